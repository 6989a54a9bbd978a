#include "haptics/voxel/slope_boxes.h"

#include "tests/support/edited_meshes.h"
#include "tests/support/field_parts.h"
#include "tests/support/wander.h"

#include <catch2/catch.hpp>

#include <algorithm>
#include <array>
#include <cmath>

using namespace fulcrum;

namespace {

std::array<float, 3> to_floats(const Vector3& v) {
    return {static_cast<float>(v.x()), static_cast<float>(v.y()), static_cast<float>(v.z())};
}

}  // namespace

TEST_CASE("slope boxes: no way within the box falls faster than they say") {
    for (const TriangleMesh& mesh :
         {make_bumpy_sphere(1.0, 16, 0.1, 9.0).value(), make_box({1.0, 0.7, 0.3}).value()}) {
        const DistanceField field = test::build_field(mesh, 64);
        const SlopeBoxes boxes(field);
        const double voxel_m = field.frame().voxel_m;
        Random random(2);
        int n_told = 0;
        for (int i = 0; i < 200000; ++i) {
            const Vector3 p_O = 1.3 * random.in_cube();
            const Vector3 way = 2.0 * random.uniform() * random.direction();
            const double before = field.sample(p_O).value_m / voxel_m;
            const double after = field.sample(p_O + voxel_m * way).value_m / voxel_m;
            if (!(before > 0.0) || before > 2.5) {
                continue;
            }
            const SlopeBox box = boxes.find(to_floats(field.frame().to_lattice(p_O)), 2.0F);
            const double most = static_cast<double>(boxes.most_voxels());
            const double least =
                std::min(before, most) + static_cast<double>(box.find_fall(to_floats(way)));
            CHECK((least <= 0.0 || after >= least - 1.0e-4));
            n_told += least > std::min(before, most) - 0.5 * way.norm() ? 1 : 0;
        }
        // Of many ways they know that it falls by less than half as much as it may, though these bricks are coarse.
        CHECK(n_told > 500);
    }
}

TEST_CASE("slope boxes: over a hole no way is known not to fall, beside it all is as ever") {
    const TriangleMesh box = make_box({1.0, 1.0, 1.0}).value();
    const TriangleCorners hole = box.triangles().back();
    const DistanceField field = test::build_field(test::take_first(box, -1), 64);
    const SlopeBoxes boxes(field);
    const auto corner = [&](std::size_t i) {
        return box.vertices_B()[static_cast<std::size_t>(hole[i])];
    };
    // On the edge of the hole the membrane begins.
    const Vector3 edge_O = 0.5 * (corner(0) + corner(1));
    const SlopeBox over = boxes.find(to_floats(field.frame().to_lattice(edge_O)), 4.0F);
    for (const Vector3& way : {Vector3(0.0, 0.0, 0.0), Vector3(0.1, 0.0, 0.0), Vector3(edge_O)}) {
        CHECK(over.find_fall(to_floats(way)) < -1.0e6F);
    }
    const Vector3 other_O = -(corner(0) + corner(1) + corner(2)) / 3.0;
    const Vector3 out = other_O.cwiseAbs().maxCoeff() *
                        other_O.unaryExpr([](double x) { return std::abs(x) > 0.49 ? x : 0.0; });
    const SlopeBox beside = boxes.find(to_floats(field.frame().to_lattice(other_O)), 2.0F);
    CHECK(beside.find_fall(to_floats(out)) == 0.0F);
}

TEST_CASE("slope boxes: over a level face a way along it or out of it does not fall") {
    const DistanceField field = test::build_field(make_box({1.0, 1.0, 1.0}).value(), 64);
    const SlopeBoxes boxes(field);
    const SlopeBox box = boxes.find(
        to_floats(field.frame().to_lattice({0.1, 0.5 + 0.5 * field.frame().voxel_m, 0.1})), 4.0F);
    CHECK(box.find_fall({1.0F, 0.0F, -1.0F}) == 0.0F);
    CHECK(box.find_fall({0.0F, 1.5F, 0.0F}) == 0.0F);
    CHECK(box.find_fall({0.5F, -1.5F, 0.5F}) == Approx(-1.5).margin(1.5 / 64.0));
    // Where no brick is near there is no slope; asked outside the block too.
    CHECK(SlopeBox{}.find_fall({1.0F, -2.0F, 3.0F}) == 0.0F);
    CHECK(boxes.find({-100.0F, -100.0F, 1.0e6F}, 2.0F).find_fall({5.0F, 5.0F, 5.0F}) <= 0.0F);
    CHECK(boxes.memory_bytes() == field.table().size() * sizeof(SlopeBox));
    CHECK(boxes.most_voxels() == Approx(3.0 - std::sqrt(3.0)));
}
