#include "haptics/math/rotation.h"
#include "tests/support/link_trial.h"
#include "tests/unit/haptics/link/held_arm.h"

#include <catch2/catch.hpp>

#include <cmath>
#include <cstdint>

using namespace fulcrum;
using test_link::ArmRounds;
using test_link::Held;
using test_link::kStep_s;
using test_link::LinkCourse;
using test_link::LinkTrial;
using test_link::run_link_trial;
using test_link::with_slow_presses;

namespace {

// Where hand and wall, two springs, meet when nothing moves any more.
double resting_force_N(const LinkTrial& trial) {
    const double hand = trial.arm.human.stiffness_N_per_m;
    const double wall = trial.stiffness_N_per_m;
    return trial.press_m * hand * wall / (hand + wall);
}

constexpr double kForce_N = 3.0;
constexpr double kTorque_Nm = 0.1;

ArmServerSettings at_once() {
    ArmServerSettings settings;
    settings.safety.soft_start_s = 0.0;
    return settings;
}

struct Unpaid {
    Held held{{}, at_once()};
    double given_J = 0.0;  // to the hand
    std::uint64_t sender = 1000;
    std::uint64_t receiver = 2000;
    std::uint64_t sequence = 0;

    Unpaid() {
        REQUIRE(held.pair.link());
        held.run(200);
        held.commands = false;
        // It goes on under the program's numbers.
        sequence = held.pair.device.status().counts.sent;
    }
    void send(PacketKind kind, const Wrench& wrench_D) {
        LinkPacket packet = test_link::make_numbered(kind, {sender, receiver, ++sequence},
                                                     LinkPost::to_ns(held.pair.now_s + kStep_s));
        packet.command.wrench_D = wrench_D;
        packet.command.max_force_N = 10.0;
        packet.command.max_torque_Nm = 1.0;
        packet.command.max_slew_N_per_s = SafetySettings{}.max_slew_N_per_s;
        held.send(packet);
    }
    // The hand goes at `speed` along x, or turns about it, for `seconds`; its arm shows that in steps of `seen`, in every so many rounds.
    void run_seen(double seconds, const Wrench& wrench_D, double speed, double seen, int every) {
        const bool turns = wrench_D.torque.squaredNorm() > 0.0;
        double gone = 0.0;
        double shown = 0.0;
        for (int i = 0; i < static_cast<int>(std::lround(seconds / kStep_s)); ++i) {
            send(PacketKind::command, wrench_D);
            gone += speed * kStep_s;
            given_J += (turns ? held.hand.written_D.torque.x() : held.felt_N()) * speed * kStep_s;
            if (i % every == 0) {
                const double step = seen * std::floor((gone - shown) / seen);
                shown += step;
                if (turns) {
                    held.hand.pose_D.orientation =
                        compute_exp(step * Vector3::UnitX()) * held.hand.pose_D.orientation;
                } else {
                    held.hand.pose_D.position.x() += step;
                }
            }
            held.run(1);
        }
    }
    // In each round the hand has gone `way` and turned by `turn` under what was written last.
    void run(int n, const Wrench& wrench_D, const Vector3& way, const Vector3& turn) {
        for (int i = 0; i < n; ++i) {
            send(PacketKind::command, wrench_D);
            held.hand.pose_D.position += way;
            held.hand.pose_D.orientation = compute_exp(turn) * held.hand.pose_D.orientation;
            given_J += held.hand.written_D.force.dot(way) + held.hand.written_D.torque.dot(turn);
            held.run(1);
        }
    }
};

constexpr double kSlow_m = 2.0e-5;
constexpr double kSlow_rad = 1.0e-3;

}  // namespace

TEST_CASE("link energy: a wall that a delay makes active throws the hand, with the balance not") {
    for (const double delay_s : {0.01, 0.02}) {
        LinkTrial trial{.stiffness_N_per_m = 400.0, .faults = {.delay_s = delay_s}};
        trial.balances_energy = false;
        const LinkCourse bare = run_link_trial(trial);
        CHECK(bare.given_J > 1.0);
        trial.balances_energy = true;
        const LinkCourse balanced = run_link_trial(trial);
        INFO("delay " << delay_s << " s: " << bare.given_J << " J and " << balanced.given_J
                      << " J");
        REQUIRE(balanced.linked);
        CHECK(balanced.given_J < 0.05);
        CHECK(balanced.trips == 0);
        CHECK(balanced.peak_N < 4.0);
    }
}

