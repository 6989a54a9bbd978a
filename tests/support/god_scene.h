// A god-object's tool and what it meets, for tests: meshes in, a tool out; and whether anything is inside anything, exactly.
#pragma once

#include "haptics/continuous/nearest_features.h"
#include "haptics/geometry/shape.h"
#include "haptics/tool/god_object/god_object_tool.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>
#include <vector>

namespace fulcrum::test {

inline constexpr double kGodDt_s = 0.001;

/// As they ship.
inline GodObjectSettings make_god_settings(const Inertia& inertia) {
    GodObjectSettings settings;
    settings.inertia = inertia;
    return settings;
}

/// But that a set of contacts is felt at once: where a test asks for what the contacts alone make of it.
inline GodObjectSettings make_sudden_settings(const Inertia& inertia) {
    GodObjectSettings settings = make_god_settings(inertia);
    settings.fade_s = 0.0;
    return settings;
}

inline GodObjectTool make_god_tool(const TriangleMesh& tool,
                                   const std::vector<TriangleMesh>& objects,
                                   const GodObjectSettings& settings) {
    const auto swept = GodSurface::create(tool);
    std::vector<GodObjectPlan> plans;
    plans.reserve(objects.size());
    for (const TriangleMesh& object : objects) {
        plans.push_back({GodSurface::create(object), swept});
    }
    return GodObjectTool::build(plans, settings).value();
}

/// So heavy to turn that it stays as it is held.
inline Inertia make_still_inertia() {
    return {.mass_kg = 0.05, .moments_kg_m2 = Vector3::Constant(0.05)};
}

inline TriangleMesh make_cube(double edge_m) {
    return make_box(Vector3::Constant(edge_m)).value();
}

/// A block 0.1 m high whose upper face lies at y = 0.
inline TriangleMesh make_ground(double side_m = 0.5) {
    const PlacedBox block{{0.0, -0.05, 0.0}, {side_m, 0.1, side_m}};
    return make_boxes({&block, 1}).value();
}

/// Its tip at the origin, pointing down; steep, so that the tip alone touches.
inline TriangleMesh make_spike() {
    return TriangleMesh::build({{0.0, 0.0, 0.0},
                                {0.004, 0.02, 0.0},
                                {-0.002, 0.02, 0.0035},
                                {-0.002, 0.02, -0.0035}},
                               {{0, 1, 2}, {0, 2, 3}, {0, 3, 1}, {1, 3, 2}})
        .value();
}

/// Steps of a tool against one object, both held at their places; what the last one felt.
inline ToolFelt move_to(GodObjectTool& tool, const Pose& handle_W, int n_steps = 1,
                        const Pose& object_W = {}) {
    ToolFelt felt;
    const MovingFrame object{object_W, {}};
    for (int i = 0; i < n_steps; ++i) {
        felt = tool.move({handle_W, {}}, {&object, 1}, 0.0, kGodDt_s);
    }
    return felt;
}

/// Of one of its triangles, from that frame.
inline Triangle find_corners(const TriangleMesh& mesh, const TriangleCorners& t,
                             const Pose& pose = {}) {
    const auto at = [&](std::size_t i) -> Vector3 {
        return pose * mesh.vertices_B()[static_cast<std::size_t>(t[i])];
    };
    return {at(0), at(1), at(2)};
}

/// Do surfaces cross? Every triangle against every other whose boxes along the axes meet, by exact signs.
inline bool do_cross(const TriangleMesh& object, const Pose& object_W, const TriangleMesh& tool,
                     const Pose& tool_W) {
    struct Boxed {
        Triangle corners;
        Vector3 low, high;
    };
    const auto list = [](const TriangleMesh& mesh, const Pose& pose) {
        std::vector<Boxed> all;
        all.reserve(mesh.triangles().size());
        for (const TriangleCorners& t : mesh.triangles()) {
            const Triangle c = find_corners(mesh, t, pose);
            all.push_back(
                {c, c[0].cwiseMin(c[1]).cwiseMin(c[2]), c[0].cwiseMax(c[1]).cwiseMax(c[2])});
        }
        return all;
    };
    const std::vector<Boxed> fixed = list(object, Pose{});
    for (const Boxed& moving : list(tool, object_W.inverse() * tool_W)) {
        for (const Boxed& held : fixed) {
            if (all_at_most(moving.low, held.high) && all_at_most(held.low, moving.high) &&
                fulcrum::do_cross(held.corners, moving.corners)) {
                return true;
            }
        }
    }
    return false;
}

/// How often a mesh winds round a place: 1 where it encloses it, 0 outside a closed one; where that is open, as much of a turn as is seen of its back.
/// By the solid angles of its triangles: A. van Oosterom, J. Strackee 1983, IEEE Trans. Biomedical Engineering 30(2).
inline double find_winding(const TriangleMesh& mesh, const Vector3& at_B) {
    double angles = 0.0;
    for (const TriangleCorners& t : mesh.triangles()) {
        const auto [a, b, c] = find_corners(mesh, t, Pose::at(-at_B));
        angles += 2.0 * std::atan2(a.dot(b.cross(c)),
                                   a.norm() * b.norm() * c.norm() + a.dot(b) * c.norm() +
                                       b.dot(c) * a.norm() + c.dot(a) * b.norm());
    }
    return angles / (4.0 * std::numbers::pi);
}

/// Is one in the other: do surfaces cross, or does one enclose the other, told by a corner? Of meshes in one piece.
inline bool do_enter(const TriangleMesh& object, const Pose& object_W, const TriangleMesh& tool,
                     const Pose& tool_W) {
    constexpr double kEnclosed = 0.75;  // open floors and corners show less of their back
    const Pose X_OT = object_W.inverse() * tool_W;
    return do_cross(object, object_W, tool, tool_W) ||
           find_winding(object, X_OT * tool.vertices_B().front()) > kEnclosed ||
           find_winding(tool, X_OT.inverse() * object.vertices_B().front()) > kEnclosed;
}

/// Between surfaces: every triangle against every other, by their features; 0 where they cross.
inline double find_distance_m(const TriangleMesh& object, const Pose& object_W,
                              const TriangleMesh& tool, const Pose& tool_W) {
    const Pose X_OT = object_W.inverse() * tool_W;
    double least_m = std::numeric_limits<double>::infinity();
    for (const TriangleCorners& t : tool.triangles()) {
        const Triangle moving = find_corners(tool, t, X_OT);
        for (const TriangleCorners& o : object.triangles()) {
            least_m = std::min(least_m,
                               find_nearest_features(find_corners(object, o), moving).distance_m);
        }
    }
    return least_m;
}

/// A tool among objects, led step by step.
struct GodScene {
    TriangleMesh tool;
    std::vector<TriangleMesh> objects;
    GodObjectTool god;
    std::vector<MovingFrame> frames;  ///< of the objects

