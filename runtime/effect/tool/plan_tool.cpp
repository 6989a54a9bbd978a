#include "runtime/effect/tool/plan_tool.h"

#include "haptics/dynamics/mesh_inertia.h"
#include "haptics/geometry/shape.h"
#include "haptics/loop/beside_thread.h"
#include "haptics/point/make_obstacle.h"
#include "haptics/tool/tool_plan.h"
#include "runtime/effect/surface/plan_walls.h"
#include "runtime/effect/tool/check_tool.h"
#include "runtime/effect/tool/tool_bodies.h"
#include "runtime/effect/tool/tool_notices.h"
#include "runtime/effect/tool/tool_springs.h"
#include "runtime/effect/tool/tool_surfaces.h"
#include "runtime/files/shape_cache.h"
#include "runtime/scene/body_shape.h"
#include "runtime/scene/shape_models.h"

#include <algorithm>
#include <array>
#include <cstdio>
#include <memory>
#include <utility>
#include <variant>
#include <vector>

namespace fulcrum::runtime {
namespace {

constexpr int kToolSides = 48;  // of a round one

Expected<TriangleMesh> load_tool_mesh(const ToolDescription& tool, SourceLine line,
                                      const SolidLoader& load_solid) {
    if (tool.model.empty() || is_shape_model(tool.model)) {
        const auto shape = to_solid_shape(tool.shape);
        if (!shape) {
            return fail("the tool has no shape", {}, "give it a shape or a model");
        }
        return make_shape_triangles(*shape, kToolSides);
    }
    BodyDescription body;
    body.name = "the tool";
    body.noun = "tool";
    body.model = tool.model;
    body.line = line;
    return load_solid(body).and_then([](const auto& mesh) { return to_triangles(*mesh); });
}

// Both in the lesson's own words: a lesson has no density.
Expected<MeshInertia> find_inertia(const ToolDescription& tool, double scale,
                                   const TriangleMesh& mesh, ShapeCache& shapes,
                                   const LoadProgress& progress) {
    auto solid = recall_measured_solid(shapes, mesh, progress);
    if (!solid) {
        return fail(solid.error().message, {}, "close its holes, or give the tool a shape");
    }
    const double mass_kg = tool.mass_kg / scale;
    auto filled = fill_with_mass(*solid, mass_kg);
    if (!filled) {
        // That may be what was kept, and not the mesh's own.
        filled = measure_solid(mesh, {}, progress).and_then([&](const MeasuredSolid& own) {
            return fill_with_mass(own, mass_kg);
        });
    }
    return filled.map_error([](const Error& /*error*/) {
        return Error{"it is so small or so large that how it turns cannot be computed",
                     {},
                     "give it another size or more mass"};
    });
}

// The tool about its centre of mass, along its principal axes; the hand holds it at its mesh's origin, as that is turned.
Expected<ToolOrder> make_order(const LessonDescription& lesson, const TriangleMesh& mesh,
                               ShapeCache& shapes, const LoadProgress& progress) {
    const ToolDescription& tool = *lesson.hand.tool;
    const double scale = lesson.hand.scale;
    const auto half = [&](double from) {
        return progress ? LoadProgress([&progress, from](double share) {
            return progress(from + 0.5 * share);
        })
                        : LoadProgress{};
    };
    auto inertia = find_inertia(tool, scale, mesh, shapes, half(0.0));
    if (!inertia) {
        return tl::unexpected(inertia.error());
    }
    auto shell = recall_surface_pointshell(shapes, mesh, find_surface_points(tool), half(0.5));
    if (!shell) {
        return tl::unexpected(shell.error());
    }
    ToolOrder order;
    VoxelToolSettings& settings = order.settings;
    settings.inertia = inertia->inertia;
    settings.grip_T = inertia->X_BP.inverse() * Vector3(Vector3::Zero());
    settings.handle_turn = inertia->X_BP.orientation;
    settings.mass = tool.massless ? ToolMass::massless : ToolMass::massive;
    settings.integrator.integrator = tool.integrator;
    order.shell = std::make_shared<const Pointshell>(make_moved(*shell, inertia->X_BP.inverse()));
    // Its springs.
    const double reach_m = compute_reach_m(*order.shell);
    const double stiffness = tool.stiffness_N_per_m / scale;
    settings.coupling.shift.stiffness_N_per_m = stiffness;
    settings.coupling.turn.stiffness_Nm_per_rad = tool.turn_stiffness_Nm_per_rad > 0.0
                                                      ? tool.turn_stiffness_Nm_per_rad * scale
                                                      : stiffness * reach_m * reach_m;
    return order;
}

// To the device that is held and to the time that a step has.
void fit_order(const LessonDescription& lesson, const PlanOptions& options, ToolOrder& order,
               Plan& plan) {
    const double kept = fit_tool_spring(lesson, options.holders, plan);
    order.settings.coupling.shift.stiffness_N_per_m *= kept;
    order.settings.coupling.turn.stiffness_Nm_per_rad *= kept;
    order.most_force_N = plan.haptic.safety.max_force_N;
    order.settings.budget_us = options.live ? find_budget_us(lesson.hand) : 0.0;
}

// The tool's share of what is told, and that of its bodies.
struct SharedProgress {
    const PlanProgress& progress;
    double per_mesh;  // of all
    std::string tool;

