#include "haptics/device/arm/arm_reach.h"

#include "haptics/base/range.h"
#include "haptics/device/arm/cholesky.h"
#include "haptics/math/dense.h"
#include "haptics/math/rotation.h"

#include <algorithm>
#include <limits>
#include <string>
#include <vector>

namespace fulcrum {
namespace {

constexpr double kBetweenSamples = 0.85;
constexpr double kReached = 1.0e-6;  // metres and radians
constexpr int kMostSteps = 200;
constexpr double kDamping_per_kg = 1.0e-9;  // of the inverse: finite where the arm is straight
constexpr double kFullTurn_rad = 6.283185307179586;

struct Sample {
    ArmPosture posture;
    JointMatrix inertia;   // L of L L^T in its lower half
    HandleJacobian eased;  // (L^-1 J^T)^T, whose square is the handle's mobility
};

// Home, with the dynamics of the place.
Sample make_sample(const ArmModel& model, const JointVector& q) {
    Sample sample;
    compute_posture(model, q, sample.posture);
    ArmBodies bodies;
    compute_bodies(model, sample.posture, HeldMass{}, bodies);
    sample.inertia = compute_joint_inertia(sample.posture, bodies, compute_rotor_inertia(model));
    factor_cholesky(sample.inertia);
    sample.eased = sample.posture.jacobian_B;
    solve_lower(sample.inertia, sample.eased);
    return sample;
}

// The joints' way to `aim`: the handle's error away, what is left of the joints' way home.
bool reach(const ArmModel& model, const JointVector& home, const Pose& aim, JointVector& q) {
    for (int step = 0; step < kMostSteps; ++step) {
        const Sample at = make_sample(model, q);
        Vector6 error;
        error << aim.position - at.posture.handle_B.position,
            compute_log(aim.orientation * at.posture.handle_B.orientation.conjugate());
        const Matrix6 mobility =
            at.eased * at.eased.transpose() + kDamping_per_kg * Matrix6::Identity();
        const JointVector back = home - q;
        const Vector6 wrench = solve_cholesky(mobility, error - compute_motion_B(at.posture, back));
        JointVector move(model.n);
        for (Index i = 0; i < model.n; ++i) {
            move(i) = at.posture.jacobian_B.col(i).dot(wrench);
        }
        solve_cholesky(at.inertia, move);
        move += back;
        // Far aims are walked to in small steps, for the Jacobian holds near by only.
        const double longest = move.cwiseAbs().maxCoeff();
        constexpr double kLongestStep_rad = 0.2;
        q += move * std::min(1.0, kLongestStep_rad / std::max(longest, kLongestStep_rad));
        for (int i = 0; i < model.n; ++i) {
            const ArmLink& link = model.links[static_cast<std::size_t>(i)];
            q(i) = std::clamp(q(i), link.low_rad, link.high_rad);
        }
        if (error.cwiseAbs().maxCoeff() < kReached && longest < kReached) {
            return true;
        }
    }
    return false;
}

// Places and turns at the workspace's rim, and its middle.
std::vector<Pose> make_aims(const Pose& home, const ArmWorkspace& workspace) {
    std::vector<Vector3> ways{Vector3::Zero()};
    for (const double x : {-1.0, 0.0, 1.0}) {
        for (const double y : {-1.0, 0.0, 1.0}) {
            for (const double z : {-1.0, 0.0, 1.0}) {
                const Vector3 way(x, y, z);
                if (way.squaredNorm() == 1.0 || way.squaredNorm() == 3.0) {
                    ways.push_back(way.normalized());
                }
            }
        }
    }
    std::vector<Pose> aims;
    for (const Vector3& place : ways) {
        for (std::size_t turn = 0; turn < ways.size(); ++turn) {
            // The eight corners of the turns add nothing that their six axes and the corners of places do not show.
            if (ways[turn].cwiseAbs().maxCoeff() != 0.0 && ways[turn].cwiseAbs().maxCoeff() < 1.0) {
                continue;
            }
            aims.push_back({home.position + workspace.radius_m * place,
                            compute_exp(workspace.tilt_rad * ways[turn]) * home.orientation});
        }
    }
    return aims;
}

// What motor k turns the handle by, a radian of its own: J T^-1, column k.
Vector6 compute_motor_column(const ArmPosture& posture, const JointMatrix& joint_per_motor, int k) {
    Vector6 column = Vector6::Zero();
    for (Index i = 0; i < joint_per_motor.rows(); ++i) {
        column += posture.jacobian_B.col(i) * joint_per_motor(i, k);
    }
    return column;
}

void take_worst(const ArmModel& model, const Sample& at, const JointMatrix& joint_per_motor,
                ArmReach& worst) {
    const JointVector weight =
        multiply(joint_per_motor.transpose(), compute_weight_torque(model, at.posture));
    Matrix3 yield = Matrix3::Zero();
    for (int k = 0; k < model.n; ++k) {
        const auto place = static_cast<std::size_t>(k);
        // By the transposed Jacobian the same column says what the motor gives for a wrench; half of its room is promised.
        const Vector6 column = compute_motor_column(at.posture, joint_per_motor, k);
        const double linear = column.head<3>().norm();
        const double turning = column.tail<3>().norm();
        const ArmMotor& motor = model.motors[place];
        const double room = std::max(motor.max_torque_Nm - std::abs(weight(k)), 0.0);
        if (linear > 0.0) {
            worst.force_N = std::min(worst.force_N, 0.5 * room / linear);
        }
        if (turning > 0.0) {
            worst.torque_Nm = std::min(worst.torque_Nm, 0.5 * room / turning);
        }
        if (motor.counts_per_turn > 0.0) {
            worst.step_m = std::max(worst.step_m, linear * kFullTurn_rad / motor.counts_per_turn);
        }
        const Vector3 row = at.posture.jacobian_B.col(k).head<3>();
        yield += row * row.transpose() / model.links[place].damping_Nms_per_rad;
    }
    worst.damping_Ns_per_m =
        std::min(worst.damping_Ns_per_m, 1.0 / compute_symmetric_axes(yield).values.maxCoeff());
}

Expected<void> check(const ArmModel& model, const ArmWorkspace& workspace) {
    const Range ranges[] = {{"radius_m", workspace.radius_m, 0.01, 0.5},
                            {"tilt_rad", workspace.tilt_rad, 0.0, 1.0}};
    if (auto checked = check_ranges("the arm's workspace's", ranges); !checked) {
        return checked;
    }
    if (workspace.home_rad.size() != model.n) {
        return fail("the arm's home posture has " + std::to_string(workspace.home_rad.size()) +
                        " angles for " + std::to_string(model.n) + " joints",
                    {}, "give one a joint");
    }
    for (int i = 0; i < model.n; ++i) {
        const ArmLink& link = model.links[static_cast<std::size_t>(i)];
        const Range range[] = {
            {"angle " + std::to_string(i + 1), workspace.home_rad(i), link.low_rad, link.high_rad}};
        if (auto checked = check_ranges("the arm's home posture's", range); !checked) {
            return checked;
        }
    }
    return {};
}

}  // namespace

Expected<ArmReach> compute_reach(const ArmModel& model, const ArmWorkspace& workspace) {
    if (auto checked = check(model, workspace); !checked) {
        return tl::unexpected<Error>(checked.error());
    }
    const JointMatrix joint_per_motor = compute_joint_per_motor(model);
    const Sample home = make_sample(model, workspace.home_rad);
    constexpr double kInfinite = std::numeric_limits<double>::infinity();
    ArmReach worst{kInfinite, kInfinite, kInfinite, 0.0, 0.0};
    for (const Pose& aim : make_aims(home.posture.handle_B, workspace)) {
        JointVector q = workspace.home_rad;
        if (!reach(model, workspace.home_rad, aim, q)) {
            return fail("the arm cannot reach all of its workspace", {},
                        "make the workspace smaller, or move its home posture");
        }
        take_worst(model, make_sample(model, q), joint_per_motor, worst);
    }
    if (worst.force_N == 0.0 || worst.torque_Nm == 0.0) {
        return fail("the arm's motors cannot carry its own weight in all of its workspace", {},
                    "make the workspace smaller, or move its home posture");
    }
    worst.force_N *= kBetweenSamples;
    worst.torque_Nm *= kBetweenSamples;
    worst.damping_Ns_per_m *= kBetweenSamples;
    worst.mass_kg = 3.0 / home.eased.topRows<3>().squaredNorm();
    return worst;
}

}  // namespace fulcrum
