#include "haptics/dynamics/joint.h"
#include "haptics/math/length.h"

#include <cmath>

namespace fulcrum {
namespace {

Expected<void> check_drive(const JointPlan& plan, const std::string& where) {
    const JointDrive& drive = plan.drive;
    const bool is_in_range = drive.lower <= 0.0 && drive.upper >= 0.0 &&
                             std::isfinite(drive.motor_speed) && drive.motor_force >= 0.0 &&
                             std::isfinite(drive.motor_force) && drive.friction >= 0.0 &&
                             std::isfinite(drive.friction);
    if (!is_in_range) {
        return fail(
            where + " has a limit on the wrong side of 0, or a motor or friction out of range", {},
            "give it a lower limit of 0 or less, an upper one of 0 or more, and forces of 0 or "
            "more");
    }
    const bool has_drive = drive.motor_force > 0.0 || drive.friction > 0.0 ||
                           std::isfinite(drive.lower) || std::isfinite(drive.upper);
    const bool has_axis = plan.kind == JointKind::hinge || plan.kind == JointKind::slider;
    if (has_drive && !has_axis) {
        return fail(where + " has limits, a motor or friction but no axis", {},
                    "make it a hinge or a slider");
    }
    return {};
}

}  // namespace

Expected<void> validate(const JointPlan& plan, std::int32_t n_bodies, const std::string& where) {
    const auto is_body = [&](std::int32_t i) { return i >= -1 && i < n_bodies; };
    if (!is_body(plan.body_a) || !is_body(plan.body_b) || plan.body_a == plan.body_b) {
        return fail(where + " does not join two bodies", {},
                    "name two different ones that are there, or -1 for the world");
    }
    if (!plan.anchor_W.allFinite() || !plan.other_anchor_W.allFinite() ||
        !plan.axis_W.allFinite() || !(plan.axis_W.squaredNorm() > 0.0)) {
        return fail(where + " has an anchor or axis that is none", {},
                    "give it finite ones, and an axis with a length");
    }
    if (plan.kind == JointKind::distance && plan.anchor_W == plan.other_anchor_W) {
        return fail(where + " is a rod without length", {},
                    "join the two points by a ball instead");
    }
    return check_drive(plan, where);
}

Joint make_joint(const JointPlan& plan, const Pose& a_W, const Pose& b_W) {
    Joint joint{.kind = plan.kind,
                .body_a = plan.body_a,
                .body_b = plan.body_b,
                .bodies_touch = plan.bodies_touch,
                .drive = plan.drive};
    const bool is_rod = plan.kind == JointKind::distance;
    const Quaternion along_axis = Quaternion::FromTwoVectors(Vector3::UnitX(), plan.axis_W);
    const Pose to_a = plan.body_a < 0 ? Pose{} : a_W.inverse();
    const Pose to_b = plan.body_b < 0 ? Pose{} : b_W.inverse();
    const Vector3& anchor_b_W = is_rod ? plan.other_anchor_W : plan.anchor_W;
    joint.frame_a = to_a * Pose{plan.anchor_W, along_axis};
    joint.frame_b = to_b * Pose{anchor_b_W, along_axis};
    joint.length_m = compute_length(Vector3(anchor_b_W - plan.anchor_W));
    JointRows rows;
    make_joint_rows(joint, a_W, b_W, 1.0, rows);
    joint.n_rows = rows.count;
    return joint;
}

}  // namespace fulcrum
