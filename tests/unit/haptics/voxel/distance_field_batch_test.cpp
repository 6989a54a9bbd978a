// What the kernels sum (distance_field_batch.h), in every version that the processor has: forces, and how they change along slopes.
#include "haptics/voxel/distance_field_batch.h"

#include "haptics/tool/field_sampling/slope_sum.h"
#include "tests/support/field_parts.h"
#include "tests/support/wander.h"

#include <catch2/catch.hpp>

#include <algorithm>
#include <bit>
#include <cmath>
#include <iterator>
#include <limits>
#include <numbers>

using namespace fulcrum;
using test::points_of;

namespace {

constexpr double kPlaces = 2.5e-4;  // voxels: what the header says of single precision places
constexpr std::size_t kLeaves = 40;

const DistanceField& field() {
    static const DistanceField kField = test::build_bumpy_field(80);
    return kField;
}

std::vector<const FieldKernels*> list_kernels() {
    std::vector<const FieldKernels*> all;
    std::ranges::copy_if(all_field_kernels(), std::back_inserter(all),
                         [](const FieldKernels* one) { return one != nullptr; });
    return all;
}

// A ball that overlaps the bumpy one, in a number of points that fills no leaf.
Pointshell make_tool() {
    return make_surface_pointshell(*make_sphere(0.5, 12), 3011).value();
}

// The same ball in whole leaves.
Pointshell make_points() {
    Pointshell shell =
        make_surface_pointshell(*make_sphere(0.5, 12), kLeaves * kLeafPoints).value();
    while (shell.size() < kLeaves * kLeafPoints) {
        shell.add(shell.position_T(0), shell.normal_T(0));
    }
    return shell;
}

ShellPoints leaf_of(const Pointshell& shell, std::size_t leaf) {
    return points_of(shell).from(kLeafPoints * leaf);
}

Pose draw_pose(Random& random) {
    return {(1.0 + 0.6 * random.uniform()) * random.direction(), random.turn(3.0)};
}

Pose draw_near_pose(Random& random, double most_m) {
    return {(1.5 - most_m * random.uniform()) * random.direction(), random.turn(3.0)};
}

ContactSums sum_slowly(const Pose& X_OT, const Pointshell& shell, ForceAlong along) {
    ContactSums sums;
    for (std::size_t i = 0; i < shell.size(); ++i) {
        const Vector3 arm = X_OT.orientation * shell.position_T(i);
        const DepthSample depth = field().sample_depth(X_OT.position + arm);
        if (depth.depth_m > 0.0) {
            const Vector3 n = along == ForceAlong::normals
                                  ? Vector3(X_OT.orientation * shell.normal_T(i))
                                  : depth.way_out;
            sums.force += depth.depth_m * n;
            sums.torque += depth.depth_m * arm.cross(n);
            ++sums.n_touching;
        }
    }
    return sums;
}

ContactSums sum_along(const Pose& X_OT, const Pointshell& shell, ForceAlong along,
                      const FieldKernels& kernels = best_field_kernels()) {
    return sum_contacts(kernels, field(), X_OT, points_of(shell), shell.size(), along);
}

// How deep the point is, as the field itself says, in parts of the band.
double find_depth(const Pose& X_OT, const Pointshell& shell, std::size_t i) {
    return -field().sample(X_OT * shell.position_T(i)).value_m / field().band_m();
}

// Point by point, those that are no deeper than that part of the band.
Matrix6 sum_one_by_one(const Pose& X_OT, const Pointshell& shell, std::size_t leaf, std::size_t n,
                       double most_depth) {
    SlopeSum sum;
    for (std::size_t i = kLeafPoints * leaf; i < kLeafPoints * leaf + n; ++i) {
        const Vector3 arm = X_OT.orientation * shell.position_T(i);
        if (find_depth(X_OT, shell, i) <= most_depth) {
            sum.add(field().sample_depth(X_OT.position + arm), arm);
        }
    }
    Matrix6 all = Matrix6::Zero();
    sum.add_to(all);
    return all;
}

// Whether a point is too near to the border between the two laws to say on which side single precision has it.
bool is_near_border(const Pose& X_OT, const Pointshell& shell, std::size_t leaf) {
    for (std::size_t i = kLeafPoints * leaf; i < kLeafPoints * (leaf + 1); ++i) {
        if (std::abs(find_depth(X_OT, shell, i) - DistanceField::kDeepFrom) < 1.0e-3) {
            return true;
        }
    }
    return false;
}

Matrix6 to_slopes(const SlopeLanes& lanes) {
    Matrix6 slopes = Matrix6::Zero();
    SlopeLanes copy = lanes;
    add_slope_lanes(field(), copy, slopes);
    return slopes;
}

}  // namespace

