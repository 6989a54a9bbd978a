#include "haptics/point/solid_plan.h"
#include "haptics/surface/friction.h"
#include "haptics/surface/material.h"
#include "haptics/surface/materials.h"
#include "haptics/surface/surface_plan.h"
#include "haptics/surface/texture.h"
#include "haptics/surface/texture_settings.h"
#include "haptics/surface/transient_settings.h"
#include "tests/support/bad_numbers.h"

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <memory>
#include <set>
#include <vector>

using namespace fulcrum;

namespace {

Material make_good() {
    Material material;
    material.name = "cork";
    material.friction = {0.5, 0.4, 0.0};
    material.texture.source = SineTexture{};
    material.texture.law = TextureLaw::lateral;
    material.transient.kind = TransientKind::decaying_sinusoid;
    material.coupling.stiffness_N_per_m = 321.0;
    return material;
}

MaterialFacts facts_of(const char* name) {
    const Material* material = find_material(name);
    REQUIRE(material != nullptr);
    return describe(*material);
}

// A number of some settings, with its range.
template <class Settings>
struct Bounds {
    double Settings::*field;
    double low, high;
};

// Accepted at its bounds, refused just past them and where it is no number.
template <class Settings>
void check_bounds(const Settings& good, std::initializer_list<Bounds<Settings>> all) {
    REQUIRE(validate(good));
    int n = 0;
    for (const Bounds<Settings>& bounds : all) {
        CAPTURE(n++);
        const auto accepts = [&](double value) {
            Settings settings = good;
            settings.*bounds.field = value;
            return validate(settings).has_value();
        };
        CHECK(accepts(bounds.low));
        CHECK(accepts(bounds.high));
        CHECK_FALSE(accepts(bounds.low - 1.0e-6));
        CHECK_FALSE(accepts(bounds.high * 1.001));
        CHECK_FALSE(accepts(kNan));
    }
}

TextureSettings with(const TextureSource& source) {
    TextureSettings settings;
    settings.source = source;
    return settings;
}
TextureSettings make_image(HeightMap map, double tile_m = 0.05) {
    return with(ImageTexture{std::make_shared<const HeightMap>(std::move(map)), tile_m, tile_m});
}
std::string refusal(const TextureSettings& settings) {
    const auto valid = validate(settings);
    return valid ? "" : to_sentence(valid.error());
}

}  // namespace

TEST_CASE("material: every part is checked, and the sentence names the material") {
    CHECK(validate(make_good()));
    Material nameless = make_good();
    nameless.name.clear();
    CHECK_FALSE(validate(nameless));
    const auto refused = [](auto spoil) {
        Material material = make_good();
        spoil(material);
        const auto valid = validate(material);
        return !valid && to_sentence(valid.error()).find("cork: ") == 0;
    };
    CHECK(refused([](Material& m) { m.coupling.stiffness_N_per_m = -1.0; }));
    CHECK(refused([](Material& m) { m.friction.dynamic_coefficient = -1.0; }));
    CHECK(refused([](Material& m) { m.texture.height_m = 1.0; }));
    CHECK(refused([](Material& m) { m.transient.decay_per_s = 0.0; }));
}

TEST_CASE("material: a body made of it has its numbers, and grades are even in the logarithm") {
    SolidPlan solid;
    solid.surface.shading = {true, 12.0};
    solid.surface.audible = true;
    put_material(make_good(), solid);
    REQUIRE(solid.coupling);
    CHECK(solid.coupling->stiffness_N_per_m == 321.0);
    CHECK(solid.friction.static_coefficient == 0.5);
    CHECK(std::holds_alternative<SineTexture>(solid.surface.texture.source));
    CHECK(solid.surface.transient.kind == TransientKind::decaying_sinusoid);
    CHECK(solid.surface.shading.on);
    CHECK(solid.surface.shading.crease_angle_deg == 12.0);
    CHECK(solid.surface.audible);
    const GradeScale scale{10.0, 1000.0};
    CHECK(compute_grade(10.0, scale) == 0.0);
    CHECK(compute_grade(100.0, scale) == Approx(0.5));
    CHECK(compute_grade(1000.0, scale) == Approx(1.0));
    CHECK(compute_grade(1.0e9, scale) == 1.0);
    for (const double none : {0.0, -1.0, 9.0, std::nan("")}) {
        CHECK(compute_grade(none, scale) == 0.0);
    }
}

