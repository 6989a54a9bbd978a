#include "haptics/coupling/passivity.h"

#include "haptics/math/rotation.h"
#include "tests/support/bad_numbers.h"

#include <catch2/catch.hpp>

#include <cmath>
#include <functional>
#include <rapidcheck.h>

using namespace fulcrum;

namespace {

constexpr double kDt_s = 0.001;
constexpr double kRounding_J = 1e-15;

// Nothing is forgotten, to speak of.
PassivitySettings make_settings(double headroom_J = 0.0) {
    PassivitySettings settings;
    settings.headroom_J = headroom_J;
    settings.memory_s = 1e12;
    return settings;
}

// A port behind a gate that lets `share` of everything through.
struct Port {
    explicit Port(const PassivitySettings& settings = make_settings(),
                  const PortLimits& limits = {})
        : controller(settings, limits) {}

    // Moves the hand by `motion` into a place where the scene's elastic force is `elastic` and its dampers' `damper`.
    Vector3 move(const Vector3& motion, const ElasticForce& elastic,
                 const Vector3& damper = Vector3::Zero(), double dt_s = kDt_s) {
        PortRound round;
        round.motion = motion;
        round.elastic = elastic;
        round.asked = elastic.now_W + damper;
        round.dt_s = dt_s;
        const Vector3 brake = controller.step(round);
        controller.sent(share * (round.asked + brake));
        return brake;
    }
    Vector3 move(const Vector3& motion, const Vector3& elastic,
                 const Vector3& damper = Vector3::Zero(), double dt_s = kDt_s) {
        return move(motion, ElasticForce{elastic, elastic}, damper, dt_s);
    }
    [[nodiscard]] double excess_J() const { return controller.energy().excess_J; }

    PassivityController controller;
    double share = 1.0;
};

}  // namespace

TEST_CASE("passivity: a held spring leaks k d^2 / 2 a period, in any direction") {
    CHECK(rc::check([](int k, int x, int y, int z) {
        const double stiffness = 1.0 + std::abs(k % 5000);
        const Vector3 start = 1e-5 * Vector3(y % 100, z % 100, x % 100);
        const Vector3 d = 1e-6 * Vector3(x % 1000, y % 1000, z % 1000);
        Port port;
        (void)port.move(Vector3::Zero(), Vector3(-stiffness * start));
        (void)port.move(d, Vector3(-stiffness * (start + d)));
        RC_ASSERT(std::abs(port.excess_J() - 0.5 * stiffness * d.squaredNorm()) < kRounding_J);
    }));
}

TEST_CASE("passivity: a damper of more than k T / 2 leaves nothing to take, one of less does") {
    CHECK(rc::check([](int k, int b, int x, int y) {
        const double stiffness = 1.0 + std::abs(k % 3000);
        const double ratio = 0.5 + 0.01 * std::abs(b % 100);  // of the line
        const double damping = ratio * 0.5 * stiffness * kDt_s;
        const Vector3 d = 1e-6 * Vector3(1 + std::abs(x % 500), y % 500, 0);
        Port port;
        (void)port.move(Vector3::Zero(), Vector3(Vector3::Zero()));
        // The damper's force of each round is held for the next period.
        (void)port.move(Vector3::Zero(), Vector3(Vector3::Zero()), -damping * d / kDt_s);
        bool braked = false;
        const int n = 50;
        for (int i = 1; i <= n; ++i) {
            braked = port.move(d, Vector3(-stiffness * i * d), -damping * d / kDt_s).norm() > 0.0 ||
                     braked;
        }
        const bool leaks = n * (1.0 - ratio) * 0.5 * stiffness * d.squaredNorm() > 1e-9;
        const bool right = ratio >= 1.0 ? !braked : braked || !leaks;
        RC_ASSERT(right);
    }));
}

