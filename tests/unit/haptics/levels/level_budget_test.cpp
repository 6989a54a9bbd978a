// A budget of time is kept however deep it is, and what it leaves is told: by a clock that counts.
#include "haptics/math/rotation.h"
#include "tests/support/level_parts.h"

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>

using namespace fulcrum;
using test::find_push;
using test::kRounding_m;
using test::Levels;
using test::make_levels;
using test::make_lumps;
using test::make_pairs;

namespace {

// A clock that is read once a piece of work: then so many microseconds are so many pieces.
double ticks_s = 0.0;
double count_a_tick_s() noexcept {
    ticks_s += 1.0e-6;
    return ticks_s;
}

// 10 mm deep, where thousands of pairs of pieces are looked at.
struct DeepLumps {
    static constexpr double kNear_m = 1.0e-3;
    Levels levels = make_lumps(kNear_m);
    Pose X_OT{{0.002, 0.09, 0.0}, compute_exp(Vector3(0.2, 0.4, 0.1))};
    [[nodiscard]] std::unique_ptr<LevelPairs> ask_within(double budget_us) const {
        return make_pairs(levels, levels, {.budget_us = budget_us, .now_s = &count_a_tick_s});
    }
};

}  // namespace

TEST_CASE(
    "level pairs: however deep, the budget is kept but for one way down, and what is left is "
    "told") {
    const DeepLumps deep;
    const auto exact = make_pairs(deep.levels, deep.levels);
    const LevelAnswer whole = exact->find(deep.X_OT, DeepLumps::kNear_m);
    REQUIRE(whole.n_looked_at > 2000);
    CHECK(whole.n_left + whole.n_coarser == 0);
    CHECK(whole.left_m == 0.0);
    // A way down ends after each node of either tree; at its end there are a patch and the clock.
    const int one_way = 2 * 2 * deep.levels->n_levels() + 8;
    for (const double budget_us : {20.0, 50.0, 100.0, 200.0, 500.0}) {
        const auto pairs = deep.ask_within(budget_us);
        int n_before = 0;
        for (int i = 0; i < 30; ++i) {
            const double before_s = ticks_s;
            const LevelAnswer answer = pairs->find(deep.X_OT, DeepLumps::kNear_m);
            const double took_us = 1.0e6 * (ticks_s - before_s);
            CAPTURE(budget_us, i, took_us, answer.n_patches, answer.n_left);
            // Two more to begin and to end.
            CHECK(took_us <= budget_us + one_way + 2);
            // No more work than readings of the clock: so time is what the clock says.
            CHECK(answer.n_looked_at <= took_us + one_way);
            // The first questions know nothing, and their ways down may end where nothing is.
            CHECK((answer.n_patches > 0 || i < 10));
            CHECK(answer.n_left + answer.n_coarser > 0);
            CHECK(answer.left_m > 0.0);
            CHECK(answer.left_m < 0.1);
            CHECK(answer.error_m <= DeepLumps::kNear_m);
            for (const LevelContact& contact : pairs->contacts()) {
                CHECK(contact.point_O.allFinite());
                CHECK(contact.normal_O.norm() == Approx(1.0));
            }
            n_before = answer.n_patches;
        }
        CHECK(n_before >= budget_us / 100.0);
    }
}

TEST_CASE("level pairs: within a budget it is pushed out as without, the more time the better") {
    const DeepLumps deep;
    const auto exact = make_pairs(deep.levels, deep.levels);
    exact->find(deep.X_OT, DeepLumps::kNear_m);
    const Vector3 way = find_push(*exact).normalized();
    double last_worst = 0.0;
    for (const double budget_us : {200.0, 800.0, 3200.0}) {
        const auto pairs = deep.ask_within(budget_us);
        double worst = 1.0;
        for (int i = 0; i < 20; ++i) {
            pairs->find(deep.X_OT, DeepLumps::kNear_m);
            if (i >= 10) {
                worst = std::min(worst, find_push(*pairs).normalized().dot(way));
            }
        }
        CAPTURE(budget_us);
        CHECK(worst > 0.9);
        last_worst = worst;
    }
    CHECK(last_worst > 0.99);
}

