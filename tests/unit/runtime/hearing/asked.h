// A question that is asked where hearing is tested, and how a program is written in one line and begun.
#pragma once

#include "dialogue/marking/question.h"
#include "runtime/hearing/external_recogniser.h"

#include <memory>
#include <string>
#include <utility>
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

inline std::unique_ptr<ExternalRecogniser> start(std::vector<std::string> words,
                                                 std::vector<std::string> recordings = {}) {
    return ExternalRecogniser::create({std::move(words), std::move(recordings), true}).value();
}

}  // namespace fulcrum::runtime::test
