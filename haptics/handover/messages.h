// The messages that cross between the loops. Each is one flat value with a time stamp in seconds of the run's clock.
//
//   haptic loop --HapticState--> world loop, lesson loop, recorder
//   world loop  --WorldFrame--> haptic loop        world loop --WorldSnapshot, WorldEvent--> lesson loop
//   lesson loop --ForceCommand--> haptic loop      lesson loop --WorldCommand--> world loop
#pragma once

#include "haptics/base/fault.h"
#include "haptics/math/spatial.h"

#include <array>
#include <cstdint>

namespace fulcrum {

inline constexpr int kMaxBodies = 64;  ///< bodies a world holds
inline constexpr int kMaxSolids = 16;  ///< bodies of those that can be touched as meshes
inline constexpr int kMaxFields = 8;   ///< force fields a scene declares
inline constexpr int kNoBody = -1;

/// A wrench that a lesson computed at its own slow rate, with its slopes, so that 1 kHz stays smooth between answers:
/// F(x, v) ~ force_W + stiffness (x - at_position_W) + damping (v - at_velocity_W),
/// T(x) ~ torque_W + torque_stiffness (x - at_position_W). Newtons, newton metres about the tool, metres, seconds.
/// There is no dT/dv: see field/linearised_wrench.h.
struct LinearisedWrench {
    double stamp_s = -1.0;  ///< when it was computed; before the first answer negative
    Vector3 force_W{Vector3::Zero()};
    Vector3 torque_W{Vector3::Zero()};
    Vector3 at_position_W{Vector3::Zero()};
    Vector3 at_velocity_W{Vector3::Zero()};
    Matrix3 stiffness_N_per_m{Matrix3::Zero()};          ///< dF/dx, 3 x 3
    Matrix3 damping_Ns_per_m{Matrix3::Zero()};           ///< dF/dv, 3 x 3
    Matrix3 torque_stiffness_Nm_per_m{Matrix3::Zero()};  ///< dT/dx, 3 x 3
};

/// What may change in a declared field while a lesson runs; its kind and coefficients are fixed by the plan.
struct FieldCommand {
    bool on = true;
    Vector3 anchor_W{Vector3::Zero()};  ///< centre of a spring or magnet
    double strength = 1.0;              ///< factor on the declared force, 0 to 1
};

/// Lesson -> haptic loop, newest value.
struct ForceCommand {
    double stamp_s = 0.0;       ///< when the lesson last answered; too old means command_stale
    bool lesson_alive = false;  ///< false fades the force to zero
    std::array<FieldCommand, kMaxFields> fields{};
    LinearisedWrench linearised{};
};

/// World -> haptic loop, newest value.
struct WorldFrame {
    double stamp_s = 0.0;
    Vector3 carried_force_W{
        Vector3::Zero()};  ///< felt weight of what lies in the tool; the loop ramps towards it
    std::array<Pose, kMaxSolids> solid_poses_W{};
    /// How often each solid was put elsewhere at once, instead of moving there.
    std::array<std::uint32_t, kMaxSolids> solid_placements{};
};

/// How far the last gate lets forces through.
enum class GatePhase : std::uint8_t { waiting, rising, open, fading, stopped };

/// What the passivity stage knows of one port, the hand's translation or its turning (coupling/passivity.h).
struct PortEnergy {
    double excess_J =
        0.0;  ///< given to the hand beyond what the ideal scene gives; negative: headroom
    double peak_J = 0.0;    ///< largest excess so far
    double braked_J = 0.0;  ///< taken back so far by the controller's brake
};

/// What a step of a tool may be short of, beside time.
enum class ToolLack : std::uint8_t {
    unsettled,  ///< it was still under way: the last force that was settled is felt
    wedged,     ///< bodies closed upon it: it holds them where they touched
    crowded,    ///< more contacts than there is room for: those left out are not felt
    inexact,    ///< the contacts' answer is not within its tolerance
};
inline constexpr std::size_t kToolLacks = 4;

/// What a step of a tool took, and what it left out.
struct ToolEffort {
    std::int64_t n_looks = 0;   ///< of its solver, at all that is near
    std::int64_t n_points = 0;  ///< looked at, in all looks together
    double error_N = 0.0;  ///< how far the points' force may be off for those that were left out
    bool in_time = true;   ///< false: the solver ended with the best it had, as its time was over
    std::array<bool, kToolLacks> lacks{};
    // So far:
    double most_error_N = 0.0;
    std::uint64_t n_inexact = 0;                        ///< steps that left out points
    std::uint64_t n_cut = 0;                            ///< steps that were not in time
    std::array<std::uint64_t, kToolLacks> n_lacking{};  ///< steps

    void tell(ToolLack lack, bool is_so) noexcept { lacks[static_cast<std::size_t>(lack)] = is_so; }
};

/// Haptic loop -> world, lesson and picture, newest value.
struct HapticState {
    std::uint64_t tick = 0;
    double time_s = 0.0;
    Pose tool_pose_W{};    ///< where the device really is, in the world
    Twist tool_twist_W{};  ///< estimated
    Vector3 proxy_position_W{
        Vector3::Zero()};  ///< where the tool may be; equals the tool's position in free space
    Quaternion proxy_orientation_W{
        Quaternion::Identity()};  ///< as the tool is held, but for one that things turn
    Wrench
        commanded_W{};  ///< what the scene asks for, braked where it is not passive, before the limits
    Wrench applied_W{};                   ///< what was sent to the device
    PortEnergy force_energy{};            ///< translation against force
    PortEnergy torque_energy{};           ///< turning against torque
    std::int32_t touched_body = kNoBody;  ///< body under the proxy, or kNoBody
    std::uint32_t buttons = 0;            ///< one bit a button
    Fault faults = Fault::none;
    GatePhase gate = GatePhase::waiting;
    ToolEffort tool{};  ///< of this round; nothing without a tool
};

/// Lesson -> world, ring.
struct WorldCommand {
    enum class Kind : std::uint8_t {
        drop,     ///< appears at position with velocity and falls
        place,    ///< appears at position and stays
        hide,     ///< is gone from the scene
        hold,     ///< lies in the tool at once, its weight is felt
        release,  ///< every held body is taken out of the tool and hidden
    };
    Kind kind = Kind::drop;
    std::int32_t body = kNoBody;
    Vector3 position_W{Vector3::Zero()};
    Vector3 velocity_W{Vector3::Zero()};
};

/// World -> lesson, ring.
struct WorldEvent {
    enum class Kind : std::uint8_t { caught, landed };
    Kind kind = Kind::caught;
    std::int32_t body = kNoBody;
    double time_s = 0.0;
    double speed_m_per_s = 0.0;  ///< at the catch or on the ground
};

enum class BodyWhere : std::uint8_t { hidden, placed, falling, held, landed };

struct BodyState {
    Pose pose_W{};
    Vector3 velocity_W{Vector3::Zero()};
    BodyWhere where = BodyWhere::hidden;
};

/// What steps of a world of rigid bodies were short of, so far.
struct WorldEffort {
    std::uint64_t n_steps = 0;
    std::uint64_t n_unconverged = 0;  ///< of them: the solver ended outside its tolerance
};

/// World -> lesson and picture, newest value.
struct WorldSnapshot {
    double time_s = 0.0;
    std::int32_t n_bodies = 0;
    std::array<BodyState, kMaxBodies> bodies{};  ///< n_bodies of them, in the order of the scene
    Vector3 carried_force_W{Vector3::Zero()};    ///< felt weight in the tool
    WorldEffort effort{};
};

}  // namespace fulcrum
