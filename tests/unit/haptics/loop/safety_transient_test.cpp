// What the gate lets through beyond the slew: a tap, and of a kick no more than it says. FULCRUM_GATE_CALLS: how many calls try it.
#include "haptics/loop/safety.h"
#include "tests/unit/haptics/loop/safety_fixture.h"

#include <catch2/catch.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <numbers>
#include <random>
#include <vector>

using namespace fulcrum;

namespace {

SafetySettings without_transients() {
    SafetySettings settings;
    settings.max_transient_N = 0.0;
    return settings;
}

// A gate as it ships, and one of the same slew that lets nothing beyond it through: what they differ by is the transient.
struct Pair {
    SafetyGate shipped = open_gate(SafetySettings{}, 0.0);
    SafetyGate base = open_gate(without_transients(), 0.0);
    Vector3 force_N{Vector3::Zero()};
    Vector3 beyond_N{Vector3::Zero()};

    void pass(const Vector3& commanded_N, double dt_s = kDt_s, Fault fault = Fault::none) {
        const Wrench commanded{commanded_N, Vector3::Zero()};
        force_N = shipped.pass(commanded, fault, dt_s).force;
        const Vector3 lasting_N = base.pass(commanded, fault, dt_s).force;
        REQUIRE(shipped.phase() == base.phase());
        // What fades is another after a transient, and none itself.
        beyond_N = shipped.phase() == GatePhase::open ? Vector3(force_N - lasting_N)
                                                      : Vector3(Vector3::Zero());
    }
};

// What is counted of it, as the head of safety.h has it; the most of each as a share of its bound.
struct Counted {
    SafetySettings settings{};
    Vector3 impulse_Ns{Vector3::Zero()};
    double ringing_N2s = 0.0;
    std::vector<double> squares_N2s = std::vector<double>(1000, 0.0);  // of the last so many calls
    std::vector<double> times_s = std::vector<double>(1000, 0.0);
    std::size_t next = 0;
    double force = 0.0;
    double swing = 0.0;
    double impulse = 0.0;
    double ringing = 0.0;
    double square = 0.0;  // over that window

    // What the call before gave was held for `dt_s`.
    void count(const Pair& pair, double dt_s) {
        const double beyond_N = pair.beyond_N.norm();
        const double held_N2s = held_N_.squaredNorm() * dt_s;
        impulse_Ns = (impulse_Ns + held_N_ * dt_s) * (1.0 - dt_s / kImpulseMemory_s);
        ringing_N2s = (ringing_N2s + held_N2s) * (1.0 - dt_s / kRingingMemory_s);
        held_N_ = pair.beyond_N;
        window_N2s_ += held_N2s - squares_N2s[next];
        window_s_ += dt_s - times_s[next];
        squares_N2s[next] = held_N2s;
        times_s[next] = dt_s;
        next = (next + 1) % squares_N2s.size();
        force = std::max(force, pair.force_N.norm() / settings.max_force_N);
        swing = std::max(swing, beyond_N / settings.max_transient_N);
        impulse = std::max(impulse, impulse_Ns.norm() / settings.transient_Ns);
        ringing = std::max(ringing, ringing_N2s / settings.transient_N2s);
        square = std::max(
            square, window_N2s_ / settings.transient_N2s / (1.0 + window_s_ / kRingingMemory_s));
    }

