#include "haptics/collision/convex_mesh_obstacle.h"

#include "haptics/geometry/shape.h"
#include "tests/support/touchable.h"
#include "tests/support/wander.h"

#include <catch2/catch.hpp>

#include <algorithm>
#include <memory>
#include <vector>

namespace fulcrum {
namespace {

constexpr double kLevel_m = 1.0e-10;

// Every triangle of a mesh as a mesh of its own.
std::vector<std::shared_ptr<const CollisionMesh>> take_apart(const CollisionMesh& mesh) {
    std::vector<std::shared_ptr<const CollisionMesh>> alone;
    for (std::int32_t i = 0; i < mesh.n_triangles(); ++i) {
        const auto [a, b, c] = mesh.places_B(i);
        alone.push_back(touchable(TriangleMesh::build({a, b, c}, {{0, 1, 2}})));
    }
    return alone;
}

TEST_CASE("convex mesh obstacle: met is what is met of its triangles, each asked alone") {
    const auto mesh = touchable(make_bumpy_sphere(1.0, 6, 0.1, 8.0));
    const std::vector<SolidShape> cursors{BoxShape{{0.25, 0.03, 0.08}}, CapsuleShape{0.05, 0.2},
                                          CylinderShape{0.2, 0.1}};
    Random random(9);
    Wanderer wanderer(6);
    for (const SolidShape& shape : cursors) {
        const ConvexBody cursor = make_convex_cursor(shape);
        ConvexMeshObstacle whole(mesh, cursor);
        std::vector<std::unique_ptr<ConvexMeshObstacle>> alone;
        for (const auto& triangle : take_apart(*mesh)) {
            alone.push_back(std::make_unique<ConvexMeshObstacle>(triangle, cursor));
        }
        const auto turn_all = [&](const Matrix3& turn_CB, bool keep) {
            whole.turn(turn_CB);
            if (keep) {
                whole.keep_turn();
            }
            for (const auto& triangle : alone) {
                triangle->turn(turn_CB);
                if (keep) {
                    triangle->keep_turn();
                }
            }
        };
        int n_hits = 0;
        int n_met_by_turn = 0;
        int n_by_neighbours = 0;
        for (int i = 0; i < 120; ++i) {
            const Matrix3 before_CB = random.turn(3.0).toRotationMatrix();
            turn_all(before_CB, true);
            const CastQuestion way{.from_B = 1.6 * wanderer.next(),
                                   .to_B = wanderer.next() * (1.2 + 0.2 * random.uniform()),
                                   .level_m = kLevel_m,
                                   .reach_m = 0.004};
            double least_t = 2.0;
            for (const auto& triangle : alone) {
                least_t = std::min(least_t, triangle->cast(way).t);
            }
            const CastHit hit = whole.cast(way);
            INFO("cursor " << shape.index() << ", way " << i);
            REQUIRE(hit.t == Approx(least_t).margin(1.0e-9));
            n_hits += hit.found() ? 1 : 0;
            // Where it stopped it turns, and is moved.
            const Vector3 place_B = way.from_B + std::min(hit.t, 1.0) * (way.to_B - way.from_B);
            turn_all(random.turn(0.2).toRotationMatrix() * before_CB, false);
            const CastQuestion turned{
                .from_B = place_B, .to_B = place_B + 0.03 * random.in_cube(), .level_m = kLevel_m};
            const CastHit met = whole.cast(turned);
            if (met.found()) {
                ++n_met_by_turn;
                const auto which = static_cast<std::size_t>(met.feature);
                REQUIRE(alone[which]->cast(turned).found());
                continue;
            }
            // A plane that was found for its neighbours may keep one off for which alone none is found.
            n_by_neighbours += std::ranges::any_of(
                alone, [&](const auto& triangle) { return triangle->cast(turned).found(); });
            whole.keep_turn();
            REQUIRE(whole.find_nearest(turned.to_B, 0.4 * kLevel_m) == -1);
        }
        CHECK(n_by_neighbours < 5);
        CHECK(n_hits > 30);
        CHECK(n_met_by_turn > 10);
        CHECK(n_met_by_turn < 110);
    }
}

}  // namespace
}  // namespace fulcrum
