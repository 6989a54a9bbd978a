#include "haptics/dynamics/integrator.h"

#include <catch2/catch.hpp>

#include <limits>

using namespace fulcrum;

TEST_CASE(
    "integrator settings: each is found by its name, and an unknown name is answered with the "
    "list") {
    for (const Integrator integrator : kIntegrators) {
        const auto found = find_integrator(to_string(integrator));
        REQUIRE(found);
        CHECK(*found == integrator);
    }
    CHECK(to_string(Integrator::runge_kutta_4) == "RK4");
    const auto missing = find_integrator("leapfrog");
    REQUIRE_FALSE(missing);
    CHECK(missing.error().message.find("leapfrog") != std::string::npos);
    CHECK(missing.error().what_to_do.find("backward Euler") != std::string::npos);
}

TEST_CASE(
    "integrator settings: the default is backward Euler, and what is out of range is refused") {
    CHECK(IntegratorSettings{}.integrator == Integrator::backward_euler);
    CHECK(validate(IntegratorSettings{}));
    const auto refuses = [](auto change) {
        IntegratorSettings settings;
        change(settings);
        return !validate(settings);
    };
    CHECK(refuses([](auto& s) { s.least_way_m = -1.0e-9; }));
    CHECK(refuses([](auto& s) { s.least_turn_rad = 0.1; }));
    CHECK(refuses([](auto& s) { s.newton_iterations = 0; }));
    CHECK(refuses([](auto& s) { s.newton_iterations = 101; }));
    CHECK(refuses([](auto& s) { s.newton_tolerance_m_per_s = 0.0; }));
    CHECK(refuses([](auto& s) { s.newton_tolerance_rad_per_s = 2.0; }));
    CHECK(refuses(
        [](auto& s) { s.newton_tolerance_rad_per_s = std::numeric_limits<double>::quiet_NaN(); }));
}

TEST_CASE("integrator settings: inertia that no body has is refused") {
    CHECK(validate(Inertia{}));
    CHECK(validate(make_box_inertia(0.1, {0.02, 0.03, 0.0})));
    CHECK(validate(make_ball_inertia(0.01, 0.03)));
    CHECK_FALSE(validate(Inertia{0.0, {1e-5, 1e-5, 1e-5}}));
    CHECK_FALSE(validate(Inertia{0.1, {1e-5, 1e-5, 0.0}}));
    CHECK_FALSE(validate(Inertia{0.1, {1e-5, 1e-5, 2.1e-5}}));
    CHECK_FALSE(validate(Inertia{0.1, {1e-5, std::numeric_limits<double>::quiet_NaN(), 1e-5}}));
    CHECK_FALSE(validate(Inertia{std::numeric_limits<double>::infinity(), {1e-5, 1e-5, 1e-5}}));
}
