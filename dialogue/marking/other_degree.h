// A right form of another degree than the question teaches: "the egg is heavy", "the sandpaper ramp is the roughest" where "heavier" and
// "rougher" are asked. Templates call it an error, which it is where the question's form was meant; here stands where it was not.
//
// Thread: pure.  Cost: linear in the sentence.
#pragma once

#include "dialogue/marking/mark.h"
#include "dialogue/marking/question.h"
#include "dialogue/template/parse.h"

#include <vector>

namespace fulcrum::dialogue {

/// Of three or more things "the roughest" is as right as "rougher", and "easiest" before a place as "easier"; of two that the question names
/// it is not.
void allow_superlative(const Question& question, std::vector<Piece>& pieces);

/// There is such a form in it, which may be just what was meant: "wood is rough, but rock is rougher".
[[nodiscard]] bool says_other_degree(const Mark& mark);

/// Of an answer of wrong meaning: "the egg is heavy" may be just what was meant, so it is no error. What shows the degree that was meant,
/// "heavy than the apple", leaves it one.
void excuse_other_degree(Mark& mark);

}  // namespace fulcrum::dialogue
