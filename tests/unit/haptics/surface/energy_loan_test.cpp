#include "haptics/surface/energy_loan.h"

#include "haptics/surface/surface_plan.h"

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
    // The debt fades, and so much is lent again.
    CHECK(ideal >= 3.0e-4);
    CHECK(ideal <= 3.0e-4 * (1.0 + 1.0 / kDebtMemory_s));
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
        RC_ASSERT(highest <= 2.0e-4 * (1.0 + 200 * 0.001 / kDebtMemory_s));
    }));
}

TEST_CASE("energy loan: a wrench that turns about its contact owes nothing, however far") {
    WrenchLoan loan;
    const Wrench pushed{Vector3(0.3, -0.2, 0.5), Vector3(0.02, 0.05, -0.01)};
    // The place on its line that is nearest: there nothing moves along the force.
    const Vector3 arm = pushed.force.cross(pushed.torque) / pushed.force.squaredNorm();
    const Vector3 turn = 1.0e-3 * Vector3(0.4, 0.1, -0.8).cross(pushed.force).normalized();
    const WrenchLoan::Way way{arm.cross(turn), turn};
    const double couple_J = pushed.force.dot(way.shift_W) + pushed.torque.dot(way.turn_W);
    REQUIRE(std::abs(couple_J) < 1.0e-3 * std::abs(pushed.force.dot(way.shift_W)));
    for (int k = 0; k < 3000; ++k) {
        loan.allow(1.0e-6, 0.001);
        const WrenchLoan::Counted counted = loan.step_evenly(pushed, way, way);
        REQUIRE(counted.force.held_W == pushed.force);
        REQUIRE(counted.torque.held_W == pushed.torque);
    }
}

TEST_CASE("energy loan: of a wrench no more is ideal than one loan, whichever gave it") {
    CHECK(rc::check("whatever the wrenches and the ways", [] {
        WrenchLoan loan;
        Wrench before{};
        double highest = 0.0;
        double lowest = 0.0;
        double sum = 0.0;
        for (int k = 0; k < 200; ++k) {
            const auto any = [] { return 0.01 * *rc::gen::inRange(-100, 101); };
            const auto vector = [&] { return Vector3(any(), any(), any()); };
            const Wrench next{vector(), 0.1 * vector()};
            const WrenchLoan::Way way{1.0e-3 * vector(), 1.0e-2 * vector()};
            loan.allow(1.0e-4, 0.001);
            const WrenchLoan::Counted counted = loan.step(next, way);
            sum += ideal_J(before.force, counted.force, way.shift_W) +
                   ideal_J(before.torque, counted.torque, way.turn_W);
            before = next;
            lowest = std::min(lowest, sum);
            highest = std::max(highest, sum - lowest);
            RC_ASSERT(std::abs(loan.owed_J()) <= 1.0e-4 * (1.0 + 1.0e-9));
        }
        RC_ASSERT(highest <= 2.0e-4 * (1.0 + 200 * 0.001 / kDebtMemory_s));
    }));
}

TEST_CASE("energy loan: a wrench upon what stands still in a hand that stands gives nothing") {
    WrenchLoan loan;
    const Wrench pushed{Vector3(1.0, 0.0, 0.0), Vector3(0.0, 0.1, 0.0)};
    loan.allow(1.0e-6, 0.001);
    (void)loan.step_evenly(pushed, {}, {});
    // The surface alone moves.
    (void)loan.step_evenly(pushed, {}, {Vector3(0.01, 0.0, 0.0), Vector3(0.0, 0.1, 0.0)});
    CHECK(loan.owed_J() == 0.0);
    const double bad = std::nan("");
    (void)loan.step_evenly(pushed, WrenchLoan::Way{Vector3(bad, 0, 0), Vector3::Zero()},
                           WrenchLoan::Way{Vector3(bad, 0, 0), Vector3::Zero()});
    CHECK(loan.owed_J() == 0.0);
    (void)loan.step_evenly(pushed, WrenchLoan::Way{Vector3(0.01, 0, 0), Vector3::Zero()},
                           WrenchLoan::Way{Vector3(0.01, 0, 0), Vector3::Zero()});
    CHECK(loan.owed_J() == Approx(1.0e-6));
    loan.leave(0.5);
    CHECK(loan.owed_J() == Approx(1.0e-6 * (1.0 - 0.5 / kDebtMemory_s)));
    loan.settle();
    CHECK(loan.owed_J() == 0.0);
}