  private:
    Vector3 held_N_{Vector3::Zero()};
    double window_N2s_ = 0.0;
    double window_s_ = 0.0;
};

// Commands that are made to get as much through as can be, in turn, each for some 300 calls.
class Adversary {
  public:
    Vector3 ask(int call, const Pair& pair, const Counted& counted) {
        if (call % 300 == 0) {
            course_ = draw(0, 6);
            half_period_ = draw(1, 100);
            way_ = Vector3(chance(), chance(), chance()).normalized();
        }
        switch (course_) {
            case 0:  // by chance, held for so long
                asked_N_ = call % half_period_ == 0
                               ? Vector3(6.0 * Vector3(chance(), chance(), chance()))
                               : asked_N_;
                break;
            case 1:  // a buzz
                asked_N_ = (call / half_period_ % 2 == 0 ? 6.0 : -6.0) * way_;
                break;
            case 2:  // with the impulse that is there
                asked_N_ = counted.impulse_Ns.norm() > 0.0
                               ? Vector3(9.0 * counted.impulse_Ns.normalized())
                               : Vector3(9.0 * way_);
                break;
            case 3:  // always to the other side of what is felt
                asked_N_ = pair.force_N.norm() > 0.0 ? Vector3(-9.0 * pair.force_N.normalized())
                                                     : Vector3(9.0 * way_);
                break;
            case 4:  // round and round
                asked_N_ =
                    6.0 * (std::cos(call * std::numbers::pi / half_period_) * Vector3::UnitX() +
                           std::sin(call * std::numbers::pi / half_period_) * Vector3::UnitZ());
                break;
            case 5:  // blows that are as long as the memory of the others lasts
                asked_N_ = call % 50 < draw(1, 12) ? Vector3(9.0 * way_) : Vector3(Vector3::Zero());
                break;
            default:
                asked_N_.setZero();
        }
        return asked_N_;
    }
    int draw(int low, int high) { return std::uniform_int_distribution<int>(low, high)(random_); }

  private:
    double chance() { return std::uniform_real_distribution<double>(-1.0, 1.0)(random_); }

    std::mt19937_64 random_{3};
    int course_ = 0;
    int half_period_ = 1;
    Vector3 way_{Vector3::UnitX()};
    Vector3 asked_N_{Vector3::Zero()};
};

}  // namespace

TEST_CASE("safety transients: whatever is commanded, each bound holds at each call") {
    const char* const asked = std::getenv("FULCRUM_GATE_CALLS");
    const int n_calls = asked != nullptr ? std::atoi(asked) : 1'000'000;
    SafetySettings settings;
    Pair pair;
    Counted counted;
    Adversary adversary;
    double faded_N = 0.0;  // more than before it, while it fades
    for (int i = 0; i < n_calls; ++i) {
        const double dt_s = i % 1000 < 20 ? 0.3 * kDt_s : kDt_s;
        // Often enough that it matters, seldom enough that it is open mostly.
        const bool fails =
            i % 20'000 >= 15'000 && i % 20'000 < 15'000 + 300 && adversary.draw(0, 99) == 0;
        const double before_N = pair.force_N.norm();
        pair.pass(adversary.ask(i, pair, counted), dt_s, fails ? Fault::device_read : Fault::none);
        counted.count(pair, dt_s);
        if (pair.shipped.phase() == GatePhase::fading) {
            faded_N = std::max(faded_N, pair.force_N.norm() - before_N);
        }
    }
    constexpr double kAll = 1.0 + 1e-9;
    CHECK(counted.force <= 1.0);
    CHECK(counted.swing <= kAll);
    CHECK(counted.impulse <= kAll);
    CHECK(counted.ringing <= kAll);
    CHECK(counted.square <= kAll);
    CHECK(faded_N <= 0.0);
    // They were asked to.
    CHECK(counted.swing > 0.99);
    CHECK(counted.impulse > 0.8);
    CHECK(counted.ringing > 0.9);
    CHECK(counted.square > 0.8);
}

TEST_CASE("safety transients: a tap arrives as it is commanded") {
    // Of metal at 0.2 m/s, and of wood at 0.4 m/s.
    for (const auto& [amplitude_N, frequency_Hz, decay_per_s] :
         {std::array{2.0, 100.0, 90.0}, {2.0, 30.0, 80.0}, {1.8, 140.0, 70.0}}) {
        Pair pair;
        for (int i = 1; i < 100; ++i) {
            const double t_s = i * kDt_s;
            const double asked_N = amplitude_N * std::exp(-decay_per_s * t_s) *
                                   std::sin(2.0 * std::numbers::pi * frequency_Hz * t_s);
            pair.pass(Vector3(0.0, asked_N, 0.0));
            REQUIRE(pair.force_N.y() == Approx(asked_N).margin(1e-9));
        }
    }
}

