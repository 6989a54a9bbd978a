// What adjectives are measured on: "heavy" and "light" on weight, which has a verb of its own, "weighs more".
//
// Thread: pure.  Cost: one look-up.
#pragma once

#include <string_view>

namespace fulcrum::dialogue {

/// The scale of one adjective; empty where there is nothing of the kind.
struct Measure {
    std::string_view adjective;
    std::string_view
        opposite;  ///< on the same scale: what is less heavy is lighter, so "slippery" has none
    std::string_view noun{};     ///< "they have the same weight"
    std::string_view more{};     ///< "weighs more"
    std::string_view most{};     ///< "weighs the most"
    std::string_view as_much{};  ///< "does not weigh as much"
    bool is_felt = false;        ///< "feels heavier"
};

/// The scale of `adjective` (lower case), all empty where none is known.
[[nodiscard]] Measure measure_of(std::string_view adjective);

}  // namespace fulcrum::dialogue