TEST_CASE("passivity: neither a weight's work nor what the scene changes is the hand's excess") {
    Port port(make_settings(1e-4));
    const Vector3 weight(0.0, -3.0, 0.0);
    (void)port.move(Vector3::Zero(), weight);
    for (int k = 0; k < 2000; ++k) {
        const Vector3 d(1e-4 * std::sin(0.1 * k), k < 1000 ? -0.001 : 0.001, 0.0);
        REQUIRE(port.move(d, weight).norm() == 0.0);
        REQUIRE(port.excess_J() == 0.0);
    }
    CHECK(port.controller.energy().peak_J == 0.0);
    // An anchor jumps, a field is switched, an answer comes: the force is another one, the hand is where it was.
    port = Port();
    (void)port.move(Vector3::Zero(), Vector3(2.0, 0.0, 0.0));
    (void)port.move(Vector3(0.001, 0, 0),
                    ElasticForce{Vector3(-4.0, 1.0, 0.0), Vector3(2.0, 0.0, 0.0)});
    CHECK(port.excess_J() == 0.0);
    // The period after it is held at the new force, and leaks by the new slope.
    (void)port.move(Vector3(0.001, 0, 0), Vector3(-4.5, 1.0, 0.0));
    CHECK(port.excess_J() == Approx(0.5 * 500.0 * 1e-6));
}

TEST_CASE("passivity: hand and anchor that go on together get what was held, and no excess") {
    // A spring whose anchor moves evenly with the hand, or half as fast, or back: only the change of its stretch leaks.
    constexpr double kStiffness = 500.0;
    const Vector3 d(0.001, 0.0, 0.0);
    for (const double anchor_share : {1.0, 0.5, -1.0}) {
        Port port;
        const auto spring = [&](int n) {
            return Vector3(-kStiffness * (0.002 * Vector3::UnitX() + n * (1.0 - anchor_share) * d));
        };
        (void)port.move(Vector3::Zero(), spring(0));
        (void)port.move(d, spring(1));
        const double stretched = 1.0 - anchor_share;
        CHECK(port.excess_J() ==
              Approx(0.5 * kStiffness * stretched * d.squaredNorm()).margin(kRounding_J));
    }
}

TEST_CASE("passivity: the brake opposes the motion, takes what will be due, and is bounded") {
    constexpr double kStiffness = 200.0;
    const Vector3 d(3e-5, -4e-5, 0.0);
    Port port;
    (void)port.move(Vector3::Zero(), Vector3(Vector3::Zero()));
    const Vector3 brake = port.move(d, Vector3(-kStiffness * d));
    const double leak_J = 0.5 * kStiffness * d.squaredNorm();
    // Due at the end of the next period: this one's leak and the next one's.
    CHECK(brake.dot(d) == Approx(-2.0 * leak_J));
    CHECK(brake.cross(d).norm() < 1e-15);
    (void)port.move(d, Vector3(-2.0 * kStiffness * d));
    CHECK(std::abs(port.excess_J()) < 1e-6 * leak_J);
    CHECK(port.controller.energy().braked_J == Approx(2.0 * leak_J));
    CHECK(port.controller.energy().peak_J == Approx(leak_J));

    // A steep spring asks for more than the bound m / 8 T = 5.6 Ns/m of the bare handle.
    Port steep;
    (void)steep.move(Vector3::Zero(), Vector3(Vector3::Zero()));
    const Vector3 bounded = steep.move(d, Vector3(-50000.0 * d));
    CHECK(steep.controller.largest_damping() == Approx(0.045 / 0.008));
    CHECK(bounded.norm() == Approx(0.045 / 0.008 * d.norm() / kDt_s));
    CHECK(bounded.dot(d) < 0.0);
    CHECK(Port(make_settings(), {0.045, 0.0, 0.00025}).controller.largest_damping() ==
          Approx(0.045 / 0.002));
}

TEST_CASE("passivity: a brake that was sent is no share that the gate kept back") {
    // The spring pushes along the motion and the brake against it, so that less is sent than the scene alone asks for.
    constexpr double kStiffness = 200.0;
    const Vector3 d(1e-4, 0.0, 0.0);
    for (const double share : {1.0, 0.5}) {
        Port port;
        port.share = share;
        const auto pull = [&](int i) { return Vector3(kStiffness * (10 - i) * d); };
        (void)port.move(Vector3::Zero(), pull(0));
        const Vector3 brake = port.move(d, pull(1));
        const double leak_J = share * 0.5 * kStiffness * d.squaredNorm();
        CHECK(port.excess_J() == Approx(leak_J));
        CHECK(brake.x() == Approx(-2.0 * leak_J / d.x()));
        (void)port.move(d, pull(2));
        CHECK(port.controller.energy().braked_J == Approx(share * 2.0 * leak_J));
        CHECK(port.excess_J() == Approx(2.0 * leak_J - share * 2.0 * leak_J).margin(1e-6 * leak_J));
    }
}

