
#include "runtime/app/option_table.h"
#include "runtime/app/parse_options.h"
#include "tests/support/table.h"
#include "tests/unit/runtime/rig.h"

using namespace fulcrum::runtime::test;

namespace {

using Strings = std::vector<std::string>;
using Fit = std::vector<std::pair<std::string, std::string>>;

// The words of a command line, between blanks; '' is an empty one.
Expected<Options> parse(const std::string& line) {
    std::istringstream stream(line);
    Strings words;
    for (std::string word; stream >> word;) {
        words.push_back(word == "''" ? "" : word);
    }
    return parse_options(words);
}

Options read(const std::string& line) {
    INFO(line);
    return value_of(parse(line));
}

}  // namespace

TEST_CASE("options: run takes a lesson and every documented flag") {
    const Options options = read(
        "run gravity --headless --seconds 2.5 --hand h.lua --say s.txt --learner Mina --db d.db "
        "--record r.rec --screenshot p.png --screenshot-at 1 --speech text --watch --mute "
        "--force-limit 10");
    CHECK(options.command == Command::run);
    CHECK(options.lesson == "gravity");
    CHECK(options.headless);
    CHECK(options.seconds == 2.5);
    CHECK(options.hands == Strings{"h.lua"});
    CHECK(options.say == "s.txt");
    CHECK(options.learner == "Mina");
    CHECK(options.database == "d.db");
    CHECK(options.record == "r.rec");
    CHECK(options.screenshot == "p.png");
    CHECK(options.screenshot_at_s == 1.0);
    CHECK(options.speech == SpeechInput::text);
    CHECK(options.watch);
    CHECK(options.mute);
    CHECK(options.force_limit_N == 10.0);
}

TEST_CASE("options: each command takes its own, as it is said") {
    CHECK(read("").command == Command::room);
    const Options menu = read("--learner Mina --mute");
    CHECK(menu.command == Command::room);
    CHECK(read("menu").command == Command::menu);
    CHECK(menu.learner == "Mina");
    CHECK(menu.mute);

    CHECK(read("run gravity --headless --real-time").real_time);
    CHECK_FALSE(read("run gravity --headless").real_time);

    CHECK(read("devices").command == Command::devices);
    CHECK(read("devices --json").json);
    CHECK(read("run gravity --hand hid:/dev/hidraw3").hands == Strings{"hid:/dev/hidraw3"});
    // One device a hand, in their order.
    CHECK(read("run x --hand udp:desk:4701 --hand none").hands == Strings{"udp:desk:4701", "none"});

    const Options explain = read("explain gravity --analyze --json --seconds 2 --hand h.lua");
    CHECK(explain.analyze);
    CHECK(explain.json);
    CHECK(explain.seconds == 2.0);
    CHECK(explain.hands == Strings{"h.lua"});
    CHECK_FALSE(read("explain gravity").analyze);

    CHECK(read("run gravity").listen == ListenMode::hold);
    CHECK(read("run gravity --listen hold").listen == ListenMode::hold);
    CHECK(read("run gravity --listen always").listen == ListenMode::always);
    CHECK(read("menu --speech sphinx --listen always").listen == ListenMode::always);

    CHECK_FALSE(read("run gravity").sureness);
    CHECK(read("run gravity --speech sphinx --sure 0.7").sureness == 0.7);
    CHECK(read("menu --speech sphinx --sure 0").sureness == 0.0);
    check_says(usage(), {"--sure N"});

    CHECK(read("run gravity").partner.kind == PartnerKind::shipped);
    CHECK_FALSE(read("run gravity").partner.is_given);
    CHECK(read("run gravity --dialogue shipped").partner.is_given);
    CHECK(read("menu --dialogue none").partner.kind == PartnerKind::none);
    const Options talking = read("explain gravity --dialogue exec:talk");
    CHECK(talking.partner.kind == PartnerKind::external);
    CHECK(talking.partner.words == std::vector<std::string>{"/bin/sh", "-c", "talk"});
    check_says(usage(), {"--dialogue shipped|none|exec:COMMAND"});

    CHECK_FALSE(read("test gravity").by);
    CHECK(read("test gravity --by arm").by == PlayedBy::arm);
    CHECK(read("test gravity --by mouse").by == PlayedBy::mouse);
    CHECK(read("run gravity --headless --by keyboard").by == PlayedBy::keyboard);

    const Options force = read("explain --force 12.5 a.rec --json");
    CHECK((force.lesson == "a.rec" && force.force_at_s == 12.5 && force.json));
    const Options table = read("export a.rec --out b.csv");
    CHECK((table.command == Command::export_record && table.out == "b.csv"));

    const Options school = read("class new 4b Mina Tim --names a.txt --class 5a --db x.db");
    CHECK(school.command == Command::school_class);
    CHECK(school.words == Strings{"new", "4b", "Mina", "Tim"});
    CHECK((school.names_file == "a.txt" && school.class_name == "5a" && school.database == "x.db"));
    CHECK(read("menu --class 5a").class_name == "5a");
    CHECK(read("report --guests").each_guest);
    CHECK_FALSE(read("report").each_guest);

    CHECK_FALSE(read("stop").only_process);
    CHECK(read("stop --only 1234").only_process == 1234);
}

