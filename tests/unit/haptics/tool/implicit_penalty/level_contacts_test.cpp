#include "haptics/tool/implicit_penalty/level_contacts.h"

#include "haptics/geometry/shape.h"
#include "haptics/math/rotation.h"
#include "haptics/tool/implicit_penalty/contact_clusters.h"
#include "haptics/tool/implicit_penalty/implicit_penalty.h"
#include "tests/support/jaws.h"
#include "tests/support/refused.h"

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

using namespace fulcrum;

namespace {

constexpr double kWithin_m = 1.0e-3;

std::shared_ptr<const ContactLevels> make_levels(const TriangleMesh& mesh) {
    return ContactLevels::create(mesh, {.within_m = kWithin_m}).value();
}

}  // namespace

TEST_CASE("level contacts: clusters of a box that is pressed into the ground hold it evenly") {
    const auto ground = make_levels(make_box({0.3, 0.02, 0.3}).value());
    const auto box = make_levels(make_box({0.06, 0.04, 0.06}).value());
    auto finder = LevelContacts::create(ground, box).value();
    BoundedList<NearContact> near(512);
    ContactClusters clusters({.within_m = kWithin_m, .radius_m = 0.015, .most = 10, .fade_s = 0.0});
    for (int i = 0; i < 50; ++i) {
        const double depth_m = 1.0e-5 * i;
        const Pose X_OT = Pose::at({0.01, 0.03 - depth_m, 0.02});
        near.clear();
        finder->find(X_OT, kWithin_m, near);
        clusters.update(near.all(), X_OT, 0.001);
        REQUIRE(clusters.all().size() >= 4);
        Vector3 force = Vector3::Zero();
        Vector3 torque = Vector3::Zero();
        for (const ContactCluster& cluster : clusters.all()) {
            CHECK(cluster.normal_O.y() > 0.9999);
            CHECK(std::abs(cluster.depth_m - depth_m) < 1.0e-6);
            force += cluster.depth_m * cluster.normal_O;
            torque += cluster.point_T.cross(cluster.depth_m * cluster.normal_O);
        }
        // Of those that lie in the middle there may be one: it adds no torque.
        CHECK(torque.norm() < 0.1 * 0.03 * force.norm() + 1.0e-12);
    }
}

TEST_CASE(
    "level contacts: points lie on the tool, and the object's surface at depth along the normal") {
    constexpr double kRadius_m = 0.05;
    const auto ball = make_levels(make_sphere(kRadius_m, 24).value());
    auto finder = LevelContacts::create(ball, ball).value();
    CHECK(finder->reach_m() == Approx(kRadius_m).epsilon(1.0e-3));
    CHECK(finder->memory_bytes() > ball->memory_bytes());
    BoundedList<NearContact> near(64);
    for (const double gap_m : {0.5e-3, 0.1e-3, -0.5e-3}) {
        const Pose X_OT{{0.0, 2.0 * kRadius_m + gap_m, 0.0},
                        compute_exp(Vector3(1.0, 0.3, std::numbers::pi))};
        near.clear();
        finder->find(X_OT, kWithin_m, near);
        REQUIRE(near.count() >= 1);
        for (const NearContact& one : near.all()) {
            const Vector3 p_O = X_OT * one.point_T;
            CHECK(std::abs(one.point_T.norm() - kRadius_m) < 5.0e-4);
            CHECK(std::abs((p_O + one.depth_m * one.normal_O).norm() - kRadius_m) < 5.0e-4);
        }
    }
}

namespace {

constexpr double kPull_N_per_m = 500.0;
constexpr double kPush_N_per_m = 20000.0;  // of a cluster, from `within_m` outside on

// What a hand feels that draws the tool along a way, at the balance of coupling and clusters.
class Pressed {
  public:
    Pressed(std::unique_ptr<LevelContacts> finder, double within_m, const Vector3& place)
        : finder_(std::move(finder)),
          within_m_(within_m),
          clusters_({.within_m = within_m, .radius_m = 0.006, .most = 10, .fade_s = 0.0}),
          place_(place) {}