TEST_CASE(
    "link energy: the lightest handle is not thrown either, and what is calm keeps its force") {
    for (const double stiffness : {600.0, 1000.0, 2000.0}) {
        for (const double delay_s : {0.005, 0.025}) {
            LinkTrial trial{.stiffness_N_per_m = stiffness, .faults = {.delay_s = delay_s}};
            trial.arm.mass_kg = 0.045;
            const LinkCourse course = run_link_trial(trial);
            INFO(stiffness << " N/m, " << delay_s << " s: " << course.given_J << " J");
            REQUIRE(course.linked);
            CHECK(course.given_J < 0.1);
        }
    }
    for (const double delay_s : {0.0, 0.002, 0.005}) {
        const LinkTrial trial{.stiffness_N_per_m = 100.0, .faults = {.delay_s = delay_s}};
        const LinkCourse course = run_link_trial(trial);
        INFO("delay " << delay_s);
        REQUIRE(course.is_calm());
        // An encoder whose last step comes and goes spends at rest what fades: 2.9 % of the force with steps of 55 um, 0.01 % without any.
        CHECK(-course.force_N == Approx(resting_force_N(trial)).epsilon(0.035));
        LinkTrial fine = trial;
        fine.arm.position_resolution_m = 0.0;
        CHECK(-run_link_trial(fine).force_N == Approx(resting_force_N(fine)).epsilon(0.001));
    }
}

TEST_CASE("link energy: loss, jitter, doubles and damage give the hand no energy either") {
    for (std::uint64_t seed = 1; seed <= 5; ++seed) {
        const LinkTrial trial{.stiffness_N_per_m = 300.0,
                              .faults = {.loss = 0.05,
                                         .burst = 8,
                                         .delay_s = 0.002,
                                         .jitter_s = 0.003,
                                         .reorder = 0.1,
                                         .duplicate = 0.1,
                                         .corrupt = 0.01,
                                         .seed = seed}};
        const LinkCourse course = run_link_trial(trial);
        INFO("seed " << seed);
        REQUIRE(course.linked);
        CHECK(course.given_J < 0.05);
        CHECK(course.peak_N < 4.0);
    }
}

TEST_CASE("link energy: an arm whose rounds come unevenly, or are half as many, throws nobody") {
    // As a thread is that others keep from running; one round right after the next; and 500 Hz.
    const ArmRounds kinds[] = {{.jitter_s = 0.95e-3},
                               {.late_chance = 0.3, .late_s = 0.006},
                               {.jitter_s = 0.95e-3, .late_chance = 0.05, .late_s = 0.01},
                               {.every = 2}};
    for (const ArmRounds& rounds : kinds) {
        for (const double stiffness : {500.0, 2000.0}) {
            for (const double delay_s : {0.0, 0.005}) {
                LinkTrial trial{.stiffness_N_per_m = stiffness, .faults = {.delay_s = delay_s}};
                trial.arm.mass_kg = 0.045;
                trial.rounds = rounds;
                trial.seconds = 6.0;
                const LinkCourse course = run_link_trial(trial);
                INFO("every " << rounds.every << ", late " << rounds.late_s << " s, " << stiffness
                              << " N/m, " << delay_s << " s: " << course.given_J << " J");
                REQUIRE(course.linked);
                CHECK(course.given_J < 0.1);
                CHECK(course.trips == 0);
            }
        }
    }
}

TEST_CASE("link energy: the brake stays below the least limit, and its debt is paid later") {
    for (const double limit_N : {0.5, 1.0, 2.0}) {
        for (const double mass_kg : {0.045, 0.25, 1.0}) {
            LinkTrial trial{.stiffness_N_per_m = 2000.0,
                            .faults = {.delay_s = 0.02},
                            .press_m = 0.04,
                            .limit_N = limit_N,
                            .stroke_m = 0.01};
            trial.arm.mass_kg = mass_kg;
            const LinkCourse course = run_link_trial(trial);
            INFO(limit_N << " N, " << mass_kg << " kg: peak " << course.peak_N << " N, debt "
                         << course.peak_debt_J << " J, then down to " << course.least_later_J
                         << " J");
            REQUIRE(course.linked);
            CHECK(course.peak_N <= limit_N);
            CHECK(course.peak_N > 0.99 * limit_N);
            CHECK(course.peak_debt_J > 2.0e-4);
            CHECK(course.least_later_J == 0.0);
        }
    }
}

TEST_CASE("link energy: slow presses give no more than is lent, and the same trial the same bits") {
    for (const double stiffness : {500.0, 1000.0}) {
        for (const double delay_s : {0.0, 0.01, 0.02, 0.05, 0.095}) {
            const LinkTrial trial = with_slow_presses(
                {.stiffness_N_per_m = stiffness, .faults = {.delay_s = delay_s}}, 3);
            const LinkCourse course = run_link_trial(trial);
            INFO(stiffness << " N/m, " << delay_s << " s: net " << course.net_J << " J, debt "
                           << course.peak_debt_J << " J");
            REQUIRE(course.linked);
            CHECK(course.trips == 0);
            CHECK(course.peak_debt_J < 2.0e-3);
            // Half of it: what brakes takes some.
            CHECK(course.net_J < 0.5 * trial.energy.lent_W * trial.seconds);
            CHECK(course.net_J > (delay_s < 0.05 ? -1.0e-3 : 5.0e-4));
            if (delay_s == 0.0) {
                CHECK(course.net_J < 5.0e-4);
            }
        }
    }
    const LinkTrial trial{.faults = {.loss = 0.1, .jitter_s = 0.004, .seed = 4}, .seconds = 3.0};
    const LinkCourse a = run_link_trial(trial);
    const LinkCourse b = run_link_trial(trial);
    CHECK(a.given_J == b.given_J);
    CHECK(a.peak_N == b.peak_N);
    CHECK(a.swing_m == b.swing_m);
}