TEST_CASE("passivity: a spring that pushes away promises nothing for the period to come") {
    const Vector3 d(1e-4, 0.0, 0.0);
    Port away;
    (void)away.move(Vector3::Zero(), Vector3(Vector3::Zero()));
    away.controller.sent(Vector3(0.06, 0.0, 0.0));
    CHECK(away.move(d, Vector3(0.1, 0.0, 0.0)).x() == Approx(-0.01));
    CHECK(away.excess_J() == Approx((0.06 - 0.05) * 1e-4));
}

TEST_CASE("passivity: the brake takes a wall's push and makes no pull of it") {
    const Vector3 up = Vector3::UnitY();
    const auto brake = [&](double push_N, const Vector3& motion) {
        PassivityController controller(make_settings(), {});
        PortRound round;
        round.dt_s = kDt_s;
        (void)controller.step(round);
        controller.sent(1e6 * motion);  // an excess of far more than the brake can take
        round.motion = motion;
        round.normal = up;
        round.push = push_N;
        round.asked = round.elastic.now_W = push_N * up;
        return controller.step(round);
    };
    const double full_N = 0.045 / 0.008 * 1e-4 / kDt_s;  // 0.56 N
    CHECK((brake(0.2, 1e-4 * up) + 0.2 * up).norm() < 1e-12);
    CHECK((brake(2.0, 1e-4 * up) + full_N * up).norm() < 1e-12);
    // Inwards it pushes, and along the surface it drags, as it likes.
    CHECK((brake(0.2, -1e-4 * up) - full_N * up).norm() < 1e-12);
    const Vector3 aslant = brake(0.2, 1e-4 * Vector3(1, 1, 0));
    CHECK(aslant.x() == Approx(-full_N));
    CHECK(aslant.y() == Approx(-0.2));
}

TEST_CASE("passivity: all axes are alike") {
    CHECK(rc::check([](int x, int y, int z) {
        const Quaternion turn = compute_exp(1e-3 * Vector3(x % 3000, y % 3000, z % 3000));
        Port plain;
        Port turned;
        Vector3 at = Vector3::Zero();
        for (int k = 0; k < 40; ++k) {
            const Vector3 d = 1e-4 * Vector3(std::sin(0.7 * k), std::cos(0.3 * k), 0.3);
            at += d;
            const Vector3 pull(-1500.0 * at.x(), -300.0 * at.y(), 0.0);
            const Vector3 brake = plain.move(d, pull);
            RC_ASSERT((turned.move(turn * d, Vector3(turn * pull)) - turn * brake).norm() < 1e-9);
            RC_ASSERT(std::abs(turned.excess_J() - plain.excess_J()) < 1e-12);
        }
    }));
}

TEST_CASE("passivity: the gate's share counts, whatever it is") {
    const Vector3 d(1e-4, 0.0, 0.0);
    const auto leak = [&](double share) {
        Port port;
        port.share = share;
        (void)port.move(Vector3::Zero(), Vector3(-2.0, 0.0, 0.0));
        (void)port.move(d, Vector3(-2.1, 0.0, 0.0));
        return port.excess_J();
    };
    CHECK(leak(1.0) == Approx(0.5 * 1000.0 * 1e-8));
    CHECK(leak(0.5) == Approx(0.25 * 1000.0 * 1e-8));
    CHECK(leak(0.0) == 0.0);  // waiting: nothing is felt, nothing is due
    // A gate that lags holds a force that nobody asks for any more: all that it gives is excess.
    Port port;
    (void)port.move(Vector3::Zero(), Vector3(-2.0, 0.0, 0.0));
    port.controller.sent(Vector3(3.0, 0.0, 0.0));
    (void)port.move(d, Vector3(-2.0, 0.0, 0.0));
    CHECK(port.excess_J() == Approx(3.0 * 1e-4));
    // One that is late in letting go, likewise what is beyond what was asked.
    Port late;
    (void)late.move(Vector3::Zero(), Vector3(2.0, 0.0, 0.0));
    late.controller.sent(Vector3(3.0, 0.0, 0.0));
    (void)late.move(d, Vector3(2.0, 0.0, 0.0));
    CHECK(late.excess_J() == Approx(1.0 * 1e-4));
    // And a damper that the gate sent though the scene asked for nothing takes.
    Port damped(make_settings(1.0));
    (void)damped.move(Vector3::Zero(), Vector3(Vector3::Zero()));
    damped.controller.sent(Vector3(-3.0, 0.0, 0.0));
    (void)damped.move(d, Vector3(Vector3::Zero()));
    CHECK(damped.excess_J() == Approx(-3.0 * 1e-4));
}

