// What a lesson's process and the program say to each other, 60 times a second.
//
//   program --LessonFrame--> lesson      what happened since the last frame, and how things stand
//   lesson --LessonReply--> program      commands, in order
//
// The lesson's process is not trusted: the program checks every number, name and length of a reply.
#pragma once

#include "haptics/handover/messages.h"
#include "runtime/effect/kite/kite_messages.h"
#include "runtime/scene/body_light.h"

#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace fulcrum::runtime {

// ---- events: program -> lesson -------------------------------------------------------------------------------

/// What happened to a body.
struct BodyEvent {
    enum class Kind : std::uint8_t { caught, landed, touched, released };
    Kind kind = Kind::caught;
    std::int32_t body = kNoBody;
    double speed_m_per_s = 0.0;
};

/// A key was pressed: "space", "return", "left", a letter …
struct KeyEvent {
    std::string key;
};

/// "Is this answer right?" The lesson answers with a VerdictCommand in the same reply; the simulated physics decides.
struct JudgeEvent {
    std::string question;
    std::vector<std::pair<std::string, std::string>> slots;  ///< e.g. thing -> watermelon
};

/// An answer has been marked and answered to; the lesson goes on from here.
struct AnsweredEvent {
    std::string question;
    std::string said;  ///< the learner's words
    std::vector<std::pair<std::string, std::string>> slots;
    bool understood = true;   ///< false: no template fitted, the program asked to say it again
    bool right = false;       ///< the meaning, by the lesson's own verdict
    bool form_right = false;  ///< its form is known, and no error was found in it
    bool over = true;         ///< the question is done: right, or left after many tries
    std::int32_t attempt = 1;
    bool turned_round =
        false;               ///< thing and material changed places: "Metal is made of a spaceship."
    bool replay = false;     ///< what the question is about should be felt again
    bool form_known = true;  ///< false: the meaning alone was heard
};

/// The learner asks for something that the lesson knows. The lesson answers with a TellCommand in the same reply.
struct AskedEvent {
    std::string knowledge;
    std::vector<std::pair<std::string, std::string>> slots;
};

/// What can be said of a material as it is felt. Grades from 0 to 1; from 0.5 on it is hard, rough, slippery (haptics/surface/material.h).
struct MaterialGrades {
    double hardness = 0.0;
    double roughness = 0.0;
    double slipperiness = 0.0;
    double stiffness_N_per_m = 0.0;  ///< as these devices are given it, in the hand's metres
};

/// What the learner has answered to a question in earlier sessions, of this lesson or another.
struct PastAnswers {
    std::string lesson;
    std::string question;
    std::int32_t asked = 0;  ///< how often it was asked
    std::int32_t right = 0;  ///< of these, how often the answer came to be right in meaning
    std::int32_t wrong_now =
        0;              ///< answers not right at the end, in a row; 0 when the last was right
    double days = 0.0;  ///< since the last answer, not negative
    std::vector<std::pair<std::string, std::int32_t>>
        points{};  ///< grammar point -> errors of form that belong to it
};
inline constexpr std::size_t kMaxPastAnswers = 2000;

/// A lesson that can be entered from a room.
struct KnownLesson {
    std::string name;  ///< of its folder
    std::string title;
    std::string level;       ///< CEFR; empty: it says nothing
    std::string icon;        ///< a model
    std::int32_t stars = 0;  ///< this learner's best, 0 to 3; -1: never played to its end
};
inline constexpr std::size_t kMaxKnownLessons = 500;

/// The plan is compiled: what each body weighs in the hand, and what each material is like. Sent once, before the first
/// frame.
struct ReadyEvent {
    std::vector<double> felt_weight_N;  ///< one a body; 0 when it can't be carried
    double felt_scale = 1.0;            ///< factor that fitted all weights under the force limit
    std::vector<MaterialGrades> materials{};  ///< one a material of the description
    double day = 0.0;                         ///< today: days since noon of 1 January 2000
    std::vector<PastAnswers> past{};          ///< where the description wants it, the newest last
    std::vector<KnownLesson> lessons{};       ///< of a room, in their order
};

using LessonEvent =
    std::variant<BodyEvent, KeyEvent, JudgeEvent, AnsweredEvent, ReadyEvent, AskedEvent>;

/// How a body on a hinge stands.
struct HingeState {
    double angle_rad = 0.0;
    double spin_rad_per_s = 0.0;
    double torque_Nm = 0.0;       ///< of the hand
    double arm_m = 0.0;           ///< of the hand's force: how far its line passes from the axis
    double load_torque_Nm = 0.0;  ///< of what hangs on it
    double inertia_kg_m2 = 0.0;   ///< about its axis where that lies now
};

