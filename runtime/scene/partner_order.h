// Who talks back to the learner, as somebody chose it for a run.
//
// Thread: values.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace fulcrum::runtime {

enum class PartnerKind : std::uint8_t { shipped, none, external, recorded };

/// As the command line and the record name it; what is read from a record was a program's then.
[[nodiscard]] constexpr std::string_view name_of(PartnerKind kind) noexcept {
    constexpr std::string_view kNames[] = {"shipped", "none", "exec", "exec"};
    return kNames[static_cast<std::size_t>(kind)];
}

/// Why there is one in the plan, for people.
[[nodiscard]] constexpr const char* why_of(PartnerKind kind) noexcept {
    constexpr const char* kWhy[] = {"", "nobody talks back to the learner",
                                    "a program of your own chooses what is said back",
                                    "what was said back is the record's"};
    return kWhy[static_cast<std::size_t>(kind)];
}

/// What another partner said to a turn, counted from 1, in a run that is repeated.
struct PartnerWords {
    int turn = 0;
    std::string text{};
    double time_s = 0.0;
};

struct PartnerOrder {
    PartnerKind kind = PartnerKind::shipped;
    bool is_given = false;                 ///< somebody chose it; else a repeated run has its own
    std::vector<std::string> words{};      ///< external: the program and its arguments
    std::vector<PartnerWords> recorded{};  ///< what it said then
    std::function<bool()> gives_up{};      ///< true once nobody waits for it any more; may be empty
};

}  // namespace fulcrum::runtime
