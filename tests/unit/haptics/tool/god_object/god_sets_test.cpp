#include "haptics/geometry/shape.h"
#include "haptics/math/rotation.h"
#include "haptics/tool/god_object/god_force.h"
#include "haptics/tool/god_object/god_front.h"
#include "tests/support/bad_numbers.h"
#include "tests/support/wander.h"

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

using namespace fulcrum;

namespace {

using Indices = std::set<std::pair<std::int32_t, std::int32_t>>;

struct Scene {
    std::shared_ptr<const SweptMesh> object = SweptMesh::create(make_sphere(0.03, 7).value());
    std::shared_ptr<const SweptMesh> tool = SweptMesh::create(make_box({0.04, 0.02, 0.03}).value());

    [[nodiscard]] GodFront make_front(int most = 4096) const { return {*object, *tool, most}; }
    [[nodiscard]] GodPlace place(const Pose& X_OT) const {
        return GodPlace::of(*object, *tool, X_OT);
    }
    [[nodiscard]] double find_distance_m(std::int32_t i, std::int32_t j, const Pose& X_OT) const {
        return find_nearest_features(object->triangle(i), place(X_OT).corners(tool->triangle(j)))
            .distance_m;
    }
    // Of all triangles.
    [[nodiscard]] Indices find_within(const Pose& X_OT, double within_m) const {
        Indices found;
        for (std::int32_t i = 0; i < object->n_triangles(); ++i) {
            for (std::int32_t j = 0; j < tool->n_triangles(); ++j) {
                if (find_distance_m(i, j, X_OT) <= within_m) {
                    found.emplace(i, j);
                }
            }
        }
        return found;
    }
};

Indices told_by(const GodFront& front) {
    Indices told;
    for (const std::int32_t i : front.near()) {
        const auto [at, is_new] =
            told.emplace(front.pair(i).object_triangle, front.pair(i).tool_triangle);
        CHECK(is_new);  // each once
    }
    return told;
}

// A walk round the ball, now short steps and now long ones, sometimes away.
Pose walk(Random& random, const Pose& at, double step_m) {
    Pose to = at;
    to.position += step_m * random.in_cube();
    to.orientation = (compute_exp(20.0 * step_m * random.in_cube()) * at.orientation).normalized();
    if (const double away_m = to.position.norm(); away_m > 0.07 || away_m < 0.035) {
        to.position *= 0.05 / away_m;
    }
    return to;
}

constexpr double kStiffness = 400.0;
constexpr double kDt_s = 0.001;
constexpr double kFade_s = 0.02;
constexpr double kDepth_m = 0.003;
const Pose kPressed = Pose::at({0.0, -kDepth_m, 0.0});
const Vector3 kUp = Vector3::UnitY();

GodForce make_force(double share = 0.5, double fade_s = kFade_s) {
    return {{.inertia = make_box_inertia(0.1, {0.1, 0.2, 0.3}),
             .stiffness_N_per_m = kStiffness,
             .step_share = share,
             .fade_s = fade_s},
            64};
}

// On a floor, held below it: three contacts round the centre.
void put_on_floor(GodForce& force) {
    force.begin(Pose{});
    for (const double angle : {0.0, 2.1, 4.2}) {
        REQUIRE(force.add({0.05 * std::cos(angle), -0.05, 0.05 * std::sin(angle)}, kUp, 0.0));
    }
}

// The next set of contacts, blended in beside something or with nothing near; what is felt before and after.
struct Change {
    Wrench before, after;
    [[nodiscard]] double step_N() const { return (after.force - before.force).norm(); }
};

template <class Put>
Change change_set(GodForce& force, const Pose& handle, Put put, bool is_near = true) {
    const Wrench before = force.compute(handle);
    force.keep(handle);
    put(force);
    force.blend(handle, kDt_s, is_near);
    return {before, force.compute(handle)};
}

void put_nothing(GodForce& force) {
    force.begin(Pose{});
}

}  // namespace

