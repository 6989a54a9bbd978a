#include "runtime/hearing/ear.h"

#include "dialogue/marking/mark_answer.h"
#include "haptics/base/clock.h"
#include "runtime/audio/recorded_microphone.h"
#include "runtime/hearing/external_recogniser.h"
#include "tests/support/eventually.h"
#include "tests/unit/runtime/hearing/sounds.h"
#include "tests/unit/runtime/rig.h"

#include <chrono>
#include <thread>

using namespace fulcrum::runtime::test;
using namespace fulcrum::test_support;

namespace {

constexpr GateSettings kAlways{.mode = ListenMode::always};

OpenMicrophone playing(const Samples& samples, double unplugged_at_s = -1.0) {
    return [samples, unplugged_at_s] {
        return Expected<std::unique_ptr<Microphone>>(std::make_unique<RecordedMicrophone>(
            samples, RecordedMicrophoneSettings{.speed = 20.0, .unplugged_at_s = unplugged_at_s}));
    };
}

Samples in_room(const std::string& text) {
    const Samples all = joined({silence(2.0), said(text), silence(60.0)});
    return added(noise(seconds_of(all), 5e-4), all);
}

std::optional<Samples> take(Ear& ear) {
    std::optional<Samples> heard;
    eventually([&] { return (heard = ear.take()).has_value(); });
    return heard;
}

}  // namespace

TEST_CASE("ear: from a microphone to a mark: the learner's error is heard as it was said") {
    dialogue::QuestionSource source;
    source.id = "heaviest";
    source.prompt = "Which one is the heaviest?";
    source.answers = {"[the|a|an] {thing} is the <superlative:heavy>"};
    source.lists = {{"thing", {"watermelon", "apple", "banana", "egg"}}};
    const auto question = dialogue::compile_question(source).value();
    const auto recogniser = ExternalRecogniser::create({{FULCRUM_SPHINX}, {}, true}).value();
    struct Said {
        std::string text, code;
    };
    const std::vector<Said> kSaid{{"the apple is the heaviest", ""},
                                  {"the banana is the most heavy", "R:ADJ:FORM"}};
    for (const Said& each : kSaid) {
        CAPTURE(each.text);
        Ear ear(kAlways, playing(in_room(each.text)));
        ear.listen(true);
        REQUIRE(recogniser->listen(question.templates));
        const auto utterance = take(ear);
        REQUIRE(utterance);
        recogniser->hear(*utterance);
        const auto heard = recogniser->poll();
        REQUIRE(heard.size() == 1);
        CHECK(heard.front().text == each.text);
        CHECK(heard.front().confidence > 0.4);
        const dialogue::Mark mark = mark_answer(question, heard.front().text);
        CHECK((mark.form_errors.empty() ? "" : mark.form_errors.front().errant()) == each.code);
    }
}

TEST_CASE("ear: what it hears is seen while it is heard, and only then") {
    Ear ear(kAlways, playing(joined({silence(1.0), noise(1.0, 0.1), silence(60.0)})));
    ear.listen(true);
    CHECK(eventually([&] { return ear.state().level > 0.5 && ear.state().hears; }));
    CHECK(take(ear));
    CHECK(eventually([&] { return ear.state().level < 0.05 && !ear.state().hears; }));
    CHECK(ear.state().has_microphone);
    ear.speak(true);
    CHECK(eventually([&] { return ear.state().deaf; }));
    ear.speak(false);
    CHECK(eventually([&] { return !ear.state().deaf; }));
    // What nobody took is gone once nobody listens.
    ear.listen(false);
    CHECK_FALSE(ear.take());
}

TEST_CASE("ear: no microphone is one sentence, however long; one that is plugged in is heard") {
    std::atomic<int> n_tries{0};
    std::atomic<bool> plugged_in{false};
    const auto plugged = playing(in_room("the apple is the heaviest"));
    Ear ear(
        kAlways,
        [&]() -> Expected<std::unique_ptr<Microphone>> {
            ++n_tries;
            if (plugged_in) {
                return plugged();
            }
            return fail("no microphone was found", {}, "plug one in, or type");
        },
        0.01);
    ear.listen(true);
    CHECK(eventually([&] { return n_tries > 5; }));
    CHECK_FALSE(ear.state().has_microphone);
    CHECK(ear.take_trouble().find("no microphone was found") == 0);
    CHECK(ear.take_trouble().empty());
    plugged_in = true;
    CHECK(take(ear));
    CHECK(ear.state().has_microphone);
    CHECK(ear.take_trouble().empty());
}

TEST_CASE("ear: unplugged in the middle it says so once, and goes on with the next") {
    std::atomic<int> n_opened{0};
    const auto whole = playing(in_room("the apple is the heaviest"));
    const auto loose = playing(in_room("the apple is the heaviest"), 2.5);
    Ear ear(
        kAlways,
        [&]() -> Expected<std::unique_ptr<Microphone>> {
            return n_opened++ == 0 ? loose() : whole();
        },
        0.01);
    ear.listen(true);
    CHECK(take(ear));
    CHECK(n_opened == 2);
    CHECK(ear.take_trouble().find("the microphone was unplugged") == 0);
    CHECK(ear.take_trouble().empty());
}

TEST_CASE("ear: a microphone that is switched off is told once") {
    Ear ear(kAlways, playing({}));
    std::string trouble;
    CHECK(eventually([&] { return !(trouble = ear.take_trouble()).empty(); }));
    CHECK(trouble.find("the microphone gives no sound") == 0);
    std::this_thread::sleep_for(std::chrono::milliseconds(400));  // eight seconds of its own
    CHECK(ear.take_trouble().empty());
    CHECK(ear.state().has_microphone);
    CHECK(ear.state().level == 0.0);
}
