// The arms that `fulcrum arm` can serve.
#pragma once

#include <array>
#include <cstdint>
#include <string_view>

namespace fulcrum::runtime {

/// In the order of --arm's words. Simulated: Barrett's WAM of seven joints, and three axes on a desk. Real: runtime/arms.
enum class ArmKind : std::uint8_t { wam, desktop, haply, touch, fd };

/// An arm at this computer that a run starts by itself (own_arm.h).
struct OwnArmKind {
    std::string_view word;  ///< of --hand
    std::string_view arm;   ///< its word of --arm
    std::string_view name;  ///< for people, at a sentence's begin
    bool is_real = true;    ///< false: simulated
};
inline constexpr std::array kOwnArms{
    OwnArmKind{"simulated", "desktop", "The simulated arm", false},
    OwnArmKind{"haply", "haply", "Haply's arm"},
    OwnArmKind{"touch", "touch", "The Touch"},
    OwnArmKind{"fd", "fd", "Force Dimension's arm"},
};

}  // namespace fulcrum::runtime
