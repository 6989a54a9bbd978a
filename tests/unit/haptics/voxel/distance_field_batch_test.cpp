#include "haptics/voxel/distance_field_batch.h"

#include "haptics/geometry/shape.h"
#include "haptics/voxel/pointshell.h"
#include "tests/support/wander.h"

#include <catch2/catch.hpp>

#include <limits>
#include <numbers>

using namespace fulcrum;

namespace {

constexpr double kPlaces = 2.5e-4;  // voxels: what the header says of single precision places

const DistanceField& field() {
    static const DistanceField kField = [] {
        const TriangleMesh mesh = *make_bumpy_sphere(1.0, 16, 0.05, 12.0);
        return DistanceField::build(mesh, DistanceField::make_frame(mesh, 80).value()).value();
    }();
    return kField;
}

ShellPoints points_of(const Pointshell& shell) {
    return {shell.x_m.data(), shell.y_m.data(), shell.z_m.data(),
            shell.nx.data(),  shell.ny.data(),  shell.nz.data()};
}

// A ball that overlaps the bumpy one, in a number of points that fills no leaf.
Pointshell make_tool() {
    return make_surface_pointshell(*make_sphere(0.5, 12), 3011).value();
}

Pose draw_pose(Random& random) {
    return {(1.0 + 0.6 * random.uniform()) * random.direction(), random.turn(3.0)};
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

}  // namespace

TEST_CASE(
    "distance field batch: values and slopes are the field's own, inside, outside and far off") {
    const Pointshell shell = make_tool();
    Random random(1);
    for (const FieldKernels* kernels : all_field_kernels()) {
        for (int k = 0; kernels != nullptr && k < 20; ++k) {
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
            const ContactSums sums = sum_contacts(best_field_kernels(), field(), X_OT,
                                                  points_of(shell), shell.size(), along);
            // Points nearer to the surface than places are exact may count or not.
            CHECK(std::abs(sums.n_touching - slow.n_touching) <= 2);
            const double margin = 2.0e-4 * (slow.force.norm() + 0.01);
            CHECK((sums.force - slow.force).norm() < margin);
            CHECK((sums.torque - slow.torque).norm() < margin);
        }
    }
}

TEST_CASE("distance field batch: all versions agree to the bit") {
    const auto kernels = all_field_kernels();
    if (kernels[1] == nullptr) {
        WARN("this processor has one version only");
        return;
    }
    const Pointshell shell = make_tool();
    Random random(3);
    for (const ForceAlong along : {ForceAlong::normals, ForceAlong::slopes}) {
        for (int k = 0; k < 40; ++k) {
            const Pose X_OT = draw_pose(random);
            const auto sum = [&](std::size_t which) {
                return sum_contacts(*kernels[which], field(), X_OT, points_of(shell), shell.size(),
                                    along);
            };
            CHECK(sum(0).force == sum(1).force);
            CHECK(sum(0).torque == sum(1).torque);
            CHECK(sum(0).n_touching == sum(1).n_touching);
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
            const ContactSums sums =
                sum_contacts(best_field_kernels(), field(), place((i + 0.5) * step),
                             points_of(shell), shell.size(), ForceAlong::slopes);
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
        const ContactSums sums = sum_contacts(best_field_kernels(), field(), X_OT, points_of(shell),
                                              shell.size(), ForceAlong::normals);
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

TEST_CASE("distance field batch: hits are the numbers of those below zero") {
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
    for (const FieldKernels* kernels : all_field_kernels()) {
        if (kernels == nullptr) {
            continue;
        }
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
}

TEST_CASE("distance field batch: a place that is no number is free") {
    const float nan = std::numeric_limits<float>::quiet_NaN();
    const std::vector<float> xs(kLeafPoints, nan);
    const ShellPoints points{xs.data(), xs.data(), xs.data(), xs.data(), xs.data(), xs.data()};
    for (const FieldKernels* kernels : all_field_kernels()) {
        if (kernels != nullptr) {
            CHECK(sum_contacts(*kernels, field(), Pose{}, points, kLeafPoints, ForceAlong::slopes)
                      .n_touching == 0);
        }
    }
}