TEST_CASE("options: what cannot be is refused, where it can with what is meant or possible") {
    hold_tables(FULCRUM_SOURCE_DIR "/tests/unit/runtime/app", [] {
        TableReader reader;
        reader.probes["refused"] = [](const std::string&, const std::string& line) {
            return refusal_of(parse(line));
        };
        return reader;
    });
    // A guess that would puzzle is not made.
    for (const char* line : {"xylophone", "run gravity --zzzz x"}) {
        const std::string refusal = refusal_of(parse(line));
        CHECK(refusal != "");
        check_lacks(refusal, {"did you mean"});
    }
}

TEST_CASE("options: help is given wherever it is asked for") {
    for (const char* line :
         {"--help", "-h", "run --help", "run gravity --help", "list -h", "check gravity --help"}) {
        CHECK(read(line).command == Command::help);
    }
}

TEST_CASE("options: how the hand is set is said in words, each hand's behind its --hand") {
    CHECK(words_of(read("run gravity --scale 2 --axes -x,y,z --middle 0,0.1,0 --clutch none "
                        "--handed left")
                       .fit) == Fit{{"scale", "2"},
                                    {"axes", "-x,y,z"},
                                    {"middle", "0,0.1,0"},
                                    {"clutch", "none"},
                                    {"handed", "left"}});
    CHECK(words_of(read("run gravity").fit).empty());
    // Which hand a person uses is one thing for all of them.
    const Options both =
        read("run x --scale 2 --hand udp:a:1 --axes y,x,z --hand udp:b:1 --scale 3 --handed left");
    CHECK(words_of(both.fit) == Fit{{"scale", "2"}, {"axes", "y,x,z"}, {"handed", "left"}});
    REQUIRE(both.more_fits.size() == 1);
    CHECK(words_of(both.more_fits[0]) == Fit{{"scale", "3"}});
    CHECK(read("run gravity").first_use == FirstUseTrial::once);
    CHECK(read("run gravity --first-use again").first_use == FirstUseTrial::again);
    CHECK(read("run gravity --first-use never").first_use == FirstUseTrial::never);
}

TEST_CASE("options: each arm has a key of its own, what stands behind its --hand") {
    const struct {
        const char *line, *first;
        Strings more;
    } rows[] = {
        {"run x --hand udp:a:1 --key a.key --hand udp:b:2 --key b.key", "a.key", {"b.key"}},
        {"run x --hand udp:a:1 --hand udp:b:2 --key b.key", "", {"b.key"}},
        {"run x --key a.key --hand udp:a:1 --hand udp:b:2", "a.key", {}},
    };
    for (const auto& row : rows) {
        INFO(row.line);
        CHECK(read(row.line).arm.key_file == row.first);
        CHECK(read(row.line).more_keys == row.more);
    }
}

