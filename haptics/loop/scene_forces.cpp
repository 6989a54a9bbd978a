#include "haptics/loop/scene_forces.h"

#include "haptics/loop/stage_listener.h"

#include <limits>

namespace fulcrum {

// What is not in the plan is neither done nor told.
template <class Passed>
void SceneForces::move(const SceneRound& round, Passed passed) noexcept {
    move_proxy(round);
    if (touch_) {
        passed(HapticStage::proxy);
    }
    if (tool_) {
        move_tool(round);
        passed(HapticStage::tool);
    }
}

template <class Passed>
void SceneForces::compute(const SceneRound& round, Passed passed) noexcept {
    demand_ = SceneDemand{};
    round.teller.begin(round.has_pose);
    if (tool_) {
        add_tool(round.teller);
    }
    if (touch_) {
        add_contact(round);
        passed(HapticStage::coupling);
    }
    if (solids_ && solids_->axles) {
        turn_axles(round);
        passed(HapticStage::turning);
    }
    if (solids_ && solids_->bodies) {
        push_bodies(round);
        passed(HapticStage::pushing);
    }
    if (touch_ && touch_->effects() != nullptr) {
        add_surface(round, passed);
    }
    if (weight_) {
        add_weight(round);
        passed(HapticStage::weight);
    }
    for (std::size_t i = 0; i < fields_.size(); ++i) {
        add_field(i, round);
        passed(stage_of(plan_.fields[i].kind));
    }
    if (line_) {
        add_line(round);
        passed(HapticStage::line);
    }
    if (lesson_force_) {
        add_lesson_force(round);
        passed(HapticStage::lesson);
    }
    round.state.commanded_W = round.has_pose ? demand_.wrench_W : Wrench{};
}

template void SceneForces::move(const SceneRound& round, NobodyListens passed) noexcept;
template void SceneForces::move(const SceneRound& round, TellsListener passed) noexcept;
template void SceneForces::compute(const SceneRound& round, NobodyListens passed) noexcept;
template void SceneForces::compute(const SceneRound& round, TellsListener passed) noexcept;

// Where everything is that can be touched; false where that is not known in this round.
bool SceneForces::find_solids(const SceneRound& round) noexcept {
    if (!solids_) {
        return false;
    }
    if (!round.has_pose) {
        solids_->leave();
        return false;
    }
    const bool is_told = plan_.expects_world && round.heard_world;
    if (!solids_->step(is_told ? &channels_.world.value() : nullptr, round.now_s)) {
        round.state.faults |= Fault::command_invalid;
        return false;
    }
    // What the world of rigid bodies tells is a step old.
    if (solids_->bodies && !(solids_->bodies->age_s(round.now_s) <=
                             plan_.safety.command_timeout_s + kLongestRigidStep_s)) {
        round.state.faults |= Fault::command_stale;
    }
    // Of what has been put elsewhere at once, proxy and tool are told.
    const std::uint32_t put = solids_->put();
    if (touch_ && put != 0) {
        touch_->put(put, solids_->poses_W());
    }
    if (tool_ && put != 0) {
        tool_->let_go(put);
    }
    return true;
}

void SceneForces::move_proxy(const SceneRound& round) noexcept {
    HapticState& state = round.state;
    state.proxy_position_W = state.tool_pose_W.position;
    state.proxy_orientation_W = state.tool_pose_W.orientation;
    state.touched_body = kNoBody;
    const bool is_known = find_solids(round);
    if (!touch_) {
        return;
    }
    if (!is_known) {
        touch_->leave();
        return;
    }
    state.proxy_orientation_W = touch_->move(state.tool_pose_W, solids_->poses_W());
    state.proxy_position_W = touch_->contact().position_W;
    state.touched_body = solids_->body_of(touch_->contact().solid);
}

// The tool among the solids; without a force while anything is wrong.
void SceneForces::move_tool(const SceneRound& round) noexcept {
    tool_force_ = {};
    if (!round.has_pose) {
        return;
    }
    HapticState& state = round.state;
    const GatePhase phase = round.gate.phase();
    const bool is_open = phase != GatePhase::fading && phase != GatePhase::stopped;
    tool_force_ = tool_->step({.hand = {state.tool_pose_W, state.tool_twist_W},
                               .solid_poses_W = solids_->poses_W(),
                               .is_fit = is_open && !any(state.faults),
                               .now_s = round.now_s,
                               .dt_s = round.dt_s});
    if (tool_force_.failed) {
        state.faults |= Fault::command_invalid;
    }
    state.tool = tool_->effort();
    state.proxy_position_W = tool_->pose_W().position;
    state.proxy_orientation_W = tool_->pose_W().orientation;
    state.touched_body = solids_->body_of(tool_->solid());
}

void SceneForces::add_tool(RoundTeller& teller) noexcept {
    demand_.contact = tool_force_.contact;
    demand_.wrench_W.force += tool_force_.wrench_W.force;
    demand_.wrench_W.torque += tool_force_.wrench_W.torque;
    demand_.force += tool_force_.elastic_force;
    demand_.torque += tool_force_.elastic_torque;
    teller.share(Effect::tool, tool_force_.spring_W.force, tool_force_.spring_W.torque);
    const Wrench& texture_W = tool_force_.texture_W;
    if (tool_->has_texture()) {
        teller.share(Effect::texture, texture_W.force, texture_W.torque);
    }
    teller.share(Effect::tool_damping,
                 tool_force_.wrench_W.force - tool_force_.spring_W.force - texture_W.force,
                 tool_force_.wrench_W.torque - tool_force_.spring_W.torque - texture_W.torque);
}

void SceneForces::add_contact(const SceneRound& round) noexcept {
    const ContactForce felt =
        touch_->couple(round.state.tool_pose_W.position, round.hand, solids_->poses_W());
    if (solids_->may_move()) {
        touch_->keep(solids_->poses_W(), round.hand.stamp_s);
    }
    if (touch_->contact().solid < 0) {
        return;
    }
    demand_.contact = felt.spring;
    demand_.force += felt.counted;
    demand_.wrench_W.force += felt.force_W;
    round.teller.share(Effect::contact, felt.spring.force);
    round.teller.share(Effect::contact_damping, felt.force_W - felt.spring.force);
}

// What the hand presses turns; the contact's is the first force of the round, and so far the only one.
void SceneForces::turn_axles(const SceneRound& round) noexcept {
    const double most_N = round.gate.find_most_N(round.dt_s);
    if (tool_) {
        // The hand feels the world's torques over the scale (tool_stage.h).
        solids_->axles->push_by_tool(
            tool_->pushes(), {most_N, round.gate.find_most_Nm(round.dt_s) * plan_.workspace.scale},
            round.dt_s);
        return;
    }
    solids_->axles->push(touch_->contact(), {demand_.wrench_W.force, most_N}, round.dt_s);
}

// Bodies are pushed by what the hand feels of them: the contact, the grip, the tool.
void SceneForces::push_bodies(const SceneRound& round) noexcept {
    BodyStage& bodies = *solids_->bodies;
    const double most_N = round.gate.find_most_N(round.dt_s);
    if (tool_) {
        bodies.push_by_tool(tool_->pushes(),
                            {most_N, round.gate.find_most_Nm(round.dt_s) * plan_.workspace.scale},
                            round.now_s);
        return;
    }
    HapticState& state = round.state;
    const HandPush touch{demand_.wrench_W.force, most_N};
    // A gate that lets nothing through holds nothing: what a grip asks for would keep it closed.
    const GatePhase phase = round.gate.phase();
    const bool may_grip = phase == GatePhase::open || phase == GatePhase::rising;
    // Nobody's hand jumps: where it is then the next round tells.
    const bool is_there = round.has_pose && !any(state.faults & Fault::device_invalid);
    const GripForce grip = bodies.grip(
        touch_->contact(), {state.tool_pose_W, state.tool_twist_W,
                            may_grip ? state.buttons : std::uint32_t{0}, may_grip, is_there});
    demand_.wrench_W.force += grip.force_W;
    demand_.force += {grip.spring_W, grip.spring_W};
    round.teller.share(Effect::grip, grip.force_W);
    if (bodies.gripped() >= 0) {
        state.touched_body = solids_->body_of(bodies.gripped());
    }
    if (const Pose* const held_W = bodies.held_pose_W()) {
        state.proxy_position_W = held_W->position;
        state.proxy_orientation_W = held_W->orientation;
    }
    bodies.push(touch_->contact(), touch, round.now_s);
}

template <class Passed>
void SceneForces::add_surface(const SceneRound& round, Passed passed) noexcept {
    SurfaceEffects& effects = *touch_->effects();
    effects.begin_round(touch_->touches(), solids_->poses_W(),
                        {round.state.tool_pose_W.position, round.state.proxy_position_W,
                         round.state.tool_twist_W.linear, round.dt_s});
    if (effects.texture) {
        const SurfaceForce felt = effects.add_texture();
        add_surface_force(felt);
        round.teller.share(Effect::texture, felt.force_W);
        passed(HapticStage::texture);
    }
    if (effects.transient) {
        const SurfaceForce felt = effects.add_transient();
        add_surface_force(felt);
        round.teller.share(Effect::tap, felt.force_W);
        passed(HapticStage::transient);
    }
    if (effects.teller) {
        effects.tell(round.now_s);
    }
}

void SceneForces::add_surface_force(const SurfaceForce& felt) noexcept {
    demand_.wrench_W.force += felt.force_W;
    demand_.force += felt.counted;
}

void SceneForces::add_weight(const SceneRound& round) noexcept {
    const Vector3& carried_W = channels_.world.value().carried_force_W;
    if (!is_finite(carried_W)) {
        round.state.faults |= Fault::command_invalid;
    }
    const Vector3 before_W = weight_->force_W();
    const Vector3& force_W = weight_->step(carried_W, round.dt_s);
    demand_.wrench_W.force += force_W;
    demand_.force += {force_W, before_W};
    round.teller.share(Effect::weight, force_W);
}

void SceneForces::add_field(std::size_t index, const SceneRound& round) noexcept {
    FieldStage& field = fields_[index];
    const Vector3 force_W =
        field.step(channels_.command.value().fields[index], round.state.tool_pose_W.position,
                   round.state.tool_twist_W.linear, round.dt_s);
    demand_.wrench_W.force += force_W;
    demand_.force += field.elastic();
    round.teller.share(Effect::field, force_W, Vector3::Zero(), index);
}

void SceneForces::add_line(const SceneRound& round) noexcept {
    if (!round.has_pose) {
        return;
    }
    // While the gate is shut the line lets go as if its world were silent: a pull that stays would keep it from engaging for ever.
    const GatePhase phase = round.gate.phase();
    const bool is_open = phase == GatePhase::rising || phase == GatePhase::open;
    constexpr double kSilent_s = std::numeric_limits<double>::infinity();
    const double line_now_s = is_open ? round.now_s : +kSilent_s;
    const Pose& hand_W = round.state.tool_pose_W;
    // Nobody's hand jumps: where it is then the next round tells.
    if (!any(round.state.faults & Fault::device_invalid)) {
        line_->tell_hand(hand_W.position);
    }
    const LineForce felt = line_->step(hand_W, line_now_s, round.dt_s);
    demand_.wrench_W.force += felt.wrench_W.force;
    demand_.wrench_W.torque += felt.wrench_W.torque;
    demand_.force += felt.force;
    demand_.torque += felt.torque;
    round.teller.share(Effect::line, felt.wrench_W.force, felt.wrench_W.torque);
}

void SceneForces::add_lesson_force(const SceneRound& round) noexcept {
    const Wrench wrench_W =
        lesson_force_->step(channels_.command.value().linearised, round.state.tool_pose_W.position,
                            round.state.tool_twist_W.linear, round.now_s);
    demand_.wrench_W.force += wrench_W.force;
    demand_.wrench_W.torque += wrench_W.torque;
    demand_.force += lesson_force_->elastic_force();
    demand_.torque += lesson_force_->elastic_torque();
    round.teller.share(Effect::lesson, wrench_W.force, wrench_W.torque);
    if (has(lesson_force_->notes(), LinearisationNote::refused_not_finite)) {
        round.state.faults |= Fault::command_invalid;
    }
}

void SceneForces::forget(const Vector3& hand_W) noexcept {
    if (touch_) {
        touch_->forget(hand_W);
    }
    if (tool_) {
        tool_->let_go();
    }
    if (solids_ && solids_->bodies) {
        solids_->bodies->let_go();
    }
}

}  // namespace fulcrum
