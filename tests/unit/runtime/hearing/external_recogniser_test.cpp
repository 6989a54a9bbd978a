#include "runtime/hearing/external_recogniser.h"

#include "tests/support/scratch_folder.h"
#include "tests/unit/runtime/hearing/asked.h"
#include "tests/unit/runtime/rig.h"

using namespace fulcrum::runtime::test;

namespace {

std::string only(const std::vector<dialogue::Hypothesis>& heard) {
    return heard.size() == 1 ? heard.front().text : "(" + std::to_string(heard.size()) + ")";
}

}  // namespace

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
