#include "runtime/scene/explain.h"

#include "haptics/collision/collision_mesh.h"
#include "runtime/effect/tool/plan_tool.h"
#include "runtime/scene/body_shape.h"
#include "runtime/text/amounts.h"

#include <algorithm>
#include <array>
#include <cstdio>

namespace fulcrum::runtime {
namespace {

std::string rate_text(double rate_hz) {
    if (rate_hz <= 0.0) {
        return "when needed";
    }
    std::array<char, 32> text{};
    std::snprintf(text.data(), text.size(), "%.0f Hz", rate_hz);
    return text.data();
}

std::string line_text(SourceLine line) {
    return line > 0 ? "lesson.lua:" + std::to_string(line) : "every lesson";
}

std::string row(const std::string& loop, const std::string& stage, const std::string& rate,
                const std::string& memory, const std::string& asked_by,
                const std::string& because) {
    std::array<char, 256> text{};
    std::snprintf(text.data(), text.size(), "%-8s %-17s %-11s %9s  %-15s %s\n", loop.c_str(),
                  stage.c_str(), rate.c_str(), memory.c_str(), asked_by.c_str(), because.c_str());
    return text.data();
}

/// The answer key of a lesson on how things feel: a teacher sees what a material of their own will be called.
std::string materials_table(const LessonDescription& lesson, const Plan& plan) {
    std::string text;
    const std::size_t n = std::min(lesson.materials.size(), plan.material_facts.size());
    for (std::size_t i = 0; i < n; ++i) {
        const MaterialDescription& material = lesson.materials[i];
        const MaterialFacts& facts = plan.material_facts[i];
        const FeltWords words = felt_words(facts.hardness, facts.roughness, facts.slipperiness);
        std::array<char, 256> line{};
        std::snprintf(line.data(), line.size(), "%-16.48s %.2f %-6s %.2f %-8s %.2f %-10s %s\n",
                      material.felt.name.c_str(), facts.hardness, words.hardness, facts.roughness,
                      words.roughness, facts.slipperiness, words.slipperiness,
                      line_text(material.line).c_str());
        text += line.data();
    }
    if (text.empty()) {
        return text;
    }
    std::array<char, 128> head{};
    std::snprintf(head.data(), head.size(), "%-16s %-11s %-13s %-15s %s\n", "material", "hardness",
                  "roughness", "slipperiness", "asked by");
    return "\nWhat a hand finds out, from 0 to 1, and what it is called:\n" + (head.data() + text);
}

/// What is felt of each body: by its formula, or as triangles.
std::string felt_text(const LessonDescription& lesson, const Plan& plan) {
    std::string formulas;
    std::string triangles;
    for (const SolidPlan& solid : plan.haptic.solids) {
        const BodyDescription& body = lesson.bodies[static_cast<std::size_t>(solid.body)];
        const MeshShape* const mesh = find_mesh(solid.shape);
        std::string& text = mesh == nullptr ? formulas : triangles;
        text += (text.empty() ? "" : "; ") + body.name + ", a " +
                std::string(name_of_felt(body, solid.shape));
        text += mesh == nullptr ? "" : " of " + std::to_string((*mesh)->n_triangles());
    }
    const auto line = [](const char* head, const std::string& text) {
        return text.empty() ? text : head + text + ".\n";
    };
    return line("\nFelt by their formula, without facets: ", formulas) +
           line("\nFelt as their triangles: ", triangles);
}

std::string notices_text(const Plan& plan) {
    std::string text;
    for (const std::string& notice : plan.notices) {
        text += "\n" + notice + "\n";
    }
    return text;
}

}  // namespace

std::string explain(const LessonDescription& lesson, const Plan& plan) {
    std::string text = lesson.title + " (" + lesson.id + ")\n\n";
    text += row("loop", "stage", "rate", "memory", "asked by", "because");
    for (const PlanStage& stage : plan.stages) {
        const std::string memory = stage.memory_bytes > 0 ? bytes_text(stage.memory_bytes) : "-";
        text += row(stage.loop, stage.name, rate_text(stage.rate_hz), memory, line_text(stage.line),
                    stage.because);
    }
    text += "\nWhat is not in this list is not built.\n";
    return text + felt_text(lesson, plan) + tool_table(lesson, plan) +
           materials_table(lesson, plan) + notices_text(plan);
}

}  // namespace fulcrum::runtime