TEST_CASE("safety transients: a step comes at once by four newtons, then as its impulse allows") {
    Pair pair;
    pair.pass(Vector3(5.0, 0.0, 0.0));
    CHECK(pair.force_N.x() == Approx(4.5));
    pair.pass(Vector3(5.0, 0.0, 0.0));
    CHECK(pair.force_N.x() == Approx(5.0));
    double least_N = 5.0;
    for (int i = 0; i < 8; ++i) {
        pair.pass(Vector3(5.0, 0.0, 0.0));
        least_N = std::min(least_N, pair.force_N.x());
    }
    CHECK(least_N > 3.5);
    // From here on nothing lies between the slew and what is commanded.
    CHECK(pair.beyond_N.norm() == 0.0);
    CHECK(pair.force_N.x() == Approx(5.0));
    // While a force comes in softly nothing does so faster.
    SafetyGate rising{SafetySettings{}};
    pass(rising, along_x(0.0), 5);
    REQUIRE(rising.phase() == GatePhase::rising);
    CHECK(pass(rising, along_x(5.0)).force.x() == Approx(0.005));
}

TEST_CASE("safety transients: a buzz for ever, of any frequency, is as weak as it is said") {
    const SafetySettings settings;
    double most_N = 0.0;
    for (const int half_period : {1, 2, 3, 5, 8, 12, 20, 40, 100}) {
        Pair pair;
        double squares_N2 = 0.0;
        constexpr int kRounds = 4000;
        for (int i = 0; i < 2 * kRounds; ++i) {
            pair.pass(Vector3(i / half_period % 2 == 0 ? 5.0 : -5.0, 0.0, 0.0));
            squares_N2 += i < kRounds ? 0.0 : pair.beyond_N.squaredNorm();
        }
        most_N = std::max(most_N, std::sqrt(squares_N2 / kRounds));
    }
    CHECK(most_N <= 0.45);
    CHECK(most_N > 0.4);
    CHECK(0.45 == Approx(std::sqrt(settings.transient_N2s / kRingingMemory_s)).margin(0.005));
}

TEST_CASE("safety transients: a slew that changes drops no force and empties no bound") {
    SafetyGate steady = open_gate(SafetySettings{}, 0.0);
    for (int i = 0; i < 20; ++i) {
        (void)pass(steady, along_x(3.0));
    }
    for (const double slew_N_per_s : {100.0, 500.0, 10.0, 0.0, -1.0, std::nan("")}) {
        steady.limit_slew(slew_N_per_s);
        CHECK(pass(steady, along_x(3.0)).force.x() == 3.0);
    }
    // None holds a force for ever.
    (void)pass(steady, along_x(0.0), 400);
    CHECK(pass(steady, along_x(0.0)).force.x() == 0.0);
    // A blow every fourth round, and a slew that would make nothing of what is counted.
    double squares_N2[2] = {0.0, 0.0};
    for (const bool changes : {false, true}) {
        SafetyGate gate = open_gate(SafetySettings{}, 0.0);
        for (int i = 0; i < 4000; ++i) {
            gate.limit_slew(changes && i % 4 == 2 ? 10.0 : 500.0);
            squares_N2[changes ? 1 : 0] +=
                pass(gate, along_x(i % 4 == 0 ? 4.4 : 0.0)).force.squaredNorm();
        }
    }
    CHECK(squares_N2[1] <= squares_N2[0]);
}

