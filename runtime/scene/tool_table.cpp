// What plan_tool.h tells of a tool and what it meets.
#include "haptics/tool/tool_plan.h"
#include "runtime/scene/check_tool.h"
#include "runtime/scene/explain.h"
#include "runtime/scene/plan_tool.h"

#include <array>
#include <cstdio>

namespace fulcrum::runtime {
namespace {

// Under a body's line: what it asks of each step besides.
std::string friction_line(const FrictionSettings& friction) {
    if (!friction.any()) {
        return {};
    }
    std::array<char, 160> line{};
    std::snprintf(line.data(), line.size(), "%-16s friction %.2g, %.2g while it slides: %s\n", "",
                  friction.static_coefficient, friction.dynamic_coefficient,
                  "where it slides a step of the tool takes up to twice as long");
    return line.data();
}

std::string texture_line(double height_m) {
    if (!(height_m > 0.0)) {
        return {};
    }
    std::array<char, 160> line{};
    std::snprintf(line.data(), line.size(), "%-16s texture up to %s high: %s\n", "",
                  metres_text(height_m).c_str(), "a step takes 1 us and 0.2 us a contact longer");
    return line.data();
}

std::string rounded_line(bool rounded) {
    std::array<char, 160> line{};
    std::snprintf(line.data(), line.size(), "%-16s rounded: %s\n", "",
                  "a step takes 0.1 us a contact longer");
    return rounded ? line.data() : "";
}

}  // namespace

std::vector<ToolObjectFacts> find_object_facts(const ToolPlan& plan) {
    std::vector<ToolObjectFacts> facts;
    if (const auto* fields = std::get_if<std::vector<FieldSamplingPlan>>(&plan.objects)) {
        for (const FieldSamplingPlan& object : *fields) {
            facts.push_back({object.field->frame(), object.field->memory_bytes()});
        }
        return facts;
    }
    if (const auto* meshes = std::get_if<std::vector<GodObjectPlan>>(&plan.objects)) {
        for (const GodObjectPlan& object : *meshes) {
            facts.push_back({{},
                             object.object->memory_bytes(),
                             object.object->swept().n_triangles(),
                             object.friction,
                             object.texture ? object.texture->settings().height_m : 0.0,
                             object.object_shading != nullptr});
        }
        return facts;
    }
    for (const auto& object : std::get<std::vector<VoxelSamplingPlan>>(plan.objects)) {
        facts.push_back(object.grid != nullptr
                            ? ToolObjectFacts{object.grid->frame, object.grid->memory_bytes()}
                            : ToolObjectFacts{object.map->frame(), object.map->memory_bytes()});
    }
    return facts;
}

std::string tool_table(const LessonDescription& lesson, const Plan& plan) {
    if (!plan.haptic.tool || !lesson.hand.tool) {
        return {};
    }
    const ToolDescription& tool = *lesson.hand.tool;
    const VoxelToolSettings& settings = plan.haptic.tool->settings;
    std::array<char, 256> line{};
    std::snprintf(line.data(), line.size(),
                  "%-16.48s %s, %d points, %s, %.3g N/m and %.3g Nm/rad in the hand, points %s\n",
                  name_of(tool).c_str(), name_of(tool.method),
                  static_cast<int>(count_points(*plan.haptic.tool)),
                  tool.massless ? "massless" : std::string(to_string(tool.integrator)).c_str(),
                  tool.stiffness_N_per_m,
                  settings.coupling.turn.stiffness_Nm_per_rad / lesson.hand.scale,
                  name_of(plan.tool_shapes.back()));
    const bool is_god_object = tool.method == ToolMethod::god_object;
    if (is_god_object) {
        std::snprintf(line.data(), line.size(),
                      "%-16.48s %s, %d corners, %.3g N/m and %.3g Nm/rad in the hand\n",
                      name_of(tool).c_str(), name_of(tool.method),
                      static_cast<int>(count_points(*plan.haptic.tool)), tool.stiffness_N_per_m,
                      settings.coupling.turn.stiffness_Nm_per_rad / lesson.hand.scale);
    }
    std::string text = line.data();
    const std::vector<ToolObjectFacts> facts = find_object_facts(*plan.haptic.tool);
    for (std::size_t i = 0; i < facts.size(); ++i) {
        const BodyDescription& body =
            lesson.bodies[static_cast<std::size_t>(plan.haptic.solids[i].body)];
        const VoxelFrame::Cell& n = facts[i].frame.n_cells;
        if (facts[i].n_triangles > 0) {
            std::snprintf(line.data(), line.size(), "%-16.48s %d triangles, %s, %s\n",
                          body.noun.c_str(), static_cast<int>(facts[i].n_triangles),
                          bytes_text(facts[i].bytes).c_str(), name_of(plan.tool_shapes[i]));
            text += line.data();
            text += friction_line(facts[i].friction) + texture_line(facts[i].texture_m) +
                    rounded_line(facts[i].rounded);
            continue;
        }
        std::snprintf(line.data(), line.size(), "%-16.48s %d x %d x %d voxels of %s, %s, %s\n",
                      body.noun.c_str(), n[0], n[1], n[2],
                      metres_text(facts[i].frame.voxel_m).c_str(),
                      bytes_text(facts[i].bytes).c_str(), name_of(plan.tool_shapes[i]));
        text += line.data();
    }
    if (is_god_object) {
        return "\nThe tool in the hand, and what it meets:\n" + text;
    }
    std::snprintf(
        line.data(), line.size(),
        "In a live run it has %.0f us of each step for them; without a window, as long as "
        "it takes.\n",
        find_tool_time_us(plan.haptic.rate_hz));
    text += line.data();
    return "\nThe tool in the hand, and what it meets:\n" + text;
}

}  // namespace fulcrum::runtime
