// A god-object's tool over what it touches: down from above until they touch, then pressed 4 mm too deep, drawn to and fro by up to 7 cm/s,
// and tilted.
#pragma once

#include "haptics/math/rotation.h"
#include "tests/bench/harness/curve.h"
#include "tests/support/god_scene.h"

namespace fulcrum::bench {

inline constexpr double kLarge_m = 0.1;  ///< each mesh

class DrawnTool {
  public:
    DrawnTool(const std::vector<GodObjectPlan>& plans, double budget_us)
        : tool_(GodObjectTool::build(plans, make_settings(budget_us)).value()) {
        tool_.place(Pose::at({0.0, 1.2 * kLarge_m, 0.0}));
        for (int i = 1; i <= 2000 && tool_.last_step().contacts == 0; ++i) {
            touched_m_ = 1.2 * kLarge_m - 1.0e-4 * i;
            (void)tool_.move({Pose::at({0.0, touched_m_, 0.0}), {}}, {&held_, 1}, 0.0,
                             test::kGodDt_s);
        }
    }
    /// What it takes of the processor.
    double step_us() {
        ++n_;
        const double t_s = n_ * test::kGodDt_s;
        return time_once([&] {
                   keep(tool_.move({handle_W(), {}}, {&held_, 1}, t_s, test::kGodDt_s));
               })
            .own_us;
    }
    [[nodiscard]] Pose handle_W() const {
        constexpr double kPressed_m = 0.004;
        const double t_s = n_ * test::kGodDt_s;
        const double down = std::min(1.0, t_s / 0.1);
        return {Vector3(0.02 * std::sin(3.0 * t_s), touched_m_ - kPressed_m * down,
                        0.01 * std::sin(5.0 * t_s)),
                compute_exp(Vector3(0.02 * std::sin(4.0 * t_s), 0.1 * std::sin(2.0 * t_s),
                                    0.02 * std::sin(3.0 * t_s)))};
    }
    [[nodiscard]] GodObjectTool& tool() { return tool_; }

  private:
    static GodObjectSettings make_settings(double budget_us) {
        constexpr double kMass_kg = 0.05;
        GodObjectSettings settings =
            test::make_god_settings(make_ball_inertia(kMass_kg, 0.5 * kLarge_m));
        settings.budget_us = budget_us;
        return settings;
    }

    const MovingFrame held_{};
    GodObjectTool tool_;
    double touched_m_ = 0.0;
    int n_ = 0;
};

}  // namespace fulcrum::bench
