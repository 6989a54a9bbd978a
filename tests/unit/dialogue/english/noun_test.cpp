#include "dialogue/english/noun.h"

#include <catch2/catch.hpp>

#include <algorithm>

using namespace fulcrum::dialogue;

TEST_CASE("noun: a table of plurals") {
    const std::pair<const char*, const char*> rows[] = {
        {"apple", "apples"},    {"egg", "eggs"},          {"box", "boxes"},
        {"bus", "buses"},       {"glass", "glasses"},     {"peach", "peaches"},
        {"brush", "brushes"},   {"buzz", "buzzes"},       {"cherry", "cherries"},
        {"baby", "babies"},     {"toy", "toys"},          {"key", "keys"},
        {"leaf", "leaves"},     {"knife", "knives"},      {"roof", "roofs"},
        {"potato", "potatoes"}, {"photo", "photos"},      {"piano", "pianos"},
        {"man", "men"},         {"child", "children"},    {"foot", "feet"},
        {"tooth", "teeth"},     {"mouse", "mice"},        {"sheep", "sheep"},
        {"fish", "fish"},       {"person", "people"},     {"big foot", "big feet"},
        {"snowman", "snowmen"}, {"scissors", "scissors"}, {"planet", "planets"},
        {"axis", "axes"},       {"stomach", "stomachs"},  {"Child", "Children"},
        {"day", "days"}};
    for (const auto& [one, many] : rows) {
        INFO(one);
        CHECK(plural_of(one) == many);
    }
    CHECK(plural_of("").empty());
}

TEST_CASE("noun: what looks plural") {
    for (const char* word : {"apples", "feet", "children", "scissors", "boxes", "red apples"}) {
        INFO(word);
        CHECK(looks_plural(word));
    }
    for (const char* word :
         {"apple", "bus", "glass", "lens", "virus", "tennis", "sheep", "is", "gas", "watermelon"}) {
        INFO(word);
        CHECK_FALSE(looks_plural(word));
    }
}

TEST_CASE("noun: a list's entry tells its class") {
    const std::pair<const char*, NounClass> rows[] = {
        {"watermelon", NounClass::count},   {"an egg", NounClass::count},
        {"A ball", NounClass::count},       {"water", NounClass::mass},
        {"sandpaper", NounClass::mass},     {"a glass", NounClass::count},
        {"scissors", NounClass::plural},    {"apples", NounClass::plural},
        {"Jupiter", NounClass::name},       {"Moon", NounClass::named_the},
        {"the Moon", NounClass::named_the}, {"moon", NounClass::count},
        {"Earth", NounClass::name_or_the},  {"the Earth", NounClass::name_or_the},
        {"SUV", NounClass::count},          {"8", NounClass::name},
        {"the", NounClass::count}};
    for (const auto& [entry, noun_class] : rows) {
        INFO(entry);
        CHECK(understand_noun(entry).noun_class == noun_class);
    }
    CHECK(understand_noun("an egg").text == "egg");
    CHECK(understand_noun("the Moon").text == "Moon");
    CHECK(understand_noun("scissors").number() == Number::plural);
    CHECK(understand_noun("water").number() == Number::singular);
}

TEST_CASE("noun: wrong plurals that learners make are none of the right ones") {
    const auto wrong = [](const char* noun) { return learner_plurals(noun); };
    CHECK(wrong("foot") == std::vector<std::string>{"foots", "footes", "feets"});
    CHECK(wrong("city") == std::vector<std::string>{"citys", "cityes", "citiess"});
    for (const char* noun : {"man", "box", "moon", "sheep", "scissors", ""}) {
        INFO(noun);
        const auto forms = wrong(noun);
        CHECK(std::find(forms.begin(), forms.end(), plural_of(noun)) == forms.end());
    }
}

TEST_CASE("noun: the singular of a plural, and what has none") {
    const std::pair<const char*, const char*> rows[] = {{"windows", "window"},
                                                        {"boxes", "box"},
                                                        {"glasses", ""},
                                                        {"cities", "city"},
                                                        {"feet", "foot"},
                                                        {"scissors", "scissor"},
                                                        {"clothes", ""},
                                                        {"houses", "house"},
                                                        {"knives", "knife"},
                                                        {"benches", "bench"},
                                                        {"ties", "tie"},
                                                        {"metal", ""},
                                                        {"bus", ""},
                                                        {"glass", ""},
                                                        {"", ""},
                                                        {"blue doors", "blue door"},
                                                        {"pairs of scissors", "pair of scissors"}};
    for (const auto& [plural, singular] : rows) {
        INFO(plural);
        CHECK(singular_of(plural) == singular);
    }
    CHECK(is_plural_only("scissors"));
    CHECK_FALSE(is_plural_only("windows"));
}

TEST_CASE("noun: the head of a phrase with of carries its number and class") {
    CHECK(plural_of("pair of scissors") == "pairs of scissors");
    CHECK(plural_of("cup of tea") == "cups of tea");
    CHECK_FALSE(looks_plural("pair of scissors"));
    CHECK(understand_noun("pair of scissors").noun_class == NounClass::count);
    CHECK(understand_noun("cup of tea").noun_class == NounClass::count);
    CHECK(understand_noun("bars of gold").noun_class == NounClass::plural);
}

TEST_CASE("noun: materials are mass nouns; some have kinds") {
    for (const char* material : {"metal", "wood", "rubber", "glass", "paper", "sandpaper",
                                 "cardboard", "stainless steel", "aluminum"}) {
        INFO(material);
        CHECK(is_mass_noun(material));
    }
    CHECK(is_mass_noun("torque"));
    CHECK_FALSE(is_mass_noun("rock"));
    CHECK_FALSE(is_mass_noun("stone"));
    CHECK(has_kinds("metal"));
    CHECK_FALSE(has_kinds("glass"));
    CHECK_FALSE(has_kinds("rock"));
    CHECK(names_force("Lift"));
    CHECK_FALSE(names_force("pull"));
}

TEST_CASE("noun: numbers, places and what begins with a preposition are no nouns") {
    for (const char* entry : {"far", "near", "two", "twenty-one", "one hundred and five",
                              "a hundred", "to the left", "near the support", "Far away", "no"}) {
        INFO(entry);
        CHECK(understand_noun(entry).noun_class == NounClass::no_noun);
        CHECK(understand_noun(entry).text == entry);
    }
    CHECK(understand_noun("onion").noun_class == NounClass::count);
    CHECK(understand_noun("tooth").noun_class == NounClass::count);
    CHECK(understand_noun("the far side").noun_class == NounClass::named_the);
}

TEST_CASE("noun: adverbs, counts and answers of several words are no nouns") {
    for (const char* entry : {"equally fast", "just as fast", "more strongly", "high up", "a",
                              "none of them", "no one", "yeah", "underneath"}) {
        INFO(entry);
        CHECK(understand_noun(entry).noun_class == NounClass::no_noun);
    }
    CHECK(understand_noun("high tower").noun_class == NounClass::count);
    CHECK(understand_noun("all-rounder").noun_class == NounClass::count);
    CHECK(understand_noun("Earth's gravity").noun_class == NounClass::name_or_the);
}

TEST_CASE("noun: comparatives of what describes describe, too") {
    for (const char* adjective : {"light", "lighter", "stronger", "bigger", "Easier"}) {
        INFO(adjective);
        CHECK(describes(adjective));
    }
    CHECK_FALSE(describes("water"));
    CHECK_FALSE(describes("letter"));
}