TEST_CASE("god front: of all triangles none that is near is left out, on any walk") {
    const Scene scene;
    GodFront front = scene.make_front();
    Random random(5);
    Pose at = Pose::at({0.0, 0.05, 0.0});
    std::size_t n_found = 0;
    for (int k = 0; k < 400; ++k) {
        at = walk(random, at, k % 50 == 0 ? 0.05 : 0.0005);
        const double reach_m = 0.0005 * (1 + k % 7);
        REQUIRE(front.look(scene.place(at), reach_m) == GodLook::whole);
        const Indices told = told_by(front);
        const Indices found = scene.find_within(at, reach_m);
        n_found += found.size();
        REQUIRE(std::ranges::includes(told, found));
        if (k % 3 == 0) {
            for (const std::int32_t i : front.near()) {
                front.aim(i, scene.place(at));
            }
        }
        front.tidy(scene.place(at), 4.0 * reach_m);
    }
    CHECK(n_found > 400);
}

TEST_CASE("god front: no direction tells more than the distance, and one that was aimed tells it") {
    const Scene scene;
    Random random(6);
    for (int k = 0; k < 30; ++k) {
        GodFront front = scene.make_front();
        const Pose at{Vector3(0.06 * random.in_cube().normalized()),
                      compute_exp(2.0 * random.in_cube())};
        const GodPlace place = scene.place(at);
        REQUIRE(front.look(place, 0.004) == GodLook::whole);
        for (const std::int32_t i : front.near()) {
            const GodNear& near = front.pair(i);
            const double distance_m =
                scene.find_distance_m(near.object_triangle, near.tool_triangle, at);
            const Triangle own = scene.tool->triangle(near.tool_triangle);
            CHECK(find_apart_m(near, own, place) <= distance_m);
            front.aim(i, place);
            if (distance_m > 1.0e-6) {
                CHECK(find_apart_m(near, own, place) <= distance_m);
                CHECK(find_apart_m(near, own, place) >= distance_m - 3.0 * place.rounded_m);
            }
        }
    }
}

TEST_CASE("god front: what has come apart goes from it again") {
    const Scene scene;
    GodFront front = scene.make_front();
    const Pose near_by = Pose::at({0.0, 0.0401, 0.0});
    REQUIRE(front.look(scene.place(near_by), 0.003) == GodLook::whole);
    const std::size_t many = front.size();
    CHECK(many > 20);
    CHECK_FALSE(front.near().empty());
    const Pose far_off = Pose::at({0.0, 1.0, 0.0});
    for (int k = 0; k < 200; ++k) {
        REQUIRE(front.look(scene.place(far_off), 0.003) == GodLook::whole);
        CHECK(front.near().empty());
        front.tidy(scene.place(far_off), 0.01);
    }
    CHECK(front.size() == 2);  // the roots
    // And comes back.
    REQUIRE(front.look(scene.place(near_by), 0.003) == GodLook::whole);
    CHECK(std::ranges::includes(told_by(front), scene.find_within(near_by, 0.003)));
}

TEST_CASE("god front: without room, and at places that are none, all is forgotten and told") {
    const Scene scene;
    GodFront front = scene.make_front(8);
    const Pose near_by = Pose::at({0.0, 0.0401, 0.0});
    CHECK(front.look(scene.place(near_by), 0.003) == GodLook::no_room);
    REQUIRE(front.look(scene.place(Pose::at({0.0, 1.0, 0.0})), 0.003) == GodLook::whole);
    CHECK(front.near().empty());
    CHECK(front.look(scene.place(Pose::at({kNan, 0.0, 0.0})), 0.003) == GodLook::no_room);
    REQUIRE(front.look(scene.place(Pose::at({0.0, 1.0, 0.0})), 0.003) == GodLook::whole);
    CHECK(front.memory_bytes() > 0);
    // Standing still uses nothing up, for however long.
    GodFront still = scene.make_front();
    REQUIRE(still.look(scene.place(near_by), 1.0e-5) == GodLook::whole);
    const Indices told = told_by(still);
    for (int k = 0; k < 1000; ++k) {
        REQUIRE(still.look(scene.place(near_by), 1.0e-5) == GodLook::whole);
    }
    CHECK(told_by(still) == told);
}

