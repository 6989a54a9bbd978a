#include "haptics/collision/convex_cursor.h"

#include <algorithm>
#include <array>

namespace fulcrum {

namespace {

// How much of a cursor's least half size its corners are rounded by.
constexpr double kRounded = 1.0e-3;
// Planes that a cursor may rest on at once.
constexpr std::size_t kMostFloors = 4;

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

// Room for the next ways.
Box find_wider(const Box& box, double margin_m) noexcept {
    const Vector3 margin = Vector3::Constant(margin_m);
    return {box.lower - margin, box.upper + margin};
}

Vector3 or_up(const Vector3& v) noexcept {
    return v.squaredNorm() > 0.0 ? v : Vector3(Vector3::UnitY());
}

// The triangle's normal, on the side of a cursor whose middle is there.
Vector3 find_side(const TriangleForGap& triangle, const Vector3& at_B) noexcept {
    const double side = triangle.normal.dot(at_B - triangle.a) < 0.0 ? -1.0 : 1.0;
    return side * triangle.normal;
}

// The last floors that triangles were found to be below: their neighbours mostly are so, too.
class SettledBelow {
  public:
    void add(const Floor& floor) noexcept {
        floors_[next_] = floor;
        next_ = (next_ + 1) % kFloors;
        count_ = std::min(count_ + 1, kFloors);
    }
    [[nodiscard]] bool has_all_of(const TriangleForGap& triangle) const noexcept {
        return std::any_of(floors_.begin(), floors_.begin() + static_cast<std::ptrdiff_t>(count_),
                           [&](const Floor& floor) noexcept {
                               return triangle.highest_along(floor.normal_B) <= floor.height_m;
                           });
    }

