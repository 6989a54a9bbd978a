// What a contact problem is made of: bodies, contacts and rows between them. Its law stands in contact_problem.h.
#pragma once

#include "haptics/math/wrench_jacobian.h"

namespace fulcrum {

/// What is not moved by any impulse; a surface of it that moves is a target.
inline constexpr int kGround = -1;

struct ConstrainedBody {
    double mass_kg = 1.0;                            ///< more than 0, finite
    Matrix3 inertia_W{Matrix3::Identity()};          ///< kg m^2 about the centre of mass
    Matrix3 inverse_inertia_W{Matrix3::Identity()};  ///< filled in by `add_body`
    Vector6 free_velocity_W{Vector6::Zero()};        ///< m/s of the centre of mass, rad/s
    Vector6 velocity_W{Vector6::Zero()};             ///< the answer
};

/// One point. a and b differ; at most one is the ground.
struct ContactConstraint {
    int body_a = kGround;
    int body_b = kGround;
    Vector3 arm_a{Vector3::Zero()};       ///< metres, from a's centre of mass to the point, in W
    Vector3 arm_b{Vector3::Zero()};       ///< the same of b
    Matrix3 axes_W{Matrix3::Identity()};  ///< columns: unit normal from a to b, two tangents
    double static_friction = 0.0;
    double dynamic_friction = 0.0;            ///< at most the static coefficient
    Vector3 target_m_per_s{Vector3::Zero()};  ///< least along the normal; that of the surface
    double softness_per_kg = 0.0;             ///< R, 0 or more: rigid at 0
    double restitution = 0.0;                 ///< 0 to 1, asked by impact.h alone
    double weight_per_kg = 0.0;               ///< contact_motion.h; filled in by `add_contact`
    Vector3 impulse_Ns{Vector3::Zero()};      ///< in: of the last step; out: the answer
    bool slides = false;                      ///< in: in the last step; out: in this one
};

/// One equation between two bodies, a joint's or a motor's.
struct RowConstraint {
    int body_a = kGround;
    int body_b = kGround;
    Vector6 jacobian_a{Vector6::Zero()};  ///< u = jacobian_a . v_a + jacobian_b . v_b
    Vector6 jacobian_b{Vector6::Zero()};
    double target = 0.0;    ///< in the unit of u
    double least = 0.0;     ///< impulse; may be minus infinity
    double most = 0.0;      ///< at least `least`; may be infinity
    double softness = 0.0;  ///< R, 0 or more
    double weight = 0.0;    ///< contact_motion.h; filled in by `add_row`
    double impulse = 0.0;   ///< in: of the last step; out: the answer
};

}  // namespace fulcrum
