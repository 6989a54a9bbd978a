#include "runtime/effect/tool/tool_bodies.h"

#include "haptics/voxel/voxelise.h"
#include "runtime/effect/tool/tool_notices.h"
#include "runtime/files/shape_cache.h"
#include "runtime/scene/round_up.h"
#include "runtime/text/amounts.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace fulcrum::runtime {
namespace {

constexpr double kBrakes_m = 0.004;  // the braking layers' depth, in the hand's metres
constexpr int kMostLayers = 8;
constexpr double kBand_voxels = 4.0;   // of a field
constexpr double kSheet_voxels = 1.0;  // on either side of an open mesh: no thinner wall is held
constexpr int kBrickCells = 8;

Expected<VoxelGrid> make_grid(const ToolBodyList::Mesh& of, double scale, ShapeCache& shapes,
                              const LoadProgress& progress) {
    VoxeliseSettings settings{.voxel_m = of.voxel_m, .offset_layers = 1};
    settings.proximity_layers = static_cast<int>(std::clamp(
        std::ceil(kBrakes_m * scale / of.voxel_m), 1.0, static_cast<double>(kMostLayers)));
    return recall_voxels(shapes, of.mesh, settings, progress);
}

Expected<DistanceField> make_field(const ToolBodyList::Mesh& of, double sheet_voxels,
                                   ShapeCache& shapes, const LoadProgress& progress) {
    const double length_m = (of.mesh.upper_B() - of.mesh.lower_B()).maxCoeff();
    const double margin = kBand_voxels + sheet_voxels;
    const double rows = std::ceil((length_m / of.voxel_m + 2.0 * margin + 2.0) / kBrickCells);
    const int n_along = kBrickCells * std::max(2, static_cast<int>(rows));
    return make_field_frame(of.mesh, n_along, margin).and_then([&](const VoxelFrame& frame) {
        return recall_distance_field(shapes, of.mesh, frame,
                                     {.band_voxels = kBand_voxels, .sheet_voxels = sheet_voxels},
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
