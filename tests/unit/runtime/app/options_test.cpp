#include "runtime/app/options.h"

#include <catch2/catch.hpp>

#include <vector>

using namespace fulcrum;
using namespace fulcrum::runtime;

namespace {
Expected<Options> parse(std::vector<std::string> words) {
    return parse_options(words);
}
}  // namespace

TEST_CASE("options: no words open the list of lessons") {
    CHECK(parse({})->command == Command::menu);
}

TEST_CASE("options: run takes a lesson and every documented flag") {
    const auto options =
        parse({"run",   "gravity",  "--headless", "--seconds",    "2.5",    "--hand",
               "h.lua", "--say",    "s.txt",      "--learner",    "Mina",   "--db",
               "d.db",  "--record", "r.rec",      "--screenshot", "p.png",  "--screenshot-at",
               "1",     "--speech", "text",       "--watch",      "--mute", "--force-limit",
               "10"});
    REQUIRE(options);
    CHECK(options->command == Command::run);
    CHECK(options->lesson == "gravity");
    CHECK(options->headless);
    CHECK(options->seconds == 2.5);
    CHECK(options->hands == std::vector<std::string>{"h.lua"});
    CHECK(options->say == "s.txt");
    CHECK(options->learner == "Mina");
    CHECK(options->database == "d.db");
    CHECK(options->record == "r.rec");
    CHECK(options->screenshot == "p.png");
    CHECK(options->screenshot_at_s == 1.0);
    CHECK(options->speech == SpeechInput::text);
    CHECK(options->watch);
    CHECK(options->mute);
    CHECK(options->force_limit_N == 10.0);
}

TEST_CASE("options: a run may keep real time, no other command may") {
    CHECK(parse({"run", "gravity", "--headless", "--real-time"})->real_time);
    CHECK_FALSE(parse({"run", "gravity", "--headless"})->real_time);
    CHECK_FALSE(parse({"test", "gravity", "--real-time"}));
}

TEST_CASE("options: devices are listed for people or for programs, and nothing else is asked") {
    CHECK(parse({"devices"})->command == Command::devices);
    CHECK(parse({"devices", "--json"})->json);
    CHECK_FALSE(parse({"devices", "gravity"}));
    CHECK_FALSE(parse({"devices", "--hand", "hid"}));
    CHECK(parse({"run", "gravity", "--hand", "hid:/dev/hidraw3"})->hands ==
          std::vector<std::string>{"hid:/dev/hidraw3"});
    // One device a hand, in their order.
    CHECK(parse({"run", "x", "--hand", "udp:desk:4701", "--hand", "none"})->hands ==
          std::vector<std::string>{"udp:desk:4701", "none"});
}

TEST_CASE("options: explain can play the lesson, and speak to programs") {
    const auto options =
        parse({"explain", "gravity", "--analyze", "--json", "--seconds", "2", "--hand", "h.lua"});
    REQUIRE(options);
    CHECK(options->analyze);
    CHECK(options->json);
    CHECK(options->seconds == 2.0);
    CHECK(options->hands == std::vector<std::string>{"h.lua"});
    CHECK_FALSE(parse({"run", "gravity", "--analyze"}));
    CHECK_FALSE(parse({"explain", "gravity"})->analyze);
}

TEST_CASE("options: the microphone is heard while a key is held, or always") {
    CHECK(parse({"run", "gravity"})->listen == ListenMode::hold);
    CHECK(parse({"run", "gravity", "--listen", "hold"})->listen == ListenMode::hold);
    CHECK(parse({"run", "gravity", "--listen", "always"})->listen == ListenMode::always);
    CHECK(parse({"menu", "--speech", "sphinx", "--listen", "always"})->listen ==
          ListenMode::always);
    CHECK(to_sentence(parse({"run", "gravity", "--listen", "never"}).error())
              .find("use hold or always") != std::string::npos);
}

TEST_CASE("options: how sure one must be to have heard is a number from 0 to 1") {
    CHECK_FALSE(parse({"run", "gravity"})->sureness);
    CHECK(parse({"run", "gravity", "--speech", "sphinx", "--sure", "0.7"})->sureness == 0.7);
    CHECK(parse({"menu", "--speech", "sphinx", "--sure", "0"})->sureness == 0.0);
    for (const char* value : {"-0.1", "1.1", "nan", "much", ""}) {
        CAPTURE(value);
        const auto refused = parse({"run", "gravity", "--sure", value});
        REQUIRE_FALSE(refused);
        CHECK(to_sentence(refused.error()).find("give a number from 0 to 1") != std::string::npos);
    }
    CHECK_FALSE(parse({"list", "--sure", "0.5"}));
    CHECK(usage().find("--sure N") != std::string::npos);
}