TEST_CASE(
    "passivity: the clock's jitter does not change what is counted, only what friction takes") {
    const Vector3 d(1e-4, 0.0, 0.0);
    for (const double dt_s : {0.0002, 0.001, 0.005, 0.1}) {
        const auto excess_J = [&](double device_damping) {
            Port port(make_settings(1.0), {0.045, device_damping, 0.001});
            (void)port.move(Vector3::Zero(), Vector3(-1.0, 0.0, 0.0));
            (void)port.move(d, Vector3(-1.1, 0.0, 0.0), Vector3::Zero(), dt_s);
            return port.excess_J();
        };
        CHECK(excess_J(0.0) == Approx(0.5 * 1000.0 * 1e-8));
        CHECK(excess_J(0.0) - excess_J(2.0) == Approx(2.0 * 1e-8 / dt_s));
    }
}

TEST_CASE("passivity: what dampers earn is little and soon forgotten, and so is an excess") {
    PassivitySettings settings;
    settings.headroom_J = 1e-4;
    settings.memory_s = 0.1;
    Port port(settings);
    for (int k = 0; k < 5000; ++k) {  // five seconds in honey: 50 mJ
        (void)port.move(Vector3(1e-4, 0, 0), Vector3(Vector3::Zero()), Vector3(-0.1, 0, 0));
    }
    CHECK(port.excess_J() == -settings.headroom_J);
    for (int k = 0; k < 100; ++k) {
        (void)port.move(Vector3::Zero(), Vector3(Vector3::Zero()));
    }
    CHECK(port.excess_J() == Approx(-settings.headroom_J * std::exp(-1.0)).epsilon(0.01));

    Port leaky(settings);
    (void)leaky.move(Vector3::Zero(), Vector3(Vector3::Zero()));
    (void)leaky.move(Vector3(1e-3, 0, 0), Vector3(-1.0, 0, 0));
    const double before_J = leaky.excess_J();
    CHECK(before_J == Approx(5e-4));
    for (int k = 0; k < 100; ++k) {
        (void)leaky.move(Vector3::Zero(), Vector3(-1.0, 0, 0));
    }
    CHECK(leaky.excess_J() == Approx(before_J * std::exp(-1.0)).epsilon(0.01));
    // A pause longer than the memory forgets all, and turns nothing round.
    (void)leaky.move(Vector3::Zero(), Vector3(-1.0, 0, 0), Vector3::Zero(), 1.0);
    CHECK(leaky.excess_J() == 0.0);
}

TEST_CASE("passivity: what is not a number begins anew and leaves no trace") {
    const Vector3 d(1e-4, 0.0, 0.0);
    const auto spoil = [&](const std::function<void(PortRound&)>& change) {
        Port port;
        (void)port.move(Vector3::Zero(), Vector3(-1.0, 0.0, 0.0));
        (void)port.move(d, Vector3(-1.2, 0.0, 0.0));
        PortRound round;
        round.motion = d;
        round.asked = Vector3(-1.0, 0, 0);
        round.dt_s = kDt_s;
        change(round);
        CHECK(port.controller.step(round).norm() == 0.0);
        CHECK(port.excess_J() == 0.0);
        port.controller.sent(Vector3(kNan, 0, 0));
        (void)port.move(d, Vector3(-1.0, 0.0, 0.0));
        CHECK(port.excess_J() == 0.0);
        (void)port.move(d, Vector3(-1.1, 0.0, 0.0));
        CHECK(port.excess_J() == Approx(0.5 * 1000.0 * 1e-8));
        CHECK(std::isfinite(port.controller.energy().peak_J));
        CHECK(std::isfinite(port.controller.energy().braked_J));
    };
    for (const double bad : {kNan, kInfinity, -1e300, 1e300}) {
        spoil([&](PortRound& round) { round.motion.y() = bad; });
        spoil([&](PortRound& round) { round.asked.x() = bad; });
        spoil([&](PortRound& round) { round.elastic.now_W.z() = bad; });
        spoil([&](PortRound& round) { round.elastic.held_W.x() = bad; });
        spoil([&](PortRound& round) { round.kink_J = bad; });
    }
    for (const double bad : {kNan, 0.0, -0.001, kInfinity}) {
        spoil([&](PortRound& round) { round.dt_s = bad; });
    }
}

