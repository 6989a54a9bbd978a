#include "runtime/app/run_effects.h"

#include "runtime/app/lesson_bodies.h"
#include "runtime/scene/plan_kite.h"

#include <utility>

namespace fulcrum::runtime {

Expected<void> RunEffects::join(Plan& plan, RunHands& hands) {
    HapticChannels& first = hands.front()->channels;
    if (plan.touch_sound) {
        build_touch_sound(plan, first);
    }
    if (!plan.haptic.axles.empty()) {
        axles_ = std::make_unique<AxleChannels>();
        first.axles = axles_.get();
    }
    if (plan.kite) {
        kite_ = std::make_unique<KiteChannels>();
        first.kite = kite_.get();
        kite_loop_ = std::make_unique<KiteLoop>(plan.kite->flight,
                                                plan.kite->rate_hz * plan.kite->n_parts, *kite_);
    }
    return plan.rigid ? build_rigid_loop(plan, hands) : Expected<void>{};
}

// The loop tells what it touches, and each solid that can be heard has its tone.
void RunEffects::build_touch_sound(Plan& plan, HapticChannels& hand) {
    std::vector<TapTone> tones;
    for (const SolidPlan& solid : plan.haptic.solids) {
        tones.push_back(solid.surface.audible ? tone_of(solid.surface.transient) : TapTone{});
    }
    touches_ = std::make_unique<TouchRing>();
    hand.touches = touches_.get();
    touch_sound_ =
        std::make_unique<TouchSound>(*touches_, std::move(tones), 1.0 / plan.haptic.rate_hz);
    for (PlanStage& stage : plan.stages) {
        if (stage.loop == "sound" && stage.name == "touch") {
            stage.memory_bytes = sizeof(TouchRing) + sizeof(TouchSound);
        }
    }
}

Expected<void> RunEffects::build_rigid_loop(const Plan& plan, RunHands& hands) {
    world_ = std::make_unique<WorldChannels>();
    std::vector<RigidChannels*> rigid;
    for (const auto& hand : hands) {
        hand->rigid = std::make_unique<RigidChannels>();
        hand->channels.rigid = hand->rigid.get();
        rigid.push_back(hand->rigid.get());
    }
    auto loop = RigidLoop::create(*plan.rigid, world_.get(), rigid);
    if (!loop) {
        return tl::unexpected(loop.error());
    }
    rigid_loop_ = std::move(*loop);
    return {};
}

void RunEffects::build_world(const Plan& plan, HapticChannels& hand,
                             const LessonDescription& lesson) {
    if (!plan.world) {
        return;
    }
    std::vector<std::int32_t> solid_bodies;
    for (const SolidPlan& solid : plan.haptic.solids) {
        solid_bodies.push_back(solid.body);
    }
    world_ = std::make_unique<WorldChannels>();
    world_loop_ = std::make_unique<WorldLoop>(*plan.world, std::move(solid_bodies), *world_, hand);
    for (const WorldCommand& place : place_at_first(lesson)) {
        (void)world_->commands.push(place);  // as many as bodies: they fit
    }
}

void RunEffects::gather(const LessonDescription& lesson, SessionInput& gathered) {
    if (world_) {
        world_->snapshot.take();
        take_rigid_bodies(lesson);
        for (WorldEvent event; world_->events.pop(event);) {
            gathered.world_events.push_back(event);
        }
    }
    if (axles_) {
        axles_->frame.take();
    }
    if (kite_) {
        kite_->frame.take();
    }
    gathered.world = newest_world();
    gathered.axles = newest_axles();
    gathered.kite = newest_kite();
}

// Bodies that are not rigid stand where they were declared.
void RunEffects::take_rigid_bodies(const LessonDescription& lesson) {
    if (!rigid_loop_ || world_->snapshot.value().n_bodies == 0) {
        return;
    }
    seen_ = world_->snapshot.value();
    seen_.n_bodies = static_cast<std::int32_t>(lesson.bodies.size());
    for (std::size_t i = 0; i < lesson.bodies.size(); ++i) {
        const BodyDescription& body = lesson.bodies[i];
        if (!body.rigid) {
            seen_.bodies[i] = {Pose::at(body.position_W), Vector3::Zero(),
                               body.visible || body.solid ? BodyWhere::placed : BodyWhere::hidden};
        }
    }
}

Expected<void> RunEffects::order(const Plan& plan, const SessionOutput& output) {
    if (axles_) {
        axles_->orders.publish(output.axles);
    }
    if (kite_) {
        // Another kite is made here, on the lesson's thread, and flown there.
        if (output.kite_design) {
            kite_->built.put(
                std::make_unique<KiteFlight>(with_design(plan.kite->flight, *output.kite_design)));
        }
        kite_->orders.publish(output.kite);
    }
    return world_ ? to_world_.send(output.world, world_->commands) : Expected<void>{};
}

void RunEffects::show(Scenery& scenery) const {
    scenery.world = newest_world();
    scenery.axles = newest_axles();
    scenery.kite = newest_kite();
}

PeriodicTask* RunEffects::world_loop() {
    return world_loop_ ? static_cast<PeriodicTask*>(world_loop_.get()) : rigid_loop_.get();
}

const WorldSnapshot* RunEffects::newest_world() const {
    if (rigid_loop_) {
        return seen_.n_bodies > 0 ? &seen_ : nullptr;
    }
    return world_ && world_->snapshot.value().n_bodies > 0 ? &world_->snapshot.value() : nullptr;
}

const AxleFrame* RunEffects::newest_axles() const {
    return axles_ && axles_->frame.value().n_axles > 0 ? &axles_->frame.value() : nullptr;
}

const KiteFrame* RunEffects::newest_kite() const {
    return kite_ && kite_->frame.value().n_nodes > 0 ? &kite_->frame.value() : nullptr;
}

WorldEffort RunEffects::world_effort() const {
    const WorldSnapshot* const world = newest_world();
    return world != nullptr ? world->effort : WorldEffort{};
}

std::uint64_t RunEffects::n_events_dropped() const {
    return world_loop_ ? world_->events.dropped() : 0;
}

std::uint64_t RunEffects::n_commands_ignored() const {
    return world_loop_ ? world_loop_->world().ignored_commands() : 0;
}

}  // namespace fulcrum::runtime
