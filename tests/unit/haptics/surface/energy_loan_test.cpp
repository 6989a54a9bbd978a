#include "haptics/surface/energy_loan.h"

#include <catch2/catch.hpp>

#include <cmath>
#include <rapidcheck.h>

using namespace fulcrum;

namespace {

// What the passivity stage takes for ideal in a period: (S + H)/2 . d, S of the last round.
double ideal_J(const Vector3& before, const ElasticForce& counted, const Vector3& motion) {
    return 0.5 * (before + counted.held_W).dot(motion);
}

Vector3 along_x(double x) {
    return {x, 0.0, 0.0};
}

}  // namespace

TEST_CASE("energy loan: bumps that give back what they took are all ideal, however long") {
    EnergyLoan loan;
    Vector3 before = Vector3::Zero();
    for (int k = 0; k < 10000; ++k) {
        loan.allow(2.0e-4, 0.001);
        // A potential of 1e-4 sin(x / 1 mm), from a place where it is anything.
        const double x = 1.0e-4 * k;
        const Vector3 force = along_x(-0.1 * std::cos(1000.0 * x + 1.0));
        const ElasticForce counted = loan.step(force, along_x(k == 0 ? 0.0 : 1.0e-4));
        if (k > 0) {
            CHECK(ideal_J(before, counted, along_x(1.0e-4)) ==
                  Approx(before.x() * 1.0e-4).margin(1.0e-18));
        }
        CHECK(counted.now_W == force);
        before = force;
    }
}

TEST_CASE("energy loan: what is given for good is lent once, to the limit and no further") {
    EnergyLoan loan;
    double given = 0.0;
    double ideal = 0.0;
    const Vector3 force = along_x(0.5);
    for (int k = 0; k < 1000; ++k) {
        loan.allow(3.0e-4, 0.001);
        const ElasticForce counted = loan.step(force, along_x(k == 0 ? 0.0 : 1.0e-5));
        if (k > 0) {
            given += force.x() * 1.0e-5;
            ideal += ideal_J(force, counted, along_x(1.0e-5));
        }
    }
    CHECK(given == Approx(999 * 5.0e-6));
    CHECK(ideal == Approx(3.0e-4).epsilon(1.0e-9));
    CHECK(loan.owed_J() == Approx(3.0e-4));
}

TEST_CASE("energy loan: what is taken earns no more than the limit") {
    CHECK(rc::check("whatever the forces and the ways, ideal energy is within twice the limit", [] {
        EnergyLoan loan;
        Vector3 before = Vector3::Zero();
        double highest = 0.0;
        double lowest = 0.0;
        double sum = 0.0;
        for (int k = 0; k < 200; ++k) {
            const auto any = [] { return 0.01 * *rc::gen::inRange(-100, 101); };
            const Vector3 force(any(), any(), any());
            const Vector3 motion = 1.0e-3 * Vector3(any(), any(), any());
            loan.allow(1.0e-4, 0.001);
            sum += ideal_J(before, loan.step(force, motion), motion);
            before = force;
            // From the lowest that it ever was, the hand was lent no more than from one end of the loan to the other.
            lowest = std::min(lowest, sum);
            highest = std::max(highest, sum - lowest);
            RC_ASSERT(std::abs(loan.owed_J()) <= 1.0e-4 * (1.0 + 1.0e-9));
        }
        RC_ASSERT(highest <= 2.0e-4 * (1.0 + 1.0e-9));
    }));
}

TEST_CASE("energy loan: a limit falls slowly and rises at once; the surface left, all is settled") {
    EnergyLoan loan;
    loan.allow(1.0, 0.001);
    CHECK(loan.limit_J() == 1.0);
    loan.allow(0.0, 0.1);
    CHECK(loan.limit_J() == Approx(0.9));
    loan.allow(2.0, 0.1);
    CHECK(loan.limit_J() == 2.0);
    for (const double bad : {-1.0, std::nan(""), HUGE_VAL}) {
        loan.allow(bad, 10.0);
        CHECK(loan.limit_J() == 0.0);
    }
    loan.allow(1.0, 0.001);
    (void)loan.step(along_x(1.0), Vector3::Zero());
    (void)loan.step(along_x(1.0), along_x(0.3));
    CHECK(loan.owed_J() == Approx(0.3));
    loan.settle();
    CHECK(loan.owed_J() == 0.0);
    CHECK(loan.limit_J() == 0.0);
    CHECK(loan.step(along_x(1.0), along_x(0.3)).held_W == Vector3::Zero());
}

TEST_CASE("energy loan: no motion, or one that is no number, is not counted") {
    EnergyLoan loan;
    loan.allow(1.0, 0.001);
    (void)loan.step(along_x(1.0), Vector3::Zero());
    CHECK(loan.step(along_x(1.0), Vector3::Zero()).held_W == along_x(1.0));
    (void)loan.step(along_x(1.0), along_x(std::nan("")));
    CHECK(loan.owed_J() == 0.0);
}
