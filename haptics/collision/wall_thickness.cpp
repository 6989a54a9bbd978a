#include "haptics/collision/wall_thickness.h"

#include "haptics/collision/segment_query.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace fulcrum {
namespace {

constexpr double kStraight = 0.9;  // n.n' of a wall's two sides, at least
constexpr double kOff = 1.0e-6;    // of the mesh's size: so far off the surface a way begins
constexpr double kNone = std::numeric_limits<double>::infinity();

Vector3 compute_doubled_area(const CollisionMesh& mesh, std::int32_t triangle) {
    const auto [a, b, c] = mesh.places_B(triangle);
    return (b - a).cross(c - a);
}

bool is_inside_out(const CollisionMesh& mesh) {
    double volume = 0.0;
    for (std::int32_t i = 0; i < mesh.n_triangles(); ++i) {
        const Vector3 away = mesh.places_B(i)[0] - mesh.centre_B();
        volume += away.dot(compute_doubled_area(mesh, i));
    }
    return volume < 0.0;
}

}  // namespace

double find_wall_m(const CollisionMesh& mesh, const Pointshell& places, double share) {
    const double inwards = is_inside_out(mesh) ? -1.0 : 1.0;
    const double longest_m = 2.0 * mesh.radius_m();
    std::vector<double> walls_m;
    for (std::size_t i = 0; i < places.size(); ++i) {
        const Vector3 along = inwards * places.normal_T(i);
        const Vector3 from = places.position_T(i) + kOff * longest_m * along;
        const SegmentHit hit = find_nearest_hit(mesh, from, from + longest_m * along);
        double wall_m = kNone;
        if (hit.found()) {
            const Vector3 out = inwards * compute_doubled_area(mesh, hit.triangle).normalized();
            wall_m = out.dot(along) >= kStraight ? (hit.t + kOff) * longest_m : kNone;
        }
        walls_m.push_back(wall_m);
    }
    if (walls_m.empty()) {
        return kNone;
    }
    const auto at = static_cast<std::ptrdiff_t>(std::min(
        share * static_cast<double>(walls_m.size()), static_cast<double>(walls_m.size() - 1)));
    std::nth_element(walls_m.begin(), walls_m.begin() + at, walls_m.end());
    return walls_m[static_cast<std::size_t>(at)];
}

}  // namespace fulcrum
