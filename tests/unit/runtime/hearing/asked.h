// A question that is asked where hearing is tested, and how a program is written in one line.
#pragma once

#include "dialogue/marking/question.h"

#include <string>
#include <vector>

namespace fulcrum::runtime::test {

inline dialogue::Question make_question() {
    dialogue::QuestionSource source;
    source.id = "heaviest";
    source.prompt = "Which one is the heaviest?";
    source.answers = {"[the|a|an] {thing} is the <superlative:heavy>"};
    source.lists = {{"thing", {"watermelon", "apple", "banana", "egg"}}};
    return dialogue::compile_question(source).value();
}

inline std::vector<std::string> shell(const std::string& script) {
    return {"sh", "-c", script};
}

}  // namespace fulcrum::runtime::test
