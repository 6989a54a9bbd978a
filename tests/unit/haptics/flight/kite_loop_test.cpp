// The kite's thread (kite_loop.h), and how it is handed another kite (kite_swap.h).
#include "haptics/flight/kite_loop.h"

#include "haptics/flight/kite_swap.h"
#include "tests/support/bad_numbers.h"

#include <catch2/catch.hpp>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <memory>
#include <thread>

using namespace fulcrum;

namespace {

constexpr double kRate_Hz = 500.0;
const Vector3 kHand_W(0.0, 1.0, 0.0);

// A hand and the lesson's orders, 7 m/s of wind among them; it flies once it is told of a hand.
struct Scene {
    std::unique_ptr<KiteChannels> channels = std::make_unique<KiteChannels>();
    KiteLoop loop;
    KiteOrders orders;
    double now_s = 0.0;

    explicit Scene(const KiteFlightSettings& settings = {}) : loop(settings, kRate_Hz, *channels) {
        orders.wind_m_per_s = 7.0;
    }
    void order() const { channels->orders.publish(orders); }
    void hold(const Vector3& hand_W = kHand_W) const { channels->hand_W.publish(hand_W); }
    void step(double dt_s) {
        now_s += dt_s;
        loop.step(now_s);
    }
    void run(double seconds) {
        for (int i = 0; i < static_cast<int>(std::lround(seconds * kRate_Hz)); ++i) {
            step(1.0 / kRate_Hz);
        }
    }
    [[nodiscard]] const KiteReport& report() const { return loop.flight().report(); }
    [[nodiscard]] const KiteLine& line() const { return loop.flight().line(); }
};

}  // namespace

TEST_CASE("kite loop: nothing flies before there is a hand; then the flight is felt and seen") {
    Scene scene;
    scene.run(1.0);
    CHECK_FALSE(scene.channels->frame.take());
    CHECK_FALSE(scene.channels->line.take());
    scene.hold();
    scene.run(20.0);
    REQUIRE(scene.channels->frame.take());
    REQUIRE(scene.channels->line.take());
    const KiteFrame& frame = scene.channels->frame.value();
    CHECK(frame.stamp_s == Approx(scene.now_s));
    CHECK(frame.report.centre_W == scene.report().centre_W);
    CHECK(frame.report.centre_W.y() > 10.0);
    CHECK(frame.n_nodes == LineSettings{}.segments + 1);
    CHECK(frame.line_W[0] == kHand_W);
    CHECK((frame.line_W[16] - frame.report.knot_W).norm() < 1.0e-9);
    const LineState& line = scene.channels->line.value();
    CHECK(line.force_W == frame.report.hand_force_W);
    CHECK(line.force_W.norm() > 1.0);
    CHECK(line.hand_W == kHand_W);
}

TEST_CASE("kite loop: the reel turns at its speed, the wind is the lesson's, a launch is one") {
    Scene scene;
    scene.hold();
    scene.orders.line_m = 25.0;
    scene.order();
    scene.run(1.0);
    CHECK(scene.line().length_m() == Approx(22.0));
    scene.run(4.0);
    CHECK(scene.line().length_m() == Approx(25.0));
    scene.run(10.0);
    const double flown_m = scene.report().centre_W.y();
    scene.orders.n_launches = 1;
    scene.orders.elevation_rad = 0.2;
    scene.order();
    scene.run(0.002);
    CHECK(scene.report().centre_W.y() < 0.5 * flown_m);
    scene.order();
    scene.run(10.0);
    CHECK(scene.report().centre_W.y() > 0.8 * flown_m);
}

