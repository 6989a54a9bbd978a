// What reaches a hand from bodies that are felt in closed form, among others, with the plan and the gate of a lesson.
#include "haptics/coupling/virtual_coupling.h"
#include "haptics/geometry/shape.h"
#include "haptics/surface/materials.h"
#include "tests/support/sent_stroke.h"
#include "tests/support/touchable.h"

#include <catch2/catch.hpp>

#include <cmath>
#include <numbers>
#include <vector>

using namespace fulcrum;
using runtime::BodyShape;
using test::SentForce;
using test::SentStroke;

namespace {

constexpr double kRound_m = 0.06;
constexpr double kHalf_m = 0.1;  // of the height

// Sixteen sides: what is felt of it must not be they.
const MeshShape& post() {
    static const MeshShape mesh = touchable(make_cylinder(kRound_m, 2.0 * kHalf_m, 16));
    return mesh;
}

// One felt so at the origin; beside it a ball and another post as it is.
runtime::LessonDescription make_felt_lesson(const Material& material, BodyShape felt_as,
                                            const CursorShape& cursor = {}) {
    runtime::LessonDescription lesson = test::make_touch_lesson(material, false, "post");
    lesson.bodies[0].felt_as = felt_as;
    lesson.bodies.resize(3, lesson.bodies[0]);
    lesson.bodies[1].name = "ball";
    lesson.bodies[1].model = "sphere";
    lesson.bodies[2].name = "other post";
    for (std::size_t i = 1; i < 3; ++i) {
        lesson.bodies[i].felt_as = BodyShape::model;
        lesson.bodies[i].position_W = Vector3(0.0, i == 1 ? 0.3 : -0.3, 0.0);
    }
    lesson.hand.cursor = cursor;
    return lesson;
}

Vector3 outwards(double angle) {
    return {std::sin(angle), 0.0, std::cos(angle)};
}

// Round the barrel, and along it.
test::Place on_barrel(double way_m) {
    const Vector3 n = outwards(0.3 + 0.8 * way_m / kRound_m);
    return {kRound_m * n + (0.6 * way_m - 0.03) * Vector3::UnitY(), n};
}

// Up a capsule's barrel, over its end and down on the other side.
test::Place on_capsule(double way_m) {
    const double straight_m = kHalf_m - kRound_m;
    const double along_m = way_m - 0.06;
    const double angle = std::clamp(along_m / kRound_m, 0.0, std::numbers::pi);
    const Vector3 n = std::cos(angle) * outwards(0.4) + std::sin(angle) * Vector3::UnitY();
    return {kRound_m * n + (straight_m + std::min(along_m, 0.0)) * Vector3::UnitY(), n};
}

test::Place on_ball(double way_m) {
    const double angle = way_m / kHalf_m;
    const Vector3 n =
        std::cos(angle) * Vector3(0.6, 0.0, 0.8) + std::sin(angle) * Vector3(-0.64, 0.6, 0.48);
    return {kHalf_m * n, n};
}

struct Felt {
    BodyShape shape;
    test::Place (*way)(double way_m);
};
constexpr Felt kFelt[] = {
    {BodyShape::ball, on_ball}, {BodyShape::cylinder, on_barrel}, {BodyShape::capsule, on_capsule}};

Material metal() {
    return test::bare(*find_material("metal"));
}

// Comes straight in and rests.
Vector3 press(SentForce& loop, const Vector3& from_W, const Vector3& hand_W) {
    loop.open_gate(from_W);
    constexpr int kRounds = 400;
    for (int i = 1; i <= kRounds; ++i) {
        (void)loop.step(from_W + (hand_W - from_W) * i / kRounds);
    }
    Vector3 force_W = Vector3::Zero();
    for (int i = 0; i < 100; ++i) {
        force_W = loop.step(hand_W);
    }
    return force_W;
}

Vector3 closed_form(const SentForce& loop, const Vector3& place_W, const Vector3& hand_W) {
    return compute_coupling_spring(*loop.plan().solids[0].coupling, place_W, hand_W);
}

}  // namespace

