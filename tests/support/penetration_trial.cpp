#include "tests/support/penetration_trial.h"

#include "haptics/geometry/shape.h"
#include "haptics/math/rotation.h"
#include "haptics/voxel/voxelise.h"

#include <array>
#include <memory>
#include <random>
#include <utility>
#include <vector>

namespace fulcrum::test {
namespace {

constexpr double kVoxel_m = 0.005;
constexpr double kDt_s = 0.001;
constexpr double kMass_kg = 0.012;
constexpr double kMost_N = 15.0;  // that the device gives
constexpr double kArm_kg = 0.25;
constexpr double kArm_N_per_m = 150.0;
constexpr double kArm_Ns_per_m = 12.0;  // critical
constexpr double kReach_m = 0.16;       // the hand's targets lie within this of the middle

void add_box(const Vector3& size_m, const Vector3& middle, std::vector<Vector3>& corners,
             std::vector<TriangleCorners>& triangles) {
    const TriangleMesh box = make_box(size_m).value();
    const auto first = static_cast<std::int32_t>(corners.size());
    for (const Vector3& corner : box.vertices_B()) {
        corners.emplace_back(corner + middle);
    }
    for (const auto& [a, b, c] : box.triangles()) {
        triangles.push_back({a + first, b + first, c + first});
    }
}

// A plate and two beams with room for the tool between them: gaps that it does not fit are wedges, of which the paper has no
// count.
TriangleMesh make_scaffold() {
    std::vector<Vector3> corners;
    std::vector<TriangleCorners> triangles;
    add_box({0.5, 0.02, 0.5}, {0.0, -0.15, 0.0}, corners, triangles);
    add_box({0.5, 0.04, 0.04}, {0.0, 0.15, 0.0}, corners, triangles);
    add_box({0.04, 0.04, 0.5}, {0.16, 0.0, 0.0}, corners, triangles);
    return TriangleMesh::build(std::move(corners), std::move(triangles)).value();
}

VoxelTool make_tool(const PenetrationTrial& trial) {
    const auto grid = std::make_shared<const VoxelGrid>(
        voxelise(make_scaffold(), {.voxel_m = kVoxel_m, .offset_layers = 2, .proximity_layers = 1})
            .value());
    const TriangleMesh ring = make_torus(0.0275, 0.01, 48, 24).value();
    VoxelSamplingSettings sampling;
    sampling.stiffness_N_per_m = 2000.0;
    sampling.braking = trial.braking;
    // Explicit steps bear M/dt = 12 Ns/m in all; some tens of points brake at once.
    sampling.braking_Ns_per_m = 0.2;
    sampling.cycle_s = kDt_s;
    VoxelToolSettings settings;
    settings.coupling.shift.stiffness_N_per_m = 600.0;
    settings.coupling.turn.stiffness_Nm_per_rad = 0.02;
    settings.integrator.integrator = Integrator::semi_implicit_euler;
    settings.lead_clamped = trial.lead_clamped;
    settings.swept = false;  // the source looks at the ends of steps alone
    settings.inertia = make_ball_inertia(kMass_kg, 0.0375);
    return VoxelTool::build(
               {grid, nullptr, make_voxel_pointshell(ring, kVoxel_m).value(), sampling}, settings)
        .value();
}

// A hand that goes from target to target, each sweep at its own speed, smoothly at both ends; the arm between its wish and the
// handle is a mass on a spring, so that what it feels holds it back.
class Hand {
  public:
    Hand(unsigned seed, double fastest_m_per_s) : random_(seed), fastest_m_per_s_(fastest_m_per_s) {
        choose();
    }
    MovingFrame next(const Vector3& felt_N) {
        share_ += kDt_s / duration_s_;
        if (share_ >= 1.0) {
            choose();
        }
        // 3 t^2 - 2 t^3 and its slope.
        const double way = share_ * share_ * (3.0 - 2.0 * share_);
        const double rate = 6.0 * share_ * (1.0 - share_) / duration_s_;
        const Vector3 wish = from_ + way * (to_ - from_);
        const Vector3 wish_velocity = rate * (to_ - from_);
        const double force = felt_N.norm();
        const Vector3 felt = force > kMost_N ? Vector3(felt_N * (kMost_N / force)) : felt_N;
        velocity_ +=
            kDt_s / kArm_kg *
            (kArm_N_per_m * (wish - place_) + kArm_Ns_per_m * (wish_velocity - velocity_) + felt);
        place_ += kDt_s * velocity_;
        const Vector3 turn = from_turn_ + way * (to_turn_ - from_turn_);
        return {{place_, compute_exp(turn)},
                {velocity_, compute_left_jacobian(turn) * (rate * (to_turn_ - from_turn_))}};
    }

  private:
    void choose() {
        from_ = std::exchange(to_, kReach_m * draw());
        from_turn_ = std::exchange(to_turn_, 0.8 * draw());
        const double speed = fastest_m_per_s_ * (0.6 + 0.4 * unit_(random_));
        duration_s_ = 1.5 * (to_ - from_).norm() / speed + 10.0 * kDt_s;
        share_ = 0.0;
    }
    Vector3 draw() {
        const double x = unit_(random_);
        const double y = unit_(random_);
        return {x, y, unit_(random_)};
    }

    std::mt19937 random_;
    std::uniform_real_distribution<double> unit_{-1.0, 1.0};
    double fastest_m_per_s_;
    Vector3 from_{Vector3::Zero()}, to_{Vector3::Zero()};
    Vector3 place_{Vector3::Zero()}, velocity_{Vector3::Zero()};
    Vector3 from_turn_{Vector3::Zero()}, to_turn_{Vector3::Zero()};
    double duration_s_ = 1.0;
    double share_ = 0.0;
};

}  // namespace

PenetrationCount run_penetration_trial(const PenetrationTrial& trial) {
    // So long past the layer, the tool has gone through: it is put back into the free middle.
    constexpr int kThrough_frames = 100;
    VoxelTool tool = make_tool(trial);
    Hand hand(trial.seed, trial.fastest_m_per_s);
    tool.place(Pose{});
    PenetrationCount count;
    int in_a_row = 0;
    Vector3 felt = Vector3::Zero();
    for (int frame = 1; frame <= trial.n_frames; ++frame) {
        const VoxelToolResult result = tool.step(hand.next(felt), {}, frame * kDt_s, kDt_s);
        felt = result.felt_W.force;
        const bool penetrated = result.contact.n_interior > 0;
        count.n_penetrations += penetrated ? 1 : 0;
        count.n_contacts += penetrated || result.contact.n_surface > 0 ? 1 : 0;
        in_a_row = penetrated ? in_a_row + 1 : 0;
        if (in_a_row == kThrough_frames) {
            ++count.n_passed;
            tool.place(Pose{});
            in_a_row = 0;
        }
    }
    return count;
}

}  // namespace fulcrum::test
