#include "runtime/effect/tool/tool_body_list.h"

#include "haptics/collision/collision_mesh.h"
#include "runtime/scene/round_up.h"
#include "runtime/text/amounts.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <functional>
#include <limits>
#include <map>
#include <numeric>
#include <string>
#include <utility>

namespace fulcrum::runtime {
namespace {

constexpr int kFinestDefault = 400;       // voxels along a body's longest side
constexpr double kDefaultVoxels = 4.0e6;  // of a body at most
constexpr double kFinestDefault_m = 5.0e-5;
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

}  // namespace

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

}  // namespace fulcrum::runtime
