#include "haptics/voxel/distance_band.h"

#include "tests/support/wander.h"

#include <catch2/catch.hpp>

using namespace fulcrum;

namespace {

constexpr float kBand = 3.0F;
constexpr double kSingle = 2.0e-5;  // voxels: single precision in a brick

// By every version, which agree to the bit.
BrickDistances lower_all(const TriangleAt& t) {
    BrickDistances lowered;
    lowered.fill(kBand * kBand);
    lower_squares(prepare_for_band(t), kBand, lowered);
    for (const LowerSquares lower : all_lower_squares()) {
        if (lower != nullptr) {
            BrickDistances squares;
            squares.fill(kBand * kBand);
            lower(prepare_for_band(t), kBand, squares);
            REQUIRE(squares == lowered);
        }
    }
    return lowered;
}

// The largest error among corners within the band; corners beyond it must not be below their distance.
double find_worst(const TriangleAt& t) {
    const BrickDistances squares = lower_all(t);
    double worst = 0.0;
    for (int z = 0; z < kBrickSide; ++z) {
        for (int y = 0; y < kBrickSide; ++y) {
            for (int x = 0; x < kBrickSide; ++x) {
                const double exact = std::sqrt(compute_square_distance(Vector3(x, y, z), t));
                const double found =
                    std::sqrt(static_cast<double>(squares[brick_corner_at(x, y, z)]));
                if (exact <= static_cast<double>(kBand)) {
                    worst = std::max(worst, std::abs(found - exact));
                } else {
                    worst = std::max(worst, static_cast<double>(kBand) - found);
                }
            }
        }
    }
    return worst;
}

}  // namespace

TEST_CASE("distance band: small, large and far triangles are as near as they are exactly") {
    Random random(11);
    for (int i = 0; i < 2000; ++i) {
        const double size = std::pow(10.0, 1.5 + 1.5 * random.uniform());
        const Vector3 middle = Vector3::Constant(4.0) + 7.0 * random.in_cube();
        const TriangleAt t{middle + size * random.in_cube(), middle + size * random.in_cube(),
                           middle + size * random.in_cube()};
        CHECK(find_worst(t) < kSingle * std::max(1.0, size / 50.0));
    }
}

TEST_CASE("distance band: slivers and triangles without area are their longest edges") {
    Random random(12);
    for (int i = 0; i < 300; ++i) {
        const Vector3 a = Vector3::Constant(4.0) + 3.0 * random.in_cube();
        const Vector3 along = 4.0 * random.in_cube();
        const double height =
            i % 3 == 0 ? 0.0 : std::pow(10.0, -3.0 - 4.0 * std::abs(random.uniform()));
        const TriangleAt t{a, a + along, a + 0.4 * along + height * random.direction()};
        CHECK(find_worst(t) < kSingle);
    }
}

TEST_CASE("distance band: a triangle beyond the band changes nothing") {
    const TriangleAt t{{20.0, 20.0, 20.0}, {21.0, 20.0, 20.0}, {20.0, 21.0, 20.0}};
    const BrickDistances squares = lower_all(t);
    CHECK(std::all_of(squares.begin(), squares.end(),
                      [](float square) { return square == kBand * kBand; }));
}
