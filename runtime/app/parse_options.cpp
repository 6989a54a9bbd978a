#include "runtime/app/parse_options.h"

#include "runtime/app/options_parts.h"
#include "runtime/lesson/learner_feedback.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <numeric>
#include <vector>

namespace fulcrum::runtime {
namespace {

struct CommandWord {
    std::string_view word;
    Command command;
    bool takes_lesson;
    std::string_view flags;  // the flags it understands, each between spaces
};

constexpr std::array<CommandWord, 16> kCommands{{
    {"run", Command::run, true,
     " --headless --seconds --seed --errors --hand --by --say --learner --db --record --screenshot "
     "--screenshot-at --speech --hear --listen --sure --throat --voice "
     "--voice-speed --watch --mute --force-limit --feedback --key --scale --axes --middle --clutch "
     "--handed --first-use --real-time "},
    {"list", Command::list, false, " "},
    {"check", Command::check, true, " --force-limit --quick --again "},
    {"test", Command::test, true, " --force-limit --seed --errors --hand --by "},
    {"explain", Command::explain, true,
     " --mute --headless --speech --hear --listen --record --force-limit --analyze --json --hand "
     "--say --seconds --force "},
    {"export", Command::export_record, true, " --out "},
    {"report", Command::report, false, " --learner --lesson --db --format --out "},
    {"devices", Command::devices, false, " --json "},
    {"arm", Command::arm, false,
     " --force-limit --arm --port --address --key --rate --motion --loss --burst --delay --jitter "
     "--reorder "
     "--duplicate --corrupt --seed --seconds "},
    {"stop", Command::stop, false, " --only "},
    {"soak", Command::soak, false, " --lesson --seed --seeds --seconds --force-limit "},
    {"help", Command::help, false, " "},
    {"--help", Command::help, false, " "},
    {"-h", Command::help, false, " "},
    {"--version", Command::version, false, " "},
    {"menu", Command::menu, false,
     " --learner --db --force-limit --feedback --mute --speech --listen --sure --throat --voice "
     "--voice-speed "
     "--watch --handed "},
}};

Expected<void> set_speech(Options& options, const std::string& value) {
    constexpr std::string_view kExec = "exec:";
    if (value.starts_with(kExec) && value.size() > kExec.size()) {
        options.speech = SpeechInput::external;
        options.hearing = value.substr(kExec.size());
        return {};
    }
    for (const SpeechInput input : {SpeechInput::text, SpeechInput::sphinx}) {
        if (name_of(input) == value) {
            options.speech = input;
            return {};
        }
    }
    return fail("--speech " + value + " is not known", "", "use text, sphinx or exec:COMMAND");
}

// "recast,prompt,rule", or "lesson", as that says.
Expected<void> set_feedback(Options& options, const std::string& value) {
    options.feedback.emplace();
    if (value == kAsLessonSays) {
        return {};
    }
    auto ladder = dialogue::read_ladder_text(value);
    if (!ladder) {
        return fail("--feedback " + value + ": " + ladder.error().message, "",
                    "write for instance --feedback recast,prompt,rule, or --feedback lesson");
    }
    options.feedback = std::move(*ladder);
    return {};
}

// What is a number; nothing for a flag of others.
std::optional<Expected<void>> set_number(Options& options, const std::string& flag,
                                         const std::string& value) {
    struct Number {
        std::string_view flag;
        double low, high;
        void (*set)(Options&, double);
    };
    constexpr double kDay_s = 86400.0;
    constexpr double kMostSeed = 4294967295.0;
    static constexpr std::array<Number, 9> kNumbers{{
        {"--seconds", 0.0, kDay_s, [](Options& o, double x) { o.seconds = x; }},
        {"--force", 0.0, kDay_s, [](Options& o, double x) { o.force_at_s = x; }},
        {"--errors", 0.0, 0.9, [](Options& o, double x) { o.errors = x; }},
        {"--sure", 0.0, 1.0, [](Options& o, double x) { o.sureness = x; }},
        {"--throat", 1.0, 2.0, [](Options& o, double x) { o.throat = x; }},
        {"--screenshot-at", 0.0, kDay_s, [](Options& o, double x) { o.screenshot_at_s = x; }},
        {"--force-limit", 0.5, 10.0, [](Options& o, double x) { o.force_limit_N = x; }},
        {"--voice-speed", kSlowestVoice, kFastestVoice,
         [](Options& o, double x) { o.voice.speed = x; }},
        {"--seed", 0.0, kMostSeed,
         [](Options& o, double x) {
             o.seed = static_cast<std::uint64_t>(x);
             o.arm.faults.seed = *o.seed;
         }},
    }};
    const auto number = std::find_if(kNumbers.begin(), kNumbers.end(),
                                     [&](const Number& n) { return n.flag == flag; });
    if (number == kNumbers.end()) {
        return std::nullopt;
    }
    return number_in(flag, value, number->low, number->high).map([&](double x) {
        number->set(options, x);
    });
}

Expected<void> set_voice(Options& options, const std::string& value) {
    return find_voice(value).map([&](VoiceKind voice) { options.voice.kind = voice; });
}

Expected<void> set_player(Options& options, const std::string& value) {
    const auto by =
        std::ranges::find(kAllPlayers, value, [](PlayedBy player) { return name_of(player); });
    if (by == kAllPlayers.end()) {
        return fail("--by " + value + " is not known", "", "use arm, mouse or keyboard");
    }
    options.by = *by;
    return {};
}

Expected<void> set_listening(Options& options, const std::string& value) {
    if (value != "hold" && value != "always") {
        return fail("--listen " + value + " is not known", "", "use hold or always");
    }
    options.listen = value == "always" ? ListenMode::always : ListenMode::hold;
    return {};
}

Expected<void> set_format(Options& options, const std::string& value) {
    if (value != "text" && value != "csv") {
        return fail("--format " + value + " is not known", "", "use text or csv");
    }
    options.format = value;
    return {};
}

// What is one of a few words; nothing for a flag of others.
std::optional<Expected<void>> set_choice(Options& options, const std::string& flag,
                                         const std::string& value) {
    struct Choice {
        std::string_view flag;
        Expected<void> (*set)(Options&, const std::string&);
    };
    static constexpr std::array<Choice, 6> kChoices{{{"--voice", set_voice},
                                                     {"--speech", set_speech},
                                                     {"--feedback", set_feedback},
                                                     {"--by", set_player},
                                                     {"--listen", set_listening},
                                                     {"--format", set_format}}};
    const auto choice = std::find_if(kChoices.begin(), kChoices.end(),
                                     [&](const Choice& c) { return c.flag == flag; });
    return choice == kChoices.end() ? std::nullopt : std::optional(choice->set(options, value));
}

// Each flag that takes a value, and where the value goes.
Expected<void> set_value(Options& options, const std::string& flag, const std::string& value) {
    for (const auto set : {set_arm_value, set_fit_value, set_number, set_choice}) {
        if (auto done = set(options, flag, value)) {
            return *done;
        }
    }
    struct Target {
        std::string_view flag;
        std::string Options::*member;
    };
    static constexpr std::array<Target, 8> kTargets{{{"--hear", &Options::hear},
                                                     {"--say", &Options::say},
                                                     {"--learner", &Options::learner},
                                                     {"--db", &Options::database},
                                                     {"--record", &Options::record},
                                                     {"--screenshot", &Options::screenshot},
                                                     {"--lesson", &Options::lesson},
                                                     {"--out", &Options::out}}};
    const auto target = std::find_if(kTargets.begin(), kTargets.end(),
                                     [&](const Target& t) { return t.flag == flag; });
    if (flag == "--hand") {  // one a hand
        options.hands.push_back(value);
    } else {
        options.*(target->member) = value;
    }
    return {};
}

bool takes_value(std::string_view flag) {
    return flag != "--headless" && flag != "--watch" && flag != "--mute" && flag != "--analyze" &&
           flag != "--json" && flag != "--quick" && flag != "--again" && flag != "--real-time";
}

void set_switch(Options& options, std::string_view flag) {
    options.headless |= flag == "--headless";
    options.watch |= flag == "--watch";
    options.mute |= flag == "--mute";
    options.analyze |= flag == "--analyze";
    options.json |= flag == "--json";
    options.quick |= flag == "--quick";
    options.again |= flag == "--again";
    options.real_time |= flag == "--real-time";
}

std::string nearest(const std::string& word, const std::vector<std::string>& known) {
    const auto best =
        std::min_element(known.begin(), known.end(), [&](const auto& a, const auto& b) {
            return edit_distance(word, a) < edit_distance(word, b);
        });
    // A third of the letters may be wrong; a guess that is further off would puzzle more than help.
    const int most = std::clamp(static_cast<int>(word.size()) / 3, 2, 3);
    return best != known.end() && edit_distance(word, *best) <= most ? *best : std::string{};
}

tl::unexpected<Error> unknown(const std::string& what, const std::string& word,
                              const std::vector<std::string>& known) {
    const std::string guess = nearest(word, known);
    return fail(
        what + " \"" + word + "\" is not known", "",
        guess.empty() ? "see fulcrum help" : "did you mean " + guess + "?  See fulcrum help");
}

const CommandWord* find_command(std::string_view word) {
    const auto found = std::find_if(kCommands.begin(), kCommands.end(),
                                    [&](const CommandWord& c) { return c.word == word; });
    return found == kCommands.end() ? nullptr : &*found;
}

std::vector<std::string> command_words() {
    std::vector<std::string> words;
    words.reserve(kCommands.size());
    for (const CommandWord& command : kCommands) {
        words.emplace_back(command.word);
    }
    return words;
}

std::vector<std::string> flags_of(const CommandWord& command) {
    std::vector<std::string> flags;
    std::size_t start = command.flags.find("--");
    while (start != std::string_view::npos) {
        const std::size_t end = command.flags.find(' ', start);
        flags.emplace_back(command.flags.substr(start, end - start));
        start = command.flags.find("--", end);
    }
    return flags;
}

// The one word that is no option.
Expected<void> set_lesson(Options& options, const CommandWord& command, const std::string& word) {
    if (command.command == Command::help && find_command(word) != nullptr) {
        options.help_for = word;
        return {};
    }
    if (!command.takes_lesson || !options.lesson.empty()) {
        return fail("\"" + word + "\" is one word too many", "", "see fulcrum help");
    }
    options.lesson = word;
    return {};
}

// The word at `i`, and its value where it has one.
Expected<void> take_word(Options& options, const CommandWord& command,
                         std::span<const std::string> words, std::size_t& i) {
    const std::string& word = words[i];
    if (!word.starts_with("--")) {
        return set_lesson(options, command, word);
    }
    if (command.flags.find(" " + word + " ") == std::string_view::npos) {
        return unknown("for " + std::string(command.word) + ", the option", word,
                       flags_of(command));
    }
    if (!takes_value(word)) {
        set_switch(options, word);
        return {};
    }
    if (i + 1 == words.size()) {
        return fail(word + " needs a value", "", "see fulcrum help");
    }
    return set_value(options, word, words[++i]);
}

}  // namespace

int edit_distance(std::string_view a, std::string_view b) {
    std::vector<int> row(b.size() + 1);
    std::iota(row.begin(), row.end(), 0);
    for (std::size_t i = 0; i < a.size(); ++i) {
        int diagonal = row[0];
        row[0] = static_cast<int>(i) + 1;
        for (std::size_t j = 0; j < b.size(); ++j) {
            const int substituted = diagonal + (a[i] == b[j] ? 0 : 1);
            diagonal = row[j + 1];
            row[j + 1] = std::min({substituted, row[j] + 1, row[j + 1] + 1});
        }
    }
    return row.back();
}

Expected<Options> parse_options(std::span<const std::string> words) {
    Options options;
    if (words.empty()) {
        return options;
    }
    // Options alone are those of the list of lessons.
    const bool only_options = words[0].starts_with("--") && find_command(words[0]) == nullptr;
    const CommandWord* const command = find_command(only_options ? "menu" : words[0]);
    if (command == nullptr) {
        return unknown("the command", words[0], command_words());
    }
    options.command = command->command;
    for (std::size_t i = only_options ? 0 : 1; i < words.size(); ++i) {
        if (words[i] == "--help" || words[i] == "-h") {
            options.command = Command::help;
            options.help_for = words[0];
            return options;
        }
        if (auto taken = take_word(options, *command, words, i); !taken) {
            return tl::unexpected(taken.error());
        }
    }
    if (command->takes_lesson && options.lesson.empty()) {
        return command->command == Command::export_record || options.force_at_s
                   ? fail(words[0] + " needs a record", "", "name a file that --record wrote")
                   : fail(words[0] + " needs a lesson", "", "name one; fulcrum list shows them");
    }
    return options;
}

}  // namespace fulcrum::runtime
