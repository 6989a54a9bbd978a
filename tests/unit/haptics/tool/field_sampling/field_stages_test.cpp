#include "haptics/tool/field_sampling/budget_look.h"
#include "haptics/tool/field_sampling/closer_look.h"
#include "haptics/tool/field_sampling/deepest_look.h"
#include "haptics/tool/field_sampling/free_memory.h"
#include "haptics/tool/field_sampling/leaf_sums.h"
#include "haptics/tool/field_sampling/sample_units.h"
#include "haptics/tool/field_sampling/seen_leaves.h"
#include "haptics/tool/field_sampling/shell_search.h"
#include "haptics/tool/field_sampling/step_choice.h"
#include "haptics/tool/field_sampling/thinned_look.h"
#include "haptics/tool/field_sampling/timed_look.h"
#include "tests/support/field_parts.h"
#include "tests/support/wander.h"

#include <catch2/catch.hpp>

#include <algorithm>
#include <array>
#include <vector>

namespace fulcrum {
namespace {

// What field sampling is made of, each class alone: one bumpy ball of points on another, of which the field is.
constexpr double kLeaf_us = 0.25;

const SampledPair& balls() {
    static const SampledPair kPair(
        std::make_shared<const DistanceField>(test::build_bumpy_field(64)),
        test::make_shell(*make_bumpy_sphere(1.0, 16, 0.03, 9.0), 20000));
    return kPair;
}

FieldSamplingSettings make_settings(double budget_us = 0.0) {
    return {.budget_us = budget_us,
            .clock = BudgetClock::counted,
            .leaf_us = kLeaf_us,
            .group_us = 0.05};
}

// Pressed in by `depth`, from any side.
Pose press(double depth, const Vector3& from = Vector3::UnitY()) {
    return Pose::at((2.0 - depth) * from);
}

// All leaves, and those of them that touch.
NodeList list_all() {
    ShellSearch search(balls());
    search.list_leaves(balls().shell->n_leaves());
    return search.nodes();
}
LeafSums take_all(const FieldLook& look) {
    LeafSums sums(balls(), make_settings());
    LookWork work;
    sums.begin();
    sums.take(look, list_all().all(), nullptr, work);
    sums.settle(look);
    return sums;
}
std::vector<std::int32_t> copy(const NodeList& list) {
    return {list.begin(), list.end()};
}

// The least F of a leaf's points, voxels.
float find_least_voxels(const FieldLook& look, std::size_t leaf) {
    std::array<float, kLeafPoints> values{};
    const ShellTree& shell = *look.pair.shell;
    look.pair.kernels->sample(look.pair.bounds.view, look.place, shell.points(0, leaf), kLeafPoints,
                              values.data(), nullptr);
    const auto n = static_cast<std::ptrdiff_t>(shell.count_in(0, leaf));
    return *std::min_element(values.begin(), values.begin() + n) * look.pair.bounds.voxels_per_step;
}

// A look with its time, the search done.
struct Rig {
    Rig(const Pose& X_OT, double budget_us)
        : at(balls(), X_OT), stages(balls(), make_settings(budget_us)), in(at, stages) {
        stages.time.begin();
        stages.sums.begin();
        stages.error.begin();
        stages.memory.advance(at);
    }
    FieldTouch tell() {
        stages.sums.settle(at);
        FieldTouch touch;
        touch.weight = stages.sums.weight();
        touch.n_touching = touch.weight * stages.sums.sums().n_touching;
        stages.error.tell(balls(), stages.sums, touch);
        return touch;
    }
    FieldLook at;
    LookStages stages;
    TimedLook in;
};

}  // namespace

TEST_CASE(
    "shell search: what is known to be free is not asked, and nothing that touches is missed") {
    FreeMemory memory(balls());
    ShellSearch known(balls());
    ShellSearch anew(balls());
    LeafSums sums(balls(), make_settings());
    Wanderer wanderer(3, 0.0004);
    LookWork work_known;
    LookWork work_anew;
    for (int i = 0; i < 100; ++i) {
        // Along the surface, in it and over it, and straight in from afar.
        const FieldLook look(balls(), i < 60 ? press(i / 20 == 1 ? -0.01 : 0.03, wanderer.next())
                                             : press(-0.6 + 0.017 * (i - 60)));
        memory.advance(look);
        known.search_known(look, memory, work_known);
        anew.search_anew(look, 0.0F, work_anew);
        // A leaf that touches is found either way.
        const std::vector<std::int32_t> touched = copy(take_all(look).touched());
        const auto has_all = [&](const NodeList& found) {
            return std::includes(found.begin(), found.end(), touched.begin(), touched.end());
        };
        REQUIRE(has_all(anew.nodes()));
        REQUIRE(has_all(known.nodes()));
        sums.begin();
        LookWork work;
        sums.take(look, known.nodes().all(), &memory, work);
        sums.settle(look);
        known.note_groups(memory);
        REQUIRE(copy(sums.touched()) == touched);
    }
    CHECK(2 * work_known.n_groups < work_anew.n_groups);
    // Where it stays nothing new is told of any ball, and of leaves those alone are due that touch.
    const FieldLook rest(balls(), press(0.03, wanderer.next()));
    for (int i = 0; i < 3; ++i) {
        memory.advance(rest);
        work_known = {};
        known.search_known(rest, memory, work_known);
        sums.begin();
        sums.take(rest, known.nodes().all(), &memory, work_known);
        sums.settle(rest);
        known.note_groups(memory);
    }
    CHECK(work_known.n_leaves <= static_cast<std::int64_t>(sums.touched().size()) + 3);
    memory.reset();
    known.search_known(rest, memory, work_known);
    anew.search_anew(rest, 0.0F, work_anew);
    CHECK(copy(known.nodes()) == copy(anew.nodes()));
}

TEST_CASE("seen leaves: never more is recalled of a leaf than its points have") {
    SeenLeaves seen(balls());
    MotionClock clock;
    Random random(5);
    Pose X_OT = press(-0.02);
    const double voxel_m = balls().field->frame().voxel_m;
    int n_recalled = 0;
    for (int i = 0; i < 200; ++i) {
        if (i % 10 == 0) {
            const FieldLook look(balls(), X_OT);
            clock.advance(X_OT, balls().shell->reach_m(), voxel_m);
            for (std::size_t leaf = 0; leaf < balls().shell->n_leaves(); ++leaf) {
                seen.remember(look, leaf, find_least_voxels(look, leaf), clock);
            }
        }
        X_OT.position += 0.1 * voxel_m * random.in_cube();
        X_OT.orientation = (random.turn(0.002) * X_OT.orientation).normalized();
        const FieldLook look(balls(), X_OT);
        clock.advance(X_OT, balls().shell->reach_m(), voxel_m);
        for (std::size_t leaf = 0; leaf < balls().shell->n_leaves(); ++leaf) {
            const float told = seen.recall(look, leaf, clock);
            n_recalled += told > 0.0F ? 1 : 0;
            // What is beyond the band is told to be at its end.
            if (told > 0.0F && find_least_voxels(look, leaf) < told) {
                FAIL("leaf " << leaf << " has " << find_least_voxels(look, leaf) << ", not "
                             << told);
            }
        }
    }
    CHECK(n_recalled > 10000);
    seen.forget();
    CHECK(seen.recall(FieldLook(balls(), X_OT), 0, clock) < 0.0F);
}

TEST_CASE("leaf sums: in parts as at once; a total that was told comes back as it was") {
    const FieldLook look(balls(), press(0.1));
    const LeafSums whole = take_all(look);
    LeafSums sums(balls(), make_settings(100.0));
    LookWork work;
    const NodeList all = list_all();
    sums.begin();
    for (std::size_t i = 0; i < all.size(); i += 7) {
        sums.take(look, all.all().subspan(i, std::min<std::size_t>(7, all.size() - i)), nullptr,
                  work);
    }
    sums.settle(look);
    CHECK(sums.sums().force == whole.sums().force);
    CHECK(sums.sums().n_touching == whole.sums().n_touching);
    CHECK(copy(sums.touched()) == copy(whole.touched()));
    CHECK(work.n_leaves == static_cast<std::int64_t>(all.size()));

    // Of a thinning each stands for four: a fourth of the points, a sum that is near.
    const LeafSums::Total total = sums.total();
    const auto take_thinned = [&] {
        sums.begin_anew(2);
        ShellSearch thinned(balls());
        thinned.list_leaves(balls().shell->n_leaves(2));
        sums.take(look, thinned.nodes().all(), nullptr, work);
        sums.settle(look);
    };
    take_thinned();
    CHECK(sums.weight() == 4);
    CHECK(4.0 * sums.sums().force.y() == Approx(whole.sums().force.y()).epsilon(0.05));
    CHECK(sums.spread().force_square > 0.0);
    CHECK(sums.touched().size() > total.n_touched);
    sums.go_back(total);
    CHECK(sums.weight() == 1);
    CHECK(sums.sums().force == whole.sums().force);
    CHECK(sums.least_steps() == whole.least_steps());
    CHECK(copy(sums.touched()) == copy(whole.touched()));
    take_thinned();
    sums.forget_before(total);
    CHECK(sums.touched().size() < total.n_touched);
    CHECK(sums.touched()[sums.touched().size() - 1] < balls().shell->n_leaves(2));
}

TEST_CASE("sample units: those that hold a leaf of the nodes, each once, and which are due") {
    constexpr std::size_t kLeaves = 300;
    const std::vector<std::vector<std::int32_t>> nodes_of{{0, 1, 5, 63, 64, 299}, {0, 3, 37}, {1}};
    for (std::size_t level = 0; level < nodes_of.size(); ++level) {
        NodeList nodes;
        nodes.reserve(kLeaves);
        for (const std::int32_t node : nodes_of[level]) {
            nodes.add(node);
        }
        for (std::size_t thinning = 0; thinning < 9; ++thinning) {
            const std::size_t n_units = (kLeaves + (std::size_t{1} << thinning) - 1) >> thinning;
            std::vector<float> until(n_units);
            std::vector<std::int32_t> wanted;
            std::vector<std::int32_t> wanted_due;
            for (std::size_t unit = 0; unit < n_units; ++unit) {
                until[unit] = unit % 3 == 0 ? 2.0F : 1.0F;
                const std::size_t first = unit << thinning;
                const std::size_t end = std::min((unit + 1) << thinning, kLeaves);
                const bool is_of = std::any_of(nodes.begin(), nodes.end(), [&](std::int32_t node) {
                    const auto from = static_cast<std::size_t>(node) << (3 * level);
                    return from < end && first < from + (std::size_t{1} << (3 * level));
                });
                if (is_of) {
                    wanted.push_back(static_cast<std::int32_t>(unit));
                    if (until[unit] <= 1.0F) {
                        wanted_due.push_back(wanted.back());
                    }
                }
            }
            const FreeLeaves known(until.data(), 1.0F);
            SampleUnits units;
            units.reserve(kLeaves);
            units.list(nodes, level, thinning, n_units, known);
            CHECK(copy(units.all()) == wanted);
            CHECK(copy(units.due()) == wanted_due);
            SampleUnits again;
            again.reserve(kLeaves);
            again.list_due(units.all(), known);
            CHECK(copy(again.due()) == wanted_due);
        }
    }
}

TEST_CASE("timed look: as many leaves as there is time for, and all others are left out") {
    Rig ample(press(0.05), 1.0e4);
    REQUIRE(ample.in.search() == 0);
    const std::size_t n_found = ample.in.found().size();
    ample.in.take_found();
    CHECK_FALSE(ample.stages.error.is_cut_short());
    CHECK(ample.tell().n_left == 0);
    CHECK(copy(ample.stages.sums.touched()) == copy(take_all(ample.at).touched()));

    Rig scarce(press(0.05), 1.0e4);
    REQUIRE(scarce.in.search() == 0);
    // The time for five leaves is left.
    scarce.stages.time.set_share((scarce.stages.time.elapsed_us() + 5.0 * kLeaf_us) / 1.0e4 +
                                 1.0e-9);
    scarce.in.take_found();
    CHECK(scarce.stages.error.is_cut_short());
    CHECK(scarce.stages.time.work().n_leaves == 5);
    const FieldTouch touch = scarce.tell();
    CHECK(touch.n_left == static_cast<std::int64_t>(n_found) - 5);
    CHECK(touch.bound_N > 0.0);

    // Of what was found, all is left out that may touch and was not taken.
    Rig other(press(0.05), 1.0e4);
    REQUIRE(other.in.search() == 0);
    other.in.leave_out_others(0, other.in.found());
    CHECK(other.tell().n_left == 0);
    NodeList some;
    some.reserve(n_found);
    some.copy(other.in.found());
    some.drop_first(3);
    other.in.leave_out_others(0, some);
    CHECK(other.tell().n_left == 3);
}

TEST_CASE("thinned look: samples stand for all where 64 touch, and for nothing where fewer do") {
    NodeList none;
    SampleUnits units;
    units.reserve(balls().n_most_nodes());
    ThinnedLook thinned;
    thinned.reserve(balls());
    Rig deep(press(0.3), 40.0);
    const std::size_t level = deep.in.search();
    REQUIRE(thinned.look(deep.in, level, units, none));
    const FieldTouch touch = deep.tell();
    CHECK(touch.weight > 1);
    CHECK(touch.error_N <= touch.bound_N);
    const LeafSums whole = take_all(deep.at);
    CHECK(static_cast<double>(touch.n_touching) ==
          Approx(static_cast<double>(whole.sums().n_touching)).epsilon(0.1));

    Rig shallow(press(0.03), 10.0);
    CHECK_FALSE(thinned.look(shallow.in, shallow.in.search(), units, none));
    CHECK(shallow.stages.sums.weight() == 1);
    CHECK(shallow.stages.sums.sums().n_touching == 0);
    CHECK(shallow.stages.error.miss().points == 0.0);
}

TEST_CASE(
    "deepest look: what touched last is looked at before all else, for as long as there is time") {
    const LeafSums whole = take_all(FieldLook(balls(), press(0.05)));
    DeepestLook deepest;
    deepest.reserve(balls());
    const auto find_taken = [&](const NodeList& touched_last) {
        Rig rig(press(0.05), 1.0e4);
        REQUIRE(rig.in.search() == 0);
        rig.stages.time.set_share((rig.stages.time.elapsed_us() + 4.0 * kLeaf_us) / 1.0e4 + 1.0e-9);
        deepest.look(rig.in, 0, touched_last);
        CHECK(rig.tell().n_left > 0);
        return copy(rig.in.found());
    };
    NodeList last;
    last.reserve(balls().n_most_nodes());
    const std::vector<std::int32_t> by_depth = find_taken(last);
    REQUIRE(by_depth.size() == 4);
    // Others than that, which touch as well.
    for (const std::int32_t leaf : whole.touched()) {
        if (last.size() < 4 &&
            std::find(by_depth.begin(), by_depth.end(), leaf) == by_depth.end()) {
            last.add(leaf);
        }
    }
    REQUIRE(last.size() == 4);
    CHECK(find_taken(last) == copy(last));
}

TEST_CASE(
    "step choice: looks of a step are at the leaves of its first one, which it alone chooses") {
    StepTime step(120.0, BudgetClock::counted);
    BudgetLook budget;
    budget.reserve(balls());
    const auto look = [&](double depth, StepTime* time) {
        Rig rig(press(depth), 20.0);
        rig.stages.time.begin_step(time, 1);
        rig.stages.time.begin();
        budget.look(rig.in, false);
        return rig.tell();
    };
    step.begin();
    budget.begin_step();
    const FieldTouch first = look(0.3, &step);
    REQUIRE(first.weight > 1);
    // Alone it would look at each point.
    CHECK(look(0.02, &step).weight == first.weight);
    budget.begin_step();
    CHECK(look(0.02, &step).weight == 1);
    // Where no time is shared each chooses for itself.
    budget.begin_step();
    CHECK(look(0.3, nullptr).weight > 1);
    CHECK(look(0.02, nullptr).weight == 1);
}

}  // namespace fulcrum
