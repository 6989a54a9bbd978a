#include "haptics/surface/friction.h"

#include "haptics/base/range.h"

namespace fulcrum {

Expected<void> validate(const FrictionSettings& settings) {
    const Range ranges[] = {
        {"dynamic coefficient", settings.dynamic_coefficient, 0.0, 5.0},
        {"static coefficient", settings.static_coefficient, settings.dynamic_coefficient, 5.0},
        {"viscosity in Ns/m", settings.viscous_Ns_per_m, 0.0, 100.0},
    };
    return check_ranges("the friction's", ranges);
}

}  // namespace fulcrum