TEST_CASE("material: what it is like follows from its numbers alone") {
    const Material base = make_good();
    const MaterialFacts facts = describe(base);
    // Grooves of 2 mm, 0.1 mm deep.
    CHECK(facts.rms_height_m == Approx(0.5e-4 / std::sqrt(2.0)).epsilon(0.001));
    CHECK(facts.stiffness_N_per_m == 321.0);
    CHECK(facts.ringing_Hz == 100.0);
    CHECK(facts.dynamic_coefficient == 0.4);
    const auto changed = [&base](auto change) {
        Material other = base;
        change(other);
        return describe(other);
    };
    CHECK(changed([](Material& m) { m.coupling.stiffness_N_per_m *= 2.0; }).hardness >
          facts.hardness);
    CHECK(changed([](Material& m) { m.transient.frequency_Hz /= 2.0; }).hardness < facts.hardness);
    CHECK(changed([](Material& m) { m.transient.kind = TransientKind::none; }).hardness ==
          compute_grade(321.0, kStiffnessScale));
    CHECK(changed([](Material& m) { m.texture.height_m *= 2.0; }).roughness > facts.roughness);
    CHECK(changed([](Material& m) {
              m.texture.source = SineTexture{0.02, 0.0};
          }).roughness < facts.roughness);
    CHECK(changed([](Material& m) { m.texture.source = {}; }).roughness == 0.0);
    CHECK(changed([](Material& m) { m.friction.dynamic_coefficient /= 2.0; }).slipperiness >
          facts.slipperiness);
    CHECK(changed([](Material& m) { m.name = "butter"; }).hardness == facts.hardness);
}

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

TEST_CASE(
    "materials: words part at the middle, each differs from all, what is harder rings higher") {
    const auto told = [](double hardness, double roughness, double slipperiness) {
        const FeltWords words = felt_words(hardness, roughness, slipperiness);
        return std::string(words.hardness) + " " + words.roughness + " " + words.slipperiness;
    };
    CHECK(told(0.5, 0.5, 0.5) == "hard rough slippery");
    CHECK(told(0.49, 0.49, 0.49) == "soft smooth ");
    CHECK(told(1.0, 0.0, 0.15) == "hard smooth ");
    CHECK(told(1.0, 0.0, 0.149) == "hard smooth sticky");
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
    CHECK(facts_of("rubber").ringing_Hz == 18.0);
    CHECK(facts_of("wood").ringing_Hz == 30.0);
    CHECK(facts_of("metal").ringing_Hz == 100.0);
    CHECK(facts_of("rubber").hardness < facts_of("wood").hardness);
    CHECK(facts_of("wood").hardness < facts_of("metal").hardness);
}

// What a surface may be set to: friction, texture, transient, shading, and the plan of them all.

