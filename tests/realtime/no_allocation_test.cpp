// Traps every allocation of this program and counts those made while a step runs.
#include "haptics/collision/collision_mesh.h"
#include "haptics/device/mouse/pointer_device.h"
#include "haptics/device/replay/replay_device.h"
#include "haptics/device/simulated/simulated_hand.h"
#include "haptics/dynamics/integrator.h"
#include "haptics/dynamics/loads.h"
#include "haptics/dynamics/world_loop.h"
#include "haptics/geometry/shape.h"
#include "haptics/loop/haptic_loop.h"
#include "tests/realtime/allocation_trap.h"

#include <catch2/catch.hpp>

#include <array>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <memory>
#include <new>

namespace {

thread_local bool armed = false;
thread_local std::uint64_t n_trapped = 0;

void note() noexcept {
    n_trapped += armed ? 1 : 0;
}

}  // namespace

namespace fulcrum {

void arm_allocation_trap() noexcept {
    n_trapped = 0;
    armed = true;
}
std::uint64_t disarm_allocation_trap() noexcept {
    armed = false;
    return n_trapped;
}

}  // namespace fulcrum

// The sanitizers bring allocators of their own, which must not be replaced; there the trap stays open and says so.
#ifndef FULCRUM_SANITIZED
extern "C" {
void* __libc_malloc(std::size_t size);
void* __libc_calloc(std::size_t n, std::size_t size);
void* __libc_realloc(void* block, std::size_t size);
void __libc_free(void* block);

void* malloc(std::size_t size) {
    note();
    return __libc_malloc(size);
}
void* calloc(std::size_t n, std::size_t size) {
    note();
    return __libc_calloc(n, size);
}
void* realloc(void* block, std::size_t size) {
    note();
    return __libc_realloc(block, size);
}
void free(void* block) {
    note();
    __libc_free(block);
}
}
#endif

namespace {

using namespace fulcrum;

constexpr double kDt_s = 0.001;
constexpr int kSteps = 10'000;

// A plan with every stage there is.
HapticPlan make_full_plan() {
    HapticPlan plan;
    plan.carries_weight = true;
    plan.expects_world = true;
    plan.lesson_force = true;
    plan.fields = {FieldPlan{FieldKind::spring, Vector3::Zero(), 50.0, 1.0},
                   FieldPlan{FieldKind::viscosity, Vector3::Zero(), 0.0, 1.0},
                   FieldPlan{FieldKind::magnet, Vector3::Zero(), 0.0, 0.0, 1.0, 0.05}};
    plan.solids.push_back({1, CollisionMesh::create(make_sphere(0.1, 20).value()).value(), {}});
    plan.solids[0].surface.shading.on = true;
    plan.solids[0].surface.audible = true;
    plan.solids[0].surface.texture.source = NoiseTexture{};
    plan.solids[0].surface.transient.kind = TransientKind::decaying_sinusoid;
    plan.solids[0].surface.transient.force_Ns_per_m = 5.0;
    return plan;
}

ForceCommand make_command(int k) {
    ForceCommand command;
    command.stamp_s = k * kDt_s;
    command.lesson_alive = k % 3000 < 2900;  // now and then the lesson dies
    command.fields[0].on = k % 400 < 200;
    command.fields[2].anchor_W = Vector3(0.0, 0.05, 0.0);
    command.linearised.stamp_s = k * kDt_s;
    command.linearised.force_W = Vector3(0.1, 0.0, 0.0);
    // Once the gate has engaged, a torque; its slope is now and then too steep.
    if (k % 3000 > 1000) {
        command.linearised.torque_W = Vector3(0.0, 0.02, 0.0);
        command.linearised.torque_stiffness_Nm_per_m =
            Matrix3::Identity() * (k % 48 == 0 ? 900 : 1);
    }
    command.linearised.damping_Ns_per_m = Matrix3::Identity() * (k % 32 == 0 ? 1.0 : -1.0);
    return command;
}

}  // namespace

TEST_CASE("no allocation: the trap itself works") {
#ifdef FULCRUM_SANITIZED
    WARN("the sanitizer's allocator is not trapped: the tests of this file check nothing here");
#else
    CHECK(count_allocations([] { delete new volatile int(3); }) == 2);
    CHECK(count_allocations([] { std::free(std::malloc(10)); }) == 2);
    CHECK(count_allocations([] { std::make_unique<std::string>(100, 'a'); }) == 4);
    CHECK(count_allocations([] {}) == 0);
#endif
}

