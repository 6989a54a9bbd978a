// A haptic loop and the contact thread of its tool, as in a live run: what is handed over is whole and felt, a thread that stalls or dies lets
// the force fade, and nothing jumps. What is asked of time is asked by a clock of the test's own.
#include "haptics/base/clock.h"
#include "haptics/device/simulated/simulated_hand.h"
#include "haptics/loop/beside_thread.h"
#include "haptics/loop/haptic_loop.h"
#include "tests/support/tool_scene.h"

#include <catch2/catch.hpp>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cmath>
#include <memory>
#include <thread>

using namespace fulcrum;

namespace {

constexpr double kPressed_m = 0.016;  // deeper than the floor's top, where the ball touches it
constexpr double kMoved_m = 0.0005;   // at once, while it is pressed
constexpr double kMost_N = 5.0;
constexpr double kFades_N = 0.2;  // in a step: four times what the fade takes of the most

std::shared_ptr<const ToolPlan> make_beside(ToolMethod method) {
    ToolPlan plan =
        *test::make_tool_of(test::make_ball_tool(method), {make_box({0.2, 0.04, 0.2}).value()});
    plan.beside = true;
    return std::make_shared<const ToolPlan>(std::move(plan));
}

// What a late answer may make of the force in a millisecond.
double find_most_step_N(ToolMethod method) {
    if (method == ToolMethod::god_object) {
        // As much of all that may be felt as a new set of contacts changes (god_force.h), and as far as the hand is moved at once.
        const GodObjectSettings settings = make_god_object_settings(*make_beside(method));
        return kMost_N * (1.0 - std::exp(-0.001 / settings.fade_s)) +
               settings.coupling.shift.stiffness_N_per_m * kMoved_m;
    }
    // As far as one plane may rise (contact_planes.h).
    const ContactPlanesSettings planes =
        make_implicit_penalty_plan(*make_beside(method)).settings.contacts;
    return planes.stiffness_N_per_m * planes.rise_m_per_s * 0.001;
}

// A ball of 2 cm over a floor whose top is at height 0.
HapticPlan make_floor(ToolMethod method) {
    HapticPlan plan;
    plan.expects_lesson = false;
    plan.safety.soft_start_s = 0.0;
    plan.safety.device_timeout_s = 1.0;  // a slow machine is no lost device
    plan.solids.push_back({.body = 3,
                           .shape = BoxShape{Vector3(0.1, 0.02, 0.1)},
                           .initial_pose_W = Pose::at(Vector3(0, -0.02, 0))});
    plan.tool = make_beside(method);
    return plan;
}

// Sees each round of the haptic loop, on its thread.
class Watched final : public PeriodicTask {
  public:
    Watched(HapticLoop& loop) : loop_(loop) {}
    void step(double now_s) override {
        const Vector3 before = loop_.state().commanded_W.force;
        loop_.step(now_s);
        most_step_N = std::max(most_step_N, (loop_.state().commanded_W.force - before).norm());
    }
    void silence(double now_s) noexcept override { loop_.silence(now_s); }
    double most_step_N = 0.0;

  private:
    HapticLoop& loop_;
};

// A loop, the hand that its test moves, and whoever lets time pass.
struct Rig {
    explicit Rig(ToolMethod method) : loop(make_floor(method), hand, *channels), watched(loop) {
        REQUIRE(loop.beside() != nullptr);
        move_to(0.05);
    }
    virtual ~Rig() = default;
    virtual void pass(int rounds) = 0;
    void move_to(double height_m) {
        HandTarget wanted;
        wanted.pose_D = Pose::at(Vector3(0.0, height_m, 0.0));
        target.publish(wanted);
        height = height_m;
    }
    const HapticState& look() {
        (void)channels->state_for_lesson.take();
        return channels->state_for_lesson.value();
    }
    template <class Condition>
    bool await(Condition condition) {
        for (int i = 0; i < 20'000; ++i) {
            if (condition(look())) {
                return true;
            }
            pass(1);
        }
        return false;
    }
    // Slowly down until it is pressed.
    void press() {
        REQUIRE(await([](const HapticState& state) { return state.gate == GatePhase::open; }));
        while (height > 0.02 - kPressed_m) {
            move_to(height - kMoved_m);
            pass(5);
        }
        REQUIRE(await([](const HapticState& state) { return state.applied_W.force.y() > 2.0; }));
    }

    double height = 0.0;
    LatestValue<HandTarget> target;
    SimulatedHand hand{SimulatedHandSettings{}, target};
    std::unique_ptr<HapticChannels> channels = std::make_unique<HapticChannels>();
    HapticLoop loop;
    Watched watched;
};

// On threads, by the clock of the wall.
struct Live final : Rig {
    explicit Live(ToolMethod method) : Rig(method) {
        RealtimeSettings settings;
        settings.epoch_s = monotonic_now_s();
        REQUIRE(contact.start(*loop.beside(), 2000.0, settings.epoch_s));
        REQUIRE(haptic.start(watched, settings));
    }
    ~Live() override {
        haptic.stop();
        contact.stop();
    }
    void pass(int rounds) override {
        std::this_thread::sleep_for(std::chrono::milliseconds(rounds));
    }

    BesideThread contact;
    RealtimeThread haptic;
};

// By a clock of its own: the other thread looks every so many rounds, or 0: not at all. So a busy machine is no late answer.
struct Stepped final : Rig {
    explicit Stepped(ToolMethod method, int looks = 1) : Rig(method), looks_every(looks) {}
    void pass(int rounds) override {
        for (; rounds > 0; --rounds) {
            watched.step(0.001 * static_cast<double>(++n));
            if (looks_every > 0 && n % looks_every == 0) {
                (void)loop.beside()->run_once();
            }
        }
    }

