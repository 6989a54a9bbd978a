#include "haptics/collision/contact_shape.h"

#include "haptics/geometry/height_field.h"
#include "haptics/geometry/shape.h"
#include "tests/support/contact_shapes.h"
#include "tests/support/touchable.h"

#include <catch2/catch.hpp>

#include <limits>

namespace fulcrum {
namespace {

// Counter-clockwise from outside, flat, and as far along the direction as the core goes.
void check_feature(const ContactShape& shape, const Vector3& direction) {
    constexpr double kRounding = 1.0e-9;  // a face's corners lie in its plane to 1e-7 of the size
    SupportFeature feature;
    find_feature(shape, direction, feature);
    const double farthest = direction.dot(shape.core.find_support(direction));
    double reached = -std::numeric_limits<double>::infinity();
    for (int i = 0; i < feature.count; ++i) {
        const auto at = static_cast<std::size_t>(i);
        reached = std::max(reached, direction.dot(feature.corners_B[at]));
        if (feature.count > 2) {
            const auto n = static_cast<std::size_t>(feature.count);
            const Vector3& here = feature.corners_B[at];
            const Vector3 along = feature.corners_B[(at + 1) % n] - here;
            const Vector3 next = feature.corners_B[(at + 2) % n] - here;
            REQUIRE(feature.normal_B.dot(along.cross(next)) > 0.0);
            REQUIRE(std::abs(feature.normal_B.dot(along)) <= kRounding);
        }
    }
    CAPTURE(direction);
    REQUIRE(reached <= farthest + kRounding);
    // What is farthest of a hull may be a corner of a face that looks less along the direction.
    if (shape.kind != ContactShape::Kind::hull) {
        REQUIRE(reached >= farthest - 1.0e-3 * shape.bounding_radius_m * 1.0e-3);
    }
}

TEST_CASE("contact shape: a feature is flat, runs round its normal and holds the farthest point") {
    Random random(1);
    for (const ContactShape& shape : make_contact_shapes(1.0)) {
        for (int i = 0; i < 2000; ++i) {
            check_feature(shape, random.direction());
        }
        for (int axis = 0; axis < 3; ++axis) {
            check_feature(shape, Vector3::Unit(axis));
            check_feature(shape, -Vector3::Unit(axis));
        }
    }
}

TEST_CASE("contact shape: a hull's triangles in one plane are one face, with each corner once") {
    std::vector<Vector3> corners;
    for (int i = 0; i < 8; ++i) {
        corners.emplace_back(i & 1 ? 1.0 : -1.0, i & 2 ? 0.5 : -0.5, i & 4 ? 2.0 : -2.0);
    }
    const auto box = make_contact_shape(make_hull_shape(corners).value()).value();
    REQUIRE(box.hull->faces.size() == 6);
    for (const auto& face : box.hull->faces) {
        CHECK(face.count == 4);
    }
    // A prism of 100 sides: its ends are thinned.
    const auto prism = make_cylinder(1.0, 1.0, 100).value();
    const auto round = make_contact_shape(make_hull_shape(prism.vertices_B()).value()).value();
    CHECK(round.hull->faces.size() == 102);
    SupportFeature feature;
    find_feature(round, Vector3::UnitY(), feature);
    CHECK(feature.count == kMostCorners);
}

TEST_CASE(
    "contact shape: an end that is not tilted keeps its corners, a tilted one has its lowest") {
    const auto cylinder = make_contact_shape(CylinderShape{1.0, 0.5}).value();
    SupportFeature still;
    find_feature(cylinder, Vector3(1.0e-6, -1.0, 1.0e-6).normalized(), still);
    CHECK(still.corners_B[0] == Vector3(1.0, -0.5, 0.0));
    const Vector3 down = Vector3(0.3, -1.0, 0.4).normalized();
    SupportFeature tilted;
    find_feature(cylinder, down, tilted);
    CHECK((tilted.corners_B[0] - Vector3(0.6, -0.5, 0.8)).norm() < 1.0e-12);
    find_feature(cylinder, Vector3::UnitX(), tilted);
    CHECK(tilted.count == 2);
}

TEST_CASE("contact shape: a mesh has the hull round it, and what cannot push is refused") {
    const auto mesh = make_contact_shape(touchable(make_torus(0.1, 0.03, 16, 8)));
    REQUIRE(mesh);
    CHECK(mesh->kind == ContactShape::Kind::mesh);
    CHECK(mesh->bounding_radius_m == Approx(0.13));
    // Seen from above the ring is a disc: its hull has a flat top without a hole.
    SupportFeature top;
    find_feature(*mesh, Vector3::UnitY(), top);
    CHECK(top.count == 16);
    CHECK(top.normal_B.y() == Approx(1.0));
    CHECK(find_face_normal(*mesh, top.face) == top.normal_B);
    const auto ground = make_contact_shape(*make_height_field_shape(HeightField{}));
    REQUIRE_FALSE(ground);
    CHECK(to_sentence(ground.error()).find("height field") != std::string::npos);
    CHECK_FALSE(make_contact_shape(SphereShape{-1.0}));
    CHECK_FALSE(make_contact_shape(BoxShape{{1.0, std::nan(""), 1.0}}));
}

TEST_CASE("contact shape: a face is found again by its number, and no other number has a normal") {
    for (const ContactShape& shape : make_contact_shapes(1.0)) {
        Random random(3);
        for (int i = 0; i < 100; ++i) {
            const Vector3 way = random.direction();
            const AlignedFace aligned = find_aligned_face(shape, way);
            CHECK(aligned.normal_B == find_face_normal(shape, aligned.face));
            for (std::int32_t face = 0; face < 20; ++face) {
                CHECK(find_face_normal(shape, face).dot(way) <= aligned.normal_B.dot(way) + 1e-12);
            }
        }
        CHECK(find_face_normal(shape, 999) == Vector3::Zero());
        CHECK(find_face_normal(shape, -1) == Vector3::Zero());
    }
}

}  // namespace
}  // namespace fulcrum
