// One word, two spellings, both right: tyre, tire; colour, color. Neither is a slip.
//
// Thread: pure functions.  Cost: a table look-up; at load.
#pragma once

#include <string>
#include <string_view>

namespace fulcrum::dialogue {

/// `phrase` with the first word that has two spellings in its other one: "car tyre" -> "car tire", "tires" -> "tyres";
/// empty when no word has. Lower case.
[[nodiscard]] std::string other_spelling(std::string_view phrase);

}  // namespace fulcrum::dialogue
