// What a lesson may say, the wire carries: every number of every row of the table, at both ends of its range.
#include "runtime/lua/api/binding_table.h"
#include "runtime/lua/wire/wire.h"
#include "tests/unit/runtime/lua/hosted_lesson.h"
#include "tests/unit/runtime/rig.h"

#include <cstdio>

using namespace fulcrum::runtime::test;

namespace {

constexpr std::size_t kHead = 5;  // length and kind

std::string number_text(double value) {
    char text[32];
    std::snprintf(text, sizeof(text), "%.17g", value);
    return text;
}

/// Something that the parameter takes, as Lua text.
std::string any_value(const Parameter& parameter) {
    switch (parameter.type) {
        case ParameterType::number:
        case ParameterType::integer:
            return number_text(parameter.high);
        case ParameterType::vector:
            return "{0, 0, 1}";
        default:
            return std::string_view(parameter.name) == "kind" ? "'slider'" : "'n'";
    }
}

std::string value_at(const Parameter& parameter, bool high) {
    const std::string number = number_text(high ? parameter.high : parameter.low);
    return parameter.type == ParameterType::vector
               ? "{" + number + ", " + number + ", " + number + "}"
               : number;
}

bool has_range(const Parameter& parameter) {
    return parameter.type == ParameterType::number || parameter.type == ParameterType::integer ||
           parameter.type == ParameterType::vector;
}

/// The fields of a table: those that must be there, and `tried` as it is given.
std::string fields_text(std::span<const Parameter> parameters, std::string_view tried,
                        const std::string& value) {
    std::string text;
    for (const Parameter& each : parameters) {
        if (each.name == tried) {
            text += std::string(each.name) + " = " + value + ", ";
        } else if (each.fallback == kRequired) {
            text += std::string(each.name) + " = " + any_value(each) + ", ";
        }
    }
    return text;
}

std::string arguments_text(const Binding& binding, std::string_view tried, const std::string& value,
                           const std::string& beside) {
    if (binding.shape != CallShape::positional) {
        return "{ " + beside + fields_text(binding.parameters, tried, value) + "}";
    }
    std::string text;
    for (const Parameter& each : binding.parameters) {
        text += text.empty() ? "(" : ", ";
        text += each.name == tried ? value : any_value(each);
    }
    return text + ")";
}

/// What a number needs beside it to make sense, by "function.field" or by the function.
std::string beside(const std::string& label) {
    static const std::map<std::string, std::string> kBeside = {
        {"body.hinge", "solid = true, "},
        {"body.crease", "solid = true, rounded = true, "},
        {"body.density", "rigid = true, model = 'box', "},
        {"body.size", "rigid = true, model = 'box', "},
        {"body.joint", "rigid = true, model = 'box', mass = 1, "},
        {"hand.cursor_size", "cursor = 'capsule', "},
        {"hand.tool.crease", "method = 'god_object', rounded = true, "},
        {"hand.tool.detail", "method = 'implicit_penalty', contact = 'levels', "},
        {"hand.tool.budget", "method = 'implicit_penalty', contact = 'levels', "},
        {"material.saturation", "stiffness = 10, "},
        {"material.saturation.linear_range", "force = 10, "},
        {"material.sliding_friction", "friction = 5, "},
        {"material.texture.size", "image = 'a.png', "},
        {"material.texture.height", "grooves = 0.01, "},
        {"material.texture.strength", "grooves = 0.01, "}};
    const auto found = kBeside.find(label);
    return found == kBeside.end() ? "" : found->second;
}

std::string lesson_with(const Binding& binding, const std::string& arguments) {
    const std::string owner = binding.owner;
    if (owner.empty()) {
        return "return " + std::string(binding.name) + arguments;
    }
    const std::string call = owner + ':' + binding.name + arguments;
    const bool acts = binding.time == CallTime::acting;
    // A body that turns, or one that falls; rigid ones fall among their like.
    const bool is_rigid = arguments.find("rigid = true") != std::string::npos;
    const bool turns = std::string_view(binding.name) == "turn";
    const bool declares_kite = std::string_view(binding.name) == "kite";
    return "local L = lesson { id = 't', title = 'T' } local world, body, force, hand, kite\n"
           "function L:start(w) world = w "
           "world:body { name = 'egg', " +
           std::string(is_rigid ? "" : "movable = true ") + "} " +
           "body = world:body { name = 'thing', " +
           (turns      ? "solid = true, hinge = { axis = { 0, 1, 0 }, inertia = 1 }"
            : is_rigid ? ""
                       : "movable = true") +
           " } force = world:spring { at = { 0, 0, 0 }, stiffness = 1 } " +
           (declares_kite ? "" : "kite = world:kite {} ") + (acts ? "" : call) +
           " end\nfunction L:update() " + (acts ? call : "") + " end\nreturn L";
}

/// The sentence of the lesson that refuses it; empty when it plays and the wire carries it.
std::string play(const std::string& text) {
    HostedLesson lesson;
    lesson.message.lesson = {"lesson.lua", text};
    lesson.host = std::make_unique<LessonHost>(lesson.message, HostServices{});
    if (const auto error = lesson.host->load()) {
        return to_sentence(to_error(*error));
    }
    if (const std::string sentence = lesson.play(); !sentence.empty()) {
        return sentence;
    }
    Bytes bytes;
    encode(lesson.host->description(), bytes);
    const auto description = decode_description(std::span(bytes).subspan(kHead));
    CHECK(description);
    bytes.clear();
    encode(lesson.reply, bytes);
    CHECK(decode_reply(std::span(bytes).subspan(kHead), lesson.host->description()));
    return {};
}

/// Tries both ends of every number, and gathers what the lesson's own line refuses.
struct Trial {
    std::set<std::string> refused{};
    std::set<std::string> carried{};

