#include "runtime/evidence/record_words.h"

#include "tests/unit/runtime/rig.h"

using namespace fulcrum::runtime::test;

TEST_CASE("record words: a declared force has the lesson's name, one that has none its number") {
    LessonDescription lesson;
    lesson.forces = {{"breeze", {}, 3}};
    const EffectSlot slots[] = {
        {Effect::contact}, {Effect::field, 0}, {Effect::field, 1}, {Effect::brake}};
    const std::vector<std::string> words = effect_words(slots, lesson);
    CHECK(words == std::vector<std::string>{"contact", "force breeze", "force 2", "brake"});
}

TEST_CASE("record words: every phase, fault, event and place has a word of its own") {
    std::set<std::string_view> words;
    for (int i = 0; i <= static_cast<int>(GatePhase::stopped); ++i) {
        words.insert(gate_word(static_cast<GatePhase>(i)));
    }
    CHECK(words.size() == 5);
    words.clear();
    for (int i = 0; i <= static_cast<int>(kLastRecordEvent); ++i) {
        words.insert(event_word(static_cast<RecordEventKind>(i)));
    }
    CHECK(words.size() == static_cast<std::size_t>(kLastRecordEvent) + 1);
    CHECK(where_word(BodyWhere::landed) == "landed");
    CHECK(fault_words(Fault::none) == "none");
    CHECK(fault_words(Fault::device_read | Fault::too_much_energy) ==
          "no pose from the device, too much energy");
    std::set<std::string> faults;
    for (unsigned bit = 1; bit <= static_cast<unsigned>(Fault::other_stopped); bit *= 2) {
        faults.insert(fault_words(static_cast<Fault>(bit)));
    }
    CHECK((faults.size() == 14 && !faults.contains("none")));
}

TEST_CASE("record words: directions are a person's before the screen, the strongest first") {
    CHECK(direction_words({0, -2, 0}) == "down");
    CHECK(direction_words({0, 3, -1}) == "up");
    CHECK(direction_words({-2, 3, 0}) == "up and left");
    CHECK(direction_words({0, 0, 1}) == "towards you");
    CHECK(direction_words({1, 0, -1}) == "right and away from you");
    CHECK(direction_words({1, 1, 1}) == "right and up and towards you");
    // Half a right angle's half: what is nearer to the axis is along it.
    const double below = std::tan(22.0 * M_PI / 180.0);
    const double above = std::tan(23.0 * M_PI / 180.0);
    CHECK(direction_words({1, below, 0}) == "right");
    CHECK(direction_words({1, above, 0}) == "right and up");
    CHECK(direction_words(Vector3::Zero()) == "-");
    CHECK(direction_words({std::numeric_limits<double>::quiet_NaN(), 0, 0}) == "-");
    CHECK(main_axes({-2, 3, 0}) == std::vector<int>{2, -1});
    CHECK(main_axes({0, 0, std::numeric_limits<double>::infinity()}).empty());
}

TEST_CASE("record words: numbers are read again to the bit") {
    for (const double x : {0.1, 1.0 / 3.0, -1e-300, 5e-324, 12345678.9, 0.0}) {
        const std::string text = exact_text(x);
        CHECK(std::strtod(text.c_str(), nullptr) == x);
    }
    CHECK(exact_text(0.1) == "0.1");
}