    int looks_every;
    int n = 0;
};

constexpr ToolMethod kMethods[] = {ToolMethod::implicit_penalty, ToolMethod::god_object};

}  // namespace

TEST_CASE(
    "contact beside: a floor is felt by what another thread found, and it keeps the tool out") {
    for (const ToolMethod method : kMethods) {
        Live live(method);
        live.press();
        const HapticState& state = live.look();
        CHECK(state.touched_body == 3);
        CHECK(state.applied_W.force.y() < 1.001 * kMost_N);
        CHECK(state.proxy_position_W.y() > 0.0185);
        CHECK(state.faults == Fault::none);
        live.haptic.stop();
        live.contact.stop();
        CHECK(live.contact.status().rounds > 10);
        CHECK(live.loop.contact_lateness()->age().count() > 10);
        CHECK(live.contact.status().rounds <= live.haptic.status().rounds);
    }
}

TEST_CASE("contact beside: at a hundred looks a second nothing shakes") {
    for (const ToolMethod method : kMethods) {
        Stepped rig(method, 10);
        rig.press();
        CHECK(rig.watched.most_step_N < find_most_step_N(method));
        rig.pass(300);
        rig.watched.most_step_N = 0.0;
        rig.pass(300);
        CHECK(rig.look().applied_W.force.y() > 2.0);
        CHECK(rig.watched.most_step_N < kFades_N);
    }
}

TEST_CASE(
    "contact beside: a thread that stalls for 0.4 s lets the force fade without a jump; the hand "
    "comes free and feels it "
    "again") {
    for (const ToolMethod method : kMethods) {
        Stepped rig(method);
        rig.press();
        rig.pass(300);
        rig.watched.most_step_N = 0.0;
        rig.looks_every = 0;
        // Held 0.1 s, and faded 0.1 s later.
        rig.pass(90);
        CHECK(rig.look().applied_W.force.y() > 2.0);
        rig.pass(115);
        CHECK(rig.loop.contact_lateness()->n_late() > 0);
        CHECK(rig.look().applied_W.force == Vector3::Zero());
        rig.pass(195);
        rig.looks_every = 1;
        CHECK(rig.watched.most_step_N < kFades_N);
        // It was let go inside the floor's reach, so nothing is felt until it has been outside.
        rig.pass(500);
        CHECK(rig.look().applied_W.force == Vector3::Zero());
        CHECK(rig.loop.contact_lateness()->age().max_s() > 0.1);
        rig.move_to(0.05);
        REQUIRE(rig.await(
            [](const HapticState& state) { return state.tool_pose_W.position.y() > 0.045; }));
        rig.press();
        CHECK(rig.watched.most_step_N < find_most_step_N(method));
    }
}

TEST_CASE(
    "contact beside: without its thread a hand feels nothing for longer than 0.2 s, and is never "
    "caught inside") {
    for (const ToolMethod method : kMethods) {
        Stepped rig(method);
        rig.press();
        rig.pass(300);
        rig.watched.most_step_N = 0.0;
        rig.looks_every = 0;
        rig.pass(205);
        CHECK(rig.look().applied_W.force == Vector3::Zero());
        rig.pass(500);
        CHECK(rig.look().applied_W.force == Vector3::Zero());
        // Up, down into the floor and up again: no answers, no force.
        for (const double height_m : {0.05, 0.005, 0.05}) {
            rig.move_to(height_m);
            REQUIRE(rig.await([&](const HapticState& state) {
                return std::abs(state.tool_pose_W.position.y() - height_m) < 0.003;
            }));
            CHECK(rig.look().applied_W.force == Vector3::Zero());
        }
        CHECK(rig.watched.most_step_N < kFades_N);
        CHECK(rig.look().faults == Fault::none);
    }
}

// Two threads by turns, each waiting for the other: the same forces to the bit as rounds in line that are a step late.
TEST_CASE("contact beside: a thread that keeps pace gives the forces of rounds in line") {
    ToolPlan plan = *make_beside(ToolMethod::implicit_penalty);
    auto beside = ImplicitPenaltyTool::build(make_implicit_penalty_plan(plan)).value();
    plan.beside = false;
    plan.penalty->round_s = 0.001;
    auto in_line = ImplicitPenaltyTool::build(make_implicit_penalty_plan(plan)).value();
    std::atomic<int> wanted{0};
    std::atomic<int> done{0};
    std::thread thread([&] {
        for (int n = 1; n <= 800; ++n) {
            while (wanted.load() < n) {
                std::this_thread::yield();
            }
            (void)beside.beside()->run_once();
            done.store(n);
        }
    });
    const MovingFrame floor{Pose::at(Vector3(0, -0.02, 0)), {}};
    in_line.place(Pose::at({0.0, 0.05, 0.0}));
    beside.place(Pose::at({0.0, 0.05, 0.0}));
    int n_different = 0;
    double most_N = 0.0;
    for (int n = 1; n <= 800; ++n) {
        const double t_s = 0.001 * n;
        const MovingFrame hand{Pose::at({0.05 * t_s, std::max(0.012, 0.05 - 0.1 * t_s), 0.0}), {}};
        const ToolFelt a = in_line.move(hand, {&floor, 1}, t_s, 0.001);
        const ToolFelt b = beside.move(hand, {&floor, 1}, t_s, 0.001);
        n_different += a.felt_W.force != b.felt_W.force || a.felt_W.torque != b.felt_W.torque;
        most_N = std::max(most_N, b.felt_W.force.norm());
        wanted.store(n);
        while (done.load() < n) {
            std::this_thread::yield();
        }
    }
    thread.join();
    CHECK(n_different == 0);
    CHECK(most_N > 2.0);
}
