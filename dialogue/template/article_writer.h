// The articles before a noun of a list: right ones and wrong ones, by the noun's class and sound.
//
// Thread: one.  Cost: some arcs a branch.
#pragma once

#include "dialogue/template/arc_writer.h"

#include <array>
#include <cstdint>
#include <string_view>

namespace fulcrum::dialogue {

/// The article that a template asks for before a list.
enum class ArticlePolicy : std::uint8_t {
    bare,        ///< {thing}: none asked for, any accepted
    indefinite,  ///< [a|an|the], <article>, a: any such thing; a or an by sound where the noun needs one
    definite,  ///< the, [the|a|an]: the one that is there; "an apple" passes, and is said back with "the"
    short_answer,  ///< the noun alone is a whole answer: it may go without
    determined,    ///< "my {thing}", "a longer {thing}": its determiner stands before it
    after_no,      ///< "no {thing}", "enough {thing}": without an article, one or several
};

/// Nouns that take the same articles.
enum class Branch : std::uint8_t {
    with_a,           // a watermelon
    with_an,          // an apple
    with_both,        // a herb, an herb
    one_with_a,       // "a tree", where the list has trees and the template no article
    one_with_an,      // "an egg", likewise
    bare_or_the,      // water
    the_stuff,        // the wind, where there is one
    bare_plural,      // scissors
    made_plural,      // watermelons in general, where the list has watermelon
    plural_of_one,    // "the watermelons", where there is one
    name,             // Jupiter, far
    the_name,         // the Moon
    name_or_the,      // Earth, the Earth
    plural_after_a,   // "a watermelons"
    plural_after_an,  // "an apples"
    unit,             // newtons, where no number stands before them
};

/// Writes the articles of one branch between two nodes.
class ArticleWriter {
  public:
    ArticleWriter(ArcWriter& writer, ArticlePolicy policy, bool predicate, int element, int from,
                  int to)
        : writer_(writer),
          policy_(policy),
          predicate_(predicate),
          element_(element),
          from_(from),
          to_(to) {}

    void write(Branch branch);

  private:
    void right(std::string_view said, bool canonical);
    /// As good as `belongs`, which is said back.
    void passes(std::string_view said, std::string_view belongs);
    void wrong(std::string_view said, std::string_view belongs, ErrorCode code);
    void count_noun(std::string_view own, std::string_view other);
    /// The singular of what a list has several of.
    void one_of_several(std::string_view own, std::string_view other);
    /// `others` point at what has the other number: "these metal", "this scissors".
    void without(const std::array<std::string_view, 3>& determiners,
                 const std::array<std::string_view, 2>& others);
    /// "Apples are heavier": right where any will do; what is there is one thing, see below. Where the template speaks of no
    /// one thing, "these rocks" are pieces of it.
    void plurals_in_general();
    /// "The apples": there is one, so the noun is wrong (the arc of the noun says so) and its determiner goes with it.
    void plurals_that_are_there();
    void only_name();
    void no_determiner();
    void with_the(ErrorCode without_it);
    /// "The wind stopped": there is one around everybody.
    void the_one_around();
    void miscounted(std::string_view own, std::string_view other);

    ArcWriter& writer_;
    ArticlePolicy policy_;
    bool predicate_;
    int element_, from_, to_;
};

}  // namespace fulcrum::dialogue
