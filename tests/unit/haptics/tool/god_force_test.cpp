#include "haptics/tool/god_force.h"

#include <catch2/catch.hpp>

#include <cmath>

namespace fulcrum {
namespace {

constexpr double kStiffness = 400.0;
constexpr double kDt_s = 0.001;
constexpr double kFade_s = 0.02;
constexpr double kDepth_m = 0.003;
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
    put(force);
    force.blend(before, handle, kDt_s, is_near);
    return {before, force.compute(handle)};
}

void put_nothing(GodForce& force) {
    force.begin(Pose{});
}

const Pose kPressed = Pose::at({0.0, -kDepth_m, 0.0});

TEST_CASE(
    "god force: at a wall it is stiffness times depth, beside contacts nothing, at any share") {
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
}

TEST_CASE("god force: a contact that is a little away lets the tool go there first") {
    GodForce force = make_force(1.0);
    force.begin(Pose{});
    REQUIRE(force.add({0.0, -0.05, 0.0}, kUp, -0.001));
    CHECK(force.compute(Pose::at({0.0, -0.001, 0.0})).force == Vector3::Zero());
    CHECK(force.compute(Pose::at({0.0, -0.003, 0.0})).force.y() == Approx(kStiffness * 0.002));
}

TEST_CASE("god force: a new set goes on from the last force, which fades as the exponential does") {
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

TEST_CASE("god force: lifted while a contact is still blended in, nothing pulls") {
    GodForce force = make_force();
    force.begin(Pose{});
    (void)change_set(force, kPressed, put_on_floor);
    for (int i = 0; i <= 30; ++i) {
        const Wrench felt = force.compute(Pose::at({0.0, -kDepth_m + 0.0002 * i, 0.0}));
        CHECK(felt.force.y() >= -1.0e-15);
    }
    CHECK(force.compute(Pose::at({0.0, 0.001, 0.0})).force == Vector3::Zero());
}

TEST_CASE("god force: a loaded tool that nothing is near any more is felt not at all, at once") {
    GodForce force = make_force();
    const Pose handle{Vector3(0.0, -kDepth_m, 0.0), compute_exp(Vector3(0.1, 0.0, 0.0))};
    put_on_floor(force);
    const Change off = change_set(force, handle, put_nothing, false);
    REQUIRE(off.before.force.norm() > 1.0);
    REQUIRE(off.before.torque.norm() > 1.0e-3);
    CHECK(off.after.force == Vector3::Zero());
    CHECK(off.after.torque == Vector3::Zero());
    // Nothing of it comes back beside the next thing.
    CHECK(change_set(force, Pose{}, put_on_floor).after.force.norm() < 1.0e-12);
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

TEST_CASE("god force: what touches again after a step fades as if it had not been free") {
    GodForce force = make_force();
    put_on_floor(force);
    for (int n = 0; n < 100; ++n) {
        const auto put = n % 2 == 1 ? put_on_floor : put_nothing;
        CHECK(change_set(force, kPressed, put).step_N() <=
              1.01 * kStiffness * kDepth_m * kDt_s / kFade_s);
    }
}

TEST_CASE("god force: a way there and along it are each other's inverse") {
    const Pose from{Vector3(0.1, -0.2, 0.3), compute_exp(Vector3(0.4, 0.5, -0.6))};
    Vector6 way;
    way << 0.3, 0.1, -0.7, 1.0, -0.5, 2.0;
    CHECK((find_way(from, go_along(from, way)) - way).norm() < 1.0e-14);
    CHECK(find_way(from, from).norm() < 1.0e-15);
}

}  // namespace
}  // namespace fulcrum
