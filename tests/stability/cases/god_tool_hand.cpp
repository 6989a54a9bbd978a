// A tool that never enters anything in hands that are hard to follow: devices that lie, clocks that stumble, long drags, tools and bodies of most unlike
// size, fast plates.
#include "haptics/math/rotation.h"
#include "tests/stability/cases/god_watch.h"
#include "tests/support/bad_numbers.h"
#include "tests/support/edited_meshes.h"
#include "tests/support/wander.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace fulcrum::stability {
namespace {

// Of what a device may tell, the worst, while it presses on a block: no number, no turn, far too far, the same again, and somewhere else at once.
Pose lie_about(const Pose& truth, int kind, Random& random) {
    Pose told = truth;
    switch (kind) {
        case 0:
            told.position.y() = kNan;
            break;
        case 1:
            told.position.x() = -kInfinity;
            break;
        case 2:
            told.position.y() = -1.0e300;
            break;
        case 3:
            told.orientation.coeffs().setZero();
            break;
        case 4:
            told.orientation.coeffs() *= 1.5;
            break;
        case 5:
            told.orientation.z() = kNan;
            break;
        case 6:
            told.position += 2.0 * random.in_cube();
            break;
        case 7:
            told = {-truth.position, random.turn(3.0)};
            break;
        case 8:
            told.position *= 1.0e5;
            break;
        default:
            break;  // twice the same
    }
    return told;
}

Finding lie_to_god() {
    GodObjectSettings settings = of_god_cube();
    settings.coupling.clamp_m = 0.02;
    test::GodScene scene(make_god_cube(), {make_box({0.1, 0.06, 0.1}).value()}, settings);
    GodWatch watch(scene);
    Random random(91);
    const double rest_m = 0.03 + 0.5 * kGodCube_m + kGodGap_m;
    scene.god.place(Pose::at({0.0, rest_m + 0.01, 0.0}));
    const Pose pressed = Pose::at({0.0, rest_m - 0.004, 0.0});
    const double most_N = kGodStiffness_N_per_m * settings.coupling.clamp_m;
    for (int kind = 0; kind < 10; ++kind) {
        for (int i = 0; i < 60; ++i) {
            const Pose before = scene.god.pose_W();
            const Pose told = i % 3 == 1 ? lie_about(pressed, kind, random) : pressed;
            const ToolFelt felt = watch.try_step(told);
            watch.demand(felt.felt_W.force.norm() / (most_N * (1.0 + 1.0e-9)));
            if (!felt.moved) {
                watch.demand(felt.felt_W.force.isZero(0.0) && felt.felt_W.torque.isZero(0.0));
                watch.demand(find_way(before, scene.god.pose_W()).isZero(0.0));
            }
        }
        // From wherever a lie has led it, back over the block.
        for (int i = 0; i < 200; ++i) {
            (void)watch.step(Pose::at({0.0, rest_m + 0.5, 0.0}));
        }
        watch.demand_free(Pose::at({0.0, rest_m + 0.5, 0.0}));
        ToolFelt felt;
        for (int i = 0; i < kBlended; ++i) {
            felt = watch.step(pressed);
        }
        watch.demand_felt(felt, {0.0, kGodStiffness_N_per_m * 0.004, 0.0});
    }
    return watch.judge();
}

// Steps of 0.05 to 50 ms by chance, and such as are none.
Finding stumble_with_god() {
    test::GodScene scene(make_god_cube(), {make_box({0.2, 0.06, 0.2}).value()}, of_god_cube());
    GodWatch watch(scene);
    Random random(92);
    const double rest_m = 0.03 + 0.5 * kGodCube_m + kGodGap_m;
    scene.god.place(Pose::at({0.0, rest_m + 0.01, 0.0}));
    double pressed_s = 0.0;
    for (int i = 0; i < 4000; ++i) {
        const double dt_s = std::pow(10.0, -2.8 + 1.5 * random.uniform());
        const Vector3 depth(0.05 * std::sin(0.01 * i), 0.004 + 0.002 * std::sin(0.03 * i),
                            0.03 * std::sin(0.007 * i));
        const Pose handle = Pose::at({depth.x(), rest_m - depth.y(), depth.z()});
        if (i % 50 == 25) {
            const double none[] = {0.0, -0.001, std::nan("")};
            const Pose before = scene.god.pose_W();
            const ToolFelt felt = watch.try_step(handle, none[i / 50 % 3]);
            watch.demand(!felt.moved && felt.felt_W.force.isZero(0.0));
            watch.demand(find_way(before, scene.god.pose_W()).isZero(0.0));
        }
        const ToolFelt felt = watch.step(handle, dt_s);
        pressed_s += dt_s;
        // As long as any set of contacts takes to be blended in.
        if (pressed_s > 1.5) {
            watch.demand_felt(felt, {0.0, kGodStiffness_N_per_m * depth.y(), 0.0});
        }
    }
    watch.demand(pressed_s > 10.0);
    return watch.judge();
}

// Eight seconds to and fro along a floor and a wall: it goes along as in free space, is held down by its depth, and comes back to where it was.
Finding wander_with_god() {
    const TriangleMesh bar = make_box({0.1, 0.3, 1.0}).value();
    const double side_m = 0.5 * kGodCube_m + kGodGap_m;
    test::GodScene scene(make_god_cube(),
                         {make_plate(1.0, 1.0, 7).value(), test::shift(bar, {-0.05, 0.16, 0.0})},
                         of_god_cube());
    GodWatch watch(scene);
    const Vector3 corner(side_m, side_m, 0.0);
    const Vector3 depth(0.003, 0.004, 0.0);
    scene.god.place(Pose::at({0.03, 0.05, 0.0}));
    Random random(93);
    double along_m = 0.0;
    double speed_m = 0.0;
    for (int i = 0; i < kBlended; ++i) {
        (void)watch.step(Pose::at(corner - depth));
    }
    const Pose begun = scene.god.pose_W();
    for (int i = 0; i < 8000; ++i) {
        speed_m = 0.99 * speed_m + 2.0e-5 * random.uniform() - 2.0e-6 * along_m;
        along_m += speed_m;
        const Vector3 before = scene.god.centre_W();
        const Vector3 handle = corner - depth + Vector3(0.0, 0.0, along_m);
        const ToolFelt felt = watch.step(Pose::at(handle));
        watch.demand_felt(felt, kGodStiffness_N_per_m * depth);
        watch.demand(felt.felt_W.torque.norm() / kExact_N);
        // Along it as in free space; across by nothing.
        const Vector3 gone = scene.god.centre_W() - before;
        watch.demand(std::abs(gone.z() - 0.5 * (handle.z() - before.z())) / 1.0e-9);
        watch.demand((scene.god.centre_W() - begun.position).head<2>().norm() / 1.0e-9);
    }
    for (int i = 0; i < 100; ++i) {
        (void)watch.step(Pose::at(corner - depth));
    }
    watch.demand(find_way(begun, scene.god.pose_W()).norm() / 1.0e-9);
    watch.demand_free(Pose::at({0.1, 0.2, 0.0}));
    return watch.judge();
}

// A cube of a millimetre on a block of ten metres, 10 km from the origin: to 1e-6 of its force.
Finding press_small_god_on_large() {
    constexpr double kSide_m = 0.001;
    test::GodScene scene(
        make_box(Vector3::Constant(kSide_m)).value(), {make_box({10.0, 2.0, 10.0}).value()},
        test::make_god_settings(make_box_inertia(0.001, Vector3::Constant(kSide_m))));
    GodWatch watch(scene, kGodGap_m, kSide_m * kSide_m / 6.0);
    const Vector3 origin(1.0e4, -3.0e3, 2.0e3);
    scene.frames[0].pose_W = Pose::at(origin);
    const double rest_m = 1.0 + 0.5 * kSide_m + kGodGap_m;
    const auto at = [&](double x, double above_m) {
        return Pose::at(origin + Vector3(x, rest_m + above_m, 0.3 * x));
    };
    scene.god.place(at(0.0, 0.001));
    for (int i = 0; i < kBlended + 1000; ++i) {
        const int k = std::max(0, i - kBlended);
        const ToolFelt felt = watch.step(at(0.004 * k, -0.002));
        if (i >= kBlended) {
            const double wanted_N = kGodStiffness_N_per_m * 0.002;
            watch.demand_felt(felt, {0.0, wanted_N, 0.0}, 1.0e-6 * wanted_N);
        }
    }
    watch.demand(watch.n_touching() > kBlended);
    watch.demand_free(at(4.0, 0.1));
    return watch.judge();
}

// The hand shoots through a plate of 0.1 mm at 5 m/s and back: the tool stays on its side.
Finding shoot_god_through_plate() {
    const Vector3 size_m(0.4, 1.0e-4, 0.4);
    test::GodScene scene(make_god_cube(), {make_box(size_m).value()}, of_god_cube());
    GodWatch watch(scene);
    Random random(51);
    for (int pass = 0; pass < 60; ++pass) {
        const Vector3 at(0.05 * random.uniform(), 0.0, 0.05 * random.uniform());
        Vector3 from = 0.2 * random.direction();
        const double side = pass % 2 == 0 ? 1.0 : -1.0;
        from.y() = side * std::max(std::abs(from.y()), 0.06);
        const Vector3 way = (at - from).normalized();
        const Quaternion turn = random.turn(3.0);
        scene.god.place({from, turn});
        constexpr int kTicks = 120;
        const int n_before = watch.n_touching();
        for (int i = 1; i <= kTicks; ++i) {
            const double way_m = 5.0 * test::kGodDt_s * std::min(i, kTicks - i);
            (void)watch.step_without_gain({from + way_m * way, turn});
            const Vector3& centre = scene.god.centre_W();
            const bool is_over = std::max(std::abs(centre.x()), std::abs(centre.z())) < 0.15;
            watch.demand(!is_over || side * centre.y() > 0.0);
        }
        watch.demand(watch.n_touching() > n_before);
        watch.demand_free({from, turn});
    }
    return watch.judge();
}

// A plate of 0.1 mm that flies at 5 m/s and turns at 20 rad/s meets a still tool: it takes the tool along, and waits for room for a few steps at most.
Finding tumble_plate_through_god() {
    constexpr int kMostWaits = 8;
    constexpr int kPasses = 15;  // of each row of chances
    const Vector3 size_m(0.3, 1.0e-4, 0.3);
    test::GodScene scene(make_god_cube(), {make_box(size_m).value()}, of_god_cube());
    GodWatch watch(scene);
    Random random(52);
    for (int pass = 0; pass < 3 * kPasses; ++pass) {
        if (pass == 2 * kPasses) {
            random = Random(114);
        }
        const Pose handle{Vector3::Zero(), random.turn(3.0)};
        const Vector3 velocity = 5.0 * random.direction();
        const Vector3 axis = random.direction();
        const Quaternion met = random.turn(3.0);
        const Vector3 aside = 0.03 * random.in_cube();
        const auto plate_at = [&](int tick) {
            const double t_s = test::kGodDt_s * (tick - 60);
            return Pose{velocity * t_s + aside,
                        (compute_exp(20.0 * t_s * axis) * met).normalized()};
        };
        scene.frames[0].pose_W = plate_at(0);
        scene.god.place(handle);
        int n_waits = 0;    // in a row
        double side = 0.0;  // of the plate, while the tool is over or under it
        for (int i = 1; i <= 320; ++i) {
            // On as if nothing were there, and then away along itself, so that the tool may come back.
            Pose& plate_W = scene.frames[0].pose_W;
            plate_W = plate_at(std::min(i, 120));
            const Vector3 along = plate_W.orientation * Vector3::UnitX();
            plate_W.position +=
                std::copysign(0.004 * std::max(i - 120, 0), along.dot(plate_W.position)) * along;
            (void)watch.step(handle);
            n_waits = scene.god.last_step().wedged ? n_waits + 1 : 0;
            watch.demand(n_waits <= kMostWaits);
            // Where it is, for it may wait.
            const Vector3 at = (scene.god.object_W(0).inverse() * scene.god.pose_W()).position;
            const bool is_over = std::max(std::abs(at.x()), std::abs(at.z())) < 0.11;
            watch.demand(!is_over || side * at.y() >= 0.0);
            side = is_over ? at.y() : 0.0;
        }
        watch.demand(!scene.god.last_step().wedged);
        watch.demand_free(handle);
    }
    watch.demand(watch.n_touching() > 30);
    return watch.judge();
}

const HardCase kLies{{"god-object and a device that lies",
                      "NaN, infinity, 1e300, no turn, jumps, doubled poses", kGodMeasured, "",
                      lie_to_god}};
const HardCase kStumbles{{"god-object in steps of 0.05 to 50 ms",
                          "and of 0, of less and of NaN, pressed and dragged", kGodMeasured, "",
                          stumble_with_god}};
const HardCase kWanders{{"god-object dragged for eight seconds",
                         "along a floor and a wall, no drag, no drift", kGodMeasured, "",
                         wander_with_god}};
const HardCase kUnlike{{"god-object of 1 mm on a body of 10 m",
                        "10 km from the origin, force to 1e-6", kGodMeasured, "",
                        press_small_god_on_large}};
const HardCase kShot{{"god-object shot at a plate of 0.1 mm", "by a hand at 5 m/s, 60 times",
                      kGodMeasured, "", shoot_god_through_plate}};
const HardCase kTumbled{{"god-object met by a plate that tumbles",
                         "0.1 mm, at 5 m/s and 20 rad/s, 45 times", kGodMeasured, "",
                         tumble_plate_through_god}};

}  // namespace
}  // namespace fulcrum::stability
