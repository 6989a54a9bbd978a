// What is sent to the Haply Inverse Service: one force a message, which it answers with one state.
//
//   {"inverse3":[{"device_id":"049D","commands":{"set_cursor_force":{"vector":{"x":0,"y":0,"z":0}}}}]}       N, base A
// The force's word is `vector` in the documents of 3.5 and `values` in every public client of 3.4 and before; whether either takes the
// other's is not documented. Forces of one message are added, so only one is ever sent.
//
// Thread: any. Cost: a microsecond; allocates until `out` is long enough.
// Source: docs.haply.co/inverseSDK/service, 3.5: realtime/control-commands ("set_cursor_force"), api/simulation
// ("session.force_render_full_state"); for `values`: isaac-sim/IsaacLab, se3_haply.py.
#pragma once

#include "haptics/math/spatial.h"

#include <optional>
#include <string>
#include <string_view>

namespace fulcrum::runtime {

enum class ForceWord : unsigned char { vector, values };

[[nodiscard]] std::string_view name_of(ForceWord word) noexcept;
[[nodiscard]] constexpr ForceWord other(ForceWord word) noexcept {
    return word == ForceWord::vector ? ForceWord::values : ForceWord::vector;
}

/// The word of a service of this version, "3.5.0" or "v3.4.8-2-gce34"; nothing below 3.1, of 4 and later, and of what is no version.
[[nodiscard]] std::optional<ForceWord> choose_force_word(std::string_view version) noexcept;

/// The arm's, for a command: letters, digits, '-' and '_', 1 to 64 of them.
[[nodiscard]] bool is_haply_id(std::string_view id) noexcept;

/// Makes `out` the message for this force; one that is not finite goes as zero. `wants_all` asks for the configuration in the answer.
void write_haply_command(std::string_view id, ForceWord word, const Vector3& force_A,
                         bool wants_all, std::string& out);

}  // namespace fulcrum::runtime
