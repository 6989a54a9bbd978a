// Whether this build hears by PocketSphinx and says texts aloud: speech_parts.cpp, or what stands for it (no_speech/).
#pragma once

#include "haptics/base/error.h"

#include <optional>

namespace fulcrum::runtime {

/// Why nothing is ever heard by PocketSphinx, where this build leaves it out.
[[nodiscard]] std::optional<Error> why_no_sphinx();
/// Why nothing is ever said aloud, likewise.
[[nodiscard]] std::optional<Error> why_no_voice();

}  // namespace fulcrum::runtime