TEST_CASE(
    "energy loan: a limit falls slowly and rises at once; the surface left, what is owed stays") {
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
    loan.leave(0.5);
    CHECK(loan.owed_J() == Approx(0.3 * (1.0 - 0.5 / kDebtMemory_s)));
    CHECK(loan.limit_J() == Approx(0.5));
    loan.settle();
    CHECK(loan.owed_J() == 0.0);
    CHECK(loan.limit_J() == 0.0);
    CHECK(loan.step(along_x(1.0), along_x(0.3)).held_W == Vector3::Zero());
}

TEST_CASE("energy loan: a share of what is asked for is lent, and a debt fades in its memory") {
    EnergyLoan loan({.debt_memory_s = 2.0, .share = 0.25});
    loan.allow(1.0, 0.001);
    CHECK(loan.limit_J() == 0.25);
    (void)loan.step(along_x(1.0), Vector3::Zero());
    (void)loan.step(along_x(1.0), along_x(0.2));
    loan.leave(0.5);
    CHECK(loan.owed_J() == Approx(0.2 * (1.0 - 0.5 / 2.0)));
    for (const EnergyLoanSettings& bad :
         {EnergyLoanSettings{.debt_memory_s = 0.009}, EnergyLoanSettings{.debt_memory_s = HUGE_VAL},
          EnergyLoanSettings{.share = -0.1}, EnergyLoanSettings{.share = std::nan("")}}) {
        CHECK_FALSE(validate(bad));
    }
    CHECK(validate(EnergyLoanSettings{}));
}

TEST_CASE("energy loan: what the hand has paid besides comes off a debt, and is no credit") {
    constexpr double kWay_m = 0.1;
    EnergyLoan loan;
    loan.allow(0.05, 0.001);
    const Vector3 way = along_x(kWay_m);
    const auto go = [&](double given_J, double paid_J) {
        const Vector3 force = along_x(given_J / kWay_m);
        (void)loan.step_evenly(force, Vector3::Zero(), Vector3::Zero(), 0.0);
        const ElasticForce counted = loan.step_evenly(force, way, way, paid_J);
        return ideal_J(force, counted, way);
    };
    const double unfelt_J = kUnfelt_N * kWay_m;
    // Paid in the round in which it is given it never falls due, however much it is; what was paid more is lost.
    for (int i = 0; i < 20; ++i) {
        CHECK(go(0.2, 0.3) == Approx(0.2));
        CHECK(loan.owed_J() == 0.0);
    }
    CHECK(go(0.04, 0.01) == Approx(0.04));
    CHECK(loan.owed_J() == Approx(0.03));
    CHECK(go(0.06, 0.0) == Approx(0.02 + unfelt_J));
    CHECK(loan.owed_J() == Approx(0.05));
    // Nothing else is taken for a payment.
    for (const double bad_J : {-1.0, std::nan(""), HUGE_VAL}) {
        (void)go(0.0, bad_J);
        CHECK(loan.owed_J() == Approx(0.05).margin(5.0 * unfelt_J));
    }
}

TEST_CASE("energy loan: where a limit falls nothing falls due that was not given in that round") {
    EnergyLoan loan;
    loan.allow(1.0, 0.001);
    (void)loan.step(along_x(1.0), Vector3::Zero());
    (void)loan.step(along_x(1.0), along_x(0.8));
    loan.leave(1.0);  // the limit is gone, the debt is not
    loan.allow(1.0e-3, 0.001);
    (void)loan.step(along_x(0.1), Vector3::Zero());
    for (const double way_m : {1.0e-3, 1.0e-6, 1.0e-12}) {
        const ElasticForce counted = loan.step(along_x(0.1), along_x(way_m));
        CHECK(ideal_J(along_x(0.1), counted, along_x(way_m)) >= -1.0e-18);
        CHECK(counted.held_W.norm() <= 0.1 * (1.0 + 1.0e-9));
    }
}

TEST_CASE("energy loan: no motion, or one that is no number, is not counted") {
    EnergyLoan loan;
    loan.allow(1.0, 0.001);
    (void)loan.step(along_x(1.0), Vector3::Zero());
    CHECK(loan.step(along_x(1.0), Vector3::Zero()).held_W == along_x(1.0));
    (void)loan.step(along_x(1.0), along_x(std::nan("")));
    CHECK(loan.owed_J() == 0.0);
}
