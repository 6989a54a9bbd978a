// How a body is lit up for the learner: it may be chosen, or it has been.
#pragma once

#include <cstdint>

namespace fulcrum::runtime {

enum class BodyLight : std::uint8_t {
    off,
    offered,  ///< a line goes round it
    lit,      ///< it shines
};

/// As lessons write them, in that order.
inline constexpr const char* kBodyLights = "off offered lit";

}  // namespace fulcrum::runtime
