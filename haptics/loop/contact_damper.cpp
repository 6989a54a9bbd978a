#include "haptics/loop/contact_damper.h"

#include "haptics/math/length.h"
#include "haptics/point/plane_constraints.h"
#include "haptics/point/proxy.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace fulcrum {
namespace {

constexpr double kSameNormal = 1.0e-3;  // radians

using Pushes = std::array<double, kMaxTouches>;
using Planes = std::array<DampedPlane, kMaxTouches>;

// `plane` and another, each with its share of the push.
void join(const DampedPlane& other, DampedPlane& plane) noexcept {
    const double push_N = plane.push_N + other.push_N;
    const double share = push_N > 0.0 ? other.push_N / push_N : 0.0;
    plane.normal_W += share * (other.normal_W - plane.normal_W);
    plane.velocity_W += share * (other.velocity_W - plane.velocity_W);
    plane.friction_coefficient += share * (other.friction_coefficient - plane.friction_coefficient);
    plane.damping_Ns_per_m += share * (other.damping_Ns_per_m - plane.damping_Ns_per_m);
    plane.drag_N_W += other.drag_N_W;
    plane.push_N = push_N;
}

// How the push is shared among planes that face one way is chance: to the damper they are one.
std::span<const DampedPlane> join_same(std::span<const DampedPlane> planes,
                                       Planes& joined) noexcept {
    std::size_t n = 0;
    for (const DampedPlane& plane : planes) {
        std::size_t k = 0;
        while (k < n &&
               compute_length(Vector3(plane.normal_W - joined[k].normal_W)) > kSameNormal) {
            ++k;
        }
        if (k < n) {
            join(plane, joined[k]);
        } else {
            joined[n++] = plane;
        }
    }
    return {joined.data(), n};
}

// w: built up along directions that are made perpendicular one after the other.
Vector3 find_common_rate(std::span<const DampedPlane> planes) noexcept {
    std::array<Vector3, kMaxTouches> directions;
    std::size_t n = 0;
    Vector3 rate_W = Vector3::Zero();
    for (const DampedPlane& plane : planes) {
        Vector3 rest_W = plane.normal_W;
        for (std::size_t k = 0; k < n; ++k) {
            rest_W -= rest_W.dot(directions[k]) * directions[k];
        }
        const double sine = compute_length(rest_W);
        if (sine > kSameNormal) {
            directions[n] = rest_W / sine;
            rate_W += (plane.normal_W.dot(plane.velocity_W - rate_W) / sine) * directions[n];
            ++n;
        }
    }
    return rate_W;
}

// N of one plane, which needs none of the rest.
double damp_push(const DampedPlane& plane) noexcept {
    return std::max(plane.push_N - plane.damping_Ns_per_m * plane.normal_W.dot(plane.velocity_W),
                    0.0);
}

// N of several: the multipliers of the point nearest to minus what is asked for in front of the planes through the origin (Moreau).
Pushes damp_pushes(std::span<const DampedPlane> planes) noexcept {
    Vector3 asked_W = Vector3::Zero();
    double push_N = 0.0;
    double damping = 0.0;
    std::array<PlaneConstraint, kMaxTouches> constraints;
    for (std::size_t i = 0; i < planes.size(); ++i) {
        asked_W += planes[i].push_N * planes[i].normal_W;
        push_N += planes[i].push_N;
        damping += planes[i].push_N * planes[i].damping_Ns_per_m;
        constraints[i] = {planes[i].normal_W, 0.0};
    }
    if (push_N > 0.0) {
        asked_W -= damping / push_N * find_common_rate(planes);
    }
    const double slack = 1.0e-12 * compute_length(asked_W);
    const ConstrainedPoint held =
        compute_constrained_point(-asked_W, std::span(constraints.data(), planes.size()), slack);
    Pushes pushes{};
    for (std::size_t k = 0; k < static_cast<std::size_t>(held.n_active); ++k) {
        pushes[static_cast<std::size_t>(held.active[k])] = held.multiplier[k];
    }
    return pushes;
}

bool has_friction(const DampedPlane& plane) noexcept {
    return plane.friction_coefficient > 0.0 || plane.drag_N_W.squaredNorm() > 0.0;
}

// Of planes that each face another way.
ContactDamping damp_apart(std::span<const DampedPlane> planes) noexcept {
    const Pushes pushes =
        planes.size() == 1 ? Pushes{damp_push(planes.front())} : damp_pushes(planes);
    const auto n_rough = static_cast<double>(std::ranges::count_if(planes, has_friction));
    ContactDamping added;
    for (std::size_t i = 0; i < planes.size(); ++i) {
        const DampedPlane& plane = planes[i];
        added.force_W += (pushes[i] - plane.push_N) * plane.normal_W;
        if (has_friction(plane)) {
            const Vector3 along_W =
                plane.velocity_W - plane.normal_W.dot(plane.velocity_W) * plane.normal_W;
            const double drag_N = compute_length(plane.drag_N_W);
            const double viscous_N =
                std::max(drag_N - plane.friction_coefficient * plane.push_N, 0.0);
            const double most_N = plane.friction_coefficient * pushes[i] + viscous_N;
            added.force_W +=
                shorten<3>(plane.drag_N_W - plane.damping_Ns_per_m / n_rough * along_W, most_N) -
                plane.drag_N_W;
            if (drag_N > most_N) {
                added.eased_W += (most_N / drag_N - 1.0) * plane.drag_N_W;
            }
        }
    }
    return added;
}

}  // namespace

ContactDamping compute_contact_damping(std::span<const DampedPlane> planes) noexcept {
    if (planes.empty()) {
        return {};
    }
    Planes joined;
    return damp_apart(planes.size() == 1 ? planes : join_same(planes, joined));
}

}  // namespace fulcrum