TEST_CASE("passivity: where a contact begins and ends, the wall's own energy is the measure") {
    constexpr double kStiffness = 800.0;
    constexpr double kDepth_m = 3e-4;
    constexpr double kGap_m = 2e-4;
    const Vector3 up = Vector3::UnitY();
    const ContactSpring none;
    const ContactSpring touching{kStiffness * kDepth_m * up,
                                 0.5 * kStiffness * kDepth_m * kDepth_m};
    const double energy_J = touching.energy_J;
    const auto ideal_J = [&](const ContactSpring& before, const ContactSpring& now,
                             const Vector3& motion) {
        return 0.5 * (before.force + now.force).dot(motion) + compute_kink_J(before, now, motion);
    };
    // Through the gap and into the wall, and back: the wall takes and gives its energy, no more.
    CHECK(ideal_J(none, touching, -(kDepth_m + kGap_m) * up) == Approx(-energy_J));
    CHECK(ideal_J(touching, none, (kDepth_m + kGap_m) * up) == Approx(energy_J));
    // Aslant likewise.
    const Vector3 aslant = -(kDepth_m + kGap_m) * up + 0.001 * Vector3::UnitX();
    CHECK(ideal_J(none, touching, aslant) == Approx(-energy_J));
    CHECK(ideal_J(touching, none, -aslant) == Approx(energy_J));
    // A wall that comes to a hand at rest, or leaves it, takes nothing from the hand.
    CHECK(ideal_J(none, touching, Vector3::Zero()) == 0.0);
    CHECK(ideal_J(touching, none, Vector3::Zero()) == 0.0);
    // Half way the wall's, half the hand's motion: the trapezoid stands where it claims less.
    CHECK(ideal_J(none, touching, -0.5 * kDepth_m * up) == Approx(-0.5 * energy_J));
    CHECK(ideal_J(touching, none, 0.5 * kDepth_m * up) == Approx(0.5 * energy_J));
    // While it lasts there is none.
    CHECK(compute_kink_J(touching, touching, -kDepth_m * up) == 0.0);
    CHECK(compute_kink_J(none, none, -kDepth_m * up) == 0.0);
}

TEST_CASE("passivity: a bounce without a damper, counted to the end") {
    // In by 0.3 mm and out: the hold took nothing on the way in and gave 0.24 N over 0.5 mm on the way out.
    constexpr double kStiffness = 800.0;
    const auto spring = [](double y_m) {
        return y_m < 0.0
                   ? ContactSpring{Vector3(0, -kStiffness * y_m, 0), 0.5 * kStiffness * y_m * y_m}
                   : ContactSpring{};
    };
    PassivityController controller(make_settings(), {1e-9, 0.0, 0.001});  // as good as no brake
    ContactSpring before;
    double y_m = 2e-4;
    double given_J = 0.0;
    double held_N = 0.0;
    for (const double next_m : {2e-4, -3e-4, 2e-4, 4e-4}) {
        PortRound round;
        round.motion = Vector3(0, next_m - y_m, 0);
        const ContactSpring now = spring(next_m);
        round.asked = round.elastic.now_W = round.elastic.held_W = now.force;
        round.kink_J = compute_kink_J(before, now, round.motion);
        round.dt_s = kDt_s;
        given_J += held_N * round.motion.y();
        controller.sent(round.asked + controller.step(round));
        held_N = now.force.y();
        before = now;
        y_m = next_m;
    }
    CHECK(given_J == Approx(0.24 * 5e-4));
    CHECK(controller.energy().excess_J == Approx(given_J));
}
