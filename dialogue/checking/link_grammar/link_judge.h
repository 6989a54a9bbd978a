// A judge of sentences by the English grammar of Link Grammar, which Debian has as liblink-grammar5 and
// link-grammar-dictionaries-en.
//
// The library is opened when the judge is made, not when the program starts; without one nothing of it is loaded.
//
// Thread: one at a time.  Cost: about 0.25 s and 16 MB when it is made; a sentence of ten words takes about a millisecond, one
//   that fits badly some ten; none longer than kMostJudgedWords.
// Source: Sleator and Temperley 1991, "Parsing English with a Link Grammar", Carnegie Mellon University CMU-CS-91-196.
#pragma once

#include "dialogue/checking/judge.h"
#include "dialogue/result.h"

#include <memory>

namespace fulcrum::dialogue {

inline constexpr int kMostJudgedWords = 16;  ///< a parse takes time with the cube of the words

/// Loads the library and its English dictionary; an error names the package that is missing.
[[nodiscard]] Expected<std::unique_ptr<SentenceJudge>> make_link_judge();

}  // namespace fulcrum::dialogue
