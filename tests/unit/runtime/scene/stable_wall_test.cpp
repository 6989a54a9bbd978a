// What the plan makes of a wall that a device cannot hold. That what it makes settles, tests/stability/declared_walls_test.cpp shows.
#include "runtime/effect/surface/stable_wall.h"

#include "haptics/device/simulated/human_impedance.h"
#include "haptics/device/simulated/simulated_arm.h"
#include "haptics/loop/haptic_plan.h"
#include "haptics/surface/materials.h"
#include "tests/support/linear_wall.h"

#include <catch2/catch.hpp>

#include <algorithm>

namespace fulcrum::runtime {
namespace {

CouplingSettings make_wall(double stiffness_N_per_m, double damping_Ns_per_m) {
    return {.stiffness_N_per_m = stiffness_N_per_m, .damping_Ns_per_m = damping_Ns_per_m};
}

bool is_same(const CouplingSettings& a, const CouplingSettings& b) {
    return a.stiffness_N_per_m == b.stiffness_N_per_m && a.damping_Ns_per_m == b.damping_Ns_per_m;
}

// No slew that bounds anything.
WallLoop make_fast_gate(double rate_hz) {
    return {.rate_hz = rate_hz, .max_slew_N_per_s = 1.0e6};
}

// Of the hands, each with the holder's mass and damping.
double find_exact_boundary(const WallHolder& holder, double rate_hz) {
    double least = HUGE_VAL;
    for (const HumanImpedance& hand : kHoldingHands) {
        z_width::LinearWall wall;
        wall.modes = {{holder.mass_kg + hand.mass_kg,
                       hand.damping_Ns_per_m + holder.damping_Ns_per_m, hand.stiffness_N_per_m}};
        wall.period_s = 1.0 / rate_hz;
        wall.delay_s = holder.link_s;
        least = std::min(least, z_width::find_linear_boundary(wall));
    }
    return least;
}

}  // namespace

TEST_CASE("stable wall: a spring's margin is that of the sampled loop's eigenvalues") {
    constexpr double kWithin = 0.04;  // the hold taken for a delay of half a period
    // The eigenvalues of many periods of delay take long.
    constexpr double kMostPeriods = 10.0;
    for (const double rate_hz : {kLeastRate_Hz, 1000.0, kMostRate_Hz}) {
        for (const double periods : {2.0, kMostPeriods}) {
            const double link_s = periods / rate_hz;
            WallHolder holder;
            holder.link_s = link_s;
            constexpr double kStiffness = 100.0;
            const double boundary =
                kStiffness * kGainMargin *
                compute_wall_margin(make_wall(kStiffness, 0.0), holder, make_fast_gate(rate_hz));
            CAPTURE(rate_hz, link_s);
            CHECK(boundary == Approx(find_exact_boundary(holder, rate_hz)).epsilon(kWithin));
        }
    }
}

TEST_CASE("stable wall: what is stable stays, what is not is lowered to what is and then stays") {
    for (const double link_s : {0.0, 0.011}) {
        for (const double rate_hz : {kLeastRate_Hz, 1000.0, kMostRate_Hz}) {
            WallHolder holder;
            holder.link_s = link_s;
            const WallLoop loop{.rate_hz = rate_hz};
            for (const double stiffness : {10.0, 14.0, 1000.0, 5000.0}) {
                for (const double damping : {0.03, 5.0, 50.0}) {
                    const CouplingSettings wanted = make_wall(stiffness, damping);
                    const CouplingSettings felt = fit_wall(wanted, holder, loop);
                    const bool was_stable = compute_wall_margin(wanted, holder, loop) >= 1.0;
                    CAPTURE(link_s, rate_hz, stiffness, damping, felt.stiffness_N_per_m,
                            felt.damping_Ns_per_m);
                    const bool holds = was_stable == is_same(felt, wanted) &&
                                       compute_wall_margin(felt, holder, loop) >= 1.0 &&
                                       felt.stiffness_N_per_m > 0.0 &&
                                       felt.stiffness_N_per_m <= stiffness &&
                                       felt.damping_Ns_per_m <= damping &&
                                       is_same(fit_wall(felt, holder, loop), felt);
                    CHECK(holds);
                }
            }
        }
    }
}

TEST_CASE("stable wall: its vibration asks for no more than the gate's slew") {
    const WallHolder holder;
    const WallLoop loop;
    const CouplingSettings felt = fit_wall(make_wall(1.0e5, 0.0), holder, {.rate_hz = 5000.0});
    const double w_per_s = std::sqrt(felt.stiffness_N_per_m / holder.mass_kg);
    CHECK(0.5 * holder.max_force_N * w_per_s <= loop.max_slew_N_per_s);
    CHECK(0.5 * holder.max_force_N * w_per_s >
          0.99 * loop.max_slew_N_per_s / std::sqrt(kGainMargin));
    // Of a loop that lets less through, more is left.
    WallLoop gentle = {.rate_hz = 5000.0, .max_force_N = 0.5 * holder.max_force_N};
    CHECK(fit_wall(make_wall(1.0e5, 0.0), holder, gentle).stiffness_N_per_m >
          1.2 * felt.stiffness_N_per_m);
}

TEST_CASE(
    "stable wall: the program's materials and its usual coupling are felt as they are on a desktop "
    "arm at hand") {
    SimulatedArmSettings arm = make_desktop_arm();
    const WallHolder usual;
    CHECK(usual.mass_kg == arm.mass_kg);
    CHECK(usual.damping_Ns_per_m == arm.damping_Ns_per_m);
    CHECK(usual.max_force_N == arm.max_force_N);
    for (const double rate_hz : {1000.0, 2000.0, 5000.0}) {
        CHECK(is_same(fit_wall({}, usual, {.rate_hz = rate_hz}), {}));
        for (const Material& material : shipped_materials()) {
            CAPTURE(material.name, rate_hz);
            CHECK(is_same(fit_wall(material.coupling, usual, {.rate_hz = rate_hz}),
                          material.coupling));
        }
    }
}

TEST_CASE("stable wall: of an open device nothing is guessed but a lightest handle") {
    DeviceTraits traits;
    traits.name = "stick";
    traits.max_force_N = 2.0;
    const WallHolder holder = make_wall_holder(traits, 0.004);
    CHECK(holder.name == "stick");
    CHECK(holder.mass_kg == kHandleMass_kg);
    CHECK(holder.damping_Ns_per_m == 0.0);
    CHECK(holder.max_force_N == 2.0);
    CHECK(holder.link_s == 0.004);
}

}  // namespace fulcrum::runtime
