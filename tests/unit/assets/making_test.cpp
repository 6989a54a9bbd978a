// The parts that models are made from.
#include "assets/make/glb_writer.h"
#include "assets/make/mesh.h"
#include "assets/make/noise.h"
#include "assets/make/parts.h"
#include "runtime/scene/gltf/gltf_model.h"

#include <catch2/catch.hpp>

#include <cmath>

using namespace fulcrum;
using namespace fulcrum::assets;

TEST_CASE("mesh: a tessellated sphere has a sphere's volume, centre and normals") {
    const MeshPart ball = outward(tessellate(ellipsoid(Vector3::Ones()), 96, 64));
    const Bulk bulk = bulk_of(ball);
    CHECK(bulk.volume_m3 == Approx(4.0 / 3.0 * M_PI).epsilon(0.005));  // chords lie inside
    CHECK(bulk.centroid.norm() < 1e-12);
    for (std::size_t i = 0; i < ball.positions.size(); ++i) {
        REQUIRE(ball.normals[i].dot(ball.positions[i]) > 0.999);
    }
}

TEST_CASE("mesh: the seam and the poles of a sheet are smooth") {
    const MeshPart ball = tessellate(ellipsoid({1.0, 2.0, 3.0}), 24, 16);
    const std::size_t row = 25;
    for (std::size_t r = 0; r <= 16; ++r) {
        CHECK((ball.positions[r * row] - ball.positions[r * row + 24]).norm() < 1e-12);
        CHECK((ball.normals[r * row] - ball.normals[r * row + 24]).norm() < 1e-12);
    }
    for (std::size_t c = 1; c < row; ++c) {
        CHECK((ball.normals[c] - ball.normals[0]).norm() < 1e-12);
    }
}

TEST_CASE("mesh: moving a part moves its bulk; turning it inside out turns the volume's sign") {
    MeshPart ball = outward(tessellate(ellipsoid(Vector3::Ones()), 32, 24));
    const double volume_m3 = bulk_of(ball).volume_m3;
    ball.transform(Affine::at({1.0, 2.0, 3.0}));
    CHECK((bulk_of(ball).centroid - Vector3(1.0, 2.0, 3.0)).norm() < 1e-9);
    CHECK(bulk_of(ball).volume_m3 == Approx(volume_m3));
    ball.turn_inside_out();
    CHECK(bulk_of(ball).volume_m3 == Approx(-volume_m3));
    CHECK(ball.normals.front().y() < 0.0);
}

TEST_CASE("mesh: a curve goes through its points and is straight between points on a line") {
    const std::vector<Vector2> points{{0, 0}, {1, 1}, {2, 2}, {3, 3}};
    CHECK(curve_through(points, 0.0) == points[0]);
    CHECK((curve_through(points, 1.0 / 3.0) - points[1]).norm() < 1e-12);
    CHECK(curve_through(points, 1.0) == points[3]);
    const Vector2 middle = curve_through(points, 0.5);
    CHECK(middle.x() == Approx(1.5));
    CHECK(middle.y() == Approx(1.5));
}

TEST_CASE("mesh: a straight tube has a cylinder's radius everywhere") {
    const Surface pipe =
        tube([](double t) { return Vector3(0.0, 2.0 * t, 0.0); }, [](double) { return 0.5; });
    for (double u = 0.0; u <= 1.0; u += 0.125) {
        for (double v = 0.0; v <= 1.0; v += 0.25) {
            const Vector3 p = pipe(u, v);
            CHECK(std::hypot(p.x(), p.z()) == Approx(0.5));
            CHECK(p.y() == Approx(2.0 * v).margin(1e-12));
        }
    }
}

