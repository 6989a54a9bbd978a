// What bodies are made of: the program's own materials, and those that a lesson makes out of them or out of a picture.
#include "runtime/effect/surface/declare_material.h"

#include "haptics/coupling/virtual_coupling.h"
#include "haptics/surface/materials.h"
#include "runtime/effect/surface/material_fields.h"
#include "runtime/lua/api/binding_table.h"
#include "runtime/lua/api/lesson_context.h"
#include "runtime/lua/api/take_fields.h"

#include <algorithm>
#include <sstream>

namespace fulcrum::runtime {
namespace {

/// How much of the bumps' widest wave the narrowest has.
constexpr double kNarrowBumps = 0.25;
constexpr double kLinearShare = 0.5;   // of the most that a spring gives, up to where it is linear
constexpr double kSlidingShare = 0.8;  // of the friction that holds, while it slides

void take_texture(lua_State* lua, const Arguments& given, MaterialDescription& material) {
    TextureSettings& texture = material.felt.texture;
    const int n_sources = static_cast<int>(given["image"].given) +
                          static_cast<int>(given["grooves"].given) +
                          static_cast<int>(given["bumps"].given);
    if (n_sources > 1) {
        raise_in_lesson(lua, "material.texture has an image, grooves or bumps; give one of them");
    }
    if (given["image"].given) {
        material.image = given["image"].text;
        if (!is_picture_name(material.image)) {
            raise_in_lesson(lua,
                            "material.texture.image is the name of a .png, .jpg or .jpeg file "
                            "beside the lesson, in letters a to z, digits, blanks, \"-\" and "
                            "\"_\"; got \"" +
                                clean_text(material.image, kMaxNameBytes) + '"');
        }
        texture.source = ImageTexture{nullptr, given["size"].number, given["size"].number};
    } else if (given["grooves"].given) {
        material.image.clear();
        texture.source = SineTexture{given["grooves"].number, 0.0};
    } else if (given["bumps"].given) {
        material.image.clear();
        const double widest_m = given["bumps"].number;
        texture.source =
            NoiseTexture{std::max(kNarrowBumps * widest_m, fields::kLeastRelief_m), widest_m, 1};
    } else if (!texture.any()) {
        raise_in_lesson(lua, "material.texture has no relief; give it image, grooves or bumps");
    }
    take_fields(fields::kTexture, given, texture);
}

void take_tap(lua_State* lua, const Arguments& given, TransientSettings& transient) {
    transient.kind = TransientKind::decaying_sinusoid;
    take_fields(fields::kTap, given, transient);
    if (given["time"].given) {
        transient.decay_per_s = 1.0 / given["time"].number;
    }
    const bool matches = transient.kind == TransientKind::acceleration_matching;
    const bool pulses = transient.kind == TransientKind::fixed_pulse;
    const bool rings = matches || transient.kind == TransientKind::decaying_sinusoid;
    const std::pair<const char*, bool> uses[] = {{"frequency", rings},
                                                 {"time", rings},
                                                 {"strength", transient.any() && !matches},
                                                 {"acceleration", matches},
                                                 {"length", pulses}};
    for (const auto& [name, is_used] : uses) {
        if (given[name].given && !is_used) {
            raise_in_lesson(lua,
                            std::string("material.tap.") + name + " is of no use with kind = \"" +
                                (given["kind"].given ? given["kind"].text : "decaying_sinusoid") +
                                "\"; leave it out");
        }
    }
}

// A spring that yields already, as of `like`, is laid out anew upon what the lesson says of its stiffness.
void take_saturation(lua_State* lua, const Arguments& arguments, CouplingSettings& coupling) {
    if (arguments["saturation"].given) {
        const Arguments& given = arguments.record("saturation");
        if (!given["force"].given) {
            raise_in_lesson(lua,
                            "material.saturation has no force; say how many newtons its spring "
                            "gives at most");
        }
        coupling.linear_range_m = kLinearShare * given["force"].number / coupling.stiffness_N_per_m;
        take_fields(fields::kSaturation, given, coupling);
    } else if (!coupling.saturates()) {
        return;
    }
    const double linear_N = coupling.stiffness_N_per_m * coupling.linear_range_m;
    if (!(linear_N < coupling.saturation_force_N)) {
        std::ostringstream most;
        most << coupling.saturation_force_N / coupling.stiffness_N_per_m;
        raise_in_lesson(lua,
                        "material.saturation: its spring gives the force before the linear "
                        "range ends; give it more force, or a linear_range below " +
                            most.str());
    }
    coupling = saturate(coupling, coupling.linear_range_m, coupling.saturation_force_N);
}

std::int32_t add_material(lua_State* lua, LessonContext& context, MaterialDescription material) {
    std::vector<MaterialDescription>& materials = context.description.materials;
    if (materials.size() >= kMaxMaterials) {
        raise_in_lesson(lua,
                        "a lesson has at most " + std::to_string(kMaxMaterials) + " materials");
    }
    materials.push_back(std::move(material));
    return static_cast<std::int32_t>(materials.size()) - 1;
}

/// The program's own of that name; raises with the names that there are.
const Material& own_material(lua_State* lua, const std::string& name) {
    std::vector<std::string> names;
    for (const Material& material : shipped_materials()) {
        if (material.name == name) {
            return material;
        }
        names.push_back(material.name);
    }
    std::string listed;
    for (const std::string& each : names) {
        listed += (listed.empty() ? "" : ", ") + each;
    }
    const std::string near = nearest_word(name, names);
    raise_in_lesson(lua,
                    "there is no material \"" + clean_text(name, kMaxNameBytes) + "\"; " +
                        (near.empty() ? "there are " + listed + ", and what world:material makes"
                                      : "did you mean \"" + near + "\"?"));
}

int make_material(lua_State* lua, LessonContext& context, const Arguments& arguments) {
    MaterialDescription material;
    if (arguments["like"].given) {
        const std::string& like = arguments["like"].text;
        const auto& made = context.description.materials;
        const auto found = std::ranges::find_if(
            made, [&](const MaterialDescription& m) { return m.felt.name == like; });
        material.felt = found != made.end() ? found->felt : own_material(lua, like);
        material.look = found != made.end() ? found->look : like;
        material.image = found != made.end() ? found->image : std::string();
    }
    FrictionSettings& friction = material.felt.friction;
    if (arguments["friction"].given) {
        friction.dynamic_coefficient = kSlidingShare * arguments["friction"].number;
    }
    take_fields(fields::kMaterial, arguments, material.felt);
    take_saturation(lua, arguments, material.felt.coupling);
    material.line = place_in_lesson(lua).line;
    const auto& others = context.description.materials;
    if (std::ranges::any_of(others, [&](const MaterialDescription& other) {
            return other.felt.name == material.felt.name;
        })) {
        raise_in_lesson(lua, "there is already a material \"" + material.felt.name +
                                 "\"; give this one another name");
    }
    if (friction.dynamic_coefficient > friction.static_coefficient) {
        raise_in_lesson(lua,
                        "material.sliding_friction is more than friction; what slides is never "
                        "held more than what rests");
    }
    if (arguments["texture"].given) {
        take_texture(lua, arguments.record("texture"), material);
    }
    if (arguments["tap"].given) {
        take_tap(lua, arguments.record("tap"), material.felt.transient);
    }
    push_handle(lua, Handle::Kind::material, add_material(lua, context, std::move(material)));
    return 1;
}

const Material& felt_of(const LessonContext& context, std::int32_t index) {
    return context.description.materials[static_cast<std::size_t>(index)].felt;
}

int get_felt_name(lua_State* lua, LessonContext& context, std::int32_t index) {
    return push_text(lua, felt_of(context, index).name);
}

/// A number of the surface as a field.
template <auto kNumber>
int get_number(lua_State* lua, LessonContext& context, std::int32_t index) {
    lua_pushnumber(lua, kNumber(felt_of(context, index)));
    return 1;
}

/// A grade as a field: the program finds it out once a picture's heights are read too.
const MaterialGrades& grades_of(lua_State* lua, const LessonContext& context, std::int32_t index) {
    const auto i = static_cast<std::size_t>(index);
    if (i >= context.grades.size()) {
        raise_in_lesson(lua,
                        "what a material is like is known once the lesson runs, in L:update and "
                        "later, not in L:start");
    }
    return context.grades[i];
}

template <auto kGrade>
int get_grade(lua_State* lua, LessonContext& context, std::int32_t index) {
    lua_pushnumber(lua, grades_of(lua, context, index).*kGrade);
    return 1;
}

int get_stiffness(lua_State* lua, LessonContext& context, std::int32_t index) {
    const auto i = static_cast<std::size_t>(index);
    lua_pushnumber(lua, i < context.grades.size()
                            ? context.grades[i].stiffness_N_per_m
                            : felt_of(context, index).coupling.stiffness_N_per_m);
    return 1;
}

/// The words that are true of it: { hard = true, smooth = true }.
int get_words(lua_State* lua, LessonContext& context, std::int32_t index) {
    const MaterialGrades& grades = grades_of(lua, context, index);
    const FeltWords words = felt_words(grades.hardness, grades.roughness, grades.slipperiness);
    lua_newtable(lua);
    for (const char* word : {words.hardness, words.roughness, words.slipperiness}) {
        if (*word != '\0') {
            lua_pushboolean(lua, 1);
            lua_setfield(lua, -2, word);
        }
    }
    return 1;
}

double ring_of(const Material& material) {
    const TransientKind kind = material.transient.kind;
    const bool rings =
        kind == TransientKind::decaying_sinusoid || kind == TransientKind::acceleration_matching;
    return rings ? material.transient.frequency_Hz : 0.0;
}

void add_material_properties(ApiTable& table) {
    const auto add = [&table](const char* property, const char* unit, const char* text,
                              int (*get)(lua_State*, LessonContext&, std::int32_t)) {
        table.properties.push_back({"material", property, "number", unit, text, get});
    };
    table.properties.push_back({"material", "name", "string", "", "", &get_felt_name});
    add("hardness", "",
        "0 (soft) to 1, hard from 0.5 on: from the stiffness of its spring and the tone of a tap",
        &get_grade<&MaterialGrades::hardness>);
    add("roughness", "",
        "0 (smooth) to 1, rough from 0.5 on: from its relief and how it pushes sideways",
        &get_grade<&MaterialGrades::roughness>);
    add("slipperiness", "",
        "0 to 1, slippery from 0.5 on, sticky below 0.15: from its friction while it slides",
        &get_grade<&MaterialGrades::slipperiness>);
    table.properties.push_back({"material", "words", "table<string, boolean>", "",
                                "what is true of it: hard or soft, rough or smooth, slippery or "
                                "sticky or neither; material.words.hard is true or nil",
                                &get_words});
    add("stiffness", "newtons per metre",
        "of its spring: as it was declared until the lesson runs, then as it is felt, which is "
        "softer where the device in the hand would shake; `hardness` follows it",
        &get_stiffness);
    add("friction", "", "what holds a resting hand, in parts of how hard it presses",
        &get_number<[](const Material& m) { return m.friction.static_coefficient; }>);
    add("ring", "hertz", "the tone of a tap; 0 when it has none", &get_number<&ring_of>);
}

}  // namespace

std::int32_t find_or_add_material(lua_State* lua, LessonContext& context, const Argument& given) {
    if (!given.given || given.material >= 0) {
        return given.given ? given.material : kNoMaterial;
    }
    const auto& made = context.description.materials;
    for (std::size_t i = 0; i < made.size(); ++i) {
        if (made[i].felt.name == given.text) {
            return static_cast<std::int32_t>(i);
        }
    }
    MaterialDescription material;
    material.felt = own_material(lua, given.text);
    material.look = given.text;
    material.line = place_in_lesson(lua).line;
    return add_material(lua, context, std::move(material));
}

void add_material_api(ApiTable& table) {
    table.functions.push_back(
        {"world", "material", CallShape::record, CallTime::declaring, rows_of(fields::kMaterial),
         "Material",
         "Makes a material for bodies: out of another one, out of numbers, or out of a picture.",
         &make_material});
    add_material_properties(table);
}

}  // namespace fulcrum::runtime
