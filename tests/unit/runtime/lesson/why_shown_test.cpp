#include "runtime/lesson/why_shown.h"

#include "tests/support/english_words.h"
#include "tests/unit/runtime/rig.h"

#include <cstdio>

using namespace fulcrum::runtime::test;

namespace {

const EffectSlot kTwo[] = {{Effect::contact}, {Effect::weight}};

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
    WhyShown why(kTwo, {}, {5.0, 0.3});
    why.look(shares_of(4.0, 1.0), state_of(3.0, 3.0), 1.0);
    const ViewWhy shown = why.show(dialogue::english_words());
    CHECK(shown.visible);
    CHECK(shown.title == "Why do I feel this?");
    REQUIRE(shown.shares.size() == 2);
    CHECK(shown.shares[0].name == "what you touch");
    CHECK(shown.shares[0].amount == "4.0 N up");
    CHECK(shown.shares[0].part == 1.0);
    CHECK_FALSE(shown.shares[0].against);
    CHECK(shown.shares[1].amount == "1.0 N down");
    CHECK(shown.shares[1].part == Approx(0.25));
    CHECK(shown.shares[1].against);
}

TEST_CASE("why shown: what limit and gate take is told, what nobody notices is not") {
    WhyShown why(kTwo, {}, {5.0, 0.3});
    why.look(shares_of(8.0, 0.04), state_of(7.96, 2.0), 1.0);
    const ViewWhy shown = why.show(dialogue::english_words());
    REQUIRE(shown.shares.size() == 3);
    CHECK(shown.shares[1].name == "held back");  // 3 N: from 5 to 2
    CHECK(shown.shares[1].amount == "3.0 N down");
    CHECK(shown.shares[2].name == "the limit");
    CHECK(shown.shares[2].amount == "3.0 N down");
    CHECK(shown.shares[1].against);
    // What is held back wholly is against it, too.
    WhyShown closed(kTwo, {}, {5.0, 0.3});
    closed.look(shares_of(3.0, 0.0), state_of(3.0, 0.0), 1.0);
    REQUIRE(closed.show(dialogue::english_words()).shares.size() == 2);
    CHECK_FALSE(closed.show(dialogue::english_words()).shares[0].against);
    CHECK(closed.show(dialogue::english_words()).shares[1].name == "held back");
    CHECK(closed.show(dialogue::english_words()).shares[1].against);
    WhyShown none(kTwo, {}, {5.0, 0.3});
    none.look(shares_of(0.01, 0.01), state_of(0.0, 0.0), 1.0);
    REQUIRE(none.show(dialogue::english_words()).shares.size() == 1);
    CHECK(none.show(dialogue::english_words()).shares[0].name == "You feel nothing now.");
}

TEST_CASE("why shown: shares follow within their time, all alike, not where time stands still") {
    WhyShown why(kTwo, {}, {50.0, 0.3});
    why.look(shares_of(0.0, 0.0), state_of(0.0, 0.0), 1.0);
    why.look(shares_of(9.0, 3.0), state_of(6.0, 6.0), 1.0);  // the same moment
    CHECK(why.show(dialogue::english_words()).shares[0].name == "You feel nothing now.");
    why.look(shares_of(9.0, 3.0), state_of(6.0, 6.0), 1.0 + kCalm_s);
    const ViewWhy shown = why.show(dialogue::english_words());
    const double follows = 1.0 - std::exp(-1.0);
    char text[32];
    std::snprintf(text, sizeof text, "%.1f N up", 9.0 * follows);
    CHECK(shown.shares[0].amount == text);
    CHECK(shown.shares[1].part == Approx(1.0 / 3.0));
    for (int i = 1; i < 100; ++i) {
        why.look(shares_of(9.0, 3.0), state_of(6.0, 6.0), 1.0 + kCalm_s + 0.1 * i);
    }
    CHECK(why.show(dialogue::english_words()).shares[0].amount == "9.0 N up");
}

TEST_CASE("why shown: the catalogue has words for each effect; a lesson's force has its name") {
    const std::vector<ForceDescription> forces{{"breeze", {}, 3}};
    const dialogue::Catalogue catalogue = dialogue::english_words();
    std::set<std::string> seen;
    for (std::size_t kind = 0; kind < kEffectKinds; ++kind) {
        const EffectSlot one[] = {{static_cast<Effect>(kind), 0}};
        WhyShown why(one, forces, {5.0, 0.3});
        ForceShares shares;
        shares.n = 1;
        shares.each_W[0].force = Vector3(0.0, 2.0, 0.0);
        why.look(shares, state_of(2.0, 2.0), 1.0);
        const ViewWhy shown = why.show(catalogue);
        REQUIRE(shown.shares.size() == 1);
        // What the catalogue has not is shown in brackets.
        CHECK(shown.shares[0].name.find('[') == std::string::npos);
        CHECK(seen.insert(shown.shares[0].name).second);
    }
    CHECK(seen.contains("breeze"));
    const EffectSlot unnamed[] = {{Effect::field, 1}};
    WhyShown why(unnamed, forces, {5.0, 0.3});
    ForceShares shares;
    shares.n = 1;
    shares.each_W[0].force = Vector3(-1.0, 0.0, 1.5);
    why.look(shares, state_of(0.0, 1.8), 1.0);
    CHECK(why.show(catalogue).shares[0].name == "2");
    CHECK(why.show(catalogue).shares[0].amount == "1.8 N to you and left");
    // A language may have these words in another order.
    const auto other = dialogue::Catalogue::parse(
                           "hud.why_field = Kraft {name}\nhud.way_near = zu dir\nhud.way_left = "
                           "links\nhud.way_and = {next} {first}\nhud.why_share = {direction}: "
                           "{newtons} N\n")
                           .value();
    CHECK(why.show(other).shares[0].name == "Kraft 2");
    CHECK(why.show(other).shares[0].amount == "links zu dir: 1.8 N");
}
