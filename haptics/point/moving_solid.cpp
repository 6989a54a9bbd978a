#include "haptics/point/moving_solid.h"

#include <algorithm>

namespace fulcrum {

namespace {

// How high the proxy is held over a triangle, of the mesh's radius: far above rounding, far below what can be felt.
constexpr double kClearance = 1.0e-10;
// Foot and edge nearer than this, of the triangle's height over that edge, count as beside.
constexpr double kEdgeMargin = 1.0e-13;
// Triangles are collected between one and four reaches around a sweep, so that the next sweeps find them there: further as long
// as they are few, nearer after they were too many. Leaves on a surface grow with the square.
constexpr double kLeastMargin = 1.0;
constexpr double kMostMargin = 4.0;
constexpr double kMarginStep = 1.25;
constexpr std::size_t kFewLeaves = NearbyTriangles::kCapacity / 4;
// The next triangles are collected around where the proxy will be so many steps on, once it is that near to the end of the
// present ones; in one step by a share of the tree's nodes, so that no step pays for a whole search.
constexpr double kStepsAhead = 3.0;
constexpr std::int32_t kNodesAhead = 6;
// A motion longer than this many reaches leads into the stuff: most likely it is stopped in its first part, over which fewer
// triangles lie.
constexpr double kLongMotion = 1.5;
constexpr double kFirstPart = 0.1;  // reaches
// So many reaches around a sweep the triangles are made ready for the next ones.
constexpr double kAround = 0.25;

}  // namespace

MovingSolid::MovingSolid(const SolidPlan& plan, std::int32_t index, SegmentStructureKind structure)
    : mesh_(*find_mesh(plan.shape)), index_(index), lets_out_(plan.lets_out) {
    if (structure != SegmentStructureKind::bounding_tree) {
        structure_ = make_segment_structure(structure, mesh_).value();
    }
    take_pose(plan.initial_pose_W);
}

SegmentHit MovingSolid::sweep(const Vector3& to_W) const noexcept {
    const Vector3 to_B = to_body(to_W);
    return to_B == proxy_B() ? SegmentHit{} : sweep_B(to_B);
}

void MovingSolid::collect_nearby(const Vector3& end_B, double reach_m) noexcept {
    ++n_searches_;
    const Vector3 margin = Vector3::Constant(margin_ * reach_m);
    const bool fits = nearby_.collect(
        *mesh_, {proxy_B().cwiseMin(end_B) - margin, proxy_B().cwiseMax(end_B) + margin});
    adapt_margin(fits);
}

void MovingSolid::look_ahead(double reach_m) noexcept {
    const Vector3 ahead_B = kStepsAhead * (proxy_B() - last_proxy_B_);
    last_proxy_B_ = proxy_B();
    if (structure_ || !nearby_.covers(proxy_B())) {
        return;
    }
    if (!nearby_.is_collecting_ahead()) {
        const Vector3 next_B = proxy_B() + ahead_B;
        if (nearby_.covers(next_B) || nearby_.covers_ahead(next_B)) {
            return;
        }
        const Vector3 margin = Vector3::Constant(margin_ * reach_m);
        nearby_.begin_ahead(*mesh_, {next_B - margin, next_B + margin});
    }
    const Collecting collected = nearby_.go_on_ahead(*mesh_, kNodesAhead);
    if (collected != Collecting::goes_on) {
        adapt_margin(collected == Collecting::done);
    }
}

void MovingSolid::adapt_margin(bool fits) noexcept {
    if (!fits) {
        margin_ = std::max(kLeastMargin, margin_ / (kMarginStep * kMarginStep));
    } else if (nearby_.n_leaves() <= kFewLeaves) {
        margin_ = std::min(kMostMargin, margin_ * kMarginStep);
    }
}

SegmentHit MovingSolid::sweep_nearby(const Vector3& to_W, double reach_m) noexcept {
    const Vector3 to_B = to_body(to_W);
    if (to_B == proxy_B() || structure_) {
        return sweep(to_W);
    }
    // What is remembered serves when it reaches to the end, or as far as anything collected anew would.
    const double length_m = largest_component(to_B - proxy_B());
    double part = nearby_.cover(proxy_B(), to_B);
    if (part < 1.0 && part * length_m < reach_m) {
        const double wanted = std::min(1.0, reach_m / length_m);
        const Vector3 end_B = proxy_B() + wanted * (to_B - proxy_B());
        collect_nearby(end_B, reach_m);
        part = nearby_.cover(proxy_B(), to_B);
    }
    if (part > 0.0) {
        SegmentHit hit;
        if (length_m * part > kLongMotion * reach_m) {
            hit = nearby_.find_nearest_hit(*mesh_, proxy_B(), to_B, kFirstPart * reach_m / length_m,
                                           kAround * reach_m);
        }
        if (!hit.found()) {
            hit = nearby_.find_nearest_hit(*mesh_, proxy_B(), to_B, part, kAround * reach_m);
        }
        if (part == 1.0 || hit.found()) {
            return hit;
        }
    }
    ++n_searches_;
    return find_nearest_hit(*mesh_, proxy_B(), to_B);
}

TouchedPlane MovingSolid::find_plane(std::int32_t triangle, int side) const noexcept {
    const PreparedTriangle prepared = prepare_triangle(*mesh_, triangle);
    const double side_sign = side < 0 ? -1.0 : 1.0;
    TouchedPlane plane{.solid = index_, .feature = triangle, .side = side < 0 ? -1 : 1};
    plane.normal_W = turn_WB() * (prepared.doubled_area.normalized() * side_sign);
    plane.point_W = to_world(prepared.a);
    const double farthest_m = largest_component(plane.point_W) + largest_component(origin_W());
    plane.clearance_m = kClearance * mesh_->radius_m() + rounding_m(farthest_m);
    return plane;
}

bool MovingSolid::is_over(std::int32_t triangle) const noexcept {
    const PreparedTriangle t = prepare_triangle(*mesh_, triangle);
    const double margin = kEdgeMargin * t.doubled_area.squaredNorm();
    const auto inside = [&](const Vector3& u, const Vector3& v) noexcept {
        return t.doubled_area.dot((v - u).cross(proxy_B() - u)) > margin;
    };
    return inside(t.a, t.b) && inside(t.b, t.c) && inside(t.c, t.a);
}

bool MovingSolid::is_near(const Vector3& centre_W, double radius_m) const noexcept {
    const double reach_m = (mesh_->radius_m() + radius_m) * (1.0 + 1.0e-9);
    return (to_body(centre_W) - mesh_->centre_B()).squaredNorm() <= reach_m * reach_m;
}

}  // namespace fulcrum
