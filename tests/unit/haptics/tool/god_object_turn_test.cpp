// A god-object's tool that is long and thin: contacts near its axis may make it turn by more than half a turn in a round, and its inertia is another
// along each axis.
#include "haptics/math/rotation.h"
#include "tests/support/edited_meshes.h"
#include "tests/support/god_scene.h"
#include "tests/support/wander.h"

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>

namespace fulcrum {
namespace {

// A hand that rolls a bar about its length, at 2 to 3.5 rad/s, and presses it ever deeper into a block's top, to `deep_m`.
bool comes_inside(const Vector3& size, double mass_kg, double deep_m, double friction,
                  unsigned seed) {
    const TriangleMesh block = make_box({0.5, 0.1, 0.5}).value();
    const TriangleMesh bar = make_box(size).value();
    GodObjectPlan plan{GodSurface::create(block), GodSurface::create(bar)};
    plan.friction.static_coefficient = plan.friction.dynamic_coefficient = friction;
    GodObjectTool god =
        GodObjectTool::build({plan}, test::make_god_settings(make_box_inertia(mass_kg, size)))
            .value();
    Random random(seed);
    const Vector3 axis = Vector3(1.0, 0.3 * random.uniform(), 0.3 * random.uniform()).normalized();
    const double spin = 1.5 * random.uniform() + (seed % 2 == 0 ? -2.0 : 2.0);
    const Vector3 above(0.0, 0.1, 0.0);
    const MovingFrame object;
    god.place(Pose::at(above));
    for (int i = 0; i < 2500; ++i) {
        const double s = 1.0e-3 * i;
        const double down_m = (0.02 + deep_m) * std::min(1.0, s / 0.5);
        const Vector3 at(0.05 * std::sin(3.0 * s + static_cast<double>(seed)),
                         0.07 + 0.5 * size.y() - down_m, 0.03 * std::sin(2.0 * s));
        const double share = std::min(1.0, i / 100.0);
        const Pose handle{share * at + (1.0 - share) * above, compute_exp(axis * spin * s)};
        (void)god.move({handle, {}}, {&object, 1}, 0.0, test::kGodDt_s);
        if (test::do_enter(block, {}, bar, god.pose_W())) {
            return true;
        }
    }
    return false;
}

TEST_CASE("god-object tool: a bar or a pencil, rolled and pressed, never gets inside") {
    for (const double deep_m : {0.01, 0.02}) {
        for (unsigned seed = 0; seed < 4; ++seed) {
            CAPTURE(deep_m, seed);
            CHECK_FALSE(comes_inside({0.2, 0.01, 0.01}, 0.05, deep_m, 0.0, seed));
            CHECK_FALSE(comes_inside({0.15, 0.007, 0.007}, 0.01, deep_m, 0.0, seed));
        }
    }
    CHECK_FALSE(comes_inside({0.2, 0.01, 0.01}, 0.05, 0.02, 0.4, 0));
}

TEST_CASE("god-object tool: a bar held at one end answers with its inertia where it points") {
    // A push d towards a post under the place r along the bar: lambda = d / (1 / m + r^2 / I), felt as K / m of it.
    const Vector3 size(0.2, 0.02, 0.02);
    constexpr double kMass_kg = 0.1;
    constexpr double kAlong_m = 0.08;
    constexpr double kPush_m = 1.0e-4;
    const Inertia inertia = make_box_inertia(kMass_kg, size);
    for (const double yaw : {0.0, 0.7, 1.5}) {
        for (const double grip_m : {0.0, 0.05}) {
            CAPTURE(yaw, grip_m);
            GodObjectSettings settings = test::make_god_settings(inertia);
            settings.grip_T = {grip_m, 0.0, 0.0};
            test::GodScene scene(make_box(size).value(), {make_box({0.004, 0.1, 0.004}).value()},
                                 settings);
            const Quaternion turn = compute_exp(Vector3(0.0, yaw, 0.0));
            const Vector3 end = turn * Vector3(kAlong_m, 0.0, 0.0);
            const Vector3 grip = turn * settings.grip_T;
            // The post is turned with the bar.
            scene.frames[0].pose_W = {{end.x(), -0.05, end.z()}, turn};
            const double rest_m = 0.01 + settings.gap_m;
            scene.god.place({Vector3(0.0, rest_m + 1.0e-3, 0.0) + grip, turn});
            for (int i = 0; i < 50; ++i) {
                (void)scene.step({Vector3(0.0, rest_m, 0.0) + grip, turn});
            }
            const Wrench felt = scene.god.force({Vector3(0.0, rest_m - kPush_m, 0.0) + grip, turn});
            // The post holds by its side that is nearer to the middle.
            const double r = kAlong_m - 0.002;
            const double lambda = kPush_m / (1.0 / kMass_kg + r * r / inertia.moments_kg_m2.z());
            CHECK(felt.force.y() ==
                  Approx(settings.coupling.shift.stiffness_N_per_m / kMass_kg * lambda)
                      .epsilon(1.0e-3));
            CHECK(std::hypot(felt.force.x(), felt.force.z()) < 1.0e-6);
            // About the grip.
            const Vector3 arm = turn * Vector3(r - grip_m, 0.0, 0.0);
            CHECK((felt.torque - arm.cross(felt.force)).norm() < 1.0e-3 * r * felt.force.y());
        }
    }
}

TEST_CASE("god-object tool: a part of it that is wholly inside is not free") {
    // A ball, and far from it another.
    const TriangleMesh ball = make_sphere(0.01, 12).value();
    const TriangleMesh two = test::join_meshes({ball, test::shift(ball, {0.3, 0.0, 0.0})});
    CHECK(GodSurface::create(two)->parts().size() == 2);
    test::GodScene scene(two, {make_box(Vector3::Constant(0.1)).value()},
                         test::make_god_settings(make_box_inertia(0.05, {0.3, 0.02, 0.02})));
    const MovingFrame box;
    for (const double x : {0.0, -0.3}) {
        scene.god.place(Pose::at({x, 0.0, 0.0}));
        CHECK_FALSE(scene.god.is_free({&box, 1}));
    }
    scene.god.place(Pose::at({-0.15, 0.0, 0.0}));
    CHECK(scene.god.is_free({&box, 1}));
}

}  // namespace
}  // namespace fulcrum
