#include "tests/stability/cases/held_arm.h"

#include "haptics/collision/collision_mesh.h"
#include "haptics/geometry/shape.h"
#include "tests/support/wall_trial.h"

#include <cmath>
#include <stdexcept>

namespace fulcrum::stability {

HeldArm::HeldArm(const HapticPlan& plan, const SimulatedArmSettings& settings)
    : device_(settings, target_) {
    if (const auto checked = validate(plan, device_.traits()); !checked) {
        throw std::runtime_error(to_sentence(checked.error()));
    }
    if (const auto checked = validate(settings); !checked) {
        throw std::runtime_error(to_sentence(checked.error()));
    }
    loop_ = std::make_unique<HapticLoop>(plan, device_, *channels_);
    aim(settings.start_D.y());
    // Long enough for the gate to engage.
    run(0.1);
}

void HeldArm::step(double dt_s) {
    now_s_ += dt_s;
    command.stamp_s = now_s_;
    command.lesson_alive = true;
    channels_->command.publish(command);
    loop_->step(now_s_);
}

void HeldArm::run(double seconds) {
    for (int k = 0; k < static_cast<int>(std::lround(1000.0 * seconds)); ++k) {
        step();
    }
}

void HeldArm::aim_at(const Vector3& position_D) {
    HandTarget target;
    target.pose_D.position = position_D;
    target_.publish(target);
}

double measure_swing(const HapticPlan& plan, const HumanImpedance& human) {
    HeldArm held(plan, make_arm_over_floor(human));
    held.aim(-kFloorPress_m);
    held.run(10.0);
    std::array<Swing, 3> swings;
    for (int k = 0; k < 1000; ++k) {
        held.step();
        for (int axis = 0; axis < 3; ++axis) {
            swings[static_cast<std::size_t>(axis)].take(held.position_m()(axis));
        }
    }
    const double swing_m = worse(worse(swings[0].width(), swings[1].width()), swings[2].width());
    return swings[1].high < kEncoderStep_m ? swing_m : HUGE_VAL;
}

HapticPlan make_floor_plan() {
    const auto mesh = make_box(Vector3(2.0, 2.0, 2.0)).and_then([](const TriangleMesh& box) {
        return CollisionMesh::create(box);
    });
    if (!mesh) {
        throw std::runtime_error(to_sentence(mesh.error()));
    }
    HapticPlan plan;
    plan.expects_lesson = false;
    plan.safety.soft_start_s = 0.0;
    plan.solids.push_back(
        {.body = 0, .shape = *mesh, .initial_pose_W = Pose::at(Vector3(0.0, -1.0, 0.0))});
    return plan;
}

SimulatedArmSettings make_arm_over_floor(const HumanImpedance& human) {
    SimulatedArmSettings arm = make_desktop_arm();
    arm.human = human;
    arm.dry_friction_N = 0.0;
    arm.start_D = Vector3(0.013, 0.01, 0.017);
    return arm;
}

double find_stiffness_inside(const HumanImpedance& human, double damping) {
    z_width::WallTrial trial;
    trial.arm = make_arm_over_floor(human);
    trial.start_m = trial.arm.start_D.y();
    trial.damping_Ns_per_m = damping;
    trial.press_m = kFloorPress_m;
    return 0.9 * z_width::find_largest_stiffness(trial).value();
}

}  // namespace fulcrum::stability
