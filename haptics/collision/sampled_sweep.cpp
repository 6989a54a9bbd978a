#include "haptics/collision/sampled_sweep.h"

#include "haptics/collision/sampled_contacts.h"
#include "haptics/math/length.h"

#include <algorithm>
#include <array>
#include <limits>

namespace fulcrum {
namespace {

constexpr double kApartForEver = std::numeric_limits<double>::infinity();
constexpr double kOfSpacing = 0.5;

double find_slack(const SampledShape& shape) noexcept {
    return kOfSpacing * shape.samples().spacing_m();
}

// What a body's points may come nearer by turning, m/s.
double find_turning_speed(const MovingShape& body) noexcept {
    const double spin = compute_length(body.velocity_W.angular);
    return spin > 0.0 ? spin * body.radius_m : 0.0;
}

// Of one body's samples the least gap to the other, less half their spacing; no more than `least_m`.
double find_least(const SampledBody& own, const SampledBody& other, double least_m) noexcept {
    const SurfaceSamples& samples = own.shape.samples();
    const double slack_m = find_slack(own.shape);
    const Matrix3 turn = other.place.turn_WB.transpose() * own.place.turn_WB;
    const Vector3 shift = other.place.to_body(own.place.position_W);
    for (const SurfaceSamples::Group& group : samples.groups()) {
        const Vector3 centre = turn * group.centre_B + shift;
        if (other.shape.bound_m(centre) - group.radius_m - slack_m > least_m) {
            continue;
        }
        for (const SurfaceSample& sample : samples.of(group)) {
            const double gap_m = other.shape.bound_m(turn * sample.place_B + shift);
            least_m = std::min(least_m, gap_m - slack_m);
        }
    }
    return least_m;
}

// Of the touches within the margin; the margin where there are none.
double find_least_touch(const SampledBody& first, const SampledBody& second, double size_m,
                        double margin_m) noexcept {
    std::array<ContactManifold, kMostPatches> touching{};
    std::array<ContactManifold*, kMostPatches> patches{};
    std::ranges::transform(touching, patches.begin(), [](ContactManifold& one) { return &one; });
    find_sampled_contacts(first, second, size_m, {.margin_m = margin_m}, patches);
    double least_m = margin_m;
    for (const ContactManifold& manifold : touching) {
        for (const ContactPoint& point : manifold.points()) {
            least_m = std::min(least_m, point.gap_m);
        }
    }
    return least_m;
}

}  // namespace

double find_sampled_slack_m(const ContactShape& first, const ContactShape& second) noexcept {
    return std::max(find_slack(*first.sampled), find_slack(*second.sampled));
}

double find_sampled_meeting_s(const MovingShape& first, const MovingShape& second, double near_m,
                              double end_s) noexcept {
    const double round_m = first.shape->bounding_radius_m + second.shape->bounding_radius_m;
    const double size_m = std::min(first.shape->bounding_radius_m, second.shape->bounding_radius_m);
    const double slack_m = find_sampled_slack_m(*first.shape, *second.shape);
    const double rate =
        compute_length(Vector3(first.velocity_W.linear - second.velocity_W.linear)) +
        find_turning_speed(first) + find_turning_speed(second);
    double time_s = 0.0;
    for (int look = 0; look < kMostSampledLooks; ++look) {
        const ContactPlace at_first = first.find_place(time_s);
        const ContactPlace at_second = second.find_place(time_s);
        if (!is_finite(at_first) || !is_finite(at_second)) {
            return kApartForEver;
        }
        const SampledBody a{*first.shape->sampled, at_first};
        const SampledBody b{*second.shape->sampled, at_second};
        double gap_m =
            compute_length(Vector3(at_first.position_W - at_second.position_W)) - round_m;
        if (!(gap_m > near_m)) {
            gap_m = find_least(b, a, find_least(a, b, kApartForEver));
        }
        if (!(gap_m > near_m)) {
            gap_m = find_least_touch(a, b, size_m, slack_m + 2.0 * near_m);
        }
        if (!(gap_m > near_m)) {
            return time_s;
        }
        time_s += (gap_m - 0.5 * near_m) / rate;
        if (!(time_s < end_s)) {
            return kApartForEver;
        }
    }
    return time_s;
}

}  // namespace fulcrum
