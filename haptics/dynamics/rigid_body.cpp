#include "haptics/dynamics/rigid_body.h"

#include "haptics/math/rotation.h"

#include <cmath>

namespace fulcrum {

RigidBody make_rigid_body(const WorldBodyPlan& plan) noexcept {
    RigidBody body;
    body.mass_kg = plan.mass_kg;
    body.felt_mass_kg = plan.felt_mass_kg;
    body.radius_m = plan.radius_m;
    body.drag_per_m = 0.5 * kAirDensity_kg_per_m3 * plan.drag_area_m2 / plan.mass_kg;
    return body;
}

Vector3 compute_falling_velocity(const Vector3& velocity_W, const Vector3& gravity_W,
                                 double drag_per_m, double dt_s) noexcept {
    // v1 = v0 + dt (g - c |v0| v1)   =>   v1 = (v0 + dt g) / (1 + dt c |v0|)
    return (velocity_W + dt_s * gravity_W) / (1.0 + dt_s * drag_per_m * velocity_W.norm());
}

void step_flight(RigidBody& body, const Vector3& gravity_W, double dt_s) noexcept {
    body.velocity_W = compute_falling_velocity(body.velocity_W, gravity_W, body.drag_per_m, dt_s);
    body.pose_W.position += dt_s * body.velocity_W;
    body.pose_W.orientation = compute_exp(dt_s * body.spin_W) * body.pose_W.orientation;
    body.pose_W.orientation.normalize();
}

double compute_terminal_speed_m_per_s(double gravity_m_per_s2, double drag_per_m) noexcept {
    return std::sqrt(gravity_m_per_s2 / drag_per_m);
}

}  // namespace fulcrum
