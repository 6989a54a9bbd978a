// What must hold after every step of a god-object's tool in a hard case, with the settings that ship.
#pragma once

#include "tests/stability/cases/stability_case.h"
#include "tests/support/god_scene.h"

#include <algorithm>
#include <cmath>
#include <string>

namespace fulcrum::stability {

inline constexpr double kGodStiffness_N_per_m = 500.0;
inline constexpr double kGodGap_m = 1.0e-6;
inline constexpr double kGodCube_m = 0.04;  // its side
inline constexpr int kBlended = 1200;       // steps in which any set of contacts is blended in
inline constexpr double kExact_N = 1.0e-6;
inline constexpr const char* kGodMeasured =
    "what the case asks, of what is allowed; 100: surfaces cross after a step, a force is no "
    "number, "
    "something is felt in the free, or the tool cannot move";

inline TriangleMesh make_god_cube() {
    return make_box(Vector3::Constant(kGodCube_m)).value();
}

inline GodObjectSettings of_god_cube() {
    return test::make_god_settings(make_box_inertia(0.05, Vector3::Constant(kGodCube_m)));
}

/// Steps a scene, and keeps the worst of what is seen.
class GodWatch {
  public:
    /// For step_without_gain: `inertia_per_mass_m2` of the tool about any axis, `recovers_m` how far contacts that it was stopped nearer to than it rests
    /// may push it back.
    explicit GodWatch(test::GodScene& scene, double gap_m = kGodGap_m,
                      double inertia_per_mass_m2 = kGodCube_m * kGodCube_m / 6.0,
                      double recovers_m = kGodGap_m)
        : scene_(scene),
          near_m_(1.001 * kNearGaps * gap_m),
          per_mass_m2_(inertia_per_mass_m2),
          recovers_m_(recovers_m) {
        for (const TriangleMesh& object : scene.objects) {
            is_small_ = is_small_ &&
                        object.triangles().size() * scene.tool.triangles().size() <= kMostPairs;
        }
    }

    ToolFelt step(const Pose& handle, double dt_s = test::kGodDt_s) {
        const ToolFelt felt = scene_.god.move({handle, {}}, scene_.frames, 0.0, dt_s);
        n_standing_ += felt.moved ? 0 : 1;
        look(felt, dt_s);
        return felt;
    }
    /// A step that may be refused, for what is told is no pose or time.
    ToolFelt try_step(const Pose& handle, double dt_s = test::kGodDt_s) {
        const ToolFelt felt = scene_.god.move({handle, {}}, scene_.frames, 0.0, dt_s);
        look(felt, dt_s);
        return felt;
    }
    /// Where nothing moves but the tool and nothing rubs: the coupling is not more stretched than before the step.
    ToolFelt step_without_gain(const Pose& handle) {
        const double before_J = find_stretch_J(handle);
        const ToolFelt felt = step(handle);
        const double pushed_J = std::sqrt(2.0 * kGodStiffness_N_per_m * before_J) * recovers_m_;
        demand(find_stretch_J(handle) <= before_J + pushed_J + kRounding_J);
        return felt;
    }
    void demand(double share) { worst_ = worse(worst_, share); }
    void demand(bool holds) { demand(holds ? 0.0 : 100.0); }
    /// This force, to within `off_N`.
    void demand_felt(const ToolFelt& felt, const Vector3& wanted_N, double off_N = kExact_N) {
        demand((felt.felt_W.force - wanted_N).norm() / off_N);
    }
    /// The hand has let the tool out: it is where the hand is, and nothing is felt.
    void demand_free(const Pose& handle) {
        ToolFelt felt;
        for (int i = 0; i < 60; ++i) {
            felt = step(handle);
        }
        const Vector6 left = find_way(scene_.god.pose_W(), handle);
        demand(left.head<3>().norm() / 1.0e-9);
        demand(std::sqrt(per_mass_m2_) * left.tail<3>().norm() / 1.0e-9);
        demand(felt.felt_W.force.norm() / 1.0e-9);
        demand(felt.felt_W.torque.norm() / 1.0e-9);
    }

    [[nodiscard]] double most_N() const { return most_N_; }
    [[nodiscard]] int n_touching() const { return n_touching_; }
    /// Of all demands the worst; 100 if surfaces crossed after any step, or a force was none, or one too many, or it would not move.
    [[nodiscard]] Finding judge() const {
        const bool kept = n_crossing_ + n_standing_ + n_felt_free_ + n_none_ == 0;
        return {
            worse(worst_, kept ? 0.0 : 100.0), 1.0,
            describe("%d of %d steps cross, %d touch, %d felt in the free, at most %.3g N, %.2g of "
                     "what is allowed",
                     n_crossing_, n_steps_, n_touching_, n_felt_free_, most_N_, worst_)};
    }

  private:
    static constexpr std::size_t kMostPairs = 4000;  // of triangles: as many are looked at
    static constexpr double kNearGaps = 16.0;
    static constexpr double kEnds_s = 0.0101;  // in which a force ends that nothing is near
    static constexpr double kRounding_J = 1.0e-9;

    void look(const ToolFelt& felt, double dt_s) {
        ++n_steps_;
        n_crossing_ += scene_.is_inside() ? 1 : 0;
        n_none_ += is_finite(felt.felt_W) && is_finite(scene_.god.pose_W()) ? 0 : 1;
        for (const ToolTouch& touch : scene_.god.touches()) {
            n_touching_ += touch.touches ? 1 : 0;
        }
        const double felt_N = felt.felt_W.force.norm();
        most_N_ = worse(most_N_, felt_N);
        if (!is_small_) {
            return;
        }
        const bool is_felt = felt_N > 1.0e-9 || felt.felt_W.torque.norm() > 1.0e-9;
        const bool is_away = is_felt && scene_.god.last_step().least_gap_m > near_m_ && is_far();
        away_s_ = is_away ? away_s_ + std::max(dt_s, 0.0) : 0.0;
        n_felt_free_ += away_s_ > kEnds_s ? 1 : 0;
    }
    // From all objects, by more than a tool may still be felt at.
    [[nodiscard]] bool is_far() const {
        for (std::size_t i = 0; i < scene_.objects.size(); ++i) {
            if (test::find_distance_m(scene_.objects[i], scene_.god.object_W(i), scene_.tool,
                                      scene_.god.pose_W()) <= near_m_) {
                return false;
            }
        }
        return true;
    }
    [[nodiscard]] double find_stretch_J(const Pose& handle) const {
        const Vector6 way = find_way(scene_.god.pose_W(), handle);
        return 0.5 * kGodStiffness_N_per_m *
               (way.head<3>().squaredNorm() + per_mass_m2_ * way.tail<3>().squaredNorm());
    }

    test::GodScene& scene_;
    double near_m_;
    double per_mass_m2_;
    double recovers_m_;
    bool is_small_ = true;
    double away_s_ = 0.0;  // felt with nothing near, in a row
    int n_steps_ = 0;
    int n_crossing_ = 0;
    int n_standing_ = 0;
    int n_touching_ = 0;
    int n_felt_free_ = 0;
    int n_none_ = 0;
    double most_N_ = 0.0;
    double worst_ = 0.0;
};

}  // namespace fulcrum::stability
