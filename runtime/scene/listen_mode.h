// How it is known that the learner speaks to the lesson.
#pragma once

#include <cstdint>

namespace fulcrum::runtime {

/// While a key is held, or whenever somebody speaks.
enum class ListenMode : std::uint8_t { hold, always };

}  // namespace fulcrum::runtime