TEST_CASE(
    "distance field batch: values and slopes are the field's own, inside, outside and far off") {
    const Pointshell shell = make_tool();
    Random random(1);
    for (const FieldKernels* kernels : list_kernels()) {
        for (int k = 0; k < 20; ++k) {
            const Pose X_OT = draw_pose(random);
            std::vector<float> values(shell.size(), 1.0e9F);
            std::array<std::vector<float>, 3> slopes;
            for (auto& slope : slopes) {
                slope.assign(shell.size(), 1.0e9F);
            }
            const std::array<float*, 3> to{slopes[0].data(), slopes[1].data(), slopes[2].data()};
            kernels->sample(FieldView(field()), FieldPlace(field(), X_OT), points_of(shell),
                            shell.size(), values.data(), to.data());
            double worst_voxels = 0.0;
            for (std::size_t i = 0; i < shell.size(); ++i) {
                const DistanceSample exact = field().sample(X_OT * shell.position_T(i));
                const double value_m = field().step_m() * static_cast<double>(values[i]);
                worst_voxels = std::max(
                    worst_voxels, std::abs(value_m - exact.value_m) / field().frame().voxel_m);
                const Vector3 slope =
                    field().step_m() / field().frame().voxel_m *
                    Vector3f(slopes[0][i], slopes[1][i], slopes[2][i]).cast<double>();
                // Beside a cell's face the slope is the neighbour's.
                CHECK((slope - exact.slope).norm() < 0.5);
            }
            CHECK(worst_voxels < field().slope_bound() * kPlaces);
        }
    }
}

TEST_CASE("distance field batch: sums are those of one point after the other") {
    const Pointshell shell = make_tool();
    Random random(2);
    for (const ForceAlong along : {ForceAlong::normals, ForceAlong::slopes}) {
        for (int k = 0; k < 40; ++k) {
            const Pose X_OT = draw_pose(random);
            const ContactSums slow = sum_slowly(X_OT, shell, along);
            const ContactSums sums = sum_along(X_OT, shell, along);
            // Points nearer to the surface than places are exact may count or not.
            CHECK(std::abs(sums.n_touching - slow.n_touching) <= 2);
            const double margin = 2.0e-4 * (slow.force.norm() + 0.01);
            CHECK((sums.force - slow.force).norm() < margin);
            CHECK((sums.torque - slow.torque).norm() < margin);
        }
    }
}

TEST_CASE("distance field batch: all versions agree to the bit, in sums and in slopes") {
    const auto kernels = list_kernels();
    if (kernels.size() < all_field_kernels().size()) {
        WARN("this processor has not every version");
    }
    const Pointshell shell = make_tool();
    Random random(3);
    for (const ForceAlong along : {ForceAlong::normals, ForceAlong::slopes}) {
        for (int k = 0; k < 40; ++k) {
            const Pose X_OT = draw_pose(random);
            const ContactSums plain = sum_along(X_OT, shell, along, *kernels[0]);
            for (const FieldKernels* wide : kernels) {
                INFO(wide->name);
                const ContactSums sums = sum_along(X_OT, shell, along, *wide);
                CHECK(plain.force == sums.force);
                CHECK(plain.torque == sums.torque);
                CHECK(plain.n_touching == sums.n_touching);
            }
        }
    }
    const Pointshell points = make_points();
    Random near(4);
    for (int k = 0; k < 100; ++k) {
        const FieldPlace place(field(), draw_near_pose(near, 0.4));
        const auto sum_leaves = [&](const FieldKernels& by, SlopeLanes& lanes) {
            std::uint32_t deep = 0;
            for (std::size_t leaf = 0; leaf < kLeaves; ++leaf) {
                deep ^= std::rotl(by.sum_slopes(FieldView(field()), place, leaf_of(points, leaf),
                                                kLeafPoints - leaf % 3, lanes),
                                  static_cast<int>(leaf % 32));
            }
            return deep;
        };
        SlopeLanes plain;
        const std::uint32_t plain_deep = sum_leaves(*kernels[0], plain);
        for (const FieldKernels* wide : kernels) {
            INFO(wide->name);
            SlopeLanes lanes;
            REQUIRE(sum_leaves(*wide, lanes) == plain_deep);
            REQUIRE(lanes.place == plain.place);
            REQUIRE(lanes.turn == plain.turn);
            REQUIRE(lanes.torque == plain.torque);
            REQUIRE(lanes.arm_force == plain.arm_force);
        }
    }
}

