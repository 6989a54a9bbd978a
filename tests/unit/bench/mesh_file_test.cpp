#include "tests/bench/curves/mesh_file.h"

#include "haptics/geometry/mesh_report.h"
#include "tests/support/scratch_folder.h"

#include <catch2/catch.hpp>

#include <cmath>
#include <string>

namespace fulcrum::bench {
namespace {

// A cube of 2 m about the origin, in faces of four corners seen counter-clockwise from outside.
const std::string kCorners =
    "v -1 -1 -1\nv 1 -1 -1\nv 1 1 -1\nv -1 1 -1\n"
    "v -1 -1 1\nv 1 -1 1\nv 1 1 1\nv -1 1 1\n";
const std::string kFaces = "f 5 6 7 8\nf 2 1 4 3\nf 6 2 3 7\nf 1 5 8 4\nf 8 7 3 4\nf 1 2 6 5\n";

MeshReport report_of(const std::string& text) {
    const auto mesh = read_obj(text, "cube.obj");
    INFO((mesh ? std::string() : to_sentence(mesh.error())));
    REQUIRE(mesh);
    return compute_mesh_report(*mesh);
}

void check_cube(const MeshReport& report) {
    CHECK(report.n_triangles == 12);
    CHECK(report.n_vertices == 8);
    CHECK(report.is_sound());
    CHECK(std::abs(report.volume_m3 - 8.0) <= 1.0e-12);
    CHECK((report.size_m - Vector3(2.0, 2.0, 2.0)).norm() == 0.0);
}

TEST_CASE("mesh file: faces of four corners become a closed cube that is seen from outside") {
    check_cube(report_of(kCorners + kFaces));
}

TEST_CASE("mesh file: textures' and normals' numbers, groups, comments, line ends are skipped") {
    std::string text = "# made by hand\r\nmtllib a.mtl\no cube\nvt 0.5 0.5\nvn 0 0 1\n" + kCorners +
                       "g all\nusemtl red\ns off\n\n";
    text +=
        "f 5/1 6/1 7/1 8/1\nf 2//1 1//1 4//1 3//1\nf 6/1/1 2/1/1 3/1/1 7/1/1\r\n"
        "f 1 5 8 4\nf 8 7 3 4\nf 1 2 6 5\n";
    check_cube(report_of(text));
}

TEST_CASE("mesh file: numbers below zero count back from the last vertex so far") {
    std::string text =
        "v -1 -1 -1\nv 1 -1 -1\nv 1 1 -1\nv -1 1 -1\nf -3 -4 -1 -2\n"
        "v -1 -1 1\nv 1 -1 1\nv 1 1 1\nv -1 1 1\nf -4 -3 -2 -1\n"
        "f 6 2 3 7\nf 1 5 8 4\nf 8 7 3 4\nf 1 2 6 5\n";
    check_cube(report_of(text));
}

TEST_CASE("mesh file: a face of five corners is cut from its first one, all of its area kept") {
    const auto mesh =
        read_obj("v 0 0 0\nv 2 0 0\nv 2 1 0\nv 1 2 0\nv 0 1 0\nf 1 2 3 4 5\n", "house.obj");
    REQUIRE(mesh);
    double area_m2 = 0.0;
    for (const TriangleCorners& t : mesh->triangles()) {
        const auto at = [&](std::size_t i) {
            return mesh->vertices_B()[static_cast<std::size_t>(t[i])];
        };
        const Vector3 doubled = (at(1) - at(0)).cross(at(2) - at(0));
        CHECK(doubled.z() > 0.0);
        area_m2 += 0.5 * doubled.norm();
    }
    CHECK(mesh->triangles().size() == 3);
    CHECK(std::abs(area_m2 - 3.0) <= 1.0e-14);
}

TEST_CASE("mesh file: what is wrong is said with the file and the line") {
    const auto refuse = [](const std::string& text) {
        const auto mesh = read_obj(text, "bad.obj");
        REQUIRE_FALSE(mesh);
        return mesh.error().where;
    };
    CHECK(refuse("v 0 0 0\nv 1 0\n") == "bad.obj:2");
    CHECK(refuse("v 0 0 zero\n") == "bad.obj:1");
    CHECK(refuse(kCorners + "f 1 2\n") == "bad.obj:9");
    CHECK(refuse(kCorners + "f 1 2 9\n") == "bad.obj:9");
    CHECK(refuse(kCorners + "f 1 2 -9\n") == "bad.obj:9");
    CHECK(refuse(kCorners + "f 0 1 2\n") == "bad.obj:9");
    CHECK(refuse(kCorners + "f 1 2 /3\n") == "bad.obj:9");
    CHECK(refuse(kCorners + "f 1 2 three\n") == "bad.obj:9");
    CHECK(refuse("v 0 0 0\n").find("bad.obj") == 0);
    CHECK(refuse("").find("bad.obj") == 0);
}

TEST_CASE("mesh file: a file is read whole; one that is not there or of another kind is refused") {
    const ScratchFolder folder;
    folder.write("cube.obj", kCorners + kFaces);
    const auto mesh = load_mesh_file(folder.file("cube.obj"));
    REQUIRE(mesh);
    check_cube(compute_mesh_report(*mesh));
    CHECK(load_mesh_file(folder.file("none.obj")).error().where.find("none.obj") !=
          std::string::npos);
    CHECK(load_mesh_file("cube.stl").error().where == "cube.stl");
}

}  // namespace
}  // namespace fulcrum::bench
