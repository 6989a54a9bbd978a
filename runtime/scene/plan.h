// The plan: what a scene calls for, and nothing else. Compiled once from a lesson's description (compile_plan.h)
// before anything runs; the runners build exactly the loops and stages that stand in it.
//
// Thread: load path.
#pragma once

#include "haptics/base/error.h"
#include "haptics/dynamics/rigid_loop_plan.h"
#include "haptics/dynamics/world_plan.h"
#include "haptics/loop/haptic_plan.h"
#include "runtime/effect/surface/stable_wall.h"
#include "runtime/scene/description.h"
#include "runtime/scene/listen_mode.h"
#include "runtime/scene/partner_order.h"
#include "runtime/scene/picture/felt_pictures.h"
#include "runtime/scene/site_limits.h"

#include <cstddef>
#include <functional>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace fulcrum::runtime {

class ShapeCache;

/// The share of the force limit that the heaviest load may use; the rest is left for springs and
/// for the arm's own friction, so that a weight is never clipped by the last gate.
inline constexpr double kWeightShareOfLimit = 0.9;

/// 22 June 2026: today, wherever a run must be the same each time.
inline constexpr double kTestDay = 9669.0;

/// How a learner's words arrive.
enum class SpeechInput : std::uint8_t { text, sphinx, external };

/// As the command line and the plan name it: "text", "sphinx", "exec".
[[nodiscard]] std::string_view name_of(SpeechInput speech);

/// What hears spoken answers.
struct HearingOrder {
    std::vector<std::string> words;  ///< the program and its arguments
    std::vector<std::string>
        recordings;  ///< WAV files that are heard instead of a microphone, one a question
    ListenMode listen = ListenMode::hold;  ///< with a microphone
    bool takes_throat = false;             ///< the program understands --throat
    double throat =
        0.0;  ///< how much smaller than a grown-up's the learner's is, 1 to 2; 0: to be found
    std::optional<double>
        sureness{};  ///< 0 to 1: what is less sure is asked for again; else as the lesson says
    /// True once nobody waits for it any more, because the program is to end; may be empty.
    std::function<bool()> gives_up{};
};

/// Told how much of what takes long to load is done, 0 to 1, and what it is; false stops the loading. May be empty.
using PlanProgress = std::function<bool(double share, std::string_view what)>;

/// Where what takes long to make comes from.
enum class ShapeSource : std::uint8_t { made, cache };

/// What the person at the keyboard chose; the rest follows from the lesson.
struct PlanOptions {
    SiteLimits site{};
    /// What the device can give; infinite for one that renders no force
    double device_force_limit_N = std::numeric_limits<double>::infinity();
    WallHolders holders{WallHolder{}};  ///< for which walls are made stable, one at least
    std::size_t n_hands = kMostHands;   ///< that somebody moves: no more are planned
    bool picture = true;                ///< a window or a screenshot is wanted
    bool sound = true;                  ///< false under --mute and --headless
    bool record = false;                ///< --record was given
    bool live =
        false;  ///< a hand waits for each step; false: the clock is virtual, and all is exact
    double day = kTestDay;  ///< today, as the lesson is told: days since noon of 1 January 2000
    SpeechInput speech = SpeechInput::text;
    HearingOrder hearing{};
    PartnerOrder partner{};
    ShapeCache* shapes = nullptr;  ///< keeps what takes long to make; null: it is made each time
    PlanProgress progress{};
};

/// One line of `fulcrum explain`: a stage that will run, and who asked for it.
struct PlanStage {
    std::string
        loop;  ///< "haptic", "hand 2", "world", "kite", "lesson", "picture", "sound" or "record"
    std::string name;      ///< e.g. "weight"
    double rate_hz = 0.0;  ///< 0: only when something happens
    std::size_t memory_bytes = 0;
    std::string because;  ///< e.g. "a body can be carried", for people
    SourceLine line = 0;  ///< line of the lesson that asked; 0 when every lesson has it
};

inline constexpr double kKiteRate_Hz = 500.0;

/// A kite's flight, which runs beside the haptic loop.
struct KitePlan {
    KiteFlightSettings flight{};
    double rate_hz = kKiteRate_Hz;
    double elevation_rad = 0.7;  ///< of the line at a launch
    int n_parts = 1;             ///< steps in each of its rounds
};

struct Plan {
    HapticPlan haptic{};
    std::vector<HapticPlan> more_hands;  ///< of the hands beside it, a loop each
    [[nodiscard]] HapticPlan& of_hand(std::size_t hand) {
        return hand == 0 ? haptic : more_hands[hand - 1];
    }
    [[nodiscard]] const HapticPlan& of_hand(std::size_t hand) const {
        return hand == 0 ? haptic : more_hands[hand - 1];
    }
    std::optional<WorldPlan> world;      ///< absent when nothing falls and is caught
    std::optional<RigidLoopPlan> rigid;  ///< absent without rigid bodies; never with the other
    std::optional<KitePlan> kite;        ///< absent when nothing flies
    bool picture = false;
    bool sound = false;
    bool touch_sound = false;  ///< strokes and taps are heard: a solid body is audible
    bool record = false;
    double day = 0.0;                        ///< today: days since noon of 1 January 2000
    bool dialogue = false;                   ///< the lesson asks questions
    bool free_english = false;               ///< and wants what fits none of their answers checked
    SpeechInput speech = SpeechInput::text;  ///< how answers arrive, when there are any
    bool recogniser = false;         ///< a speech recogniser listens; never with SpeechInput::text
    HearingOrder hearing{};          ///< what that is
    PartnerOrder partner{};          ///< who talks back; shipped where nobody is asked
    bool microphone = false;         ///< it hears one: somebody is there, and no recording is given
    bool live = false;               ///< on the loops' own threads, in real time
    bool waits_for_hearing = false;  ///< until it answers: no hand waits
    std::vector<double> felt_weight_N;          ///< one a body, 0 when it can't be carried
    std::vector<MaterialFacts> material_facts;  ///< one a material of the lesson, as it is felt
    double felt_scale =
        1.0;  ///< the factor that fitted the felt weights under the limit, at most 1
    std::vector<ShapeSource>
        tool_shapes;      ///< with a tool: of each solid as it meets it, then of its own points
    WallHolders holders;  ///< for which its walls were made stable
    std::vector<std::string> softer;  ///< what is less stiff for that: materials, bodies of none
    std::vector<std::string>
        notices;  ///< what a teacher should know of this scene, a sentence each
    std::vector<PlanStage>
        stages;  ///< everything above, in the order of the data, for people and for tests

    /// True when a stage of that loop and name is in the plan.
    [[nodiscard]] bool has(const std::string& loop, const std::string& name) const;
    /// Of the world's loop, 0 where there is none.
    [[nodiscard]] double world_rate_hz() const {
        return world ? world->rate_hz : rigid ? rigid->rate_hz : 0.0;
    }
};

/// Gives the touchable mesh of a solid body (from its model); called for solid bodies only.
using SolidLoader =
    std::function<Expected<std::shared_ptr<const CollisionMesh>>(const BodyDescription&)>;

/// Gives the relief of a material's picture, `width_m` wide on the surface; called for materials with a picture.
using PictureLoader =
    std::function<Expected<FeltPicture>(const MaterialDescription&, double width_m)>;

}  // namespace fulcrum::runtime
