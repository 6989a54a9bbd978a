#include "haptics/field/field.h"
#include "tests/unit/haptics/field/field_fixture.h"

#include <catch2/catch.hpp>

#include <limits>

using namespace fulcrum;
using namespace fulcrum::test;

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

TEST_CASE("field: each coefficient is accepted at its bounds and refused just past them") {
    const auto accepts = [](FieldKind kind, double FieldPlan::*field, double value) {
        FieldPlan plan;
        plan.kind = kind;
        plan.range_m = 1.0;
        plan.*field = value;
        return validate(plan).has_value();
    };
    CHECK(accepts(FieldKind::spring, &FieldPlan::stiffness_N_per_m, 2000.0));
    CHECK_FALSE(accepts(FieldKind::spring, &FieldPlan::stiffness_N_per_m, 2000.1));
    CHECK_FALSE(accepts(FieldKind::spring, &FieldPlan::stiffness_N_per_m, -0.1));
    CHECK(accepts(FieldKind::viscosity, &FieldPlan::damping_Ns_per_m, 50.0));
    CHECK_FALSE(accepts(FieldKind::viscosity, &FieldPlan::damping_Ns_per_m, 50.1));
    CHECK(accepts(FieldKind::magnet, &FieldPlan::peak_force_N, 10.0));
    CHECK_FALSE(accepts(FieldKind::magnet, &FieldPlan::peak_force_N, 10.1));
    CHECK(accepts(FieldKind::magnet, &FieldPlan::range_m, 100.0));
    CHECK_FALSE(accepts(FieldKind::magnet, &FieldPlan::range_m, 100.1));
    CHECK(accepts(FieldKind::magnet, &FieldPlan::range_m, 0.001));
    CHECK_FALSE(accepts(FieldKind::magnet, &FieldPlan::range_m, 0.0009));
    // 10 N over 8.2 mm: 2011 N/m at the centre.
    FieldPlan plan;
    plan.kind = FieldKind::magnet;
    plan.peak_force_N = 10.0;
    plan.range_m = 0.0083;
    CHECK(validate(plan));
    plan.range_m = 0.0082;
    CHECK_FALSE(validate(plan));
}