TEST_CASE("god force: stiffness times depth, beside contacts nothing; first the way there") {
    for (const double share : {0.1, 0.5, 1.0}) {
        GodForce force = make_force(share);
        force.begin(Pose{});
        CHECK(force.compute(Pose::at({1.0, 2.0, 3.0})).force == Vector3::Zero());
        put_on_floor(force);
        const Wrench pressed = force.compute(Pose::at({0.02, -kDepth_m, 0.01}));
        CHECK((pressed.force - kStiffness * kDepth_m * kUp).norm() < 1.0e-12);
        CHECK(pressed.torque.norm() < 1.0e-12);
        const double sum_N = (force.force_W(0) + force.force_W(1) + force.force_W(2)).y();
        CHECK(sum_N == Approx(kStiffness * kDepth_m));
        CHECK(force.compute(Pose::at({0.02, kDepth_m, 0.01})).force == Vector3::Zero());
        CHECK(force.force_W(0) == Vector3::Zero());
    }
    GodForce force = make_force(1.0);
    force.begin(Pose{});
    REQUIRE(force.add({0.0, -0.05, 0.0}, kUp, -0.001));
    CHECK(force.compute(Pose::at({0.0, -0.001, 0.0})).force == Vector3::Zero());
    CHECK(force.compute(Pose::at({0.0, -0.003, 0.0})).force.y() == Approx(kStiffness * 0.002));
}

TEST_CASE("god force: a new set goes on from the last force, what touches again fades on") {
    GodForce force = make_force();
    force.begin(Pose{});
    const double whole_N = kStiffness * kDepth_m;
    double kept = 1.0;
    for (int i = 0; i < 100; ++i) {
        const double felt_N = change_set(force, kPressed, put_on_floor).after.force.y();
        kept *= std::exp(-kDt_s / kFade_s);
        CHECK(felt_N == Approx(whole_N * (1.0 - kept)).epsilon(1.0e-9));
    }
    // What the handle changes comes at once.
    const double now_N = force.compute(kPressed).force.y();
    CHECK(force.compute(Pose::at({0.0, -kDepth_m - 0.001, 0.0})).force.y() ==
          Approx(now_N + kStiffness * 0.001));
    force = make_force();
    put_on_floor(force);
    for (int n = 0; n < 100; ++n) {
        const auto put = n % 2 == 1 ? put_on_floor : put_nothing;
        CHECK(change_set(force, kPressed, put).step_N() <=
              1.01 * kStiffness * kDepth_m * kDt_s / kFade_s);
    }
    const Pose from{Vector3(0.1, -0.2, 0.3), compute_exp(Vector3(0.4, 0.5, -0.6))};
    Vector6 way;
    way << 0.3, 0.1, -0.7, 1.0, -0.5, 2.0;
    CHECK((find_way(from, go_along(from, way)) - way).norm() < 1.0e-14);
    CHECK(find_way(from, from).norm() < 1.0e-15);
}

TEST_CASE("god force: a new set that pushes the other way, and less, goes on from the one before") {
    GodForce force = make_force();
    const Pose handle = Pose::at({0.0, -kDepth_m, 0.001});
    put_on_floor(force);
    const Change other = change_set(force, handle, [](GodForce& to) {
        to.begin(Pose{});
        REQUIRE(to.add({0.0, 0.0, 0.05}, -Vector3::UnitZ(), 0.0));
    });
    const double kept = std::exp(-kDt_s / kFade_s);
    const Vector3 now = -kStiffness * 0.001 * Vector3::UnitZ();
    CHECK((other.after.force - (now + kept * (other.before.force - now))).norm() < 1.0e-9);
    // Taken back, what is taken of the push goes with it.
    force.begin(Pose{});
    REQUIRE(force.add({0.0, 0.05, 0.0}, -kUp, -2.0 * kDepth_m));
    REQUIRE(force.add({0.0, -0.05, 0.0}, -kUp, -2.0 * kDepth_m));
    const Change back = change_set(force, handle, [](GodForce& to) {
        to.begin(Pose::at({0.0, -kDepth_m - 0.0001, 0.001}));
        REQUIRE(to.add({0.0, 0.05, 0.0}, -kUp, 0.0));
    });
    CHECK(back.step_N() < 1.01 * (1.0 - kept) * (back.before.force.norm() + kStiffness * 0.0001));
}

