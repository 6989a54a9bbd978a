// What a person has to be told of a play in which the last gate kept back what the lesson asked the hand to feel.
#pragma once

#include "haptics/base/error.h"
#include "haptics/loop/felt_time.h"

#include <span>
#include <string>
#include <vector>

namespace fulcrum::runtime {

/// One for each of a run's hands that was asked to feel something for a second or longer, and felt nothing, or whose gate was shut for more
/// than half of that time: for how long, why, and what to do. `where`: what the play was made from.
[[nodiscard]] std::vector<Error> notes_of_felt(std::span<const FeltTime> hands,
                                               const std::string& where);

/// Writes each to standard error, a line each.
void tell_felt(std::span<const FeltTime> hands, const std::string& where);

/// Whether any of them felt anything.
[[nodiscard]] bool was_felt(std::span<const FeltTime> hands);

}  // namespace fulcrum::runtime
