// Faults of a running loop: bits that are set and counted, never thrown. Any of them fades the force to zero.
#pragma once

#include <cstdint>

namespace fulcrum {

/// One bit a kind of fault; a step ORs them together.
enum class Fault : std::uint32_t {
    none = 0,
    device_read = 1U << 0,      ///< the device did not give a pose
    device_stale = 1U << 1,     ///< the device's newest pose is too old
    device_invalid = 1U << 2,   ///< no pose, an impossible jump, or a stamp that went back
    command_stale = 1U << 3,    ///< the lesson or the world has not answered for too long
    command_invalid = 1U << 4,  ///< NaN or infinity in a force, or a clock that does not go on
    emergency_stop = 1U << 5,   ///< somebody pressed the emergency stop
    lesson_failed = 1U << 6,    ///< the lesson's process failed; the force fades
    record_full = 1U << 7,     ///< the recorder could not keep up; samples were dropped and counted
    device_write = 1U << 8,    ///< the device refused the wrench
    ended = 1U << 9,           ///< the run is over; the force fades before the loop stops
    hand_too_fast = 1U << 10,  ///< the hand moves faster than forces may follow it
    too_much_energy = 1U << 11,  ///< the hand was given more energy in a second than is allowed
    clutched = 1U << 12,         ///< the person holds the clutch: the arm moves and the hand stays
    other_stopped = 1U << 13,    ///< the emergency stop of another hand of this run
};

[[nodiscard]] constexpr Fault operator|(Fault a, Fault b) noexcept {
    return static_cast<Fault>(static_cast<std::uint32_t>(a) | static_cast<std::uint32_t>(b));
}
[[nodiscard]] constexpr Fault operator&(Fault a, Fault b) noexcept {
    return static_cast<Fault>(static_cast<std::uint32_t>(a) & static_cast<std::uint32_t>(b));
}
constexpr Fault& operator|=(Fault& a, Fault b) noexcept {
    return a = a | b;
}
[[nodiscard]] constexpr bool any(Fault faults) noexcept {
    return faults != Fault::none;
}

/// A stop, this hand's or another's: the force fades and stays away until somebody lifts it.
inline constexpr Fault kStops = Fault::emergency_stop | Fault::other_stopped;
/// The force itself was too much for the hand.
inline constexpr Fault kThrown = Fault::hand_too_fast | Fault::too_much_energy;

}  // namespace fulcrum
