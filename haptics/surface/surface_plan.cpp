#include "haptics/surface/surface_plan.h"

#include "haptics/base/range.h"

namespace fulcrum {

Expected<void> validate(const ShadingSettings& settings) {
    const Range ranges[] = {
        {"crease angle in degrees", settings.crease_angle_deg, 0.0, kMostCrease_deg}};
    return check_ranges("the shading's", ranges);
}

Expected<void> validate(const EnergyLoanSettings& settings) {
    const Range ranges[] = {{"memory of a debt in seconds", settings.debt_memory_s, 0.01, 1.0e6},
                            {"share", settings.share, 0.0, 100.0}};
    return check_ranges("the energy loan's", ranges);
}

Expected<void> validate(const SurfacePlan& plan) {
    return validate(plan.texture).and_then([&] { return validate(plan.transient); }).and_then([&] {
        return validate(plan.shading);
    });
}

}  // namespace fulcrum
