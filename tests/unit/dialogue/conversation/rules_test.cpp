#include "dialogue/conversation/conversation.h"
#include "tests/unit/dialogue/questions.h"

#include <catch2/catch.hpp>

#include <algorithm>
#include <set>

using namespace fulcrum::dialogue;

namespace {

std::string rule_for(const Question& question, std::string_view said) {
    const Mark mark = mark_answer(question, said);
    REQUIRE(mark.main_error() != nullptr);
    return rule_key(*mark.main_error());
}

}  // namespace

TEST_CASE("rules: each error has the rule that helps with it") {
    CHECK(rule_for(heaviest(), "a watermelon is the most heavy") == "rule.superlative.ending");
    CHECK(rule_for(heaviest(), "a watermelon is the heavyest") == "rule.superlative.ending");
    CHECK(rule_for(heaviest(), "a watermelon is heaviest") == "rule.superlative.the");
    CHECK(rule_for(heavier(), "an apple is more heavy than an egg") == "rule.comparative.ending");
    CHECK(rule_for(dearer(), "an apple is expensiver than an egg") == "rule.comparative.more_most");
    CHECK(rule_for(heavier(), "an apple is heavier then an egg") == "rule.than");
    CHECK(rule_for(heavier(), "an apple is the heavier than an egg") == "rule.article.extra");
    CHECK(rule_for(made_of(), "the ball is made by wood") == "rule.preposition");
    CHECK(rule_for(heaviest(), "watermelon is the heaviest") == "rule.article.missing");
    CHECK(rule_for(heaviest(), "a apple is the heaviest") == "rule.article.sound");
    CHECK(rule_for(heaviest(), "these watermelon is the heaviest") == "rule.this");
    CHECK(rule_for(feels_how(), "those metal is hard") == "rule.this");
    CHECK(rule_for(heaviest(), "a watermelon the heaviest") == "rule.verb.missing");
    CHECK(rule_for(heaviest(), "watermelons is the heaviest") == "rule.verb.agreement");
    CHECK(rule_for(heaviest(), "a watermelons is the heaviest") == "rule.noun.number");
    CHECK(rule_for(heaviest(), "a watermelon it is the heaviest") == "rule.pronoun.extra");
    CHECK(rule_for(heaviest(), "a watermelon be the heaviest") == "rule.verb.form");
    CHECK(rule_for(heaviest(), "a watermellon is the heaviest") == "rule.spelling");
}

TEST_CASE("rules: adjectives, materials and the passive have their own") {
    const Question made = made_of_what();
    CHECK(rule_for(made, "a key is made by metal") == "rule.passive.of");
    CHECK(rule_for(made, "a key is made metal") == "rule.passive.of");
    CHECK(rule_for(made, "a key is made from metal") == "rule.passive.from");
    CHECK(rule_for(made, "a key is make of metal") == "rule.passive.made");
    CHECK(rule_for(made, "a key is maked of metal") == "rule.passive.made");
    CHECK(rule_for(made, "a key is maid of metal") == "rule.passive.made");
    CHECK(rule_for(made, "a key makes of metal") == "rule.passive.voice");
    CHECK(rule_for(made, "a key made of metal") == "rule.passive.be");
    CHECK(rule_for(made, "a key has made of metal") == "rule.passive.be");
    CHECK(rule_for(made, "a key are made of metal") == "rule.verb.agreement");
    CHECK(rule_for(made, "a key is made of a metal") == "rule.article.material");
    CHECK(rule_for(made, "a key is made of metals") == "rule.noun.material");
    CHECK(rule_for(made, "key is made of metal") == "rule.article.missing");
    CHECK(rule_for(made, "is made of metal") == "rule.pronoun.missing");
    const Question feels = feels_how();
    CHECK(rule_for(feels, "metal is hardly") == "rule.adjective.form");
    CHECK(rule_for(feels, "metal is harder") == "rule.adjective.degree");
    CHECK(rule_for(feels, "metal is bumpey") == "rule.spelling");
    CHECK(rule_for(feels, "metal is a hard") == "rule.article.adjective");
    CHECK(rule_for(feels, "a metal is hard") == "rule.article.material");
    CHECK(rule_for(feels, "the metals are hard") == "rule.noun.material");
    CHECK(rule_for(feels, "metal is hard smooth") == "rule.and");
    CHECK(rule_for(feels, "metal is hard or smooth") == "rule.and");
    CHECK(rule_for(feels, "metal feels like hard") == "rule.preposition.extra");
    CHECK(rule_for(feels, "metal hard") == "rule.verb.missing");
    CHECK(rule_for(spaceship_of_what(), "they are made of metal") == "rule.pronoun.number");
    CHECK(rule_for(heaviest(), "its the apple") == "rule.contraction");
    CHECK(rule_for(compares_feel(), "wood is more soft than rock") == "rule.comparative.ending");
}

TEST_CASE("rules: every error that any template labels has a rule among the needed keys") {
    std::set<std::string> needed;
    for (const CatalogueNeed& need : conversation_needs()) {
        CHECK(needed.insert(std::string(need.key)).second);
    }
    for (int code = 1; code < kErrorCodes; ++code) {
        for (const Role role : {Role::word, Role::determiner, Role::noun, Role::adjective,
                                Role::verb, Role::preposition}) {
            FormError error;
            error.code = static_cast<ErrorCode>(code);
            error.role = role;
            error.base = "heavy";
            error.degree = Degree::superlative;
            INFO(error.errant());
            CHECK(needed.count(rule_key(error)) == 1);
        }
    }
}
