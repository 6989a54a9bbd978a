#include "runtime/scene/knobs.h"

#include "haptics/tool/tool_plan.h"
#include "runtime/effect/tool/check_tool.h"
#include "runtime/scene/explain.h"
#include "runtime/scene/plan_hands.h"
#include "runtime/text/amounts.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <iterator>
#include <memory>
#include <optional>
#include <string_view>
#include <utility>
#include <variant>

namespace fulcrum::runtime {
namespace {

constexpr double kExact_m_per_s = 1.0e-12;  // of a world's solver
constexpr int kExactContacts = 1'000'000;
constexpr double kLeastGap_m = 1.0e-7;
constexpr int kGodRounds = 1000;
constexpr int kNewtonIterations = 100;
constexpr int kMorePoints = 4;

std::string times(double value, const char* unit) {
    std::array<char, 48> text{};
    std::snprintf(text.data(), text.size(), "%.6g %s", value, unit);
    return text.data();
}

// Gathers the knobs of one plan.
class List {
  public:
    List(const LessonDescription& lesson, const Plan& plan) : lesson_(lesson), plan_(plan) {}

    // Nothing where the plan has no such stage.
    void add(const std::string& loop, std::string_view name, Knob knob) {
        const auto found = std::ranges::find_if(plan_.stages, [&](const PlanStage& stage) {
            return stage.loop == loop && (name.empty() || stage.name == name);
        });
        if (found != plan_.stages.end()) {
            knob.stage = static_cast<std::size_t>(found - plan_.stages.begin());
            knobs_.push_back(std::move(knob));
        }
    }
    void add(std::size_t hand, HapticStage stage, Knob knob) {
        knob.hand = hand;
        add(name_of_loop(hand), name_of(stage), std::move(knob));
    }
    void add_hand(std::size_t hand, const DeviceTraits& device);
    void add_worlds();
    [[nodiscard]] std::vector<Knob> finish() {
        std::ranges::stable_sort(knobs_, {}, &Knob::stage);
        return std::move(knobs_);
    }

  private:
    void add_rate(std::size_t hand);
    void add_velocity(std::size_t hand, const DeviceTraits& device);
    void add_touch(std::size_t hand);
    void add_relief(std::size_t hand);
    void add_tool(std::size_t hand);
    void add_points(std::size_t hand);

