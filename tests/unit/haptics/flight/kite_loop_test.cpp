#include "haptics/flight/kite_loop.h"

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>

using namespace fulcrum;

namespace {

constexpr double kRate_Hz = 500.0;
const Vector3 kHand_W(0.0, 1.0, 0.0);

struct Scene {
    std::unique_ptr<KiteChannels> channels = std::make_unique<KiteChannels>();
    KiteLoop loop{KiteFlightSettings{}, kRate_Hz, *channels};
    double now_s = 0.0;
    void run(double seconds) {
        for (int i = 0; i < static_cast<int>(std::lround(seconds * kRate_Hz)); ++i) {
            now_s += 1.0 / kRate_Hz;
            loop.step(now_s);
        }
    }
};

}  // namespace

TEST_CASE(
    "kite loop: nothing flies before there is a hand; then what is felt and seen is the flight's") {
    Scene scene;
    scene.run(1.0);
    CHECK_FALSE(scene.channels->frame.take());
    CHECK_FALSE(scene.channels->line.take());
    scene.channels->hand_W.publish(kHand_W);
    scene.run(20.0);
    REQUIRE(scene.channels->frame.take());
    REQUIRE(scene.channels->line.take());
    const KiteFrame& frame = scene.channels->frame.value();
    CHECK(frame.stamp_s == Approx(scene.now_s));
    CHECK(frame.report.centre_W == scene.loop.flight().report().centre_W);
    CHECK(frame.report.centre_W.y() > 10.0);
    CHECK(frame.n_nodes == LineSettings{}.segments + 1);
    CHECK(frame.line_W[0] == kHand_W);
    CHECK((frame.line_W[16] - frame.report.knot_W).norm() < 1.0e-9);
    const LineState& line = scene.channels->line.value();
    CHECK(line.force_W == frame.report.hand_force_W);
    CHECK(line.force_W.norm() > 1.0);
    CHECK(line.hand_W == kHand_W);
}

TEST_CASE(
    "kite loop: the reel turns at its speed, the wind is the lesson's, a launch is made once") {
    Scene scene;
    scene.channels->hand_W.publish(kHand_W);
    KiteOrders orders;
    orders.line_m = 25.0;
    orders.wind_m_per_s = 7.0;
    scene.channels->orders.publish(orders);
    scene.run(1.0);
    CHECK(scene.loop.flight().line().length_m() == Approx(22.0));
    scene.run(4.0);
    CHECK(scene.loop.flight().line().length_m() == Approx(25.0));
    scene.run(10.0);
    const double flown_m = scene.loop.flight().report().centre_W.y();
    orders.n_launches = 1;
    orders.elevation_rad = 0.2;
    scene.channels->orders.publish(orders);
    scene.run(0.002);
    CHECK(scene.loop.flight().report().centre_W.y() < 0.5 * flown_m);
    scene.channels->orders.publish(orders);
    scene.run(10.0);
    CHECK(scene.loop.flight().report().centre_W.y() > 0.8 * flown_m);
}

TEST_CASE(
    "kite loop: a cut is made once, and another kite flies on as much line in the same wind") {
    Scene scene;
    scene.channels->hand_W.publish(kHand_W);
    KiteOrders orders;
    orders.line_m = 25.0;
    orders.wind_m_per_s = 7.0;
    scene.channels->orders.publish(orders);
    scene.run(5.0);
    CHECK(scene.loop.flight().line().length_m() == Approx(25.0));
    KiteFlightSettings other;
    other.kite.shape = KiteShape::sled;
    scene.channels->built.put(std::make_unique<KiteFlight>(other));
    scene.run(0.002);
    CHECK(scene.loop.flight().kite().plates.size() == make_kite(other.kite).plates.size());
    CHECK(scene.loop.flight().line().length_m() == Approx(25.0));
    KiteFlight same(other);
    same.set_line_length_m(25.0);
    same.set_wind_speed_m_per_s(7.0);
    same.launch(kHand_W, orders.elevation_rad, orders.lean_rad);
    same.step(0.002, kHand_W);
    CHECK((scene.loop.flight().report().centre_W - same.report().centre_W).norm() < 1.0e-9);
    orders.n_cuts = 1;
    scene.channels->orders.publish(orders);
    scene.run(0.002);
    CHECK(scene.loop.flight().report().is_snapped);
    orders.n_launches = 1;
    scene.channels->orders.publish(orders);
    scene.run(0.01);
    CHECK_FALSE(scene.loop.flight().report().is_snapped);
}

TEST_CASE("kite loop: a broken clock, hand or order leaves it flying; silence lets go") {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    Scene scene;
    scene.channels->hand_W.publish(kHand_W);
    scene.run(5.0);
    scene.loop.step(nan);
    scene.channels->hand_W.publish({nan, 0.0, 0.0});
    KiteOrders orders;
    orders.n_launches = 7;
    orders.elevation_rad = nan;
    orders.line_m = nan;
    orders.wind_m_per_s = nan;
    scene.channels->orders.publish(orders);
    scene.run(5.0);
    const KiteReport& report = scene.loop.flight().report();
    CHECK(is_finite(report.pose_W));
    CHECK(report.centre_W.y() > 10.0);
    // Starved, it goes on in the longest step it takes.
    scene.now_s += 10.0;
    scene.loop.step(scene.now_s);
    CHECK(is_finite(report.pose_W));
    scene.loop.silence(scene.now_s);
    REQUIRE(scene.channels->line.take());
    CHECK(scene.channels->line.value().force_W == Vector3::Zero());
    CHECK(scene.channels->line.value().stamp_s == scene.now_s);
}

