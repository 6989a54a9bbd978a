// Errors put into right sentences, one each: those that the lessons teach pupils not to make.
#pragma once

#include "dialogue/english/lexicon.h"
#include "tests/bench/curves/english_scores.h"

#include <string>
#include <vector>

namespace fulcrum::bench {

/// All ways to spoil `sentence` in one place: degrees, articles, numbers, agreement, "made of", adverbs for adjectives, order, a
/// verb left out.
[[nodiscard]] std::vector<ErroneousSentence> spoil(const dialogue::Lexicon& lexicon,
                                                   const std::string& sentence);

}  // namespace fulcrum::bench
