#include "runtime/lesson/why_shown.h"

#include <catch2/catch.hpp>

#include <cmath>

using namespace fulcrum;
using namespace fulcrum::runtime;

namespace {

dialogue::Catalogue words() {
    return dialogue::Catalogue::parse(
               "hud.why = Why?\nhud.why_limits = the limit\nhud.why_gate = held back\n"
               "hud.why_nothing = Nothing.\n")
        .value();
}

ForceShares shares_of(double contact_N, double weight_N) {
    ForceShares shares;
    shares.n = 2;
    shares.each_W[0].force = Vector3(0.0, contact_N, 0.0);
    shares.each_W[1].force = Vector3(0.0, -weight_N, 0.0);
    return shares;
}

HapticState state_of(double asked_N, double felt_N) {
    HapticState state;
    state.gate = GatePhase::open;
    state.commanded_W.force = Vector3(0.0, asked_N, 0.0);
    state.applied_W.force = Vector3(0.0, felt_N, 0.0);
    return state;
}

}  // namespace

TEST_CASE("why shown: the strongest first, each against the strongest, what acts against said so") {
    WhyShown why({"contact", "weight"}, {5.0, 0.3});
    why.look(shares_of(4.0, 1.0), state_of(3.0, 3.0), 1.0);
    const ViewWhy shown = why.show(words());
    CHECK(shown.visible);
    CHECK(shown.title == "Why?");
    REQUIRE(shown.shares.size() == 2);
    CHECK(shown.shares[0].name == "contact");
    CHECK(shown.shares[0].amount == "4.0 N up");
    CHECK(shown.shares[0].part == 1.0);
    CHECK_FALSE(shown.shares[0].against);
    CHECK(shown.shares[1].amount == "1.0 N down");
    CHECK(shown.shares[1].part == Approx(0.25));
    CHECK(shown.shares[1].against);
}

TEST_CASE("why shown: what limit and gate take is told, what nobody notices is not") {
    WhyShown why({"contact", "weight"}, {5.0, 0.3});
    why.look(shares_of(8.0, 0.04), state_of(7.96, 2.0), 1.0);
    const ViewWhy shown = why.show(words());
    REQUIRE(shown.shares.size() == 3);
    CHECK(shown.shares[1].name == "held back");  // 3 N: from 5 to 2
    CHECK(shown.shares[1].amount == "3.0 N down");
    CHECK(shown.shares[2].name == "the limit");
    CHECK(shown.shares[2].amount == "3.0 N down");
    WhyShown none({"contact", "weight"}, {5.0, 0.3});
    none.look(shares_of(0.01, 0.01), state_of(0.0, 0.0), 1.0);
    REQUIRE(none.show(words()).shares.size() == 1);
    CHECK(none.show(words()).shares[0].name == "Nothing.");
}

TEST_CASE(
    "why shown: shares follow within their time, all alike, and not where time stands still") {
    WhyShown why({"contact", "weight"}, {50.0, 0.3});
    why.look(shares_of(0.0, 0.0), state_of(0.0, 0.0), 1.0);
    why.look(shares_of(9.0, 3.0), state_of(6.0, 6.0), 1.0);  // the same moment
    CHECK(why.show(words()).shares[0].name == "Nothing.");
    why.look(shares_of(9.0, 3.0), state_of(6.0, 6.0), 1.0 + kCalm_s);
    const ViewWhy shown = why.show(words());
    const double follows = 1.0 - std::exp(-1.0);
    char text[32];
    std::snprintf(text, sizeof text, "%.1f N up", 9.0 * follows);
    CHECK(shown.shares[0].amount == text);
    CHECK(shown.shares[1].part == Approx(1.0 / 3.0));
    for (int i = 1; i < 100; ++i) {
        why.look(shares_of(9.0, 3.0), state_of(6.0, 6.0), 1.0 + kCalm_s + 0.1 * i);
    }
    CHECK(why.show(words()).shares[0].amount == "9.0 N up");
}
