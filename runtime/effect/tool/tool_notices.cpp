#include "runtime/effect/tool/tool_notices.h"

#include "haptics/collision/wall_thickness.h"
#include "runtime/scene/round_up.h"
#include "runtime/text/amounts.h"

#include <array>
#include <cmath>
#include <cstdio>

namespace fulcrum::runtime {
namespace {

constexpr double kHeldBy_voxels = 2.0;
constexpr double kShare = 0.05;  // of the surface: not edges and tips, where a mesh is rounded
constexpr int kPlaces = 2000;
constexpr double kRounding = 1.0e-4;  // places are single precision
constexpr double kElsewhere_m = 1.0e6;

std::string two_digits(double value) {
    std::array<char, 32> text{};
    std::snprintf(text.data(), text.size(), "%.2g", value);
    return text.data();
}

}  // namespace

std::optional<std::string> tell_thin_wall(const ToolBodyList::Mesh& of, double voxel_m) {
    const auto mesh = CollisionMesh::create(of.mesh);
    const auto places = make_surface_pointshell(of.mesh, kPlaces);
    if (!mesh || !places) {
        return {};
    }
    const double wall_m = find_wall_m(**mesh, *places, kShare);
    const double held_m = kHeldBy_voxels * voxel_m;
    if (wall_m >= (1.0 - kRounding) * held_m) {
        return {};
    }
    // Two digits, downwards: a voxel that does.
    const double length_m = (of.mesh.upper_B() - of.mesh.lower_B()).maxCoeff();
    const double digit =
        std::pow(10.0, std::floor(std::log10(std::max(wall_m, 1.0e-9) / kHeldBy_voxels)) - 1.0);
    const double finer_m = std::floor(wall_m / kHeldBy_voxels / digit + kRounding) * digit;
    const std::string thicker = "make it " + two_digits(round_up(held_m)) + " m thick or more";
    return to_sentence({"the " + of.body->noun + ": it has walls of " + metres_text(wall_m) +
                            ", and voxels of " + metres_text(voxel_m) +
                            " hold no wall thinner than two of them: a tool may be pressed through",
                        at_line(of.body->line),
                        can_be_met_with(length_m, finer_m)
                            ? thicker + ", or give the tool a voxel of " + two_digits(finer_m)
                            : thicker});
}

std::vector<std::string> tell_start_inside(const LessonDescription& lesson,
                                           const std::vector<SolidPlan>& solids,
                                           const ToolPlan& plan) {
    std::vector<std::string> told;
    const std::unique_ptr<ToolSolver> tool = make_tool(plan);
    tool->place(Pose::at(lesson.hand.centre_W));
    for (std::size_t i = 0; i < solids.size(); ++i) {
        const BodyDescription& body = lesson.bodies[static_cast<std::size_t>(solids[i].body)];
        if (!body.visible) {
            continue;  // it is put somewhere later
        }
        // This one alone; the others are far away.
        std::vector<MovingFrame> frames(solids.size(),
                                        {Pose::at({kElsewhere_m, kElsewhere_m, kElsewhere_m}), {}});
        frames[i].pose_W = Pose::at(body.position_W);
        if (!tool->is_free(frames)) {
            told.push_back(
                to_sentence({"the tool begins inside the " + body.noun +
                                 ", and nothing is felt of it until it is outside",
                             at_line(lesson.hand.line),
                             "put the hand's centre or the " + body.noun + " elsewhere"}));
        }
    }
    return told;
}

}  // namespace fulcrum::runtime
