// The load-path half of field.h.
#include "haptics/field/field.h"

#include <sstream>

namespace fulcrum {
namespace {

Expected<void> refuse(const char* what, double value, const char* unit, double low, double high) {
    std::ostringstream message;
    message << "the field's " << what << " is " << value << ' ' << unit << ", outside the range "
            << low << " to " << high;
    return fail(message.str(), {}, "set it within that range");
}

bool outside(double value, double low, double high) {
    return !(value >= low && value <= high);
}

}  // namespace

Expected<void> validate(const FieldPlan& plan) {
    if (!is_finite(plan.anchor_W)) {
        return fail("the field's anchor is not a finite position", {}, "give it three numbers");
    }
    const bool has_spring = plan.kind == FieldKind::spring;
    const bool has_magnet = plan.kind == FieldKind::magnet;
    if (has_spring && outside(plan.stiffness_N_per_m, 0.0, kMaxFeltStiffness_N_per_m)) {
        return refuse("stiffness", plan.stiffness_N_per_m, "N/m", 0.0, kMaxFeltStiffness_N_per_m);
    }
    if (!has_magnet && outside(plan.damping_Ns_per_m, 0.0, kMaxFeltDamping_Ns_per_m)) {
        return refuse("damping", plan.damping_Ns_per_m, "Ns/m", 0.0, kMaxFeltDamping_Ns_per_m);
    }
    if (has_magnet && outside(plan.peak_force_N, 0.0, kMaxFieldPeak_N)) {
        return refuse("peak force", plan.peak_force_N, "N", 0.0, kMaxFieldPeak_N);
    }
    if (has_magnet && outside(plan.range_m, 0.001, 100.0)) {
        return refuse("range", plan.range_m, "m", 0.001, 100.0);
    }
    const double centre_N_per_m = compute_largest_gains(plan).stiffness_N_per_m;
    if (has_magnet && centre_N_per_m > kMaxFeltStiffness_N_per_m) {
        return refuse("stiffness at its centre (1.65 peak / range)", centre_N_per_m, "N/m", 0.0,
                      kMaxFeltStiffness_N_per_m);
    }
    return {};
}

}  // namespace fulcrum
