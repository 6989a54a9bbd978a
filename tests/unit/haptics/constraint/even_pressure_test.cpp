#include "haptics/constraint/even_pressure.h"

#include <catch2/catch.hpp>

#include <cmath>
#include <limits>
#include <random>
#include <vector>

namespace fulcrum {
namespace {

constexpr double kExact = 1.0e-7;  // of the force: the billionth that holds what nothing else does

struct Contact {
    Vector3 arm;
    Vector3 normal;
};

Vector6 sum_of(const std::vector<Contact>& contacts, const EvenPressure& pressure) {
    Vector6 sum = Vector6::Zero();
    for (std::size_t k = 0; k < contacts.size(); ++k) {
        sum.head<3>() += pressure.force_N(k) * contacts[k].normal;
        sum.tail<3>() += pressure.force_N(k) * contacts[k].arm.cross(contacts[k].normal);
    }
    return sum;
}

// The corners of a plate of 2 a x 2 b, seen from a height above.
std::vector<Contact> make_plate(double a, double b) {
    std::vector<Contact> contacts;
    for (const double x : {-a, a}) {
        for (const double z : {-b, b}) {
            contacts.push_back({Vector3(x, -0.02, z), Vector3::UnitY()});
        }
    }
    return contacts;
}

EvenPressure make(const std::vector<Contact>& contacts, double reach_m = 0.05) {
    EvenPressure pressure(contacts.size(), reach_m);
    for (const Contact& contact : contacts) {
        REQUIRE(pressure.add(contact.arm, contact.normal, 1.0));
    }
    return pressure;
}

// Up at x, z.
Vector6 push_at(double x, double z, double force_N) {
    Vector6 wrench;
    wrench << Vector3(0.0, force_N, 0.0), Vector3(x, -0.02, z).cross(Vector3(0.0, force_N, 0.0));
    return wrench;
}

TEST_CASE("even pressure: four corners of a plate press as a plane through the load has it") {
    constexpr double kA = 0.03;
    constexpr double kB = 0.02;
    const std::vector<Contact> corners = make_plate(kA, kB);
    EvenPressure pressure = make(corners);
    for (const double x : {0.0, 0.005, -0.011}) {
        for (const double z : {0.0, -0.004, 0.006}) {
            REQUIRE(pressure.solve(push_at(x, z, 3.0)));
            for (std::size_t k = 0; k < corners.size(); ++k) {
                const double share = 0.25 * (1.0 + x * corners[k].arm.x() / (kA * kA) +
                                             z * corners[k].arm.z() / (kB * kB));
                CAPTURE(x, z, k);
                CHECK(pressure.force_N(k) == Approx(3.0 * share).margin(3.0 * kExact));
            }
        }
    }
}

TEST_CASE("even pressure: a load over an edge leaves the others free, and one over a corner all") {
    const std::vector<Contact> corners = make_plate(0.03, 0.02);
    EvenPressure pressure = make(corners);
    REQUIRE(pressure.solve(push_at(0.03, 0.0, 2.0)));
    CHECK(pressure.force_N(0) == Approx(0.0).margin(1.0e-5));
    CHECK(pressure.force_N(1) == Approx(0.0).margin(1.0e-5));
    CHECK(pressure.force_N(2) == Approx(1.0).margin(1.0e-5));
    CHECK(pressure.force_N(3) == Approx(1.0).margin(1.0e-5));
    REQUIRE(pressure.solve(push_at(-0.03, -0.02, 2.0)));
    CHECK(pressure.force_N(0) == Approx(2.0).margin(1.0e-5));
}

TEST_CASE("even pressure: shares press, add up to what is shared, and no others are more even") {
    std::mt19937 random(7);
    std::uniform_real_distribution<double> any(-1.0, 1.0);
    for (int i = 0; i < 400; ++i) {
        std::vector<Contact> contacts;
        Vector6 wrench = Vector6::Zero();
        std::vector<double> given;
        for (int k = 0; k < 3 + i % 60; ++k) {
            contacts.push_back({0.05 * Vector3(any(random), any(random), any(random)),
                                Vector3(any(random), any(random), any(random)).normalized()});
            given.push_back(std::max(any(random), 0.0));
            wrench.head<3>() += given.back() * contacts.back().normal;
            wrench.tail<3>() += given.back() * contacts.back().arm.cross(contacts.back().normal);
        }
        EvenPressure pressure = make(contacts);
        if (!pressure.solve(wrench)) {
            REQUIRE(wrench.isZero(0.0));
            continue;
        }
        Vector6 off = sum_of(contacts, pressure) - wrench;
        off.tail<3>() /= 0.05;
        double squares = 0.0;
        double given_squares = 0.0;
        for (std::size_t k = 0; k < contacts.size(); ++k) {
            REQUIRE(pressure.force_N(k) >= 0.0);
            squares += pressure.force_N(k) * pressure.force_N(k);
            given_squares += given[k] * given[k];
        }
        CAPTURE(i, contacts.size(), pressure.left_over());
        CHECK(off.norm() < 1.0e-4 * wrench.norm());
        CHECK(squares <= given_squares * (1.0 + 1.0e-4));
    }
}

TEST_CASE("even pressure: shares change evenly with the load, whatever begins to press") {
    const std::vector<Contact> corners = make_plate(0.03, 0.02);
    std::vector<Contact> contacts = corners;
    contacts.push_back({Vector3(0.01, -0.02, 0.005), Vector3::UnitY()});
    contacts.push_back({Vector3(0.0, -0.02, 0.005), Vector3(0.1, 1.0, 0.0).normalized()});
    EvenPressure pressure = make(contacts);
    std::vector<double> before;
    for (int i = 0; i <= 3000; ++i) {
        const double x = 0.0299 * std::sin(0.001 * i);
        REQUIRE(pressure.solve(push_at(x, 0.015 * std::cos(0.0017 * i), 1.0)));
        for (std::size_t k = 0; k < contacts.size(); ++k) {
            if (i > 0) {
                CAPTURE(i, k);
                REQUIRE(std::abs(pressure.force_N(k) - before[k]) < 0.01);
            }
        }
        before.clear();
        for (std::size_t k = 0; k < contacts.size(); ++k) {
            before.push_back(pressure.force_N(k));
        }
    }
}

TEST_CASE("even pressure: a contact twice as stiff bears twice as much, one of weight 0 nothing") {
    EvenPressure pressure(3, 0.05);
    REQUIRE(pressure.add(Vector3(0.0, -0.02, 0.0), Vector3::UnitY(), 2.0));
    REQUIRE(pressure.add(Vector3(0.0, -0.02, 0.0), Vector3::UnitY(), 1.0));
    REQUIRE(pressure.add(Vector3(0.0, -0.02, 0.0), Vector3::UnitY(), 0.0));
    REQUIRE(pressure.solve(push_at(0.0, 0.0, 3.0)));
    CHECK(pressure.force_N(0) == Approx(2.0).margin(1.0e-6));
    CHECK(pressure.force_N(1) == Approx(1.0).margin(1.0e-6));
    CHECK(pressure.force_N(2) == 0.0);
}

TEST_CASE("even pressure: what cannot be borne, nothing and no number") {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    EvenPressure pressure(2, 0.05);
    CHECK_FALSE(pressure.solve(push_at(0.0, 0.0, 1.0)));
    CHECK_FALSE(pressure.add(Vector3(nan, 0.0, 0.0), Vector3::UnitY(), 1.0));
    CHECK_FALSE(pressure.add(Vector3::Zero(), Vector3::UnitY(), nan));
    CHECK_FALSE(pressure.add(Vector3::Zero(), Vector3::UnitY(), -1.0));
    CHECK(pressure.size() == 0);
    REQUIRE(pressure.add(Vector3(0.0, -0.02, 0.0), Vector3::UnitY(), 1.0));
    REQUIRE(pressure.add(Vector3(0.01, -0.02, 0.0), Vector3::UnitY(), 1.0));
    CHECK_FALSE(pressure.add(Vector3::Zero(), Vector3::UnitY(), 1.0));
    CHECK_FALSE(pressure.solve(Vector6::Zero()));
    CHECK_FALSE(pressure.solve(Vector6::Constant(nan)));
    CHECK(pressure.force_N(0) == 0.0);
    // A pull: nobody pulls.
    (void)pressure.solve(push_at(0.0, 0.0, -1.0));
    CHECK(pressure.force_N(0) == Approx(0.0).margin(1.0e-6));
    CHECK(pressure.left_over() > 0.9);
    // Aside: what they can bear of it is nothing.
    Vector6 aside = Vector6::Zero();
    aside.x() = 1.0;
    (void)pressure.solve(aside);
    CHECK(std::isfinite(pressure.force_N(0)));
    CHECK(pressure.left_over() > 0.9);
}

}  // namespace
}  // namespace fulcrum
