// economy_probe SCENE ROUNDS: steps one loop with fixed inputs, so that its instructions can be counted (economy.sh).
// A scene of the haptic loop calls for one effect and leads the hand through it; one of the world, "rest-N", "fall-N" or
// "caught-N", has N bodies that lie, fall past the tool, or fall into it. "flown" is a kite's own loop, "pushed" a hand and the
// rigid bodies that it pushes.
#include "haptics/dynamics/world_loop.h"
#include "haptics/flight/kite_loop.h"
#include "haptics/geometry/shape.h"
#include "haptics/loop/haptic_loop.h"
#include "tests/support/hands_in_world.h"
#include "tests/support/scripted_device.h"
#include "tests/support/touchable.h"

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <map>
#include <memory>
#include <stdexcept>
#include <string>

using namespace fulcrum;

namespace {

constexpr double kDt_s = 0.001;
constexpr double kBall_m = 0.05;

HapticPlan make_field(FieldKind kind) {
    HapticPlan plan;
    FieldPlan field;
    field.kind = kind;
    field.stiffness_N_per_m = 100.0;
    field.damping_Ns_per_m = 2.0;
    field.peak_force_N = 2.0;
    plan.fields = {field};
    return plan;
}

HapticPlan make_ball() {
    HapticPlan plan;
    plan.solids = only_solid(touchable(make_sphere(kBall_m, 8)));
    return plan;
}

const std::map<std::string, HapticPlan (*)()> kHapticScenes{
    {"bare", [] { return HapticPlan{}; }},
    {"weight",
     [] {
         HapticPlan plan;
         plan.carries_weight = true;
         return plan;
     }},
    {"spring", [] { return make_field(FieldKind::spring); }},
    {"viscosity", [] { return make_field(FieldKind::viscosity); }},
    {"magnet", [] { return make_field(FieldKind::magnet); }},
#ifdef ECONOMY_ADDED_KIND
    {"added", [] { return make_field(FieldKind::ECONOMY_ADDED_KIND); }},
#endif
    {"lesson",
     [] {
         HapticPlan plan;
         plan.lesson_force = true;
         return plan;
     }},
    {"solid", make_ball},
    {"textured",
     [] {
         HapticPlan plan = make_ball();
         plan.solids[0].surface.texture.source = SineTexture{};
         return plan;
     }},
    {"tapped",
     [] {
         HapticPlan plan = make_ball();
         plan.solids[0].surface.transient.kind = TransientKind::decaying_sinusoid;
         plan.solids[0].surface.transient.force_Ns_per_m = 5.0;
         return plan;
     }},
    {"shaded",
     [] {
         HapticPlan plan = make_ball();
         plan.solids[0].surface.shading.on = true;
         return plan;
     }},
    {"line",
     [] {
         HapticPlan plan;
         plan.line = LineFeelSettings{};
         return plan;
     }},
    {"kalman",
     [] {
         HapticPlan plan;
         plan.velocity_method = VelocityMethod::kalman;
         return plan;
     }},
};

template <class Plan>
void check(const Plan& plan) {
    if (const auto valid = validate(plan); !valid) {
        throw std::runtime_error(to_sentence(valid.error()));
    }
}

// What lesson and world say, 60 and 500 times a second.
void speak(HapticChannels& channels, int k) {
    if (k % 16 == 0) {
        ForceCommand command;
        command.stamp_s = k * kDt_s;
        command.lesson_alive = true;
        command.linearised.stamp_s = k * kDt_s;
        command.linearised.force_W.x() = 0.1 + 0.001 * k;
        channels.command.publish(command);
    }
    if (k % 2 == 0) {
        WorldFrame world;
        world.stamp_s = k * kDt_s;
        world.carried_force_W.y() = -0.1;
        channels.world.publish(world);
    }
}

void run_haptics(const HapticPlan& plan, int n_rounds) {
    check(plan);
    const auto channels = std::make_unique<HapticChannels>();
    const auto device = std::make_unique<ScriptedDevice>();
    const auto kite = std::make_unique<KiteChannels>();
    channels->kite = plan.line ? kite.get() : nullptr;
    const auto loop = std::make_unique<HapticLoop>(plan, *device, *channels);
    for (int k = 1; k <= n_rounds; ++k) {
        speak(*channels, k - 1);
        if (plan.line && k % 2 == 0) {
            kite->line.publish({k * kDt_s, Vector3::Zero(), {2.0, 1.0, 0.0}, 25.0, 20.0});
        }
        // In and out of the ball, and aside.
        device->pose_D.position = {kBall_m + 0.01 * std::cos(0.1 * k), 0.01 * std::sin(0.07 * k),
                                   0.0};
        loop->step(k * kDt_s);
    }
}

void run_world(const std::string& what, int n_bodies, int n_rounds) {
    WorldPlan plan;
    plan.bodies.resize(static_cast<std::size_t>(n_bodies));
    plan.ground_height_m = -1000.0;
    plan.catcher.present = what == "caught";
    plan.catcher.capacity = kMaxBodies;
    check(plan);
    const auto haptics = std::make_unique<HapticChannels>();
    const auto channels = std::make_unique<WorldChannels>();
    const auto loop =
        std::make_unique<WorldLoop>(plan, std::vector<std::int32_t>{0}, *channels, *haptics);
    haptics->state_for_world.publish(HapticState{});
    for (std::int32_t i = 0; i < n_bodies; ++i) {
        channels->commands.push(
            {what == "rest" ? WorldCommand::Kind::place : WorldCommand::Kind::drop, i,
             Vector3(0.0, 0.01, 0.0)});
    }
    for (int k = 1; k <= n_rounds; ++k) {
        loop->step(2.0 * kDt_s * k);
    }
}

// A kite, its world's rounds alone.
void run_kite(int n_rounds) {
    const auto channels = std::make_unique<KiteChannels>();
    const auto loop = std::make_unique<KiteLoop>(KiteFlightSettings{}, 500.0, *channels);
    for (int k = 1; k <= n_rounds; ++k) {
        channels->hand_W.publish({0.0, 1.0, 0.0});
        loop->step(2.0 * kDt_s * k);
    }
}

// A hand that comes from beside and pushes a box against another.
void run_rigid(int n_rounds) {
    test::BoxScene scene;
    scene.boxes.push_back({.at_W = {0.065, 0.03, 0.0}});
    const auto hands =
        std::make_unique<test::HandsInWorld>(scene, std::vector<Vector3>{{-0.045, 0.03, 0.0}});
    for (int k = 1; k <= n_rounds; ++k) {
        hands->aim(0, {-0.045 + 1.0e-4 * k, 0.03, 0.0});
        hands->step();
    }
}

void run(const std::string& scene, int n_rounds) {
    if (scene == "flown") {
        return run_kite(n_rounds);
    }
    if (scene == "pushed") {
        return run_rigid(n_rounds);
    }
    const std::size_t dash = scene.find('-');
    if (dash != std::string::npos) {
        run_world(scene.substr(0, dash), std::stoi(scene.substr(dash + 1)), n_rounds);
    } else {
        run_haptics(kHapticScenes.at(scene)(), n_rounds);
    }
}

}  // namespace

int main(int argc, char** argv) {
    if (argc != 3) {
        std::fprintf(stderr, "economy_probe SCENE ROUNDS\n");
        return 2;
    }
    try {
        run(argv[1], std::atoi(argv[2]));
    } catch (const std::exception& error) {
        std::fprintf(stderr, "%s: %s\n", argv[1], error.what());
        return 1;
    }
    return 0;
}
