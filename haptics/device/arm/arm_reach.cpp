#include "haptics/device/arm/arm_reach.h"

#include "haptics/base/range.h"
#include "haptics/math/rotation.h"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
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

using Matrix = Eigen::MatrixXd;
using Vector = Eigen::VectorXd;

struct Sample {
    ArmPosture posture;
    Matrix inertia;
};

// Home, with the dynamics of the place.
Sample make_sample(const ArmModel& model, const JointVector& q) {
    Sample sample;
    compute_posture(model, q, sample.posture);
    ArmBodies bodies;
    compute_bodies(model, sample.posture, HeldMass{}, bodies);
    sample.inertia = compute_joint_inertia(sample.posture, bodies, compute_rotor_inertia(model));
    return sample;
}

// The joints' way to `aim`: the handle's error away, what is left of the joints' way home.
bool reach(const ArmModel& model, const JointVector& home, const Pose& aim, JointVector& q) {
    for (int step = 0; step < kMostSteps; ++step) {
        const Sample at = make_sample(model, q);
        Vector6 error;
        error << aim.position - at.posture.handle_B.position,
            compute_log(aim.orientation * at.posture.handle_B.orientation.conjugate());
        const Matrix jacobian = at.posture.jacobian_B;
        const Matrix response = at.inertia.llt().solve(jacobian.transpose());
        const Matrix mobility = jacobian * response + kDamping_per_kg * Matrix::Identity(6, 6);
        const Vector back = home - q;
        const Vector move = back + response * mobility.llt().solve(Vector(error - jacobian * back));
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

// What the motors leave for one part of the wrench: half of their room.
double compute_promise(const ArmModel& model, const Vector& weight,
                       const Matrix& motor_per_wrench) {
    double promise = std::numeric_limits<double>::infinity();
    for (int k = 0; k < model.n; ++k) {
        const double most = model.motors[static_cast<std::size_t>(k)].max_torque_Nm;
        const double room = std::max(most - std::abs(weight(k)), 0.0);
        const double asked = motor_per_wrench.row(k).norm();
        if (asked > 0.0) {
            promise = std::min(promise, 0.5 * room / asked);
        }
    }
    return promise;
}

double compute_least_damping(const ArmModel& model, const Matrix& rows) {
    Vector per_damping(model.n);
    for (int i = 0; i < model.n; ++i) {
        per_damping(i) = 1.0 / model.links[static_cast<std::size_t>(i)].damping_Nms_per_rad;
    }
    const Matrix3 yield = rows * per_damping.asDiagonal() * rows.transpose();
    return 1.0 / Eigen::SelfAdjointEigenSolver<Matrix3>(yield).eigenvalues().maxCoeff();
}

double compute_largest_step(const ArmModel& model, const Matrix& rows,
                            const Matrix& joint_per_motor) {
    double step_m = 0.0;
    for (int k = 0; k < model.n; ++k) {
        const double counts = model.motors[static_cast<std::size_t>(k)].counts_per_turn;
        if (counts > 0.0) {
            step_m =
                std::max(step_m, (rows * joint_per_motor.col(k)).norm() * kFullTurn_rad / counts);
        }
    }
    return step_m;
}

void take_worst(const ArmModel& model, const Sample& at, const Matrix& joint_per_motor,
                ArmReach& worst) {
    const Matrix motor_per_joint = joint_per_motor.transpose();
    const Matrix rows = at.posture.jacobian_B.topRows<3>();
    const Matrix turns = at.posture.jacobian_B.bottomRows<3>();
    const Vector weight = motor_per_joint * compute_weight_torque(model, at.posture);
    worst.force_N =
        std::min(worst.force_N, compute_promise(model, weight, motor_per_joint * rows.transpose()));
    worst.torque_Nm = std::min(worst.torque_Nm,
                               compute_promise(model, weight, motor_per_joint * turns.transpose()));
    worst.damping_Ns_per_m = std::min(worst.damping_Ns_per_m, compute_least_damping(model, rows));
    worst.step_m = std::max(worst.step_m, compute_largest_step(model, rows, joint_per_motor));
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
    const Matrix joint_per_motor = compute_joint_per_motor(model);
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
    const Matrix rows = home.posture.jacobian_B.topRows<3>();
    worst.mass_kg = 3.0 / (rows * home.inertia.llt().solve(rows.transpose())).trace();
    return worst;
}

}  // namespace fulcrum
