#include "haptics/surface/materials.h"

#include "haptics/surface/texture.h"

#include <catch2/catch.hpp>

#include <algorithm>
#include <set>
#include <vector>

using namespace fulcrum;

namespace {

MaterialFacts facts_of(const char* name) {
    const Material* material = find_material(name);
    REQUIRE(material != nullptr);
    return describe(*material);
}

}  // namespace

TEST_CASE("materials: all that are promised ship, are good, and have names of their own") {
    std::set<std::string> names;
    for (const Material& material : shipped_materials()) {
        INFO(material.name);
        CHECK(validate(material));
        CHECK(names.insert(material.name).second);
        CHECK(find_material(material.name) == &material);
        CHECK(material.friction.any());
        CHECK(material.transient.any());
    }
    for (const char* name : {"wood", "metal", "rock", "rubber", "glass", "paper", "sandpaper"}) {
        CHECK(names.count(name) == 1);
    }
    CHECK(find_material("cheese") == nullptr);
}

TEST_CASE("materials: what people say of them is true of their numbers") {
    struct Said {
        double MaterialFacts::*grade;
        double low, high;  // from, and below
        std::vector<const char*> names;
    };
    constexpr double kAny = 2.0;
    const Said all[] = {
        {&MaterialFacts::hardness, kGradeMiddle, kAny, {"wood", "metal", "rock", "glass"}},
        {&MaterialFacts::hardness, 0.0, kGradeMiddle, {"rubber"}},
        {&MaterialFacts::roughness, kGradeMiddle, kAny, {"rock", "sandpaper", "wood"}},
        {&MaterialFacts::roughness, 0.0, kGradeMiddle, {"metal", "glass", "paper", "rubber"}},
        {&MaterialFacts::slipperiness, kGradeMiddle, kAny, {"metal", "glass"}},
        {&MaterialFacts::slipperiness, 0.0, kStickyBelow, {"rubber", "sandpaper"}},
        {&MaterialFacts::slipperiness, kStickyBelow, kGradeMiddle, {"wood", "rock"}}};
    for (const Said& said : all) {
        for (const char* name : said.names) {
            CAPTURE(name, said.low, said.high);
            CHECK(facts_of(name).*said.grade >= said.low);
            CHECK(facts_of(name).*said.grade < said.high);
        }
    }
}

TEST_CASE("materials: the words part at the middle, and between slippery and sticky is neither") {
    const auto told = [](double hardness, double roughness, double slipperiness) {
        const FeltWords words = felt_words(hardness, roughness, slipperiness);
        return std::string(words.hardness) + " " + words.roughness + " " + words.slipperiness;
    };
    CHECK(told(0.5, 0.5, 0.5) == "hard rough slippery");
    CHECK(told(0.49, 0.49, 0.49) == "soft smooth ");
    CHECK(told(1.0, 0.0, 0.15) == "hard smooth ");
    CHECK(told(1.0, 0.0, 0.149) == "hard smooth sticky");
}

TEST_CASE("materials: each differs from each other in something that is felt") {
    const auto all = shipped_materials();
    for (const Material& one : all) {
        for (const Material& other : all) {
            if (&one != &other) {
                const MaterialFacts a = describe(one);
                const MaterialFacts b = describe(other);
                INFO(one.name << " and " << other.name);
                CHECK(std::max({std::abs(a.hardness - b.hardness),
                                std::abs(a.roughness - b.roughness),
                                std::abs(a.slipperiness - b.slipperiness)}) > 0.05);
            }
        }
    }
}

TEST_CASE("materials: what is harder rings higher, as is written for each") {
    CHECK(facts_of("rubber").ringing_Hz == 18.0);
    CHECK(facts_of("wood").ringing_Hz == 30.0);
    CHECK(facts_of("metal").ringing_Hz == 100.0);
    CHECK(facts_of("rubber").hardness < facts_of("wood").hardness);
    CHECK(facts_of("wood").hardness < facts_of("metal").hardness);
}
