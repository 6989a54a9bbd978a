#include "runtime/lesson/hand_fit.h"

#include "tests/unit/runtime/lesson/session_fixture.h"
#include "tests/unit/runtime/rig.h"

using namespace fulcrum::runtime::test;

namespace {

const char* const kArmName = "udp:arm:4701";

HandSetting kept_as(const LearnerId& learner, const std::string& device, const std::string& name,
                    const std::string& value) {
    return {random_record_id(), learner, device, name, value, 1};
}

HandFit fit_of(const std::vector<std::pair<std::string, std::string>>& words) {
    HandFit fit;
    for (const auto& [name, value] : words) {
        REQUIRE(set_fit(fit, name, value));
    }
    return fit;
}

}  // namespace

TEST_CASE("hand fit: what is said in words is what is set, and says itself again") {
    const std::vector<std::pair<std::string, std::string>> words = {
        {"scale", "1.5"}, {"axes", "-x,z,y"}, {"middle", "0.02,-0.1,0"},
        {"clutch", "2"},  {"handed", "left"}, {"checked", "good"}};
    const HandFit fit = fit_of(words);
    CHECK(fit.scale == 1.5);
    CHECK(fit.middle_A == Vector3(0.02, -0.1, 0.0));
    CHECK(fit.clutch_button == 2);
    CHECK(fit.left_handed == true);
    CHECK(words_of(fit) == words);
    const DeviceFit device = device_fit(fit);
    CHECK(validate(device));
    CHECK(device.axes.text() == "-x,z,y");
    CHECK(device_fit({}).axes.is_plain());
    CHECK_FALSE(device_fit({}).left_handed);
    CHECK(device_fit(fit_of({{"clutch", "none"}, {"handed", "right"}})).clutch_button == 0);
}

TEST_CASE("hand fit: what cannot be is refused in a sentence, and nothing is set") {
    const std::pair<const char*, std::vector<const char*>> bad[] = {
        {"scale", {"0", "-1", "4.01", "nan", "inf", "", "1x", "1e300"}},
        {"axes", {"x,y", "x,x,z"}},
        {"middle", {"0,0", "0,0,0,0", "0,nan,0", "0,0.6,0", "a,b,c"}},
        {"clutch", {"0", "9", "12", ""}},
        {"handed", {"both"}},
        {"checked", {""}},
        {"force", {"10"}},
        {"", {"1"}}};
    for (const auto& [name, values] : bad) {
        for (const char* value : values) {
            CAPTURE(name, value);
            HandFit fit;
            CHECK(refusal_of(set_fit(fit, name, value)).ends_with('.'));
            CHECK(words_of(fit).empty());
        }
    }
}

TEST_CASE("hand fit: what is said now goes before what was kept") {
    const HandFit kept = fit_of({{"scale", "2"}, {"handed", "left"}});
    const HandFit all = join(fit_of({{"scale", "3"}}), kept);
    CHECK(all.scale == 3.0);
    CHECK(all.left_handed == true);
    CHECK(words_of(join({}, kept)) == words_of(kept));
}

TEST_CASE("hand fit: of a learner and a device the newest counts; the hand is the same with all") {
    const LearnerId mina = random_record_id();
    const LearnerId tom = random_record_id();
    ProgressData data;
    data.hands = {
        kept_as(mina, kArmName, "scale", "2"), kept_as(mina, kArmName, "scale", "1.5"),
        kept_as(mina, "mouse", "clutch", "4"), kept_as(mina, kAnyDevice, "handed", "left"),
        kept_as(tom, kArmName, "scale", "3"),  kept_as(tom, kArmName, "checked", "good")};
    const KeptFit kept = find_fit(data, mina, kArmName);
    CHECK(kept.notices.empty());
    CHECK(words_of(kept.fit) == words_of(fit_of({{"scale", "1.5"}, {"handed", "left"}})));
    CHECK(find_fit(data, mina, "hid:046d:c626").fit.left_handed == true);
    CHECK(words_of(find_fit(data, random_record_id(), kArmName).fit).empty());
}

TEST_CASE("hand fit: kept words that cannot be are passed over, told, and leave what was good") {
    const LearnerId mina = random_record_id();
    ProgressData data;
    data.hands = {kept_as(mina, kArmName, "scale", "2"), kept_as(mina, kArmName, "scale", "1e9"),
                  kept_as(mina, kArmName, "max_force", "99"),
                  kept_as(mina, kArmName, "axes", "x;y;z")};
    const KeptFit kept = find_fit(data, mina, kArmName);
    CHECK(kept.fit.scale == 2.0);
    CHECK_FALSE(kept.fit.axes);
    REQUIRE(kept.notices.size() == 3);
    check_says(kept.notices[0], {"scale is \"1e9\""});
}

TEST_CASE("hand fit: is kept once for a learner and a device, and read again") {
    MemoryStore store;
    const Learner mina{random_record_id(), "Mina", 1};
    const HandFit fit = fit_of({{"scale", "2"}, {"handed", "left"}, {"checked", "good"}});
    for (int i = 0; i < 3; ++i) {
        REQUIRE(keep_fit(store, mina, kArmName, fit));
    }
    CHECK(store.data.hands.size() == 3);
    CHECK(words_of(read_fit(store, mina, kArmName).fit) == words_of(fit));
    // With another device the hand is the same, and nothing else.
    CHECK(words_of(read_fit(store, mina, "mouse").fit) == words_of(fit_of({{"handed", "left"}})));
    REQUIRE(keep_fit(store, mina, kArmName, fit_of({{"scale", "3"}})));
    CHECK(store.data.hands.size() == 4);
    CHECK(read_fit(store, mina, kArmName).fit.scale == 3.0);
}
