// What plan_tool.h tells of a tool and what it meets.
#include "haptics/tool/tool_plan.h"
#include "runtime/effect/tool/check_tool.h"
#include "runtime/effect/tool/plan_tool.h"
#include "runtime/text/amounts.h"

#include <array>
#include <cstdio>

namespace fulcrum::runtime {
namespace {

// "1 level, 3 pieces"
std::string levels_text(std::int32_t n_levels, std::int32_t n_pieces) {
    return std::to_string(n_levels) + (n_levels == 1 ? " level, " : " levels, ") +
           std::to_string(n_pieces) + (n_pieces == 1 ? " piece" : " pieces");
}

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
    if (const auto* levels = std::get_if<std::vector<LevelContactsPlan>>(&plan.objects)) {
        for (const LevelContactsPlan& one : *levels) {
            facts.push_back({{},
                             one.object->memory_bytes(),
                             static_cast<std::int32_t>(one.object->report().n_triangles),
                             {},
                             0.0,
                             false,
                             one.object->n_levels(),
                             one.object->n_pieces()});
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

namespace {

// The tool itself: what it is, how it is kept outside, on which springs.
std::string own_lines(const LessonDescription& lesson, const Plan& plan) {
    const ToolDescription& tool = *lesson.hand.tool;
    const ToolPlan& of = *plan.haptic.tool;
    const double turn_Nm_per_rad =
        of.settings.coupling.turn.stiffness_Nm_per_rad / lesson.hand.scale;
    const int n = static_cast<int>(count_points(of));
    std::array<char, 512> line{};
    if (const auto* levels = std::get_if<std::vector<LevelContactsPlan>>(&of.objects)) {
        const ContactLevels& own = *levels->front().tool;
        const double tolerance_m = levels->front().settings.tolerance_m;
        std::snprintf(line.data(), line.size(),
                      "%-16.48s %s, contact by levels: %s, %s, %s; %.3g N/m and %.3g "
                      "Nm/rad in the hand\n%-16s contact is what is nearer than %s, %s\n",
                      name_of(tool).c_str(), name_of(tool.method),
                      levels_text(own.n_levels(), own.n_pieces()).c_str(),
                      bytes_text(own.memory_bytes()).c_str(), name_of(plan.tool_shapes.back()),
                      tool.stiffness_N_per_m, turn_Nm_per_rad, "",
                      metres_text(own.settings().within_m).c_str(),
                      tolerance_m > 0.0 ? ("as one to " + metres_text(tolerance_m)).c_str()
                                        : "as fine as the meshes");
        return line.data();
    }
    if (tool.method == ToolMethod::god_object) {
        std::snprintf(line.data(), line.size(),
                      "%-16.48s %s, %d corners, %.3g N/m and %.3g Nm/rad in the hand\n",
                      name_of(tool).c_str(), name_of(tool.method), n, tool.stiffness_N_per_m,
                      turn_Nm_per_rad);
        return line.data();
    }
    std::snprintf(line.data(), line.size(),
                  "%-16.48s %s, %d points, %s, %.3g N/m and %.3g Nm/rad in the hand, points %s\n",
                  name_of(tool).c_str(), name_of(tool.method), n,
                  tool.massless ? "massless" : std::string(to_string(tool.integrator)).c_str(),
                  tool.stiffness_N_per_m, turn_Nm_per_rad, name_of(plan.tool_shapes.back()));
    return line.data();
}

// How its contacts push, where there is a choice.
std::string contact_line(const ToolDescription& tool) {
    return tool.method == ToolMethod::implicit_penalty
               ? std::string(17, ' ') + "contacts push as: " + name_of(tool.contact_model) + "\n"
               : "";
}

// A body as the tool meets it.
std::string body_lines(const std::string& noun, const ToolObjectFacts& facts, ShapeSource source) {
    std::array<char, 256> line{};
    if (facts.n_levels > 0) {
        std::snprintf(line.data(), line.size(), "%-16.48s %d triangles, %s, %s, %s\n", noun.c_str(),
                      facts.n_triangles, levels_text(facts.n_levels, facts.n_pieces).c_str(),
                      bytes_text(facts.bytes).c_str(), name_of(source));
        return line.data();
    }
    if (facts.n_triangles > 0) {
        std::snprintf(line.data(), line.size(), "%-16.48s %d triangles, %s, %s\n", noun.c_str(),
                      facts.n_triangles, bytes_text(facts.bytes).c_str(), name_of(source));
        return line.data() + friction_line(facts.friction) + texture_line(facts.texture_m) +
               rounded_line(facts.rounded);
    }
    const VoxelFrame::Cell& n = facts.frame.n_cells;
    std::snprintf(line.data(), line.size(), "%-16.48s %d x %d x %d voxels of %s, %s, %s\n",
                  noun.c_str(), n[0], n[1], n[2], metres_text(facts.frame.voxel_m).c_str(),
                  bytes_text(facts.bytes).c_str(), name_of(source));
    return line.data();
}

}  // namespace

std::string tool_table(const LessonDescription& lesson, const Plan& plan) {
    if (!plan.haptic.tool || !lesson.hand.tool) {
        return {};
    }
    std::string text = "\nThe tool in the hand, and what it meets:\n" + own_lines(lesson, plan) +
                       contact_line(*lesson.hand.tool);
    const std::vector<ToolObjectFacts> facts = find_object_facts(*plan.haptic.tool);
    for (std::size_t i = 0; i < facts.size(); ++i) {
        const auto body = static_cast<std::size_t>(plan.haptic.solids[i].body);
        text += body_lines(lesson.bodies[body].noun, facts[i], plan.tool_shapes[i]);
    }
    if (lesson.hand.tool->method == ToolMethod::god_object) {
        return text + "In a live run a thread of its own moves it, beside the steps.\n";
    }
    std::array<char, 160> line{};
    std::snprintf(
        line.data(), line.size(),
        "In a live run it has %.0f us of each step for them; without a window, as long as "
        "it takes.\n",
        find_budget_us(lesson.hand));
    text += line.data();
    return has_thread(*lesson.hand.tool)
               ? text + "In a live run a thread of its own finds contact, beside the steps.\n"
               : text;
}

}  // namespace fulcrum::runtime
