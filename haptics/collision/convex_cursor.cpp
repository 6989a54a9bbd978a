#include "haptics/collision/convex_cursor.h"

#include <algorithm>
#include <cmath>

namespace fulcrum {

namespace {

// How much of a cursor's least half size its corners are rounded by.
constexpr double kRounded = 1.0e-3;
using Kind = ConvexCore::Kind;

struct MakeCore {
    ConvexBody operator()(const SphereShape& sphere) const {
        return {{.kind = Kind::point, .radius_m = sphere.radius_m}};
    }
    ConvexBody operator()(const BoxShape& box) const {
        return {{.kind = Kind::box, .half_m = box.half_size_m}};
    }
    ConvexBody operator()(const CapsuleShape& capsule) const {
        return {{.kind = Kind::segment,
                 .half_m = capsule.half_length_m * Vector3::UnitY(),
                 .radius_m = capsule.radius_m}};
    }
    ConvexBody operator()(const CylinderShape& cylinder) const {
        return {
            {.kind = Kind::cylinder, .half_m = {cylinder.radius_m, cylinder.half_height_m, 0.0}}};
    }
    ConvexBody operator()(const HullShape& hull) const {
        auto points = std::make_shared<std::vector<Vector3>>();
        for (std::int32_t i = 0; i < hull.mesh->n_triangles(); ++i) {
            for (const std::int32_t corner : hull.mesh->corners(i)) {
                points->push_back(hull.mesh->vertex_B(corner));
            }
        }
        const auto is_before = [](const Vector3& a, const Vector3& b) {
            return std::ranges::lexicographical_compare(a, b);
        };
        std::ranges::sort(*points, is_before);
        points->erase(std::unique(points->begin(), points->end()), points->end());
        points->shrink_to_fit();
        ConvexBody body{{.kind = Kind::cloud, .cloud = *points}, points};
        return body;
    }
    template <class Other>
    ConvexBody operator()(const Other& /*no convex shape*/) const {
        return {};
    }
};

double least_half_m(const ConvexCore& core) {
    switch (core.kind) {
        case Kind::box:
            return core.half_m.minCoeff();
        case Kind::cylinder:
            return std::min(core.half_m.x(), core.half_m.y());
        default:
            return core.bounding_radius_m();
    }
}

// Where cores overlap no direction is known: out towards the cursor's middle, by all of its size.
Gap to_gap(const ConvexGap& apart, double radii_m, double size_m) noexcept {
    const double depth_m = apart.gap_m > 0.0 ? 0.0 : size_m;
    return {.normal_B = apart.normal, .gap_m = apart.gap_m - radii_m - depth_m};
}

Vector3 or_up(const Vector3& v) noexcept {
    return v.squaredNorm() > 0.0 ? v : Vector3(Vector3::UnitY());
}

}  // namespace

ConvexBody make_convex_solid(const SolidShape& shape) {
    return std::visit(MakeCore{}, shape);
}

ConvexBody make_convex_cursor(const SolidShape& shape) {
    ConvexBody body = make_convex_solid(shape);
    if (body.core.radius_m > 0.0) {
        return body;
    }
    const double rounded_m = kRounded * least_half_m(body.core);
    if (body.core.kind == Kind::box) {
        body.core.half_m -= Vector3::Constant(rounded_m);
    } else if (body.core.kind == Kind::cylinder) {
        body.core.half_m -= Vector3(rounded_m, rounded_m, 0.0);
    }
    body.core.radius_m = rounded_m;
    return body;
}

double find_least_reach_m(const ConvexBody& body) {
    const bool is_round = body.core.kind == Kind::point || body.core.kind == Kind::segment;
    const bool is_hull = body.core.kind == Kind::cloud;
    return is_hull ? 0.0 : body.core.radius_m + (is_round ? 0.0 : least_half_m(body.core));
}

TurnedCursor::TurnedCursor(ConvexBody body)
    : body_(std::move(body)), bounding_radius_m_(body_.core.bounding_radius_m()) {
    now_.turn_CB.setZero();  // none yet
    (void)turn(Matrix3::Identity());
    keep_turn();
}

bool TurnedCursor::turn(const Matrix3& turn_CB) noexcept {
    if (turn_CB != now_.turn_CB) {
        now_.turn_CB = turn_CB;
        for (int axis = 0; axis < 3; ++axis) {
            now_.extent_B.lower[axis] = find_support(-Vector3::Unit(axis))[axis];
            now_.extent_B.upper[axis] = find_support(Vector3::Unit(axis))[axis];
        }
        has_turned_ = now_.turn_CB != kept_.turn_CB;
    }
    return has_turned_;
}

void TurnedCursor::keep_turn() noexcept {
    kept_ = now_;
    has_turned_ = false;
}

double TurnedCursor::find_lowest_m(const Vector3& direction_B, const Vector3& from_B,
                                   const Vector3& to_B) const noexcept {
    const double now_m = direction_B.dot(find_support(-direction_B));
    const double kept_m = has_turned_ ? direction_B.dot(find_kept_support(-direction_B)) : now_m;
    return std::min(direction_B.dot(from_B) + kept_m, direction_B.dot(to_B) + now_m) - radius_m();
}

Box TurnedCursor::find_swept_box(const Vector3& from_B, const Vector3& to_B,
                                 double margin_m) const noexcept {
    const Vector3 margin = Vector3::Constant(radius_m() + margin_m);
    return {(from_B + kept_.extent_B.lower).cwiseMin(to_B + now_.extent_B.lower) - margin,
            (from_B + kept_.extent_B.upper).cwiseMax(to_B + now_.extent_B.upper) + margin};
}

ConvexObstacle::ConvexObstacle(ConvexBody solid, ConvexBody cursor)
    : solid_(std::move(solid)),
      cursor_(std::move(cursor)),
      solid_radius_m_(solid_.core.bounding_radius_m()) {}

CastHit ConvexObstacle::cast(const CastQuestion& question) noexcept {
    if (cursor_.has_turned()) {
        const double gap_m = find_turned_gap(question.from_B, question.to_B).gap_m;
        return gap_m < question.level_m ? CastHit{0.0, 0} : CastHit{};
    }
    return {cast_convex(question, [this](const Vector3& at_B) { return find_gap(0, at_B); }), 0};
}

Gap ConvexObstacle::find_gap(std::int32_t /*feature*/, const Vector3& at_B) const noexcept {
    if (cursor_.has_turned()) {
        return find_turned_gap(at_B, at_B);
    }
    const ConvexGap apart = find_convex_gap(or_up(at_B), [&](const Vector3& direction) noexcept {
        return Vector3(at_B + cursor_.find_support(direction) -
                       solid_.core.find_support(-direction));
    });
    return to_gap(apart, cursor_.radius_m() + solid_.core.radius_m, cursor_.bounding_radius_m());
}

Gap ConvexObstacle::find_turned_gap(const Vector3& from_B, const Vector3& to_B) const noexcept {
    const Vector3 normal = find_convex_gap(or_up(from_B), [&](const Vector3& direction) noexcept {
                               return Vector3(from_B + cursor_.find_kept_support(direction) -
                                              solid_.core.find_support(-direction));
                           }).normal;
    const double lowest_m = normal.dot(to_B + cursor_.find_support(-normal)) - cursor_.radius_m();
    const double highest_m = normal.dot(solid_.core.find_support(normal)) + solid_.core.radius_m;
    return {.normal_B = normal, .gap_m = lowest_m - highest_m};
}

std::int32_t ConvexObstacle::find_nearest(const Vector3& at_B, double level_m) const noexcept {
    return find_gap(0, at_B).gap_m < level_m ? 0 : -1;
}

double ConvexObstacle::radius_m() const noexcept {
    return solid_radius_m_ + cursor_.bounding_radius_m();
}

double ConvexObstacle::clearance_m() const noexcept {
    return kExactClearance * std::max(solid_radius_m_, cursor_.bounding_radius_m());
}

}  // namespace fulcrum
