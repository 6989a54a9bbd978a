// A wall that a lesson declares, pressed by a simulated hand on a simulated arm, at hand or over the link: plan, loop, couplings and gates are those
// that `run` would make of the lesson.
//
// The hand rests 10 mm above the wall until the gate is open, comes down at the speed of its own spring and wants to be press_m inside. Judged as
// wall_trial.h does, by the arm's true place and the force that is sent; without the arm's dry friction, which would hide a vibration.
#pragma once

#include "haptics/coupling/virtual_coupling.h"
#include "haptics/device/arm/simulated_wam.h"
#include "haptics/device/simulated/simulated_arm.h"
#include "haptics/geometry/shape.h"
#include "haptics/loop/haptic_loop.h"
#include "runtime/scene/compile_plan.h"
#include "tests/support/link.h"
#include "tests/support/wall_trial.h"

#include <functional>
#include <memory>
#include <optional>
#include <stdexcept>

namespace fulcrum::test {

enum class TriedArm : unsigned char { desktop, wam };

struct DeclaredWall {
    double stiffness_N_per_m = 500.0;
    double damping_Ns_per_m = 9.5;
    double rate_Hz = 1000.0;
    VelocityMethod velocity = VelocityMethod::adaptive_window;
    TriedArm arm = TriedArm::desktop;
    HumanImpedance human = kFingertip;
    std::optional<double> link_delay_s{};  ///< each way; none: the arm is at hand
    double press_m = 0.004;
    bool is_spring =
        false;  ///< both ways, as a force of the lesson; the hand begins where it pulls to
    bool is_dry = false;      ///< with the desktop arm's own dry friction
    double hand_scale = 1.0;  ///< world metres a metre of the device
    double saturation_N =
        0.0;  ///< the most that it gives, even up to half of that; 0: an even spring
    std::function<void(HapticPlan&)>
        change{};  ///< for curves over a setting: of the plan, before it is used
};

struct DeclaredWallCourse {
    z_width::WallCourse wall;
    double excess_J = 0.0;    ///< most at a time, as the program's passivity stage counts it
    double given_J = 0.0;     ///< to the hand and not given back, largest of all times
    CouplingSettings felt{};  ///< of the plan
};

inline constexpr double kAboveWall_m = 0.01;

/// A lesson with that wall: the top of a block in the middle of the hand's reach.
[[nodiscard]] inline runtime::LessonDescription make_wall_lesson(const DeclaredWall& wall) {
    runtime::LessonDescription lesson;
    lesson.id = lesson.title = "wall";
    lesson.hand.rate_hz = wall.rate_Hz;
    lesson.hand.velocity = wall.velocity;
    lesson.hand.scale = wall.hand_scale;
    if (wall.is_spring) {
        lesson.forces.push_back({"hold",
                                 {.anchor_W = lesson.hand.centre_W,
                                  .stiffness_N_per_m = wall.stiffness_N_per_m,
                                  .damping_Ns_per_m = wall.damping_Ns_per_m},
                                 4});
        return lesson;
    }
    Material material;
    material.name = "wall";
    material.coupling = {.stiffness_N_per_m = wall.stiffness_N_per_m,
                         .damping_Ns_per_m = wall.damping_Ns_per_m};
    if (wall.saturation_N > 0.0) {
        material.coupling = saturate(
            material.coupling, 0.5 * wall.saturation_N / wall.stiffness_N_per_m, wall.saturation_N);
    }
    lesson.materials.push_back({material, {}, {}, 2});
    runtime::BodyDescription body;
    body.name = body.noun = "block";
    body.model = "box";
    body.radius_m = 0.2;
    body.solid = body.visible = true;
    body.position_W = lesson.hand.centre_W - Vector3(0.0, body.radius_m, 0.0);
    body.material = 0;
    body.line = 3;
    lesson.bodies.push_back(body);
    return lesson;
}

/// What `run` would make of it, or why it refuses.
[[nodiscard]] inline Expected<runtime::Plan> make_wall_plan(const DeclaredWall& wall,
                                                            const runtime::WallHolder& holder) {
    const auto load = [](const runtime::BodyDescription& body) {
        return make_box(Vector3::Constant(2.0 * body.radius_m))
            .and_then([](const TriangleMesh& box) { return CollisionMesh::create(box); });
    };
    runtime::PlanOptions options;
    options.holders = {holder};
    return runtime::compile_plan(make_wall_lesson(wall), options, load)
        .map([](runtime::Plan&& plan) {
            plan.haptic.expects_lesson = false;
            return std::move(plan);
        });
}

[[nodiscard]] inline bool may_be_declared(const DeclaredWall& wall) {
    return make_wall_plan(wall, {}).has_value();
}

/// The arm, the hand that holds it, the line to it where there is one, and the loop.
class DeclaredWallRig {
  public:
    /// `pull_m`: a spring pulls the hand up by so much, of the world.
    explicit DeclaredWallRig(const DeclaredWall& wall, double pull_m = 0.0) : wall_(wall) {
        if (wall.arm == TriedArm::wam) {
            SimulatedWamSettings settings;
            settings.grip.push = wall.human;
            wam_ = std::move(*SimulatedWam::create(settings, target_));
        } else {
            SimulatedArmSettings settings = make_desktop_arm();
            settings.human = wall.human;
            settings.dry_friction_N = wall.is_dry ? settings.dry_friction_N : 0.0;
            settings.start_D.y() = start_m();
            desktop_ = std::make_unique<SimulatedArm>(settings, target_);
        }
        seen_m_ = start_m();
        aim(start_m());
        if (wall.link_delay_s) {
            link(*wall.link_delay_s);
        }
        Device& felt = pair_ ? static_cast<Device&>(pair_->device) : arm();
        plan_ = make_wall_plan(
                    wall, runtime::make_wall_holder(
                              felt.traits(), pair_ ? pair_->device.status().round_trip_s : 0.0))
                    .value();
        if (wall.change) {
            wall.change(plan_.haptic);
        }
        ForceCommand command;  // of a session that has changed nothing
        command.fields[0].anchor_W =
            plan_.haptic.workspace.pose_WD.position + pull_m * Vector3::UnitY();
        channels_->command.publish(command);
        loop_ = std::make_unique<HapticLoop>(plan_.haptic, felt, *channels_);
    }