    const LessonDescription& lesson_;
    const Plan& plan_;
    std::vector<Knob> knobs_;
};

void List::add_rate(std::size_t hand) {
    const double rate_hz = plan_.of_hand(hand).rate_hz;
    Knob knob{.what = "rounds of " + times(rate_hz, "Hz")};
    knob.n_parts = kFinestRounds;
    knob.against = times(kFinestRounds * rate_hz, "Hz") + ", evenly from pose to pose";
    knob.converge = [hand](Plan& plan) {
        HapticPlan& finer = plan.of_hand(hand);
        finer.rate_hz *= kFinestRounds;
        finer.safety.engage_cycles *= kFinestRounds;
    };
    add(hand, HapticStage::read, std::move(knob));
}

void List::add_velocity(std::size_t hand, const DeviceTraits& device) {
    const HapticPlan& plan = plan_.of_hand(hand);
    Knob knob{.what = "velocity by " + std::string(name_of(plan.velocity_method)) +
                      ", turning below " + times(plan.velocity_cutoff_hz, "Hz")};
    if (device.position_resolution_m > 0.0) {
        knob.because = "the device counts steps, and nobody knows how fast the hand was";
    } else {
        knob.against = "the way from pose to pose";
        knob.converge = [hand](Plan& changed) {
            constexpr double kAllPass_Hz = 1.0e6;
            changed.of_hand(hand).velocity_method = VelocityMethod::finite_difference;
            changed.of_hand(hand).velocity_cutoff_hz = kAllPass_Hz;
        };
    }
    add(hand, HapticStage::estimate, std::move(knob));
}

void List::add_touch(std::size_t hand) {
    const HapticPlan& plan = plan_.of_hand(hand);
    if (plan.proxy.kind == ProxyKind::friction_cone) {
        Knob knob{
            .what = "rounds of the friction cone: " + std::to_string(plan.proxy.friction_rounds),
            .against = std::to_string(kConvergedRounds)};
        knob.converge = [hand](Plan& changed) {
            changed.of_hand(hand).proxy.friction_rounds = kConvergedRounds;
        };
        add(hand, HapticStage::proxy, std::move(knob));
    }
    const auto is_mesh = [](const SolidPlan& solid) { return find_mesh(solid.shape) != nullptr; };
    if (const auto n = std::ranges::count_if(plan.solids, is_mesh); n > 0) {
        add(hand, HapticStage::proxy,
            {.what = "facets of " + std::to_string(n) + (n == 1 ? " body" : " bodies"),
             .because = "they are all that is known of the model"});
    }
    if (std::ranges::any_of(plan.solids, [&](const SolidPlan& solid) {
            return is_mesh(solid) && solid.surface.shading.on;
        })) {
        add(hand, HapticStage::coupling,
            {.what = "even normals over facets",
             .because = "what surface the facets stand for nobody has told"});
    }
}

void List::add_relief(std::size_t hand) {
    const auto& solids = plan_.of_hand(hand).solids;
    const auto rough = std::ranges::find_if(
        solids, [](const SolidPlan& solid) { return solid.surface.texture.any(); });
    if (rough == solids.end()) {
        return;
    }
    const bool is_picture = std::ranges::any_of(solids, [](const SolidPlan& solid) {
        return std::holds_alternative<ImageTexture>(solid.surface.texture.source);
    });
    add(hand, HapticStage::texture,
        {.what = is_picture ? "points of a picture" : "points of a relief",
         .because = is_picture ? "between them nothing is known of it"
                               : "they are as many as it is made with, and its curve goes through "
                                 "them; `fulcrum bench texture-pictures` has fewer"});
    add(hand, HapticStage::texture,
        {.what = "the relief's law", .because = "each law is another feeling, none the limit"});
}

void List::add_points(std::size_t hand) {
    if (!lesson_.hand.tool) {
        return;
    }
    const int n = find_surface_points(*lesson_.hand.tool);
    const int more = kMorePoints * n;
    Knob knob{.what = "points of the tool: " + std::to_string(n), .against = std::to_string(more)};
    knob.change = [more](LessonDescription& lesson) { lesson.hand.tool->points = more; };
    add(hand, HapticStage::tool, std::move(knob));
}

void List::add_tool(std::size_t hand) {
    const auto& tool = plan_.of_hand(hand).tool;
    if (!tool) {
        return;
    }
    // Of a plan of its own: the other has the same.
    const auto with = [hand](auto change) {
        return [hand, change](Plan& plan) {
            auto changed = std::make_shared<ToolPlan>(*plan.of_hand(hand).tool);
            change(*changed);
            plan.of_hand(hand).tool = std::move(changed);
        };
    };
    const auto put = [&](std::string what, std::string against, std::function<void(Plan&)> how) {
        Knob knob{.what = std::move(what), .against = std::move(against)};
        knob.converge = std::move(how);
        add(hand, HapticStage::tool, std::move(knob));
    };
    if (std::holds_alternative<std::vector<GodObjectPlan>>(tool->objects)) {
        put("rounds a step: " + std::to_string(tool->god_rounds), std::to_string(kGodRounds),
            with([](ToolPlan& plan) { plan.god_rounds = kGodRounds; }));
        put("gap of " + metres_text(tool->god_gap_m), metres_text(kLeastGap_m),
            with([](ToolPlan& plan) { plan.god_gap_m = kLeastGap_m; }));
        return;
    }
    if (tool->penalty) {
        put("clusters of contact: " + std::to_string(tool->penalty->clusters.most),
            std::to_string(kMostClusters),
            with([](ToolPlan& plan) { plan.penalty->clusters.most = kMostClusters; }));
    } else if (tool->settings.mass == ToolMass::massless) {
        put("iterations at rest: " + std::to_string(tool->settings.static_iterations),
            std::to_string(kNewtonIterations),
            with([](ToolPlan& plan) { plan.settings.static_iterations = kNewtonIterations; }));
    } else {
        put("iterations of Newton: " + std::to_string(tool->settings.integrator.newton_iterations),
            std::to_string(kNewtonIterations), with([](ToolPlan& plan) {
                plan.settings.integrator.newton_iterations = kNewtonIterations;
            }));
    }
    if (const auto* levels = std::get_if<std::vector<LevelContactsPlan>>(&tool->objects)) {
        put("contact levels within " + metres_text(levels->front().settings.tolerance_m),
            "as fine as the meshes", with([](ToolPlan& plan) {
                for (auto& each : std::get<std::vector<LevelContactsPlan>>(plan.objects)) {
                    each.settings.tolerance_m = 0.0;
                }
            }));
        return;
    }
    const bool in_rows = std::holds_alternative<std::vector<VoxelSamplingPlan>>(tool->objects);
    if (!in_rows) {
        add_points(hand);
    }
    add(hand, HapticStage::tool,
        {.what = in_rows ? "voxels, and the points in their rows" : "voxels of what it meets",
         .because = "how deep a point may be goes with them: finer ones are another law"});
}

void List::add_hand(std::size_t hand, const DeviceTraits& device) {
    add_rate(hand);
    add_velocity(hand, device);
    add_touch(hand);
    add_relief(hand);
    add_tool(hand);
    if (plan_.of_hand(hand).lesson_force) {
        Knob knob{.what = "answers of " + times(plan_.of_hand(hand).lesson_rate_hz, "Hz"),
                  .against = "each round between the answers before and behind it",
                  .reach = KnobReach::answers};
        knob.converge = [hand](Plan& plan) {
            plan.of_hand(hand).lesson_rate_hz = plan.of_hand(hand).rate_hz;
        };
        add(hand, HapticStage::lesson, std::move(knob));
    }
    Knob brake{.what = "the brake", .against = "none"};
    brake.converge = [hand](Plan& plan) { plan.of_hand(hand).passivity.on = false; };
    add(hand, HapticStage::passivity, std::move(brake));
}

void List::add_worlds() {
    const auto put = [&](const char* loop, std::string what, std::string against,
                         std::function<void(Plan&)> how) {
        Knob knob{.what = std::move(what), .against = std::move(against), .reach = KnobReach::all};
        knob.converge = std::move(how);
        add(loop, {}, std::move(knob));
    };
    if (plan_.world_rate_hz() > 0.0) {
        const double rate_hz = plan_.world_rate_hz();
        put("world", "steps of " + times(rate_hz, "Hz"), times(kFinestRounds * rate_hz, "Hz"),
            [](Plan& plan) {
                (plan.world ? plan.world->rate_hz : plan.rigid->rate_hz) *= kFinestRounds;
            });
    }
    if (plan_.rigid) {
        put("world",
            "solver within " + times(plan_.rigid->world.settings.solver.tolerance_m_per_s, "m/s") +
                ", resting islands stepped seldom",
            times(kExact_m_per_s, "m/s") + ", all in each step", [](Plan& plan) {
                RigidWorldSettings& settings = plan.rigid->world.settings;
                settings.slow_period_s = 0.0;
                settings.sleep_after_s = 0.0;
                settings.solver.tolerance_m_per_s = kExact_m_per_s;
                settings.solver.max_iterations = 1000;
                settings.solver.friction_rounds = 100;
                settings.solver.most_exact_contacts = kExactContacts;
            });
    }
    if (plan_.kite) {
        const int segments = plan_.kite->flight.line.segments;
        const int more = std::min(2 * segments, kMostLineSegments);
        put("kite", "segments of the line: " + std::to_string(segments),
            std::to_string(more) + ", flying on by itself",
            [more](Plan& plan) { plan.kite->flight.line.segments = more; });
        const double rate_hz = plan_.kite->rate_hz;
        put("kite", "steps of " + times(rate_hz, "Hz"),
            times(kFinestRounds * rate_hz, "Hz") + " in the same gusts, flying on by itself",
            [](Plan& plan) {
                plan.kite->n_parts *= kFinestRounds;
                plan.kite->flight.steps_a_gust *= kFinestRounds;
            });
    }
}

}  // namespace

std::vector<Knob> list_knobs(const LessonDescription& lesson, const Plan& plan,
                             const std::vector<DeviceTraits>& hands) {
    List list(lesson, plan);
    for (std::size_t hand = 0; hand < hands.size(); ++hand) {
        list.add_hand(hand, hands[hand]);
    }
    list.add_worlds();
    return list.finish();
}

}  // namespace fulcrum::runtime
