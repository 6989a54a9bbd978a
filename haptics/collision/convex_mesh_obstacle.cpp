#include "haptics/collision/convex_mesh_obstacle.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace fulcrum {

namespace {

// Of a gap on a cursor's way, what may be left unknown.
constexpr double kRough = 0.05;
// Planes that a cursor may rest on at once.
constexpr std::size_t kMostFloors = 4;

// The triangle's normal, on the side of a cursor whose middle is there.
Vector3 find_side(const TriangleForGap& triangle, const Vector3& at_B) noexcept {
    const double side = triangle.normal.dot(at_B - triangle.a) < 0.0 ? -1.0 : 1.0;
    return side * triangle.normal;
}

struct PlainTriangle {
    Vector3 at_B[3];
    PlainTriangle(const CollisionMesh& mesh, std::int32_t triangle) noexcept {
        const TriangleCorners& corners = mesh.corners(triangle);
        for (std::size_t i = 0; i < 3; ++i) {
            at_B[i] = mesh.vertex_B(corners[i]);
        }
    }
    [[nodiscard]] double highest_along(const Vector3& direction) const noexcept {
        return std::max({direction.dot(at_B[0]), direction.dot(at_B[1]), direction.dot(at_B[2])});
    }
};

// A node of the tree.
struct NodeBox {
    Vector3 middle_B;
    Vector3 half_m;
    explicit NodeBox(const Box& box) noexcept
        : middle_B(0.5 * (box.lower + box.upper)), half_m(0.5 * (box.upper - box.lower)) {}
    [[nodiscard]] double highest_along(const Vector3& direction) const noexcept {
        return direction.dot(middle_B) + direction.cwiseAbs().dot(half_m);
    }
};

template <class FindSupport, class IsEnough>
ConvexGap find_triangle_gap(const TriangleForGap& triangle, const Vector3& start_B,
                            const Vector3& at_B, FindSupport&& find_support,
                            IsEnough&& is_enough) noexcept {
    return find_convex_gap(
        start_B,
        [&](const Vector3& direction) noexcept {
            return Vector3(at_B + find_support(direction) - triangle.find_farthest(-direction));
        },
        is_enough);
}

bool to_the_end(const Vector3& /*normal*/, double /*least_m*/, double /*most_m*/) noexcept {
    return false;
}

}  // namespace

// Those that the cursor rests on, and the last that something was found to be below: what is beside it mostly is so, too.
class ConvexMeshObstacle::Floors {
  public:
    void keep(const Floor& floor) noexcept { floors_[n_kept_++] = floor; }
    void add(const Floor& floor) noexcept {
        floors_[kMostFloors + next_] = floor;
        next_ = (next_ + 1) % kLast;
        n_last_ = std::min(n_last_ + 1, kLast);
    }
    template <class Thing>
    [[nodiscard]] bool has_above(const Thing& thing) const noexcept {
        const auto is_below = [&](const Floor& floor) noexcept { return floor.has_below(thing); };
        const std::span<const Floor> all(floors_);
        return std::ranges::none_of(all.first(n_kept_), is_below) &&
               std::ranges::none_of(all.subspan(kMostFloors, n_last_), is_below);
    }

  private:
    static constexpr std::size_t kLast = 8;
    std::array<Floor, kMostFloors + kLast> floors_{};
    std::size_t n_kept_ = 0;
    std::size_t next_ = 0;
    std::size_t n_last_ = 0;
};

ConvexMeshObstacle::ConvexMeshObstacle(std::shared_ptr<const CollisionMesh> mesh, ConvexBody cursor)
    : mesh_(std::move(mesh)), cursor_(std::move(cursor)) {}

template <class IsEnough>
Gap ConvexMeshObstacle::find_gap(const TriangleForGap& triangle, const Vector3& at_B,
                                 IsEnough&& is_enough) const noexcept {
    const Vector3 face_B = find_side(triangle, at_B);
    const ConvexGap apart = find_triangle_gap(
        triangle, face_B, at_B,
        [this](const Vector3& direction) noexcept { return cursor_.find_support(direction); },
        is_enough);
    if (!(apart.gap_m > 0.0)) {
        // Where the cores overlap no direction is known: out by all of the cursor's size.
        return {.normal_B = face_B, .gap_m = -cursor_.radius_m() - cursor_.bounding_radius_m()};
    }
    return {.normal_B = apart.normal, .gap_m = apart.gap_m - cursor_.radius_m()};
}