// What the arm gives to a hand while nobody has put it in, by commands made by hand: their sums of energy stay zero.

TEST_CASE("link: force and torque that nobody has paid for are left out along the way") {
    const Vector3 x = Vector3::UnitX();
    const Vector3 none = Vector3::Zero();
    for (const bool turns : {false, true}) {
        CAPTURE(turns);
        Unpaid arm;
        arm.run(10, {}, none, none);
        if (turns) {
            arm.run(500, {none, kTorque_Nm * x}, none, kSlow_rad * x);
        } else {
            arm.run(500, {kForce_N * x, none}, kSlow_m * x, none);
        }
        // Without the balance 30 mJ or 50 mJ. Headroom and what is borne are 1.5 mJ.
        CHECK(arm.given_J > 0.0);
        CHECK(arm.given_J < 2.5e-3);
    }
}

TEST_CASE("link: nor is it where an encoder or every second round shows the hand's way in steps") {
    struct Seen {
        double speed, step;  // metres, or radians for a torque
        int every;
        bool turns;
    };
    const double encoder_m = 5.5e-5;
    for (const Seen& seen : {Seen{0.005, encoder_m, 1, false}, Seen{0.01, encoder_m, 1, false},
                             Seen{0.02, encoder_m, 1, false}, Seen{0.1, encoder_m, 1, false},
                             Seen{0.1, 1.0e-6, 2, false}, Seen{0.02, encoder_m, 2, false},
                             Seen{0.2, 1.5e-3, 1, true}, Seen{1.0, 1.5e-3, 2, true}}) {
        CAPTURE(seen.speed, seen.every, seen.turns);
        Unpaid arm;
        Wrench asked{Vector3::Zero(), Vector3::Zero()};
        (seen.turns ? asked.torque : asked.force).x() = seen.turns ? kTorque_Nm : kForce_N;
        arm.run(10, {}, Vector3::Zero(), Vector3::Zero());
        arm.run_seen(2.0, asked, seen.speed, seen.step, seen.every);
        // Without the balance 30 to 600 mJ, and as much where only the rounds that show motion are looked at. The brake may take
        // more than was given, for what it takes counts by the lesser force: a drag of a tenth of a newton.
        CHECK(arm.given_J > -0.1 * (seen.turns ? 0.1 : 1.0) * 2.0 * seen.speed);
        CHECK(arm.given_J < 3.0e-3);
    }
}

TEST_CASE("link: a hand that seems to rest is given one encoder's step at a time") {
    Unpaid arm;
    const Wrench asked{kForce_N * Vector3::UnitX(), Vector3::Zero()};
    arm.run(10, {}, Vector3::Zero(), Vector3::Zero());
    arm.run_seen(2.0, asked, 0.0005, 5.5e-5, 1);
    CHECK(arm.given_J < 2.0 * kForce_N * 5.5e-5 / SeenWay::kRests_s);
    // Where it rests it has the whole force.
    arm.run_seen(0.2, asked, 0.0, 5.5e-5, 1);
    CHECK(arm.held.felt_N() == Approx(kForce_N));
}

TEST_CASE("link: the brake ends 50 ms after nothing is asked for; a new holder has no debt") {
    Unpaid arm;
    const Vector3 x = Vector3::UnitX();
    const Wrench asked{kForce_N * x, Vector3::Zero()};
    arm.run(10, {}, Vector3::Zero(), Vector3::Zero());
    arm.run(100, asked, kSlow_m * x, Vector3::Zero());
    REQUIRE(arm.held.felt_N() < 0.5);  // in debt
    // The hand goes on, and is braked for a while, ever less.
    arm.run(20, {}, kSlow_m * x, Vector3::Zero());
    const double early_N = -arm.held.felt_N();
    CHECK(early_N > 0.02);
    arm.run(20, {}, kSlow_m * x, Vector3::Zero());
    CHECK(-arm.held.felt_N() > 0.0);
    CHECK(-arm.held.felt_N() < early_N);
    for (int i = 0; i < 40; ++i) {
        arm.run(1, {}, kSlow_m * x, Vector3::Zero());
        CHECK((i < 12 || arm.held.hand.written_D.force.norm() == 0.0));
    }
    // Another holds it, and is given what he asks for.
    arm.send(PacketKind::bye, {});
    arm.held.run(1);
    REQUIRE_FALSE(arm.held.arm().held);
    arm.sender = 5000;
    arm.receiver = 2001;
    arm.sequence = 0;
    arm.run(200, {}, Vector3::Zero(), Vector3::Zero());  // the last one's force has faded
    REQUIRE(arm.held.arm().held);
    arm.run(5, asked, kSlow_m * x, Vector3::Zero());
    CHECK(arm.held.felt_N() > 2.7);
}
