#include "dialogue/english/making.h"

#include "dialogue/english/letters.h"
#include "dialogue/english/noun.h"

#include <algorithm>
#include <array>
#include <string>
#include <utility>

namespace fulcrum::dialogue {
namespace {

/// What a thing is made from, when one can't see it in the thing any more.
constexpr std::array<std::pair<std::string_view, std::string_view>, 24> kChanged = {{
    {"paper", "wood"},  {"paper", "tree"}, {"paper", "cotton"},   {"cardboard", "wood"},
    {"book", "wood"},   {"book", "tree"},  {"glass", "sand"},     {"plastic", "oil"},
    {"rubber", "tree"}, {"rubber", "oil"}, {"bread", "flour"},    {"cheese", "milk"},
    {"butter", "milk"}, {"wine", "grape"}, {"juice", "fruit"},    {"juice", "apple"},
    {"steel", "iron"},  {"metal", "rock"}, {"metal", "stone"},    {"brick", "clay"},
    {"sugar", "plant"}, {"wax", "oil"},    {"concrete", "stone"}, {"sandpaper", "sand"},
}};

/// The last word in the singular.
std::string plain(std::string_view phrase) {
    const std::size_t space = phrase.find_last_of(" -");
    const std::string_view last =
        space == std::string_view::npos ? phrase : phrase.substr(space + 1);
    const std::string singular = singular_of(last);
    return singular.empty() ? lower_case(last) : singular;
}

}  // namespace

std::vector<LearnerVerb> learner_participles() {
    return {{"make", ErrorCode::verb_form},        {"makes", ErrorCode::verb_form},
            {"making", ErrorCode::verb_form},      {"maked", ErrorCode::verb_inflection},
            {"maded", ErrorCode::verb_inflection}, {"maken", ErrorCode::verb_inflection},
            {"maid", ErrorCode::spelling}};
}

std::vector<LearnerVerb> learner_auxiliaries() {
    std::vector<LearnerVerb> wrong = learner_verbs({"is", "are", true});
    for (const std::string_view said : {"has", "have", "been", "does", "do"}) {
        wrong.push_back({std::string(said), ErrorCode::verb_form});
    }
    return wrong;
}

std::vector<LearnerVerb> active_for_passive() {
    return {{"makes", ErrorCode::verb_voice}, {"make", ErrorCode::verb_voice}};
}

bool changed_in_making(std::string_view thing, std::string_view material) {
    const std::pair<std::string, std::string> made{plain(thing), plain(material)};
    return std::any_of(kChanged.begin(), kChanged.end(), [&](const auto& pair) {
        return pair.first == made.first && pair.second == made.second;
    });
}

}  // namespace fulcrum::dialogue
