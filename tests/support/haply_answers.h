// What the stand-in for Haply's service says, and what it understands. Written from documents: where one says otherwise, it is right.
//
// Sources: docs.haply.co/inverseSDK/service, text of 3.5.x: [W] realtime/websocket-protocol, [C] realtime/control-commands, [H] api/http,
// [S] api/settings, [M] commons/mount-and-workspace, [B] commons/basis, [T] tutorials; clients: [I] IsaacLab se3_haply.py, [J] jhu-saw
// mtsHaply.cpp, [N] NVIDIA IsaacTeleop HaplyTracker. [?]: nobody says, and it is as is worst for who listens.
#pragma once

#include "haptics/math/spatial.h"
#include "tests/support/haply_wire.h"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace fulcrum::test_support {

enum class StandInGrip { none, wired, wireless, asleep };

/// How the stand-in is and behaves; all of it may change while it runs.
struct HaplyOptions {
    std::string version = "3.5.0";  ///< git_tag of GET /version [H]
    bool takes_vector = true;       ///< the word of 3.5 [C]
    bool takes_values =
        false;  ///< the word of 3.4 and before [I]; that one excludes the other: [?]
    std::vector<std::string> ids{"049D"};  ///< of the arms [W]; all are where the one arm is
    std::string type = "inverse3";         ///< [W]
    bool is_calibrated = true;             ///< [J]
    bool has_power = true;                 ///< [W]
    bool is_in_use = false;                ///< [W]
    StandInGrip grip = StandInGrip::none;  ///< [W]
    std::string grip_buttons =
        "a";  ///< the names of what is pressed, a comma between [W]; "button_0" as [N] reads
    bool leaves_out = false;  ///< parts that equal identity [T]
    bool speaks_3_0 = false;  ///< "mode" for "control_mode", and no status or transform [old pages]
    std::string basis = "XYZ";         ///< [B]; "XZY" swaps two axes
    double mount_scale = 1.0;          ///< of the session's mount [M]
    double transform_scale = 1.0;      ///< of its workspace [M]
    double gate_gain = 0.3;            ///< [W]
    std::string preset = "defaults";   ///< [W]
    std::string handedness = "right";  ///< [W]
    std::optional<double> force_scale =
        1.0;  ///< devices/force_scale [S]; the shape of the answer: {ok, data} [H], the value in it [?]
    WireHabits wire{};
    // Faults.
    bool is_silent = false;      ///< takes commands and answers none
    bool hangs = false;          ///< takes nothing, sends nothing, and leaves the last force on
    bool echoes = true;          ///< tells the force that it has [W]
    bool repeats = false;        ///< answers the same state again and again
    bool cuts_off = false;       ///< the next answer ends in the middle of its frame, with the line
    bool is_malformed = false;   ///< answers are half a message
    bool has_no_number = false;  ///< a coordinate is null
    double delay_s = 0.0;        ///< before each answer
    bool delays_once = false;    ///< before the next alone
};

/// Where the arm is, in its base A: m, m/s, N.
struct StandInState {
    Vector3 position_A{Vector3::Zero()};
    Vector3 velocity_A{Vector3::Zero()};
    Vector3 force_A{Vector3::Zero()};  ///< as it was ordered
    Quaternion grip_A{Quaternion::Identity()};
};

/// One message. `is_full` ones have the configuration [W].
[[nodiscard]] std::string make_state_text(const HaplyOptions& options, const StandInState& state,
                                          bool is_full);

/// What a client has asked.
struct StandInOrder {
    std::optional<Vector3> force_A;  ///< forces of one message are added [C]
    bool wants_all = false;
    bool is_message = false;
};
[[nodiscard]] StandInOrder read_order_text(const HaplyOptions& options, std::string_view text);

/// The answer to a GET of `path`, with its head.
[[nodiscard]] std::string answer_get(const HaplyOptions& options, std::string_view path);

/// Between the arm's base and what a session with this basis and mount is told.
[[nodiscard]] Vector3 to_session(const HaplyOptions& options, const Vector3& v_A);
[[nodiscard]] Vector3 turn_to_base(const HaplyOptions& options, const Vector3& force);

}  // namespace fulcrum::test_support
