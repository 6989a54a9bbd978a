#include "dialogue/marking/mark_answer.h"
#include "runtime/audio/voice/voice_program.h"
#include "runtime/files/run_program.h"
#include "runtime/hearing/external_recogniser.h"
#include "tests/support/scratch_folder.h"
#include "tests/unit/runtime/hearing/asked.h"
#include "tests/unit/runtime/hearing/sounds.h"
#include "tests/unit/runtime/rig.h"

#include <atomic>

using namespace fulcrum::runtime::test;

namespace {

// A recording of a sentence, said by flite.
std::string record(const ScratchFolder& folder, const std::string& name, const std::string& text) {
    const std::atomic<bool> never{false};
    const auto wav = run_program({make_voice_words({.speed = 1.0}, text), 10'000'000, 20.0}, never);
    REQUIRE(wav);
    folder.write(name, *wav);
    return folder.file(name);
}

}  // namespace

TEST_CASE("hearing: PocketSphinx hears what is right, learners' errors as said, and no more") {
    const ScratchFolder folder;
    const dialogue::Question question = make_question();
    struct Said {
        std::string text, heard, code;
    };
    const std::vector<Said> kSaid{
        {"The watermelon is the heaviest.", "the watermelon is the heaviest", ""},
        {"The apple is the heaviest.", "the apple is the heaviest", ""},
        {"Watermelon is the heaviest.", "watermelon is the heaviest", "M:DET"},
        {"The banana are the heaviest.", "the banana are the heaviest", "R:VERB:SVA"},
        {"The banana is the most heavy.", "the banana is the most heavy", "R:ADJ:FORM"},
        {"I like to eat ice cream.", "", ""},
        {"The weather is nice today.", "", ""},
        {"My brother plays football in the park.", "", ""},
    };
    std::vector<std::string> recordings;
    for (std::size_t i = 0; i < kSaid.size(); ++i) {
        recordings.push_back(record(folder, std::to_string(i) + ".wav", kSaid[i].text));
    }
    const auto recogniser = start({FULCRUM_SPHINX}, recordings);
    constexpr double kLeast = 0.4;  // below it a lesson asks again
    for (const Said& said : kSaid) {
        CAPTURE(said.text);
        REQUIRE(recogniser->listen(question.templates));
        const auto heard = recogniser->poll();
        REQUIRE(heard.size() == 1);
        if (said.heard.empty()) {
            CHECK(heard.front().confidence < kLeast);
            continue;
        }
        CHECK(heard.front().text == said.heard);
        CHECK(heard.front().confidence > kLeast);
        const dialogue::Mark mark = mark_answer(question, heard.front().text);
        CHECK(mark.understood);
        CHECK((mark.form_errors.empty() ? "" : mark.form_errors.front().errant()) == said.code);
    }
    CHECK(recogniser->name() == "pocketsphinx");
    CHECK(recogniser->take_trouble().empty());
}

TEST_CASE("hearing: a voice four semitones higher is heard by a smaller throat, and not without") {
    const dialogue::Question question = make_question();
    const auto n_heard = [&](const std::vector<std::string>& words) {
        const auto recogniser = start(words);
        int n = 0;
        for (const char* text : {"the watermelon is the heaviest", "the banana is the most heavy",
                                 "the apple is the heaviest", "the egg is the heaviest"}) {
            REQUIRE(recogniser->listen(question.templates));
            recogniser->hear(said(text, 1.26));
            const auto heard = recogniser->poll();
            REQUIRE(heard.size() == 1);
            n += heard.front().text == text && heard.front().confidence > 0.4 ? 1 : 0;
        }
        REQUIRE(recogniser->listen(question.templates));
        recogniser->hear(said("the weather is nice today", 1.26));
        const auto outside = recogniser->poll();
        REQUIRE(outside.size() == 1);
        CHECK(outside.front().confidence < 0.4);
        return n;
    };
    CHECK(n_heard({FULCRUM_SPHINX, "--throats", "1"}) == 0);
    CHECK(n_heard({FULCRUM_SPHINX}) >= 3);
}

TEST_CASE("hearing: in a loud room some is heard, and what fits nothing is still not taken in") {
    const dialogue::Question question = make_question();
    const auto in_room = [](std::string_view text) {
        const Samples voice = joined({silence(0.3), said(text), silence(0.3)});
        double power = 0.0;
        for (const std::int16_t x : voice) {
            power += std::pow(x / 32767.0, 2) / static_cast<double>(voice.size());
        }
        // 20 dB below the voice.
        return added(noise(seconds_of(voice), 0.1 * std::sqrt(power)), voice);
    };
    const auto recogniser = start({FULCRUM_SPHINX});
    const auto is_heard = [&](std::string_view text) {
        REQUIRE(recogniser->listen(question.templates));
        recogniser->hear(in_room(text));
        const auto heard = recogniser->poll();
        REQUIRE(heard.size() == 1);
        return heard.front().confidence > 0.4;
    };
    int n = 0;
    for (const char* text :
         {"the watermelon is the heaviest", "the apple is the heaviest", "the egg is the heaviest",
          "the banana is the heaviest", "an apple is the heaviest", "the egg is most heavy",
          "banana is heaviest", "the apple is the most heaviest"}) {
        n += is_heard(text) ? 1 : 0;
    }
    CHECK(n >= 4);
    for (const char* text : {"the weather is nice today", "my brother plays football"}) {
        CHECK_FALSE(is_heard(text));
    }
}

TEST_CASE("hearing: a list of throats that is none is refused") {
    for (const char* throats : {"", "1,", "x", "0.5", "3", "1,,2"}) {
        const auto recogniser = start({FULCRUM_SPHINX, "--throats", throats});
        REQUIRE(recogniser->listen(make_question().templates));
        recogniser->hear(std::vector<std::int16_t>(100, 1));
        CHECK(recogniser->poll().empty());
        CHECK_FALSE(recogniser->take_trouble().empty());
    }
}
