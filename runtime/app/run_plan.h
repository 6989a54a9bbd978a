// The plan of a run and the scene that it is compiled from, fitted to the devices in its hands: to what they can give, to how far they reach, to
// what walls they hold.
//
// Thread: load path.
#pragma once

#include "haptics/base/error.h"
#include "runtime/app/places.h"
#include "runtime/app/run_hand.h"
#include "runtime/app/run_request.h"
#include "runtime/scene/plan.h"

#include <functional>
#include <string>
#include <vector>

namespace fulcrum::runtime {

/// What a lesson's run was asked for, from where. Both outlive what is done with them.
struct RunOrder {
    const Places& places;
    const RunRequest& request;
};

class RunPlan {
  public:
    /// The lesson's own, before any hand is open.
    [[nodiscard]] Expected<void> compile(const RunOrder& order, const LessonDescription& lesson);
    /// To what the newest hand's device can give, and what it holds.
    [[nodiscard]] Expected<void> fit_to_force(const RunOrder& order, const RunHands& hands);
    /// A hand beside the first goes as far as was said; the first one's scale is in the scene from the beginning.
    [[nodiscard]] Expected<void> scale_as_said(const RunOrder& order, const RunHands& hands,
                                               std::size_t hand, const HandFit& fit);
    /// `factor` times as far, where the scene can be felt so; else the lesson's own stays, and a part of it is out of reach.
    void fit_to_reach(const RunOrder& order, const RunHands& hands, std::size_t hand,
                      double factor);
    /// What the same lesson would be planned as, were it changed so.
    [[nodiscard]] Expected<Plan> compile_changed(
        const RunOrder& order, const RunHands& hands,
        const std::function<void(LessonDescription&)>& change) const;

    [[nodiscard]] Plan& plan() { return plan_; }
    [[nodiscard]] const Plan& plan() const { return plan_; }
    /// The lesson's, at the scale of its hands.
    [[nodiscard]] const LessonDescription& scene() const { return scene_; }
    /// What was done to it, a sentence each; given once.
    [[nodiscard]] std::vector<std::string> take_notices() { return std::move(notices_); }

  private:
    [[nodiscard]] Expected<Plan> compile_for(const RunOrder& order, const RunHands& hands,
                                             const LessonDescription& scene) const;
    [[nodiscard]] Expected<Plan> compile_scaled(const RunOrder& order, const RunHands& hands,
                                                std::size_t hand, double factor,
                                                LessonDescription& scene) const;

    LessonDescription scene_{};
    Plan plan_{};
    std::vector<std::string> notices_;
};

/// The most that all hands can give, newtons: as far as it is known before they are open, or as they say themselves.
[[nodiscard]] double find_force_limit_N(const RunRequest& request, const RunHands& hands);

}  // namespace fulcrum::runtime
