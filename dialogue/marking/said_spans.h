// Where the sentences of an answer end, and the list that may follow one: "There are four: lift, drag, weight and tension."
//
// Thread: pure.  Cost: linear in the text.
#pragma once

#include <cstddef>
#include <optional>
#include <string_view>
#include <vector>

namespace fulcrum::dialogue {

/// Bytes [begin, end) of an answer.
struct SaidSpan {
    std::size_t begin = 0;
    std::size_t end = 0;
};

/// The sentences of `text`: "3.5" and "Mr. Fox" have no end in them, and a reason belongs to what it is the reason of. With
/// `clauses` also what stands between commas, behind "but", and behind "and" where that is a clause.
[[nodiscard]] std::vector<SaidSpan> said_sentences(std::string_view text, bool clauses);

/// What is listed behind an answer.
struct SaidList {
    std::size_t begin = 0;  ///< of the colon or the comma before it
    std::vector<SaidSpan> items{};
};

/// The list at the end of `text`, of names of some words each; none where there is none, or where something in it says "not".
[[nodiscard]] std::optional<SaidList> list_behind(std::string_view text);

/// The first pronoun of `text` that stands for a thing: "it", "they", "this".
[[nodiscard]] std::optional<SaidSpan> find_pronoun(std::string_view text);

/// A sentence ends in `text`, or at its edge.
[[nodiscard]] bool has_sentence_end(std::string_view text);

}  // namespace fulcrum::dialogue
