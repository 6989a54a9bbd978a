#include "haptics/point/plane_constraints.h"

#include "haptics/math/length.h"

namespace fulcrum {

namespace {

// Planes at a smaller angle than this (radians) have no intersection that rounding leaves any meaning.
constexpr double kParallel = 1.0e-11;
// A multiplier counts as not negative down to this part of the largest distance involved.
constexpr double kMultiplierSlack = 1.0e-12;

using Planes = std::span<const PlaneConstraint>;

bool respects(const Vector3& position, const Planes& planes, double slack_m) noexcept {
    for (const PlaneConstraint& plane : planes) {
        if (!(plane.normal.dot(position) >= plane.offset_m - slack_m)) {
            return false;
        }
    }
    return true;
}

// The foot on one plane that the wish lies behind.
bool try_plane(const Vector3& wish, const Planes& planes, int index, double slack_m,
               ConstrainedPoint& found) noexcept {
    const PlaneConstraint& plane = planes[static_cast<std::size_t>(index)];
    const double square = plane.normal.squaredNorm();
    const double push = (plane.offset_m - plane.normal.dot(wish)) / square;
    const Vector3 foot = wish + push * plane.normal;
    if (!(square > kParallel * kParallel) || !(push >= 0.0) || !respects(foot, planes, slack_m)) {
        return false;
    }
    found.position = foot;
    found.n_active = 1;
    found.active[0] = index;
    found.multiplier[0] = push;
    found.feasible = true;
    return true;
}

// One active plane after another: the direction in which it pushes without disturbing those before it.
class ActiveSet {
  public:
    explicit ActiveSet(const Vector3& wish) noexcept : position_(wish) {}

    // Makes the plane active; false when it is parallel to those before.
    bool add(const Planes& planes, int index) noexcept {
        const PlaneConstraint& plane = planes[static_cast<std::size_t>(index)];
        Vector3 free = plane.normal;
        for (std::size_t i = 0; i < n_; ++i) {
            free -= directions_[i].dot(plane.normal) * directions_[i];
        }
        const double sine = compute_length(free);
        if (!(sine > kParallel)) {
            return false;
        }
        free /= sine;
        for (std::size_t i = 0; i < n_ && sine < 0.1; ++i) {
            free -=
                directions_[i].dot(free) * directions_[i];  // once more, for what cancellation left
        }
        const double lead = plane.normal.dot(free);
        const double push = (plane.offset_m - plane.normal.dot(position_)) / lead;
        position_ += push * free;
        directions_[n_] = free;
        pushes_[n_] = push;
        normals_[n_] = plane.normal;
        indices_[n_] = index;
        ++n_;
        return true;
    }

    // From position = wish + sum push_i direction_i back to normals: a triangular system, last plane first.
    [[nodiscard]] bool find_multipliers(double slack) noexcept {
        bool all_push = true;
        for (std::size_t i = n_; i-- > 0;) {
            double rest = pushes_[i];
            for (std::size_t j = i + 1; j < n_; ++j) {
                rest -= multipliers_[j] * normals_[j].dot(directions_[i]);
            }
            multipliers_[i] = rest / normals_[i].dot(directions_[i]);
            all_push = all_push && multipliers_[i] >= -slack;
        }
        return all_push;
    }

    [[nodiscard]] const Vector3& position() const noexcept { return position_; }
    [[nodiscard]] ConstrainedPoint result() const noexcept {
        return {position_, static_cast<int>(n_), indices_, multipliers_, true};
    }

  private:
    Vector3 position_;
    std::array<Vector3, 3> directions_;
    std::array<Vector3, 3> normals_;
    std::array<double, 3> pushes_{};
    std::array<double, 3> multipliers_{};
    std::array<int, 3> indices_{};
    std::size_t n_ = 0;
};

// Bits of `set` name the planes to be made active.
bool try_set(const Vector3& wish, const Planes& planes, unsigned set, double slack_m,
             ConstrainedPoint& found) noexcept {
    ActiveSet active(wish);
    for (int i = 0; i < static_cast<int>(planes.size()); ++i) {
        if ((set & (1U << static_cast<unsigned>(i))) != 0 && !active.add(planes, i)) {
            return false;
        }
    }
    if (!active.find_multipliers(kMultiplierSlack * compute_length(wish)) ||
        !respects(active.position(), planes, slack_m)) {
        return false;
    }
    found = active.result();
    return true;
}

// Sets of two and three of four planes, fewest first.
constexpr std::array<unsigned, 10> kSets{0b0011, 0b0101, 0b0110, 0b1001, 0b1010,
                                         0b1100, 0b0111, 0b1011, 0b1101, 0b1110};

}  // namespace

ConstrainedPoint compute_constrained_point(const Vector3& wish,
                                           std::span<const PlaneConstraint> planes,
                                           double slack_m) noexcept {
    ConstrainedPoint found;
    if (respects(wish, planes, slack_m)) {
        found.position = wish;
        found.feasible = true;
        return found;
    }
    for (int i = 0; i < static_cast<int>(planes.size()); ++i) {
        if (try_plane(wish, planes, i, slack_m, found)) {
            return found;
        }
    }
    const unsigned given = (1U << planes.size()) - 1U;
    for (const unsigned set : kSets) {
        if ((set & ~given) == 0 && try_set(wish, planes, set, slack_m, found)) {
            return found;
        }
    }
    return found;
}

}  // namespace fulcrum
