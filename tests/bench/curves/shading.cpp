// What shaded normals gain where a body is smooth, and what they cost where it has an edge.
//
// A torus has no edges: the worst error of the faces' own normals and of the shaded ones, over the number of triangles. A
// drum, a closed cylinder, is round with a rim of 90 degrees: the worst error over the crease angle, for drums of 12, 24 and 48 sides.
// Errors are against the normals of the true body at the nearest true place.
#include "haptics/surface/shading.h"

#include "haptics/geometry/shape.h"
#include "tests/bench/harness/curve.h"
#include "tests/support/touchable.h"

namespace fulcrum::bench {
namespace {

constexpr double kRing_m = 0.05;
constexpr double kTube_m = 0.02;
constexpr double kDrum_m = 0.05;

double angle_deg(const Vector3& a, const Vector3& b) {
    return std::atan2(a.cross(b).norm(), a.dot(b)) * 180.0 / std::numbers::pi;
}

Vector3 torus_normal(const Vector3& p) {
    const Vector3 ring = kRing_m * Vector3(p.x(), 0.0, p.z()).normalized();
    return (p - ring).normalized();
}

// Side or lid, whichever the face belongs to.
Vector3 drum_normal(const Vector3& p, const Vector3& face) {
    return std::abs(face.y()) > 0.5 ? Vector3(0.0, face.y() > 0.0 ? 1.0 : -1.0, 0.0)
                                    : Vector3(Vector3(p.x(), 0.0, p.z()).normalized());
}

TriangleMesh make_drum(std::int32_t sides) {
    std::vector<Vector3> vertices{{0.0, kDrum_m, 0.0}, {0.0, -kDrum_m, 0.0}};
    std::vector<TriangleCorners> triangles;
    for (std::int32_t i = 0; i < sides; ++i) {
        const double turn = 2.0 * std::numbers::pi * i / sides;
        for (const double y : {kDrum_m, -kDrum_m}) {
            vertices.emplace_back(kDrum_m * std::cos(turn), y, kDrum_m * std::sin(turn));
        }
        const std::int32_t a = 2 + 2 * i;
        const std::int32_t b = 2 + 2 * ((i + 1) % sides);
        triangles.push_back({0, b, a});
        triangles.push_back({1, a + 1, b + 1});
        triangles.push_back({a, b, a + 1});
        triangles.push_back({b, b + 1, a + 1});
    }
    return TriangleMesh::build(vertices, triangles).value();
}

// Places of a triangle that are looked at, as weights of its corners.
constexpr std::array<std::array<double, 3>, 7> kPlaces{{{1, 0, 0},
                                                        {0, 1, 0},
                                                        {0, 0, 1},
                                                        {0.5, 0.5, 0},
                                                        {0, 0.5, 0.5},
                                                        {0.5, 0, 0.5},
                                                        {1.0 / 3, 1.0 / 3, 1.0 / 3}}};

struct Errors {
    double flat_deg = 0.0;
    double shaded_deg = 0.0;
};

template <class True>
Errors find_errors(const CollisionMesh& mesh, const ShadedNormals& shaded, const True& truth) {
    Errors worst;
    for (std::int32_t t = 0; t < mesh.n_triangles(); ++t) {
        const TriangleCorners& corners = mesh.corners(t);
        const Vector3& a = mesh.vertex_B(corners[0]);
        const Vector3& b = mesh.vertex_B(corners[1]);
        const Vector3& c = mesh.vertex_B(corners[2]);
        const Vector3 face = (b - a).cross(c - a).normalized();
        for (const auto& w : kPlaces) {
            const Vector3 p = w[0] * a + w[1] * b + w[2] * c;
            const Vector3 normal = truth(p, face);
            worst.flat_deg = std::max(worst.flat_deg, angle_deg(face, normal));
            worst.shaded_deg =
                std::max(worst.shaded_deg, angle_deg(shaded.normal_B(t, p, face), normal));
        }
    }
    return worst;
}

LineChart draw_smooth(Run& run) {
    LineChart chart;
    chart.name = "shading";
    chart.title = "Shaded normals of a smooth body";
    chart.work =
        "The worst error of a ring's normals, at corners, sides and middles of all triangles.";
    chart.reference =
        "the normals of the true torus; theory: through the first point, as the size of the faces, "
        "and as its square";
    chart.advice =
        "Shade what is round: a mesh of some hundred triangles then feels as smooth as one of a "
        "hundred thousand.";
    chart.x = {"triangles", "", true};
    chart.y = {"worst error of a normal", "°", true};
    Line flat{"the faces' own"};
    Line shaded{"shaded"};
    Line first{"as the faces' size", LineStyle::theory};
    Line second{"as its square", LineStyle::theory};
    for (const int n : run.pick<std::vector<int>>({12, 24, 48, 96, 192}, {12, 48})) {
        const auto mesh = touchable(make_torus(kRing_m, kTube_m, 2 * n, n));
        const Errors errors =
            find_errors(*mesh, ShadedNormals(mesh, 60.0),
                        [](const Vector3& p, const Vector3&) { return torus_normal(p); });
        const double x = mesh->n_triangles();
        flat.add(x, errors.flat_deg);
        shaded.add(x, errors.shaded_deg);
        first.add(x, flat.y[0] * std::sqrt(flat.x[0] / x));
        second.add(x, shaded.y[0] * flat.x[0] / x);
    }
    chart.lines = {flat, first, shaded, second};
    return chart;
}

LineChart draw_creases(Run& run) {
    LineChart chart;
    chart.name = "shading-creases";
    chart.title = "What shading costs at a crease";
    chart.work =
        "The worst error of a drum's normals, at corners, sides and middles of all triangles; its "
        "rim bends by 90 degrees.";
    chart.reference = "the normals of the true drum, of its side and of its lids";
    chart.advice =
        "Choose the crease angle above what a round side bends by from face to face, and below "
        "what is an edge: 30 degrees from 12 sides on.";
    chart.x = {"crease angle", "°", false};
    chart.y = {"worst error of a normal", "°", false};
    for (const std::int32_t sides : {12, 24, 48}) {
        const auto mesh = touchable(make_drum(sides));
        Line line{std::to_string(sides) + " sides"};
        for (double crease = 0.0; crease <= 120.0; crease += run.pick(2.5, 15.0)) {
            line.add(crease,
                     find_errors(*mesh, ShadedNormals(mesh, crease), drum_normal).shaded_deg);
        }
        chart.lines.push_back(std::move(line));
    }
    return chart;
}

Sheet list_costs(Run& run) {
    Sheet sheet{
        "shading-cost",
        "What a shaded normal costs",
        "One normal at the middle of a triangle, all triangles one after the other; least median "
        "of the passes.",
        "It is little beside a proxy's step, and meshes that do not ask for it have none of it.",
        {"triangles", "median µs", "99 % µs", "bytes a triangle"}};
    for (const int n : run.pick<std::vector<int>>({24, 192}, {24})) {
        const auto mesh = touchable(make_torus(kRing_m, kTube_m, 2 * n, n));
        const ShadedNormals shaded(mesh, 60.0);
        std::int32_t t = 0;
        const Cost cost = measure_cost([&] {
            const Vector3& p = mesh->vertex_B(mesh->corners(t)[0]);
            keep(shaded.normal_B(t, p, p).x());
            t = (t + 1) % mesh->n_triangles();
        });
        const double bytes = static_cast<double>(shaded.memory_bytes()) / mesh->n_triangles();
        sheet.add({mesh->n_triangles(), std::to_string(cost.median_us), std::to_string(cost.p99_us),
                   std::to_string(bytes)});
    }
    return sheet;
}

Report run_shading(Run& run) {
    return {draw_smooth(run), draw_creases(run), list_costs(run)};
}

const Registration kShading{
    {"shading", "normals' error over mesh resolution and crease angle", run_shading}};

}  // namespace
}  // namespace fulcrum::bench
