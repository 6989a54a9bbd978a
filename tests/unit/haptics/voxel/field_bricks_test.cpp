#include "haptics/geometry/shape.h"
#include "haptics/voxel/ball_slack.h"
#include "haptics/voxel/brick_sides.h"
#include "haptics/voxel/brick_triangles.h"
#include "haptics/voxel/distance_band.h"
#include "haptics/voxel/distance_field.h"
#include "haptics/voxel/slope_boxes.h"
#include "haptics/voxel/winding_number.h"
#include "tests/support/edited_meshes.h"
#include "tests/support/field_parts.h"
#include "tests/support/hard_meshes.h"
#include "tests/support/wander.h"

#include <catch2/catch.hpp>

#include <algorithm>
#include <array>
#include <cmath>

using namespace fulcrum;

namespace {

constexpr float kBand = 3.0F;
constexpr double kSingle_m = 2.0e-5;  // voxels: single precision in a brick

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

constexpr double kReach_voxels = 3.0;
constexpr double kAny = 1.0e9;

constexpr double kVoxel_m = 0.05;
constexpr float kBound = 3.0F;  // voxels

BrickDistances measure(const TriangleClusters& clusters, const Vector3& corner) {
    BrickDistances distances;
    for (int z = 0; z < kBrickSide; ++z) {
        for (int y = 0; y < kBrickSide; ++y) {
            for (int x = 0; x < kBrickSide; ++x) {
                const double d = clusters.find_distance(corner + kVoxel_m * Vector3(x, y, z));
                distances[brick_corner_at(x, y, z)] =
                    std::min(static_cast<float>(d / kVoxel_m), kBound);
            }
        }
    }
    return distances;
}

// Corners whose side is not that of their own winding number, of those that are not on the surface.
int count_wrong(const TriangleMesh& mesh, int n_bricks) {
    const TriangleClusters clusters(mesh);
    const BrickSides sides(mesh, clusters, kVoxel_m);
    Random random(21);
    int n_wrong = 0;
    for (int i = 0; i < n_bricks; ++i) {
        const Vector3 corner =
            1.0 * random.direction() - Vector3::Constant(0.5 * kBrickCells * kVoxel_m);
        const BrickDistances distances = measure(clusters, corner);
        BrickDistances with_signs = distances;
        sides.put_signs(corner, with_signs);
        for (int c = 0; c < static_cast<int>(kBrickCorners); ++c) {
            const Vector3 at(c % 9, c / 9 % 9, c / 81);
            const double w = compute_winding_number(clusters, corner + kVoxel_m * at, 1.0e9);
            const auto j = static_cast<std::size_t>(c);
            CHECK(std::abs(with_signs[j]) == distances[j]);
            const bool is_clear = distances[j] > 1.0e-4F && std::abs(std::abs(w) - 0.5) > 0.03;
            n_wrong += is_clear && (with_signs[j] < 0.0F) != (std::abs(w) >= 0.5) ? 1 : 0;
        }
    }
    return n_wrong;
}

constexpr double kSingle = 1.0e-2;  // voxels

const DistanceField& field() {
    static const DistanceField kField = test::build_bumpy_field(128);
    return kField;
}

// By every version of the kernels, which agree to the bit.
std::array<float, 8> find_slacks(const SlackBounds& bounds, const FieldPlace& place,
                                 const EightBalls& balls) {
    std::array<float, 8> plain{};
    all_field_kernels()[0]->find_slacks(bounds, place, balls, plain);
    for (const FieldKernels* kernels : all_field_kernels()) {
        if (kernels != nullptr) {
            std::array<float, 8> slacks{};
            kernels->find_slacks(bounds, place, balls, slacks);
            INFO(kernels->name);
            REQUIRE(slacks == plain);
        }
    }
    return plain;
}

std::array<float, 3> to_floats(const Vector3& v) {
    return {static_cast<float>(v.x()), static_cast<float>(v.y()), static_cast<float>(v.z())};
}

}  // namespace

