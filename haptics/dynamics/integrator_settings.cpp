// The load-path half of integrator.h.
#include "haptics/base/range.h"
#include "haptics/dynamics/integrator.h"

#include <algorithm>
#include <string>

namespace fulcrum {

Expected<Integrator> find_integrator(std::string_view name) {
    std::string known;
    for (const Integrator integrator : kIntegrators) {
        if (to_string(integrator) == name) {
            return integrator;
        }
        known += (known.empty() ? "" : ", ") + std::string(to_string(integrator));
    }
    return fail("there is no integrator \"" + std::string(name) + "\"", {},
                "choose one of " + known);
}

Expected<void> validate(const IntegratorSettings& settings) {
    const std::array<Range, 5> ranges{
        {{"newton_iterations", static_cast<double>(settings.newton_iterations), 1.0, 100.0},
         {"newton_tolerance_m_per_s", settings.newton_tolerance_m_per_s, 1.0e-14, 1.0},
         {"newton_tolerance_rad_per_s", settings.newton_tolerance_rad_per_s, 1.0e-14, 1.0},
         {"least_way_m", settings.least_way_m, 0.0, 1.0e-3},
         {"least_turn_rad", settings.least_turn_rad, 0.0, 1.0e-3}}};
    return check_ranges("the integrator's", ranges);
}

Expected<void> validate(const Inertia& inertia) {
    const Vector3& moments = inertia.moments_kg_m2;
    const std::array<Range, 4> ranges{{{"mass_kg", inertia.mass_kg, 1.0e-6, 1.0e6},
                                       {"moments_kg_m2.x", moments.x(), 1.0e-12, 1.0e6},
                                       {"moments_kg_m2.y", moments.y(), 1.0e-12, 1.0e6},
                                       {"moments_kg_m2.z", moments.z(), 1.0e-12, 1.0e6}}};
    if (auto checked = check_ranges("the body's", ranges); !checked) {
        return checked;
    }
    // I_x + I_y - I_z is twice a sum of m z^2; rounding may take it below 0 for a flat plate.
    constexpr double kRounding = 1.0e-9;
    if (2.0 * moments.maxCoeff() > (1.0 + kRounding) * moments.sum()) {
        return fail("one of the body's moments of inertia is larger than the two others together",
                    {}, "no body has such moments: compute them again");
    }
    return {};
}

}  // namespace fulcrum