TEST_CASE("felt shapes: a resting hand gets the closed form of each, whatever lies beside it") {
    struct Pressed {
        BodyShape shape;
        Vector3 normal;
        Vector3 place;
    };
    const Vector3 side = outwards(0.55);
    const Vector3 tilted(0.36, 0.8, 0.48);
    const Vector3 up = Vector3::UnitY();
    const double straight_m = kHalf_m - kRound_m;
    // A face, the barrel, a pole; and beside edges: the hand is nearer to the other side than to the one that it came through.
    const std::vector<Pressed> cases{
        {BodyShape::ball, tilted, kHalf_m * tilted},
        {BodyShape::box, Vector3::UnitX(), Vector3(kRound_m, 0.02, 0.03)},
        {BodyShape::box, Vector3::UnitX(), Vector3(kRound_m, 0.0999, -0.0599)},
        {BodyShape::box, up, Vector3(0.01, kHalf_m, 0.0598)},
        {BodyShape::cylinder, side, kRound_m * side + 0.02 * up},
        {BodyShape::cylinder, side, kRound_m * side + 0.0998 * up},
        {BodyShape::cylinder, up, 0.0598 * side + kHalf_m * up},
        {BodyShape::capsule, side, kRound_m * side + 0.03 * up},
        {BodyShape::capsule, tilted, kRound_m * tilted + straight_m * up},
        {BodyShape::hull, up, Vector3(0.02, kHalf_m, 0.01)}};
    for (const Pressed& pressed : cases) {
        SentForce loop(make_felt_lesson(metal(), pressed.shape), post());
        const Vector3 hand_W = pressed.place - 0.002 * pressed.normal;
        const Vector3 sent = press(loop, pressed.place + 0.01 * pressed.normal, hand_W);
        const Vector3 expected = closed_form(loop, pressed.place, hand_W);
        INFO("shape " << static_cast<int>(pressed.shape) << ": off by "
                      << (sent - expected).norm());
        CHECK(expected.norm() > 0.5);
        CHECK((sent - expected).norm() < 1.0e-3);
        CHECK(loop.state().touched_body == 0);
        // Off it there is nothing left.
        CHECK(press(loop, hand_W, pressed.place + 0.001 * pressed.normal).norm() < 1.0e-6);
    }
}

TEST_CASE("felt shapes: nothing is sent along a ball, a barrel or a capsule that has no friction") {
    for (const Felt& felt : kFelt) {
        for (const Material& shipped : shipped_materials()) {
            const Material material = test::bare(shipped);
            for (const double speed_m_per_s : {0.02, 0.2, 0.5}) {
                SentForce loop(make_felt_lesson(material, felt.shape), post());
                const SentStroke sent = test::stroke(loop, material, felt.way, speed_m_per_s);
                INFO(shipped.name << " at " << speed_m_per_s << " m/s: " << sent.sideways_N << ", "
                                  << sent.along_N);
                CHECK(sent.sideways_N < 0.005);
                CHECK(sent.along_N < 0.005);
                CHECK(loop.state().touched_body == 0);
            }
        }
    }
}

TEST_CASE("felt shapes: cursors with a shape of their own feel them so, too") {
    // Places of the cursor's middle where it touches the solid in the direction -n, at one height all the way.
    struct Cursor {
        CursorShape shape;
        double across_m;  // how far it reaches to a side
        double down_m;    // and down, beside what a ball or a capsule has all round
        double round_m;
        double tolerance;  // of the force: corners are rounded by a thousandth of the cursor
    };
    const Cursor cursors[] = {{SphereShape{0.01}, 0.0, 0.0, 0.01, 1.0e-4},
                              {CapsuleShape{0.006, 0.01}, 0.0, 0.01, 0.006, 1.0e-4},
                              {CylinderShape{0.01, 0.012}, 0.01, 0.012, 0.0, 0.01}};
    const Material material = metal();
    const double deep_m = test::kStrokePush_N / material.coupling.stiffness_N_per_m;
    for (const Cursor& cursor : cursors) {
        for (const Felt& felt : kFelt) {
            const auto way = [&](double way_m) -> test::Place {
                const Vector3 out = outwards(0.3 + way_m / kHalf_m);
                const bool is_ball = felt.shape == BodyShape::ball;
                const Vector3 n = is_ball ? Vector3(0.8 * out + 0.6 * Vector3::UnitY()) : out;
                return {(is_ball ? kHalf_m : kRound_m) * n + cursor.round_m * n +
                            cursor.across_m * out +
                            (is_ball ? cursor.down_m : 0.0) * Vector3::UnitY(),
                        n};
            };
            for (const double speed_m_per_s : {0.02, 0.5}) {
                SentForce loop(make_felt_lesson(material, felt.shape, cursor.shape), post());
                const SentStroke sent = test::stroke(loop, material, way, speed_m_per_s);
                INFO("cursor " << cursor.shape.index() << ", shape " << static_cast<int>(felt.shape)
                               << " at " << speed_m_per_s << " m/s: " << sent.sideways_N);
                CHECK(sent.sideways_N < 0.005);
                CHECK(sent.along_N < 0.005);
            }
            SentForce loop(make_felt_lesson(material, felt.shape, cursor.shape), post());
            const test::Place place = way(0.0);
            const Vector3 hand_W = place.at_W - deep_m * place.normal_W;
            const Vector3 sent = press(loop, place.at_W + 0.01 * place.normal_W, hand_W);
            CHECK((sent - closed_form(loop, place.at_W, hand_W)).norm() <
                  cursor.tolerance * test::kStrokePush_N);
        }
    }
    // A box that stands on a capsule's barrel with its side.
    SentForce loop(make_felt_lesson(material, BodyShape::capsule, BoxShape{{0.01, 0.01, 0.01}}),
                   post());
    const Vector3 place(kRound_m + 0.01, 0.01, 0.0);
    const Vector3 hand_W = place - deep_m * Vector3::UnitX();
    const Vector3 sent = press(loop, place + 0.01 * Vector3::UnitX(), hand_W);
    CHECK((sent - closed_form(loop, place, hand_W)).norm() < 1.0e-3);
}

