#include "haptics/collision/enclosure.h"

#include "haptics/collision/segment_query.h"

#include <algorithm>
#include <array>

namespace fulcrum {

namespace {

constexpr int kMostMeetings = 256;  // along a ray; beyond them it decides nothing
// From one meeting on to the next, of the ray's length: far above rounding.
constexpr double kBeyondHit = 1.0e-12;
// Along no edge, diagonal or axis that a modeller would draw.
const std::array<Vector3, 3> kDirections{Vector3(0.5721, 0.6133, 0.5447),
                                         Vector3(-0.7039, 0.2917, 0.6477),
                                         Vector3(0.3163, -0.8111, -0.4921)};

bool leaves_stuff(const CollisionMesh& mesh, const Vector3& at_B, const Vector3& way) noexcept {
    int n = 0;
    int first_side = 0;
    for (double from = 0.0; n < kMostMeetings;) {
        const Vector3 from_B = at_B + from * way;
        const SegmentHit hit = find_nearest_hit(mesh, from_B, at_B + way);
        if (!hit.found()) {
            break;
        }
        first_side = n++ == 0 ? hit.side : first_side;
        from += hit.t * (1.0 - from) + kBeyondHit;
        if (from >= 1.0) {
            break;
        }
    }
    return n % 2 == 1 && first_side < 0;
}

}  // namespace

bool is_in_stuff(const CollisionMesh& mesh, const Vector3& at_B) noexcept {
    const double from_centre_m = (at_B - mesh.centre_B()).norm();
    if (!(from_centre_m <= mesh.radius_m())) {
        return false;
    }
    const double length_m = 2.0 * (mesh.radius_m() + from_centre_m);
    return std::ranges::count_if(kDirections, [&](const Vector3& direction) noexcept {
               const Vector3 way = length_m * direction;
               return leaves_stuff(mesh, at_B, way) && leaves_stuff(mesh, at_B, -way);
           }) >= 2;
}

}  // namespace fulcrum