    GodScene(TriangleMesh tool_mesh, std::vector<TriangleMesh> object_meshes,
             const GodObjectSettings& settings)
        : tool(std::move(tool_mesh)),
          objects(std::move(object_meshes)),
          god(make_god_tool(tool, objects, settings)),
          frames(objects.size()) {}
    ToolFelt step(const Pose& handle) { return god.move({handle, {}}, frames, 0.0, kGodDt_s); }
    /// Anywhere, where the objects were said to be, or where they wait.
    [[nodiscard]] bool is_inside() const {
        for (std::size_t i = 0; i < objects.size(); ++i) {
            if (test::do_enter(objects[i], god.object_W(i), tool, god.pose_W())) {
                return true;
            }
        }
        return false;
    }
};

/// A block along z with a hole along z, round with n sides that touch a circle of `hole_m`; 8 n triangles.
inline TriangleMesh make_block_with_hole(int n, double hole_m, double outside_m, double height_m) {
    std::vector<Vector3> vertices;
    std::vector<TriangleCorners> triangles;
    const double corner_m = hole_m / std::cos(std::numbers::pi / n);
    for (int i = 0; i < n; ++i) {
        const double angle = 2.0 * std::numbers::pi * i / n;
        const Vector3 along(std::cos(angle), std::sin(angle), 0.0);
        const Vector3 up(0.0, 0.0, 0.5 * height_m);
        vertices.insert(vertices.end(), {corner_m * along - up, corner_m * along + up,
                                         outside_m * along - up, outside_m * along + up});
    }
    const auto quad = [&](int a, int b, int c, int d) {
        triangles.push_back({a, b, c});
        triangles.push_back({a, c, d});
    };
    for (int i = 0; i < n; ++i) {
        const int a = 4 * i;
        const int b = 4 * ((i + 1) % n);
        quad(a, a + 1, b + 1, b);          // the hole's wall
        quad(a + 2, b + 2, b + 3, a + 3);  // outside
        quad(a + 1, a + 3, b + 3, b + 1);  // above
        quad(a, b, b + 2, a + 2);          // below
    }
    return TriangleMesh::build(std::move(vertices), std::move(triangles)).value();
}

}  // namespace fulcrum::test