Gap ConvexMeshObstacle::find_turned_gap(const TriangleForGap& triangle, const Vector3& from_B,
                                        const Vector3& to_B) const noexcept {
    const Vector3 normal = find_triangle_gap(
                               triangle, find_side(triangle, from_B), from_B,
                               [this](const Vector3& direction) noexcept {
                                   return cursor_.find_kept_support(direction);
                               },
                               to_the_end)
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

// All below it is kept off the cursor's way or, where it has turned, off both its ends.
ConvexMeshObstacle::Floor ConvexMeshObstacle::find_floor(
    const Vector3& normal_B, const CastQuestion& question) const noexcept {
    return {normal_B,
            cursor_.find_lowest_m(normal_B, question.from_B, question.to_B) - question.level_m};
}

// One that the triangle is below, if there is one: a plane between both, as the search for their distance comes by.
std::optional<ConvexMeshObstacle::Floor> ConvexMeshObstacle::find_floor_over(
    const TriangleForGap& triangle, const CastQuestion& question) const noexcept {
    const double least_m = cursor_.radius_m() + question.level_m;
    std::optional<Floor> floor;
    (void)find_triangle_gap(
        triangle, find_side(triangle, question.from_B), question.from_B,
        [this](const Vector3& direction) noexcept { return cursor_.find_kept_support(direction); },
        [&](const Vector3& normal, double /*apart_m*/, double most_m) noexcept {
            const Floor there = find_floor(normal, question);
            if (there.has_below(triangle)) {
                floor = there;
            }
            return floor || most_m < least_m;
        });
    return floor;
}

CastHit ConvexMeshObstacle::cast(const CastQuestion& question) noexcept {
    Floors floors;
    for (const Vector3& normal :
         question.normals_B.first(std::min(question.normals_B.size(), kMostFloors))) {
        floors.keep(find_floor(normal, question));
    }
    // What is still of interest: as far as the nearest meeting, and where the cursor has turned what is deeper in than the deepest.
    CastQuestion left = question;
    CastHit nearest;
    // A way's next step is as long as the gap is at least: it need not be known better than that leaves it nearly as long.
    const auto is_rough_enough = [&](const Vector3& /*normal*/, double least_m,
                                     double most_m) noexcept {
        return most_m - least_m <= kRough * (least_m - cursor_.radius_m() - question.level_m);
    };
    const auto is_off = [&](const Box& box) noexcept {
        const NodeBox node(box);
        if (!floors.has_above(node)) {
            return true;
        }
        const Vector3 from_nearest =
            question.from_B - question.from_B.cwiseMax(box.lower).cwiseMin(box.upper);
        if (!(from_nearest.squaredNorm() > 0.0)) {
            return false;
        }
        const Floor floor = find_floor(compute_direction(from_nearest), left);
        if (floor.has_below(node)) {
            floors.add(floor);
            return true;
        }
        return false;
    };
    const auto ask = [&](std::int32_t index) noexcept {
        if (!floors.has_above(PlainTriangle(*mesh_, index))) {
            return;
        }
        const TriangleForGap triangle = prepare_for_gap(*mesh_, index);
        if (const std::optional<Floor> floor = find_floor_over(triangle, left)) {
            floors.add(*floor);
            return;
        }
        if (cursor_.has_turned()) {
            const Gap gap = find_turned_gap(triangle, question.from_B, question.to_B);
            floors.add({gap.normal_B, find_settled_m(triangle, gap, question)});
            if (gap.gap_m < left.level_m) {
                left.level_m = gap.gap_m;
                nearest = {0.0, index};
            }
            return;
        }
        const double t = cast_convex(question, [&](const Vector3& at_B) noexcept {
            return find_gap(triangle, at_B, is_rough_enough);
        });
        if (t < nearest.t || (t == nearest.t && t <= 1.0 && index < nearest.feature)) {
            nearest = {t, index};
            left.to_B = question.from_B + t * (question.to_B - question.from_B);
        }
    };
    mesh_->tree().for_each_in_box(
        cursor_.find_swept_box(question.from_B, question.to_B, question.level_m), is_off, ask);
    return nearest;
}

Gap ConvexMeshObstacle::find_gap(std::int32_t feature, const Vector3& at_B) const noexcept {
    const TriangleForGap triangle = prepare_for_gap(*mesh_, feature);
    return cursor_.has_turned() ? find_turned_gap(triangle, at_B, at_B)
                                : find_gap(triangle, at_B, to_the_end);
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