    void aim(double height_m) {
        HandTarget wanted;
        wanted.pose_D.position.y() = height_m;
        target_.publish(wanted);
    }
    /// Rests until the gate is open, and from then on wants to be press_m inside.
    void press() {
        run(plan_.haptic.safety.soft_start_s + 0.5);
        aim(-wall_.press_m);
    }
    /// One round of the loop, and, half a round later, of the arm's side.
    void step() {
        now_s_ += 1.0 / wall_.rate_Hz;
        loop_->step(now_s_);
        const double before_m = seen_m_;
        if (pair_) {
            pair_->now_s = now_s_;
            pair_->server.step(now_s_ + 0.5 / wall_.rate_Hz);
        }
        seen_m_ = height_m();
        given_J_ = std::max(given_J_ + sent_before_N_ * (seen_m_ - before_m), 0.0);
        sent_before_N_ = sent_N();
    }
    void run(double seconds) {
        for (long n = std::lround(seconds * wall_.rate_Hz); n > 0; --n) {
            step();
        }
    }
    [[nodiscard]] z_width::WallWindow run_window() {
        double low_m = HUGE_VAL, high_m = -HUGE_VAL, low_N = HUGE_VAL, high_N = -HUGE_VAL;
        double sum_m = 0.0, sum_N = 0.0;
        const long n = std::lround(z_width::kWindow_s * wall_.rate_Hz);
        for (long k = 0; k < n; ++k) {
            step();
            low_m = std::min(low_m, height_m());
            high_m = std::max(high_m, height_m());
            low_N = std::min(low_N, sent_N());
            high_N = std::max(high_N, sent_N());
            sum_m += height_m();
            sum_N += sent_N();
            most_J_ = std::max(most_J_, given_J_);
        }
        const double rounds = static_cast<double>(n);
        return {high_m - low_m, high_N - low_N, -sum_m / rounds, sum_N / rounds, false};
    }
    [[nodiscard]] CouplingSettings felt() const {
        if (wall_.is_spring) {
            const FieldPlan& spring = plan_.haptic.fields.front();
            return {.stiffness_N_per_m = spring.stiffness_N_per_m,
                    .damping_Ns_per_m = spring.damping_Ns_per_m};
        }
        return *plan_.haptic.solids.front().coupling;
    }
    [[nodiscard]] double height_m() const {
        return wam_ ? wam_->compute_pose_D().position.y() : desktop_->position_D().y();
    }
    /// Up, to the arm.
    [[nodiscard]] double sent_N() {
        return pair_ ? pair_->server.status().applied_D.force.y()
                     : loop_->state().applied_W.force.y();
    }
    [[nodiscard]] Device& arm() {
        return wam_ ? static_cast<Device&>(*wam_) : static_cast<Device&>(*desktop_);
    }
    [[nodiscard]] const HapticState& state() const { return loop_->state(); }
    [[nodiscard]] const HapticPlan& plan() const { return plan_.haptic; }
    [[nodiscard]] double most_given_J() const { return most_J_; }