TEST_CASE(
    "level pairs: a budget that is enough gives the whole answer, and no more than a tolerance") {
    constexpr double kNear_m = 5.0e-3;
    const Levels levels = make_lumps(kNear_m);
    const Pose X_OT = test::kLumpsApart;
    const auto exact = make_pairs(levels, levels);
    const double nearest_m = exact->find(X_OT, kNear_m).nearest_m;
    const auto most = make_pairs(levels, levels, {.budget_us = 1.0e6});
    const LevelAnswer fine = most->find(X_OT, kNear_m);
    CHECK(fine.error_m == 0.0);
    CHECK(fine.n_left + fine.n_coarser == 0);
    CHECK(!fine.is_late);
    CHECK(fine.nearest_m == Approx(nearest_m).margin(kRounding_m));
    CHECK(most->contacts().size() == exact->contacts().size());
    // Not finer than the tolerance, however much time there is.
    const auto held = make_pairs(levels, levels, {.tolerance_m = 1.2e-2, .budget_us = 1.0e6});
    CHECK(held->find(X_OT, kNear_m).error_m > 0.0);
    // No time at all: late, and one way down is gone all the same.
    const auto least = make_pairs(levels, levels, {.budget_us = 1.0e-3});
    const LevelAnswer hasty = least->find(X_OT, kNear_m);
    CHECK(hasty.is_late);
    CHECK(hasty.n_left + hasty.n_coarser > 0);
    CHECK(hasty.n_patches <= 1);
    CHECK(hasty.n_looked_at <= 4 * levels->n_levels());
}

TEST_CASE("level pairs: in free space nothing is told, whatever the budget") {
    const Levels levels = make_levels(make_bumpy_sphere(0.05, 12, 0.06, 60.0).value(), 1.0e-3);
    for (const double budget_us : {1.0e-3, 20.0, 1.0e6}) {
        const auto pairs = make_pairs(levels, levels, {.budget_us = budget_us});
        for (int i = 0; i < 50; ++i) {
            const LevelAnswer answer = pairs->find(
                {{0.002 * i, 0.107, 0.0}, compute_exp(Vector3(0.1 * i, 0.2, 0.0))}, 1.0e-3);
            CHECK(pairs->contacts().empty());
            CHECK(std::isinf(answer.nearest_m));
        }
    }
}

TEST_CASE("level pairs: what a budget cut short is found again as soon as there is time") {
    constexpr double kNear_m = 5.0e-3;
    const Levels levels = make_levels(make_bumpy_sphere(0.05, 12, 0.06, 60.0).value(), kNear_m);
    const auto exact = make_pairs(levels, levels);
    const auto hurried = make_pairs(levels, levels, {.now_s = &count_a_tick_s});
    int n_near = 0;
    for (int i = 0; i < 3000; ++i) {
        // To and fro along the object, always near it somewhere.
        const double along = 0.3 * std::sin(0.08 * i);
        const double far_m = 0.1035 + 0.0008 * std::sin(0.56 * i);
        const Pose X_OT{far_m * Vector3(std::sin(along), std::cos(along), 0.0),
                        compute_exp(Vector3(0.0, 0.0, 0.3 * along))};
        const bool has_time = i % 10 == 9;
        hurried->set_budget_us(has_time ? 0.0 : 1.0 + i % 1000);
        const LevelAnswer answer = hurried->find(X_OT, kNear_m);
        if (!has_time) {
            continue;
        }
        const LevelAnswer whole = exact->find(X_OT, kNear_m);
        CAPTURE(i, whole.nearest_m, answer.nearest_m);
        REQUIRE(hurried->contacts().empty() == exact->contacts().empty());
        REQUIRE(std::min(answer.nearest_m, 1.0) ==
                Approx(std::min(whole.nearest_m, 1.0)).margin(kRounding_m));
        n_near += exact->contacts().empty() ? 0 : 1;
    }
    CHECK(n_near > 200);
}