/// How a hand is.
struct HandFrame {
    Pose tool_pose_W{};
    Twist tool_twist_W{};
    Wrench applied_W{};         ///< what it is given
    std::uint32_t buttons = 0;  ///< one bit a button
};

/// Everything the lesson needs to know for one frame.
struct LessonFrame {
    double time_s = 0.0;
    double dt_s = 0.0;
    Pose tool_pose_W{};
    Twist tool_twist_W{};
    Wrench applied_W{};                 ///< what the hand is given
    std::uint32_t buttons = 0;          ///< of its device, one bit each
    std::vector<HandFrame> more_hands;  ///< those beside it that somebody moves
    std::vector<BodyState> bodies;      ///< in the order of the scene
    std::vector<HingeState> hinges;     ///< of the bodies that have one, in their order
    std::optional<KiteState> kite;      ///< once it flies
    std::vector<LessonEvent> events;
    bool only_asks =
        false;  ///< for verdicts: no time passes, and nobody is called but for the events
};

// ---- commands: lesson -> program -----------------------------------------------------------------------------

/// drop, place, hide, hold or release a body.
struct MoveCommand {
    WorldCommand move{};
};
/// Lays a cloth over a body or takes it away: it is not seen, and felt as before.
struct CoverCommand {
    std::int32_t body = kNoBody;
    bool covered = true;
};
/// Shows beside a body that stands there what was felt of it, newtons; 0 takes that away.
struct MarkCommand {
    std::int32_t body = kNoBody;
    double felt_N = 0.0;
};
/// Lights a body up, from now on.
struct LightCommand {
    std::int32_t body = kNoBody;
    BodyLight light = BodyLight::off;
};
/// Sets what is given of a body on a hinge.
struct TurnCommand {
    std::int32_t body = kNoBody;
    std::optional<double> angle_rad;
    std::optional<double> spin_rad_per_s;
    std::optional<Vector3> pivot_W;
    std::optional<double> load_N;
};
/// Switches or moves a declared force.
struct FieldChangeCommand {
    std::int32_t force = 0;  ///< index in the description
    FieldCommand field{};
};
/// The lesson's own force function, evaluated and linearised at the newest tool state.
struct LessonForceCommand {
    LinearisedWrench force{};
};
/// One instruction for the learner, shown; an empty one clears it.
struct CaptionCommand {
    std::string text;
};
struct AskCommand {
    std::string question;
};
struct VerdictCommand {
    std::string question;
    bool right = false;
};
/// The answer to what a learner has asked; empty: the lesson does not know.
struct TellCommand {
    std::string knowledge;
    std::string text;
};
struct ScoreCommand {
    std::int32_t score = 0;
};
struct LevelCommand {
    std::int32_t level = 1;
    std::string title;
};
struct SoundCommand {
    std::string name;
};
/// The lesson is over; the program shows the end, keeps the result and offers to play again.
struct FinishCommand {
    std::int32_t stars = 0;  ///< 0 to 3
};
/// This lesson, a room, is left for another one, named as in KnownLesson; empty: for the list of all.
struct EnterCommand {
    std::string lesson;
};
/// Shows the program's own hand there, or takes it away: it shows what to do, and touches nothing.
struct ShowHandCommand {
    std::optional<Vector3> at_W;
};
/// print(): for the teacher's terminal.
struct PrintCommand {
    std::string text;
};

using LessonCommand =
    std::variant<MoveCommand, FieldChangeCommand, LessonForceCommand, CaptionCommand, AskCommand,
                 VerdictCommand, ScoreCommand, LevelCommand, SoundCommand, FinishCommand,
                 PrintCommand, CoverCommand, TurnCommand, KiteCommand, WindCommand, TellCommand,
                 ShowHandCommand, EnterCommand, MarkCommand, LightCommand>;

/// Where a simulated hand wants to be.
struct HandAim {
    bool is_given = false;
    Pose target_W{};
    std::uint32_t buttons = 0;
};

struct LessonReply {
    std::vector<LessonCommand> commands;
    bool has_hand_target = false;  ///< the simulated hand's Lua gave a target
    Pose hand_target_W{};
    std::uint32_t hand_buttons = 0;
    std::string hand_key;            ///< that it presses on the keyboard, once; empty for none
    std::vector<HandAim> more_aims;  ///< of the simulated hands beside it
};

}  // namespace fulcrum::runtime
