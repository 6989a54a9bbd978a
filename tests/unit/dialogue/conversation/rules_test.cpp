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
    CHECK(rule_for(heaviest(), "a watermelon the heaviest") == "rule.verb.missing");
    CHECK(rule_for(heaviest(), "watermelons is the heaviest") == "rule.verb.agreement");
    CHECK(rule_for(heaviest(), "a watermelons is the heaviest") == "rule.noun.number");
    CHECK(rule_for(heaviest(), "a watermelon it is the heaviest") == "rule.pronoun.extra");
    CHECK(rule_for(heaviest(), "a watermelon be the heaviest") == "rule.verb.form");
    CHECK(rule_for(heaviest(), "a watermellon is the heaviest") == "rule.spelling");
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