namespace {

// A command line of that command with this option, as far as it needs words beside it.
std::string line_with(const CommandRow& command, const OptionRow& option,
                      const std::string& value) {
    return spaced(Strings{std::string(command.word), command.takes.empty() ? "" : "x",
                          std::string(option.name), value});
}

// Its words with one blank between them, as the help may break them otherwise.
std::string unbroken(const std::string& text) {
    std::istringstream stream(text);
    Strings words;
    for (std::string word; stream >> word;) {
        words.push_back(word);
    }
    return ' ' + spaced(words) + ' ';
}

std::string help_of(const OptionRow& option) {
    return unbroken(spaced(
        Strings{std::string(option.name), std::string(option.value), std::string(option.text)}));
}

std::size_t count_of(const std::string& part, const std::string& text) {
    std::size_t count = 0;
    for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) {
        ++count;
    }
    return count;
}

// A value that it takes, beside its numbers.
std::string good_value(const OptionRow& option) {
    const std::map<std::string_view, std::string> others{{"--axes", "-x,y,z"},
                                                         {"--middle", "0,0.1,0"},
                                                         {"--centre", "0,0.1,0"},
                                                         {"--feedback", "recast,rule"}};
    const auto other = others.find(option.name);
    return option.low < option.high ? number_text(option.low)
           : other != others.end()  ? other->second
           : option.value.find('|') < option.value.size()
               ? std::string(option.value.substr(0, option.value.find('|')))
               : std::string(option.value);
}

}  // namespace

TEST_CASE("options: every row of the table is taken, refused and explained as it says") {
    const std::string all = unbroken(usage());
    for (const CommandRow& command : command_rows()) {
        if (command.text.empty() || command.command == Command::bench) {
            continue;
        }
        const std::string own = unbroken(usage(command.word));
        check_says(own, {unbroken(std::string(command.text))});
        for (const OptionRow& option : option_rows()) {
            INFO(command.word << ' ' << option.name);
            const auto taken = [&](const std::string& value) {
                return parse(line_with(command, option, value)).has_value();
            };
            CHECK(taken(good_value(option)) == option.is_of(command.command));
            CHECK(count_of(help_of(option), own) == (option.is_of(command.command) ? 1 : 0));
            CHECK(count_of(help_of(option), all) == 1);
            if (!option.is_of(command.command) || !(option.low < option.high)) {
                continue;
            }
            check_says(own, {number_text(option.low) + " to " + number_text(option.high) + ']'});
            constexpr double kBeyond = 0.001;
            CHECK(taken(number_text(option.high)));
            CHECK_FALSE(taken(number_text(option.low - kBeyond)));
            CHECK_FALSE(taken(number_text(option.high + kBeyond)));
        }
    }
}

TEST_CASE("options: each choice that the help names is taken, as itself, and no other word") {
    const auto chosen = [](const std::string& line) {
        const Options o = read(line);
        return std::tuple(o.first_use, o.by, o.listen, o.format, o.arm.kind, o.arm.motion,
                          o.voice.value_or(VoiceKind::flite), o.picture, o.fit.left_handed,
                          o.language);
    };
    for (const OptionRow& option : option_rows()) {
        const std::string value(option.value);
        if (value.find('|') == std::string::npos ||
            value.find_first_of("N:") != std::string::npos) {
            continue;
        }
        const auto command = std::ranges::find_if(
            command_rows(), [&](const CommandRow& row) { return option.is_of(row.command); });
        std::vector<decltype(chosen(""))> seen;
        for (const std::string& word : listed(value, "|")) {
            const auto now = chosen(line_with(*command, option, word));
            CHECK(std::ranges::find(seen, now) == seen.end());
            seen.push_back(now);
        }
        CHECK(seen.size() > 1);
        CHECK_FALSE(parse(line_with(*command, option, "other")));
    }
    CHECK(read("arm --arm desktop --motion circle").arm.kind == ArmKind::desktop);
    CHECK(read("arm --arm desktop --motion circle").arm.motion ==
          fulcrum::runtime::ArmMotion::circle);
    // Per cent and milliseconds, as people say them; kept as parts and seconds.
    const LinkFaults faults = read("arm --loss 25 --delay 40 --burst 3 --seed 9").arm.faults;
    CHECK((faults.loss == 0.25 && faults.delay_s == 0.001 * 40.0));
    CHECK((faults.burst == 3 && faults.seed == 9));
}
