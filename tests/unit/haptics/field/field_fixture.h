// A spring and a magnet that tests change one number of.
#pragma once

#include "haptics/field/field.h"

namespace fulcrum::test {

inline FieldPlan make_spring() {
    FieldPlan plan;
    plan.kind = FieldKind::spring;
    plan.anchor_W = Vector3(0.1, 0.0, 0.0);
    plan.stiffness_N_per_m = 100.0;
    plan.damping_Ns_per_m = 2.0;
    return plan;
}

inline FieldPlan make_magnet() {
    FieldPlan plan;
    plan.kind = FieldKind::magnet;
    plan.peak_force_N = 3.0;
    plan.range_m = 0.05;
    return plan;
}

}  // namespace fulcrum::test