    [[nodiscard]] LoadProgress of_tool(int part = 0) const {
        return progress ? LoadProgress([this, part](double share) {
            return progress(per_mesh * (part + share), "the " + tool);
        })
                        : LoadProgress{};
    }
    [[nodiscard]] PlanProgress of_bodies(int n_tool_parts) const {
        return progress ? PlanProgress([this, n_tool_parts](double share, std::string_view what) {
            const double before = per_mesh * n_tool_parts;
            return progress(before + (1.0 - before) * share, what);
        })
                        : PlanProgress{};
    }
};

// One sentence about the tool, where it was not one about a line of its own.
tl::unexpected<Error> refuse_tool(const Error& error, SourceLine line) {
    return error.where.empty() ? fail("the tool: " + error.message, at_line(line), error.what_to_do)
                               : tl::unexpected(error);
}

// Among voxels: a point a voxel, as McNeely has them, where the lesson allows so many. Such points lie in rows as the voxels do, so
// that of a flat end all push at once; others push beside edges, too, where their normals point sideways. Gives the most that were too many.
std::size_t put_in_rows(const TriangleMesh& mesh, int most_points, const ToolBodies& bodies,
                        ToolOrder& order) {
    const Pose X_PB{order.settings.grip_T, order.settings.handle_turn.conjugate()};
    std::size_t n_left_out = 0;
    for (const std::shared_ptr<const VoxelGrid>& grid : bodies.grids) {
        // Bodies that share a mesh share their voxels, too.
        const auto first = std::ranges::find(bodies.grids, grid) - bodies.grids.begin();
        if (static_cast<std::size_t>(first) < order.shells.size()) {
            order.shells.push_back(order.shells[static_cast<std::size_t>(first)]);
            continue;
        }
        // Voxels too small for that are refused there; the points on the surface serve.
        const auto rows = make_voxel_pointshell(mesh, grid->frame.voxel_m);
        const bool fits = rows && rows->size() <= static_cast<std::size_t>(most_points);
        order.shells.push_back(fits ? std::make_shared<const Pointshell>(make_moved(*rows, X_PB))
                                    : order.shell);
        n_left_out = std::max(n_left_out, rows && !fits ? rows->size() : 0);
    }
    return n_left_out;
}

// One sentence for a lesson that has not chosen so few itself.
std::string tell_left_out(const HandDescription& hand, std::size_t n_voxels) {
    std::array<char, 192> text{};
    std::snprintf(text.data(), text.size(),
                  "the tool: it has %zu voxels of its own, and a step has time for %d points, so "
                  "it has %d and pushes sideways beside edges",
                  n_voxels, find_most_voxel_points(hand), find_surface_points(*hand.tool));
    return to_sentence({text.data(), at_line(hand.line),
                        "give it a larger voxel, or method = \"field_sampling\""});
}

// About its centre of mass, along its principal axes.
Expected<TriangleMesh> make_centred(const TriangleMesh& mesh, const ToolOrder& order) {
    const Pose X_PB{order.settings.grip_T, order.settings.handle_turn.conjugate()};
    std::vector<Vector3> vertices = mesh.vertices_B();
    for (Vector3& vertex : vertices) {
        vertex = X_PB * vertex;
    }
    return TriangleMesh::build(std::move(vertices), mesh.triangles());
}

// What is told to be near by contact levels, where the lesson asks for it; those of the bodies come later.
Expected<LevelOrder> make_levels(const ToolDescription& tool, const TriangleMesh& mesh,
                                 const ToolOrder& order, double within_m, ShapeCache& shapes,
                                 const LoadProgress& progress) {
    if (!has_levels(tool)) {
        return LevelOrder{};
    }
    return make_centred(mesh, order).and_then([&](const TriangleMesh& own) {
        return recall_contact_levels(shapes, own, {.within_m = within_m}, progress)
            .map([&](const std::shared_ptr<const ContactLevels>& levels) {
                LevelOrder made{levels, std::make_shared<const TriangleClusters>(own), {}, {}};
                made.tolerance = tool.detail;
                return made;
            });
    });
}

// Triangles among triangles, and what their surfaces are like.
Expected<ToolPlan> put_among_meshes(const LessonDescription& lesson, const TriangleMesh& mesh,
                                    const ToolOrder& order, const ToolBodyList& list,
                                    const ToolBodies& bodies,
                                    const std::vector<SolidPlan>& solids) {
    return make_centred(mesh, order).and_then([&](const TriangleMesh& own) {
        ToolPlan plan = make_god_object_plan(order, GodSurface::create(own), bodies.surfaces);
        return put_surfaces(lesson, list, solids, own,
                            std::get<std::vector<GodObjectPlan>>(plan.objects))
            .map([&] { return std::move(plan); });
    });
}

// The tool among voxels, fields or levels.
Expected<ToolPlan> put_among(const ToolDescription& tool, const ToolOrder& order,
                             const LevelOrder& levels, const ToolBodies& bodies) {
    auto made = tool.method == ToolMethod::voxel_sampling
                    ? Expected<ToolPlan>(make_voxel_tool_plan(order, bodies.grids))
                : has_levels(tool) ? Expected<ToolPlan>(make_level_tool_plan(order, levels))
                : tool.method == ToolMethod::implicit_penalty
                    ? make_penalty_tool_plan(order, bodies.fields)
                    : make_field_tool_plan(order, bodies.fields);
    if (!made) {
        return made;
    }
    if (made->penalty) {
        made->penalty->contacts.model = tool.contact_model;
    }
    return validate(*made).map([&] { return std::move(*made); }).map_error([](const Error& /*e*/) {
        return Error{"how it presses against so small a body cannot be computed",
                     {},
                     "give it larger voxels or the body a larger size"};
    });
}

Expected<void> check_scene(const LessonDescription& lesson, const Plan& plan) {
    const std::string where = at_line(lesson.hand.line);
    if (plan.haptic.solids.empty()) {
        return fail("the hand has a tool, and no body is solid", where,
                    "make a body solid = true, or leave the tool out");
    }
    if (lesson.bucket.present) {
        return fail("the hand has a tool and a bucket", where, "leave out one of them");
    }
    return check_tool_time(lesson.hand);
}

void add_notices(const LessonDescription& lesson, const std::vector<std::string>& of_bodies,
                 Plan& plan) {
    plan.notices.insert(plan.notices.end(), of_bodies.begin(), of_bodies.end());
    if (const auto sentence = find_tool_notice(lesson.hand, *plan.haptic.tool)) {
        plan.notices.push_back(*sentence);
    }
    for (std::string& inside : tell_start_inside(lesson, plan.haptic.solids, *plan.haptic.tool)) {
        plan.notices.push_back(std::move(inside));
    }
}

}  // namespace

bool has_thread(const ToolDescription& tool) {
    return tool.method == ToolMethod::implicit_penalty || tool.method == ToolMethod::god_object;
}

PlanStage make_contact_stage(const LessonDescription& lesson, const Plan& plan) {
    const bool moves = lesson.hand.tool->method == ToolMethod::god_object;
    const std::string what = moves ? " moves the tool" : " finds contact";
    return {"contact",
            moves ? "motion" : "finding",
            BesideThread::compute_looks_Hz(plan.haptic.rate_hz),
            0,
            plan.haptic.tool->beside ? "a thread" + what + " beside the haptic loop"
                                     : "each step" + what + "; in a live run a thread does",
            lesson.hand.line};
}

const char* name_of(ShapeSource source) {
    return source == ShapeSource::made ? "made now" : "from the cache";
}

std::string name_of(const ToolDescription& tool) {
    constexpr std::array<const char*, 6> kNames{"", "ball", "box", "capsule", "cylinder", "hull"};
    return tool.model.empty() ? kNames[tool.shape.index()] : tool.model;
}

const char* name_of(ContactFinding contact) {
    return kContactFindings.at(static_cast<std::size_t>(contact));
}

const char* name_of(PenaltyModel model) {
    return kPenaltyModels.at(static_cast<std::size_t>(model));
}

const char* name_of(ToolMethod method) {
    return kToolMethods.at(static_cast<std::size_t>(method));
}

Expected<void> add_tool(const LessonDescription& lesson, const SolidLoader& load_solid,
                        const PlanOptions& options, Plan& plan) {
    if (!lesson.hand.tool) {
        return {};
    }
    ShapeCache none{{}};
    ShapeCache& shapes = options.shapes != nullptr ? *options.shapes : none;
    // What can be refused at once is, before anything that takes long is made.
    if (auto good = check_scene(lesson, plan); !good) {
        return good;
    }
    const auto list = list_tool_bodies(lesson, plan.haptic.solids);
    if (!list) {
        return tl::unexpected(list.error());
    }
    // With levels of its own it is one mesh more.
    const int n_tool_parts = has_levels(*lesson.hand.tool) ? 2 : 1;
    const SharedProgress progress{
        options.progress,
        1.0 / (static_cast<double>(list->meshes.size()) + static_cast<double>(n_tool_parts)),
        name_of(*lesson.hand.tool)};
    const int n_made_before = shapes.counts().n_made;
    const auto mesh = load_tool_mesh(*lesson.hand.tool, lesson.hand.line, load_solid);
    if (!mesh) {
        return refuse_tool(mesh.error(), lesson.hand.line);
    }
    auto order = make_order(lesson, *mesh, shapes, progress.of_tool());
    if (!order) {
        return refuse_tool(order.error(), lesson.hand.line);
    }
    fit_order(lesson, options, *order, plan);
    if (auto good = check_tool_springs(lesson.hand, *order, compute_reach_m(*order->shell));
        !good) {
        return good;
    }
    const int n_made = n_tool_parts > 1 ? shapes.counts().n_made : n_made_before;
    const double within_m =
        compute_contact_distance_m(compute_reach_m(*order->shell), find_finest_voxel_m(*list));
    auto levels =
        make_levels(*lesson.hand.tool, *mesh, *order, within_m, shapes, progress.of_tool(1));
    if (!levels) {
        return refuse_tool(levels.error(), lesson.hand.line);
    }
    const ShapeSource source =
        shapes.counts().n_made > n_made ? ShapeSource::made : ShapeSource::cache;
    auto bodies =
        make_tool_bodies(lesson, *list, within_m, progress.of_bodies(n_tool_parts), shapes);
    if (!bodies) {
        return tl::unexpected(bodies.error());
    }
    levels->objects = bodies->levels;
    levels->object_solids = bodies->solids;
    const std::size_t n_left_out =
        put_in_rows(*mesh, find_most_voxel_points(lesson.hand), *bodies, *order);
    if (n_left_out > 0 && lesson.hand.tool->points == 0) {
        plan.notices.push_back(tell_left_out(lesson.hand, n_left_out));
    }
    auto made = lesson.hand.tool->method == ToolMethod::god_object
                    ? put_among_meshes(lesson, *mesh, *order, *list, *bodies, plan.haptic.solids)
                    : put_among(*lesson.hand.tool, *order, *levels, *bodies);
    if (!made) {
        return refuse_tool(made.error(), lesson.hand.line);
    }
    made->beside = options.live && has_thread(*lesson.hand.tool);
    plan.haptic.tool = std::make_shared<const ToolPlan>(std::move(*made));
    leave_out_surfaces(lesson, plan);
    plan.tool_shapes = std::move(bodies->sources);
    plan.tool_shapes.push_back(source);
    add_notices(lesson, bodies->notices, plan);
    return check_tool(lesson.hand, *plan.haptic.tool, *order->shell);
}

}  // namespace fulcrum::runtime
