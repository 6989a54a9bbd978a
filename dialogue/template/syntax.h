// The syntax of sentence templates, after hassil (Home Assistant's template language):
//
//   words            as they are; case and punctuation don't matter
//   [optional]       may be left out           [a|b]       one of them or none
//   (a|b)            one of them               (a;b)       all of them, in any order (at most 4)
//   {list}           a word of a list          {list:slot} the same under another name
//   <rule>           another template          <form:word> a form of grammar, e.g. <superlative:heavy>
//                                              <form:{list}>, <form:{list:slot}> the same of each word of a list
//   \x               the character x itself
//
// A template is parsed into a tree that lies in one array; children are indices into it, always of later nodes.
//
// Thread: pure functions.  Cost: linear in the text.
#pragma once

#include "dialogue/result.h"

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace fulcrum::dialogue {

inline constexpr std::size_t kLongestTemplate_bytes = 4096;
inline constexpr int kDeepestTemplate = 24;            ///< brackets within brackets
inline constexpr std::size_t kLargestPermutation = 4;  ///< parts of (a;b;…)

/// One part of a template.
struct SyntaxNode {
    enum class Kind : std::uint8_t {
        sequence,
        alternatives,
        permutation,
        optional,
        word,
        list,
        rule
    };
    Kind kind = Kind::sequence;
    std::string text;  ///< the word; the list's or rule's name
    std::string
        argument;  ///< the slot of a list, the word of a form, a word as it is shown ("Earth"); may be empty
    std::vector<int>
        children;  ///< of sequence, alternatives, permutation, optional (one child), form of a list (the list)
    int column = 1;  ///< where it begins
};

/// A parsed template; node 0 is the whole.
using Syntax = std::vector<SyntaxNode>;

/// Parses `text`; an error says what and at which column.
[[nodiscard]] Expected<Syntax> parse_template(std::string_view text);

}  // namespace fulcrum::dialogue