TEST_CASE("felt shapes: a model whose middle is not its origin is felt the same where it lies") {
    const Vector3 middle(0.12, -0.2, 0.07);
    const Vector3 upright(2.0 * kRound_m, 2.0 * kHalf_m, 2.0 * kRound_m);
    const PlacedBox placed{middle, upright};
    const MeshShape off = touchable(make_boxes(std::span(&placed, 1)));
    const MeshShape log = touchable(make_box({upright.y(), upright.x(), upright.z()}));
    // What is upright at the origin, turned so that it lies along x.
    const Quaternion lies(AngleAxis(-0.5 * std::numbers::pi, Vector3::UnitZ()));
    const Vector3 n = Vector3(0.5, 0.1, 0.86).normalized();
    for (const CursorShape& cursor : {CursorShape(), CursorShape(SphereShape{0.004}),
                                      CursorShape(CapsuleShape{0.004, 0.004})}) {
        for (const BodyShape shape :
             {BodyShape::ball, BodyShape::box, BodyShape::cylinder, BodyShape::capsule}) {
            const double pressed_m = shape == BodyShape::ball  ? 0.097
                                     : shape == BodyShape::box ? 0.068
                                                               : 0.0595;
            const auto feel = [&](const MeshShape& mesh, const Pose& at_W) {
                SentForce loop(make_felt_lesson(metal(), shape, cursor), mesh);
                const Quaternion& turn_W = at_W.orientation;
                loop.open_gate(Pose{at_W * Vector3(0.25 * n), turn_W});
                // In to where it is pressed, and on along the side.
                for (int i = 0; i <= 1200; ++i) {
                    const double out_m = std::max(0.25 - 2.0e-4 * i, pressed_m);
                    const double up_m = std::max(i - 1000, 0) * 5.0e-5;
                    (void)loop.step(
                        Pose{at_W * Vector3(out_m * n + up_m * Vector3::UnitY()), turn_W});
                }
                CHECK(loop.state().touched_body == 0);
                return Vector3(turn_W.conjugate() * loop.state().applied_W.force);
            };
            const Vector3 there_B = feel(touchable(make_box(upright)), Pose{});
            INFO("cursor " << cursor.index() << ", shape " << static_cast<int>(shape) << ": "
                           << there_B.norm() << " N");
            CHECK(there_B.norm() > 0.5);
            CHECK((feel(off, Pose::at(middle)) - there_B).norm() < 1.0e-6);
            if (shape == BodyShape::cylinder || shape == BodyShape::capsule) {
                CHECK((feel(log, {Vector3::Zero(), lies}) - there_B).norm() < 1.0e-6);
            }
        }
    }
}

