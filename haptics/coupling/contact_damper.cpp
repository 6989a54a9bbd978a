#include "haptics/coupling/contact_damper.h"

#include "haptics/math/length.h"

#include <algorithm>
#include <cmath>

namespace fulcrum {
namespace {

// g: how often the same direction is among the normals.
double find_overlap(std::span<const DampedPlane> planes) noexcept {
    double most = 1.0;
    for (const DampedPlane& one : planes) {
        double sum = 0.0;
        for (const DampedPlane& other : planes) {
            sum += std::abs(one.normal_W.dot(other.normal_W));
        }
        most = std::max(most, sum);
    }
    return most;
}

Vector3 shortened(const Vector3& v, double most) noexcept {
    const double length = compute_length(v);
    return length > most ? Vector3(v * (most / length)) : v;
}

}  // namespace

Vector3 compute_contact_damping(std::span<const DampedPlane> planes) noexcept {
    const double overlap = planes.size() > 1 ? find_overlap(planes) : 1.0;
    const auto n_planes = static_cast<double>(planes.size());
    Vector3 added_W = Vector3::Zero();
    for (const DampedPlane& plane : planes) {
        const double leaving_m_per_s = plane.normal_W.dot(plane.velocity_W);
        const double push_N =
            std::max(plane.push_N - plane.damping_Ns_per_m / overlap * leaving_m_per_s, 0.0);
        added_W += (push_N - plane.push_N) * plane.normal_W;
        if (plane.most_drag_N > 0.0 && plane.push_N > 0.0) {
            const Vector3 along_W = plane.velocity_W - leaving_m_per_s * plane.normal_W;
            added_W += shortened(plane.drag_N_W - plane.damping_Ns_per_m / n_planes * along_W,
                                 plane.most_drag_N / plane.push_N * push_N) -
                       plane.drag_N_W;
        }
    }
    return added_W;
}

}  // namespace fulcrum
