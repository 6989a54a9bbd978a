#include "haptics/device/arm/arm_dynamics.h"

namespace fulcrum {
namespace {

// Turning over linear, about the base's origin: a motion, or a force with its moment.
struct Spatial {
    Vector3 turning{Vector3::Zero()};
    Vector3 linear{Vector3::Zero()};
};

// These are called some forty times a step: inline, for the compiler's own measure leaves them out of line.
inline void add(Spatial& sum, const Spatial& other, double factor) noexcept {
    sum.turning += factor * other.turning;
    sum.linear += factor * other.linear;
}

inline double dot(const Spatial& motion, const Spatial& force) noexcept {
    return motion.turning.dot(force.turning) + motion.linear.dot(force.linear);
}

// I V: momentum, moment about the base's origin over linear.
inline Spatial multiply(const SpatialInertia& inertia, const Spatial& motion) noexcept {
    return {inertia.turning_kg_m2 * motion.turning + inertia.moment_kg_m.cross(motion.linear),
            inertia.mass_kg * motion.linear + motion.turning.cross(inertia.moment_kg_m)};
}

// V x S of two motions.
inline Spatial cross_motion(const Spatial& v, const Spatial& s) noexcept {
    return {v.turning.cross(s.turning), v.turning.cross(s.linear) + v.linear.cross(s.turning)};
}

// V x* F of a motion and a force.
inline Spatial cross_force(const Spatial& v, const Spatial& f) noexcept {
    return {v.turning.cross(f.turning) + v.linear.cross(f.linear), v.turning.cross(f.linear)};
}

inline Spatial make_axis(const ArmPosture& posture, int joint) noexcept {
    const Vector3 axis = posture.axis_B(joint);
    return {axis, posture.origin_B[static_cast<std::size_t>(joint)].cross(axis)};
}

using Axes = std::array<Spatial, kMostJoints>;

void make_axes(const ArmPosture& posture, Axes& axes) noexcept {
    for (int i = 0; i < posture.n; ++i) {
        axes[static_cast<std::size_t>(i)] = make_axis(posture, i);
    }
}

// Adds a body's inertia about the base's origin, by Steiner's theorem, to that about its centre.
inline void move_to_origin(const Vector3& centre, SpatialInertia& inertia) noexcept {
    const Vector3 moment = inertia.mass_kg * centre;
    inertia.moment_kg_m = moment;
    inertia.turning_kg_m2 -= moment * centre.transpose();
    inertia.turning_kg_m2.diagonal() += Vector3::Constant(moment.dot(centre));
}

inline void add(SpatialInertia& sum, const SpatialInertia& other) noexcept {
    sum.mass_kg += other.mass_kg;
    sum.moment_kg_m += other.moment_kg_m;
    sum.turning_kg_m2 += other.turning_kg_m2;
}

// Newton-Euler out along the arm and back. Without `a` the joints do not accelerate.
JointVector run_newton_euler(const ArmPosture& posture, const ArmBodies& bodies,
                             const JointVector& v, const JointVector* a) noexcept {
    Axes axes;
    make_axes(posture, axes);
    std::array<Spatial, kMostJoints> forces;
    Spatial motion;
    Spatial acceleration;
    for (int i = 0; i < posture.n; ++i) {
        const auto at = static_cast<std::size_t>(i);
        add(motion, axes[at], v(i));
        add(acceleration, cross_motion(motion, axes[at]), v(i));
        if (a != nullptr) {
            add(acceleration, axes[at], (*a)(i));
        }
        forces[at] = multiply(bodies.links[at], acceleration);
        add(forces[at], cross_force(motion, multiply(bodies.links[at], motion)), 1.0);
    }
    JointVector torque(posture.n);
    Spatial behind;
    for (int i = posture.n - 1; i >= 0; --i) {
        const auto at = static_cast<std::size_t>(i);
        add(behind, forces[at], 1.0);
        torque(i) = dot(axes[at], behind);
    }
    return torque;
}

}  // namespace

void compute_bodies(const ArmModel& model, const ArmPosture& posture, const HeldMass& held,
                    ArmBodies& bodies) noexcept {
    for (int i = 0; i < model.n; ++i) {
        const auto at = static_cast<std::size_t>(i);
        const ArmLink& link = model.links[at];
        const Matrix3& turn_B = posture.turn_B[at + 1];
        SpatialInertia& body = bodies.links[at];
        body.mass_kg = link.mass_kg;
        Matrix3 turned;
        turned = turn_B * link.inertia_kg_m2;
        body.turning_kg_m2 = turned * turn_B.transpose();
        move_to_origin(posture.origin_B[at + 1] + turn_B * link.centre_m, body);
    }
    SpatialInertia hand{held.mass_kg, Vector3::Zero(), held.inertia_kg_m2 * Matrix3::Identity()};
    move_to_origin(posture.handle_B.position, hand);
    add(bodies.links[static_cast<std::size_t>(model.n - 1)], hand);
}

JointMatrix compute_joint_inertia(const ArmPosture& posture, const ArmBodies& bodies,
                                  const JointMatrix& rotors) noexcept {
    JointMatrix inertia = rotors;
    Axes axes;
    make_axes(posture, axes);
    SpatialInertia behind;
    for (int i = posture.n - 1; i >= 0; --i) {
        const auto at = static_cast<std::size_t>(i);
        add(behind, bodies.links[at]);
        const Spatial force = multiply(behind, axes[at]);
        inertia.coeffRef(i, i) += dot(axes[at], force);
        for (int j = 0; j < i; ++j) {
            const double coupled = dot(axes[static_cast<std::size_t>(j)], force);
            inertia.coeffRef(j, i) += coupled;
            inertia.coeffRef(i, j) += coupled;
        }
    }
    return inertia;
}

JointVector compute_inverse_dynamics(const ArmPosture& posture, const ArmBodies& bodies,
                                     const JointMatrix& rotors, const JointVector& v,
                                     const JointVector& a) noexcept {
    JointVector torque = run_newton_euler(posture, bodies, v, &a);
    torque += multiply(rotors, a);
    return torque;
}

JointVector compute_motion_torque(const ArmPosture& posture, const ArmBodies& bodies,
                                  const JointVector& v) noexcept {
    return run_newton_euler(posture, bodies, v, nullptr);
}

JointVector compute_weight_torque(const ArmModel& model, const ArmPosture& posture) noexcept {
    JointVector torque(model.n);
    double mass_kg = 0.0;
    Vector3 moment_kg_m = Vector3::Zero();
    for (int i = model.n - 1; i >= 0; --i) {
        const auto at = static_cast<std::size_t>(i);
        const ArmLink& link = model.links[at];
        mass_kg += link.mass_kg;
        moment_kg_m +=
            link.mass_kg * (posture.origin_B[at + 1] + posture.turn_B[at + 1] * link.centre_m);
        // The weight of all that lies behind the joint, about its axis.
        const Vector3 lever_kg_m = moment_kg_m - mass_kg * posture.origin_B[at];
        torque(i) = -posture.axis_B(i).dot(lever_kg_m.cross(model.gravity_B));
    }
    return torque;
}

}  // namespace fulcrum
