// What a lesson's run has to do with bodies; for lesson_run.cpp.
#include "runtime/app/lesson_run.h"

#include <utility>

namespace fulcrum::runtime {

Expected<void> LessonRun::build_rigid_loop() {
    rigid_ = std::make_unique<RigidChannels>();
    channels_.rigid = rigid_.get();
    world_channels_ = std::make_unique<WorldChannels>();
    std::vector<RigidChannels*> hands{rigid_.get()};
    for (const auto& hand : more_hands_) {
        hands.push_back(&hand->rigid);
    }
    auto loop = RigidLoop::create(*plan_.rigid, world_channels_.get(), hands);
    if (!loop) {
        return tl::unexpected(loop.error());
    }
    rigid_loop_ = std::move(*loop);
    return {};
}

// Bodies that are not rigid stand where they were declared.
void LessonRun::take_rigid_bodies() {
    if (!rigid_loop_ || world_channels_->snapshot.value().n_bodies == 0) {
        return;
    }
    seen_ = world_channels_->snapshot.value();
    const auto& bodies = session_->description().bodies;
    seen_.n_bodies = static_cast<std::int32_t>(bodies.size());
    for (std::size_t i = 0; i < bodies.size(); ++i) {
        if (!bodies[i].rigid) {
            seen_.bodies[i] = {
                Pose::at(bodies[i].position_W), Vector3::Zero(),
                bodies[i].visible || bodies[i].solid ? BodyWhere::placed : BodyWhere::hidden};
        }
    }
}

// A simulated person who may go where nobody planned sees where things are.
void LessonRun::look_around() {
    constexpr double kStays =
        0.7;  // who looks at something looks on until another is nearer by so much
    const auto& bodies = session_->description().bodies;
    const WorldSnapshot* const world = newest_world();
    const Vector3 hand_W = channels_.state_for_lesson.value().tool_pose_W.position;
    std::optional<Vector3> nearest_W;
    double nearest_m = 0.0;
    std::size_t seen = kMaxBodies;
    for (std::size_t i = 0; i < bodies.size(); ++i) {
        if (!bodies[i].solid || (world != nullptr && world->bodies[i].where == BodyWhere::hidden)) {
            continue;
        }
        const Vector3 at_W =
            world == nullptr ? bodies[i].position_W : world->bodies[i].pose_W.position;
        const double away_m = (i == looked_at_ ? kStays : 1.0) * (at_W - hand_W).norm();
        if (!nearest_W || away_m < nearest_m) {
            nearest_W = at_W;
            nearest_m = away_m;
            seen = i;
        }
    }
    looked_at_ = seen;
    hand_->see(nearest_W);
}

std::vector<WorldCommand> place_at_first(const LessonDescription& lesson) {
    std::vector<WorldCommand> commands;
    const auto& bodies = lesson.bodies;
    for (std::size_t i = 0; i < bodies.size(); ++i) {
        if (bodies[i].visible || bodies[i].solid) {
            WorldCommand place;
            place.kind = WorldCommand::Kind::place;
            place.body = static_cast<std::int32_t>(i);
            place.position_W = bodies[i].position_W;
            commands.push_back(place);
        }
    }
    return commands;
}

void LessonRun::place_visible_bodies() {
    if (!world_loop_) {
        return;
    }
    for (const WorldCommand& place : place_at_first(session_->description())) {
        (void)world_channels_->commands.push(place);  // as many as bodies: they fit
    }
}

}  // namespace fulcrum::runtime
