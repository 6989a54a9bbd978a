// What must be known before anything else: a mistake in the lesson, a lesson that hardly runs, a stop, a device that is lost, progress
// that is not kept, a force that waits.
//
// Thread: pure.
#pragma once

#include "dialogue/catalogue.h"
#include "runtime/scene/view.h"

#include <string>

namespace fulcrum::runtime {

/// In a window nobody waits longer than that for a lesson that cannot begin, or without being asked for one that plays.
inline constexpr double kLongestWindowWait_s = 10.0;

struct ScreenTrouble {
    std::string error{};    ///< why the lesson failed, for the teacher
    double waited_s = 0.0;  ///< for the lesson's answer
    bool is_stopped = false;
    bool is_paused = false;  ///< stopped because somebody wants to wait
    bool device_is_lost = false;
    bool is_unkept = false;   ///< something of what the learner did
    bool holds_back = false;  ///< a force waits until the hand rests
};

/// Whether Enter begins again, and Escape leaves at once: nothing plays.
[[nodiscard]] bool offers_another_begin(const ScreenTrouble& trouble) noexcept;

/// The worst of it, in the banner; the picture as it was where there is none.
void show(const ScreenTrouble& trouble, const dialogue::Catalogue& catalogue, View& view);

}  // namespace fulcrum::runtime
