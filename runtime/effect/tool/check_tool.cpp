#include "runtime/effect/tool/check_tool.h"

#include "runtime/scene/round_up.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <optional>
#include <string>

namespace fulcrum::runtime {
namespace {

// What a lesson may ask for, as the program's reference has it; in the hand's kilograms and N/m.
constexpr double kMostMass_kg = 1.0;
constexpr double kSoftest_N_per_m = 50.0;
constexpr double kStiffest_N_per_m = 2000.0;
constexpr double kSpringStep = 1.25;  // from one that is tried to the next
constexpr double kVoxelPoint_ns =
    25.0;  // of a point lying flat among voxels, all looks of a step: measured
constexpr double kFieldPoint_ns = 150.0;  // likewise against a field
constexpr double kShareOfStep = 0.5;      // that a tool may take
constexpr int kSurfacePoints = 2000;
constexpr int kSprings = 16;  // on either side: 1.25^16 = 35, from the softest to near the stiffest

template <class... Values>
std::string print(const char* format, Values... values) {
    std::array<char, 256> text{};
    std::snprintf(text.data(), text.size(), format, values...);
    return text.data();
}

double find_voxel_points_in_time(double rate_hz) {
    return kShareOfStep * 1.0e9 / (rate_hz * kVoxelPoint_ns);
}

// The tool on another spring; its turn goes with it, as it does by default.
VoxelToolSettings make_stiffer(VoxelToolSettings settings, double ratio) {
    settings.coupling.shift.stiffness_N_per_m *= ratio;
    settings.coupling.turn.stiffness_Nm_per_rad *= ratio;
    return settings;
}

// A spring in the hand with which the heaviest tool holds, the nearest to its own that is tried.
std::optional<double> find_spring(const HandDescription& hand, const StepLimit& limit,
                                  const VoxelToolSettings& settings, double dt_s) {
    if (hand.tool->turn_stiffness_Nm_per_rad > 0.0) {
        return std::nullopt;  // that was chosen by itself
    }
    const VoxelToolSettings heaviest = make_heavier(settings, kMostMass_kg / hand.scale);
    const double own = hand.tool->stiffness_N_per_m;
    double ratio = 1.0;
    for (int i = 0; i < kSprings; ++i) {
        ratio *= kSpringStep;
        for (const double spring : {round_up(own / ratio), round_up(own * ratio)}) {
            if (spring >= kSoftest_N_per_m && spring <= kStiffest_N_per_m &&
                limit.holds(make_stiffer(heaviest, spring / own), dt_s)) {
                return spring;
            }
        }
    }
    return std::nullopt;
}

// A mass, or a mass and a spring, or nothing.
std::string find_what_would_do(const HandDescription& hand, const StepLimit& limit,
                               const VoxelToolSettings& settings, double dt_s) {
    if (const auto least_kg = limit.find_least_mass_kg(settings, dt_s, kMostMass_kg / hand.scale)) {
        const double mass_kg = std::min(round_up(*least_kg * hand.scale), kMostMass_kg);
        return print("give it a mass of at least %g, or ", mass_kg);
    }
    if (const auto spring = find_spring(hand, limit, settings, dt_s)) {
        return print("give it a mass of %g and a stiffness of %g, or ", kMostMass_kg, *spring);
    }
    return {};
}

}  // namespace

int find_surface_points(const ToolDescription& tool) {
    return tool.points > 0 ? tool.points : kSurfacePoints;
}

int find_most_voxel_points(const HandDescription& hand) {
    return hand.tool->points > 0 ? hand.tool->points
                                 : static_cast<int>(find_voxel_points_in_time(hand.rate_hz));
}

// Voxel sampling looks at every point in every step.
Expected<void> check_tool_time(const HandDescription& hand) {
    const ToolDescription& tool = *hand.tool;
    if (tool.budget_us > find_tool_time_us(hand.rate_hz)) {
        return fail(print("the tool: its contacts may take %.0f us of each step, and at %g steps a "
                          "second there are %.0f us for it",
                          tool.budget_us, hand.rate_hz, find_tool_time_us(hand.rate_hz)),
                    at_line(hand.line),
                    print("give it a budget of at most %.0f, or leave that out",
                          std::floor(find_tool_time_us(hand.rate_hz))));
    }
    const double most_points = find_voxel_points_in_time(hand.rate_hz);
    if (tool.method != ToolMethod::voxel_sampling || tool.points <= most_points) {
        return {};
    }
    return fail(
        print("the tool: %d points among voxels take %.2g ms of each step of %.2g ms", tool.points,
              1.0e-6 * kVoxelPoint_ns * tool.points, 1.0e3 / hand.rate_hz),
        at_line(hand.line),
        print("give it at most %.0f points, or method = \"field_sampling\", which looks only "
              "at those that are near",
              std::floor(most_points)));
}

Expected<void> check_tool(const HandDescription& hand, const ToolPlan& plan,
                          const Pointshell& shell) {
    const VoxelToolSettings& settings = plan.settings;
    if (hand.tool->method == ToolMethod::god_object || settings.mass == ToolMass::massless ||
        settings.integrator.integrator == Integrator::backward_euler) {
        return {};
    }
    const StepLimit limit(plan, shell);
    const double dt_s = 1.0 / hand.rate_hz;
    if (limit.holds(settings, dt_s)) {
        return {};
    }
    const std::string name(to_string(settings.integrator.integrator));
    return fail(
        print("the tool: with %g kg on %g N/m, %d points and %g steps a second %s shakes it",
              hand.tool->mass_kg, hand.tool->stiffness_N_per_m,
              static_cast<int>(count_points(plan)), hand.rate_hz, name.c_str()),
        at_line(hand.line),
        find_what_would_do(hand, limit, settings, dt_s) +
            "leave out integrator: backward_euler holds it");
}

double find_tool_time_us(double rate_hz) {
    return kShareOfStep * 1.0e6 / rate_hz;
}

double find_budget_us(const HandDescription& hand) {
    const double time_us = find_tool_time_us(hand.rate_hz);
    return hand.tool->budget_us > 0.0 ? std::min(hand.tool->budget_us, time_us) : time_us;
}

std::optional<std::string> find_tool_notice(const HandDescription& hand, const ToolPlan& plan) {
    const auto n = static_cast<double>(count_points(plan));
    const double most_points = find_tool_time_us(hand.rate_hz) * 1.0e3 / kFieldPoint_ns;
    if (hand.tool->method != ToolMethod::field_sampling || n <= most_points) {
        return std::nullopt;
    }
    return to_sentence(
        {print("the tool: where all of its %.0f points touch, looking at each takes about %.2g ms, "
               "and a step has %.2g ms for them",
               n, 1.0e-6 * kFieldPoint_ns * n, 1.0e-3 * find_tool_time_us(hand.rate_hz)),
         at_line(hand.line),
         print("give it at most %.0f points, or bear that a live run looks at fewer then and says "
               "when it ends how far off the force may have been",
               std::floor(most_points))});
}

}  // namespace fulcrum::runtime
