// The load path of axle.h.
#include "haptics/base/range.h"
#include "haptics/dynamics/axle.h"

#include <cmath>
#include <sstream>

namespace fulcrum {

Expected<void> validate(const AxleSettings& settings) {
    const Range ranges[] = {
        {"axis' length", settings.axis_W.norm(), 1.0 - 1e-9, 1.0 + 1e-9},
        {"pivot's distance in metres", settings.pivot_B.norm(), 0.0, kFarthestOnAxle_m},
        {"inertia in kilogram square metres", settings.inertia_kg_m2, kLeastAxleInertia_kg_m2,
         kMostAxleInertia_kg_m2},
        {"mass in kilograms", settings.mass_kg, 0.0, kMostAxleMass_kg},
        {"centre's distance in metres", settings.centre_B.norm(), 0.0, kFarthestOnAxle_m},
        {"friction in newton metres", settings.friction_Nm, 0.0, kMostAxleFriction_Nm},
        {"lowest angle in radians", settings.lowest_rad, -kAnyAngle_rad, kAnyAngle_rad},
        {"highest angle in radians", settings.highest_rad, settings.lowest_rad, kAnyAngle_rad},
        {"load in newtons", settings.load_N, 0.0, kMostAxleLoad_N},
        {"load's distance in metres", settings.load_B.norm(), 0.0, kFarthestOnAxle_m},
    };
    if (auto checked = check_ranges("an axle's", ranges); !checked) {
        return checked;
    }
    const double about_centre_kg_m2 = move_pivot(settings, settings.centre_B).inertia_kg_m2;
    if (!(about_centre_kg_m2 >= 0.0)) {
        std::ostringstream message;
        message << "an axle's inertia is " << settings.inertia_kg_m2
                << " kg m^2, and its mass alone, where its centre lies, has "
                << settings.inertia_kg_m2 - about_centre_kg_m2 << " about the pivot";
        return fail(message.str(), {}, "give it that much at least, or less mass");
    }
    return {};
}

}  // namespace fulcrum
