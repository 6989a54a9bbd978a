// What the command line can ask for.
#pragma once

#include "dialogue/marking/feedback_ladder.h"
#include "haptics/base/error.h"
#include "haptics/link/link_faults.h"
#include "runtime/app/arm_kind.h"
#include "runtime/app/played_by.h"
#include "runtime/audio/voice/voice_program.h"
#include "runtime/lesson/hand_fit.h"
#include "runtime/render/picture_quality.h"
#include "runtime/scene/plan.h"
#include "runtime/scene/screen_settings.h"

#include <optional>
#include <string>
#include <vector>

namespace fulcrum::runtime {

enum class Command : std::uint8_t {
    room,
    menu,
    run,
    list,
    check,
    test,
    explain,
    report,
    school_class,
    devices,
    arm,
    stop,
    soak,
    bench,
    export_record,
    help,
    version
};

/// When an arm's forces are tried before a lesson: once for each learner and arm, each time, or not at all.
enum class FirstUseTrial : std::uint8_t { once, again, never };

/// What the hand does that holds a simulated arm.
enum class ArmMotion : std::uint8_t { still, circle };

/// Of `fulcrum arm`, and of the arm that a run starts.
struct ArmOptions {
    std::string address = "127.0.0.1";
    std::uint16_t port = 4701;
    std::string key_file;  ///< empty: the default place; of run: the first hand's
    double rate_Hz = 1000.0;
    ArmKind kind = ArmKind::wam;
    ArmMotion motion = ArmMotion::still;
    bool is_attached =
        false;  ///< to a program: it ends with its input, and speaks as own_arm.h says
    LinkFaults faults{};
    std::uint16_t service_port = 10001;  ///< of Haply's service
    std::string device_id;               ///< of Haply's arm; empty: the only one
    /// Of Haply's arm: the middle of its space in its own base, m; nothing: where the handle rests while it is opened.
    std::optional<Vector3> centre_A;
    std::string log_file;         ///< where what Haply's service says is kept; empty: nowhere
    std::string library;          ///< of a real arm's maker: where it lies; empty: its usual places
    bool may_initialise = false;  ///< somebody has said that the arm may move by itself once
};

/// Everything the command line can say: option_table.h says what each option means and may be. Fields that a command does not use are
/// refused for it.
struct Options {
    Command command = Command::room;
    std::string help_for;            ///< help: of this command alone; empty: of all
    std::vector<std::string> words;  ///< class: what is done, and with whom
    std::string lesson;              ///< a name under scenarios/ or a folder; a record of it
    bool headless = false;
    bool real_time = false;
    std::optional<double> seconds;
    std::vector<std::string> hands;  ///< of each; what is not said is chosen by what is there
    std::optional<PlayedBy> by;      ///< test: by all where none is named
    std::string deeds;               ///< where what --by does in a window is written
    std::string say;
    std::optional<double> errors;
    std::string learner;
    std::string database;    ///< empty: the default place
    std::string class_name;  ///< empty: the only one there is; in the list of lessons each
    std::string names_file;  ///< of a class; empty: its names are words
    bool each_guest = false;
    std::optional<std::uint64_t> seed;
    std::string record;
    std::string screenshot;
    double screenshot_at_s = -1.0;  ///< negative: at the run's end
    PartnerOrder partner{};
    SpeechInput speech = SpeechInput::text;
    std::optional<double> throat;
    std::optional<double> sureness;
    std::string hearing;  ///< with --speech exec: the command
    std::string hear;
    ListenMode listen = ListenMode::hold;
    std::optional<VoiceKind> voice{};     ///< nothing: as the learner has chosen
    std::optional<double> voice_speed{};  ///< likewise
    bool watch = false;
    bool mute = false;
    std::optional<Language> language{};  ///< nothing: as the learner has chosen, else the locale's
    double yield = 1.0;
    std::optional<PictureLevel> picture{};  ///< nothing: as fine as comes in time
    bool analyze = false;
    bool quick = false;
    bool again = false;
    bool json = false;
    std::optional<double> force_limit_N;
    SiteLimits site{};  ///< found for it (site_file.h)
    /// Empty: as each lesson says; none: as the learner's own is, if one is kept.
    std::optional<dialogue::FeedbackLadder> feedback{};
    std::string format = "text";
    std::string out;
    ArmOptions arm{};
    HandFit fit{};                       ///< how the first hand's device is set, as far as said
    std::vector<HandFit> more_fits;      ///< of the others: what stands behind their --hand
    std::vector<std::string> more_keys;  ///< likewise; empty: the default place
    FirstUseTrial first_use = FirstUseTrial::once;
    std::optional<double> force_at_s;
    std::optional<int> only_process;
    std::uint64_t seeds = 3;
};

}  // namespace fulcrum::runtime
