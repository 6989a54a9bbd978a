#include "haptics/field/field.h"

#include <catch2/catch.hpp>

#include <limits>

using namespace fulcrum;

namespace {

FieldPlan make_spring() {
    FieldPlan plan;
    plan.kind = FieldKind::spring;
    plan.anchor_W = Vector3(0.1, 0.0, 0.0);
    plan.stiffness_N_per_m = 100.0;
    plan.damping_Ns_per_m = 2.0;
    return plan;
}

FieldPlan make_magnet() {
    FieldPlan plan;
    plan.kind = FieldKind::magnet;
    plan.peak_force_N = 3.0;
    plan.range_m = 0.05;
    return plan;
}

}  // namespace

TEST_CASE("field: coefficients outside their ranges are refused") {
    CHECK(validate(make_spring()));
    CHECK(validate(make_magnet()));
    FieldPlan plan = make_spring();
    plan.stiffness_N_per_m = 2001.0;
    REQUIRE_FALSE(validate(plan));
    CHECK(to_sentence(validate(plan).error()).find("0 to 2000") != std::string::npos);
    plan = make_spring();
    plan.damping_Ns_per_m = -1.0;
    CHECK_FALSE(validate(plan));
    plan = make_magnet();
    plan.range_m = 0.0;
    CHECK_FALSE(validate(plan));
    plan = make_magnet();
    plan.range_m = 0.002;  // 3 N over 2 mm: 2473 N/m at the centre
    CHECK_FALSE(validate(plan));
    plan = make_magnet();
    plan.peak_force_N = std::numeric_limits<double>::quiet_NaN();
    CHECK_FALSE(validate(plan));
    plan = make_magnet();
    plan.anchor_W.y() = std::numeric_limits<double>::infinity();
    CHECK_FALSE(validate(plan));
}
