#include "haptics/loop/contact_damper.h"

#include <catch2/catch.hpp>

#include <array>
#include <cmath>
#include <random>
#include <vector>

using namespace fulcrum;

namespace {

constexpr double kRounding = 1.0e-12;

// A plane pushed with 2 N by a spring whose damper has 10 Ns/m.
DampedPlane make_plane(const Vector3& normal_W, const Vector3& velocity_W) {
    return {
        .normal_W = normal_W, .push_N = 2.0, .velocity_W = velocity_W, .damping_Ns_per_m = 10.0};
}

Vector3 added(const std::vector<DampedPlane>& planes) {
    return compute_contact_damping(planes).force_W;
}

}  // namespace

TEST_CASE("contact damper: one plane is a dashpot along its normal, and never pulls") {
    const Vector3 up = Vector3::UnitY();
    // What goes along the surface is not asked for.
    CHECK((added({make_plane(up, {3.0, -0.05, -1.0})}) - 0.5 * up).norm() < kRounding);
    CHECK((added({make_plane(up, {3.0, 0.15, -1.0})}) + 1.5 * up).norm() < kRounding);
    // From 0.2 m/s on the damper would have to hold the hand fast: what is left is nothing.
    for (const double leaves_m_per_s : {0.2, 0.3, 30.0}) {
        CHECK((added({make_plane(up, {0.0, leaves_m_per_s, 0.0})}) + 2.0 * up).norm() < kRounding);
    }
    CHECK(added({}) == Vector3::Zero());
}

TEST_CASE("contact damper: several planes have one damper in all directions that they hold") {
    const Vector3 velocity(0.01, -0.02, 0.03);
    const Vector3 corner =
        added({make_plane(Vector3::UnitX(), velocity), make_plane(Vector3::UnitY(), velocity),
               make_plane(Vector3::UnitZ(), velocity)});
    CHECK((corner + 10.0 * velocity).norm() < kRounding);
    // The valley of two planes that bend by the angle 2 a: along the line none, outwards and across it one, as far as the planes reach.
    for (const double a : {0.0, 1.0e-6, 0.01, 0.1, 0.4}) {
        const auto force = [&](const Vector3& v) {
            return added({make_plane({std::sin(a), std::cos(a), 0.0}, v),
                          make_plane({-std::sin(a), std::cos(a), 0.0}, v)});
        };
        CHECK((force({0.0, -0.05, 0.0}) - 0.5 * Vector3::UnitY()).norm() < 1.0e-6);
        CHECK(force({0.0, 0.0, 7.0}).norm() < 1.0e-6);
        const Vector3 across = force({0.01, 0.0, 0.0});
        const double outwards_N = 4.0 * std::cos(a);
        if (outwards_N * std::tan(a) > 0.1) {
            CHECK((across + 0.1 * Vector3::UnitX()).norm() < kRounding);
        } else {
            // One plane alone, in its own direction.
            const Vector3 second(-std::sin(a), std::cos(a), 0.0);
            const Vector3 force_N = outwards_N * Vector3::UnitY() + across;
            CHECK((force_N - force_N.dot(second) * second).norm() < 1.0e-5);
        }
    }
    // Two solids, each with its own matter and damper: a floor that rises, and a wall that goes away.
    DampedPlane wall = make_plane(Vector3::UnitX(), {0.03, 0.0, 0.0});
    wall.damping_Ns_per_m = 5.0;
    CHECK((added({make_plane(Vector3::UnitY(), {0.0, -0.1, 0.0}), wall}) -
           7.5 * Vector3(-0.03, 0.1, 0.0))
              .norm() < kRounding);
}

TEST_CASE("contact damper: friction is damped while it holds, and no further than it may hold") {
    DampedPlane plane = make_plane(Vector3::UnitY(), {0.02, 0.0, 0.0});
    plane.friction_coefficient = 0.5;
    plane.drag_N_W = {-0.5, 0.0, 0.0};
    CHECK((added({plane}) - Vector3(-0.2, 0.0, 0.0)).norm() < kRounding);
    // What slides stays on the circle, whatever the speed; pressed less it holds less, in the same cone.
    for (const double speed_m_per_s : {0.05, 0.5, 5.0}) {
        plane.velocity_W = {speed_m_per_s, 0.0, 0.0};
        CHECK((added({plane}) - Vector3(-0.5, 0.0, 0.0)).norm() < kRounding);
        plane.velocity_W.y() = 0.05;
        CHECK((added({plane}) - Vector3(-0.25, -0.5, 0.0)).norm() < kRounding);
    }
    // A hand that turns back meets the damper before the spring has let go.
    plane.drag_N_W = {-1.0, 0.0, 0.0};
    plane.velocity_W = {-0.03, 0.0, 0.0};
    CHECK((added({plane}) - Vector3(0.3, 0.0, 0.0)).norm() < kRounding);
    // What is viscous does not grow with the push.
    DampedPlane honey = make_plane(Vector3::UnitY(), {0.2, -0.05, 0.0});
    honey.push_N = 0.02;
    honey.friction_coefficient = 0.1;
    honey.drag_N_W = {-0.402, 0.0, 0.0};
    CHECK((added({honey}) - Vector3(-0.05, 0.5, 0.0)).norm() < kRounding);
    // Lifted off faster than the spring pushes, nothing is held.
    plane.velocity_W = {-0.03, 1.0, 0.0};
    CHECK((added({plane}) - Vector3(1.0, -2.0, 0.0)).norm() < kRounding);
}

