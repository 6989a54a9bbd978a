// What a guest is kept as: "guest 2026-11-30 14:05 7f3a91c2", when they came, by the computer's clock, and eight digits by chance, so that no
// two guests are one learner.
//
// Thread: any.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace fulcrum::runtime {

/// Of a guest who comes now.
[[nodiscard]] std::string new_guest_name();
/// The same at that time, in the computer's zone; `id` has eight hexadecimal digits at least.
[[nodiscard]] std::string guest_name_at(std::int64_t utc_ms, std::string_view id);

/// Whether a nickname was made so. The learner called "guest" alone, all guests of earlier versions together, is none of them.
[[nodiscard]] bool is_guest_name(std::string_view nickname) noexcept;

}  // namespace fulcrum::runtime