  private:
    [[nodiscard]] double start_m() const { return wall_.is_spring ? 0.0 : kAboveWall_m; }
    // As `run` and `fulcrum arm` make them.
    void link(double delay_s) {
        LinkFaults faults;
        faults.delay_s = delay_s;
        ArmServerSettings server;
        server.handle_mass_kg = arm().traits().mass_kg;
        pair_ = std::make_unique<test_link::LinkPair>(arm(), faults, server);
        pair_->device.tell_limits(SafetySettings{});
        if (!pair_->link(3.0)) {
            throw std::runtime_error("the link does not stand");
        }
        now_s_ = pair_->now_s;
    }

    DeclaredWall wall_;
    runtime::Plan plan_;
    LatestValue<HandTarget> target_;
    std::unique_ptr<SimulatedArm> desktop_;
    std::unique_ptr<SimulatedWam> wam_;
    std::unique_ptr<test_link::LinkPair> pair_;
    std::unique_ptr<HapticChannels> channels_ = std::make_unique<HapticChannels>();
    std::unique_ptr<HapticLoop> loop_;
    double now_s_ = 0.0;
    double seen_m_ = 0.0;
    double sent_before_N_ = 0.0;
    double given_J_ = 0.0;
    double most_J_ = 0.0;
};

/// Until it is decided.
[[nodiscard]] inline DeclaredWallCourse press_declared_wall(const DeclaredWall& wall) {
    DeclaredWallRig rig(wall);
    rig.press();
    DeclaredWallCourse course;
    course.felt = rig.felt();
    z_width::WallTrial judged;
    judged.arm = make_desktop_arm();
    judged.stiffness_N_per_m = course.felt.stiffness_N_per_m;
    const z_width::WallJudge full(judged);
    z_width::WallJudge judge =
        wall.is_dry
            ? full
            : z_width::WallJudge(z_width::kCalmSteps * judged.arm.position_resolution_m, HUGE_VAL);
    constexpr double kLongest_s = 20.0;
    for (double s = 0.0; course.wall.verdict == z_width::WallVerdict::undecided;
         s += z_width::kWindow_s) {
        course.wall.last = rig.run_window();
        course.wall.verdict =
            s < kLongest_s ? judge.take(course.wall.last) : z_width::WallVerdict::unstable;
        course.wall.lasted_s = s;
    }
    course.excess_J = rig.state().force_energy.peak_J;
    course.given_J = rig.most_given_J();
    return course;
}

}  // namespace fulcrum::test