TEST_CASE(
    "no allocation: ten thousand rounds of haptic and world loop with every stage, faults "
    "included") {
    auto haptics = std::make_unique<HapticChannels>();
    auto channels = std::make_unique<WorldChannels>();
    auto ring = std::make_unique<RecordRing>();
    haptics->record = ring.get();
    auto touches = std::make_unique<TouchRing>();
    haptics->touches = touches.get();
    LatestValue<HandTarget> target;
    SimulatedHand hand(SimulatedHandSettings{}, target);
    HapticLoop loop(make_full_plan(), hand, *haptics);
    WorldPlan world_plan;
    world_plan.bodies.resize(3);
    world_plan.catcher.present = true;
    WorldLoop world(world_plan, {1}, *channels, *haptics);
    channels->commands.push({WorldCommand::Kind::place, 1});
    bool touched = false;
    bool pushed = false;
    const std::uint64_t n = count_allocations([&] {
        for (int k = 1; k <= kSteps; ++k) {
            // The hand circles into the sphere and out of it.
            HandTarget wanted;
            wanted.pose_D.position =
                Vector3(0.2 * std::cos(0.002 * k), 0.05 * std::sin(0.003 * k), 0.0);
            target.publish(wanted);
            if (k % 16 == 0) {
                haptics->command.publish(make_command(k));
            }
            if (k % 500 == 0) {
                channels->commands.push({WorldCommand::Kind::drop, 0, Vector3(0.2, 0.3, 0.0)});
            }
            if (k == 9000) {
                haptics->emergency_stop.press();
            }
            world.step(k * kDt_s);
            loop.step(k * kDt_s);
            RecordRound round;
            touched = touched || loop.state().touched_body == 1;
            pushed = pushed || loop.state().applied_W.force.norm() > 0.1;
            while (k % 100 == 0 && ring->pop(round)) {
            }
        }
        loop.silence(kSteps * kDt_s);
    });
    CHECK(n == 0);
    CHECK(touched);
    CHECK(pushed);
    TouchSample heard;
    CHECK(touches->pop(heard));
}

TEST_CASE("no allocation: mouse and replay") {
    Record record;
    record.samples.resize(500);
    for (std::size_t i = 0; i < record.samples.size(); ++i) {
        record.samples[i].time_s = record.samples[i].stamp_s = 0.001 * static_cast<double>(i);
    }
    ReplayDevice replay(record);
    LatestValue<PointerTarget> target;
    PointerDevice mouse(PointerSettings{}, target);
    CHECK(count_allocations([&] {
              DeviceReading reading;
              for (int k = 0; k < 1000; ++k) {
                  target.publish({Vector3(0.001 * (k % 100), 0.0, 0.0), 0});
                  (void)mouse.read(k * kDt_s, reading);
                  (void)mouse.write(k * kDt_s, {});
                  (void)replay.read(k * kDt_s, reading);
                  (void)replay.write(k * kDt_s, {});
              }
          }) == 0);
    CHECK(replay.finished());
}

TEST_CASE("no allocation: a tool on its coupling and in contact, with every integrator") {
    const std::array<PlaneContact, 1> floor{{{.point_B = {0.02, -0.01, 0.0}}}};
    const PlaneContactsLoad contact(floor);
    ToolCouplingLoad coupling{ToolCouplingSettings{}};
    const Loads all(coupling, contact);
    for (const Integrator integrator : kIntegrators) {
        IntegratorSettings settings;
        settings.integrator = integrator;
        RigidState state;
        int n_moved = 0;
        CHECK(
            count_allocations([&] {
                for (int k = 0; k < 1000; ++k) {
                    coupling.set_handle({Pose::at({0.0, 0.01 * std::cos(0.01 * k), 0.0}), {}},
                                        k * kDt_s);
                    n_moved +=
                        step_rigid_body(settings, Inertia{}, all, k * kDt_s, 0.0002, state).moved();
                }
            }) == 0);
        CHECK(n_moved == 1000);
    }
}