TEST_CASE("kite loop: a cut is one, and another kite flies on as much line in the same wind") {
    Scene scene;
    scene.hold();
    scene.orders.line_m = 25.0;
    scene.order();
    scene.run(5.0);
    CHECK(scene.line().length_m() == Approx(25.0));
    KiteFlightSettings other;
    other.kite.shape = KiteShape::sled;
    scene.channels->built.put(std::make_unique<KiteFlight>(other));
    scene.run(0.002);
    CHECK(scene.loop.flight().kite().plates.size() == make_kite(other.kite).plates.size());
    CHECK(scene.line().length_m() == Approx(25.0));
    KiteFlight same(other);
    same.set_line_length_m(25.0);
    same.set_wind_speed_m_per_s(7.0);
    same.launch(kHand_W, scene.orders.elevation_rad, scene.orders.lean_rad);
    same.step(0.002, kHand_W);
    CHECK((scene.report().centre_W - same.report().centre_W).norm() < 1.0e-9);
    scene.orders.n_cuts = 1;
    scene.order();
    scene.run(0.002);
    CHECK(scene.report().is_snapped);
    scene.orders.n_launches = 1;
    scene.order();
    scene.run(0.01);
    CHECK_FALSE(scene.report().is_snapped);
}

TEST_CASE("kite loop: a broken clock, hand or order leaves it flying; silence lets go") {
    Scene scene;
    scene.hold();
    scene.run(5.0);
    scene.loop.step(kNan);
    scene.hold({kNan, 0.0, 0.0});
    scene.orders.n_launches = 7;
    scene.orders.elevation_rad = kNan;
    scene.orders.line_m = kNan;
    scene.orders.wind_m_per_s = kNan;
    scene.order();
    scene.run(5.0);
    const KiteReport& report = scene.report();
    CHECK(is_finite(report.pose_W));
    CHECK(report.centre_W.y() > 10.0);
    // Starved, it goes on in the longest step it takes.
    scene.step(10.0);
    CHECK(is_finite(report.pose_W));
    scene.loop.silence(scene.now_s);
    REQUIRE(scene.channels->line.take());
    CHECK(scene.channels->line.value().force_W == Vector3::Zero());
    CHECK(scene.channels->line.value().stamp_s == scene.now_s);
}

TEST_CASE("kite loop: a round that comes late flies as the rounds that it stands for") {
    Scene in_time;
    Scene late;
    for (Scene* scene : {&in_time, &late}) {
        scene->hold();
        scene->orders.line_m = 24.0;
        scene->order();
        scene->run(0.002);
    }
    // The hand goes on steadily, and each tells what it is at its rounds.
    const Vector3 velocity_W(0.8, 0.3, -0.2);
    for (int i = 1; i <= 2000; ++i) {
        in_time.hold(kHand_W + 0.002 * i * velocity_W);
        in_time.run(0.002);
        if (i % 25 == 0) {
            late.hold(kHand_W + 0.002 * i * velocity_W);
            late.now_s = in_time.now_s;
            late.loop.step(late.now_s);
        }
    }
    const KiteReport& one = in_time.report();
    const KiteReport& other = late.report();
    CHECK(one.line_m == Approx(24.0));
    CHECK(other.line_m == Approx(24.0));
    CHECK((one.centre_W - other.centre_W).norm() < 1.0e-6);
    CHECK((one.hand_force_W - other.hand_force_W).norm() < 1.0e-6);
    CHECK(late.line().nodes_W().front() == kHand_W + 4.0 * velocity_W);
}

TEST_CASE("kite loop: a round a little early or late is one step, and none exceeds the longest") {
    Scene scene;
    scene.hold();
    scene.run(0.002);
    KiteFlight same{KiteFlightSettings{}};
    same.launch(kHand_W, KiteOrders{}.elevation_rad, KiteOrders{}.lean_rad);
    same.step(0.002, kHand_W);
    for (const double dt_s : {0.0012, 0.0028}) {
        scene.step(dt_s);
        same.step(scene.now_s - (scene.now_s - dt_s), kHand_W);
    }
    CHECK((scene.report().centre_W - same.report().centre_W).norm() < 1.0e-12);
    scene.step(3600.0);
    for (int i = 0; i < 25; ++i) {
        same.step(kLongestKiteStep_s / 25, kHand_W);
    }
    CHECK((scene.report().centre_W - same.report().centre_W).norm() < 1.0e-9);
}