TEST_CASE("options: a wrong word names the nearest right one") {
    CHECK(to_sentence(parse({"rnu"}).error()).find("did you mean run") != std::string::npos);
    CHECK(to_sentence(parse({"run", "gravity", "--headles"}).error())
              .find("did you mean --headless") != std::string::npos);
    CHECK(to_sentence(parse({"xylophone"}).error()).find("did you mean") == std::string::npos);
}

TEST_CASE("options: no force limit above ten newtons can be asked for") {
    for (const char* value : {"10.01", "0", "-5", "nan", "inf", "1e9", "5N", ""}) {
        CAPTURE(value);
        CHECK_FALSE(parse({"run", "gravity", "--force-limit", value}));
    }
}

TEST_CASE(
    "options: a missing lesson, a missing value and a word too many are said in one sentence") {
    CHECK_FALSE(parse({"run"}));
    CHECK_FALSE(parse({"run", "gravity", "--hand"}));
    CHECK_FALSE(parse({"run", "gravity", "apples"}));
    CHECK_FALSE(parse({"list", "gravity"}));
    CHECK_FALSE(parse({"report", "--headless"}));
    CHECK_FALSE(parse({"report", "--format", "docx"}));
    const auto microphone = parse({"run", "gravity", "--speech", "microphone"});
    REQUIRE_FALSE(microphone);
    CHECK(to_sentence(microphone.error()) ==
          "--speech microphone is not known; use text, sphinx or exec:COMMAND.");
}

TEST_CASE("options: edit distance counts letters") {
    CHECK(edit_distance("", "abc") == 3);
    CHECK(edit_distance("kitten", "sitting") == 3);
    CHECK(edit_distance("same", "same") == 0);
}

TEST_CASE("options: options without a command are those of the list of lessons") {
    const auto options = parse({"--learner", "Mina", "--mute"});
    REQUIRE(options);
    CHECK(options->command == Command::menu);
    CHECK(options->learner == "Mina");
    CHECK(options->mute);
    CHECK(to_sentence(parse({"--lerner", "Mina"}).error()).find("did you mean --learner") !=
          std::string::npos);
    CHECK_FALSE(parse({"--headless"}));
    CHECK_FALSE(parse({"--learner"}));
}

TEST_CASE("options: a guess that would puzzle is not made") {
    CHECK(to_sentence(parse({"run", "gravity", "--zzzz", "x"}).error()).find("did you mean") ==
          std::string::npos);
}

TEST_CASE("options: help is given wherever it is asked for") {
    for (const std::vector<std::string>& words : {std::vector<std::string>{"--help"},
                                                  {"-h"},
                                                  {"run", "--help"},
                                                  {"run", "gravity", "--help"},
                                                  {"list", "-h"},
                                                  {"check", "gravity", "--help"}}) {
        const auto options = parse(words);
        REQUIRE(options);
        CHECK(options->command == Command::help);
    }
}

TEST_CASE("options: a simulated hand plays by arm, mouse or keyboard, and by nothing else") {
    CHECK_FALSE(parse({"test", "gravity"})->by);
    CHECK(parse({"test", "gravity", "--by", "arm"})->by == PlayedBy::arm);
    CHECK(parse({"test", "gravity", "--by", "mouse"})->by == PlayedBy::mouse);
    CHECK(parse({"run", "gravity", "--headless", "--by", "keyboard"})->by == PlayedBy::keyboard);
    const auto odd = parse({"test", "gravity", "--by", "foot"});
    REQUIRE_FALSE(odd);
    CHECK(to_sentence(odd.error()) == "--by foot is not known; use arm, mouse or keyboard.");
}