    void try_ends(const std::string& label, const Parameter& parameter, const auto& lesson_for) {
        for (const bool high : {false, true}) {
            const std::string text = lesson_for(value_at(parameter, high));
            INFO(label << (high ? " at its most\n" : " at its least\n") << text);
            const std::string sentence = play(text);
            if (sentence.empty()) {
                carried.insert(label);
            } else {
                CHECK(sentence.starts_with("lesson.lua:"));
                refused.insert(label + (high ? " most" : " least"));
            }
        }
    }

    void try_fields(const Binding& binding, const Parameter& record) {
        const std::string called = std::string(binding.name) + '.' + record.name;
        for (const Parameter& field : std::span(record.fields, record.n_fields)) {
            if (has_range(field)) {
                const std::string label = called + '.' + field.name;
                try_ends(label, field, [&](const std::string& value) {
                    return lesson_with(
                        binding, arguments_text(binding, record.name,
                                                "{ " + beside(label) +
                                                    fields_text({record.fields, record.n_fields},
                                                                field.name, value) +
                                                    "}",
                                                beside(called)));
                });
            }
        }
    }

    void try_row(const Binding& binding) {
        for (const Parameter& parameter : binding.parameters) {
            const std::string label = std::string(binding.name) + '.' + parameter.name;
            if (parameter.type == ParameterType::record) {
                try_fields(binding, parameter);
            } else if (has_range(parameter)) {
                try_ends(label, parameter, [&](const std::string& value) {
                    return lesson_with(
                        binding, arguments_text(binding, parameter.name, value, beside(label)));
                });
            }
        }
    }
};

}  // namespace

TEST_CASE("wire: what a row of the table allows is carried, or refused in the lesson's own line") {
    Trial trial;
    for (const Binding& binding : api_table().functions) {
        trial.try_row(binding);
    }
    // A place may be anywhere, but not far from the body that turns about it; angles begin at 0.
    CHECK(trial.refused ==
          std::set<std::string>{
              "body.hinge.at least", "body.hinge.at most", "body.hinge.highest least",
              "body.hinge.load_at least", "body.hinge.load_at most", "body.hinge.lowest most",
              "turn.at least", "turn.at most",
              // Only a rod has another end; no edge is thinner than what touches it can tell.
              "body.joint.end_at least", "body.joint.end_at most", "body.size least",
              // Who says two hands declares two.
              "lesson.hands most", "material.tap.acceleration least",
              "material.tap.acceleration most", "material.tap.length least",
              "material.tap.length most",
              // Somebody answers from say, or a simulated learner does.
              "test.learner.form least", "test.learner.form most", "test.learner.unclear least",
              "test.learner.unclear most", "test.learner.wrong least", "test.learner.wrong most",
              // A bridle makes a triangle with this height and this knot, or none.
              "kite.bridle least", "kite.bridle most", "kite.knot least", "kite.knot most",
              "build.bridle least", "build.bridle most", "build.knot least", "build.knot most"});
    // Far more than these few are tried.
    CHECK(trial.carried.size() > 50);
}
