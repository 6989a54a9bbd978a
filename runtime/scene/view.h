// What the picture shows in one frame. The renderer reads this and nothing else.
#pragma once

#include "haptics/math/spatial.h"
#include "runtime/scene/body_light.h"
#include "runtime/scene/description.h"
#include "runtime/scene/screen_settings.h"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace fulcrum::runtime {

/// One thing to draw.
struct ViewBody {
    std::string model;  ///< name of a model
    Pose pose_W{};
    Vector3 scale{Vector3::Ones()};  ///< squash and stretch
    BodyLight light = BodyLight::off;
    std::string look;    ///< what it is made of, "wood"; empty: as the model is painted
    std::string label;   ///< small text beside it, e.g. "apple"; empty for none
    bool marked = true;  ///< the floor below it says where it is, by a mark and a shadow
};

/// Whose force it is: of the hand or felt by it, of what hangs there or weighs, of the air across its stream and along it.
enum class ForceLook : std::uint8_t { hand, load, lift, drag };
inline constexpr std::size_t kForceLooks = 4;

/// A force drawn as an arrow with its newtons; every lesson draws it alike.
struct ViewForce {
    bool visible = false;
    Vector3 at_W{Vector3::Zero()};
    Vector3 force_W{Vector3::Zero()};
    std::string text;                  ///< e.g. "felt 2.8 N · true 2.0 N"
    ForceLook look = ForceLook::hand;  ///< each has a colour of its own
};

/// A hand beside the first.
struct ViewHand {
    ViewBody tool{};
    bool ghost_visible = false;
    Pose ghost_pose_W{};
};

/// A force that turns a body about an axis: the lever arm as a bar from the axis, the force as an arrow at its end.
struct ViewTorque {
    Vector3 axis_W{Vector3::Zero()};  ///< the point of the axis from which the arm starts
    ViewForce force{};                ///< its text is the torque's
};

/// A setting at one of its steps, drawn as a sign.
struct ViewSetting {
    SettingKind kind{};
    int step = 0;
};

/// An entry of the list of lessons, or of the settings.
struct ViewMenuItem {
    std::string title;
    std::string subtitle;       ///< level and minutes
    std::string icon;           ///< name of a model drawn small
    int stars = -1;             ///< the learner's most, 0 to 3; -1: never played to its end
    std::string second_icon{};  ///< beside the first, where there are two
    bool leads_back = false;    ///< an arrow instead of a model
    std::optional<ViewSetting> setting{};  ///< its sign instead of a model
};

/// Whether somebody may speak, and how loud it is.
struct ViewMicrophone {
    bool visible = false;  ///< a microphone is there, and a question is open
    bool hears = false;    ///< what is said now is taken in
    double level = 0.0;    ///< 0 to 1
    std::string words;     ///< what to do, where nothing is typed yet
};

/// An answer to choose.
struct ViewChoice {
    std::string said;
    std::string picture{};  ///< name of a model drawn small before it; empty for none
    std::string look{};     ///< what that is made of, as a ViewBody's
};

/// A part of the force that is felt.
struct ViewShare {
    std::string name;
    std::string amount;    ///< newtons and direction
    double part = 0.0;     ///< of the strongest, 0 to 1
    bool against = false;  ///< it acts against what is felt
};

/// "Why do I feel this?"
struct ViewWhy {
    bool visible = false;
    std::string title;
    std::vector<ViewShare> shares;  ///< the strongest first
};

/// Where something was caught or answered rightly, and how long ago.
struct ViewBurst {
    Vector3 at_W{Vector3::Zero()};
    double age_s = 0.0;  ///< below kBurstLasts_s
};
inline constexpr double kBurstLasts_s = 0.8;

/// How the helper looks that speaks: after a right answer, after another one, else.
enum class ViewMood : std::uint8_t { calm, happy, thoughtful };

/// What a click in the corner does, as keys do.
enum class ScreenButton : std::uint8_t { pause, say_again, ask, why, settings, leave };

struct View {
    double time_s = 0.0;
    CameraDescription camera{};
    double ground_height_m = 0.0;  ///< height of the floor, where things land and cast their shadow
    bool in_space = false;         ///< stars instead of floor and sky
    std::vector<ViewBody> bodies;
    bool tool_visible = true;
    ViewBody tool{};  ///< where the tool is (the proxy)
    bool ghost_visible = false;
    Pose ghost_pose_W{};  ///< where the arm really is
    std::vector<ViewHand> more_hands;
    ViewForce force{};
    std::vector<ViewTorque> torques;  ///< of bodies on hinges, where something presses or hangs
    std::vector<ViewForce> forces;    ///< that are compared: drawn to one scale
    std::vector<ViewForce> marks;     ///< remembered, each ends at `at_W`: as long as if felt now
    std::optional<KiteSettings> kite_design{};  ///< what kKiteModel is like
    std::vector<ViewBurst> bursts;
    ViewMood mood = ViewMood::calm;
    bool speaks = false;  ///< a voice is heard
    std::string title;
    std::string caption;   ///< the one instruction
    std::string feedback;  ///< what was answered; words between asterisks are emphasised
    bool input_visible = false;
    std::string input;                ///< what the learner is typing
    std::vector<ViewChoice> choices;  ///< answers to choose from, above the line to type in
    int chosen = -1;                  ///< of these; -1: none
    ViewMicrophone microphone{};
    ViewWhy why{};
    std::vector<bool> lights;  ///< of the bodies offered or lit, in their order: is it lit?
    int score = 0;
    int level = 0;
    std::string level_title;
    int stars = -1;                     ///< 0 to 3 at the end, -1 before
    std::vector<ScreenButton> buttons;  ///< from the left
    bool paused = false;                ///< the lesson stands still, and `pause` goes on
    std::string banner;                 ///< an error or a notice across the top; empty for none
    bool banner_is_error = false;
    std::vector<ViewMenuItem> menu;  ///< the list of lessons, instead of a scene
    int menu_selected = 0;
    int menu_first_row = 0;  ///< the row of cards to show first, where the chosen card allows it
    bool menu_is_small = false;  ///< cards so small that those of a class stand on one picture
    ViewLook look{};
    std::string end_note{};  ///< below the stars: why these
};

}  // namespace fulcrum::runtime
