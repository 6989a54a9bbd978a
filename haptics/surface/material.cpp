#include "haptics/surface/material.h"

#include "haptics/coupling/virtual_coupling.h"
#include "haptics/surface/texture.h"

#include <algorithm>
#include <cmath>

namespace fulcrum {

Expected<void> validate(const Material& material) {
    if (material.name.empty()) {
        return fail("a material has no name", {}, "give it one");
    }
    const auto told = [&material](const Error& error) {
        return Error{material.name + ": " + error.message, error.where, error.what_to_do};
    };
    return validate(material.coupling)
        .and_then([&] { return validate(material.friction); })
        .and_then([&] { return validate(material.texture); })
        .and_then([&] { return validate(material.transient); })
        .map_error(told);
}

double compute_grade(double value, const GradeScale& scale) noexcept {
    if (!(value > scale.low)) {
        return 0.0;
    }
    return std::min(std::log(value / scale.low) / std::log(scale.high / scale.low), 1.0);
}

MaterialFacts describe(const Material& material) {
    const TextureFacts relief =
        measure_texture(material.texture, material.coupling.stiffness_N_per_m, kPress_N);
    const TransientSettings& tap = material.transient;
    const bool rings = tap.kind == TransientKind::decaying_sinusoid ||
                       tap.kind == TransientKind::acceleration_matching;
    MaterialFacts facts;
    facts.stiffness_N_per_m = material.coupling.stiffness_N_per_m;
    facts.ringing_Hz = rings ? tap.frequency_Hz : 0.0;
    facts.rms_height_m = relief.rms_height_m;
    facts.rms_lateral_share = relief.rms_lateral_share;
    facts.dynamic_coefficient = material.friction.dynamic_coefficient;
    const double firm = compute_grade(facts.stiffness_N_per_m, kStiffnessScale);
    facts.hardness = rings ? 0.5 * (firm + compute_grade(facts.ringing_Hz, kRingingScale)) : firm;
    facts.roughness = 0.5 * (compute_grade(facts.rms_height_m, kHeightScale) +
                             compute_grade(facts.rms_lateral_share, kLateralScale));
    facts.slipperiness = 1.0 - compute_grade(facts.dynamic_coefficient, kFrictionScale);
    return facts;
}

}  // namespace fulcrum
