#include "tests/bench/curves/accuracy_scenes.h"

#include "haptics/geometry/shape.h"
#include "tests/bench/curves/mesh_file.h"
#include "tests/bench/harness/curve.h"
#include "tests/support/wander.h"

#include <cctype>
#include <filesystem>

namespace fulcrum::bench {
namespace {

constexpr double kPi = std::numbers::pi;
constexpr double kDeep_m = 0.01;
constexpr double kRadius_m = 0.5;  // of ball and cylinder
// From the upright scene to the lattice.
const Quaternion kAskew(AngleAxis(0.4, Vector3(1.0, 2.0, 3.0).normalized()));
// The tool's middle in its own frame.
const Vector3 kMiddle_T(0.2, 0.1, -0.15);

TriangleMesh make_askew(const TriangleMesh& mesh) {
    return make_changed(mesh, [](const Vector3& v) -> Vector3 { return kAskew * v; });
}

// A prism of so many sides that it is round to 5e-6 of its radius; its axis is z.
TriangleMesh make_cylinder(double length_m) {
    constexpr int kSides = 1000;
    std::vector<Vector3> vertices{{0.0, 0.0, -0.5 * length_m}, {0.0, 0.0, 0.5 * length_m}};
    std::vector<TriangleCorners> triangles;
    for (int i = 0; i < kSides; ++i) {
        const double angle = 2.0 * kPi * i / kSides;
        for (const double z : {-0.5 * length_m, 0.5 * length_m}) {
            vertices.emplace_back(kRadius_m * std::cos(angle), kRadius_m * std::sin(angle), z);
        }
        const int here = 2 + 2 * i;
        const int next = 2 + 2 * ((i + 1) % kSides);
        triangles.push_back({here, next, next + 1});
        triangles.push_back({here, next + 1, here + 1});
        triangles.push_back({0, next, here});
        triangles.push_back({1, here + 1, next + 1});
    }
    return TriangleMesh::build(std::move(vertices), std::move(triangles)).value();
}

// A tool whose middle is at `middle_U`, turned, in the upright scene.
Pose place(const Vector3& middle_U, const Quaternion& turn_UT) {
    const Quaternion turn_OT = kAskew * turn_UT;
    return {kAskew * middle_U - turn_OT * kMiddle_T, turn_OT};
}

// A push up through the tool's middle.
Wrench push_up(const Pose& X_OT, double force_N) {
    const Vector3 force_O = kAskew * Vector3(0.0, force_N, 0.0);
    return {force_O, (X_OT.orientation * kMiddle_T).cross(force_O)};
}

struct NamedMesh {
    std::string name;
    TriangleMesh mesh;
};

// A person's own mesh, in the middle and as large as the usual one, or that.
NamedMesh load_as_large(const std::string& file, const std::string& usual_name,
                        const TriangleMesh& usual) {
    if (file.empty()) {
        return {usual_name, usual};
    }
    const auto longest_m = [](const TriangleMesh& mesh) {
        return (mesh.upper_B() - mesh.lower_B()).maxCoeff();
    };
    const TriangleMesh loaded = must(load_mesh_file(file));
    return {std::filesystem::path(file).stem().string(),
            make_scaled(loaded, longest_m(usual) / longest_m(loaded))};
}

Pointshell put_beside(const Pointshell& shell) {
    return make_moved(shell, Pose::at(kMiddle_T));
}

}  // namespace

AccuracyScene make_sphere_plane(int n_poses) {
    AccuracyScene scene{"sphere-plane",
                        "A ball on a plane",
                        "analytic: the pressure's integral over the cap that lies in the plane",
                        make_askew(*make_box({2.4, 0.8, 2.4})),
                        {},
                        4.0 * kPi * kRadius_m * kRadius_m,
                        {},
                        {}};
    scene.make_shell = [](int n_points) {
        // Points of a mesh, put on the ball itself.
        constexpr int kFrequency = 40;
        const Pointshell facets =
            make_surface_pointshell(*make_sphere(kRadius_m, kFrequency), n_points).value();
        Pointshell shell;
        for (std::size_t i = 0; i < facets.size(); ++i) {
            const Vector3 out = facets.position_T(i).normalized();
            shell.add(kRadius_m * out, -out);
        }
        return put_beside(shell);
    };
    const double u = 1.0 - kDeep_m / kRadius_m;
    const double force_N =
        2.0 * kPi * kRadius_m * kRadius_m *
        ((kDeep_m - kRadius_m) * (1.0 - u * u) / 2.0 + kRadius_m * (1.0 - u * u * u) / 3.0);
    Random random(21);
    for (int i = 0; i < n_poses; ++i) {
        const Vector3 middle_U(0.3 * random.uniform(), 0.4 + kRadius_m - kDeep_m,
                               0.3 * random.uniform());
        scene.X_OT.push_back(place(middle_U, random.turn(kPi)));
        scene.wrenches_O.push_back(push_up(scene.X_OT.back(), force_N));
    }
    return scene;
}

AccuracyScene make_cylinder_box(int n_poses) {
    const Vector3 size_m(1.0, 0.3, 0.4);
    AccuracyScene scene{
        "cylinder-box",
        "A box's face on a cylinder",
        "analytic: the pressure's integral over the part of the face that lies in the cylinder",
        make_askew(make_cylinder(1.6)),
        {},
        2.0 * (size_m.x() * size_m.y() + size_m.y() * size_m.z() + size_m.z() * size_m.x()),
        {},
        {}};
    scene.make_shell = [size_m](int n_points) {
        return put_beside(make_surface_pointshell(*make_box(size_m), n_points).value());
    };
    const double h = kRadius_m - kDeep_m;
    const double x = std::sqrt(kRadius_m * kRadius_m - h * h);
    const double force_N = size_m.z() * (kRadius_m * x - h * h * std::asinh(x / h));
    Random random(22);
    for (int i = 0; i < n_poses; ++i) {
        const Vector3 middle_U(0.3 * random.uniform(), h + 0.5 * size_m.y(),
                               0.4 * random.uniform());
        const Quaternion half_turn(AngleAxis(i % 2 == 0 ? 0.0 : kPi, Vector3::UnitY()));
        scene.X_OT.push_back(place(middle_U, half_turn));
        // The face's middle is beside the line that touches: the push goes through the line.
        Wrench wrench = push_up(scene.X_OT.back(), force_N);
        const Vector3 beside_O = kAskew * Vector3(-middle_U.x(), 0.0, 0.0);
        wrench.torque += beside_O.cross(wrench.force);
        scene.wrenches_O.push_back(wrench);
    }
    return scene;
}

AccuracyScene make_free_forms(int n_poses, const std::string& object_file,
                              const std::string& tool_file) {
    const NamedMesh object = load_as_large(object_file, "a torus", *make_torus(0.7, 0.3, 120, 60));
    const NamedMesh named_tool =
        load_as_large(tool_file, "a bumpy ball", *make_bumpy_sphere(0.3, 40, 0.05, 9.0));
    const TriangleMesh& tool = named_tool.mesh;
    AccuracyScene scene{"free-forms",
                        named_tool.name + " on " + object.name,
                        "converged: many points and the finest field",
                        make_askew(object.mesh),
                        {},
                        0.0,
                        {},
                        {}};
    scene.title.front() = static_cast<char>(std::toupper(scene.title.front()));
    for (const TriangleCorners& t : tool.triangles()) {
        const std::vector<Vector3>& v = tool.vertices_B();
        const auto at = [&](int corner) {
            return v[static_cast<std::size_t>(t[static_cast<std::size_t>(corner)])];
        };
        scene.area_m2 += 0.5 * (at(1) - at(0)).cross(at(2) - at(0)).norm();
    }
    scene.make_shell = [tool](int n_points) {
        return put_beside(make_surface_pointshell(tool, n_points).value());
    };
    // From each side towards the middle of the object, as deep behind the first touch as in the other scenes; where only a tip is in
    // by then, which no voxel resolves, deeper.
    const FieldSampler::Field field = make_distance_field(scene.object, 256);
    const auto shell =
        std::make_shared<const ShellTree>(ShellTree::build(scene.make_shell(20000)).value());
    FieldSampler sampler = FieldSampler::build(field, shell).value();
    constexpr int kLeastInside = 100;  // of 20 000
    constexpr double kDeepest_m = 8 * kDeep_m;
    Random random(23);
    while (static_cast<int>(scene.X_OT.size()) < n_poses) {
        const Quaternion turn = random.turn(kPi);
        const Vector3 out = random.direction();
        const auto at = [&](double way_m) {
            return Pose{(2.0 - way_m) * out - turn * kMiddle_T, turn};
        };
        const double way_m = 2.0 * sampler.find_first_touch(at(0.0), at(2.0));
        double depth_m = kDeep_m;
        while (depth_m < kDeepest_m &&
               sampler.step({}, at(way_m + depth_m)).n_touching < kLeastInside) {
            depth_m += kDeep_m;
        }
        if (way_m < 2.0 && depth_m < kDeepest_m) {
            scene.X_OT.push_back(at(way_m + depth_m));
        }
    }
    return scene;
}

}  // namespace fulcrum::bench
