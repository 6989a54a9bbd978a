// What was said or written, as words: case, punctuation, odd apostrophes, double spaces, contractions and digits no
// longer matter.
//
//   "It's  the WATERMELON!" -> it is the watermelon      "don’t" -> do not      "3.5" -> three point five
//
// Every word knows the bytes it came from. Bytes that are not UTF-8 and control characters part words; capitals of
// all alphabets are folded (unicode.h), and other alphabets are words too.
//
// Thread: pure functions.  Cost: linear in the text.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace fulcrum::dialogue {

/// One word and where it stood: bytes [begin, end) of the text.
struct Token {
    std::string text;
    std::size_t begin = 0;
    std::size_t end = 0;
};

/// The words of `text`, in order.
[[nodiscard]] std::vector<Token> tokenise(std::string_view text);

/// The words of `text` without their places.
[[nodiscard]] std::vector<std::string> words_of(std::string_view text);

/// The same as one text, each word between blanks, " the egg ", in which a word is found by its blanks.
[[nodiscard]] std::string words_between_blanks(std::string_view text);

/// `text` without the blanks, tabs and ends of lines before and behind it.
[[nodiscard]] std::string_view without_blanks(std::string_view text);

}  // namespace fulcrum::dialogue
