#include "runtime/app/options.h"
#include "tests/unit/runtime/rig.h"

using namespace fulcrum::runtime::test;

TEST_CASE("usage: help of a command is its own part alone") {
    for (const auto& words : {std::vector<std::string>{"run", "--help"}, {"help", "run"}}) {
        const auto options = value_of(parse_options(words));
        CHECK(options.command == Command::help);
        const std::string help = usage(options.help_for);
        CHECK(help.starts_with("  fulcrum run LESSON "));
        check_says(help, {"--say FILE", "--voice-speed N"});
        check_lacks(help, {"fulcrum soak", "Exit codes"});
    }
    const std::string explain = usage("explain");
    check_says(explain, {"fulcrum explain LESSON", "fulcrum explain --force T"});
    check_lacks(explain, {"fulcrum export"});
    check_says(usage("bench"), {"--draw FILE.csv"});
    // Without a command, and of the list of lessons, all of it.
    CHECK(usage(parse_options(std::vector<std::string>{"help"})->help_for) == usage());
    CHECK(usage(parse_options(std::vector<std::string>{"--mute", "--help"})->help_for) == usage());
    check_says(usage(), {"fulcrum soak"});
    CHECK_FALSE(parse_options(std::vector<std::string>{"help", "gravity"}));
}