  private:
    static constexpr std::size_t kFloors = 8;
    std::array<Floor, kFloors> floors_{};
    std::size_t next_ = 0;
    std::size_t count_ = 0;
};

template <class FindSupport>
ConvexGap find_triangle_gap(const TriangleForGap& triangle, const Vector3& face_B,
                            const Vector3& at_B, FindSupport&& find_support) noexcept {
    const std::array<Vector3, 3> corners{triangle.a, triangle.a + triangle.ab,
                                         triangle.a + triangle.ac};
    return find_convex_gap(face_B, [&](const Vector3& direction) noexcept {
        const Vector3& corner = *std::ranges::min_element(
            corners, {}, [&](const Vector3& c) { return direction.dot(c); });
        return Vector3(at_B + find_support(direction) - corner);
    });
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

ConvexMeshObstacle::ConvexMeshObstacle(std::shared_ptr<const CollisionMesh> mesh, ConvexBody cursor)
    : mesh_(std::move(mesh)), cursor_(std::move(cursor)) {}

Gap ConvexMeshObstacle::find_gap(const TriangleForGap& triangle,
                                 const Vector3& at_B) const noexcept {
    const Vector3 face_B = find_side(triangle, at_B);
    const ConvexGap apart = find_triangle_gap(
        triangle, face_B, at_B,
        [this](const Vector3& direction) noexcept { return cursor_.find_support(direction); });
    if (!(apart.gap_m > 0.0)) {
        return to_gap({face_B, 0.0}, cursor_.radius_m(), cursor_.bounding_radius_m());
    }
    return to_gap(apart, cursor_.radius_m(), 0.0);
}

Gap ConvexMeshObstacle::find_turned_gap(const TriangleForGap& triangle, const Vector3& from_B,
                                        const Vector3& to_B) const noexcept {
    const Vector3 normal = find_triangle_gap(triangle, find_side(triangle, from_B), from_B,
                                             [this](const Vector3& direction) noexcept {
                                                 return cursor_.find_kept_support(direction);
                                             })
                               .normal;
    const double lowest_m = normal.dot(to_B + cursor_.find_support(-normal)) - cursor_.radius_m();
    return {.normal_B = normal, .gap_m = lowest_m - triangle.highest_along(normal)};
}

// All below that height along the gap's normal was kept off by that plane where the cursor was, and is so now: or will be where it has
// been pushed off the triangle.
double ConvexMeshObstacle::find_settled_m(const TriangleForGap& triangle, const Gap& gap,
                                          const CastQuestion& question) const noexcept {
    const Vector3& normal = gap.normal_B;
    const double kept_m = normal.dot(question.from_B + cursor_.find_kept_support(-normal)) -
                          cursor_.radius_m() - question.level_m;
    const double now_m =
        triangle.highest_along(normal) + std::max(gap.gap_m - question.level_m, 0.0);
    return std::min(kept_m, now_m);
}

// Does the triangle's own plane, or a floor, keep it off the way?
bool ConvexMeshObstacle::is_free(const TriangleForGap& triangle, const CastQuestion& question,
                                 std::span<const Floor> floors) const noexcept {
    const Vector3 own = find_side(triangle, question.from_B);
    return triangle.highest_along(own) <=
               cursor_.find_lowest_m(own, question.from_B, question.to_B) - question.level_m ||
           std::ranges::any_of(floors, [&](const Floor& floor) noexcept {
               return triangle.highest_along(floor.normal_B) <= floor.height_m;
           });
}

CastHit ConvexMeshObstacle::cast(const CastQuestion& question) noexcept {
    std::array<Floor, kMostFloors> floors;
    const std::size_t n_floors = std::min(question.normals_B.size(), kMostFloors);
    for (std::size_t i = 0; i < n_floors; ++i) {
        const Vector3& normal = question.normals_B[i];
        floors[i] = {normal, cursor_.find_lowest_m(normal, question.from_B, question.to_B) -
                                 question.level_m};
    }
    const std::span<const Floor> given(floors.data(), n_floors);
    CastHit nearest;
    double least_m = question.level_m;
    SettledBelow settled;
    const auto ask = [&](std::int32_t index) noexcept {
        const TriangleForGap triangle = prepare_for_gap(*mesh_, index);
        if (is_free(triangle, question, given)) {
            return;
        }
        if (cursor_.has_turned()) {
            if (settled.has_all_of(triangle)) {
                return;
            }
            const Gap gap = find_turned_gap(triangle, question.from_B, question.to_B);
            settled.add({gap.normal_B, find_settled_m(triangle, gap, question)});
            if (gap.gap_m < least_m) {
                least_m = gap.gap_m;
                nearest = {0.0, index};
            }
            return;
        }
        const double t = cast_convex(
            question, [&](const Vector3& at_B) noexcept { return find_gap(triangle, at_B); });
        if (t < nearest.t || (t == nearest.t && t <= 1.0 && index < nearest.feature)) {
            nearest = {t, index};
        }
    };
    const Box swept = cursor_.find_swept_box(question.from_B, question.to_B, question.level_m);
    if (near_.covers(swept) || near_.collect(*mesh_, find_wider(swept, question.reach_m))) {
        near_.for_each_in_box(swept, given, ask);
    } else {
        mesh_->tree().for_each_in_box(swept, ask);
    }
    return nearest;
}

Gap ConvexMeshObstacle::find_gap(std::int32_t feature, const Vector3& at_B) const noexcept {
    const TriangleForGap triangle = prepare_for_gap(*mesh_, feature);
    return cursor_.has_turned() ? find_turned_gap(triangle, at_B, at_B) : find_gap(triangle, at_B);
}

std::int32_t ConvexMeshObstacle::find_nearest(const Vector3& at_B, double level_m) const noexcept {
    std::int32_t nearest = -1;
    double least_m = level_m;
    mesh_->tree().for_each_in_box(cursor_.find_swept_box(at_B, at_B, level_m),
                                  [&](std::int32_t triangle) noexcept {
                                      const double gap_m = find_gap(triangle, at_B).gap_m;
                                      if (gap_m < least_m) {
                                          least_m = gap_m;
                                          nearest = triangle;
                                      }
                                  });
    return nearest;
}

double ConvexMeshObstacle::radius_m() const noexcept {
    return mesh_->radius_m() + cursor_.bounding_radius_m();
}

double ConvexMeshObstacle::clearance_m() const noexcept {
    return kExactClearance * std::max(mesh_->radius_m(), cursor_.bounding_radius_m());
}

}  // namespace fulcrum
