// How two bodies are joined, as a lesson says it: in the world, as they stand at the start.
#pragma once

#include "haptics/math/spatial.h"

#include <cstdint>
#include <limits>

namespace fulcrum {

enum class JointKind : std::uint8_t {
    ball,     ///< a point of both stays one
    hinge,    ///< and they turn about the axis alone
    slider,   ///< they move along the axis alone
    fixed,    ///< they are one
    distance  ///< two points stay as far apart as they are: a rod
};

/// Along a slider's axis in metres and newtons, about a hinge's in radians and newton metres; no other joint has any of them.
struct JointDrive {
    double lower =
        -std::numeric_limits<double>::infinity();  ///< at most 0, where it is at the start
    double upper = std::numeric_limits<double>::infinity();  ///< at least 0
    double motor_speed = 0.0;  ///< m/s or rad/s, held with at most `motor_force`
    double motor_force = 0.0;  ///< 0 or more; 0: no motor
    double friction = 0.0;     ///< force or torque that resists motion at most, 0 or more
};

struct JointPlan {
    JointKind kind = JointKind::ball;
    std::int32_t body_a = -1;  ///< -1: the world
    std::int32_t body_b = -1;  ///< moves relative to a; one of both at least moves
    Vector3 anchor_W{Vector3::Zero()};
    Vector3 other_anchor_W{Vector3::Zero()};  ///< of b: a distance joint alone
    Vector3 axis_W{Vector3::UnitY()};         ///< of a hinge or slider; any length above 0
    JointDrive drive{};
    bool bodies_touch = false;  ///< whether the two still push each other
};

}  // namespace fulcrum
