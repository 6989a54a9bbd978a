#include "haptics/math/rotation.h"
#include "haptics/tool/god_object/god_allowed.h"
#include "haptics/tool/god_object/god_force.h"
#include "haptics/tool/god_object/god_pairs.h"
#include "haptics/tool/god_object/god_presses.h"
#include "haptics/tool/god_object/god_slips.h"
#include "tests/support/god_scene.h"

#include <catch2/catch.hpp>

#include <memory>

namespace fulcrum {
namespace {

// What a round of the god-object's motion is made of, each alone: a cube on a block whose top is y = 0.
constexpr double kSide_m = 0.04;
const MovingFrame kBlock{Pose::at({0.0, -0.02, 0.0}), {}};
const GodObjectSettings kSettings =
    test::make_god_settings(make_box_inertia(0.02, Vector3::Constant(kSide_m)));
const double kGap_m = kSettings.gap_m;
constexpr double kRounded_m = 1.0e-10;  // of gaps, and of what a solver holds to 1e-11 of its way

std::vector<GodObjectPlan> make_plans(const FrictionSettings& friction = {}) {
    GodObjectPlan plan{GodSurface::create(make_box({0.2, 0.04, 0.2}).value()),
                       GodSurface::create(test::make_cube(kSide_m))};
    plan.friction = friction;
    return {plan};
}

struct Round {
    explicit Round(double height_m, const FrictionSettings& friction = {})
        : plans(make_plans(friction)), pairs(plans, kSettings), slips(plans, kGap_m) {
        // Where a motion begins nothing is nearer than the gap at rest.
        const double began_m = 20.0 * kGap_m;
        pairs.place(Pose::at({0.01, 0.5 * kSide_m + began_m, 0.0}));
        REQUIRE(pairs.begin({&kBlock, 1}));
        pairs.set_goals({&kBlock, 1});
        go({0.0, height_m - began_m, 0.0});
        slips.forget(pairs);
    }
    [[nodiscard]] double height_m() const { return pairs.tool_W().position.y() - 0.5 * kSide_m; }
    void go(const Vector3& shift_W) {
        Vector6 way = Vector6::Zero();
        way.head<3>() = shift_W;
        pairs.advance(way, 1.0);
        pairs.look_on(shift_W.norm(), 1.0, false);
    }
    // Where the contacts let it go of a shift that is wanted.
    Vector3 allow(GodAllowed& allowed, const Vector3& shift_W) {
        Pose wanted_W = pairs.tool_W();
        wanted_W.position += shift_W;
        const Vector6 way = allowed.find(pairs, slips, wanted_W);
        CHECK(way.tail<3>().norm() < 1.0e-6);
        return way.head<3>();
    }