TEST_CASE("kite loop: a round that comes late flies as the rounds that it stands for") {
    Scene in_time;
    Scene late;
    KiteOrders orders;
    orders.line_m = 24.0;
    orders.wind_m_per_s = 7.0;
    for (Scene* scene : {&in_time, &late}) {
        scene->channels->hand_W.publish(kHand_W);
        scene->channels->orders.publish(orders);
        scene->run(0.002);
    }
    // The hand goes on steadily, and each tells what it is at its rounds.
    const Vector3 velocity_W(0.8, 0.3, -0.2);
    for (int i = 1; i <= 2000; ++i) {
        in_time.channels->hand_W.publish(kHand_W + 0.002 * i * velocity_W);
        in_time.run(0.002);
        if (i % 25 == 0) {
            late.channels->hand_W.publish(kHand_W + 0.002 * i * velocity_W);
            late.now_s = in_time.now_s;
            late.loop.step(late.now_s);
        }
    }
    const KiteReport& one = in_time.loop.flight().report();
    const KiteReport& other = late.loop.flight().report();
    CHECK(one.line_m == Approx(24.0));
    CHECK(other.line_m == Approx(24.0));
    CHECK((one.centre_W - other.centre_W).norm() < 1.0e-6);
    CHECK((one.hand_force_W - other.hand_force_W).norm() < 1.0e-6);
    CHECK(late.loop.flight().line().nodes_W().front() == kHand_W + 4.0 * velocity_W);
}

TEST_CASE(
    "kite loop: a round a little early or late is one step, and none is longer than the longest") {
    Scene scene;
    scene.channels->hand_W.publish(kHand_W);
    scene.run(0.002);
    KiteFlight same{KiteFlightSettings{}};
    same.launch(kHand_W, KiteOrders{}.elevation_rad, KiteOrders{}.lean_rad);
    same.step(0.002, kHand_W);
    for (const double dt_s : {0.0012, 0.0028}) {
        scene.now_s += dt_s;
        scene.loop.step(scene.now_s);
        same.step(scene.now_s - (scene.now_s - dt_s), kHand_W);
    }
    CHECK((scene.loop.flight().report().centre_W - same.report().centre_W).norm() < 1.0e-12);
    scene.now_s += 3600.0;
    scene.loop.step(scene.now_s);
    for (int i = 0; i < 25; ++i) {
        same.step(kLongestKiteStep_s / 25, kHand_W);
    }
    CHECK((scene.loop.flight().report().centre_W - same.report().centre_W).norm() < 1.0e-9);
}

TEST_CASE(
    "kite loop: no sample of a hand throws the kite: one that is none stays, one far off draws") {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    const double infinite = std::numeric_limits<double>::infinity();
    for (const double stretch_N : {500.0, 1.0e5}) {
        KiteFlightSettings settings;
        settings.line.stretch_N = stretch_N;
        const auto channels = std::make_unique<KiteChannels>();
        KiteLoop loop(settings, kRate_Hz, *channels);
        double now_s = 0.0;
        const auto run = [&](double seconds, const Vector3& hand_W) {
            double fastest = 0.0;
            for (int i = 0; i < static_cast<int>(std::lround(seconds * kRate_Hz)); ++i) {
                now_s += 1.0 / kRate_Hz;
                channels->hand_W.publish(hand_W);
                loop.step(now_s);
                fastest = std::max(fastest, loop.flight().report().velocity_W.norm());
            }
            return fastest;
        };
        run(20.0, kHand_W);
        const Vector3 flown_W = loop.flight().report().centre_W;
        for (const Vector3& bad_W :
             {Vector3(nan, 1.0, 0.0), Vector3(0.0, nan, nan), Vector3(infinite, 0.0, 0.0),
              Vector3(0.0, -1.0e300, 0.0), Vector3(0.0, 1.0, 2.0e4)}) {
            run(0.002, bad_W);
            CHECK(loop.flight().line().nodes_W().front() == kHand_W);
        }
        // A hand that is put 30 m elsewhere draws the line there at its own speed; the kite goes along and flies on.
        const Vector3 elsewhere_W = kHand_W + Vector3(0.0, 0.0, 30.0);
        CHECK(run(2.9, elsewhere_W) < 3.0 * kFastestLineHand_m_per_s);
        CHECK(loop.flight().line().nodes_W().front().z() == Approx(29.0).margin(0.03));
        run(30.0, elsewhere_W);
        CHECK(loop.flight().line().nodes_W().front() == elsewhere_W);
        CHECK_FALSE(loop.flight().report().is_snapped);
        CHECK((loop.flight().report().centre_W - flown_W - (elsewhere_W - kHand_W)).norm() < 0.1);
    }
}
