#include "haptics/collision/contact_axis.h"

#include "haptics/collision/collision_mesh.h"
#include "haptics/collision/solid_shape.h"
#include "haptics/geometry/height_field.h"
#include "haptics/geometry/shape.h"
#include "tests/support/contact_shapes.h"
#include "tests/support/touchable.h"

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

namespace fulcrum {
namespace {

constexpr double kFar_m = std::numeric_limits<double>::infinity();

// The greatest gap over all directions, but for what a face may be preferred by; the search by directions falls a little short.
void check_is_greatest(const PlacedShape& a, const PlacedShape& b, double size_m) {
    const ContactAxis axis = find_contact_axis(a, b, kFar_m, 0);
    REQUIRE(axis.normal_W.norm() == Approx(1.0).margin(1.0e-12));
    REQUIRE(find_gap_along(a, b, axis.normal_W) == Approx(axis.gap_m).margin(1.0e-9 * size_m));
    const double searched_m = search_gap_m(a, b);
    // Two boxes that are apart by their corners are told less.
    const bool are_boxes =
        a.shape->kind == ContactShape::Kind::box && b.shape->kind == a.shape->kind;
    REQUIRE((are_boxes && searched_m > 0.0 ? axis.gap_m > 0.0
                                           : axis.gap_m >= searched_m - 2.0 * kPrefer * size_m));
}

TEST_CASE("contact axis: least translation and shortest way of every pair, at any size") {
    for (const double size_m : {1.0e-3, 1.0, 1.0e3}) {
        const auto shapes = make_contact_shapes(size_m);
        Random random(5);
        for (const ContactShape& first : shapes) {
            for (const ContactShape& second : shapes) {
                for (int i = 0; i < 8; ++i) {
                    const Vector3 apart = size_m * (0.3 + 0.1 * i) * random.direction();
                    check_is_greatest({&first, random.turn(3.0).toRotationMatrix(), apart},
                                      {&second, random.turn(3.0).toRotationMatrix()}, size_m);
                }
            }
        }
    }
}

TEST_CASE("contact axis: the pair turned over tells the same with the normal turned over") {
    const auto shapes = make_contact_shapes(1.0);
    Random random(6);
    for (const ContactShape& first : shapes) {
        for (const ContactShape& second : shapes) {
            for (int i = 0; i < 30; ++i) {
                const PlacedShape a{&first, random.turn(3.0).toRotationMatrix(),
                                    0.8 * random.direction()};
                const PlacedShape b{&second, random.turn(3.0).toRotationMatrix()};
                const ContactAxis one = find_contact_axis(a, b, kFar_m, 0);
                const ContactAxis other = find_contact_axis(b, a, kFar_m, 0);
                REQUIRE(one.gap_m == Approx(other.gap_m).margin(2.0 * kPrefer));
                if (std::abs(one.gap_m - other.gap_m) < 1.0e-9) {
                    REQUIRE(one.normal_W.dot(other.normal_W) < -0.999);
                }
            }
        }
    }
}

TEST_CASE("contact axis: two boxes face to face, edge to edge and one in the other") {
    const auto box = make_contact_shape(BoxShape{{0.5, 0.5, 0.5}}).value();
    const PlacedShape lower{&box};
    const ContactAxis faces =
        find_contact_axis({.shape = &box, .place = {0.1, 0.9, 0.2}}, lower, 0.1, 0);
    CHECK(faces.gap_m == Approx(-0.1));
    CHECK(faces.normal_W == Vector3::UnitY());
    // Edges crosswise: each body a quarter of a right angle round its own axis, tops along x and z.
    const Matrix3 about_x = AngleAxis(0.25 * M_PI, Vector3::UnitX()).toRotationMatrix();
    const Matrix3 about_z = AngleAxis(0.25 * M_PI, Vector3::UnitZ()).toRotationMatrix();
    const double reach_m = std::sqrt(0.5);
    const ContactAxis edges = find_contact_axis({&box, about_x, {0.05, 2.0 * reach_m - 0.03, 0.02}},
                                                {&box, about_z}, 0.1, 0);
    CHECK(edges.gap_m == Approx(-0.03));
    CHECK(edges.normal_W.y() == Approx(1.0));
    CHECK(edges.which >= 1000);
    const ContactAxis same = find_contact_axis(lower, lower, 0.1, 0);
    CHECK(same.gap_m == -1.0);
    CHECK(same.normal_W.norm() == 1.0);
}

TEST_CASE("contact axis: round shapes in closed form, their middles in one place too") {
    const auto capsule = make_contact_shape(CapsuleShape{0.1, 1.0}).value();
    const Matrix3 lying = AngleAxis(0.5 * M_PI, Vector3::UnitX()).toRotationMatrix();
    const Matrix3 across = AngleAxis(0.5 * M_PI, Vector3::UnitZ()).toRotationMatrix();
    const ContactAxis crossed = find_contact_axis({&capsule, lying}, {&capsule, across}, 1.0, 0);
    CHECK(crossed.gap_m == Approx(-0.2));
    CHECK(std::abs(crossed.normal_W.y()) == Approx(1.0));
    const ContactAxis parallel = find_contact_axis(
        {.shape = &capsule, .turn_WB = lying, .place = {0.0, 0.0, 0.3}}, {&capsule, lying}, 1.0, 0);
    CHECK(parallel.gap_m == Approx(-0.2));
    CHECK(parallel.normal_W.z() == Approx(0.0).margin(1.0e-12));
    const ContactAxis apart = find_contact_axis(
        {.shape = &capsule, .turn_WB = lying, .place = {0.3, 0.4, 0.0}}, {&capsule, lying}, 1.0, 0);
    CHECK(apart.gap_m == Approx(0.3));
    const auto sphere = make_contact_shape(SphereShape{0.2}).value();
    const ContactAxis inside = find_contact_axis({&sphere}, {&sphere}, 1.0, 0);
    CHECK(inside.gap_m == Approx(-0.4));
    CHECK(inside.normal_W.norm() == Approx(1.0));
}

TEST_CASE("contact axis: a half space tells the height of what is lowest, from either side") {
    const ContactShape ground = make_half_space();
    for (const ContactShape& shape : make_contact_shapes(1.0)) {
        Random random(8);
        for (int i = 0; i < 50; ++i) {
            const Vector3 up = random.direction();
            const Matrix3 turn =
                Quaternion::FromTwoVectors(Vector3::UnitY(), up).toRotationMatrix();
            const PlacedShape floor{&ground, turn, 0.1 * random.in_cube()};
            const PlacedShape body{&shape, random.turn(3.0).toRotationMatrix(), random.in_cube()};
            const ContactAxis axis = find_contact_axis(body, floor, kFar_m, 0);
            const double lowest_m = up.dot(body.find_support(-up) - floor.place);
            CHECK(axis.gap_m == Approx(lowest_m - shape.core.radius_m).margin(1.0e-12));
            CHECK(axis.normal_W.dot(up) == Approx(1.0));
            CHECK(find_contact_axis(floor, body, kFar_m, 0).normal_W == -axis.normal_W);
        }
    }
    CHECK(find_contact_axis({&ground}, {&ground}, 1.0, 0).gap_m == kFar_m);
}

TEST_CASE("contact axis: the last direction stays until bettered; what is apart is told at once") {
    const auto box = make_contact_shape(BoxShape{{0.5, 0.5, 0.5}}).value();
    // As deep along x as along y, but for what is added along x.
    const auto find = [&](double deeper_m, std::int32_t last) {
        return find_contact_axis({.shape = &box, .place = {0.9 - deeper_m, 0.9, 0.0}}, {&box}, 0.1,
                                 last);
    };
    const double margin_m = kPrefer * box.bounding_radius_m;
    const std::int32_t along_x = find(-2.0 * margin_m, 0).which;
    const std::int32_t along_y = find(2.0 * margin_m, 0).which;
    REQUIRE(along_x != along_y);
    for (const double noise_m : {-0.5 * margin_m, 0.5 * margin_m}) {
        CHECK(find(noise_m, along_x).which == along_x);
        CHECK(find(noise_m, along_y).which == along_y);
    }
    CHECK(find(2.0 * margin_m, along_x).which == along_y);
    const auto shapes = make_contact_shapes(1.0);
    for (const ContactShape& first : shapes) {
        const PlacedShape a{.shape = &first, .place = {0.0, 3.0, 0.0}};
        const PlacedShape b{&shapes[2]};
        const ContactAxis axis = find_contact_axis(a, b, 0.01, 0);
        CHECK(axis.gap_m > 0.01);
        CHECK(find_contact_axis(a, b, 0.01, axis.which).gap_m > 0.01);
    }
}

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

TEST_CASE("contact shape: features are flat, run round their normals and keep the corners") {
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

TEST_CASE("contact shape: a mesh has the hull round it; a face is found again by its number") {
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

TEST_CASE("solid shape: sizes that are not finite and above zero, and no mesh, are refused") {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    const MeshShape mesh = touchable(make_box(Vector3::Ones()));
    for (const SolidShape& sound :
         {SolidShape(SphereShape{0.1}), SolidShape(BoxShape{{0.1, 0.2, 0.3}}),
          SolidShape(CapsuleShape{0.1, 0.0}), SolidShape(CylinderShape{0.1, 0.1}),
          SolidShape(mesh)}) {
        CAPTURE(sound.index());
        CHECK(validate(sound));
    }
    int row = 0;
    for (const SolidShape& bad :
         {SolidShape(SphereShape{0.0}), SolidShape(SphereShape{nan}),
          SolidShape(BoxShape{{0.0, 0.2, 0.3}}), SolidShape(BoxShape{{0.1, 0.0, 0.3}}),
          SolidShape(BoxShape{{0.1, 0.2, 0.0}}), SolidShape(CapsuleShape{0.1, -0.1}),
          SolidShape(CapsuleShape{-0.1, 0.1}), SolidShape(CylinderShape{0.1, 0.0}),
          SolidShape(CylinderShape{1.0e13, 0.1}), SolidShape(MeshShape{})}) {
        CAPTURE(row++);
        CHECK_FALSE(validate(bad));
    }
    CHECK(memory_bytes(mesh) == sizeof(SolidShape) + mesh->memory_bytes());
    CHECK(memory_bytes(SphereShape{}) == sizeof(SolidShape));
}

TEST_CASE("collision mesh: keeps the source's numbers of its triangles and tells its size") {
    const auto source = make_bumpy_sphere(1.0, 9, 0.05, 9.0);
    const auto mesh = touchable(source);
    REQUIRE(mesh->n_triangles() == static_cast<std::int32_t>(source->triangles().size()));
    for (std::int32_t i = 0; i < mesh->n_triangles(); ++i) {
        for (std::size_t corner = 0; corner < 3; ++corner) {
            const auto of_source =
                source->triangles()[static_cast<std::size_t>(mesh->source_triangle(i))][corner];
            REQUIRE(mesh->vertex_B(mesh->corners(i)[corner]) ==
                    source->vertices_B()[static_cast<std::size_t>(of_source)]);
        }
    }
    CHECK(mesh->radius_m() >= 1.0);
    CHECK(mesh->radius_m() <= 1.1);
    CHECK(mesh->memory_bytes() > 1620 * 30);
    CHECK(mesh->memory_bytes() < 1620 * 50);
}

TEST_CASE("collision mesh: a mesh that was given away is refused") {
    auto mesh = make_box(Vector3::Ones());
    REQUIRE(CollisionMesh::create(std::move(*mesh)));
    const TriangleMesh taken = std::move(*mesh);
    CHECK_FALSE(CollisionMesh::create(std::move(*mesh)));
}

}  // namespace
}  // namespace fulcrum