TEST_CASE("safety transients: one that is held for longer than it was meant for counts so long") {
    // Calls that come early and late in turn, each late one with a blow that is held.
    SafetyGate uneven = open_gate(SafetySettings{}, 0.0);
    double held_N2s = 0.0;
    for (int i = 0; i < 4000; ++i) {
        const bool hits = i % 2 == 0;
        const Vector3 force_N =
            uneven.pass(along_x(hits ? 4.0 : 0.0), Fault::none, hits ? 0.0001 : 0.0019).force;
        held_N2s += force_N.squaredNorm() * (hits ? 0.0019 : 0.0001);
    }
    // What lasts is a tenth of a newton at most, and a blow is counted 0.9 ms late.
    const SafetySettings settings;
    const double late_N2s = settings.max_transient_N * settings.max_transient_N * 0.0009;
    CHECK(std::sqrt(held_N2s / 4.0) <
          0.1 + std::sqrt((settings.transient_N2s + late_N2s) / kRingingMemory_s));
    // After a call that came 15 ms late nothing more is pushed the same way before that is forgotten.
    Pair late;
    late.pass(Vector3(4.0, 0.0, 0.0));
    late.pass(Vector3::Zero(), 0.015);
    for (int i = 0; i < 40; ++i) {
        late.pass(Vector3(5.0, 0.0, 0.0));
        CHECK(late.beyond_N.norm() < 1e-9);
        late.pass(Vector3(0.0, 0.0, 0.0));
    }
}

TEST_CASE("safety transients: at a fault one ends at once, and no stop or fault gives another") {
    Pair pair;
    pair.pass(Vector3(2.0, 0.0, 0.0));
    REQUIRE(pair.force_N.x() == Approx(2.0));
    // What lasts is half a newton.
    pair.pass(Vector3(2.0, 0.0, 0.0), kDt_s, Fault::device_read);
    CHECK(pair.force_N.x() == Approx(0.5 * 0.99));
    // One against what lasts leaves nothing to fade.
    Pair other;
    for (int i = 0; i < 100; ++i) {
        other.pass(Vector3(2.0, 0.0, 0.0));
    }
    other.pass(Vector3(-1.0, 0.0, 0.0));
    REQUIRE(other.force_N.x() == Approx(-1.0));
    other.pass(Vector3(-1.0, 0.0, 0.0), kDt_s, Fault::emergency_stop);
    CHECK(other.force_N.norm() == 0.0);
    // A gate that was spent, stopped and let go again is spent still: softly as it opens, nothing of it came back but by time.
    SafetySettings quick;
    quick.soft_start_s = 0.0;
    quick.engage_cycles = 1;
    quick.fade_s = 0.01;
    SafetyGate gate = open_gate(quick, 0.0);
    double squares_N2s = 0.0;
    for (int i = 0; i < 3000; ++i) {
        // Spent in 15 calls, then a fault, and the four calls that it takes to open again.
        const int at = i % 30;
        const Fault fault = at == 15 ? Fault::device_read : Fault::none;
        const double asked_N = at < 15 ? (at % 2 == 0 ? 5.0 : -5.0) : 0.0;
        squares_N2s += gate.pass(along_x(asked_N), fault, kDt_s).force.squaredNorm() * kDt_s;
    }
    const double lasting_N = 0.5;
    CHECK(std::sqrt(squares_N2s / 3.0) < 0.45 + lasting_N);
    CHECK(std::sqrt(squares_N2s / 3.0) > 0.4);
}

TEST_CASE("safety transients: with a gentler slew they are as much smaller") {
    SafetySettings gentle;
    gentle.max_slew_N_per_s = 50.0;
    SafetyGate gate = open_gate(gentle, 0.0);
    CHECK(pass(gate, along_x(5.0)).force.x() == Approx(0.05 + 0.4));
    // No time, no change.
    const double before_N = pass(gate, along_x(5.0)).force.x();
    CHECK(gate.pass(along_x(0.0), Fault::none, 0.0).force.x() == before_N);
}