TEST_CASE(
    "felt shapes: a cursor that turns is felt as it stands, and turns no faster than the gate") {
    const Material material = metal();
    const Vector3 half(0.01, 0.01, 0.01);
    for (const BodyShape shape : {BodyShape::box, BodyShape::model}) {
        SentForce loop(make_felt_lesson(material, shape, BoxShape{half}), post());
        const Vector3 up = Vector3::UnitY();
        Pose hand = Pose::at((kHalf_m + 0.009) * up);
        (void)press(loop, (kHalf_m + 0.02) * up, hand.position);
        // To its edge in 50 ms, a tenth of a radian a round: no round changes by more than the slew and a transient's bounds.
        const double slew_N = loop.plan().safety.max_slew_N_per_s / loop.plan().rate_hz +
                              loop.plan().safety.max_transient_N;
        Vector3 last_W = loop.state().applied_W.force;
        for (int i = 1; i <= 400; ++i) {
            const double turn_rad = std::min(0.1 * i, 0.6);
            hand.orientation = Quaternion(AngleAxis(turn_rad, Vector3::UnitZ()));
            const Vector3& sent_W = loop.step(hand).force;
            REQUIRE((sent_W - last_W).norm() < slew_N);
            last_W = sent_W;
        }
        // Corners are rounded by a thousandth.
        const double reach_m = 0.01 * (std::sin(0.6) + std::cos(0.6));
        const Vector3 expected = closed_form(loop, (kHalf_m + reach_m) * up, hand.position);
        INFO("sent " << last_W.y() << " N for " << expected.y());
        CHECK((last_W - std::min(loop.plan().safety.max_force_N, expected.norm()) * up).norm() <
              0.02);
        CHECK(loop.state().proxy_orientation_W.angularDistance(hand.orientation) < 1.0e-9);
        CHECK(loop.state().proxy_position_W.y() == Approx(kHalf_m + reach_m).margin(1.0e-5));
        // Lifted off it hangs in the air as the hand does, and another hand that did the same is told the same bits.
        hand.position = (kHalf_m + 0.03) * up;
        for (int i = 0; i < 200; ++i) {
            (void)loop.step(hand);
        }
        CHECK(loop.state().applied_W.force.norm() < 1.0e-6);
        CHECK(loop.state().proxy_position_W == loop.state().tool_pose_W.position);
    }
}

TEST_CASE("felt shapes: a hand that turns a cursor twice feels the same to the bit") {
    const auto feel = [](std::vector<Vector3>& forces_W) {
        SentForce loop(make_felt_lesson(metal(), BodyShape::model, BoxShape{{0.01, 0.012, 0.008}}),
                       post());
        (void)press(loop, Vector3(0.0, kHalf_m + 0.03, 0.0), Vector3(0.0, kHalf_m + 0.013, 0.0));
        for (int i = 0; i < 2000; ++i) {
            const double s = 1.0e-3 * i;
            forces_W.push_back(loop.step(Pose{Vector3(0.03 * std::sin(3.0 * s),
                                                      kHalf_m + 0.01 + 0.003 * std::cos(5.0 * s),
                                                      0.02 * std::sin(2.0 * s)),
                                              Quaternion(AngleAxis(2.0 * std::sin(4.0 * s),
                                                                   Vector3(0.6, 0.0, 0.8)))})
                                   .force);
        }
    };
    std::vector<Vector3> once_W;
    std::vector<Vector3> twice_W;
    feel(once_W);
    feel(twice_W);
    CHECK(once_W == twice_W);
    CHECK(std::ranges::count_if(once_W, [](const Vector3& f) { return f.norm() > 0.2; }) > 500);
}

TEST_CASE("felt shapes: friction stays in its cone and pulls nobody along") {
    for (const Felt& felt : kFelt) {
        for (const char* name : {"metal", "wood", "rubber"}) {
            Material material = metal();
            material.friction = find_material(name)->friction;
            SentForce loop(make_felt_lesson(material, felt.shape), post());
            const SentStroke sent = test::stroke(loop, material, felt.way, 0.2);
            INFO(name << ": along " << sent.along_N << ", cone " << sent.cone);
            CHECK(sent.along_N < 0.05);
            CHECK(sent.cone > 0.5 * material.friction.dynamic_coefficient);
            CHECK(sent.cone < 1.03 * material.friction.static_coefficient + 0.003);
        }
    }
}

TEST_CASE("felt shapes: a closed cycle gives the hand no energy") {
    for (const Felt& felt : kFelt) {
        const Material material = metal();
        SentForce loop(make_felt_lesson(material, felt.shape), post());
        const auto hand_at = [&](double way_m, double deep_m) {
            const test::Place place = felt.way(way_m);
            return Vector3(place.at_W - deep_m * place.normal_W);
        };
        Vector3 hand_W = hand_at(0.02, -0.002);
        loop.open_gate(hand_W);
        Vector3 force_W = Vector3::Zero();
        double energy_J = 0.0;
        const auto go = [&](const Vector3& to_W) {
            energy_J += force_W.dot(to_W - hand_W);
            hand_W = to_W;
            force_W = loop.step(to_W);
        };
        // In, along with a push that swells, and back to where it began.
        constexpr int kRounds = 4000;
        for (int i = 0; i <= kRounds; ++i) {
            const double turn = 2.0 * std::numbers::pi * i / kRounds;
            go(hand_at(0.06 - 0.04 * std::cos(turn), 0.002 - 0.004 * std::cos(3.0 * turn)));
        }
        INFO(energy_J);
        CHECK(energy_J < 0.0);
        CHECK(energy_J > -0.01);
    }
}
