// The load path of axle_stage.h.
#include "haptics/loop/axle_stage.h"

#include <set>
#include <sstream>
#include <string>
#include <variant>

namespace fulcrum {

Expected<void> validate_axles(const HapticPlan& plan) {
    std::set<std::size_t> solids;
    for (const AxlePlan& axle : plan.axles) {
        if (axle.solid >= plan.solids.size() || !solids.insert(axle.solid).second) {
            return fail("an axle is of solid " + std::to_string(axle.solid) +
                            ", which the plan has not, or has on another axle",
                        {}, "give each solid that there is one axle at most");
        }
        if (const Expected<void> good = validate(axle.axle); !good) {
            return good;
        }
        const double least_kg_m2 = kLeastRimMass_kg * axle.reach_m * axle.reach_m;
        if (!(axle.axle.inertia_kg_m2 >= least_kg_m2)) {
            std::ostringstream sentence;
            sentence << "an inertia of " << axle.axle.inertia_kg_m2
                     << " kg m^2 is too little for a body that a hand presses " << axle.reach_m
                     << " m from its axis: it would shake";
            std::ostringstream advice;
            advice << "give it at least " << least_kg_m2 << " kg m^2";
            return fail(sentence.str(), {}, advice.str());
        }
    }
    return {};
}

AxleStage::AxleStage(const HapticPlan& plan, AxleChannels* channels)
    : channels_(channels), cursor_m_(0.0) {
    if (const auto* ball = std::get_if<SphereShape>(&plan.proxy.cursor)) {
        cursor_m_ = ball->radius_m;
    }
    axles_.reserve(plan.axles.size());
    for (const AxlePlan& planned : plan.axles) {
        Axle axle;
        axle.solid = planned.solid;
        axle.plan = planned;
        axle.settings = planned.axle;
        axle.rest_W = plan.solids[planned.solid].initial_pose_W;
        axles_.push_back(axle);
    }
    frame_.n_axles = static_cast<std::int32_t>(axles_.size());
}

std::size_t AxleStage::memory_bytes() const noexcept {
    return sizeof(AxleStage) + axles_.capacity() * sizeof(Axle) +
           (channels_ != nullptr ? sizeof(AxleChannels) : 0);
}

std::unique_ptr<AxleStage> make_axle_stage(const HapticPlan& plan, AxleChannels* channels) {
    return plan.axles.empty() ? nullptr : std::make_unique<AxleStage>(plan, channels);
}

}  // namespace fulcrum