TEST_CASE("kite loop: no sample of a hand throws the kite, none stays, one far off draws it") {
    for (const double stretch_N : {500.0, 1.0e5}) {
        KiteFlightSettings settings;
        settings.line.stretch_N = stretch_N;
        Scene scene(settings);
        const auto run = [&](double seconds, const Vector3& hand_W) {
            double fastest = 0.0;
            for (int i = 0; i < static_cast<int>(std::lround(seconds * kRate_Hz)); ++i) {
                scene.hold(hand_W);
                scene.step(1.0 / kRate_Hz);
                fastest = std::max(fastest, scene.report().velocity_W.norm());
            }
            return fastest;
        };
        run(20.0, kHand_W);
        const Vector3 flown_W = scene.report().centre_W;
        for (const Vector3& bad_W :
             {Vector3(kNan, 1.0, 0.0), Vector3(0.0, kNan, kNan), Vector3(kInfinity, 0.0, 0.0),
              Vector3(0.0, -1.0e300, 0.0), Vector3(0.0, 1.0, 2.0e4)}) {
            run(0.002, bad_W);
            CHECK(scene.line().nodes_W().front() == kHand_W);
        }
        // A hand that is put 30 m elsewhere draws the line there at its own speed; the kite goes along and flies on.
        const Vector3 elsewhere_W = kHand_W + Vector3(0.0, 0.0, 30.0);
        CHECK(run(2.9, elsewhere_W) < 3.0 * kFastestLineHand_m_per_s);
        CHECK(scene.line().nodes_W().front().z() == Approx(29.0).margin(0.03));
        run(30.0, elsewhere_W);
        CHECK(scene.line().nodes_W().front() == elsewhere_W);
        CHECK_FALSE(scene.report().is_snapped);
        CHECK((scene.report().centre_W - flown_W - (elsewhere_W - kHand_W)).norm() < 0.1);
    }
}

namespace {

std::unique_ptr<KiteFlight> make_flight(double tail_m) {
    KiteFlightSettings settings;
    settings.kite.tail_m = tail_m;
    return std::make_unique<KiteFlight>(settings);
}

}  // namespace

TEST_CASE("kite swap: what is put is taken once, and the newest of two") {
    KiteSwap swap;
    std::unique_ptr<KiteFlight> flown = make_flight(1.0);
    CHECK(swap.take(flown.get()) == nullptr);
    swap.put(make_flight(2.0));
    swap.put(make_flight(3.0));
    KiteFlight* next = swap.take(flown.get());
    REQUIRE(next != nullptr);
    const std::unique_ptr<KiteFlight> own(next);
    (void)flown.release();  // the swap's now
    CHECK(next->kite().inertia.mass_kg == make_flight(3.0)->kite().inertia.mass_kg);
    CHECK(swap.take(next) == nullptr);
}

TEST_CASE("kite swap: nothing is taken before what came back is freed, and the next put frees it") {
    KiteSwap swap;
    swap.put(make_flight(1.0));
    KiteFlight* first = swap.take(make_flight(0.5).release());
    REQUIRE(first != nullptr);
    swap.put(make_flight(2.0));  // frees what came back
    KiteFlight* second = swap.take(first);
    REQUIRE(second != nullptr);
    const std::unique_ptr<KiteFlight> own(second);
    CHECK(swap.take(second) == nullptr);
}

TEST_CASE("kite swap: two threads hand over hundreds, and each kite is whole") {
    KiteSwap swap;
    std::atomic<bool> ended{false};
    int n_taken = 0;
    std::thread flier([&] {
        KiteFlight* flown = make_flight(0.0).release();
        while (!ended.load(std::memory_order_acquire)) {
            if (KiteFlight* next = swap.take(flown)) {
                flown = next;
                ++n_taken;
                flown->step(0.002, {0.0, 1.0, 0.0});
            }
        }
        const std::unique_ptr<KiteFlight> own(flown);
        CHECK(is_finite(own->report().pose_W));
    });
    for (int i = 0; i < 300; ++i) {
        swap.put(make_flight(0.01 * i));
    }
    ended.store(true, std::memory_order_release);
    flier.join();
    CHECK(n_taken <= 300);
}
