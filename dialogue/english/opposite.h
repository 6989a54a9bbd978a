// Opposites of adjectives that compare: heavy and light, big and small. "The egg is lighter" may be true where "Which one is
// heavier?" was asked; it is no answer to that.
//
// Thread: pure.  Cost: a table look-up.
#pragma once

#include <string_view>

namespace fulcrum::dialogue {

/// The opposite of `adjective` (lower case); empty when it has none here.
[[nodiscard]] std::string_view opposite_of(std::string_view adjective);

}  // namespace fulcrum::dialogue
