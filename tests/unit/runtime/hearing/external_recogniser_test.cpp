#include "runtime/hearing/external_recogniser.h"

#include "dialogue/marking/mark_answer.h"
#include "runtime/audio/voice/voice_program.h"
#include "runtime/files/run_program.h"
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

std::unique_ptr<ExternalRecogniser> start(std::vector<std::string> words,
                                          std::vector<std::string> recordings = {}) {
    return ExternalRecogniser::create({std::move(words), std::move(recordings), true}).value();
}

std::string only(const std::vector<dialogue::Hypothesis>& heard) {
    return heard.size() == 1 ? heard.front().text : "(" + std::to_string(heard.size()) + ")";
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

TEST_CASE("hearing: any program that keeps to the lines will do") {
    const auto recogniser =
        start(shell("echo '{\"ready\":1,\"name\":\"ear\"}'; read line; "
                    "echo '{\"listening\":1,\"unknown\":[\"egg\"]}'; "
                    "echo '{\"heard\":9,\"text\":\"of another question\",\"confidence\":1}'; "
                    "echo '{\"heard\":1,\"text\":\"the apple\",\"confidence\":0.5}'; read line"));
    REQUIRE(recogniser->listen(make_question().templates));
    CHECK(recogniser->listening());
    std::vector<dialogue::Hypothesis> heard;
    while (heard.empty() && recogniser->name() != "none") {
        heard = recogniser->poll();
    }
    CHECK(only(heard) == "the apple");
    CHECK(heard.front().confidence == 0.5);
    CHECK_FALSE(recogniser->listening());
    CHECK(recogniser->name() == "ear");
    CHECK(recogniser->take_trouble() == "Nobody knows how \"egg\" sounds, so it is never heard.");
    CHECK(recogniser->take_trouble().empty());
}

TEST_CASE("hearing: a program that talks nonsense or ends is told once, and nothing is heard") {
    const auto recogniser =
        start(shell("read line; echo nonsense; echo '{\"trouble\":\"no ears\"}'"));
    REQUIRE(recogniser->listen(make_question().templates));
    while (recogniser->name() != "none") {
        CHECK(recogniser->poll().empty());
    }
    CHECK(recogniser->take_trouble().find("said what it should not") != std::string::npos);
    CHECK(recogniser->take_trouble() == "The program that hears: no ears.");
    CHECK(recogniser->take_trouble() ==
          "Nobody hears any more: the program sh has ended; type the answers.");
    CHECK(recogniser->listen(make_question().templates));
    CHECK(recogniser->poll().empty());
    CHECK(recogniser->take_trouble().empty());
}

TEST_CASE("hearing: a program that hears the meaning alone says so of each answer") {
    for (const char* ready :
         {"{\"ready\":1,\"name\":\"a\"}", "{\"ready\":1,\"name\":\"a\",\"form\":false}"}) {
        const auto recogniser = start(
            shell("echo '" + std::string(ready) +
                  "'; while read -r line; do case $line in *end*) "
                  "echo '{\"heard\":1,\"text\":\"the egg\",\"confidence\":0.9}';; esac; done"));
        REQUIRE(recogniser->listen(make_question().templates));
        recogniser->hear(std::vector<std::int16_t>(100, 1));
        const auto heard = recogniser->poll();
        REQUIRE(heard.size() == 1);
        CHECK(heard.front().form == (std::string_view(ready).find("form") == std::string::npos));
    }
}

TEST_CASE("hearing: an utterance is given in pieces, and only while somebody listens") {
    // Tells how many lines of audio came before the end.
    const auto recogniser = start(
        shell("n=0; while read -r line; do case $line in *audio*) n=$((n+1));; "
              "*end*) echo \"{\\\"heard\\\":1,\\\"text\\\":\\\"$n\\\",\\\"confidence\\\":1}\";; "
              "esac; done"));
    const std::vector<std::int16_t> utterance(7000, 5);
    recogniser->hear(utterance);
    REQUIRE(recogniser->listen(make_question().templates));
    CHECK(recogniser->poll().empty());
    recogniser->hear(utterance);
    CHECK(only(recogniser->poll()) == "3");
    recogniser->hear(utterance);
    CHECK(recogniser->poll().empty());
}

TEST_CASE("hearing: what fits nothing is passed over where anybody may be heard") {
    for (const bool passes_over : {true, false}) {
        CAPTURE(passes_over);
        const auto recogniser =
            ExternalRecogniser::create(
                {shell("while read -r line; do case $line in *end*) "
                       "echo '{\"heard\":1,\"text\":\"the egg\",\"confidence\":0.001}'; "
                       "echo '{\"heard\":1,\"text\":\"\",\"confidence\":0.9}'; "
                       "echo '{\"trouble\":\"done\"}';; esac; done"),
                 {},
                 true,
                 passes_over})
                .value();
        REQUIRE(recogniser->listen(make_question().templates));
        recogniser->hear(std::vector<std::int16_t>(100, 1));
        std::vector<dialogue::Hypothesis> heard;
        for (std::string trouble; trouble.empty() && heard.empty();) {
            heard = recogniser->poll();
            trouble = recogniser->take_trouble();
        }
        CHECK(heard.empty() == passes_over);
        CHECK(recogniser->listening() == passes_over);
    }
}

TEST_CASE("hearing: a recording that is none, and a program that is not there, are one sentence") {
    const ScratchFolder folder;
    folder.write("none.wav", "RIFFnonsense");
    const auto recogniser =
        start(shell("sleep 100"), {folder.file("none.wav"), folder.file("missing.wav")});
    for (const char* file : {"none.wav", "missing.wav"}) {
        REQUIRE(recogniser->listen(make_question().templates));
        CHECK(recogniser->take_trouble().find(folder.file(file)) == 0);
        CHECK(recogniser->poll().empty());
    }
    CHECK_FALSE(ExternalRecogniser::create({{"no_such_program_4"}, {}, true}));
    CHECK_FALSE(recogniser->listen(nullptr));
}
