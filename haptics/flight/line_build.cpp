// The load path of line.h.
#include "haptics/base/range.h"
#include "haptics/flight/line.h"

namespace fulcrum {

Expected<void> validate(const LineSettings& settings) {
    const Range ranges[] = {
        {"length in metres", settings.length_m, 0.5, 500.0},
        {"number of segments", static_cast<double>(settings.segments), 1.0, kMostLineSegments},
        {"mass in kilograms a metre", settings.mass_kg_per_m, 1.0e-5, 0.1},
        {"stretch in newtons", settings.stretch_N, 10.0, 1.0e6},
        {"damping in seconds", settings.damping_s, 0.0, 1.0},
        {"diameter in metres", settings.diameter_m, 0.0, 0.02},
        {"drag coefficient", settings.drag_coefficient, 0.0, 2.0},
        {"strength in newtons", settings.strength_N, 1.0, 1.0e6},
    };
    return check_ranges("a line's", ranges);
}

KiteLine::KiteLine(const LineSettings& settings)
    : settings_(settings),
      length_m_(settings.length_m),
      nodes_W_(static_cast<std::size_t>(settings.segments) + 1, Vector3::Zero()),
      velocities_W_(nodes_W_.size(), Vector3::Zero()),
      segments_(nodes_W_.size() - 1, Segment{Vector3::Zero(), Matrix3::Zero(), Vector3::Zero()}),
      inverse_(nodes_W_.size(), Matrix3::Zero()),
      solved_(nodes_W_.size(), Vector3::Zero()),
      ways_W_(nodes_W_.size(), Vector3::Zero()) {}

}  // namespace fulcrum
