// Shots that meet a closed mesh exactly in a corner or on an edge of its triangles, to the last bit: none gets in between.
#include "haptics/geometry/shape.h"
#include "haptics/point/god_object.h"
#include "tests/stability/cases/stability_case.h"
#include "tests/support/touchable.h"

#include <memory>
#include <string>

namespace fulcrum::stability {
namespace {

// From twice as far out straight to the middle, in `n_ticks`: halving is exact, so the way leads through `p` itself. True
// when the proxy is behind the surface then.
bool leaks(const std::shared_ptr<const CollisionMesh>& mesh, const Vector3& p, int n_ticks) {
    GodObject proxy(only_solid(mesh));
    proxy.reset(2.0 * p);
    for (int i = 1; i <= n_ticks; ++i) {
        proxy.step(2.0 * p * (1.0 - static_cast<double>(i) / n_ticks), {});
    }
    const Vector3& place = proxy.contact().position_W;
    return proxy.contact().solid == kNoBody ||
           find_nearest_hit(*mesh, place, place + 2.0 * p).found();
}

struct Shots {
    int n_leaks = 0;
    int count = 0;
    void shoot(const std::shared_ptr<const CollisionMesh>& mesh, const Vector3& p) {
        // One tick from outside to the middle; four of which one ends in `p` itself.
        for (const int n_ticks : {1, 4}) {
            n_leaks += leaks(mesh, p, n_ticks) ? 1 : 0;
            ++count;
        }
    }
    [[nodiscard]] Finding finding() const {
        return {static_cast<double>(n_leaks), 0.0, "of " + std::to_string(count) + " shots"};
    }
};

// Every vertex, where five or six triangles meet.
Finding shoot_at_vertices() {
    const auto ball = make_sphere(1.0, 12);
    const auto mesh = touchable(ball);
    Shots shots;
    for (const Vector3& vertex : ball->vertices_B()) {
        shots.shoot(mesh, vertex);
    }
    return shots.finding();
}

// Eighths along the edges of a cube and the diagonals of its faces: numbers that a double holds exactly.
Finding shoot_at_edges() {
    const auto cube = make_box(Vector3::Ones());
    const auto mesh = touchable(cube);
    Shots shots;
    for (const TriangleCorners& t : cube->triangles()) {
        for (std::size_t i = 0; i < 3; ++i) {
            const Vector3& a = cube->vertices_B()[static_cast<std::size_t>(t[i])];
            const Vector3& b = cube->vertices_B()[static_cast<std::size_t>(t[(i + 1) % 3])];
            for (int eighth = 0; eighth < 8; ++eighth) {
                shots.shoot(mesh, a + 0.125 * eighth * (b - a));
            }
        }
    }
    return shots.finding();
}

constexpr const char* kMeasured = "shots that got inside";

const HardCase kVertices{{"shots exactly at vertices", "at every vertex of a ball, fast and slow",
                          kMeasured, "", shoot_at_vertices}};
const HardCase kEdges{{"shots exactly at edges",
                       "at places on the edges of a cube and the diagonals of its faces", kMeasured,
                       "", shoot_at_edges}};

}  // namespace
}  // namespace fulcrum::stability
