// L14's table 2 on a scene of our own (penetration_trial.h): what pre-contact braking does to the share of frames in which a
// point got past the layer that pushes. Printed: 1.0e-3 without, 6e-5 with.
#include "tests/support/penetration_trial.h"

#include <catch2/catch.hpp>

using namespace fulcrum;
using namespace fulcrum::test;

namespace {

PenetrationCount run(PreContactBraking braking, double fastest_m_per_s, bool lead_clamped = false) {
    PenetrationCount sum;
    for (const unsigned seed : {1U, 2U}) {
        const PenetrationCount one =
            run_penetration_trial({braking, lead_clamped, 60'000, fastest_m_per_s, seed});
        sum.n_penetrations += one.n_penetrations;
        sum.n_contacts += one.n_contacts;
        sum.n_passed += one.n_passed;
    }
    return sum;
}

}  // namespace

TEST_CASE(
    "penetration ratio: at high speed braking lowers it by far, at moderate speed nothing "
    "penetrates") {
    const PenetrationCount without = run(PreContactBraking::off, 2.0);
    const PenetrationCount with = run(PreContactBraking::one_cycle, 2.0);
    CHECK(without.n_contacts > 20'000);
    CHECK(with.n_contacts > 20'000);
    // Of the order that is printed without brakes, and with them a fifth of it at most; printed is a seventeenth.
    CHECK(without.ratio() > 2.0e-4);
    CHECK(without.ratio() < 5.0e-3);
    CHECK(with.ratio() < 0.2 * without.ratio());
    CHECK(run(PreContactBraking::off, 1.0).ratio() < 1.0e-4);
    CHECK(run(PreContactBraking::one_cycle, 1.0).ratio() < 1.0e-4);
}

TEST_CASE(
    "penetration ratio: even where the hand is too fast the brakes keep the tool from passing") {
    const PenetrationCount without = run(PreContactBraking::off, 3.0);
    CHECK(without.n_passed > 0);
    for (const PreContactBraking braking :
         {PreContactBraking::viscous, PreContactBraking::one_cycle}) {
        const PenetrationCount with = run(braking, 3.0);
        CHECK(with.n_passed < without.n_passed);
        CHECK(with.ratio() < 0.5 * without.ratio());
    }
}

TEST_CASE(
    "penetration ratio: with the hand's motion clamped too nothing passes, even without brakes") {
    for (const double fastest_m_per_s : {2.0, 3.0}) {
        for (const PreContactBraking braking :
             {PreContactBraking::off, PreContactBraking::one_cycle}) {
            const PenetrationCount ours = run(braking, fastest_m_per_s, true);
            CHECK(ours.n_contacts > 10'000);
            CHECK(ours.n_passed == 0);
            CHECK(ours.ratio() < 1.0e-4);
        }
    }
}
