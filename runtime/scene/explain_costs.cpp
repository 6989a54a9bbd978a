// The half of explain.h that speaks of a run.
#include "haptics/collision/collision_mesh.h"
#include "runtime/effect/tool/check_tool.h"
#include "runtime/effect/tool/plan_tool.h"
#include "runtime/effect/tool/tool_bodies.h"
#include "runtime/scene/body_shape.h"
#include "runtime/scene/explain.h"
#include "runtime/text/amounts.h"
#include "runtime/text/json.h"

#include <array>
#include <cstdio>
#include <utility>
#include <vector>

namespace fulcrum::runtime {
namespace {

std::string percent_text(double share) {
    std::array<char, 16> text{};
    std::snprintf(text.data(), text.size(), "%.1f %%", 100.0 * share);
    return text.data();
}

std::string cost_row(const PlanStage& stage, const StageFigures& figures, double total_us) {
    const std::string memory = stage.memory_bytes > 0 ? bytes_text(stage.memory_bytes) : "-";
    const double share = total_us > 0.0 ? figures.total_us / total_us : 0.0;
    std::array<char, 160> text{};
    std::snprintf(text.data(), text.size(), "%-8s %-17s %9llu %10.3f %10.3f %8s %9s\n",
                  stage.loop.c_str(), stage.name.c_str(),
                  static_cast<unsigned long long>(figures.calls), figures.median_us, figures.p99_us,
                  percent_text(share).c_str(), memory.c_str());
    return text.data();
}

std::string error_row(const PlanStage& stage, const StageError& error) {
    std::array<char, 48> value{};
    std::snprintf(value.data(), value.size(), "%.3g %s", error.value, error.unit.c_str());
    std::array<char, 256> text{};
    std::snprintf(text.data(), text.size(), "%-8s %-17s %s %s%s%s\n", stage.loop.c_str(),
                  stage.name.c_str(), error.what.c_str(), value.data(),
                  error.against.empty() ? "" : ", against ", error.against.c_str());
    return text.data();
}

// "0.001, 0.004, 0.02 N"
std::string three_text(const std::array<double, 3>& values, const char* unit) {
    std::array<char, 64> text{};
    std::snprintf(text.data(), text.size(), "%.2g, %.2g, %.2g %s", values[0], values[1], values[2],
                  unit);
    return text.data();
}

std::string knob_row(const PlanStage& stage, const KnobError& error) {
    std::array<char, 48> head{};
    std::snprintf(head.data(), head.size(), "%-8s %-17s ", stage.loop.c_str(), stage.name.c_str());
    std::string row = head.data() + error.what + ": ";
    if (!error.because.empty()) {
        return row + "no reference: " + error.because + "\n";
    }
    row += three_text(error.force_N, "N");
    if (error.turns) {
        row += "; " + three_text(error.torque_Nm, "N m");
    }
    return row + "; against " + error.against + "\n";
}

std::string knobs_text(const Plan& plan, const std::vector<KnobError>& knobs) {
    if (knobs.empty()) {
        return {};
    }
    std::array<char, 200> head{};
    std::snprintf(head.data(), head.size(),
                  "\nWhat each knob leaves at the device: the first %.1f s once more with the "
                  "same poses and\nthat knob converged, differences rms, 99 %% and at most:\n\n",
                  knobs.front().seconds);
    std::string text = head.data();
    for (const KnobError& error : knobs) {
        text += knob_row(plan.stages[error.stage], error);
    }
    return text;
}

Json json_of(const PlanStage& stage) {
    return Json::object({{"loop", stage.loop},
                         {"stage", stage.name},
                         {"rate_hz", stage.rate_hz},
                         {"memory_bytes", stage.memory_bytes},
                         {"asked_by_line", stage.line},
                         {"because", stage.because}});
}

void add_costs(Json& stages, const Analysis& analysis) {
    const double total_us = analysis.total_us();
    for (const StageFigures& figures : analysis.stages) {
        Json errors = Json::array();
        for (const StageError& error : figures.errors) {
            errors.push_back(Json::object({{"what", error.what},
                                           {"value", error.value},
                                           {"unit", error.unit},
                                           {"against", error.against}}));
        }
        Json& stage = stages.at(figures.stage);
        stage.add("calls", figures.calls);
        stage.add("median_us", figures.median_us);
        stage.add("p99_us", figures.p99_us);
        stage.add("share", total_us > 0.0 ? figures.total_us / total_us : 0.0);
        stage.add("errors", std::move(errors));
    }
}

Json json_of(const KnobError& error) {
    const auto three = [&](const std::array<double, 3>& values) {
        return error.because.empty() ? Json::array({values[0], values[1], values[2]}) : Json();
    };
    Json json = Json::object({{"what", error.what},
                              {"against", error.against},
                              {"because", error.because},
                              {"seconds", error.seconds},
                              {"force_N", three(error.force_N)}});
    if (error.turns) {
        json.add("torque_Nm", three(error.torque_Nm));
    }
    return json;
}

void add_knobs(Json& stages, const std::vector<KnobError>& knobs) {
    for (std::size_t i = 0; i < knobs.size();) {
        const std::size_t stage = knobs[i].stage;
        Json list = Json::array();
        for (; i < knobs.size() && knobs[i].stage == stage; ++i) {
            list.push_back(json_of(knobs[i]));
        }
        stages.at(stage).add("knobs", std::move(list));
    }
}

Json json_of_materials(const LessonDescription& lesson, const Plan& plan) {
    Json materials = Json::array();
    const std::size_t n = std::min(lesson.materials.size(), plan.material_facts.size());
    for (std::size_t i = 0; i < n; ++i) {
        const MaterialFacts& facts = plan.material_facts[i];
        materials.push_back(Json::object({{"name", lesson.materials[i].felt.name},
                                          {"hardness", facts.hardness},
                                          {"roughness", facts.roughness},
                                          {"slipperiness", facts.slipperiness}}));
    }
    return materials;
}

Json json_of_formulas(const LessonDescription& lesson, const Plan& plan) {
    Json formulas = Json::array();
    for (const SolidPlan& solid : plan.haptic.solids) {
        if (find_mesh(solid.shape) == nullptr) {
            const BodyDescription& body = lesson.bodies[static_cast<std::size_t>(solid.body)];
            formulas.push_back(Json::object(
                {{"name", body.name}, {"shape", std::string(name_of_felt(body, solid.shape))}}));
        }
    }
    return formulas;
}

Json json_of_triangles(const LessonDescription& lesson, const Plan& plan) {
    Json triangles = Json::array();
    for (const SolidPlan& solid : plan.haptic.solids) {
        if (const MeshShape* const mesh = find_mesh(solid.shape); mesh != nullptr) {
            const BodyDescription& body = lesson.bodies[static_cast<std::size_t>(solid.body)];
            triangles.push_back(
                Json::object({{"name", body.name},
                              {"shape", std::string(name_of_felt(body, solid.shape))},
                              {"triangles", static_cast<double>((*mesh)->n_triangles())}}));
        }
    }
    return triangles;
}

const char* source_of(ShapeSource source) {
    return source == ShapeSource::made ? "made" : "cache";
}

Json json_of_tool(const LessonDescription& lesson, const Plan& plan) {
    const ToolDescription& tool = *lesson.hand.tool;
    Json bodies = Json::array();
    const std::vector<ToolObjectFacts> facts = find_object_facts(*plan.haptic.tool);
    for (std::size_t i = 0; i < facts.size(); ++i) {
        const auto body = static_cast<std::size_t>(plan.haptic.solids[i].body);
        const auto& n_cells = facts[i].frame.n_cells;
        bodies.push_back(
            Json::object({{"name", lesson.bodies[body].name},
                          {"voxels", Json::array({n_cells[0], n_cells[1], n_cells[2]})},
                          {"voxel_m", facts[i].frame.voxel_m},
                          {"triangles", facts[i].n_triangles},
                          {"levels", facts[i].n_levels},
                          {"pieces", facts[i].n_pieces},
                          {"friction", facts[i].friction.static_coefficient},
                          {"sliding_friction", facts[i].friction.dynamic_coefficient},
                          {"texture_m", facts[i].texture_m},
                          {"rounded", facts[i].rounded},
                          {"memory_bytes", facts[i].bytes},
                          {"source", source_of(plan.tool_shapes[i])}}));
    }
    Json json = Json::object({{"name", name_of(tool)},
                              {"method", name_of(tool.method)},
                              {"points", count_points(*plan.haptic.tool)},
                              {"source", source_of(plan.tool_shapes.back())},
                              {"live_time_us", find_budget_us(lesson.hand)},
                              {"bodies", std::move(bodies)}});
    if (has_levels(tool)) {
        const auto& levels =
            std::get<std::vector<LevelContactsPlan>>(plan.haptic.tool->objects).front();
        json.add("contact", Json::object({{"found_by", name_of(tool.contact)},
                                          {"tolerance_m", levels.settings.tolerance_m},
                                          {"within_m", levels.tool->settings().within_m},
                                          {"levels", levels.tool->n_levels()},
                                          {"pieces", levels.tool->n_pieces()},
                                          {"memory_bytes", levels.tool->memory_bytes()}}));
    }
    return json;
}

}  // namespace

std::string explain_costs(const Plan& plan, const Analysis& analysis) {
    std::array<char, 200> text{};
    std::snprintf(text.data(), text.size(),
                  "\nPlayed %.1f s in %.2f s. What it cost, a call (%.0f ns for the clock are "
                  "taken off each):\n\n",
                  analysis.simulated_s, analysis.wall_s, 1e3 * analysis.clock_us);
    std::string result = text.data();
    std::snprintf(text.data(), text.size(), "%-8s %-17s %9s %10s %10s %8s %9s\n", "loop", "stage",
                  "calls", "median us", "99 % us", "share", "memory");
    result += text.data();
    const double total_us = analysis.total_us();
    std::string errors;
    for (const StageFigures& figures : analysis.stages) {
        const PlanStage& stage = plan.stages[figures.stage];
        result += cost_row(stage, figures, total_us);
        for (const StageError& error : figures.errors) {
            errors += error_row(stage, error);
        }
    }
    if (!errors.empty()) {
        result +=
            "\nWhat stages counted, and how far from the truth where it is known:\n\n" + errors;
    }
    return result + knobs_text(plan, analysis.knobs);
}

std::string explain_json(const LessonDescription& lesson, const Plan& plan,
                         const Analysis* analysis) {
    Json whole = Json::object({{"version", 1}, {"lesson", lesson.id}, {"title", lesson.title}});
    Json stages = Json::array();
    for (const PlanStage& stage : plan.stages) {
        stages.push_back(json_of(stage));
    }
    if (analysis != nullptr) {
        whole.add("simulated_s", analysis->simulated_s);
        whole.add("wall_s", analysis->wall_s);
        whole.add("clock_us", analysis->clock_us);
        add_costs(stages, *analysis);
        add_knobs(stages, analysis->knobs);
    }
    whole.add("stages", std::move(stages));
    whole.add("felt_by_formula", json_of_formulas(lesson, plan));
    whole.add("felt_as_triangles", json_of_triangles(lesson, plan));
    whole.add("materials", json_of_materials(lesson, plan));
    if (plan.haptic.tool && lesson.hand.tool) {
        whole.add("tool", json_of_tool(lesson, plan));
    }
    Json notices = Json::array();
    for (const std::string& notice : plan.notices) {
        notices.push_back(notice);
    }
    whole.add("notices", std::move(notices));
    // A title may hold what is no UTF-8: it is replaced, never thrown at.
    return whole.to_text();
}

}  // namespace fulcrum::runtime
