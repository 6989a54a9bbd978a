// The load-path half of passivity.h.
#include "haptics/base/range.h"
#include "haptics/coupling/passivity.h"

namespace fulcrum {

Expected<void> validate(const PassivitySettings& settings) {
    const Range ranges[] = {
        {"handle_mass_kg", settings.handle_mass_kg, 0.001, 10.0},
        {"handle_inertia_kg_m2", settings.handle_inertia_kg_m2, 1.0e-8, 1.0},
        {"headroom_J", settings.headroom_J, 0.0, 0.01},
        {"memory_s", settings.memory_s, 0.01, 10.0},
    };
    return check_ranges("the passivity setting", ranges);
}

}  // namespace fulcrum
