#include "haptics/dynamics/hand_rows.h"

#include <catch2/catch.hpp>

namespace fulcrum {
namespace {

constexpr double kRowStep_s = 0.01;
const Inertia kRowInertia{0.2, {1.0e-4, 2.0e-4, 3.0e-4}};

BodyHold make_row_hold() {
    BodyHold hold{.at_W = {0.03, 0.0, 0.0}, .push_W = {{2.0, 1.0, 0.0}, {0.0, 0.0, 0.05}}};
    hold.slopes = {600.0, 5.0, 0.5, 0.01, 0.04};
    hold.bounds = {.along_W = Vector3::UnitX(), .friction_N = 0.7, .most_N = 3.0, .most_Nm = 0.2};
    return hold;
}

TEST_CASE("hand rows: a push goes along as the hand would have it, from nothing to its bound") {
    RigidState state;
    state.velocity_W.linear = {0.5, 0.0, 0.0};
    const HandRows rows = make_hand_rows(make_row_hold(), kRowInertia, state, kRowStep_s);
    REQUIRE(rows.count == 6);
    const double mass_kg = kRowStep_s * (kRowStep_s * 600.0 + 5.0) + 0.04;
    const RowConstraint& along = rows.rows[0];
    CHECK(along.softness == Approx(1.0 / mass_kg));
    CHECK(along.target == Approx(0.5 + kRowStep_s * 2.0 / mass_kg));
    CHECK(along.least == 0.0);
    CHECK(along.most == Approx(kRowStep_s * 3.0));
}

TEST_CASE("hand rows: across it holds what friction bears, and turns as far as its couple goes") {
    const HandRows rows = make_hand_rows(make_row_hold(), kRowInertia, RigidState{}, kRowStep_s);
    CHECK(rows.rows[1].most == Approx(kRowStep_s * 0.7));
    CHECK(rows.rows[1].least == Approx(-kRowStep_s * 0.7));
    CHECK(rows.rows[5].most == Approx(kRowStep_s * 0.05));
    CHECK(rows.rows[5].softness == Approx(1.0 / (kRowStep_s * (kRowStep_s * 0.5 + 0.01))));
}

TEST_CASE("hand rows: a grip holds every way, and what is not bounded above nothing has no row") {
    BodyHold hold = make_row_hold();
    hold.bounds.along_W.setZero();
    HandRows rows = make_hand_rows(hold, kRowInertia, RigidState{}, kRowStep_s);
    REQUIRE(rows.count == 6);
    CHECK(rows.rows[0].least == Approx(-kRowStep_s * 3.0));
    CHECK(rows.rows[2].least == Approx(-kRowStep_s * 3.0));
    CHECK(rows.rows[3].most == Approx(kRowStep_s * 0.2));
    hold.bounds.most_N = 0.0;
    hold.bounds.most_Nm = 0.0;
    CHECK(make_hand_rows(hold, kRowInertia, RigidState{}, kRowStep_s).count == 0);
}

TEST_CASE("hand rows: without slopes a force is given as it is, no further than its bound") {
    BodyHold hold = make_row_hold();
    hold.slopes = {};
    hold.push_W.force.x() = 5.0;
    const HandRows rows = make_hand_rows(hold, kRowInertia, RigidState{}, kRowStep_s);
    REQUIRE(rows.count == 6);
    CHECK(rows.rows[0].least == Approx(kRowStep_s * 3.0));
    CHECK(rows.rows[0].most == rows.rows[0].least);
    CHECK(rows.rows[0].softness == 0.0);
}

}  // namespace
}  // namespace fulcrum