TEST_CASE(
    "distance band: small, large, thin and far triangles are as near as they are, or changed not") {
    Random random(11);
    for (int i = 0; i < 2000; ++i) {
        const double size = std::pow(10.0, 1.5 + 1.5 * random.uniform());
        const Vector3 middle = Vector3::Constant(4.0) + 7.0 * random.in_cube();
        const TriangleAt t{middle + size * random.in_cube(), middle + size * random.in_cube(),
                           middle + size * random.in_cube()};
        CHECK(find_worst(t) < kSingle_m * std::max(1.0, size / 50.0));
    }
    random = Random(12);
    for (int i = 0; i < 300; ++i) {
        const Vector3 a = Vector3::Constant(4.0) + 3.0 * random.in_cube();
        const Vector3 along = 4.0 * random.in_cube();
        const double height =
            i % 3 == 0 ? 0.0 : std::pow(10.0, -3.0 - 4.0 * std::abs(random.uniform()));
        const TriangleAt t{a, a + along, a + 0.4 * along + height * random.direction()};
        CHECK(find_worst(t) < kSingle_m);
    }
    const TriangleAt t{{20.0, 20.0, 20.0}, {21.0, 20.0, 20.0}, {20.0, 21.0, 20.0}};
    const BrickDistances squares = lower_all(t);
    CHECK(std::all_of(squares.begin(), squares.end(),
                      [](float square) { return square == kBand * kBand; }));
}

TEST_CASE("brick triangles: a brick has every triangle that comes within reach of it") {
    const TriangleMesh mesh = *make_bumpy_sphere(1.0, 8, 0.2, 5.0);
    const VoxelFrame frame = make_field_frame(mesh, 48).value();
    const auto list = list_brick_triangles(mesh, frame, kReach_voxels, kAny, {});
    REQUIRE(list);
    CHECK(std::is_sorted(list->bricks.begin(), list->bricks.end()));
    CHECK(list->n_pairs == static_cast<double>(list->triangles.size()));
    const int nx = frame.n_cells[0] / kBrickCells;
    const int ny = frame.n_cells[1] / kBrickCells;
    const int nz = frame.n_cells[2] / kBrickCells;
    std::size_t at = 0;
    for (int brick = 0; brick < nx * ny * nz; ++brick) {
        const Vector3 corner = kBrickCells * Vector3(brick % nx, brick / nx % ny, brick / nx / ny);
        const bool listed = at < list->bricks.size() && list->bricks[at] == brick;
        const auto begin = list->triangles.begin();
        const auto first = listed ? begin + static_cast<std::ptrdiff_t>(list->first[at]) : begin;
        const auto end = listed ? begin + static_cast<std::ptrdiff_t>(list->first[at + 1]) : begin;
        CHECK(std::is_sorted(first, end));
        for (std::size_t t = 0; t < mesh.triangles().size(); ++t) {
            // At the brick's own corners: what reaches those it must have.
            const TriangleAt triangle = find_lattice_triangle(mesh, frame, t);
            bool is_near = false;
            for (int c = 0; c < 8; ++c) {
                const Vector3 p = corner + kBrickCells * Vector3(c & 1, c / 2 & 1, c / 4);
                is_near = is_near ||
                          compute_square_distance(p, triangle) <= kReach_voxels * kReach_voxels;
            }
            if (is_near) {
                REQUIRE(std::find(first, end, static_cast<std::int32_t>(t)) != end);
            }
        }
        at += listed ? 1 : 0;
    }
    CHECK(at == list->bricks.size());
}

TEST_CASE("brick triangles: a list that grows too long is given up, and how long it were is told") {
    const TriangleMesh heap = *make_heap(1000, 3);
    const VoxelFrame frame = make_field_frame(heap, 128).value();
    const auto whole = list_brick_triangles(heap, frame, kReach_voxels, kAny, {});
    const auto given_up = list_brick_triangles(heap, frame, kReach_voxels, 20000.0, {});
    REQUIRE(whole);
    REQUIRE(given_up);
    REQUIRE(whole->n_pairs > 1.0e5);
    CHECK(given_up->bricks.empty());
    CHECK(given_up->triangles.empty());
    CHECK(given_up->n_pairs == Approx(whole->n_pairs).epsilon(0.2));
}