    std::vector<GodObjectPlan> plans;
    GodPairs pairs;
    GodSlips slips;
};

TEST_CASE("god pairs: a way ends at a quarter of the gap, to twice that, and is whole along it") {
    Round round(10.0 * kGap_m);
    CHECK(round.pairs.found().contacts == 0);
    CHECK(round.pairs.found().least_gap_m == kInfinity);
    Vector6 down = Vector6::Zero();
    down.y() = -20.0 * kGap_m;
    double least_m = kGap_m;  // what is nearer than the gap at rest comes down to a quarter of that
    for (int i = 0; i < 2; ++i) {
        const double share = round.pairs.find_free_share(down);
        CHECK_FALSE(round.pairs.is_cut());
        round.pairs.advance(down, share);
        CHECK(round.height_m() > 0.25 * least_m - kRounded_m);
        CHECK(round.height_m() < 0.5 * least_m + kRounded_m);
        round.pairs.look_on(-down.y(), share, false);
        CHECK(round.pairs.found().contacts == 4);
        CHECK(round.pairs.found().least_gap_m == Approx(round.height_m()).margin(kRounded_m));
        least_m = round.height_m();
    }
    Vector6 along = Vector6::Zero();
    along.x() = 0.01;
    CHECK(round.pairs.find_free_share(along) == 1.0);
}

TEST_CASE("god pairs: an object that touches turns by 0.02 rad a round, a free one at once") {
    MovingFrame turned = kBlock;
    turned.pose_W.orientation = compute_exp(Vector3(0.0, 0.1, 0.0));
    const auto find_turn = [&](Round& round) {
        round.pairs.set_goals({&turned, 1});
        return round.pairs.goal_W(0).orientation.angularDistance(
            round.pairs.object_W(0).orientation);
    };
    Round touching(kGap_m);
    CHECK(find_turn(touching) == Approx(0.02).epsilon(1.0e-9));
    CHECK_FALSE(touching.pairs.have_arrived());
    // Seen from what carries it the tool stands still.
    const Pose seen_OT = touching.pairs.seen_OT(0);
    const Vector6 carried = touching.pairs.find_carried();
    CHECK(touching.pairs.find_free_share(carried) == 1.0);
    touching.pairs.advance(carried, 1.0);
    CHECK((touching.pairs.seen_OT(0).position - seen_OT.position).norm() < 1.0e-15);
    CHECK(touching.pairs.have_arrived());
    CHECK_FALSE(touching.pairs.are_at({&turned, 1}));
    // One that waits is not where it is said to be.
    (void)find_turn(touching);
    touching.pairs.wait();
    CHECK(touching.pairs.have_arrived());
    Round away(10.0 * kGap_m);
    CHECK(find_turn(away) == Approx(0.1).epsilon(1.0e-9));
    away.pairs.advance(Vector6::Zero(), 1.0);
    CHECK(away.pairs.are_at({&turned, 1}));
}

TEST_CASE("god allowed: down to the gap at rest, back up to it, along it freely") {
    const Vector3 wanted_W(3.0e-4, -5.0e-4, 1.0e-4);
    for (const double gaps : {0.5, 1.0, 3.0}) {
        CAPTURE(gaps);
        Round round(gaps * kGap_m);
        GodAllowed allowed(round.plans, kSettings);
        const Vector3 way_W = round.allow(allowed, wanted_W);
        CHECK(way_W.x() == Approx(wanted_W.x()).margin(kRounded_m));
        CHECK(way_W.y() == Approx((1.0 - gaps) * kGap_m).margin(kRounded_m));
        CHECK(way_W.z() == Approx(wanted_W.z()).margin(kRounded_m));
        // What is still away from the tool does not hold it.
        CHECK(allowed.is_held(round.pairs) == (gaps < 2.0));
    }
    // An object that rises takes it along.
    Round round(kGap_m);
    GodAllowed allowed(round.plans, kSettings);
    MovingFrame raised = kBlock;
    raised.pose_W.position.y() += 2.0e-5;
    round.pairs.set_goals({&raised, 1});
    CHECK(round.allow(allowed, wanted_W).y() == Approx(2.0e-5).margin(kRounded_m));
}

TEST_CASE("god allowed: along itself a contact holds by its coefficient of what it pushes") {
    const Vector3 wanted_W(1.0e-4, -3.0e-4, 0.0);
    for (const double friction : {0.2, 0.5}) {
        CAPTURE(friction);
        Round round(kGap_m, {.static_coefficient = friction, .dynamic_coefficient = friction});
        GodAllowed allowed(round.plans, kSettings);
        const double left_m = std::max(wanted_W.x() + friction * wanted_W.y(), 0.0);
        CHECK(round.allow(allowed, wanted_W).x() == Approx(left_m).margin(kRounded_m));
    }
}

TEST_CASE("god allowed: what held it is recalled out of sight, until it acts no more") {
    const Vector3 down_W(0.0, -20.0 * kGap_m, 0.0);
    const Vector3 along_W(20.0 * kGap_m, 0.0, 0.0);
    Round round(kGap_m);
    GodAllowed allowed(round.plans, kSettings);
    (void)round.allow(allowed, down_W);
    CHECK_FALSE(allowed.recalls());
    allowed.recall(round.pairs);
    REQUIRE(allowed.recalls());
    round.go({0.0, 10.0 * kGap_m, 0.0});
    REQUIRE(round.pairs.found().contacts == 0);
    CHECK(round.allow(allowed, down_W).y() == Approx(-10.0 * kGap_m).margin(kRounded_m));
    allowed.forget_idle(round.pairs);
    CHECK(allowed.recalls());
    CHECK((round.allow(allowed, along_W) - along_W).norm() < kRounded_m);
    allowed.forget_idle(round.pairs);
    CHECK_FALSE(allowed.recalls());
    CHECK((round.allow(allowed, down_W) - down_W).norm() < kRounded_m);
}

TEST_CASE("god slips: static until a step goes a thousandth of the gap along, and again at rest") {
    constexpr double kStatic = 0.6;
    constexpr double kDynamic = 0.4;
    Round round(kGap_m, {.static_coefficient = kStatic, .dynamic_coefficient = kDynamic});
    const auto find_after = [&](const Vector3& shift_W) {
        round.go(shift_W);
        round.slips.note(round.pairs);
        return round.slips.find_friction(0, round.pairs.all()[0].contacts()[0]);
    };
    CHECK(find_after({0.0, 0.0, 0.0}) == kStatic);
    CHECK(find_after({0.9e-3 * kGap_m, 0.0, 0.0}) == kStatic);
    CHECK(find_after({1.1e-3 * kGap_m, 0.0, 0.0}) == kDynamic);
    CHECK(find_after({0.0, 0.5 * kGap_m, 0.0}) == kStatic);
    CHECK(find_after({0.0, 0.0, 0.01}) == kDynamic);
    CHECK((round.slips.over(0).to_OT.position - round.slips.over(0).from_OT.position -
           Vector3(0.0, 0.0, 0.01))
              .norm() < 1.0e-15);
    round.slips.forget(round.pairs);
    CHECK(round.slips.find_friction(0, round.pairs.all()[0].contacts()[0]) == kStatic);
}

TEST_CASE("god presses: from two gaps on down to one a contact begins to press, evenly") {
    const auto set = std::make_unique<GodContactSet>();
    for (const double gaps : {0.5, 1.25, 1.75, 2.1}) {
        CAPTURE(gaps);
        const Round round(gaps * kGap_m);
        const GodPresses presses(round.plans, kGap_m);
        presses.tell_presses(round.pairs, round.slips, *set);
        CHECK(set->n == (gaps < 2.0 ? 4 : 0));
        for (const GodPress& press : set->all()) {
            CHECK(press.share == Approx(std::min(2.0 - gaps, 1.0)).margin(1.0e-4));
            CHECK(press.least_m == Approx(std::min(1.0 - gaps, 0.0) * kGap_m).margin(kRounded_m));
        }
    }
}

TEST_CASE("god presses: near is within sixteen gaps, where that is asked or a contact is there") {
    const auto is_near = [](double gaps, bool asks_near) {
        Round round(gaps * kGap_m);
        GodPresses presses(round.plans, kGap_m);
        const auto set = std::make_unique<GodContactSet>();
        presses.look(round.pairs, asks_near);
        presses.tell_places(round.pairs, round.slips, *set);
        CHECK(set->tool_W.position == round.pairs.tool_W().position);
        CHECK(set->objects[0].object_W.position == kBlock.pose_W.position);
        return set->is_near;
    };
    CHECK(is_near(3.0, false));
    CHECK_FALSE(is_near(15.0, false));
    CHECK(is_near(15.0, true));
    CHECK_FALSE(is_near(17.0, true));
}

}  // namespace
}  // namespace fulcrum
