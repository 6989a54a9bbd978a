#include "haptics/coupling/tool_coupling.h"

#include <catch2/catch.hpp>

#include <limits>

using namespace fulcrum;

namespace {

template <class Change>
bool accepts(Change change) {
    ToolCouplingSettings settings;
    change(settings);
    return validate(settings).has_value();
}

}  // namespace

TEST_CASE("tool coupling settings: defaults and bounds are accepted") {
    CHECK(validate(ToolCouplingSettings{}));
    CHECK(accepts([](auto& s) { s.turn.stiffness_Nm_per_rad = 1.0e3; }));
    CHECK(accepts([](auto& s) { s.turn.damping_Nms_per_rad.setZero(); }));
    CHECK(accepts([](auto& s) { s.clamp_m = 1.0; }));
    CHECK(accepts([](auto& s) { s.turn = {0.5, Vector3::Zero(), 0.1, 1.0, 0.3}; }));
}

TEST_CASE("tool coupling settings: what is out of range is refused") {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    CHECK_FALSE(accepts([](auto& s) { s.shift.stiffness_N_per_m = -1.0; }));
    CHECK_FALSE(accepts([&](auto& s) { s.shift.damping_Ns_per_m = nan; }));
    CHECK_FALSE(accepts([](auto& s) { s.turn.stiffness_Nm_per_rad = 1.1e3; }));
    CHECK_FALSE(accepts([&](auto& s) { s.turn.stiffness_Nm_per_rad = nan; }));
    for (const int axis : {0, 1, 2}) {
        CHECK_FALSE(accepts([=](auto& s) { s.turn.damping_Nms_per_rad[axis] = -1.0e-9; }));
        CHECK_FALSE(accepts([=](auto& s) { s.turn.damping_Nms_per_rad[axis] = 100.1; }));
        CHECK_FALSE(accepts([=](auto& s) { s.turn.damping_Nms_per_rad[axis] = nan; }));
    }
    CHECK_FALSE(accepts([](auto& s) { s.clamp_m = -0.001; }));
    CHECK_FALSE(accepts([&](auto& s) { s.clamp_m = nan; }));
}

TEST_CASE("tool coupling settings: a torque that would fall, or ranges out of order, are refused") {
    const double infinite = std::numeric_limits<double>::infinity();
    CHECK_FALSE(accepts([](auto& s) { s.turn = {0.5, Vector3::Zero(), 1.0, 0.5, 0.6}; }));
    CHECK_FALSE(accepts([](auto& s) { s.turn = {0.5, Vector3::Zero(), 0.1, 1.0, 0.19}; }));
    CHECK_FALSE(accepts([&](auto& s) { s.turn = {0.5, Vector3::Zero(), 0.1, infinite, 0.3}; }));
    CHECK_FALSE(accepts([&](auto& s) { s.turn = {0.5, Vector3::Zero(), 0.1, 1.0, infinite}; }));
    CHECK_FALSE(accepts([](auto& s) { s.turn = {0.5, Vector3::Zero(), -0.1, 1.0, 0.3}; }));
}

TEST_CASE("tool coupling settings: a clamp and saturation exclude each other") {
    CHECK_FALSE(accepts([](auto& s) {
        s.clamp_m = 0.001;
        s.shift.linear_range_m = 0.004;
        s.shift.saturation_range_m = 0.016;
        s.shift.saturation_force_N = 5.0;
    }));
    CHECK(accepts([](auto& s) { s.clamp_rad = 0.05; }));
    CHECK_FALSE(accepts([](auto& s) { s.clamp_rad = -0.05; }));
    CHECK_FALSE(accepts([](auto& s) { s.clamp_rad = 4.0; }));
    CHECK_FALSE(accepts([](auto& s) {
        s.clamp_rad = 0.05;
        s.turn = {0.5, Vector3::Zero(), 0.1, 1.0, 0.3};
    }));
}