TEST_CASE("distance field batch: along slopes no closed way gains energy, at any depth") {
    const Pointshell shell = make_tool();
    // Round a circle and turning, just in contact, half in, and so that all points but few are deeper than the band; the work is
    // that of the midpoints.
    constexpr int kSteps = 4000;
    for (const double radius_m : {1.47, 1.0, 0.3}) {
        const auto place = [&](double angle) {
            return Pose{radius_m * Vector3(std::cos(angle), std::sin(angle), 0.1),
                        Quaternion(AngleAxis(angle, Vector3::UnitY()))};
        };
        double work = 0.0;
        double most = 0.0;
        for (int i = 0; i < kSteps; ++i) {
            const double step = 2.0 * std::numbers::pi / kSteps;
            const Pose from = place(i * step);
            const Pose to = place((i + 1) * step);
            const ContactSums sums = sum_along(place((i + 0.5) * step), shell, ForceAlong::slopes);
            const Vector3 turn = step * Vector3::UnitY();
            const double gained =
                sums.force.dot(to.position - from.position) + sums.torque.dot(turn);
            work += gained;
            most += std::abs(gained);
        }
        INFO(radius_m << " m: " << work << " of " << most);
        CHECK(most > 1.0e-3);
        CHECK(std::abs(work) < 1.0e-3 * most);
    }
}

TEST_CASE("distance field batch: along normals the force is continuous where the tool slides") {
    const Pointshell shell = make_tool();
    Vector3 before = Vector3::Zero();
    double largest = 0.0;
    constexpr double kStep_m = 1.0e-5;
    for (int i = 0; i < 4000; ++i) {
        const Pose X_OT = Pose::at({0.3 + i * kStep_m, 1.42, 0.2});
        const ContactSums sums = sum_along(X_OT, shell, ForceAlong::normals);
        if (i > 0) {
            // Each point's depth changes by L a metre at most; single precision places come on top.
            const double places_m = 2.0 * kPlaces * field().frame().voxel_m;
            const double bound = static_cast<double>(sums.n_touching + 4) * field().slope_bound() *
                                 (kStep_m + places_m);
            CHECK((sums.force - before).norm() <= bound);
            largest = std::max(largest, sums.force.norm());
        }
        before = sums.force;
    }
    CHECK(largest > 0.1);
}

TEST_CASE("distance field batch: hits are those below zero, and what is no number is free") {
    // More than two vectors of any version, and a rest.
    Random random(11);
    std::vector<float> values{1.0F,  -1.0F, 0.0F,
                              -0.0F, -2.0F, std::numeric_limits<float>::quiet_NaN()};
    for (int i = 0; i < 61; ++i) {
        values.push_back(static_cast<float>(random.uniform()));
    }
    std::vector<std::int32_t> expected;
    for (std::size_t i = 0; i < values.size(); ++i) {
        if (values[i] < 0.0F) {
            expected.push_back(static_cast<std::int32_t>(i));
        }
    }
    REQUIRE(expected.size() > 10);
    for (const FieldKernels* kernels : list_kernels()) {
        std::vector<std::int32_t> hits(values.size() + 1, -7);
        REQUIRE(kernels->collect_hits(values.data(), values.size(), hits.data()) ==
                expected.size());
        CHECK(std::equal(expected.begin(), expected.end(), hits.begin()));
        CHECK(kernels->collect_hits(values.data(), 0, hits.data()) == 0);
        // None but the first, which leaves all that is behind it as it was.
        std::vector<std::int32_t> few(3, -7);
        CHECK(kernels->collect_hits(values.data() + 1, 1, few.data()) == 1);
        CHECK(few[2] == -7);
    }
    const float nan = std::numeric_limits<float>::quiet_NaN();
    const std::vector<float> xs(kLeafPoints, nan);
    const ShellPoints points{xs.data(), xs.data(), xs.data(), xs.data(), xs.data(), xs.data()};
    for (const FieldKernels* kernels : list_kernels()) {
        CHECK(sum_contacts(*kernels, field(), Pose{}, points, kLeafPoints, ForceAlong::slopes)
                  .n_touching == 0);
    }
}

