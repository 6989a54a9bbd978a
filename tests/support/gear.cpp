#include "tests/support/gear.h"

#include <cmath>

namespace fulcrum {
namespace {

constexpr double kTurn = 6.283185307179586;

using Contour = std::vector<Vector2>;

Contour make_circle(double radius, int n) {
    Contour contour;
    for (int i = 0; i < n; ++i) {
        contour.emplace_back(radius * std::cos(kTurn * i / n), radius * std::sin(kTurn * i / n));
    }
    return contour;
}

// Two contours of as many corners, counter-clockwise, the inner one looked into: corner i is outer low, outer high, inner low,
// inner high.
Expected<TriangleMesh> draw_out(const Contour& outer, const Contour& inner, double width_m) {
    std::vector<Vector3> corners;
    std::vector<TriangleCorners> triangles;
    const auto n = static_cast<std::int32_t>(outer.size());
    const auto quad = [&triangles](std::int32_t a, std::int32_t b, std::int32_t c, std::int32_t d) {
        triangles.push_back({a, b, c});
        triangles.push_back({a, c, d});
    };
    for (std::int32_t i = 0; i < n; ++i) {
        for (const Contour* contour : {&outer, &inner}) {
            const Vector2& p = (*contour)[static_cast<std::size_t>(i)];
            corners.emplace_back(p.x(), p.y(), -0.5 * width_m);
            corners.emplace_back(p.x(), p.y(), 0.5 * width_m);
        }
        const std::int32_t here = 4 * i;
        const std::int32_t next = 4 * ((i + 1) % n);
        quad(here, next, next + 1, here + 1);          // outside
        quad(here + 2, here + 3, next + 3, next + 2);  // inside
        quad(here + 1, next + 1, next + 3, here + 3);  // top
        quad(here, here + 2, next + 2, next);          // bottom
    }
    return TriangleMesh::build(std::move(corners), std::move(triangles));
}

}  // namespace

Expected<TriangleMesh> make_gear(const GearSettings& settings) {
    // Four corners a tooth: the gap's end, the tip's two, the gap's beginning.
    Contour outer;
    Contour inner;
    for (int tooth = 0; tooth < settings.n_teeth; ++tooth) {
        const double first = kTurn * tooth / settings.n_teeth;
        const double pitch = kTurn / settings.n_teeth;
        for (const auto& [share, radius] :
             {std::pair{0.0, settings.root_m}, std::pair{0.15, settings.tip_m},
              std::pair{0.40, settings.tip_m}, std::pair{0.55, settings.root_m}}) {
            const double angle = first + share * pitch;
            const Vector2 direction(std::cos(angle), std::sin(angle));
            outer.emplace_back(radius * direction);
            inner.emplace_back(settings.bore_m * direction);
        }
    }
    return draw_out(outer, inner, settings.width_m);
}

Expected<TriangleMesh> make_bush(double outer_m, double inner_m, double width_m, int n_sides) {
    return draw_out(make_circle(outer_m, n_sides), make_circle(inner_m, n_sides), width_m);
}

Expected<TriangleMesh> make_peg(double radius_m, double length_m, int n_sides) {
    std::vector<Vector3> corners{{0.0, 0.0, -0.5 * length_m}, {0.0, 0.0, 0.5 * length_m}};
    std::vector<TriangleCorners> triangles;
    const Contour circle = make_circle(radius_m, n_sides);
    for (std::int32_t i = 0; i < n_sides; ++i) {
        const Vector2& p = circle[static_cast<std::size_t>(i)];
        corners.emplace_back(p.x(), p.y(), -0.5 * length_m);
        corners.emplace_back(p.x(), p.y(), 0.5 * length_m);
        const std::int32_t here = 2 + 2 * i;
        const std::int32_t next = 2 + 2 * ((i + 1) % n_sides);
        triangles.push_back({here, next, next + 1});
        triangles.push_back({here, next + 1, here + 1});
        triangles.push_back({0, next, here});
        triangles.push_back({1, here + 1, next + 1});
    }
    return TriangleMesh::build(std::move(corners), std::move(triangles));
}

}  // namespace fulcrum