    Vector3 follow(const Pose& hand) {
        for (int i = 0; i < 6; ++i) {
            const Pose here{place_, hand.orientation};
            near_.clear();
            finder_->find(here, within_m_, near_);
            clusters_.update(near_.all(), here, 0.001);
            Vector3 force = kPull_N_per_m * (hand.position - place_);
            double stiffness = kPull_N_per_m;
            for (const ContactCluster& cluster : clusters_.all()) {
                force += kPush_N_per_m * cluster.strength *
                         std::max(cluster.depth_m + within_m_, 0.0) * cluster.normal_O;
                stiffness += kPush_N_per_m;
            }
            const Vector3 step = force / stiffness;
            place_ +=
                step.norm() > 0.5 * within_m_ ? Vector3(0.5 * within_m_ * step.normalized()) : step;
        }
        return kPull_N_per_m * (place_ - hand.position);
    }

  private:
    std::unique_ptr<LevelContacts> finder_;
    double within_m_;
    BoundedList<NearContact> near_{1 << 13};
    ContactClusters clusters_;
    Vector3 place_;
};

}  // namespace

TEST_CASE("level contacts: jaws hold a bite, with a tolerance as without") {
    constexpr double kNear_m = 0.5e-3;
    const TriangleMesh jaw = test::make_jaw(80, 32).value();
    const auto levels = ContactLevels::create(jaw, {.within_m = kNear_m}).value();
    const auto press = [&](double share) {
        return Pressed(
            LevelContacts::create(levels, levels, {.tolerance_m = share * levels->size_m()})
                .value(),
            kNear_m, {0.0, 0.022, 0.0});
    };
    Pressed exact = press(0.0);
    Pressed coarse = press(0.025);
    Pressed coarsest = press(0.1);
    double off = 0.0;
    double off_coarsest = 0.0;
    double felt = 0.0;
    for (int i = 0; i < 120; ++i) {
        const double t = i / 120.0;
        const double down = std::min(4.0 * t, 1.0);
        const double u = std::max(0.0, t - 0.25);
        const Pose hand{
            {0.004 * std::sin(12.0 * u), 0.022 - 0.009 * down, 0.003 * std::sin(9.0 * u)},
            compute_exp(Vector3(0.0, 0.15 * std::sin(6.0 * u), 0.0)) *
                compute_exp(Vector3(0.05 * std::sin(10.0 * u), 0.0, std::numbers::pi))};
        const Vector3 exact_N = exact.follow(hand);
        felt += exact_N.squaredNorm();
        off += (coarse.follow(hand) - exact_N).squaredNorm();
        off_coarsest += (coarsest.follow(hand) - exact_N).squaredNorm();
    }
    CHECK(std::sqrt(felt / 120.0) > 2.0);
    CHECK(std::sqrt(off / felt) < 0.025);
    CHECK(std::sqrt(off_coarsest / felt) < 0.1);
}

TEST_CASE("level contacts: lists get an even share; a tool needs levels made as far as it looks") {
    const auto bumpy = make_levels(make_bumpy_sphere(0.05, 16, 0.05, 100.0).value());
    auto finder = LevelContacts::create(bumpy, bumpy).value();
    const Pose X_OT = Pose::at({0.0, 0.099, 0.0});
    BoundedList<NearContact> all(4096);
    finder->find(X_OT, kWithin_m, all);
    REQUIRE(all.count() > 10);
    BoundedList<NearContact> few(4);
    finder->find(X_OT, kWithin_m, few);
    CHECK(few.count() >= 2);
    CHECK(few.count() <= 4);
    const std::size_t n_before = few.count();
    BoundedList<NearContact> none(0);
    finder->find(X_OT, kWithin_m, none);
    CHECK(none.count() == 0);
    CHECK(few.count() == n_before);
    CHECK(finder->answer().n_looked_at > 0);
    CHECK_FALSE(LevelContacts::create(nullptr, bumpy));
    const auto box = make_levels(make_box({0.04, 0.04, 0.04}).value());
    ImplicitPenaltyPlan plan;
    plan.meshes.push_back({box, box, {}});
    plan.settings.inertia = make_box_inertia(0.05, {0.04, 0.04, 0.04});
    plan.settings.clusters.within_m = kWithin_m;
    plan.settings.contacts.within_m = 0.25 * kWithin_m;
    CHECK(ImplicitPenaltyTool::build(plan));
    plan.settings.clusters.within_m = 1.5 * kWithin_m;
    CHECK(is_refused(ImplicitPenaltyTool::build(plan), "within_m"));
    plan.meshes.front().tool = nullptr;
    CHECK_FALSE(ImplicitPenaltyTool::build(plan));
}

