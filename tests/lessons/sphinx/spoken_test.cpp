// A lesson played by voice: what a synthetic voice says is heard, marked and answered as what is typed is.
#include "runtime/audio/voice/voice_program.h"
#include "runtime/files/run_program.h"
#include "runtime/progress/sqlite/sqlite_store.h"
#include "tests/lessons/program.h"

#include <atomic>
#include <cstring>

using namespace fulcrum::test;

namespace {

// As a throat so much smaller says it: said slower, and played quicker.
void make_smaller(std::string& wav, double smaller) {
    constexpr std::size_t kRate = 24;  // of a WAV file's header, and bytes a second behind it
    for (const std::size_t at : {kRate, kRate + 4}) {
        std::uint32_t value = 0;
        std::memcpy(&value, wav.data() + at, sizeof value);
        value = static_cast<std::uint32_t>(std::lround(value * smaller));
        std::memcpy(wav.data() + at, &value, sizeof value);
    }
}

// A list of recordings of these sentences, as --hear takes it.
std::string record(const Sandbox& sandbox, const std::vector<std::string>& sentences,
                   double smaller = 1.0) {
    const std::atomic<bool> never{false};
    std::string list;
    for (const std::string& sentence : sentences) {
        auto wav = runtime::run_program(
            {runtime::make_voice_words({.speed = 1.0 / smaller}, sentence), 10'000'000, 20.0},
            never);
        REQUIRE(wav);
        make_smaller(*wav, smaller);
        const std::string name = "said" + std::to_string(list.size()) + ".wav";
        sandbox.write(name, *wav);
        list += name + "\n";
    }
    return sandbox.write("said.txt", list);
}

}  // namespace

TEST_CASE("spoken: the gravity game is played by voice, and what is no answer is asked again") {
    const Sandbox sandbox;
    const std::string list =
        record(sandbox, {"the apple is heavier than the egg", "I want to go home now",
                         "an apple is the heaviest", "the watermelon is the heaviest",
                         "the egg is the lightest"});
    const ProgramRun run =
        sandbox.run("run gravity --headless --speech sphinx --seconds 300 --hear " + list);
    CAPTURE(run.output);
    check_run(run, 0,
              {"the apple is heavier than the egg (right)", "(not heard well)",
               "Please say it again.", "the egg is the lightest (right)"});
    // What was not heard well is no attempt, and no mistake.
    check_says(run.output, {"gravity: finished after", "3 of 3 stars, 4 answers"});
    check_lacks(run.output, {"(wrong"});
}

TEST_CASE("spoken: how small a learner's throat is is kept with the learner, and said is said") {
    const Sandbox sandbox;
    const std::string play =
        "run gravity --headless --speech sphinx --db p.db --seconds 40 --hear " +
        record(sandbox,
               {"the apple is heavier than the egg", "an apple is the heaviest",
                "the watermelon is the heaviest", "the egg is the lightest"},
               1.26);
    for (const char* rest :
         {" --learner Mina", " --learner Mina", " --learner Tom --throat 1.35"}) {
        check_run(sandbox.run(play + rest), 0);
    }
    const auto store = runtime::open_sqlite_store(sandbox.path("p.db"));
    REQUIRE(store);
    const auto data = (*store)->read({});
    REQUIRE(data);
    REQUIRE(data->sessions.size() == 3);
    const auto setting = [&](std::size_t session, const std::string& name) {
        for (const auto& [known, value] : data->sessions[session].settings) {
            if (known == name) {
                return value;
            }
        }
        return std::string();
    };
    CHECK(setting(0, "throat").empty());
    const std::string heard = setting(0, "throat_heard");
    CHECK(heard > "1.00");
    CHECK(heard <= "1.50");
    CHECK(setting(1, "throat") == heard);
    CHECK(setting(2, "throat") == "1.35");
}

TEST_CASE("spoken: how sure one must be to have heard is a knob, from all that fits to nothing") {
    const Sandbox sandbox;
    const std::string play = "run gravity --headless --speech sphinx --seconds 40 --hear " +
                             record(sandbox, {"the apple is heavier than the egg"}) + " --sure ";
    const auto answers = [&](const std::string& sure) {
        const ProgramRun run = sandbox.run(play + sure);
        INFO(run.output);
        const bool badly = run.output.find("(not heard well)") != std::string::npos;
        CHECK(badly != (run.output.find("(right)") != std::string::npos));
        return !badly;
    };
    CHECK(answers("0.5"));
    CHECK_FALSE(answers("1"));
}
