// The statements of Otaduy & Lin 2005, section 7 and figure 4, on the scene of spoon_scene.h. Bounds are the values found,
// rounded away from them.
#include "tests/support/spoon_scene.h"

#include <catch2/catch.hpp>

using namespace fulcrum;
using namespace fulcrum::test;

namespace {

double penetration_mm(const SpoonSample& sample) {
    return 1.0e3 * sample.penetration_m;
}
double deviation_mm(const SpoonSample& sample) {
    return 1.0e3 * sample.coupling_deviation_m;
}
double contact_N(const SpoonSample& sample) {
    return sample.contact_force_N;
}
double felt_N(const SpoonSample& sample) {
    return sample.felt_force_N;
}

using Number = double (*)(const SpoonSample& sample);
// Pressed and still; the worst in free motion, and of all.
Summary pressed(const std::vector<SpoonSample>& course, Number number) {
    return summarise(course, 0.40, 0.45, number);
}
double worst_free(const std::vector<SpoonSample>& course, Number number) {
    return summarise(course, 0.0, 0.12, number).worst;
}
double worst(const std::vector<SpoonSample>& course, Number number) {
    return summarise(course, 0.0, kSpoonCourse_s, number).worst;
}

const std::vector<SpoonSample>& heavy_rk4() {
    static const auto kCourse =
        run_spoon({.integrator = Integrator::runge_kutta_4, .mass_kg = 0.1});
    return kCourse;
}
const std::vector<SpoonSample>& light_rk4() {
    static const auto kCourse =
        run_spoon({.integrator = Integrator::runge_kutta_4, .mass_kg = 0.01});
    return kCourse;
}
const std::vector<SpoonSample>& soft() {
    static const auto kCourse = run_spoon({.mass_kg = 0.01});
    return kCourse;
}
const std::vector<SpoonSample>& stiff() {
    static const auto kCourse = run_spoon({.mass_kg = 0.01, .contact_stiffness_N_per_m = 1.0e4});
    return kCourse;
}

}  // namespace

TEST_CASE("L14: backward Euler is stable at 10 g with contacts of 2 and of 10 kN/m") {
    for (const auto* course : {&soft(), &stiff()}) {
        CHECK(comes_to_rest(*course));
        // Pressed and still: no ripple in what is felt, and every step solved.
        CHECK(pressed(*course, felt_N).spread < 1.0e-6);
        CHECK(std::all_of(course->begin(), course->end(), [](const SpoonSample& sample) {
            return sample.step.status == StepStatus::done;
        }));
    }
}

TEST_CASE("L14: RK4 is stable at 100 g; at 10 g it chatters, and at 8 kHz comes to rest") {
    CHECK(comes_to_rest(heavy_rk4()));
    CHECK_FALSE(comes_to_rest(light_rk4()));
    CHECK(pressed(heavy_rk4(), felt_N).spread < 0.01);
    CHECK(pressed(light_rk4(), felt_N).spread > 0.1);
    // Here the bound lies between 20 and 30 g, not at 100: contacts are found anew at each of RK4's stages.
    CHECK_FALSE(
        comes_to_rest(run_spoon({.integrator = Integrator::runge_kutta_4, .mass_kg = 0.02})));
    CHECK(comes_to_rest(run_spoon({.integrator = Integrator::runge_kutta_4, .mass_kg = 0.03})));
    const auto fine =
        run_spoon({.integrator = Integrator::runge_kutta_4, .mass_kg = 0.01, .dt_s = 0.000125});
    CHECK(comes_to_rest(fine));
    CHECK(pressed(fine, felt_N).mean == Approx(pressed(soft(), felt_N).mean).epsilon(1e-4));
    CHECK(pressed(fine, penetration_mm).mean ==
          Approx(pressed(soft(), penetration_mm).mean).epsilon(1e-4));
}

TEST_CASE(
    "L14: five times the contact stiffness, a fifth of the penetration, at about the same force") {
    const double soft_mm = worst(soft(), penetration_mm);
    const double stiff_mm = worst(stiff(), penetration_mm);
    CHECK(soft_mm < 0.6);
    CHECK(soft_mm > 0.5);
    CHECK(stiff_mm < 0.13);
    CHECK(soft_mm / stiff_mm == Approx(4.8).margin(0.3));
    CHECK(pressed(stiff(), contact_N).mean / pressed(soft(), contact_N).mean ==
          Approx(1.05).margin(0.05));
}

TEST_CASE("L14: the mass that RK4 needs is felt in free motion; 10 g are not") {
    CHECK(worst_free(heavy_rk4(), deviation_mm) > 1.0);
    CHECK(worst_free(soft(), deviation_mm) < 0.13);
    CHECK(worst_free(heavy_rk4(), felt_N) > 0.8);
    CHECK(worst_free(soft(), felt_N) < 0.1);
    // Nothing touches there: it is inertia alone.
    CHECK(worst_free(heavy_rk4(), contact_N) == 0.0);
}

TEST_CASE(
    "L14: backward Euler at 10 g stays on the figure's axes, and the hand feels what the contacts "
    "push") {
    for (const auto* course : {&soft(), &stiff()}) {
        CHECK(worst(*course, penetration_mm) < 0.7);
        CHECK(worst(*course, deviation_mm) < 5.0);
        CHECK(worst(*course, contact_N) < 1.8);
        CHECK(worst(*course, felt_N) < 1.8);
        CHECK(pressed(*course, felt_N).mean ==
              Approx(pressed(*course, contact_N).mean).epsilon(1e-4));
        // k_c times the deviation is what is felt when nothing moves.
        CHECK(pressed(*course, felt_N).mean ==
              Approx(0.5 * pressed(*course, deviation_mm).mean).epsilon(1e-4));
    }
    // RK4's 100 g strike harder than the axis of forces, which ends at 1.8 N; the rest stays on it.
    CHECK(worst(heavy_rk4(), contact_N) > 2.1);
    CHECK(worst(heavy_rk4(), contact_N) < 2.2);
    CHECK(worst(heavy_rk4(), felt_N) < 1.8);
    CHECK(worst(heavy_rk4(), penetration_mm) < 0.7);
    CHECK(worst(heavy_rk4(), deviation_mm) < 5.0);
}

TEST_CASE("L14: one linear solve a step, as the paper does it, is stable on this scene too") {
    for (const double stiffness_N_per_m : {2.0e3, 1.0e4}) {
        const auto course = run_spoon({.mass_kg = 0.01,
                                       .contact_stiffness_N_per_m = stiffness_N_per_m,
                                       .newton_iterations = 1});
        CHECK(comes_to_rest(course));
        const auto& full = stiffness_N_per_m < 5.0e3 ? soft() : stiff();
        CHECK(pressed(course, felt_N).mean == Approx(pressed(full, felt_N).mean).epsilon(1e-4));
    }
}
