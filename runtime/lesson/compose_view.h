// Puts one frame's picture together from what the loops and the session say. Pure: the same input,
// the same view.
//
// Thread: lesson loop. Cost: a copy of the words and one entry a visible body.
#pragma once

#include "dialogue/catalogue.h"
#include "haptics/handover/axle_messages.h"
#include "haptics/handover/messages.h"
#include "runtime/lesson/session.h"
#include "runtime/scene/description.h"
#include "runtime/scene/plan.h"
#include "runtime/scene/view.h"

#include <string>

namespace fulcrum::runtime {

/// A hand beside the first.
struct HandScenery {
    HapticState hand{};
    bool ghost = false;
    Pose ghost_pose_W{};
};

/// Everything that a frame shows.
struct Scenery {
    double time_s = 0.0;
    HapticState hand{};
    const WorldSnapshot* world = nullptr;  ///< null when the plan has none
    const AxleFrame* axles = nullptr;      ///< null when nothing turns
    const KiteFrame* kite = nullptr;       ///< null when nothing flies
    bool renders_force = true;  ///< false for a mouse: what can't be felt is shown more strongly
    bool ghost = false;         ///< show where the hand itself is
    Pose ghost_pose_W{};
    std::vector<HandScenery> more_hands{};
};

/// The picture of a lesson that runs.
[[nodiscard]] View compose_view(const LessonDescription& lesson, const Plan& plan,
                                const SessionHud& hud, const Scenery& scenery,
                                const dialogue::Catalogue& catalogue);

/// Is the hand a ball, box, capsule or cylinder of its own, drawn as such (kToolModel), that touches without turning?
[[nodiscard]] bool has_shaped_cursor(const HandDescription& hand) noexcept;

/// A number with so many decimals.
[[nodiscard]] std::string number_text(double value, int decimals);
/// Newtons as a child reads them: one decimal.
[[nodiscard]] std::string newtons_text(double newtons);

}  // namespace fulcrum::runtime
