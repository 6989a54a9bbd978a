// Questions that several tests ask.
#pragma once

#include "dialogue/marking/question.h"
#include "tests/unit/dialogue/rig.h"

namespace fulcrum::dialogue {

/// Compiles or throws, so that a test fails with the reason.
inline Question compiled(const QuestionSource& source) {
    auto question = compile_question(source);
    if (!question) {
        throw std::runtime_error(question.error().message + " at column " +
                                 std::to_string(question.error().column));
    }
    return *question;
}

inline TemplateSet compiled_templates(const TemplateSource& source) {
    auto set = compile_templates(source);
    if (!set) {
        throw std::runtime_error(set.error().message + " at column " +
                                 std::to_string(set.error().column));
    }
    return std::move(*set);
}

inline const NamedLists& fruit() {
    static const NamedLists lists{{"thing", {"watermelon", "apple", "banana", "egg"}}};
    return lists;
}

inline Question heaviest() {
    return compiled({"heaviest",
                     "Which one is the heaviest?",
                     {"[a|an|the] {thing} is the <superlative:heavy> [one|object|fruit]",
                      "the <superlative:heavy> [one|object|fruit] is <article> {thing}"},
                     fruit()});
}

inline Question heavier() {
    return compiled({"heavier",
                     "Which is heavier, an apple or an egg?",
                     {"<article> {thing} is <comparative:heavy> [than <article> {thing:other}]"},
                     fruit()});
}

inline Question biggest() {
    return compiled({"biggest",
                     "Which one is the biggest?",
                     {"[the] {body} is the <superlative:big>"},
                     {{"body", {"Jupiter", "Mars", "the Moon", "Earth"}}}});
}

inline Question made_of() {
    return compiled(
        {"made",
         "What is it made of?",
         {"the {thing} is made of {material}"},
         {{"thing", {"ball", "knife", "scissors"}}, {"material", {"metal", "wood", "rubber"}}}});
}

inline Question dearer() {
    return compiled({"dearer",
                     "Which one is more expensive?",
                     {"<article> {thing} is <comparative:expensive> than <article> {thing:other}"},
                     fruit()});
}

inline Question moons() {
    return compiled({"moons",
                     "How many moons does it have?",
                     {"{planet} has {number} <plural:moon>"},
                     {{"planet", {"Mars", "Earth"}}, {"number", {"2", "8", "21"}}}});
}

inline Question weighs() {
    return compiled({"weighs",
                     "What weighs more?",
                     {"<article> {thing} weighs more than <article> {thing:other}"},
                     fruit()});
}

/// The things and materials of a lesson on textures.
inline const NamedLists& textures() {
    static const NamedLists lists{
        {"thing",
         {"spaceship", "table", "chair", "windows", "scissors", "bottle", "tyre", "ball", "castle",
          "statue", "cup", "book", "pencil", "door", "boat", "key", "coin"}},
        {"material", {"metal", "wood", "rock", "stone", "rubber", "glass", "paper", "sandpaper"}},
        {"feel", {"hard", "soft", "smooth", "rough", "bumpy", "slippery", "sticky"}}};
    return lists;
}

inline Question made_of_what() {
    return compiled({"made_of_what",
                     "What is it made of?",
                     {"[a|an|the] {thing} <made_of:{material}>"},
                     textures()});
}

inline Question spaceship_of_what() {
    return compiled({"spaceship_of_what",
                     "What is the spaceship made of?",
                     {"(the|a) spaceship <made_of:{material}>"},
                     textures()});
}

inline Question scissors_of_what() {
    return compiled({"scissors_of_what",
                     "What are the scissors made of?",
                     {"[the|these] scissors <made_of:{material}>"},
                     textures()});
}

inline Question what_of_metal() {
    return compiled({"what_of_metal",
                     "Which thing is made of metal?",
                     {"[the|a|an] {thing} <made_of:metal>"},
                     textures()});
}

inline Question feels_how() {
    return compiled({"feels_how",
                     "How does it feel?",
                     {"{material} (is|feels) <adjective:{feel}> [and <adjective:{feel:also}>]"},
                     textures()});
}

inline Question feels_two() {
    return compiled({"feels_two",
                     "Say two words.",
                     {"{material} (is|feels) <adjective:{feel}> and <adjective:{feel:also}>"},
                     textures()});
}

inline Question compares_feel() {
    return compiled({"compares_feel",
                     "How do they differ?",
                     {"{material} (is|feels) <comparative:{feel}> than {material:other}"},
                     textures()});
}

inline Question most_of_feel() {
    return compiled({"most_of_feel",
                     "What can you tell?",
                     {"{material} is the <superlative:{feel}> [material]"},
                     textures()});
}

/// All of them, each once.
inline std::vector<Question> all_questions() {
    return {heaviest(),
            heavier(),
            biggest(),
            made_of(),
            dearer(),
            moons(),
            weighs(),
            made_of_what(),
            spaceship_of_what(),
            scissors_of_what(),
            what_of_metal(),
            feels_how(),
            feels_two(),
            compares_feel(),
            most_of_feel(),
            compiled({"any_order", "Say it.", {"(it is heavy;really) [now]"}, {}}),
            compiled({"quiet",
                      "Which is quieter?",
                      {"(this|that) <thing> is <comparative:quiet>"},
                      {{"noun", {"bell|gong", "herb", "hour"}}},
                      {{"thing", "{noun}"}}}),
            compiled({"best",
                      "Which one is the best?",
                      {"{thing} (is|was) <superlative:good>"},
                      {{"thing", {"tea", "a cup"}}}})};
}

}  // namespace fulcrum::dialogue
