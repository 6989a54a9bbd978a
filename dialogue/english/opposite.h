// Opposites of adjectives that compare: heavy and light, big and small. "The egg is lighter" may be true where "Which one is
// heavier?" was asked; it is no answer to that.
//
// Thread: pure.  Cost: a table look-up.
#pragma once

#include <string_view>
#include <vector>

namespace fulcrum::dialogue {

/// The opposites of `adjective` (lower case): soft and easy of hard; empty when it has none here.
[[nodiscard]] std::vector<std::string_view> opposites_of(std::string_view adjective);

}  // namespace fulcrum::dialogue