TEST_CASE("noise: is zero at lattice points, bounded, smooth, and always the same") {
    double highest = 0.0;
    for (int i = 0; i < 5000; ++i) {
        const Vector3 p(0.137 * i, 1.0 - 0.071 * i, 0.53 * i);
        highest = std::max(highest, std::abs(noise(p)));
        CHECK(std::abs(noise(p + Vector3(1e-6, 0, 0)) - noise(p)) < 1e-4);
    }
    CHECK(highest > 0.5);
    CHECK(highest <= 1.2);
    for (int i = -5; i < 5; ++i) {
        CHECK(noise(Vector3(i, 2 * i, -i)) == 0.0);
    }
    CHECK(noise({0.3, 0.4, 0.5}) == noise({0.3, 0.4, 0.5}));
}

TEST_CASE("noise: spots are where they should be, and none at no density") {
    double covered = 0.0;
    for (int i = 0; i < 4000; ++i) {
        const Vector3 p(0.0317 * i, 0.011 * i, 0.71 * i);
        const double spot = spots(p, 0.5, 0.4);
        CHECK(spot >= 0.0);
        CHECK(spot <= 1.0);
        CHECK(spots(p, 0.0, 0.4) == 0.0);
        covered += spot;
    }
    // Half the cells hold a ball of radius 0.2 to 0.4: about 0.5 * 4/3 pi 0.3^3 = 6 % of space.
    CHECK(covered / 4000.0 > 0.02);
    CHECK(covered / 4000.0 < 0.12);
}

TEST_CASE("picture: colours go to sRGB and back, and the PNG written is the picture read") {
    const Picture picture = paint(5, 3, [](double u, double v) { return Colour(u, v, 0.25); });
    REQUIRE(picture.rgb.size() == 45);
    CHECK(picture.rgb[2] == 137);  // linear 0.25 in sRGB: IEC 61966-2-1
    CHECK(srgb(0xFFFFFF) == Colour(1.0, 1.0, 1.0));
    CHECK(srgb(0x000000) == Colour(0.0, 0.0, 0.0));
    CHECK(srgb(0x808080).x() == Approx(0.2158).epsilon(0.001));

    Model model{"tile",
                {tessellate([](double u, double v) { return Vector3(u, v, 0.0); }, 1, 1)},
                {picture}};
    model.parts[0].picture = 0;
    const auto bytes = encode_glb(model);
    const auto loaded = runtime::read_gltf(std::as_bytes(std::span(bytes)), "tile.glb");
    REQUIRE(loaded.has_value());
    const auto& image = loaded->images.at(0);
    REQUIRE(image.width == 5);
    REQUIRE(image.height == 3);
    for (std::size_t i = 0; i < 15; ++i) {
        for (std::size_t k = 0; k < 3; ++k) {
            CHECK(image.rgba[4 * i + k] == picture.rgb[3 * i + k]);
        }
    }
}

TEST_CASE("picture: blending stays between its colours") {
    const Colour a(0.0, 0.5, 1.0);
    const Colour b(1.0, 0.5, 0.0);
    CHECK(blend(a, b, 0.0) == a);
    CHECK(blend(a, b, 1.0) == b);
    CHECK(blend(a, b, 7.0) == b);
    CHECK(blend(a, b, -7.0) == a);
    CHECK(blend(a, b, 0.25).x() == Approx(0.25));
}

TEST_CASE("glb: a part's colour, roughness and triangles are what the loader gives back") {
    Model model{
        "tile", {tessellate([](double u, double v) { return Vector3(u, v, 0.5); }, 2, 3)}, {}};
    model.parts[0].colour = Colour(0.125, 0.5, 0.75);
    model.parts[0].alpha = 0.5;
    model.parts[0].roughness = 0.25;
    const auto bytes = encode_glb(model);
    const auto loaded = runtime::read_gltf(std::as_bytes(std::span(bytes)), "tile.glb");
    REQUIRE(loaded.has_value());
    const auto& p = loaded->primitives.at(0);
    CHECK(p.base_colour == std::array<float, 4>{0.125F, 0.5F, 0.75F, 0.5F});
    CHECK(p.roughness == 0.25F);
    CHECK(p.indices == model.parts[0].indices);
    CHECK(p.positions.size() == 3 * model.parts[0].positions.size());
    CHECK(p.uvs[2] == 0.5F);
}
