#include "dialogue/template/variant_texts.h"

#include "tests/unit/dialogue/questions.h"

#include <catch2/catch.hpp>

#include <algorithm>

using namespace fulcrum::dialogue;

namespace {

std::vector<Variant> made(const std::string& text) {
    TemplateSource source{{text}, fruit(), {}};
    source.lists.emplace_back("other", fruit()[0].second);
    return variants_of(compiled_templates(source), {}, text);
}

bool has(const std::vector<Variant>& variants, const std::string& text, Claim claim) {
    return std::ranges::any_of(variants, [&](const Variant& variant) {
        return variant.text == text && variant.claim == claim;
    });
}

}  // namespace

TEST_CASE("variant texts: the author's own words stay around what is said otherwise") {
    const auto compared = made("[the|a] {thing} is <comparative:heavy> [than [the|a] {other}]");
    CHECK(has(compared, "[the|a] {other} is not (as|so) (<adjective:heavy>)  as [the|a] {thing}",
              Claim::same));
    CHECK(has(compared,
              "[the|a] {thing} is the (<comparative:heavy>) (one|of the two|one of the two)",
              Claim::same));
    const auto denied = made("[(it|the bowl) is] under the {thing}");
    REQUIRE(denied.size() == 1);
    CHECK(denied[0].text == "(it|the bowl) is not under the {thing}");
    CHECK(denied[0].about == "thing");
}

TEST_CASE("variant texts: only what is on one scale has an opposite, and only what weighs a verb") {
    const auto far = made("the {thing} is <comparative:far> than the {other}");
    CHECK(std::ranges::none_of(far, [](const Variant& variant) {
        return variant.text.find("weigh") != std::string::npos ||
               variant.text.find("near") != std::string::npos;
    }));
    const auto deed = made("it weighs {thing}");
    REQUIRE(deed.size() == 1);
    CHECK(deed[0].text == "it does not weigh {thing}");
    CHECK(deed[0].claim == Claim::excluded);
    CHECK(made("it is heavy").empty());
    CHECK(made("what is {thing}").empty());
}