TEST_CASE("surface settings: bounds are accepted, past them refused; one part makes an effect") {
    check_bounds<TransientSettings>({}, {{&TransientSettings::force_Ns_per_m, 0.0, 100.0},
                                         {&TransientSettings::acceleration_per_s, 0.0, 1.0e4},
                                         {&TransientSettings::frequency_Hz, 5.0, 1000.0},
                                         {&TransientSettings::decay_per_s, 5.0, 2000.0},
                                         {&TransientSettings::pulse_s, 0.001, 0.1},
                                         {&TransientSettings::max_force_N, 0.1, 10.0},
                                         {&TransientSettings::energy_share, 0.0, 1.0}});
    check_bounds<ShadingSettings>({true, 10.0}, {{&ShadingSettings::crease_angle_deg, 0.0, 180.0}});
    check_bounds(with(SineTexture{}), {{&TextureSettings::height_m, 1.0e-7, 0.01},
                                       {&TextureSettings::gain, 0.0, 100.0}});
    check_bounds<FrictionSettings>({5.0, 0.4, 2.0},
                                   {{&FrictionSettings::static_coefficient, 0.4, 5.0},
                                    {&FrictionSettings::dynamic_coefficient, 0.0, 5.0},
                                    {&FrictionSettings::viscous_Ns_per_m, 0.0, 100.0}});
    CHECK_FALSE(validate(FrictionSettings{0.3, 0.4, 0.0}));
    CHECK_FALSE(FrictionSettings{}.any());
    CHECK(FrictionSettings{0.1, 0.0, 0.0}.any());
    CHECK(FrictionSettings{0.0, 0.0, 0.1}.any());
    TransientSettings transient;
    CHECK_FALSE(transient.any());
    transient.kind = TransientKind::fixed_pulse;
    CHECK(transient.any());
    // A texture with a source and a gain.
    TextureSettings texture;
    CHECK_FALSE(texture.any());
    CHECK(validate(texture));
    texture.source = SineTexture{};
    CHECK(texture.any());
    texture.gain = 0.0;
    CHECK_FALSE(texture.any());
}

TEST_CASE("surface settings: a plan that asks for nothing is good, and each part is checked") {
    CHECK(validate(SurfacePlan{}));
    SurfacePlan texture;
    texture.texture.gain = -1.0;
    CHECK_FALSE(validate(texture));
    SurfacePlan transient;
    transient.transient.pulse_s = 1.0;
    CHECK_FALSE(validate(transient));
    SurfacePlan shading;
    shading.shading.crease_angle_deg = 181.0;
    REQUIRE_FALSE(validate(shading));
    CHECK(to_sentence(validate(shading).error()).find("0 to 180") != std::string::npos);
}

TEST_CASE("surface settings: an image has one height from 0 to 1 at each place") {
    CHECK(refusal(make_image({2, 2, {0.0F, 0.5F, 1.0F, 0.0F}})).empty());
    CHECK(refusal(make_image({1, 1, {0.5F}})).empty());
    CHECK(refusal(make_image({2, 2, {0.0F, 0.5F, 1.0F}})).find("3 heights and 4 places") !=
          std::string::npos);
    CHECK(refusal(make_image({2, 1, {0.0F, 1.01F}})).find("not 0 to 1") != std::string::npos);
    CHECK(refusal(with(ImageTexture{})).find("no height map") != std::string::npos);
    for (const TextureSettings& bad :
         {make_image({2, 1, {0.0F, -0.01F}}), make_image({2, 1, {0.0F, std::nanf("")}}),
          make_image({0, 1, {}}), make_image({4097, 1, std::vector<float>(4097)}),
          make_image({1, 1, {0.5F}}, 0.0), make_image({1, 1, {0.5F}}, 101.0)}) {
        CHECK_FALSE(refusal(bad).empty());
    }
}

TEST_CASE("surface settings: grooves and bumps are held to their ranges") {
    for (const TextureSource& good : std::initializer_list<TextureSource>{
             SineTexture{1.0e-4, -100.0}, SineTexture{1.0, 100.0}, NoiseTexture{0.001, 0.001, 3},
             NoiseTexture{0.001, 0.064, 3}}) {
        CHECK(refusal(with(good)).empty());
    }
    for (const TextureSource& bad : std::initializer_list<TextureSource>{
             SineTexture{0.9e-4, 0.0}, SineTexture{1.1, 0.0}, SineTexture{0.01, kNan},
             SineTexture{kNan, 0.0}, NoiseTexture{0.001, 0.065, 3},  // too wide a band
             NoiseTexture{0.002, 0.001, 3},                          // the longest is the shorter
             NoiseTexture{0.9e-4, 0.001, 3}, NoiseTexture{0.5, 1.1, 3},
             NoiseTexture{kNan, 0.001, 3}, NoiseTexture{0.001, kNan, 3}}) {
        CHECK_FALSE(refusal(with(bad)).empty());
    }
}