TEST_CASE("god force: lifted nothing pulls, and where nothing is near all ends within 10 ms") {
    GodForce force = make_force();
    force.begin(Pose{});
    (void)change_set(force, kPressed, put_on_floor);
    for (int i = 0; i <= 30; ++i) {
        const Wrench felt = force.compute(Pose::at({0.0, -kDepth_m + 0.0002 * i, 0.0}));
        CHECK(felt.force.y() >= -1.0e-15);
    }
    CHECK(force.compute(Pose::at({0.0, 0.001, 0.0})).force == Vector3::Zero());
    force = make_force();
    const Pose handle{Vector3(0.0, -kDepth_m, 0.0), compute_exp(Vector3(0.1, 0.0, 0.0))};
    put_on_floor(force);
    const Wrench pressed = force.compute(handle);
    REQUIRE(pressed.force.norm() > 1.0);
    REQUIRE(pressed.torque.norm() > 1.0e-3);
    for (int n = 1; n <= 12; ++n) {
        const Change off = change_set(force, handle, put_nothing, false);
        CAPTURE(n);
        CHECK(off.step_N() <= 0.101 * pressed.force.norm());
        CHECK((n < 10) == (off.after.force != Vector3::Zero()));
        CHECK((n < 10) == (off.after.torque != Vector3::Zero()));
    }
    // Nothing of it comes back beside the next thing.
    CHECK(change_set(force, Pose{}, put_on_floor).after.force.norm() < 1.0e-12);
}

// A floor that leans, so that a set turns the force by `turn_rad`.
TEST_CASE("god force: what turns from facet to facet is felt at once, what turns farther fades") {
    for (const double turn_rad : {0.02, 0.1, 0.35, 0.5}) {
        GodForce force = make_force();
        put_on_floor(force);
        const Vector3 normal(std::sin(turn_rad), std::cos(turn_rad), 0.0);
        const Change turned = change_set(force, kPressed, [&](GodForce& to) {
            to.begin(Pose{});
            REQUIRE(to.add({0.0, 0.0, 0.0}, normal, 0.0));
        });
        const Vector3 wanted_N = kStiffness * kDepth_m * normal.y() * normal;
        const double whole_N = (wanted_N - turned.before.force).norm();
        CAPTURE(turn_rad);
        if (turn_rad < 0.4) {
            CHECK((turned.after.force - wanted_N).norm() < 1.0e-9);
        } else {
            CHECK(turned.step_N() < 1.01 * whole_N * kDt_s / kFade_s);
        }
    }
}

TEST_CASE("god force: a tool that slips free beside something fades in 5 ms and the fade's time") {
    GodForce force = make_force();
    put_on_floor(force);
    double last_N = force.compute(kPressed).force.norm();
    double left_N = last_N;  // after 5 ms
    for (int n = 1; n <= 40; ++n) {
        const double now_N = change_set(force, kPressed, put_nothing).after.force.norm();
        CAPTURE(n);
        CHECK(now_N <= last_N);
        // As a set of contacts that is replaced fades; then evenly.
        left_N = n <= 5 ? now_N : left_N;
        const double most_N = n <= 5 ? last_N * kDt_s / kFade_s : left_N * kDt_s / kFade_s;
        CHECK(last_N - now_N <= 1.01 * most_N);
        CHECK((n < 25 ? now_N > 0.0 : now_N == 0.0));
        last_N = now_N;
    }
    // At once where nothing is to fade.
    GodForce hard = make_force(0.5, 0.0);
    put_on_floor(hard);
    CHECK(change_set(hard, kPressed, put_nothing).after.force == Vector3::Zero());
}
