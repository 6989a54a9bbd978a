// Programs that hear and do not keep to the lines: they say too much, nothing, or end.
#include "haptics/base/clock.h"
#include "runtime/hearing/external_recogniser.h"
#include "tests/unit/runtime/hearing/asked.h"
#include "tests/unit/runtime/rig.h"

using namespace fulcrum::runtime::test;

namespace {

constexpr double kLongest_s = 20.0;

std::unique_ptr<ExternalRecogniser> start_waiting(std::vector<std::string> words) {
    return ExternalRecogniser::create({.words = std::move(words), .waits = true}).value();
}

// Polls until nobody hears any more; how long the longest poll took, and what was told.
struct Ended {
    double longest_poll_s = 0.0;
    std::vector<std::string> told{};
};
Ended poll_to_its_end(ExternalRecogniser& recogniser) {
    Ended ended;
    const double begun_s = monotonic_now_s();
    while (recogniser.name() != "none" && monotonic_now_s() - begun_s < kLongest_s) {
        const double before_s = monotonic_now_s();
        CHECK(recogniser.poll().empty());
        ended.longest_poll_s = std::max(ended.longest_poll_s, monotonic_now_s() - before_s);
    }
    CHECK(recogniser.name() == "none");
    for (std::string told = recogniser.take_trouble(); !told.empty();
         told = recogniser.take_trouble()) {
        ended.told.push_back(std::move(told));
    }
    return ended;
}

}  // namespace

TEST_CASE("hearing: a program that floods is ended with one sentence, and no poll takes long") {
    struct Flood {
        std::vector<std::string> words;
        const char* why;
    };
    const std::string line = "{\"trouble\":\"again\"}";
    constexpr const char* kMuch =
        "Nobody hears any more: the program yes says much more than it is asked, and was ended; "
        "type the answers.";
    const std::vector<Flood> floods{
        {{"yes"}, kMuch},
        {{"yes", line}, kMuch},
        {shell("tr '\\0' a </dev/zero"),
         "Nobody hears any more: the program sh says a line that is too long; type the answers."},
    };
    for (const bool waits : {true, false}) {
        for (const Flood& flood : floods) {
            CAPTURE(waits, flood.words.front());
            const auto recogniser =
                ExternalRecogniser::create({.words = flood.words, .waits = waits}).value();
            REQUIRE(recogniser->listen(make_question().templates));
            recogniser->hear(std::vector<std::int16_t>(100, 1));
            const Ended ended = poll_to_its_end(*recogniser);
            CHECK(ended.longest_poll_s < 5.0);
            REQUIRE_FALSE(ended.told.empty());
            CHECK(ended.told.size() <= 2);  // that, and what was odd about its lines
            CHECK(ended.told.back() == flood.why);
            CHECK(recogniser->listen(make_question().templates));
            CHECK(recogniser->poll().empty());
            CHECK(recogniser->take_trouble().empty());
        }
    }
}

TEST_CASE("hearing: a poll takes some lines of a program that says many, and leaves the rest") {
    const auto recogniser =
        start_waiting(shell("for i in $(seq 100); do echo \"{\\\"trouble\\\":\\\"$i\\\"}\"; done; "
                            "exec sleep 100"));
    std::vector<std::string> told;
    const double begun_s = monotonic_now_s();
    while (told.size() < 16 && monotonic_now_s() - begun_s < kLongest_s) {
        (void)recogniser->poll();
        for (std::string one = recogniser->take_trouble(); !one.empty();
             one = recogniser->take_trouble()) {
            told.push_back(one);
        }
    }
    CHECK(told.front() == "The program that hears: 1.");
    CHECK(recogniser->name() != "none");
}

TEST_CASE("hearing: a program may say two lines for each that it gets, for as long as it likes") {
    const auto recogniser =
        start_waiting(shell("while read -r line; do echo '{\"trouble\":\"a\"}'; "
                            "echo '{\"trouble\":\"b\"}'; done"));
    constexpr int kQuestions = 300;
    const auto templates = make_question().templates;
    for (int i = 0; i < kQuestions; ++i) {
        REQUIRE(recogniser->listen(templates));
        recogniser->hear(std::vector<std::int16_t>(100, 1));
        CHECK(recogniser->poll().empty());
    }
    CHECK(recogniser->name() != "none");
}

TEST_CASE("hearing: nobody is waited for longer than the patience, nor once somebody gives up") {
    constexpr const char* kSilence =
        "Nobody hears any more: the program sh has said nothing of what was spoken for 1 s, and "
        "was "
        "ended; type the answers.";
    for (const char* script :
         {"exec sleep 1000",
          "while sleep 0.1; do echo '{\"heard\":9,\"text\":\"a\",\"confidence\":1}'; done"}) {
        CAPTURE(script);
        bool gives_up = false;
        const auto recogniser = ExternalRecogniser::create({.words = shell(script),
                                                            .waits = true,
                                                            .patience_s = 1.0,
                                                            .gives_up = [&] { return gives_up; }})
                                    .value();
        REQUIRE(recogniser->listen(make_question().templates));
        recogniser->hear(std::vector<std::int16_t>(100, 1));
        gives_up = true;
        const double begun_s = monotonic_now_s();
        CHECK(recogniser->poll().empty());
        CHECK(monotonic_now_s() - begun_s < 0.5);
        CHECK(recogniser->name() != "none");
        gives_up = false;
        CHECK(poll_to_its_end(*recogniser).told == std::vector<std::string>{kSilence});
        CHECK(monotonic_now_s() - begun_s < 5.0);
    }
}

TEST_CASE("hearing: a program that closes its output is ended at once") {
    for (const bool waits : {true, false}) {
        const auto recogniser =
            ExternalRecogniser::create(
                {.words = shell("exec >&- <&-; exec sleep 1000"), .waits = waits})
                .value();
        REQUIRE(recogniser->listen(make_question().templates));
        recogniser->hear(std::vector<std::int16_t>(100, 1));
        CHECK(poll_to_its_end(*recogniser).told ==
              std::vector<std::string>{
                  "Nobody hears any more: the program sh has ended; type the answers."});
    }
}

TEST_CASE("hearing: in a window too a silent program is told of and ended, and no poll waits") {
    const auto recogniser =
        ExternalRecogniser::create({.words = shell("exec sleep 100"), .patience_s = 0.3}).value();
    REQUIRE(recogniser->listen(make_question().templates));
    CHECK(recogniser->poll().empty());
    CHECK(recogniser->name() != "none");
    recogniser->hear(std::vector<std::int16_t>(100, 1));
    recogniser->hear(std::vector<std::int16_t>(100, 1));
    const Ended ended = poll_to_its_end(*recogniser);
    CHECK(ended.longest_poll_s < 5.0);
    CHECK(ended.told ==
          std::vector<std::string>{"Nobody hears any more: the program sh has said nothing of what "
                                   "was spoken for 0 s, and was ended; type the answers."});
}
