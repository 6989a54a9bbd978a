// What samples tell a budget of time, on a counted clock: in a socket nearly all points are near, and few touch.
#include "haptics/tool/field_sampling.h"
#include "tests/support/field_parts.h"
#include "tests/support/hard_meshes.h"
#include "tests/support/wander.h"

#include <catch2/catch.hpp>

#include <algorithm>
#include <vector>

using namespace fulcrum;

namespace {

constexpr double kLeaf_us = 0.2;
constexpr double kGroup_us = 0.04;

FieldSampler make(const FieldSampler::Field& field, const FieldSampler::Shell& shell,
                  double budget_us) {
    return FieldSampler::build(field, shell,
                               {.budget_us = budget_us,
                                .clock = BudgetClock::counted,
                                .leaf_us = kLeaf_us,
                                .group_us = kGroup_us})
        .value();
}

double cost_us(const FieldTouch& touch) {
    return static_cast<double>(touch.n_leaves) * kLeaf_us +
           static_cast<double>(touch.n_groups) * kGroup_us;
}

FieldSampler::Field socket() {
    static const FieldSampler::Field kField = test::make_field(
        make_hollow(*make_sphere(1.2, 24), *make_bumpy_sphere(1.0, 24, 0.02, 9.0)).value(), 128);
    return kField;
}

// What fills it but for a voxel.
FieldSampler::Shell plug() {
    static const FieldSampler::Shell kShell = test::make_shell(
        *make_bumpy_sphere(1.0 - socket()->frame().voxel_m, 24, 0.02, 9.0), 100000);
    return kShell;
}

// Pressed to a side that wanders.
std::vector<Pose> make_way(double step_voxels, int n) {
    const double voxel_m = socket()->frame().voxel_m;
    Wanderer wanderer(5, step_voxels);
    std::vector<Pose> way;
    for (int i = 0; i < n; ++i) {
        const Quaternion turn(AngleAxis(1.0e-3 * std::sin(0.1 * i), Vector3::UnitY()));
        way.push_back({1.02 * voxel_m * wanderer.next(), turn});
    }
    return way;
}

}  // namespace

TEST_CASE("field sampling samples: in a socket the force is right to 1 %, and the error is said") {
    constexpr double kBudget_us = 60.0;
    for (const double step_voxels : {0.1, 0.3}) {
        FieldSampler all = make(socket(), plug(), 0.0);
        FieldSampler some = make(socket(), plug(), kBudget_us);
        FieldSampler again = make(socket(), plug(), kBudget_us);
        std::vector<double> off;
        for (const Pose& X_WT : make_way(step_voxels, 300)) {
            const FieldTouch exact = all.step({}, X_WT);
            const FieldTouch touch = some.step({}, X_WT);
            CHECK(cost_us(touch) <= kBudget_us + 1.0e-6);
            const double force_N = exact.wrench_W.force.norm();
            const double off_N = (touch.wrench_W.force - exact.wrench_W.force).norm();
            const double off_Nm = (touch.wrench_W.torque - exact.wrench_W.torque).norm();
            CHECK(off_N <= touch.error_N + 1.0e-6 * force_N);
            CHECK(off_Nm <= touch.error_Nm + 1.0e-6 * force_N);
            CHECK(touch.error_N <= touch.bound_N);
            if (touch.n_left > 0 && touch.n_touching >= 150 * touch.weight) {
                off.push_back(off_N / force_N);
            }
            const FieldTouch same = again.step({}, X_WT);
            CHECK(same.wrench_W.force == touch.wrench_W.force);
            CHECK(same.wrench_W.torque == touch.wrench_W.torque);
            CHECK(same.error_N == touch.error_N);
        }
        REQUIRE(off.size() > 280);
        std::sort(off.begin(), off.end());
        INFO(step_voxels);
        CAPTURE(off[off.size() / 2], off[off.size() * 99 / 100], off.back());
        CHECK(off[off.size() * 99 / 100] < 0.01);
    }
}

TEST_CASE("field sampling samples: a lone tip that was found is kept while samples see another") {
    const FieldSampler::Field box = test::make_unit_box_field(64);
    const double voxel_m = box->frame().voxel_m;
    const auto plate = test::make_shell(test::make_point_rows(200, 0.8, [&](int row, int column) {
        const bool is_tip = 200 * row + column == 7777;
        const bool is_patch = row >= 150 && row < 170 && column >= 150 && column < 170;
        return -voxel_m * (is_tip ? 1.3 : is_patch ? 0.6 : 0.0);
    }));
    FieldSampler all = make(box, plate, 0.0);
    FieldSampler some = make(box, plate, 15.0);
    const auto at = [&](double up_voxels) {
        return Pose::at({0.0, 0.5 + up_voxels * voxel_m, 0.0});
    };
    // The tip alone, until it is found.
    FieldTouch touch;
    for (int i = 0; i < 20; ++i) {
        touch = some.step({}, at(1.0));
    }
    REQUIRE(touch.n_touching == 1);
    // Now the patch touches too.
    for (int i = 0; i < 20; ++i) {
        const Pose X_WT = at(0.5 - 0.001 * i);
        const FieldTouch exact = all.step({}, X_WT);
        touch = some.step({}, X_WT);
        REQUIRE(exact.n_touching == 401);
        CHECK(touch.n_touching == exact.n_touching);
        CHECK(touch.weight == 1);
        CHECK(touch.wrench_W.force.y() == Approx(exact.wrench_W.force.y()).epsilon(1.0e-5));
    }
}
