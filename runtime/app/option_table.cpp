#include "runtime/app/option_table.h"

#include "dialogue/result.h"
#include "haptics/device/mouse/pointer_device.h"
#include "runtime/arms/dhd/dhd_port.h"
#include "runtime/files/line_program.h"
#include "runtime/lesson/learner_feedback.h"
#include "runtime/scene/lesson_limits.h"

#include <algorithm>
#include <charconv>
#include <type_traits>

namespace fulcrum::runtime {
namespace {

using dialogue::concat;

constexpr double kDay_s = 86400.0;
constexpr double kMostProcess = 4194304.0;  // PID_MAX_LIMIT, proc(5)
constexpr double kMostSeed = 4294967295.0;
constexpr double kPercent = 0.01;
constexpr double kMilli = 0.001;

tl::unexpected<Error> refuse(const OptionRow& row, const std::string& value,
                             const std::string& to_do) {
    return fail(concat({row.name, " ", value, " is not known"}), "", to_do);
}

Expected<double> read_number(const OptionRow& row, const std::string& value) {
    double number = 0.0;
    const char* const end = value.data() + value.size();
    const auto parsed = std::from_chars(value.data(), end, number);
    if (parsed.ec != std::errc{} || parsed.ptr != end ||
        !(number >= row.low && number <= row.high)) {
        return fail(
            concat({row.name, " is \"", value, "\""}), "",
            concat({"give a number from ", number_text(row.low), " to ", number_text(row.high)}));
    }
    return number;
}

// Which of the row's words the value is.
Expected<std::size_t> read_choice(const OptionRow& row, const std::string& value) {
    std::string use = "use ";
    std::size_t place = 0;
    for (std::size_t begin = 0; begin < row.value.size(); ++place) {
        const std::size_t end = std::min(row.value.find('|', begin), row.value.size());
        const std::string_view word = row.value.substr(begin, end - begin);
        if (word == value) {
            return place;
        }
        use += concat({begin == 0 ? "" : end == row.value.size() ? " or " : ", ", word});
        begin = end + 1;
    }
    return refuse(row, value, use);
}

template <class T>
T inside(const T&);
template <class T>
T inside(const std::optional<T>&);

// A switch, a text, a choice, whose values stand in the order of the words, or a number, in the member's unit, into a member of a member.
template <auto... kMembers>
Expected<void> put(Options& options, const OptionRow& row, const std::string& value) {
    auto& place = (options.*....*kMembers);
    using Value = decltype(inside(place));
    if constexpr (std::is_same_v<Value, bool>) {
        place = true;
    } else if constexpr (std::is_same_v<Value, std::string>) {
        place = value;
    } else if constexpr (std::is_enum_v<Value>) {
        return read_choice(row, value).map([&](std::size_t i) { place = static_cast<Value>(i); });
    } else {
        const double unit = row.value == "P" ? kPercent : row.value == "MS" ? kMilli : 1.0;
        return read_number(row, value).map([&](double x) { place = static_cast<Value>(unit * x); });
    }
    return {};
}

constexpr auto kArm = &Options::arm;
constexpr auto kFaults = &ArmOptions::faults;

Expected<void> set_seed(Options& options, const OptionRow& row, const std::string& value) {
    return put<&Options::seed>(options, row, value).map([&] {
        options.arm.faults.seed = *options.seed;
    });
}

Expected<void> set_process(Options& options, const OptionRow& row, const std::string& value) {
    return read_number(row, value).and_then([&](double id) -> Expected<void> {
        options.only_process = static_cast<int>(id);
        // A part of a number would be another process.
        return *options.only_process == id
                   ? Expected<void>{}
                   : fail(concat({row.name, " is \"", value, "\""}), "", "give a process's number");
    });
}

Expected<void> set_format(Options& options, const OptionRow& row, const std::string& value) {
    return read_choice(row, value).map([&](std::size_t) { options.format = value; });
}

// What stands behind "exec:"; empty where the value is none such.
std::string command_in(const std::string& value) {
    constexpr std::string_view kExec = "exec:";
    return value.starts_with(kExec) ? value.substr(kExec.size()) : std::string();
}

Expected<void> set_speech(Options& options, const OptionRow& row, const std::string& value) {
    if (std::string command = command_in(value); !command.empty()) {
        options.speech = SpeechInput::external;
        options.hearing = std::move(command);
        return {};
    }
    for (const SpeechInput input : {SpeechInput::text, SpeechInput::sphinx}) {
        if (name_of(input) == value) {
            options.speech = input;
            return {};
        }
    }
    return refuse(row, value, "use text, sphinx or exec:COMMAND");
}

Expected<void> set_dialogue(Options& options, const OptionRow& row, const std::string& value) {
    PartnerOrder& partner = options.partner;
    partner = {.is_given = true};
    if (const std::string command = command_in(value); !command.empty()) {
        partner.kind = PartnerKind::external;
        partner.words = shell_line(command);
    } else if (value == name_of(PartnerKind::none)) {
        partner.kind = PartnerKind::none;
    } else if (value != name_of(PartnerKind::shipped)) {
        return refuse(row, value, "use shipped, none or exec:COMMAND");
    }
    return {};
}

// "recast,prompt,rule", or "lesson", as that says.
Expected<void> set_feedback(Options& options, const OptionRow& row, const std::string& value) {
    options.feedback.emplace();
    if (value == kAsLessonSays) {
        return {};
    }
    auto ladder = dialogue::read_ladder_text(value);
    if (!ladder) {
        return fail(concat({row.name, " ", value, ": ", ladder.error().message}), "",
                    "write for instance --feedback recast,prompt,rule, or --feedback lesson");
    }
    options.feedback = std::move(*ladder);
    return {};
}

Expected<void> set_picture(Options& options, const OptionRow& row, const std::string& value) {
    return read_choice(row, value).map([&](std::size_t i) {
        options.picture = i == 0 ? std::nullopt : std::optional(static_cast<PictureLevel>(i - 1));
    });
}

Expected<void> set_voice(Options& options, const OptionRow&, const std::string& value) {
    return find_voice(value).map([&](VoiceKind voice) { options.voice = voice; });
}

Expected<void> add_hand(Options& options, const OptionRow&, const std::string& value) {
    options.hands.push_back(value);
    return {};
}

// Of the hand whose --hand stands before it, else of the first.
template <class T>
T& of_hand(const Options& options, T& first, std::vector<T>& more) {
    if (options.hands.size() < 2) {
        return first;
    }
    more.resize(options.hands.size() - 1);
    return more.back();
}

Expected<void> set_key(Options& options, const OptionRow&, const std::string& value) {
    of_hand(options, options.arm.key_file, options.more_keys) = value;
    return {};
}

// Which hand a person writes with is one thing for all.
Expected<void> set_hand_fit(Options& options, const OptionRow& row, const std::string& value) {
    const std::string_view name = row.name.substr(2);
    return set_fit(
        name == "handed" ? options.fit : of_hand(options, options.fit, options.more_fits), name,
        value);
}

Expected<void> set_centre(Options& options, const OptionRow&, const std::string& value) {
    HandFit fit;
    return set_fit(fit, "middle", value).map([&] { options.arm.centre_A = fit.middle_A; });
}

constexpr std::uint32_t of(auto... commands) {
    return ((1U << static_cast<unsigned>(commands)) | ...);
}

}  // namespace

// A row a line, and its text below where that is long.
// clang-format off
std::span<const CommandRow> command_rows() {
    using enum Command;
    static constexpr CommandRow kRows[] = {
        {"run", run, "LESSON", "play a lesson"},
        {"room", room, "", "the science room, in a window, from which the lessons are entered; what fulcrum without a command is"},
        {"menu", menu, "", "the list of lessons, in a window"},
        {"list", list, "", "the lessons"},
        {"check", check, "LESSON", "look for mistakes, also in what is only called in a play"},
        {"test", test, "LESSON", "play the lesson's own tests, by arm, by mouse and by keyboard"},
        {"explain", explain, "LESSON", "what runs for it, how often, and which line asked for it"},
        {"export", export_record, "FILE.rec", "a record as CSV: rounds, and beside them .events, .bodies and .facts"},
        {"report", report, "", "what learners did"},
        {"class", school_class, "DO ...",
         R"(who is asked "Who are you?" before the list of lessons, by pictures. new CLASS NAME...: makes a class. add NAME...: more pupils.
         list: each pupil's card and secret picture. picture NAME: another secret picture, or with three pictures behind it those.
         show-as names: cards with names, which nobody need know a picture for; show-as pictures)"},
        {"devices", devices, "", "what can be a hand here, what each can do, what is missing"},
        {"arm", arm, "", "a simulated arm that speaks the arm link, for --hand udp:localhost:4701"},
        {"stop", stop, "", "emergency stop: every hand and arm of yours on this computer fades to no force"},
        {"soak", soak, "", "all lessons with an arm on which things break by chance, under a virtual clock: is every force as it may be?"},
        {"bench", bench, "[NAME...]", "what accuracy costs in time (--out DIR --quick --list --draw FILE.csv); fulcrum bench --help says more"},
        {"help", help, "", "this; fulcrum help COMMAND or fulcrum COMMAND --help: all of that command"},
        {"--help", help, "", ""},
        {"-h", help, "", ""},
        {"--version", version, "", "which Fulcrum this is"},
    };
    return kRows;
}

std::span<const OptionRow> option_rows() {
    using enum Command;
    static constexpr OptionRow kRows[] = {
        {"--headless", "", of(run, explain), put<&Options::headless>,
         "without a window, faster than real time, repeatable to the byte; tells what is said"},
        {"--real-time", "", of(run), put<&Options::real_time>, "with --headless: as fast as it is"},
        {"--hand", "FILE.lua|mouse|keys|hid|hid:PATH|haply|touch|fd|simulated|udp:HOST:PORT|wam:HOST|replay:FILE|none", of(run, test, explain), add_hand,
         R"(what moves the hand, once a hand (by what is there). haply, touch: those arms. fd: Force Dimension's arm, or the Falcon. simulated: one of our own. udp, wam: an arm on
         another computer, or fulcrum arm on this one; wam waits at port 4701. replay: a run
         that --record wrote, with its keys, answers and seed; --headless says whether every force is the same to the bit, and if not, where
         first and why. A test takes a FILE.lua)"},
        {"--key", "FILE", of(run, arm), set_key, "what an arm on the network shares with the program; behind a second --hand that arm's"},
        {"--handed", "left|right", of(run, room, menu), set_hand_fit,
         "for a left hand the arm's first two buttons change places, and I J K L move the pointer; kept with the learner"},
        {"--scale", "N", of(run), set_hand_fit,
         R"(how the arm stands before the learner: times the lesson's scale. --scale, --axes, --middle and --clutch are kept with the
         learner and the arm; behind a second --hand they are of that one)", kLeastFitScale, kMostFitScale},
        {"--axes", "-x,y,z", of(run), set_hand_fit, "which of its axes are right, up and near"},
        {"--middle", "X,Y,Z", of(run), set_hand_fit, "the place, in metres, that is the middle"},
        {"--clutch", "N|none", of(run), set_hand_fit,
         "the button that holds the scene still while the arm moves on (3)", 1.0, kMostClutchButton},
        {"--yield", "N", of(run, room, menu, test), put<&Options::yield>,
         R"(how strongly a hand that a mouse or keys move gives way to what pushes it and comes late, so that force is seen: times what ships;
         0: it is where the mouse is)", 0.0, kMostYield},
        {"--first-use", "once|again|never", of(run), put<&Options::first_use>,
         R"(whether an arm or a joystick pushes gently first and asks which way (once for each learner and device): one that is wired or stands
         wrongly gives no force, and none later with never)"},
        {"--by", "arm|mouse|keyboard|touch|clumsy|idle", of(run, test), put<&Options::by>,
         R"(how the simulated hand plays, by an arm or as somebody at a desk (arm; a test: by the first three); touch: a finger on a screen; clumsy: a mouse
         that comes late, trembles, strays and slips, and answers are clicked by chance; idle: nothing is moved; these must come to the end)"},
        {"--deeds", "PIPE", of(run), put<&Options::deeds>,
         R"(with --by in a window: what that player would do is written there, line by line, as xdotool reads it, and only what comes back from
         the screen counts; the window's upper left corner is the screen's)"},
        {"--say", "FILE", of(run, explain), put<&Options::say>,
         R"(what a pupil says, a line each time it is the pupil's turn: an answer to the question that is open; a line that begins with ? is
         asked instead, between questions too ("?What is this?"); # begins a remark)"},
        {"--errors", "N", of(run, test), put<&Options::errors>,
         R"(a simulated learner answers, who knows what is right and errs in so many parts of the answers: half of that in form, a third in
         meaning, else unclear; the lesson must come to its end)", 0.0, 0.9},
        {"--learner", "NAME", of(run, room, menu, report), put<&Options::learner>, "whose progress this is"},
        {"--class", "CLASS", of(school_class, room, menu), put<&Options::class_name>, "this one of several classes"},
        {"--names", "FILE", of(school_class), put<&Options::names_file>, "new, add: the names in a text file, one a line; -: in what is piped to it"},
        {"--guests", "", of(report), put<&Options::each_guest>, "each guest by itself, instead of all as one"},
        {"--db", "FILE", of(run, room, menu, report, school_class), put<&Options::database>, "where progress is kept"},
        {"--record", "FILE", of(run, explain), put<&Options::record>, "write poses, forces and events"},
        {"--screenshot", "FILE", of(run), put<&Options::screenshot>, "write the picture when the run ends"},
        {"--screenshot-at", "S", of(run), put<&Options::screenshot_at_s>, "or at that second", 0.0, kDay_s},
        {"--seconds", "N", of(run, explain, arm, soak), put<&Options::seconds>, "end early; soak: how long each run is (60)", 0.0, kDay_s},
        {"--seed", "N", of(run, test, arm, soak), set_seed,
         "what is left to chance goes as it went with this number; without a window 1; soak: the first of them (1)", 0.0, kMostSeed},
        {"--force-limit", "N", of(run, room, menu, check, test, explain, arm, soak), put<&Options::force_limit_N>,
         "newtons at most (5); never more than /etc/fulcrum/site.conf allows", kLeastForceLimit_N, kMostForceLimit_N},
        {"--feedback", "STEP,STEP", of(run, room, menu), set_feedback,
         R"(what is done about an error of form the first time, the second …: recast, prompt, rule, replay (as the lesson says, else
         recast,prompt,rule); kept with a --learner until another is given, or lesson)"},
        {"--language", "en|es|ko", of(run, room, menu), put<&Options::language>,
         R"(of buttons, help and settings in the window; the lesson stays English (as was chosen in the settings, else the system's where it is one of
         these))"},
        {"--mute", "", of(run, room, menu, explain), put<&Options::mute>, "without sound"},
        {"--picture", "auto|best|good|fair|fast", of(run, room, menu), set_picture,
         R"(how finely the scene is drawn in a window: as finely as 30 pictures a second allow (auto); edges smoothed (best) or not (good); with
         half (fair) or a quarter (fast) of the dots; words are always fine)"},
        {"--watch", "", of(run, room, menu), put<&Options::watch>, "runs again whenever a file of the lesson is saved, not only after a mistake"},
        {"--dialogue", "shipped|none|exec:COMMAND", of(run, room, menu, explain), set_dialogue,
         R"(who chooses the words that are said back: the program itself (shipped); nobody; a program of your own, which marks nothing
         (dialogue/README.md))"},
        {"--speech", "text|sphinx|exec:COMMAND", of(run, room, menu, explain), set_speech,
         R"(how answers come beside typing: not at all (text); spoken, heard by PocketSphinx; heard by a program of your own
         (dialogue/README.md))"},
        {"--hear", "FILE", of(run, explain), put<&Options::hear>,
         "one recording (WAV) a line, heard for the questions in turn instead of a microphone"},
        {"--listen", "hold|always", of(run, room, menu, explain), put<&Options::listen>,
         "when the microphone is heard: while Control is held, or whenever somebody speaks (hold)"},
        {"--sure", "N", of(run, room, menu), put<&Options::sureness>,
         "with --speech: what is heard less surely is asked for again (as the lesson says, else 0.4)", 0.0, 1.0},
        {"--throat", "N", of(run, room, menu), put<&Options::throat>,
         R"(with --speech sphinx: how much smaller than a grown-up's the pupil's throat is (as it was heard the last time, kept with the
         pupil's progress))", 1.0, 2.0},
        {"--voice", "flite|espeak-ng|none", of(run, room, menu), set_voice, "who says aloud what stands there (as was chosen in the settings, else flite)"},
        {"--voice-speed", "N", of(run, room, menu), put<&Options::voice_speed>,
         "1 is as a teacher speaks (as was chosen in the settings, else 0.9)", kSlowestVoice, kFastestVoice},
        {"--quick", "", of(check), put<&Options::quick>, "without playing it"},
        {"--again", "", of(check), put<&Options::again>, "also where nothing has changed since the last time, which is told again otherwise"},
        {"--analyze", "", of(explain), put<&Options::analyze>,
         "plays it without a window and says what each stage cost; --hand, --say and --seconds are for that"},
        {"--force", "T", of(explain), put<&Options::force_at_s>,
         R"(fulcrum explain --force T FILE.rec: why the hand felt that force at T seconds of a record: each effect's share, limits, gate)",
         0.0, kDay_s},
        {"--json", "", of(explain, devices), put<&Options::json>, "for programs"},
        {"--lesson", "NAME", of(report, soak), put<&Options::lesson>, "that one alone"},
        {"--format", "text|csv", of(report), set_format, "as what (text)"},
        {"--out", "FILE", of(export_record, report), put<&Options::out>,
         "report: where to, instead of the screen; export: the table's name, FILE.csv"},
        {"--port", "N", of(arm), put<kArm, &ArmOptions::port>, "where it waits (4701); 0: at any port that is free", 0.0, 65535.0},
        {"--address", "A", of(arm), put<kArm, &ArmOptions::address>, "likewise (127.0.0.1)"},
        {"--rate", "N", of(arm), put<kArm, &ArmOptions::rate_Hz>, "rounds a second (1000)", 500.0, 2000.0},
        {"--arm", "wam|desktop|haply|touch|fd", of(arm), put<kArm, &ArmOptions::kind>,
         R"(simulated: Barrett's WAM of seven joints, or three axes on a desk (wam); real: Haply's by its service, 3D Systems' Touch, and Force
         Dimension's and the Falcon, by their makers' libraries)"},
        {"--library", "FILE", of(run, arm), put<kArm, &ArmOptions::library>, "the library of the arm's maker, where it lies in no usual place"},
        {"--service-port", "N", of(run, arm), put<kArm, &ArmOptions::service_port>, "where Haply's service waits at this computer (10001)", 1.0, 65535.0},
        {"--device", "ID", of(run, arm), put<kArm, &ArmOptions::device_id>, "which of several Haply arms, such as 049D"},
        {"--centre", "X,Y,Z", of(arm), set_centre,
         "the middle of a Haply arm's space in its own base, in metres (where its handle rests while it is opened)"},
        {"--log", "FILE", of(run, arm), put<kArm, &ArmOptions::log_file>, "keeps what Haply's service says, as it comes"},
        {kInitialiseOption, "", of(run, arm), put<kArm, &ArmOptions::may_initialise>,
         "nobody holds the arm and nothing is near it: it may move by itself to find its zero"},
        {"--attached", "", of(arm), put<kArm, &ArmOptions::is_attached>, "for programs: ends when its input does; says in lines where it waits and what happens"},
        {"--motion", "still|circle", of(arm), put<kArm, &ArmOptions::motion>, "what the hand does that holds it (still)"},
        {"--loss", "P", of(arm), put<kArm, kFaults, &LinkFaults::loss>, "per cent of the packets that are lost (0)", 0.0, 100.0},
        {"--burst", "N", of(arm), put<kArm, kFaults, &LinkFaults::burst>, "so many in a row (1)", 1.0, 1000.0},
        {"--delay", "MS", of(arm), put<kArm, kFaults, &LinkFaults::delay_s>, "milliseconds each way (0)", 0.0, 1000.0},
        {"--jitter", "MS", of(arm), put<kArm, kFaults, &LinkFaults::jitter_s>, "by which that changes (0)", 0.0, 1000.0},
        {"--reorder", "P", of(arm), put<kArm, kFaults, &LinkFaults::reorder>, "per cent that are overtaken (0)", 0.0, 100.0},
        {"--duplicate", "P", of(arm), put<kArm, kFaults, &LinkFaults::duplicate>, "doubled (0)", 0.0, 100.0},
        {"--corrupt", "P", of(arm), put<kArm, kFaults, &LinkFaults::corrupt>, "damaged (0)", 0.0, 100.0},
        {"--only", "PROCESS", of(stop), set_process, "that process alone", 1.0, kMostProcess},
        {"--seeds", "N", of(soak), put<&Options::seeds>, "how many runs of each lesson (3)", 1.0, 1.0e6},
    };
    return kRows;
}
// clang-format on

std::string number_text(double number) {
    std::string text = std::to_string(number);
    text.erase(text.find_last_not_of('0') + 1);
    return text.back() == '.' ? text.substr(0, text.size() - 1) : text;
}

}  // namespace fulcrum::runtime
