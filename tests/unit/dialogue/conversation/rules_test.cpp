#include "dialogue/conversation/conversation.h"
#include "tests/unit/dialogue/questions.h"

#include <catch2/catch.hpp>

#include <algorithm>
#include <set>

using namespace fulcrum::dialogue;

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