TEST_CASE("options: how the hand is set is said in words, and what cannot be is refused") {
    const auto options = parse({"run", "gravity", "--scale", "2", "--axes", "-x,y,z", "--middle",
                                "0,0.1,0", "--clutch", "none", "--handed", "left"});
    REQUIRE(options);
    CHECK(words_of(options->fit) ==
          std::vector<std::pair<std::string, std::string>>{{"scale", "2"},
                                                           {"axes", "-x,y,z"},
                                                           {"middle", "0,0.1,0"},
                                                           {"clutch", "none"},
                                                           {"handed", "left"}});
    CHECK(words_of(parse({"run", "gravity"})->fit).empty());
    // Behind a second --hand it is that one's; which hand a person uses is one thing for all of them.
    using Words = std::vector<std::pair<std::string, std::string>>;
    const auto both = parse({"run", "x", "--scale", "2", "--hand", "udp:a:1", "--axes", "y,x,z",
                             "--hand", "udp:b:1", "--scale", "3", "--handed", "left"});
    REQUIRE(both);
    CHECK(words_of(both->fit) == Words{{"scale", "2"}, {"axes", "y,x,z"}, {"handed", "left"}});
    REQUIRE(both->more_fits.size() == 1);
    CHECK(words_of(both->more_fits[0]) == Words{{"scale", "3"}});
    CHECK_FALSE(parse({"run", "x", "--hand", "mouse", "--hand", "keys", "--scale", "9"}));
    CHECK(parse({"run", "gravity"})->first_use == FirstUseTrial::once);
    CHECK(parse({"run", "gravity", "--first-use", "again"})->first_use == FirstUseTrial::again);
    CHECK(parse({"run", "gravity", "--first-use", "never"})->first_use == FirstUseTrial::never);
    CHECK_FALSE(parse({"run", "gravity", "--first-use", "twice"}));
    CHECK_FALSE(parse({"run", "gravity", "--scale", "9"}));
    CHECK_FALSE(parse({"run", "gravity", "--axes", "x,y"}));
    CHECK_FALSE(parse({"run", "gravity", "--handed", "both"}));
    CHECK_FALSE(parse({"list", "--handed", "left"}));
}

TEST_CASE("options: a record is explained at a time, or exported") {
    const auto force = parse({"explain", "--force", "12.5", "a.rec", "--json"});
    REQUIRE(force);
    CHECK((force->lesson == "a.rec" && force->force_at_s == 12.5 && force->json));
    CHECK_FALSE(parse({"explain", "--force", "soon", "a.rec"}));
    CHECK_FALSE(parse({"explain", "--force", "-1", "a.rec"}));
    const auto nothing = parse({"explain", "--force", "1"});
    REQUIRE_FALSE(nothing);
    CHECK(nothing.error().message.find("needs a record") != std::string::npos);
    const auto table = parse({"export", "a.rec", "--out", "b.csv"});
    REQUIRE(table);
    CHECK((table->command == Command::export_record && table->out == "b.csv"));
    CHECK_FALSE(parse({"export"}));
    CHECK_FALSE(parse({"export", "a.rec", "--json"}));
    CHECK_FALSE(parse({"run", "gravity", "--force", "1"}));
}

TEST_CASE("options: each arm has a key of its own, what stands behind its --hand") {
    const auto both = parse(
        {"run", "x", "--hand", "udp:a:1", "--key", "a.key", "--hand", "udp:b:2", "--key", "b.key"});
    REQUIRE(both);
    CHECK(both->arm.key_file == "a.key");
    REQUIRE(both->more_keys.size() == 1);
    CHECK(both->more_keys[0] == "b.key");
    const auto second =
        parse({"run", "x", "--hand", "udp:a:1", "--hand", "udp:b:2", "--key", "b.key"});
    REQUIRE(second);
    CHECK(second->arm.key_file.empty());
    CHECK(second->more_keys == std::vector<std::string>{"b.key"});
    const auto first =
        parse({"run", "x", "--key", "a.key", "--hand", "udp:a:1", "--hand", "udp:b:2"});
    REQUIRE(first);
    CHECK(first->arm.key_file == "a.key");
    CHECK(first->more_keys.empty());
}

TEST_CASE("options: a stop is of all hands, or of one process") {
    CHECK_FALSE(parse({"stop"})->only_process);
    CHECK(parse({"stop", "--only", "1234"})->only_process == 1234);
    CHECK_FALSE(parse({"stop", "--only", "0"}));
    CHECK_FALSE(parse({"stop", "--only", "1234.5"}));
    CHECK_FALSE(parse({"stop", "--only", "all"}));
}
