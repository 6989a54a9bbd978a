#include "haptics/dynamics/rigid_body.h"

#include <catch2/catch.hpp>

#include <cmath>

using namespace fulcrum;

namespace {

const Vector3 kGravity_W(0.0, -9.81, 0.0);

RigidBody make_body(double drag_area_m2) {
    return make_rigid_body({0.2, 0.2, 0.05, drag_area_m2});
}

// Height after falling from rest for `time_s` in steps of `dt_s`.
double fall_m(double dt_s, double time_s, double drag_area_m2) {
    RigidBody body = make_body(drag_area_m2);
    const int n = static_cast<int>(std::lround(time_s / dt_s));
    for (int k = 0; k < n; ++k) {
        step_flight(body, kGravity_W, dt_s);
    }
    return body.pose_W.position.y();
}

}  // namespace

TEST_CASE("rigid body: free fall is semi-implicit Euler's own closed form") {
    RigidBody body = make_body(0.0);
    body.velocity_W = Vector3(1.0, 2.0, 0.0);
    const double dt_s = 0.002;
    for (int n = 1; n <= 500; ++n) {
        step_flight(body, kGravity_W, dt_s);
        // v_n = v_0 + g n dt,  x_n = v_0 n dt + g dt^2 n (n + 1) / 2
        REQUIRE(body.velocity_W.y() == Approx(2.0 - 9.81 * n * dt_s).margin(1e-12));
        REQUIRE(body.pose_W.position.y() ==
                Approx(2.0 * n * dt_s - 9.81 * dt_s * dt_s * n * (n + 1) / 2.0).margin(1e-12));
        REQUIRE(body.pose_W.position.x() == Approx(n * dt_s).margin(1e-12));
    }
}

TEST_CASE("rigid body: the error of a fall with drag halves with the step") {
    // x(t) = -ln cosh(sqrt(g c) t) / c from rest.
    const double c = make_body(0.02).drag_per_m;
    const double exact_m = -std::log(std::cosh(std::sqrt(9.81 * c) * 2.0)) / c;
    double before = fall_m(0.02, 2.0, 0.02) - exact_m;
    for (double dt_s = 0.01; dt_s > 0.0005; dt_s *= 0.5) {
        const double error = fall_m(dt_s, 2.0, 0.02) - exact_m;
        CHECK(before / error == Approx(2.0).epsilon(0.02));
        before = error;
    }
    CHECK(std::abs(before) < 0.01);
}

TEST_CASE("rigid body: the terminal speed is met, from above and from below, at any step") {
    for (const double dt_s : {0.001, 0.05, 10.0}) {
        for (const double start_m_per_s : {0.0, -500.0}) {
            RigidBody body = make_body(0.02);
            body.velocity_W.y() = start_m_per_s;
            for (int k = 0; k < 20000; ++k) {
                step_flight(body, kGravity_W, dt_s);
            }
            CHECK(-body.velocity_W.y() ==
                  Approx(compute_terminal_speed_m_per_s(9.81, body.drag_per_m)).epsilon(1e-9));
        }
    }
    // m g = rho C_d A v^2 / 2
    const double v = compute_terminal_speed_m_per_s(9.81, make_body(0.02).drag_per_m);
    CHECK(0.5 * kAirDensity_kg_per_m3 * 0.02 * v * v == Approx(0.2 * 9.81));
}

TEST_CASE("rigid body: drag takes energy, and without gravity it never turns the motion round") {
    RigidBody body = make_body(0.5);
    body.velocity_W = Vector3(30.0, 40.0, -20.0);
    const Vector3 way = body.velocity_W.normalized();
    double before = body.velocity_W.norm();
    for (int k = 0; k < 1000; ++k) {
        step_flight(body, Vector3::Zero(), 0.01);
        REQUIRE(body.velocity_W.norm() < before);
        REQUIRE(body.velocity_W.normalized().dot(way) == Approx(1.0));
        before = body.velocity_W.norm();
    }
    // With gravity: kinetic plus potential energy falls in every step. Semi-implicit Euler without drag changes it by
    // -m g^2 dt^2 / 2 a step, exactly.
    RigidBody free = make_body(0.0);
    const auto energy_J = [](const RigidBody& b) {
        return 0.5 * b.mass_kg * b.velocity_W.squaredNorm() +
               b.mass_kg * 9.81 * b.pose_W.position.y();
    };
    double energy = energy_J(free);
    for (int k = 0; k < 100; ++k) {
        step_flight(free, kGravity_W, 0.002);
        REQUIRE(energy_J(free) - energy ==
                Approx(-0.5 * 0.2 * 9.81 * 9.81 * 0.002 * 0.002).epsilon(1e-6));
        energy = energy_J(free);
    }
}

TEST_CASE("rigid body: a constant spin turns by its angle and stays a rotation") {
    RigidBody body = make_body(0.0);
    body.spin_W = Vector3(0.0, 0.0, 1.5707963267948966);
    for (int k = 0; k < 1000; ++k) {
        step_flight(body, Vector3::Zero(), 0.001);
    }
    CHECK((body.pose_W.orientation * Vector3::UnitX() - Vector3::UnitY()).norm() < 1e-9);
    CHECK(body.pose_W.orientation.coeffs().norm() == Approx(1.0).epsilon(1e-14));
}

TEST_CASE("rigid body: a spin turns about the world's axes, whatever the body's own stand like") {
    RigidBody body = make_body(0.0);
    // Turned about x first, y lies along z; a quarter turn about the world's z leaves it there.
    body.pose_W.orientation = AngleAxis(1.5707963267948966, Vector3::UnitX());
    body.spin_W = Vector3(0.0, 0.0, 1.5707963267948966);
    step_flight(body, Vector3::Zero(), 1.0);
    CHECK((body.pose_W.orientation * Vector3::UnitY() - Vector3::UnitZ()).norm() < 1e-12);
    CHECK((body.pose_W.orientation * Vector3::UnitX() - Vector3::UnitY()).norm() < 1e-12);
}

TEST_CASE("rigid body: drag in air of 1.204 kilograms a cubic metre") {
    // c = 1.204 * 0.02 / (2 * 0.2)
    CHECK(make_body(0.02).drag_per_m == Approx(0.0602));
}
