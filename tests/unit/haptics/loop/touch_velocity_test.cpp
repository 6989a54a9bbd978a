#include "haptics/loop/touch_velocity.h"

#include <catch2/catch.hpp>

#include <array>
#include <cmath>

using namespace fulcrum;

namespace {

constexpr double kPeriod_s = 0.001;

ProxyContact touching(const Vector3& place_W, std::int32_t first = 0,
                      std::int32_t second = kNoBody) {
    ProxyContact contact;
    contact.position_W = place_W;
    contact.solid = first;
    contact.n_constraints = second == kNoBody ? 1 : 2;
    contact.touches[0].solid = first;
    contact.touches[1].solid = second;
    return contact;
}

// A hand at an even velocity, and one round after the other.
struct Moving {
    explicit Moving(const Vector3& velocity) : velocity_W(velocity) {
        for (int i = 0; i < 20; ++i) {
            move();
        }
    }
    void move() {
        now_s += kPeriod_s;
        at_W += kPeriod_s * velocity_W;
        estimator.step(at_W, now_s);
    }
    std::span<const Vector3> feel(const ProxyContact& contact, std::span<const Pose> poses_W) {
        const auto felt = touch.step(contact, poses_W, {estimator, now_s});
        touch.keep(poses_W, now_s);
        return felt;
    }
    Vector3 velocity_W;
    double now_s = 0.0;
    Vector3 at_W{Vector3::Zero()};
    VelocityEstimator estimator{VelocitySettings{}};
    TouchVelocity touch;
};

}  // namespace

TEST_CASE("touch velocity: against what stands still it is the hand's own, to the bit") {
    Moving hand(Vector3(0.1, -0.2, 0.3));
    const std::array<Pose, 2> still{Pose::at({1.0, 2.0, 3.0}), Pose::at({4.0, 5.0, 6.0})};
    for (int i = 0; i < 10; ++i) {
        hand.move();
        const auto felt = hand.feel(touching(hand.at_W, 1, 0), still);
        REQUIRE(felt.size() == 2);
        CHECK(felt[0] == hand.estimator.velocity());
        CHECK(felt[1] == hand.estimator.velocity());
    }
    // One that has no pose, and a proxy that names no planes.
    CHECK(hand.feel(touching(hand.at_W, 7), still)[0] == hand.estimator.velocity());
    ProxyContact unnamed = touching(hand.at_W);
    unnamed.n_constraints = 0;
    REQUIRE(hand.feel(unnamed, still).size() == 1);
    CHECK(hand.feel(unnamed, still)[0] == hand.estimator.velocity());
}

TEST_CASE("touch velocity: of what moves and turns it is that against its matter at the place") {
    const Vector3 rate(0.3, -2.0, 1.0);
    Moving hand(Vector3(0.1, 0.05, -0.2));
    std::array<Pose, 2> poses{};
    for (int i = 0; i < 60; ++i) {
        hand.move();
        const double t = hand.now_s;
        poses[0].position = {0.2 * t, -0.1, 0.4 * t};
        poses[0].orientation = Quaternion(AngleAxis(rate.norm() * t, rate.normalized()));
        const auto felt = hand.feel(touching(hand.at_W, 0, 1), poses);
        if (i > 10) {
            const Vector3 matter_W =
                Vector3(0.2, 0.0, 0.4) + rate.cross(hand.at_W - poses[0].position);
            CHECK((felt[0] - (hand.velocity_W - matter_W)).norm() < 0.01);
            CHECK(felt[1] == hand.estimator.velocity());
        }
    }
}

TEST_CASE("touch velocity: a hand that goes along with a solid has none, however it goes") {
    Moving hand(Vector3::Zero());
    std::array<Pose, 1> poses{};
    double most = 0.0;
    for (int i = 0; i < 2000; ++i) {
        // To and fro at 5 Hz by 3 cm: 9 m/s^2 at most.
        hand.now_s += kPeriod_s;
        hand.at_W.x() = 0.03 * std::sin(10.0 * 3.14159 * hand.now_s);
        hand.estimator.step(hand.at_W, hand.now_s);
        poses[0].position.x() = hand.at_W.x();
        const double felt = hand.feel(touching(hand.at_W), poses)[0].norm();
        most = i < 10 ? 0.0 : std::max(most, felt);
    }
    CHECK(most < 1.0e-9);
}

TEST_CASE("touch velocity: a touch that flickers knows the solid's from its first round on") {
    Moving hand(Vector3(0.3, 0.0, 0.0));
    std::array<Pose, 1> poses{Pose::at(hand.at_W)};
    hand.touch.keep(poses, hand.now_s);
    for (int i = 0; i < 50; ++i) {
        hand.move();
        poses[0].position = hand.at_W;
        if (i % 5 == 4) {
            hand.touch.leave();
            hand.touch.keep(poses, hand.now_s);
        } else {
            CHECK(hand.feel(touching(hand.at_W), poses)[0].norm() < 1.0e-9);
        }
    }
}

TEST_CASE(
    "touch velocity: a solid that is put elsewhere has not moved, nor one that is touched anew") {
    Moving hand(Vector3(0.0, -0.1, 0.0));
    std::array<Pose, 1> poses{};
    const auto feel = [&] {
        hand.move();
        return hand.feel(touching(hand.at_W), poses)[0];
    };
    (void)feel();
    poses[0].position.x() = 0.5;
    hand.touch.put(1U, poses);
    CHECK(feel() == hand.estimator.velocity());
    CHECK(feel() == hand.estimator.velocity());
    hand.touch.forget();
    poses[0].position.x() = 0.7;
    CHECK(feel() == hand.estimator.velocity());
    // Where nobody has said that it was put, it has come so fast, from the first round on.
    poses[0].position.x() = 0.701;
    CHECK(feel().x() == Approx(-1.0));
}

TEST_CASE("touch velocity: a step of a hand's encoder is no blow against a solid that drifts") {
    constexpr double kEncoder_m = 5.5e-5;
    VelocityEstimator hand({.noise_bound_m = kEncoder_m});
    TouchVelocity touch;
    std::array<Pose, 1> poses{};
    for (int i = 1; i < 2000; ++i) {
        const double now_s = kPeriod_s * i;
        // The hand goes to and fro by a step and a half, the solid away at 3 mm/s.
        const Vector3 at_W(std::round(1.4 * std::sin(20.0 * now_s)) * kEncoder_m, 0.0, 0.0);
        poses[0].position.x() = 0.003 * now_s;
        hand.step(at_W, now_s);
        const Vector3 felt = touch.step(touching(at_W), poses, {hand, now_s})[0];
        REQUIRE((i < 20 || std::abs(felt.x()) < 0.003 + 1.5 * kEncoder_m / kLongestWindow_s));
    }
}
