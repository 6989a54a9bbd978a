#include "haptics/constraint/newton_solver.h"

#include "tests/support/contact_scenes.h"
#include "tests/support/contact_stack.h"

#include <catch2/catch.hpp>

namespace fulcrum {
namespace {

using namespace contact_scenes;

constexpr double kStill_m_per_s = 1.0e-9;
constexpr double kPlace_m = 1.0e-8;
constexpr int kMostAgain = 40;  // of 100 steps

TEST_CASE("newton solver: stacks stand, and are seldom solved again") {
    for (const int n : {1, 2, 10, 20}) {
        for (const double top_mass_kg : {1.0, 100.0}) {
            CAPTURE(n, top_mass_kg);
            ContactStack stack({.n_cubes = n, .top_mass_kg = top_mass_kg},
                               settings_of(ContactMethod::newton));
            CHECK(stack.step().n_iterations > 0);
            int n_iterations = 0;
            for (int k = 0; k < 100; ++k) {
                const SolveReport report = stack.step();
                CHECK(report.converged);
                n_iterations += report.n_iterations;
            }
            CHECK(n_iterations <= kMostAgain);
            for (int i = 0; i < n; ++i) {
                CHECK(stack.velocity(i).cwiseAbs().maxCoeff() <= kStill_m_per_s);
            }
            CHECK(stack.drift_m() <= kPlace_m);
            CHECK(std::abs(stack.sunk_m()) <= kPlace_m);
        }
    }
}

TEST_CASE("newton solver: the corners of a stack share its weight alike") {
    ContactStack stack({.n_cubes = 4}, settings_of(ContactMethod::newton));
    stack.step();
    for (const ContactConstraint& c : stack.problem().contacts()) {
        const double above_kg = 4.0 - c.body_b;
        CHECK(std::abs(c.impulse_Ns.x() - 0.25 * above_kg * kGravity * kStep_s) <= kSolved);
        CHECK(c.impulse_Ns.tail<2>().cwiseAbs().maxCoeff() <= kSolved);
    }
}

TEST_CASE("newton solver: a stack that falls lands and stands within few solves a step") {
    constexpr int kMostSolves = 40;
    ContactStack stack({.n_cubes = 10, .start_gap_m = 0.005}, settings_of(ContactMethod::newton));
    for (int k = 0; k < 1000; ++k) {
        const SolveReport report = stack.step();
        CHECK(report.converged);
        CHECK(report.n_iterations <= kMostSolves);
    }
    CHECK(stack.drift_m() <= kPlace_m);
    CHECK(std::abs(stack.sunk_m()) <= kPlace_m);
}

TEST_CASE("newton solver: a heavy body on a light one is no harder than another") {
    for (const double heavy_kg : {1.0e3, 1.0e6}) {
        CAPTURE(heavy_kg);
        ContactStack stack({.n_cubes = 3, .top_mass_kg = heavy_kg},
                           settings_of(ContactMethod::newton));
        const SolveReport report = stack.step();
        CHECK(report.converged);
        for (int i = 0; i < 3; ++i) {
            CHECK(stack.velocity(i).cwiseAbs().maxCoeff() <= kStill_m_per_s);
        }
    }
}

}  // namespace
}  // namespace fulcrum
