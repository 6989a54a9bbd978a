#include "haptics/math/rotation.h"
#include "haptics/tool/field_sampling/rank_cut.h"
#include "haptics/tool/field_sampling/seen_samples.h"
#include "haptics/voxel/voxelise.h"
#include "tests/support/gear.h"
#include "tests/support/listed_tree.h"
#include "tests/support/wander.h"

#include <catch2/catch.hpp>

#include <algorithm>
#include <random>
#include <vector>

using namespace fulcrum;

namespace {

constexpr std::size_t kUnits = 3;

std::vector<float> see(SeenSamples& seen, unsigned seed) {
    Random random(seed);
    std::vector<float> all;
    seen.clear();
    for (std::size_t unit = 0; unit < kUnits; ++unit) {
        float* const to = seen.add_unit();
        for (std::size_t i = 0; i < kLeafPoints; ++i) {
            to[i] = static_cast<float>(random.uniform());
            all.push_back(to[i]);
        }
    }
    return all;
}

std::vector<float> choose(const std::vector<float>& ranks, std::size_t room) {
    RankCut cut(ranks, room);
    std::vector<float> taken;
    std::copy_if(ranks.begin(), ranks.end(), std::back_inserter(taken),
                 [&](float rank) { return cut.takes(rank); });
    return taken;
}

}  // namespace

TEST_CASE("seen samples: a part's F is the least of its samples, or its only one") {
    SeenSamples seen;
    seen.reserve(kUnits);
    CHECK(seen.n_most_units() == kUnits);
    const std::vector<float> all = see(seen, 1);
    CHECK(seen.n_units() == kUnits);
    for (const std::size_t n_parts : {128U, 32U, 8U, 2U, 1U}) {
        seen.split(n_parts);
        CHECK(seen.n_parts_a_sample() == std::max<std::size_t>(n_parts / kLeafPoints, 1));
        std::size_t n_touch = 0;
        for (std::size_t unit = 0; unit < kUnits; ++unit) {
            for (std::size_t part = 0; part < n_parts; ++part) {
                // Shares of the unit's samples, at least one.
                const std::size_t first = kLeafPoints * unit + part * kLeafPoints / n_parts;
                const std::size_t n = std::max<std::size_t>(kLeafPoints / n_parts, 1);
                const auto begin = all.begin() + static_cast<std::ptrdiff_t>(first);
                const float least =
                    *std::min_element(begin, begin + static_cast<std::ptrdiff_t>(n));
                CHECK(seen.least(unit, part) == least);
                n_touch += least < 0.0F ? 1 : 0;
            }
        }
        CHECK(seen.count_touching() * seen.n_parts_a_sample() == n_touch);
    }
}

TEST_CASE("seen samples: after clearing, nothing of what was seen is left") {
    SeenSamples seen;
    seen.reserve(kUnits);
    see(seen, 1);
    seen.split(1);
    const std::vector<float> all = see(seen, 2);
    seen.split(kLeafPoints);
    CHECK(seen.n_units() == kUnits);
    for (std::size_t part = 0; part < kLeafPoints; ++part) {
        CHECK(seen.least(1, part) == all[kLeafPoints + part]);
    }
    seen.clear();
    seen.split(1);
    CHECK(seen.n_units() == 0);
    CHECK(seen.count_touching() == 0);
}

TEST_CASE("rank cut: exactly as many as there is room for, the first before what is nearly first") {
    Random random(1);
    for (const std::size_t n : {0U, 1U, 100U, 5000U}) {
        std::vector<float> ranks;
        for (std::size_t i = 0; i < n; ++i) {
            // Many are alike, as what touched is.
            const auto rank = static_cast<float>(1.0 + 1.2 * random.uniform());
            ranks.push_back(std::clamp(rank, 0.0F, RankCut::kFirst));
        }
        for (const std::size_t room : {0U, 1U, 7U, 99U, 100U, 101U, 4999U, 10000U}) {
            std::vector<float> taken = choose(ranks, room);
            REQUIRE(taken.size() == std::min(room, n));
            std::vector<float> best = ranks;
            std::sort(best.rbegin(), best.rend());
            std::sort(taken.rbegin(), taken.rend());
            for (std::size_t i = 0; i < taken.size(); ++i) {
                CHECK(taken[i] >= best[i] - RankCut::kFirst / 127.0F);
            }
        }
    }
    std::vector<float> ranks(50, 0.999F * RankCut::kFirst);
    ranks.insert(ranks.end(), 10, RankCut::kFirst);
    const std::vector<float> taken = choose(ranks, 12);
    CHECK(std::count(taken.begin(), taken.end(), RankCut::kFirst) == 10);
    CHECK(taken.size() == 12);
}

// The thesis' way of looking up, which benchmarks have beside ours, finds the same voxels and the same force.

TEST_CASE("listed tree: finds the surface voxels that the grid has, at both depths") {
    const auto gear = make_gear({}).value();
    const VoxelGrid grid = voxelise(gear, {.voxel_m = compute_voxel_m(gear, 40)}).value();
    for (const int depth : {1, 2}) {
        const test::ListedTree tree(grid, depth);
        std::mt19937 random(9);  // NOLINT(cert-msc51-cpp): the same each time
        std::uniform_real_distribution<double> unit(-1.1, 1.1);
        for (int i = 0; i < 20000; ++i) {
            const Vector3 p(0.05 * unit(random), 0.05 * unit(random), 0.012 * unit(random));
            const VoxelFrame::Cell cell = grid.frame.find_cell(p);
            const Vector3* const found = tree.find_surface(p);
            REQUIRE((found != nullptr) == (grid.find_class(cell) == VoxelClass::surface));
            REQUIRE((found == nullptr || (*found - grid.frame.centre_of(cell)).norm() < 1.0e-12));
        }
    }
}

TEST_CASE(
    "listed tree: the thesis' sum over all points is what voxel sampling gives with its settings") {
    const auto gear = make_gear({}).value();
    const auto grid = std::make_shared<const VoxelGrid>(
        voxelise(gear, {.voxel_m = compute_voxel_m(gear, 40)}).value());
    const Pointshell shell = make_surface_pointshell(gear, 4000).value();
    VoxelSamplingSettings settings;
    settings.plane = TangentPlane::both_sides;
    settings.braking = PreContactBraking::off;
    settings.full_contacts = 70.0;
    const VoxelSampling sampling = VoxelSampling::build({grid, nullptr, shell, settings}).value();
    std::vector<Vector3> points;
    std::vector<Vector3> normals;
    for (std::size_t i = 0; i < shell.size(); ++i) {
        points.push_back(shell.position_T(i));
        normals.push_back(shell.normal_T(i));
    }
    const test::ListedTree tree(*grid, 1);
    for (const double apart_m : {0.097, 0.093, 0.06}) {
        RigidState state;
        state.pose_W = {{apart_m, 0.001, 0.002}, compute_exp({0.02, 0.01, 0.2})};
        const VoxelContact contact = sampling.sample(state, {});
        const Wrench listed = test::sample_listed(tree, points, normals, state.pose_W,
                                                  settings.stiffness_N_per_m, 70.0);
        REQUIRE(contact.n_surface > 0);
        // A point at a wall may count for the neighbour in single precision: one of some hundred at most.
        CHECK((contact.wrench_W.force - listed.force).norm() <
              1.0e-3 * (1.0 + listed.force.norm()));
        CHECK((contact.wrench_W.torque - listed.torque).norm() <
              1.0e-4 * (1.0 + listed.torque.norm()));
    }
}
