// What the command line can ask for.
#pragma once

#include "dialogue/marking/feedback_ladder.h"
#include "haptics/base/error.h"
#include "haptics/link/link_faults.h"
#include "runtime/app/played_by.h"
#include "runtime/audio/voice/voice_program.h"
#include "runtime/lesson/hand_fit.h"
#include "runtime/scene/plan.h"

#include <optional>
#include <string>
#include <vector>

namespace fulcrum::runtime {

enum class Command : std::uint8_t {
    menu,
    run,
    list,
    check,
    test,
    explain,
    report,
    devices,
    arm,
    stop,
    soak,
    export_record,
    help,
    version
};

/// When an arm's forces are tried before a lesson: once for each learner and arm, each time, or not at all.
enum class FirstUseTrial : std::uint8_t { once, again, never };

/// What the hand does that holds a simulated arm.
enum class ArmMotion : std::uint8_t { still, circle };

/// Which arm is simulated: Barrett's WAM of seven joints, or three axes on a desk.
enum class ArmKind : std::uint8_t { wam, desktop };

/// Of `fulcrum arm`.
struct ArmOptions {
    std::string address = "127.0.0.1";  ///< where it waits
    std::uint16_t port = 4701;          ///< 0: any that is free
    std::string key_file;               ///< empty: the default place; of run: the first hand's
    double rate_Hz = 1000.0;            ///< 500 to 2000
    ArmKind kind = ArmKind::wam;
    ArmMotion motion = ArmMotion::still;
    LinkFaults faults{};
};

/// Everything the command line can say. Fields that a command does not use are refused for it.
struct Options {
    Command command = Command::menu;
    std::string help_for;           ///< help: of this command alone; empty: of all
    std::string lesson;             ///< a name under scenarios/ or a folder
    bool headless = false;          ///< no window: virtual clock, faster than real time
    bool real_time = false;         ///< run: the loops keep real time, as in a window
    std::optional<double> seconds;  ///< end the run after this long, 0 to 86 400
    /// Of each hand: FILE.lua, mouse, keys, hid, hid:PATH, udp:HOST:PORT, replay:FILE or none; what is not said is chosen by what is there.
    std::vector<std::string> hands;
    std::optional<PlayedBy> by;  ///< how a simulated hand plays; test: by all where none is named
    std::string say;             ///< file with one answer a line
    std::optional<double>
        errors;            ///< a simulated learner answers, and errs in so many parts, 0 to 0.9
    std::string learner;   ///< nickname
    std::string database;  ///< file; empty: the default place
    std::optional<std::uint64_t> seed;  ///< of what a lesson leaves to chance
    std::string record;                 ///< file to write the run to
    std::string screenshot;             ///< PNG to write when the run ends
    double screenshot_at_s = -1.0;      ///< or at this time of the run; negative: at its end
    SpeechInput speech = SpeechInput::text;
    std::optional<double>
        throat;  ///< with --speech sphinx: the learner's, 1 to 2 times smaller than a grown-up's
    std::optional<double> sureness;        ///< with --speech: how sure one must be, 0 to 1
    std::string hearing;                   ///< with --speech exec: the command
    std::string hear;                      ///< file with the name of one recording a line
    ListenMode listen = ListenMode::hold;  ///< in a window: when the microphone is heard
    VoiceSettings voice{};                 ///< likewise
    bool watch = false;                    ///< start again whenever the lesson's files change
    bool mute = false;
    bool analyze = false;                 ///< explain: play it too, and tell what each stage cost
    bool quick = false;                   ///< check: without playing it
    bool again = false;                   ///< check: also where nothing has changed since the last
    bool json = false;                    ///< explain, devices: for programs
    std::optional<double> force_limit_N;  ///< newtons, 0.5 to 10; no more than the site allows
    SiteLimits site{};                    ///< found for it (site_file.h)
    std::optional<dialogue::FeedbackLadder>
        feedback{};  ///< empty: as each lesson says; none: as the learner's own is, if one is kept
    std::string format = "text";  ///< report: text or csv
    std::string out;              ///< report: file instead of the screen; export: the table's
    ArmOptions arm{};
    HandFit fit{};  ///< how the hand's device is set, as far as it is said
    std::vector<HandFit>
        more_fits;  ///< of the hands beside the first: what stands behind their --hand
    std::vector<std::string> more_keys;  ///< likewise; empty: the default place
    FirstUseTrial first_use = FirstUseTrial::once;
    std::optional<double>
        force_at_s;                   ///< explain: of a record, the force at this time, 0 to 86 400
    std::optional<int> only_process;  ///< stop: that one alone
    std::uint64_t seeds = 3;          ///< soak: how many runs of each lesson
};

}  // namespace fulcrum::runtime
