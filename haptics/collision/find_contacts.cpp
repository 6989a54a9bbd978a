#include "haptics/collision/find_contacts.h"

#include "haptics/collision/contact_axis.h"
#include "haptics/collision/contact_points.h"
#include "haptics/collision/contact_shadow.h"

#include <algorithm>
#include <cmath>

namespace fulcrum {
namespace {

using ShapeKind = ContactShape::Kind;

// A half space's face as seen under another shadow: of four corners far beyond it.
void make_ground_shadow(const Shadow& over, double height, Shadow& ground) noexcept {
    double low_x = over.corners[0].x;
    double high_x = low_x;
    double low_y = over.corners[0].y;
    double high_y = low_y;
    for (int i = 1; i < over.count; ++i) {
        const Shadow::Place& corner = over.corners[static_cast<std::size_t>(i)];
        low_x = std::min(low_x, corner.x);
        high_x = std::max(high_x, corner.x);
        low_y = std::min(low_y, corner.y);
        high_y = std::max(high_y, corner.y);
    }
    const double beyond = high_x - low_x + high_y - low_y;
    ground.corners[0] = {low_x - beyond, low_y - beyond};
    ground.corners[1] = {high_x + beyond, low_y - beyond};
    ground.corners[2] = {high_x + beyond, high_y + beyond};
    ground.corners[3] = {low_x - beyond, high_y + beyond};
    ground.count = 4;
    ground.height = height;
    ground.slope_x = 0.0;
    ground.slope_y = 0.0;
}

// Both shadows of a pair; the upper one is the first's.
class Pair {
  public:
    Pair(const PlacedShape& first, const PlacedShape& second, const ContactAxis& axis) noexcept
        : first_(first), second_(second), axis_(axis), frame_(ShadowFrame::across(axis.normal_W)) {}

    /// In the order in which they are found.
    void find_candidates(double margin_m, ContactCandidates& candidates) noexcept {
        make_shadows();
        find_shared_corners(upper_, lower_, shared_);
        const bool is_point = upper_.count == 1 || lower_.count == 1;
        candidates.count = 0;
        for (int i = 0; i < shared_.count; ++i) {
            const SharedCorner& corner = shared_.corners[static_cast<std::size_t>(i)];
            const double upper = corner.upper - first_.shape->core.radius_m;
            const double lower = corner.lower + second_.shape->core.radius_m;
            const double gap_m = is_point ? axis_.gap_m : upper - lower;
            if (gap_m <= margin_m) {
                candidates.add({.place = place_of(corner.at, 0.5 * (upper + lower)),
                                .gap_m = gap_m,
                                .feature = corner.feature});
            }
        }
        if (candidates.count == 0) {
            candidates.add(find_nearest());
        }
    }

  private:
    void make_shadow_of(const PlacedShape& body, double sign, Shadow& shadow) noexcept {
        SupportFeature feature;
        find_feature(*body.shape, body.turn_WB.transpose() * (sign * frame_.n), feature);
        make_shadow(feature, body.turn_WB, body.place, frame_, sign, shadow);
    }
    void make_shadows() noexcept {
        const bool is_over_ground = second_.shape->kind == ShapeKind::half_space;
        const bool is_under_ground = first_.shape->kind == ShapeKind::half_space;
        if (!is_under_ground) {
            make_shadow_of(first_, -1.0, upper_);
        }
        if (!is_over_ground) {
            make_shadow_of(second_, 1.0, lower_);
        }
        if (is_over_ground) {
            make_ground_shadow(upper_, frame_.n.dot(second_.place), lower_);
        } else if (is_under_ground) {
            make_ground_shadow(lower_, frame_.n.dot(first_.place), upper_);
        }
    }
    [[nodiscard]] Vector3 place_of(const Shadow::Place& at, double height) const noexcept {
        return at.x * frame_.u + at.y * frame_.v + height * frame_.n;
    }
    [[nodiscard]] ContactCandidate find_nearest() const noexcept {
        const SharedCorner corner = find_nearest_corner(upper_, lower_);
        const double upper = corner.upper - first_.shape->core.radius_m;
        const double lower = corner.lower + second_.shape->core.radius_m;
        return {.place = place_of(corner.at, 0.5 * (upper + lower)),
                .gap_m = axis_.gap_m,
                .feature = corner.feature};
    }

    const PlacedShape& first_;
    const PlacedShape& second_;
    const ContactAxis& axis_;
    ShadowFrame frame_;
    Shadow upper_;
    Shadow lower_;
    SharedCorners shared_;
};

// Of the smaller body that has an end.
double find_end_size(const ContactShape& first, const ContactShape& second) noexcept {
    if (first.kind == ShapeKind::half_space) {
        return second.bounding_radius_m;
    }
    return second.kind == ShapeKind::half_space
               ? first.bounding_radius_m
               : std::min(first.bounding_radius_m, second.bounding_radius_m);
}

}  // namespace

void find_contacts(const ContactShape& first, const ContactPlace& first_place,
                   const ContactShape& second, const ContactPlace& second_place, double margin_m,
                   ContactManifold& manifold) noexcept {
    if (!is_finite(first_place) || !is_finite(second_place)) {
        manifold.count = 0;
        return;
    }
    // Seen from the first body, whatever the place in the world: a half space has no middle.
    const bool is_ground = first.kind == ShapeKind::half_space;
    const Vector3 origin = is_ground ? second_place.position_W : first_place.position_W;
    const PlacedShape a{&first, first_place.turn_WB, first_place.position_W - origin};
    const PlacedShape b{&second, second_place.turn_WB, second_place.position_W - origin};
    const ContactAxis axis = find_contact_axis(a, b, margin_m, manifold.which_axis);
    if (!(axis.gap_m <= margin_m)) {
        manifold.count = 0;
        manifold.which_axis = axis.which;
        return;
    }
    ContactCandidates candidates;
    Pair(a, b, axis).find_candidates(margin_m, candidates);
    manifold.normal_W = axis.normal_W;
    manifold.which_axis = axis.which;
    const ContactTurn turn{origin, first_place, second_place};
    choose_contacts(candidates, axis.normal_W, find_end_size(first, second), turn, manifold);
}

}  // namespace fulcrum
