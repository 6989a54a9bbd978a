// What a recogniser listens for: one graph of the words that may be heard for a question, right or wrong.
//
//   start --the--> o --watermelon--> o --is--> o --the--> o --heaviest--> end
//         ------------------------------->           --most--> o --heavy->
//
// All graphs of a template set between one start and one end, each word an arc. What cannot be heard is left out: a misspelling
// sounds as the right word does. A recogniser so hears the errors that learners make, and does not mend them.
//
// Thread: pure.  Cost: linear in the arcs, at most kLargestGraph_arcs of them with their words.
#pragma once

#include "dialogue/template/graph.h"

#include <string>
#include <vector>

namespace fulcrum::dialogue {

/// What recognisers are given: samples a second, mono.
inline constexpr int kHeardRate_Hz = 16'000;

/// How likely an arc with an error is taken to be, beside a right one.
inline constexpr double kErrorWeight = 0.2;

struct WordGraph {
    struct Arc {
        int from = 0;
        int to = 0;
        int word = kNone;     ///< in `words`; kNone: nothing is said
        double weight = 1.0;  ///< 0 to 1, beside the others
    };
    std::vector<std::string> words;  ///< lower case, each once; numbers in words
    std::vector<Arc> arcs;           ///< no two alike
    int nodes = 0;                   ///< from 0, the start, to `nodes - 1`, the end
};

[[nodiscard]] WordGraph make_word_graph(const TemplateSet& set);

}  // namespace fulcrum::dialogue