TEST_CASE("brick triangles: it stops where it is told to") {
    const TriangleMesh mesh = *make_sphere(1.0, 8);
    const VoxelFrame frame = make_field_frame(mesh, 48).value();
    CHECK_FALSE(
        list_brick_triangles(mesh, frame, kReach_voxels, kAny, [](double) { return false; }));
}

TEST_CASE("brick sides: every corner has the side of its winding number, closed mesh") {
    const TriangleMesh mesh = *make_bumpy_sphere(1.0, 12, 0.1, 8.0);
    const TriangleClusters clusters(mesh);
    CHECK(BrickSides(mesh, clusters, kVoxel_m).n_open_edges() == 0);
    CHECK(count_wrong(mesh, 40) == 0);
}

TEST_CASE(
    "brick sides: every corner has the side of its winding number, by a hole and far from it") {
    TriangleMesh ball = *make_sphere(1.0, 8);
    std::vector<TriangleCorners> kept(ball.triangles().begin() + 40, ball.triangles().end());
    const TriangleMesh mesh = TriangleMesh::build(ball.vertices_B(), kept).value();
    const TriangleClusters clusters(mesh);
    CHECK(BrickSides(mesh, clusters, kVoxel_m).n_open_edges() > 8);
    CHECK(count_wrong(mesh, 60) == 0);
}

TEST_CASE("ball slack: is the field's own free radius less the ball's, near, far and outside") {
    const SlackBounds bounds(field());
    const double voxel_m = field().frame().voxel_m;
    Random random(1);
    for (int k = 0; k < 3000; ++k) {
        const Pose X_OT{random.in_cube(), random.turn(3.0)};
        EightBalls balls;
        for (std::size_t i = 0; i < 8; ++i) {
            const Vector3 at = (k % 3 == 0 ? 6.0 : 1.2) * random.in_cube();
            balls.x[i] = static_cast<float>(at.x());
            balls.y[i] = static_cast<float>(at.y());
            balls.z[i] = static_cast<float>(at.z());
            balls.radius[i] = static_cast<float>(0.1 * std::abs(random.uniform()));
        }
        const std::array<float, 8> slacks = find_slacks(bounds, FieldPlace(field(), X_OT), balls);
        for (std::size_t i = 0; i < 8; ++i) {
            const Vector3 centre = X_OT * Vector3(balls.x[i], balls.y[i], balls.z[i]);
            const double free_m = field().find_free_radius_m(centre);
            const double exact = (free_m - static_cast<double>(balls.radius[i])) / voxel_m;
            const auto slack = static_cast<double>(slacks[i]);
            if (free_m > kSingle * voxel_m) {
                CHECK(slack == Approx(exact).margin(kSingle).epsilon(1.0e-5));
            } else {
                CHECK(slack < kSingle);
            }
        }
    }
}

TEST_CASE(
    "ball slack: a ball that moves by less stays free; a node that is not there never touches") {
    const SlackBounds bounds(field());
    const double voxel_m = field().frame().voxel_m;
    Random random(2);
    int n_free = 0;
    for (int k = 0; k < 4000; ++k) {
        const Vector3 at = (1.15 + 0.3 * random.uniform()) * random.direction();
        EightBalls balls;
        balls.x.fill(static_cast<float>(at.x()));
        balls.y.fill(static_cast<float>(at.y()));
        balls.z.fill(static_cast<float>(at.z()));
        balls.radius.fill(0.05F);
        const std::array<float, 8> slacks = find_slacks(bounds, FieldPlace(field(), Pose{}), balls);
        if (slacks[3] > 0.0F) {
            ++n_free;
            const double reach_m = 0.05 + voxel_m * static_cast<double>(slacks[3]);
            CHECK(field().sample(at + reach_m * random.direction()).value_m > 0.0);
        }
    }
    CHECK(n_free > 1000);
    EightBalls balls;
    balls.radius.fill(-1.0e30F);
    const std::array<float, 8> slacks =
        find_slacks(SlackBounds(field()), FieldPlace(field(), Pose{}), balls);
    CHECK(slacks[0] > 1.0e20F);
}

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
