// What the Haply Inverse Service tells, read and judged; numbers stay in the arm's base A as the service has it.
//
//   {"inverse3":[{"device_id", "config", "state", "status"}], "verse_grip":[…], "wireless_verse_grip":[…], "custom_verse_grip":[…]}
// The first message and those that were asked for have `config`; the others `state` and `status` alone. A part of a vector, a turn or a
// scale that equals identity may be left out. Unknown keys are passed over. Whatever else is not as it should be makes the whole message
// one of no use: text that is no JSON, a number that is none, a place no arm can reach, a turn that is no turn.
//
// Thread: any; a value. Cost: some 40 microseconds a state; allocates.
// Source: docs.haply.co/inverseSDK/service, version 3.5: realtime/websocket-protocol ("Initial inventory", "State update"),
// tutorials/01 ("Partial-update semantics"), commons/mount-and-workspace. `mode` for `control_mode` at 3.0 and 3.1 is not read.
#pragma once

#include "haptics/base/error.h"
#include "haptics/math/spatial.h"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace fulcrum::runtime {

/// Where a frame lies in another, and how it is stretched.
struct HaplyTransform {
    Pose pose{};
    Vector3 scale{Vector3::Ones()};
};
[[nodiscard]] bool is_identity(const HaplyTransform& transform) noexcept;
[[nodiscard]] bool is_same(const HaplyTransform& a, const HaplyTransform& b) noexcept;

/// What stands between a program and an arm, as a session has it.
struct HaplyConfig {
    std::string type = "inverse3";  ///< inverse3, inverse3x or minverse
    std::string basis = "XYZ";      ///< "XYZ": +X right, +Y away from the person, +Z up
    std::string handedness{};
    std::string preset{};
    HaplyTransform mount{};
    std::optional<double> gate_gain{};  ///< of the force gate
    std::optional<double> damping_Ns_per_m{};
    std::optional<bool> compensates_gravity{};
    std::optional<double> gravity_scale{};
    std::optional<bool> scales_torque{};
};

/// Is empty where a message does not say.
struct HaplyStatus {
    std::optional<bool> is_calibrated{};
    std::optional<bool> is_in_use{};
    std::optional<bool> has_power{};
};

struct HaplyArm {
    std::string id;
    std::optional<HaplyConfig> config;
    Vector3 position_A{Vector3::Zero()};  ///< m
    Vector3 velocity_A{Vector3::Zero()};  ///< m/s
    Vector3 echo_A{
        Vector3::Zero()};  ///< the force that the service has now, N; zero where it is left out
    HaplyTransform transform{};  ///< of the workspace
    HaplyStatus status{};
};

struct HaplyGrip {
    std::string id;
    std::optional<Quaternion> orientation_A;
    std::uint32_t buttons = 0;  ///< bit 0: a, or the only one; 1: b; 2: c; 3: home
    bool is_awake = true;
};

struct HaplyMessage {
    std::vector<HaplyArm> arms;
    std::vector<HaplyGrip> grips;
};

/// Refuses what is of no use, with a clause that says what.
[[nodiscard]] Expected<HaplyMessage> parse_haply_message(std::string_view text);

/// The git_tag, or else the project_version, of GET /version; empty where neither is there.
[[nodiscard]] std::string parse_haply_version(std::string_view text);

/// What multiplies every force, of GET /settings/devices/force_scale or of GET /settings; nothing where neither tells.
[[nodiscard]] std::optional<double> parse_haply_force_scale(std::string_view text);

}  // namespace fulcrum::runtime