TEST_CASE("contact damper: planes that face one way are one, however they share the push") {
    for (const Vector3& velocity :
         {Vector3(0.2, 0.0, 0.0), Vector3(0.5, -0.1, 0.2), Vector3(0.3, 0.05, 0.0)}) {
        DampedPlane whole = make_plane(Vector3::UnitY(), velocity);
        whole.friction_coefficient = 0.8;
        whole.drag_N_W = {-1.6, 0.0, 0.0};
        const ContactDamping one = compute_contact_damping({&whole, 1});
        // Lifted off it holds less, and that is no damper's doing.
        CHECK(one.eased_W.norm() ==
              Approx(0.8 * 10.0 * std::max(velocity.y(), 0.0)).margin(kRounding));
        for (const double share : {1.0, 0.96, 0.5, 0.04, 0.0}) {
            // Where the proxy has just met the second, all of the drag is the first's.
            std::vector<DampedPlane> planes(2, whole);
            planes[0].push_N *= share;
            planes[1].push_N *= 1.0 - share;
            planes[1].normal_W = Vector3(1.0e-6, 1.0, -2.0e-6).normalized();
            planes[1].drag_N_W.setZero();
            const ContactDamping two = compute_contact_damping(planes);
            INFO("share " << share << ", lifted at " << velocity.y());
            CHECK((two.force_W - one.force_W).norm() < 1.0e-5);
            CHECK((two.eased_W - one.eased_W).norm() < 1.0e-5);
        }
    }
}

TEST_CASE("contact damper: whatever the planes, it takes from the hand, and no plane pulls") {
    std::mt19937 random(5);
    std::uniform_real_distribution<double> uniform(-1.0, 1.0);
    const auto vector = [&] { return Vector3(uniform(random), uniform(random), uniform(random)); };
    for (int i = 0; i < 20000; ++i) {
        std::vector<DampedPlane> planes(static_cast<std::size_t>(1 + i % 3));
        const Vector3 velocity = vector();
        const Vector3 first = vector();
        // Far apart, or nearly one; the velocity often nearly along them.
        const double spread = i % 5 == 0 ? 1.0e-6 : 1.0;
        double damping = 0.0;
        for (DampedPlane& plane : planes) {
            plane.normal_W = (first + spread * vector()).normalized();
            plane.push_N = 2.0 + 2.0 * uniform(random);
            plane.damping_Ns_per_m = 5.0 + 5.0 * uniform(random);
            plane.velocity_W = velocity;
            damping = std::max(damping, plane.damping_Ns_per_m);
        }
        const Vector3 felt = added(planes);
        INFO("case " << i << " of " << planes.size() << " planes");
        REQUIRE(felt.dot(velocity) <= 1.0e-9);
        // All of them together are no stronger than the strongest alone.
        REQUIRE(felt.norm() <= damping * velocity.norm() * (1.0 + 1.0e-9));
        Vector3 springs = Vector3::Zero();
        for (const DampedPlane& plane : planes) {
            springs += plane.push_N * plane.normal_W;
        }
        // In the cone of the normals: no plane's share is below zero, seen from any direction that all planes face.
        const Vector3 away = vector();
        const bool faces_all = std::ranges::all_of(
            planes, [&](const DampedPlane& plane) { return plane.normal_W.dot(away) >= 0.0; });
        REQUIRE((!faces_all || (springs + felt).dot(away) >= -1.0e-9));
    }
}

TEST_CASE("contact damper: with friction too it takes from the hand where the push does not fall") {
    std::mt19937 random(6);
    std::uniform_real_distribution<double> uniform(-1.0, 1.0);
    for (int i = 0; i < 20000; ++i) {
        DampedPlane plane = make_plane(Vector3::UnitY(), Vector3::Zero());
        const double most_N = 1.0 + uniform(random);
        plane.friction_coefficient = most_N / plane.push_N;
        plane.drag_N_W =
            most_N * uniform(random) * Vector3(std::cos(3.0 * i), 0.0, std::sin(3.0 * i));
        plane.velocity_W = {uniform(random), -0.1 * (1.0 + uniform(random)), uniform(random)};
        const Vector3 felt = added({plane});
        REQUIRE(felt.dot(plane.velocity_W) <= kRounding);
        const Vector3 force = plane.push_N * plane.normal_W + plane.drag_N_W + felt;
        REQUIRE(std::hypot(force.x(), force.z()) <=
                plane.friction_coefficient * force.y() * (1.0 + kRounding) + kRounding);
    }
}
