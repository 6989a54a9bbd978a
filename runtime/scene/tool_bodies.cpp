#include "runtime/scene/tool_bodies.h"

#include "haptics/collision/collision_mesh.h"
#include "haptics/voxel/voxelise.h"
#include "runtime/files/shape_cache.h"
#include "runtime/scene/explain.h"
#include "runtime/scene/plan_touch.h"
#include "runtime/scene/round_up.h"
#include "runtime/scene/tool_notices.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numeric>
#include <utility>

namespace fulcrum::runtime {
namespace {

constexpr int kFinestDefault = 400;       // voxels along a body's longest side
constexpr double kDefaultVoxels = 4.0e6;  // of a body at most
constexpr double kFinestDefault_m = 5.0e-5;
constexpr double kBrakes_m = 0.004;  // the braking layers' depth, in the hand's metres
constexpr int kMostLayers = 8;
constexpr double kBand_voxels = 4.0;   // of a field
constexpr double kSheet_voxels = 1.0;  // on either side of an open mesh: no thinner wall is held
constexpr int kBrickCells = 8;
constexpr double kMarginCells = 24.0;  // layers and bands on both sides, at most
constexpr double kMostAlong = 504.0;   // voxels along a body, margins included
constexpr double kMillion = 1.0e6;

Vector3 size_of(const TriangleMesh& mesh) {
    return mesh.upper_B() - mesh.lower_B();
}

double count_voxels(const Vector3& size_m, double voxel_m) {
    return (size_m / voxel_m + Vector3::Constant(kMarginCells)).prod();
}

// The least voxel from `finest_m` on with which `fits(voxel)` is true; it is for a body's own length.
template <class Fits>
double find_least_voxel_m(double finest_m, double length_m, const Fits& fits) {
    if (fits(finest_m)) {
        return finest_m;
    }
    double too_fine_m = finest_m;
    double fine_m = std::max(finest_m, length_m);
    constexpr int kHalvings = 60;
    for (int i = 0; i < kHalvings; ++i) {
        const double middle_m = 0.5 * (too_fine_m + fine_m);
        (fits(middle_m) ? fine_m : too_fine_m) = middle_m;
    }
    return fine_m;
}

double choose_voxel_m(const Vector3& size_m, double most_voxels) {
    const double length_m = size_m.maxCoeff();
    const double finest_m = std::max(
        {length_m / kFinestDefault, std::cbrt(size_m.prod() / kDefaultVoxels), kFinestDefault_m});
    return find_least_voxel_m(finest_m, length_m, [&](double voxel_m) {
        return count_voxels(size_m, voxel_m) <= most_voxels;
    });
}

double sum_voxels(const ToolBodyList& list, double voxel_m) {
    return std::transform_reduce(
        list.meshes.begin(), list.meshes.end(), 0.0, std::plus<>(),
        [&](const ToolBodyList::Mesh& each) { return count_voxels(size_of(each.mesh), voxel_m); });
}

// With which all bodies could be made, two digits.
std::string least_voxel_text(const ToolBodyList& list) {
    double longest_m = 0.0;
    for (const ToolBodyList::Mesh& each : list.meshes) {
        longest_m = std::max(longest_m, size_of(each.mesh).maxCoeff());
    }
    const double least_m = find_least_voxel_m(
        longest_m / (kMostAlong - kMarginCells), longest_m,
        [&](double voxel_m) { return sum_voxels(list, voxel_m) <= kMostVoxels; });
    std::array<char, 32> text{};
    std::snprintf(text.data(), text.size(), "%.2g", round_up(least_m));
    return text.data();
}

// The lesson's own voxels.
Expected<void> check_voxels(const LessonDescription& lesson, const ToolBodyList& list) {
    const double voxel_m = lesson.hand.tool->voxel_m;
    const auto refuse = [&](const std::string& why) {
        return fail(
            "voxels of " + metres_text(voxel_m) + " are too " + why, at_line(lesson.hand.line),
            "leave out the tool's voxel, or make it " + least_voxel_text(list) + " or more");
    };
    for (const ToolBodyList::Mesh& each : list.meshes) {
        if (!can_be_met_with(size_of(each.mesh).maxCoeff(), voxel_m)) {
            return refuse("small for the " + each.body->noun +
                          " that the tool meets: at most 480 lie along a body");
        }
    }
    if (const double n = sum_voxels(list, voxel_m); n > kMostVoxels) {
        return refuse("many for what the tool meets: " + std::to_string(std::lround(n / kMillion)) +
                      " million, and at most " +
                      std::to_string(std::lround(kMostVoxels / kMillion)) + " million");
    }
    return {};
}

Expected<VoxelGrid> make_grid(const ToolBodyList::Mesh& of, double scale, ShapeCache& shapes,
                              const LoadProgress& progress) {
    VoxeliseSettings settings{.voxel_m = of.voxel_m, .offset_layers = 1};
    settings.proximity_layers = static_cast<int>(std::clamp(
        std::ceil(kBrakes_m * scale / of.voxel_m), 1.0, static_cast<double>(kMostLayers)));
    return recall_voxels(shapes, of.mesh, settings, progress);
}

Expected<DistanceField> make_field(const ToolBodyList::Mesh& of, double sheet_voxels,
                                   ShapeCache& shapes, const LoadProgress& progress) {
    const double length_m = size_of(of.mesh).maxCoeff();
    const double margin = kBand_voxels + sheet_voxels;
    const double rows = std::ceil((length_m / of.voxel_m + 2.0 * margin + 2.0) / kBrickCells);
    const int n_along = kBrickCells * std::max(2, static_cast<int>(rows));
    return DistanceField::make_frame(of.mesh, n_along, margin)
        .and_then([&](const VoxelFrame& frame) {
            return recall_distance_field(
                shapes, of.mesh, frame, {.band_voxels = kBand_voxels, .sheet_voxels = sheet_voxels},
                progress);
        });
}

// An open mesh with nothing in it that is a voxel deep.
bool is_hollow(const DistanceField& field) {
    const double deep_steps = field.frame().voxel_m / field.step_m();
    const auto is_deep = [&](std::int16_t value) { return value <= -deep_steps; };
    const auto& bricks = field.bricks();  // the first two are those that are alike throughout
    return field.counts().n_open_edges > 0 &&
           std::ranges::none_of(
               field.table(),
               [](const auto& entry) { return entry.brick == DistanceField::kInside; }) &&
           std::none_of(bricks.begin() + DistanceField::kInside + 1, bricks.end(),
                        [&](const DistanceField::Brick& brick) {
                            return std::ranges::any_of(brick.values, is_deep);
                        });
}

// A leaf or a flag has two outsides: it is felt as a sheet.
Expected<DistanceField> make_field_or_sheet(const ToolBodyList::Mesh& of, ShapeCache& shapes,
                                            const LoadProgress& progress) {
    return make_field(of, 0.0, shapes, progress).and_then([&](DistanceField field) {
        return is_hollow(field) ? make_field(of, kSheet_voxels, shapes, progress)
                                : Expected<DistanceField>(std::move(field));
    });
}

// What a teacher should know of a body that is met as a field.
std::optional<Error> tell_field(const DistanceField& field) {
    if (field.sheet_m() > 0.0) {
        return Error{"its mesh is open and encloses nothing, so a tool feels it as a sheet " +
                         metres_text(2.0 * field.sheet_m()) + " thick",
                     {},
                     "close the mesh where it should be solid"};
    }
    auto holes = field.tell_holes();
    if (holes) {
        holes->what_to_do = "close them";
    }
    return holes;
}

// What a teacher should know of a body that is met by its contact levels.
std::optional<std::string> tell_levels(const ToolBodyList::Mesh& of, const ContactLevels& levels) {
    const MeshReport& report = levels.report();
    if (report.is_closed() && report.inconsistent_edges == 0 && !report.inside_out) {
        return std::nullopt;
    }
    return to_sentence({"the " + of.body->noun + ": " +
                            (report.inside_out    ? "all of its triangles look inwards"
                             : report.is_closed() ? "some of its triangles are turned over"
                                                  : "its mesh is open") +
                            ", so on which side of it a tool is may be felt wrong",
                        at_line(of.body->line), "close it, with all fronts outwards"});
}

template <class Shape>
auto keep_in(std::vector<std::shared_ptr<const Shape>>& list) {
    return
        [&list](Shape shape) { list.push_back(std::make_shared<const Shape>(std::move(shape))); };
}

Expected<void> add_levels(const ToolBodyList::Mesh& of, double within_m, ShapeCache& shapes,
                          const LoadProgress& progress, ToolBodies& made) {
    return recall_contact_levels(shapes, of.mesh, {.within_m = within_m}, progress)
        .map([&](std::shared_ptr<const ContactLevels> levels) {
            if (auto told = tell_levels(of, *levels)) {
                made.notices.push_back(std::move(*told));
            }
            made.levels.push_back(std::move(levels));
            made.solids.push_back(std::make_shared<const TriangleClusters>(of.mesh));
        });
}

// Voxels or a field, and what a teacher should know of them.
Expected<void> add_sampled(const ToolBodyList::Mesh& of, const HandDescription& hand,
                           ShapeCache& shapes, const LoadProgress& progress, ToolBodies& made) {
    auto added = hand.tool->method == ToolMethod::voxel_sampling
                     ? make_grid(of, hand.scale, shapes, progress).map(keep_in(made.grids))
                     : make_field_or_sheet(of, shapes, progress).map(keep_in(made.fields));
    if (!added) {
        return added;
    }
    const auto told = made.fields.empty() ? std::nullopt : tell_field(*made.fields.back());
    if (told) {
        made.notices.push_back(to_sentence({"the " + of.body->noun + ": " + told->message,
                                            at_line(of.body->line), told->what_to_do}));
    }
    const VoxelFrame& frame =
        made.fields.empty() ? made.grids.back()->frame : made.fields.back()->frame();
    const bool is_sheet = !made.fields.empty() && made.fields.back()->sheet_m() > 0.0;
    if (auto thin = is_sheet ? std::nullopt : tell_thin_wall(of, frame.voxel_m)) {
        made.notices.push_back(std::move(*thin));
    }
    return {};
}

// One of `made` for each solid.
template <class Each>
std::vector<Each> deal_out(const std::vector<Each>& made, const std::vector<std::size_t>& mesh_of) {
    std::vector<Each> all;
    for (const std::size_t mesh : mesh_of) {
        if (mesh < made.size()) {
            all.push_back(made[mesh]);
        }
    }
    return all;
}

}  // namespace

bool has_levels(const ToolDescription& tool) {
    return tool.method == ToolMethod::implicit_penalty && tool.contact == ContactFinding::levels;
}

double find_finest_voxel_m(const ToolBodyList& list) {
    double finest_m = std::numeric_limits<double>::infinity();
    for (const ToolBodyList::Mesh& each : list.meshes) {
        finest_m = std::min(finest_m, each.voxel_m);
    }
    return finest_m;
}

bool can_be_met_with(double length_m, double voxel_m) {
    return length_m / voxel_m + kMarginCells <= kMostAlong;
}

Expected<TriangleMesh> to_triangles(const CollisionMesh& mesh) {
    const auto vertices = mesh.vertices_B();
    const auto triangles = mesh.triangles();
    return TriangleMesh::build({vertices.begin(), vertices.end()},
                               {triangles.begin(), triangles.end()});
}

Expected<ToolBodyList> list_tool_bodies(const LessonDescription& lesson,
                                        const std::vector<SolidPlan>& solids) {
    ToolBodyList list;
    std::map<const CollisionMesh*, std::size_t> known;
    for (const SolidPlan& solid : solids) {
        const BodyDescription& body = lesson.bodies[static_cast<std::size_t>(solid.body)];
        if (body.material != kNoMaterial && lesson.hand.tool->method != ToolMethod::god_object) {
            return fail(
                "the " + body.noun + " has a material, and a tool of points feels its shape alone",
                at_line(body.line),
                "leave out the material, or give the tool method = \"god_object\", which "
                "feels friction and texture");
        }
        const CollisionMesh* const mesh = find_mesh(solid.shape)->get();
        const auto [found, is_new] = known.emplace(mesh, list.meshes.size());
        if (is_new) {
            auto triangles = to_triangles(*mesh);
            if (!triangles) {
                return fail(triangles.error().message, at_line(body.line),
                            triangles.error().what_to_do);
            }
            list.meshes.push_back({&body, std::move(*triangles), lesson.hand.tool->voxel_m});
        }
        list.mesh_of.push_back(found->second);
    }
    if (lesson.hand.tool->voxel_m > 0.0) {
        return check_voxels(lesson, list).map([&] { return std::move(list); });
    }
    for (ToolBodyList::Mesh& each : list.meshes) {
        each.voxel_m = choose_voxel_m(size_of(each.mesh),
                                      kMostVoxels / static_cast<double>(list.meshes.size()));
    }
    return list;
}

Expected<ToolBodies> make_tool_bodies(const LessonDescription& lesson, const ToolBodyList& list,
                                      double within_m, const PlanProgress& progress,
                                      ShapeCache& shapes) {
    const ToolDescription& tool = *lesson.hand.tool;
    ToolBodies made;
    for (std::size_t i = 0; i < list.meshes.size(); ++i) {
        const ToolBodyList::Mesh& of = list.meshes[i];
        if (tool.method == ToolMethod::god_object) {
            made.surfaces.push_back(GodSurface::create(of.mesh));
            made.sources.push_back(ShapeSource::made);
            continue;
        }
        LoadProgress part;
        if (progress) {
            part = [&progress, &of, i, n = list.meshes.size()](double share) {
                return progress((static_cast<double>(i) + share) / static_cast<double>(n),
                                of.body->noun);
            };
        }
        const int n_made = shapes.counts().n_made;
        if (auto added = has_levels(tool) ? add_levels(of, within_m, shapes, part, made)
                                          : add_sampled(of, lesson.hand, shapes, part, made);
            !added) {
            return fail("the " + of.body->noun + ": " + added.error().message,
                        at_line(of.body->line), added.error().what_to_do);
        }
        made.sources.push_back(shapes.counts().n_made > n_made ? ShapeSource::made
                                                               : ShapeSource::cache);
    }
    made.grids = deal_out(made.grids, list.mesh_of);
    made.fields = deal_out(made.fields, list.mesh_of);
    made.surfaces = deal_out(made.surfaces, list.mesh_of);
    made.levels = deal_out(made.levels, list.mesh_of);
    made.solids = deal_out(made.solids, list.mesh_of);
    made.sources = deal_out(made.sources, list.mesh_of);
    return made;
}

}  // namespace fulcrum::runtime
