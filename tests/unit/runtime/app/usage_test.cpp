#include "runtime/app/options.h"

#include <catch2/catch.hpp>

#include <string>
#include <vector>

using namespace fulcrum::runtime;

TEST_CASE("usage: help of a command is its own part alone") {
    for (const auto& words : {std::vector<std::string>{"run", "--help"}, {"help", "run"}}) {
        const auto options = parse_options(words);
        REQUIRE(options);
        CHECK(options->command == Command::help);
        const std::string help = usage(options->help_for);
        CHECK(help.starts_with("  fulcrum run LESSON "));
        CHECK(help.find("--say FILE") != std::string::npos);
        CHECK(help.find("--voice-speed N") != std::string::npos);
        CHECK(help.find("fulcrum soak") == std::string::npos);
        CHECK(help.find("Exit codes") == std::string::npos);
    }
    const std::string explain = usage("explain");
    CHECK(explain.find("fulcrum explain LESSON") != std::string::npos);
    CHECK(explain.find("fulcrum explain --force T") != std::string::npos);
    CHECK(explain.find("fulcrum export") == std::string::npos);
    CHECK(usage("bench").find("--draw FILE.csv") != std::string::npos);
    // Without a command, and of the list of lessons, all of it.
    CHECK(usage(parse_options(std::vector<std::string>{"help"})->help_for) == usage());
    CHECK(usage(parse_options(std::vector<std::string>{"--mute", "--help"})->help_for) == usage());
    CHECK(usage().find("fulcrum soak") != std::string::npos);
    CHECK_FALSE(parse_options(std::vector<std::string>{"help", "gravity"}));
}
