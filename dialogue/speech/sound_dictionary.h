// The dictionary of sounds: a text of one word and its sounds a line, as the CMU Pronouncing Dictionary is published.
//
//   apple AE P AH L
//   read(2) R EH D           another way to say it
//   ;; and ## begin remarks; blank lines are passed over
//
// It is read before a recogniser is given it, for that ends its process over what it cannot read. Refused are files that are cut off
// in a line, texts in other alphabets' encodings (UTF-16 has zero bytes), lines and files beyond all measure, and what is no file.
//
// Thread: any.  Cost: one pass over the text; the English one, 3 MB, takes some ten milliseconds.
#pragma once

#include "dialogue/result.h"

#include <functional>
#include <string>
#include <string_view>

namespace fulcrum::dialogue {

/// Is given each word and its sounds, apart by one space each as they stand in the line.
using TakeSounds = std::function<void(std::string_view word, std::string_view sounds)>;

/// Reads a dictionary; the error has the line. What was taken before it is no more than the beginning.
[[nodiscard]] Expected<int> read_sound_dictionary(std::string_view text, const TakeSounds& take);

/// The same of a file; the error is one sentence with the file's name. Gives the number of words.
[[nodiscard]] Expected<int> open_sound_dictionary(const std::string& path, const TakeSounds& take);

}  // namespace fulcrum::dialogue