TEST_CASE(
    "level contacts: one wholly inside the other is enclosed, either way, and nothing else is") {
    const TriangleMesh small = make_box({0.02, 0.02, 0.02}).value();
    const TriangleMesh large = make_box({0.2, 0.2, 0.2}).value();
    const auto clusters = [](const TriangleMesh& mesh) {
        return std::make_shared<const TriangleClusters>(mesh);
    };
    LevelContactsPlan plan{make_levels(large), make_levels(small), {}};
    const auto silent = LevelContacts::create(plan).value();
    CHECK_FALSE(silent->is_enclosed(Pose::at({0.01, 0.02, 0.03})));
    plan.object_solid = clusters(large);
    plan.tool_solid = clusters(small);
    const auto inside = LevelContacts::create(plan).value();
    CHECK(inside->is_enclosed(Pose::at({0.01, 0.02, 0.03})));
    CHECK_FALSE(inside->is_enclosed(Pose::at({0.0, 0.15, 0.0})));
    std::swap(plan.object, plan.tool);
    std::swap(plan.object_solid, plan.tool_solid);
    const auto round = LevelContacts::create(plan).value();
    CHECK(round->is_enclosed(Pose::at({0.01, 0.02, 0.03})));
    CHECK_FALSE(round->is_enclosed(Pose::at({0.0, 0.15, 0.0})));
    // A tool is told so before it is let in; found by points it knows by its depth.
    ImplicitPenaltyPlan whole;
    whole.meshes.push_back(plan);
    whole.settings.inertia = make_box_inertia(0.05, {0.2, 0.2, 0.2});
    whole.settings.clusters.within_m = kWithin_m;
    whole.settings.contacts.within_m = 0.25 * kWithin_m;
    for (const bool own_rounds : {true, false}) {
        whole.settings.own_rounds = own_rounds;
        auto tool = ImplicitPenaltyTool::build(whole).value();
        const auto is_free_at = [&](double y_m) {
            const MovingFrame object;
            tool.place(Pose::at({0.0, y_m, 0.0}));
            return tool.is_free({&object, 1});
        };
        CHECK_FALSE(is_free_at(0.0));
        CHECK_FALSE(is_free_at(0.11));
        CHECK_FALSE(is_free_at(0.1101));
        CHECK(is_free_at(0.1105));
        CHECK(is_free_at(0.2));
    }
}

TEST_CASE("level contacts: the shorter of both budgets counts, and what it cost is said") {
    const auto bumpy = make_levels(make_bumpy_sphere(0.05, 24, 0.05, 100.0).value());
    LevelContactsPlan plan{bumpy, bumpy, {}};
    const Pose X_OT = Pose::at({0.0, 0.099, 0.0});
    BoundedList<NearContact> near(4096);
    const auto ask = [&](double own_us, double given_us) {
        plan.settings.budget_us = own_us;
        auto finder = LevelContacts::create(plan).value();
        finder->limit(given_us);
        near.clear();
        finder->find(X_OT, kWithin_m, near);
        return finder->is_cut();
    };
    CHECK_FALSE(ask(0.0, 0.0));
    const std::size_t n_all = near.count();
    CHECK(ask(1.0e-3, 0.0));
    CHECK(near.count() > 0);  // coarser, and not nothing
    CHECK(near.count() <= n_all);
    CHECK(ask(0.0, 1.0e-3));
    CHECK(ask(1.0e6, 1.0e-3));
    CHECK(ask(1.0e-3, 1.0e6));
    CHECK_FALSE(ask(1.0e6, 1.0e6));
    CHECK(near.count() == n_all);
}
