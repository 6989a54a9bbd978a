// A judge of sentences by the English grammar of Link Grammar, which Debian has as liblink-grammar5 and
// link-grammar-dictionaries-en.
//
// The library is opened when the first judge is made, not when the program starts, and stays open for all that come after; without one
// nothing of it is loaded.
//
// Thread: all judges of a program one at a time.  Cost: about 0.25 s and 16 MB when the first is made; a sentence of ten words takes about a millisecond, one
//   that fits badly some ten; none longer than kMostJudgedWords.
// Source: Sleator and Temperley 1991, "Parsing English with a Link Grammar", Carnegie Mellon University CMU-CS-91-196.
#pragma once

#include "dialogue/checking/judge.h"
#include "dialogue/result.h"

#include <cstdint>
#include <memory>

namespace fulcrum::dialogue {

inline constexpr int kMostJudgedWords = 16;  ///< a parse takes time with the cube of the words

/// When the dictionary is loaded, which takes long: at once, where nobody may be kept waiting in the middle of a lesson, or for the first
/// sentence, for most lessons that run under a virtual clock bring none.
enum class GrammarOpens : std::uint8_t { at_once, for_a_sentence };

/// Loads the library; an error names the package that is missing, its English dictionary's too.
[[nodiscard]] Expected<std::unique_ptr<SentenceJudge>> make_link_judge(
    GrammarOpens when = GrammarOpens::at_once);

}  // namespace fulcrum::dialogue
