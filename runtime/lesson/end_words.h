// What is said at a lesson's end besides its stars: how it went, and what to try next.
//
//   [Your best so far!] + answers at the first try, or that there was no question + what to practise
// From what was answered (SessionResult), so that it is true whatever rule a lesson gives its stars by.
//
// Thread: pure.
#pragma once

#include "dialogue/catalogue.h"
#include "runtime/lesson/session_messages.h"

#include <optional>
#include <string>
#include <vector>

namespace fulcrum::runtime {

/// `best_before`: the learner's most stars in this lesson, -1: it was never played to its end.
[[nodiscard]] std::string explain_stars(const SessionResult& result, int best_before,
                                        const dialogue::Catalogue& catalogue);

/// The next of them, in their order and from the first again after the last, that was not played to its end; nothing where there is none, or
/// the lesson of this name is none of them.
[[nodiscard]] std::optional<KnownLesson> find_next_lesson(const std::vector<KnownLesson>& lessons,
                                                          const std::string& played);

}  // namespace fulcrum::runtime
