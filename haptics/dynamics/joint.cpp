#include "haptics/dynamics/joint.h"

#include "haptics/math/length.h"
#include "haptics/math/rotation.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace fulcrum {
namespace {

constexpr double kEndless = std::numeric_limits<double>::infinity();

// Anchors and axes in the world.
struct PlacedJoint {
    Pose a;  // of the joint's frame on a
    Pose b;
    Vector3 arm_a;
    Vector3 arm_b;
    Vector3 apart;  // from a's anchor to b's
    Vector3 turn;   // from a's frame to b's, a rotation vector
};

PlacedJoint place_joint(const Joint& joint, const Pose& a_W, const Pose& b_W) noexcept {
    PlacedJoint placed;
    placed.a = a_W * joint.frame_a;
    placed.b = b_W * joint.frame_b;
    placed.arm_a = placed.a.position - a_W.position;
    placed.arm_b = placed.b.position - b_W.position;
    placed.apart = placed.b.position - placed.a.position;
    placed.turn = compute_log(placed.b.orientation * placed.a.orientation.conjugate());
    return placed;
}

class RowWriter {
  public:
    RowWriter(const Joint& joint, const PlacedJoint& placed, JointRows& rows) noexcept
        : joint_(joint), placed_(placed), rows_(rows) {}

    /// The anchors stay together along e; a's arm goes to b's anchor, as the axis does that turns with a.
    void add_along(const Vector3& e, double error) noexcept {
        const Vector3 arm_a = placed_.arm_a + placed_.apart;
        add(e, arm_a.cross(e), placed_.arm_b.cross(e), error, -kEndless, kEndless);
    }
    void add_about(const Vector3& e, double error) noexcept {
        add(Vector3::Zero(), e, e, error, -kEndless, kEndless);
    }
    /// Along the free axis e, with bounds of the impulse.
    void add_drive(const Vector3& e, double target, double error, double least,
                   double most) noexcept {
        if (joint_.kind == JointKind::hinge) {
            add(Vector3::Zero(), e, e, error, least, most);
        } else {
            add(e, (placed_.arm_a + placed_.apart).cross(e), placed_.arm_b.cross(e), error, least,
                most);
        }
        rows_.rows[static_cast<std::size_t>(rows_.count - 1)].target = target;
    }

  private:
    void add(const Vector3& linear, const Vector3& turn_a, const Vector3& turn_b, double error,
             double least, double most) noexcept {
        const auto i = static_cast<std::size_t>(rows_.count++);
        RowConstraint& row = rows_.rows[i];
        row = {};
        row.jacobian_a << -linear, -turn_a;
        row.jacobian_b << linear, turn_b;
        row.least = least;
        row.most = most;
        row.impulse = joint_.impulses[i];
        rows_.errors[i] = error;
    }

    const Joint& joint_;
    const PlacedJoint& placed_;
    JointRows& rows_;
};

void add_point_rows(const PlacedJoint& placed, RowWriter& writer) noexcept {
    for (int axis = 0; axis < 3; ++axis) {
        writer.add_along(Vector3::Unit(axis), placed.apart[axis]);
    }
}

// Of a turn about what: e . (axis_a x axis_b) is the angle by which b's axis has left a's about e.
void add_hinge_rows(const PlacedJoint& placed, RowWriter& writer) noexcept {
    const Matrix3 axes = placed.a.orientation.toRotationMatrix();
    const Vector3 left = axes.col(0).cross(placed.b.orientation * Vector3::UnitX());
    writer.add_about(axes.col(1), axes.col(1).dot(left));
    writer.add_about(axes.col(2), axes.col(2).dot(left));
}

void add_turn_rows(const PlacedJoint& placed, RowWriter& writer) noexcept {
    for (int axis = 0; axis < 3; ++axis) {
        writer.add_about(Vector3::Unit(axis), placed.turn[axis]);
    }
}

void add_slider_rows(const PlacedJoint& placed, RowWriter& writer) noexcept {
    const Matrix3 axes = placed.a.orientation.toRotationMatrix();
    writer.add_along(axes.col(1), axes.col(1).dot(placed.apart));
    writer.add_along(axes.col(2), axes.col(2).dot(placed.apart));
    add_turn_rows(placed, writer);
}

double find_travel(const Joint& joint, const PlacedJoint& placed) noexcept {
    if (joint.kind == JointKind::slider) {
        return (placed.a.orientation * Vector3::UnitX()).dot(placed.apart);
    }
    if (joint.kind == JointKind::hinge) {
        const Quaternion turn = placed.a.orientation.conjugate() * placed.b.orientation;
        const double half_rad = std::atan2(turn.x(), turn.w());
        constexpr double kTurn_rad = 2.0 * std::numbers::pi;
        return joint.travel + std::remainder(2.0 * half_rad - joint.travel, kTurn_rad);
    }
    return 0.0;
}

// One row for motor and friction together: at the motor's speed friction takes what the motor has to give more.
void add_motor_row(const JointDrive& drive, const Vector3& axis, double dt_s,
                   RowWriter& writer) noexcept {
    const bool has_motor = drive.motor_force > 0.0;
    const double most = dt_s * (has_motor ? drive.motor_force : drive.friction);
    writer.add_drive(axis, has_motor ? drive.motor_speed : 0.0, 0.0, -most, most);
}

void add_limit_rows(const JointDrive& drive, double travel, const Vector3& axis, double dt_s,
                    RowWriter& writer) noexcept {
    if (std::isfinite(drive.lower)) {
        const double over = travel - drive.lower;
        writer.add_drive(axis, -std::max(over, 0.0) / dt_s, std::min(over, 0.0), 0.0, kEndless);
    }
    if (std::isfinite(drive.upper)) {
        const double under = drive.upper - travel;
        writer.add_drive(axis, std::max(under, 0.0) / dt_s, -std::min(under, 0.0), -kEndless, 0.0);
    }
}

}  // namespace

void make_joint_rows(const Joint& joint, const Pose& a_W, const Pose& b_W, double dt_s,
                     JointRows& rows) noexcept {
    rows.count = 0;
    const PlacedJoint placed = place_joint(joint, a_W, b_W);
    RowWriter writer(joint, placed, rows);
    switch (joint.kind) {
        case JointKind::ball:
            return add_point_rows(placed, writer);
        case JointKind::fixed:
            add_point_rows(placed, writer);
            return add_turn_rows(placed, writer);
        case JointKind::distance: {
            const Vector3 along = compute_direction(placed.apart);
            return writer.add_along(along, compute_length(placed.apart) - joint.length_m);
        }
        case JointKind::hinge:
            add_point_rows(placed, writer);
            add_hinge_rows(placed, writer);
            break;
        case JointKind::slider:
            add_slider_rows(placed, writer);
            break;
    }
    const Vector3 axis = placed.a.orientation * Vector3::UnitX();
    if (joint.drive.motor_force > 0.0 || joint.drive.friction > 0.0) {
        add_motor_row(joint.drive, axis, dt_s, writer);
    }
    add_limit_rows(joint.drive, find_travel(joint, placed), axis, dt_s, writer);
}

double compute_joint_travel(const Joint& joint, const Pose& a_W, const Pose& b_W) noexcept {
    return find_travel(joint, place_joint(joint, a_W, b_W));
}

}  // namespace fulcrum
