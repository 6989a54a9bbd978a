#include "runtime/scene/plan_tool.h"

#include "haptics/collision/collision_mesh.h"
#include "haptics/dynamics/mesh_inertia.h"
#include "haptics/geometry/shape.h"
#include "haptics/tool/tool_plan.h"
#include "haptics/voxel/voxelise.h"
#include "runtime/files/shape_cache.h"
#include "runtime/scene/check_tool.h"
#include "runtime/scene/explain.h"
#include "runtime/scene/plan_touch.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <memory>
#include <sstream>
#include <utility>
#include <variant>
#include <vector>

namespace fulcrum::runtime {
namespace {

constexpr int kFinestDefault = 400;       // voxels along a body's longest side
constexpr double kDefaultVoxels = 4.0e6;  // of a body at most
constexpr double kBrakes_m = 0.004;       // the braking layers' depth, in the hand's metres
constexpr int kMostLayers = 8;
constexpr double kBand_voxels = 4.0;  // of a field
constexpr int kBrickCells = 8;
constexpr double kMarginCells = 24.0;  // layers and bands on both sides, at most
constexpr double kMostAlong = 504.0;   // voxels along a body, margins included
constexpr int kRound = 48;             // sides of a round tool

// Bounds of a mesh.
struct Bounds {
    Vector3 lower_B;
    Vector3 upper_B;
    [[nodiscard]] Vector3 size_m() const { return upper_B - lower_B; }
};

Bounds bounds_of(const TriangleMesh& mesh) {
    return {mesh.lower_B(), mesh.upper_B()};
}

Expected<TriangleMesh> mesh_of(const CollisionMesh& mesh) {
    const auto vertices = mesh.vertices_B();
    const auto triangles = mesh.triangles();
    return TriangleMesh::build({vertices.begin(), vertices.end()},
                               {triangles.begin(), triangles.end()});
}

struct MakeMesh {
    Expected<TriangleMesh> operator()(const SphereShape& ball) const {
        return make_sphere(ball.radius_m, kRound / 4);
    }
    Expected<TriangleMesh> operator()(const BoxShape& box) const {
        return make_box(2.0 * box.half_size_m);
    }
    Expected<TriangleMesh> operator()(const CapsuleShape& capsule) const {
        return make_capsule(capsule.radius_m, 2.0 * capsule.half_length_m, kRound, kRound / 4);
    }
    Expected<TriangleMesh> operator()(const CylinderShape& cylinder) const {
        return make_cylinder(cylinder.radius_m, 2.0 * cylinder.half_height_m, kRound);
    }
    template <class Other>
    Expected<TriangleMesh> operator()(const Other& /*shape*/) const {
        return fail("the tool has no shape", {}, "give it a shape or a model");
    }
};

Expected<TriangleMesh> load_tool_mesh(const ToolDescription& tool, SourceLine line,
                                      const SolidLoader& load_solid) {
    if (tool.model.empty()) {
        return std::visit(MakeMesh{}, tool.shape);
    }
    BodyDescription body;
    body.name = "the tool";
    body.noun = "tool";
    body.model = tool.model;
    body.line = line;
    return load_solid(body).and_then([](const auto& mesh) { return mesh_of(*mesh); });
}

double choose_voxel_m(const ToolDescription& tool, const Bounds& bounds) {
    if (tool.voxel_m > 0.0) {
        return tool.voxel_m;
    }
    const Vector3 size_m = bounds.size_m();
    return std::max(size_m.maxCoeff() / kFinestDefault, std::cbrt(size_m.prod() / kDefaultVoxels));
}

std::string millimetres(double metres) {
    std::ostringstream text;
    text.precision(2);
    text << 1e3 * metres << " mm";
    return text.str();
}

// What all bodies are made into.
struct Objects {
    std::vector<std::shared_ptr<const VoxelGrid>> grids;
    std::vector<FieldSampler::Field> fields;
    double voxels_left = kMostVoxels;
    LoadProgress progress;  // of the next one
};

// What `make` gives, and whether the cache had it.
template <class Make>
auto make_and_note(const ShapeCache& shapes, std::vector<ShapeSource>& sources, const Make& make) {
    const int n_made = shapes.counts().n_made;
    auto made = make();
    sources.push_back(shapes.counts().n_made > n_made ? ShapeSource::made : ShapeSource::cache);
    return made;
}

Expected<void> add_grid(const TriangleMesh& mesh, double voxel_m, double scale, ShapeCache& shapes,
                        Objects& objects) {
    VoxeliseSettings settings{.voxel_m = voxel_m, .offset_layers = 1};
    settings.proximity_layers = static_cast<int>(
        std::clamp(std::ceil(kBrakes_m * scale / voxel_m), 1.0, static_cast<double>(kMostLayers)));
    return recall_voxels(shapes, mesh, settings, objects.progress).map([&](VoxelGrid grid) {
        objects.grids.push_back(std::make_shared<const VoxelGrid>(std::move(grid)));
    });
}

Expected<void> add_field(const TriangleMesh& mesh, double voxel_m, ShapeCache& shapes,
                         Objects& objects) {
    const double length_m = bounds_of(mesh).size_m().maxCoeff();
    const double rows = std::ceil((length_m / voxel_m + 2.0 * kBand_voxels + 2.0) / kBrickCells);
    const int n_along = kBrickCells * std::max(2, static_cast<int>(rows));
    return DistanceField::make_frame(mesh, n_along, kBand_voxels)
        .and_then([&](const VoxelFrame& frame) {
            return recall_distance_field(shapes, mesh, frame, {.band_voxels = kBand_voxels},
                                         objects.progress);
        })
        .map([&](DistanceField field) {
            objects.fields.push_back(std::make_shared<const DistanceField>(std::move(field)));
        });
}

// One solid body, from the voxels that are left.
Expected<void> add_object(const LessonDescription& lesson, const BodyDescription& body,
                          const CollisionMesh& mesh, ShapeCache& shapes, Objects& objects) {
    const ToolDescription& tool = *lesson.hand.tool;
    const auto triangles = mesh_of(mesh);
    if (!triangles) {
        return tl::unexpected(triangles.error());
    }
    const double voxel_m = choose_voxel_m(tool, bounds_of(*triangles));
    const Vector3 cells = (bounds_of(*triangles).size_m() / voxel_m).array() + kMarginCells;
    objects.voxels_left -= cells.prod();
    if (objects.voxels_left < 0.0 || cells.maxCoeff() > kMostAlong) {
        return fail("voxels of " + millimetres(voxel_m) + " are too small for the " + body.noun +
                        " that the tool meets",
                    at_line(lesson.hand.line),
                    "give the tool larger voxels: at most 480 along a body, and 64 million in all");
    }
    return tool.method == ToolMethod::voxel_sampling
               ? add_grid(*triangles, voxel_m, lesson.hand.scale, shapes, objects)
               : add_field(*triangles, voxel_m, shapes, objects);
}

// Each solid body as the method needs it.
Expected<Objects> make_objects(const LessonDescription& lesson, const PlanProgress& progress,
                               ShapeCache& shapes, Plan& plan) {
    Objects objects;
    const std::vector<SolidPlan>& solids = plan.haptic.solids;
    for (std::size_t i = 0; i < solids.size(); ++i) {
        const BodyDescription& body = lesson.bodies[static_cast<std::size_t>(solids[i].body)];
        if (body.material != kNoMaterial) {
            return fail("the " + body.noun + " has a material, and a tool feels its shape alone",
                        at_line(body.line), "leave out the material, or the hand's tool");
        }
        if (progress) {
            objects.progress = [&progress, &body, i, n = solids.size()](double share) {
                return progress((static_cast<double>(i) + share) / static_cast<double>(n),
                                body.noun);
            };
        }
        const auto added = make_and_note(shapes, plan.tool_shapes, [&] {
            return add_object(lesson, body, **find_mesh(solids[i].shape), shapes, objects);
        });
        if (!added) {
            const Error& error = added.error();
            return fail(error.message,
                        error.where.empty() ? at_line(lesson.hand.line) : error.where,
                        error.what_to_do);
        }
        if (const auto holes =
                objects.fields.empty() ? std::nullopt : objects.fields.back()->tell_holes()) {
            plan.notices.push_back(to_sentence(
                {"the " + body.noun + ": " + holes->message, at_line(body.line), "close them"}));
        }
    }
    return objects;
}

// The tool about its centre of mass, along its principal axes; the hand holds it at its mesh's origin, as that is turned.
Expected<ToolOrder> make_order(const LessonDescription& lesson, const SolidLoader& load_solid,
                               ShapeCache& shapes) {
    const ToolDescription& tool = *lesson.hand.tool;
    const double scale = lesson.hand.scale;
    auto mesh = load_tool_mesh(tool, lesson.hand.line, load_solid);
    if (!mesh) {
        return tl::unexpected(mesh.error());
    }
    auto inertia = compute_inertia_of_mass(*mesh, tool.mass_kg / scale, name_of(tool));
    auto shell = recall_surface_pointshell(shapes, *mesh, tool.points);
    if (!inertia || !shell) {
        return tl::unexpected(inertia ? shell.error() : inertia.error());
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

const char* name_of(ShapeSource source) {
    return source == ShapeSource::made ? "made now" : "from the cache";
}

}  // namespace

std::string name_of(const ToolDescription& tool) {
    constexpr std::array<const char*, 6> kNames{"", "ball", "box", "capsule", "cylinder", "hull"};
    return tool.model.empty() ? kNames[tool.shape.index()] : tool.model;
}

const char* name_of(ToolMethod method) {
    return method == ToolMethod::voxel_sampling ? "voxel_sampling" : "field_sampling";
}

Expected<void> add_tool(const LessonDescription& lesson, const SolidLoader& load_solid,
                        const PlanOptions& options, Plan& plan) {
    if (!lesson.hand.tool) {
        return {};
    }
    const std::string where = at_line(lesson.hand.line);
    if (plan.haptic.solids.empty()) {
        return fail("the hand has a tool, and no body is solid", where,
                    "make a body solid = true, or leave the tool out");
    }
    if (lesson.bucket.present) {
        return fail("the hand has a tool and a bucket", where, "leave out one of them");
    }
    ShapeCache none{{}};
    ShapeCache& shapes = options.shapes != nullptr ? *options.shapes : none;
    const auto objects = make_objects(lesson, options.progress, shapes, plan);
    if (!objects) {
        return tl::unexpected(objects.error());
    }
    // The tool among them.
    std::shared_ptr<const Pointshell> shell;
    const auto made = make_and_note(shapes, plan.tool_shapes, [&] {
                          return make_order(lesson, load_solid, shapes);
                      }).and_then([&](ToolOrder order) -> Expected<ToolPlan> {
        order.most_force_N = plan.haptic.safety.max_force_N;
        shell = order.shell;
        return lesson.hand.tool->method == ToolMethod::voxel_sampling
                   ? make_voxel_tool_plan(order, objects->grids)
                   : make_field_tool_plan(order, objects->fields);
    });
    const auto checked = made.and_then([](const ToolPlan& tool) { return validate(tool); });
    if (!checked) {
        return fail("the tool: " + checked.error().message, where, checked.error().what_to_do);
    }
    plan.haptic.tool = std::make_shared<const ToolPlan>(*made);
    return check_tool(lesson.hand, *made, *shell);
}

std::vector<ToolObjectFacts> find_object_facts(const ToolPlan& plan) {
    std::vector<ToolObjectFacts> facts;
    if (const auto* fields = std::get_if<std::vector<FieldSamplingPlan>>(&plan.objects)) {
        for (const FieldSamplingPlan& object : *fields) {
            facts.push_back({object.field->frame(), object.field->memory_bytes()});
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
                  name_of(tool).c_str(), name_of(tool.method), tool.points,
                  tool.massless ? "massless" : std::string(to_string(tool.integrator)).c_str(),
                  tool.stiffness_N_per_m,
                  settings.coupling.turn.stiffness_Nm_per_rad / lesson.hand.scale,
                  name_of(plan.tool_shapes.back()));
    std::string text = line.data();
    const std::vector<ToolObjectFacts> facts = find_object_facts(*plan.haptic.tool);
    for (std::size_t i = 0; i < facts.size(); ++i) {
        const BodyDescription& body =
            lesson.bodies[static_cast<std::size_t>(plan.haptic.solids[i].body)];
        const VoxelFrame::Cell& n = facts[i].frame.n_cells;
        std::snprintf(line.data(), line.size(), "%-16.48s %d x %d x %d voxels of %s, %s, %s\n",
                      body.noun.c_str(), n[0], n[1], n[2],
                      millimetres(facts[i].frame.voxel_m).c_str(),
                      bytes_text(facts[i].bytes).c_str(), name_of(plan.tool_shapes[i]));
        text += line.data();
    }
    return "\nThe tool in the hand, and what it meets:\n" + text;
}

}  // namespace fulcrum::runtime
