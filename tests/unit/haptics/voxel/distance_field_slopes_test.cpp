// How contacts' forces along slopes change, summed by the kernels of distance_field_batch.h.
#include "haptics/geometry/shape.h"
#include "haptics/tool/slope_sum.h"
#include "haptics/voxel/distance_field_batch.h"
#include "haptics/voxel/pointshell.h"
#include "tests/support/wander.h"

#include <catch2/catch.hpp>

#include <algorithm>
#include <bit>
#include <cmath>

using namespace fulcrum;

namespace {

const DistanceField& bumpy_field() {
    static const DistanceField kField = [] {
        const TriangleMesh mesh = *make_bumpy_sphere(1.0, 16, 0.05, 12.0);
        return DistanceField::build(mesh, DistanceField::make_frame(mesh, 80).value()).value();
    }();
    return kField;
}

constexpr std::size_t kPoints = 40 * kLeafPoints;

Pointshell make_points() {
    Pointshell shell = make_surface_pointshell(*make_sphere(0.5, 12), kPoints).value();
    while (shell.size() < kPoints) {
        shell.add(shell.position_T(0), shell.normal_T(0));
    }
    return shell;
}

ShellPoints leaf_of(const Pointshell& shell, std::size_t leaf) {
    const ShellPoints all{shell.x_m.data(), shell.y_m.data(), shell.z_m.data(),
                          shell.nx.data(),  shell.ny.data(),  shell.nz.data()};
    return all.from(kLeafPoints * leaf);
}

// How deep the point is, as the field itself says, in parts of the band.
double find_depth(const Pose& X_OT, const Pointshell& shell, std::size_t i) {
    return -bumpy_field().sample(X_OT * shell.position_T(i)).value_m / bumpy_field().band_m();
}

// Point by point, those that are no deeper than that part of the band.
Matrix6 sum_one_by_one(const Pose& X_OT, const Pointshell& shell, std::size_t leaf, std::size_t n,
                       double most_depth) {
    SlopeSum sum;
    for (std::size_t i = kLeafPoints * leaf; i < kLeafPoints * leaf + n; ++i) {
        const Vector3 arm = X_OT.orientation * shell.position_T(i);
        if (find_depth(X_OT, shell, i) <= most_depth) {
            sum.add(bumpy_field().sample_depth(X_OT.position + arm), arm);
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
    add_slope_lanes(bumpy_field(), copy, slopes);
    return slopes;
}

Pose draw_near_pose(Random& random, double most_m) {
    return {(1.5 - most_m * random.uniform()) * random.direction(), random.turn(3.0)};
}

}  // namespace

TEST_CASE(
    "distance field slopes: sums in vectors are those point by point, in every part, and deep "
    "points are told") {
    const Pointshell shell = make_points();
    Random random(3);
    int n_shallow = 0;
    int n_deep = 0;
    for (const FieldKernels* kernels : all_field_kernels()) {
        for (int k = 0; kernels != nullptr && k < 1500; ++k) {
            // A graze, or far in.
            const Pose X_OT = draw_near_pose(random, k % 2 == 0 ? 0.1 : 0.6);
            const FieldPlace place(bumpy_field(), X_OT);
            const std::size_t leaf = static_cast<std::size_t>(k) % (kPoints / kLeafPoints);
            const std::size_t n = k % 3 == 0 ? kLeafPoints : 1 + static_cast<std::size_t>(k) % 31;
            if (is_near_border(X_OT, shell, leaf)) {
                continue;
            }
            SlopeLanes lanes;
            const std::uint32_t deep = kernels->sum_slopes(FieldView(bumpy_field()), place,
                                                           leaf_of(shell, leaf), n, lanes);
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

TEST_CASE("distance field slopes: every version of the kernels has the same bits") {
    const auto versions = all_field_kernels();
    if (versions[1] == nullptr) {
        return;
    }
    const Pointshell shell = make_points();
    Random random(4);
    for (int k = 0; k < 100; ++k) {
        const FieldPlace place(bumpy_field(), draw_near_pose(random, 0.4));
        std::array<SlopeLanes, 2> lanes;
        std::array<std::uint32_t, 2> deep{};
        for (std::size_t version = 0; version < 2; ++version) {
            for (std::size_t leaf = 0; leaf < kPoints / kLeafPoints; ++leaf) {
                deep[version] ^=
                    std::rotl(versions[version]->sum_slopes(FieldView(bumpy_field()), place,
                                                            leaf_of(shell, leaf),
                                                            kLeafPoints - leaf % 3, lanes[version]),
                              static_cast<int>(leaf % 32));
            }
        }
        REQUIRE(deep[0] == deep[1]);
        REQUIRE(lanes[0].place == lanes[1].place);
        REQUIRE(lanes[0].turn == lanes[1].turn);
        REQUIRE(lanes[0].torque == lanes[1].torque);
        REQUIRE(lanes[0].arm_force == lanes[1].arm_force);
    }
}

TEST_CASE(
    "distance field slopes: what does not touch adds nothing, and lanes that were added are "
    "empty") {
    const Pointshell shell = make_points();
    const FieldPlace far(bumpy_field(), Pose::at({4.0, 0.0, 0.0}));
    const FieldPlace near(bumpy_field(), Pose::at({1.45, 0.0, 0.0}));
    for (const FieldKernels* kernels : all_field_kernels()) {
        if (kernels == nullptr) {
            continue;
        }
        SlopeLanes lanes;
        for (std::size_t leaf = 0; leaf < kPoints / kLeafPoints; ++leaf) {
            CHECK(kernels->sum_slopes(FieldView(bumpy_field()), far, leaf_of(shell, leaf),
                                      kLeafPoints, lanes) == 0);
        }
        CHECK(to_slopes(lanes) == Matrix6::Zero());
        for (std::size_t leaf = 0; leaf < kPoints / kLeafPoints; ++leaf) {
            (void)kernels->sum_slopes(FieldView(bumpy_field()), near, leaf_of(shell, leaf),
                                      kLeafPoints, lanes);
        }
        Matrix6 once = Matrix6::Zero();
        add_slope_lanes(bumpy_field(), lanes, once);
        CHECK(once.norm() > 1.0);
        Matrix6 again = once;
        add_slope_lanes(bumpy_field(), lanes, again);
        CHECK(again == once);
    }
}
