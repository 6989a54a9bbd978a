// Sentences that a template makes: the canonical one for given slots, and all right and wrong ones by walking its graph.
//
// Thread: pure.  Cost: one pass over the arcs for the canonical sentence; linear in its length for a walk.
#pragma once

#include "dialogue/template/parse.h"

#include <cstddef>
#include <functional>
#include <string>
#include <utility>
#include <vector>

namespace fulcrum::dialogue {

/// The pieces of the sentence that a recast gives: canonical forms, what is optional left out, slots as in `slots`
/// (a slot that isn't named there takes its list's first entry). Nothing is marked as said. Of `said`, lower case, as much is kept as
/// may be: "to turn" of "harder to turning".
[[nodiscard]] std::vector<Piece> canonical_pieces(
    const TemplateSet& set, int graph,
    const std::vector<std::pair<std::string, std::string>>& slots,
    const std::vector<std::string>& said = {});

/// Forms of one word as far as their letters show: "turn" and "turning", "stop" and "stopped".
[[nodiscard]] bool alike(std::string_view word, std::string_view other);

/// A range of pieces, [first, last).
struct PieceRange {
    int first = 0;
    int last = 0;
};

/// The phrase around piece `at`: "the heaviest", "a watermelon", "is".
[[nodiscard]] PieceRange phrase_around(const std::vector<Piece>& pieces, int at);

/// The phrase around the first piece that fills `slot`; empty where none does.
[[nodiscard]] PieceRange phrase_of_slot(const std::vector<Piece>& pieces, int slot);

/// All of "is made of" around piece `at`, which is part of it.
[[nodiscard]] PieceRange passive_around(const std::vector<Piece>& pieces, int at);

/// The right sentence with capital and full stop. `mark` is set in *asterisks*, or left out as "…" when `blank`.
[[nodiscard]] std::string render(const std::vector<Piece>& pieces, PieceRange mark = {},
                                 bool blank = false);

/// The right words of `range` alone: "the heaviest".
[[nodiscard]] std::string render_phrase(const std::vector<Piece>& pieces, PieceRange range);

/// A sentence made from a graph, as a learner might say it.
struct Sample {
    std::string said;           ///< what is said
    std::vector<Piece> pieces;  ///< each with its code and what belongs there
    std::vector<std::pair<std::string, std::string>> slots;  ///< what it means
};

/// Walks from start to end; `choose(n)` picks one of n ways on (0 <= result < n). `errors`: wrong arcs may be taken too.
[[nodiscard]] Sample walk(const TemplateSet& set, int graph, bool errors,
                          const std::function<std::size_t(std::size_t)>& choose);

/// The same along what a recast says, with every word of its lists; `error`: one wrong arc is taken, where one can be.
[[nodiscard]] Sample walk_plainly(const TemplateSet& set, int graph, bool error,
                                  const std::function<std::size_t(std::size_t)>& choose);

}  // namespace fulcrum::dialogue