TEST_CASE("distance field slopes: sums are those point by point, and deep points are told") {
    const Pointshell shell = make_points();
    Random random(3);
    int n_shallow = 0;
    int n_deep = 0;
    for (const FieldKernels* kernels : list_kernels()) {
        for (int k = 0; k < 1500; ++k) {
            // A graze, or far in.
            const Pose X_OT = draw_near_pose(random, k % 2 == 0 ? 0.1 : 0.6);
            const FieldPlace place(field(), X_OT);
            const std::size_t leaf = static_cast<std::size_t>(k) % (kLeaves);
            const std::size_t n = k % 3 == 0 ? kLeafPoints : 1 + static_cast<std::size_t>(k) % 31;
            if (is_near_border(X_OT, shell, leaf)) {
                continue;
            }
            SlopeLanes lanes;
            const std::uint32_t deep =
                kernels->sum_slopes(FieldView(field()), place, leaf_of(shell, leaf), n, lanes);
            std::uint32_t right_deep = 0;
            for (std::size_t i = 0; i < n; ++i) {
                const bool is_deep =
                    find_depth(X_OT, shell, kLeafPoints * leaf + i) > DistanceField::kDeepFrom;
                right_deep |= is_deep ? 1U << i : 0U;
            }
            REQUIRE(deep == right_deep);
            const Matrix6 right = sum_one_by_one(X_OT, shell, leaf, n, DistanceField::kDeepFrom);
            const Matrix6 slopes = to_slopes(lanes);
            for (int row = 0; row < 6; row += 3) {
                for (int column = 0; column < 6; column += 3) {
                    // Single precision of places and sums, the latter over slopes of 1 and arms of half a metre. A point whose F
                    // is 0 but for a rounding would count or not with all of its slope; none of these does.
                    const Matrix3 off =
                        slopes.block<3, 3>(row, column) - right.block<3, 3>(row, column);
                    constexpr double kArm_m = 0.5;
                    REQUIRE(off.norm() <
                            2.0e-5 * static_cast<double>(n) * std::pow(kArm_m, (row + column) / 3));
                }
            }
            n_shallow += right.topLeftCorner<3, 3>().norm() > 1.0 ? 1 : 0;
            n_deep += deep != 0 ? 1 : 0;
        }
    }
    CHECK(n_shallow > 50);
    CHECK(n_deep > 50);
}

TEST_CASE("distance field slopes: what does not touch adds nothing, and added lanes are empty") {
    const Pointshell shell = make_points();
    for (const FieldKernels* kernels : list_kernels()) {
        SlopeLanes lanes;
        const auto sum_at = [&](double x_m) {
            const FieldPlace place(field(), Pose::at({x_m, 0.0, 0.0}));
            std::uint32_t deep = 0;
            for (std::size_t leaf = 0; leaf < kLeaves; ++leaf) {
                deep |= kernels->sum_slopes(FieldView(field()), place, leaf_of(shell, leaf),
                                            kLeafPoints, lanes);
            }
            return deep;
        };
        CHECK(sum_at(4.0) == 0);
        CHECK(to_slopes(lanes) == Matrix6::Zero());
        (void)sum_at(1.45);
        Matrix6 once = Matrix6::Zero();
        add_slope_lanes(field(), lanes, once);
        CHECK(once.norm() > 1.0);
        Matrix6 again = once;
        add_slope_lanes(field(), lanes, again);
        CHECK(again == once);
    }
}
