// The step path of arm_server.h; what builds it stands in arm_server_build.cpp.
#include "haptics/link/arm_server.h"

#include "haptics/math/length.h"
#include "haptics/math/rotation.h"

#include <algorithm>
#include <cmath>

namespace fulcrum {
namespace {

bool is_zero(const Wrench& wrench) noexcept {
    return wrench.force.squaredNorm() == 0.0 && wrench.torque.squaredNorm() == 0.0;
}

constexpr double kWelcomeEvery_s = 0.02;  // to one session
constexpr int kMostWelcomes = 8;          // in a round
constexpr double kBrakeAfter_s = 0.05;    // it goes so long after nothing is asked for any more
constexpr double kBrakeShare = 8.0;       // alpha <= m / 8 T (coupling/passivity.h)
constexpr double kUnderLimit = 1.0 - 1.0e-12;  // by no rounding above it, here or in the gate

}  // namespace

void ArmServer::step(double now_s) noexcept {
    begin_round(now_s);
    take_packets();
    take_stops();
    read_arm();
    count_energy();
    drive();
    tell_state();
    publish();
}

void ArmServer::begin_round(double now_s) noexcept {
    faults_ = late_faults_;
    late_faults_ = Fault::none;
    dt_s_ = started_ ? now_s - now_s_ : 1.0 / settings_.rate_Hz;
    if (std::isfinite(now_s)) {
        started_ = true;
        now_s_ = now_s;
    }
    if (!(dt_s_ > 0.0)) {
        faults_ |= Fault::command_invalid;
    }
}

void ArmServer::take_packets() noexcept {
    post_.begin_round();
    n_welcomes_ = 0;
    while (const auto opened = post_.open_next(now_s_)) {
        take(*opened);
    }
    if (post_.has_partner() && std::abs(now_s_ - heard_s_) > settings_.lost_after_s) {
        forget_holder();
    }
    // A command that is due at the timeout itself and not there is missing.
    const double longest_s = settings_.safety.command_timeout_s - 0.5 / settings_.rate_Hz;
    const bool is_fresh = has_command_ && std::abs(now_s_ - command_age_from_s_) <= longest_s;
    if (!is_fresh) {
        faults_ |= Fault::command_stale;
    }
}

void ArmServer::take(const OpenedPacket& opened) noexcept {
    const PacketHead& head = opened.packet.head;
    if (head.kind == PacketKind::hello && head.receiver == 0) {
        welcome(opened);
        return;
    }
    // What only an arm says is no program's.
    if (head.kind != PacketKind::command && head.kind != PacketKind::bye) {
        post_.refuse();
        return;
    }
    if (!post_.has_partner() && head.kind == PacketKind::command &&
        head.receiver == post_.session()) {
        post_.set_partner(head.sender, opened.from);
        heard_s_ = now_s_;
        ++now_.sessions;
    }
    if (!post_.accept(now_s_, opened)) {
        return;
    }
    if (head.kind == PacketKind::bye) {
        forget_holder();
    } else if (head.sequence > command_number_) {
        take_command(opened);
        // Old packets that somebody has kept and gives out slowly hold nothing.
        if (now_s_ - command_age_from_s_ <= settings_.safety.command_timeout_s) {
            heard_s_ = now_s_;
        }
    }
}

void ArmServer::take_command(const OpenedPacket& opened) noexcept {
    // Whatever the program's rate, so many in a row are no chance any more.
    if (has_command_ && post_.missing() >= kLostInARow) {
        faults_ |= Fault::command_stale;
    }
    command_number_ = opened.packet.head.sequence;
    command_ = opened.packet.command;
    has_command_ = true;
    command_age_from_s_ = post_.compute_usual_arrival_s(now_s_, opened.packet.head.sent_ns);
}

// Answers a hello, and remembers no more of it than when: an old one that somebody kept changes nothing, and a flood of one hello, or
// of many, gets few answers while others still get theirs.
void ArmServer::welcome(const OpenedPacket& opened) noexcept {
    const std::uint64_t from = opened.packet.head.sender;
    const auto known = std::find_if(greeted_.begin(), greeted_.end(),
                                    [&](const Greeted& g) { return g.session == from; });
    const bool is_known = known != greeted_.end();
    if (n_welcomes_ >= kMostWelcomes ||
        (is_known && std::abs(now_s_ - known->at_s) < kWelcomeEvery_s)) {
        return;
    }
    ++n_welcomes_;
    Greeted& place = is_known ? *known : greeted_[next_greeted_++ % greeted_.size()];
    place = {from, now_s_};
    LinkPacket packet;
    packet.head.kind = PacketKind::welcome;
    packet.traits = traits_;
    packet.traits.taken = post_.has_partner() ? 1 : 0;
    post_.send_to(now_s_, packet, opened.packet.head.sender, opened.from);
}

void ArmServer::forget_holder() noexcept {
    post_.begin_session();
    has_command_ = false;
    command_number_ = 0;
    command_ = LinkCommand{};
    force_.reset();
    torque_.reset();
}

// As the haptic loop does it: a stop that comes while an earlier one is being lifted stays.
void ArmServer::take_stops() noexcept {
    const bool lifts = rearm_wanted_.load(std::memory_order_acquire);
    if (stop_.take()) {
        faults_ |= Fault::emergency_stop;
        if (lift_waits_) {
            rearm_wanted_.store(false, std::memory_order_release);
        }
        lift_waits_ = lifts && !lift_waits_;
        return;
    }
    lift_waits_ = lifts && gate_.is_fading();
    if (lifts && !lift_waits_) {
        rearm_wanted_.store(false, std::memory_order_release);
        if (gate_.phase() == GatePhase::stopped) {
            gate_.reset();
        }
    }
}

void ArmServer::read_arm() noexcept {
    motion_D_.setZero();
    turn_D_.setZero();
    DeviceReading reading{};
    if (!arm_.read(now_s_, reading)) {
        faults_ |= Fault::device_read;
        return;
    }
    if (!is_reading(reading)) {
        faults_ |= Fault::device_invalid;
        return;
    }
    faults_ |= reading.faults;
    if (!(std::abs(now_s_ - reading.stamp_s) <= settings_.safety.device_timeout_s)) {
        faults_ |= Fault::device_stale;
        return;
    }
    // An impossible jump is a fault of its own, and no motion that anybody paid for.
    const Vector3 way_D = reading.pose_D.position - reading_.pose_D.position;
    const double since_s = std::max(reading.stamp_s - reading_.stamp_s, 1.0 / settings_.rate_Hz);
    const bool follows = has_pose_ && reading.stamp_s >= reading_.stamp_s &&
                         way_D.norm() <= settings_.safety.max_hand_speed_m_per_s * since_s;
    if (follows) {
        motion_D_ = way_D;
        turn_D_ = compute_log(reading.pose_D.orientation * reading_.pose_D.orientation.conjugate());
    } else {
        faults_ |= has_pose_ ? Fault::device_invalid : Fault::none;
        guard_.forget();
        sensor_.forget();
        velocity_.reset();
        angular_velocity_.reset();
        way_.reset();
        turn_way_.reset();
    }
    reading_ = reading;
    has_pose_ = true;
    velocity_.step(reading_.pose_D.position, reading_.stamp_s);
    angular_velocity_.step(reading_.pose_D.orientation, reading_.stamp_s);
    faults_ |= guard_.step(applied_D_, motion_D_, turn_D_, dt_s_) |
               sensor_.step(reading_.pose_D.position, reading_.stamp_s, applied_D_.force);
}

void ArmServer::count_energy() noexcept {
    way_.step(motion_D_, dt_s_);
    turn_way_.step(turn_D_, dt_s_);
    force_.step(applied_D_.force, motion_D_, command_.given.force_J, dt_s_);
    torque_.step(applied_D_.torque, turn_D_, command_.given.torque_J, dt_s_);
}

// A hand that bounces is braked on its way through free space too; one whose program has faded is not held on to.
Wrench ArmServer::brake() noexcept {
    const Wrench& asked = command_.wrench_D;
    if (asked.force.squaredNorm() > 0.0 || asked.torque.squaredNorm() > 0.0) {
        asked_s_ = now_s_;
    }
    const double share = std::clamp(1.0 - (now_s_ - asked_s_) / kBrakeAfter_s, 0.0, 1.0);
    if (!settings_.balances_energy || !(dt_s_ > 0.0) || share <= 0.0) {
        return {};
    }
    // What is written now is held for as long as the next round, not as long as a last one that made up for lateness.
    const double hold_s = std::max(dt_s_, 1.0 / settings_.rate_Hz);
    const double most = settings_.handle_mass_kg / (kBrakeShare * hold_s);
    const double most_turning = settings_.handle_inertia_kg_m2 / (kBrakeShare * hold_s);
    const Vector3 velocity = way_.velocity();
    const Vector3 turning = turn_way_.velocity();
    return {velocity * (-share * force_.compute_damping(velocity * dt_s_, dt_s_, most)),
            turning * (-share * torque_.compute_damping(turning * dt_s_, dt_s_, most_turning))};
}

// After packets that were lost the arm catches up with the program no faster than the program's own gate goes: in force this side's gate
// takes its slew; in torque the ratio of the two may be another than here.
Vector3 ArmServer::approach(const Vector3& torque_Nm) const noexcept {
    if (gate_.phase() != GatePhase::rising && gate_.phase() != GatePhase::open) {
        // What waits must be calm by itself, and what fades follows nothing.
        return torque_Nm;
    }
    const double torque_per_force_m =
        command_.max_force_N > 0.0 ? command_.max_torque_Nm / command_.max_force_N : 0.0;
    const double reach_Nm =
        command_.max_slew_N_per_s * torque_per_force_m * std::clamp(dt_s_, 0.0, kLongestStep_s);
    return applied_D_.torque + shorten<3>(torque_Nm - applied_D_.torque, reach_Nm);
}

// Whatever was asked for, what leaves here has passed the gate.
void ArmServer::drive() noexcept {
    Wrench wanted{};
    if (has_command_) {
        const Wrench braked = brake();
        const Wrench asked{shorten(command_.wrench_D.force, command_.max_force_N),
                           shorten(command_.wrench_D.torque, command_.max_torque_Nm)};
        const Wrench left =
            settings_.balances_energy
                ? Wrench{force_.hold_back(asked.force, way_.velocity() * dt_s_),
                         torque_.hold_back(asked.torque, turn_way_.velocity() * dt_s_)}
                : asked;
        // The brake has no limit of its own: what finds no room below the program's stays a debt, and is braked later.
        wanted = {shorten<3>(left.force + braked.force, command_.max_force_N * kUnderLimit),
                  approach(shorten<3>(left.torque + braked.torque,
                                      command_.max_torque_Nm * kUnderLimit))};
        gate_.limit_slew(command_.max_slew_N_per_s);
    }
    const GatePhase before = gate_.phase();
    const bool acted = !is_zero(applied_D_);
    now_.asked_D = wanted;
    applied_D_ = gate_.pass(wanted, faults_, dt_s_);
    faults_ |= gate_.faults();
    const bool was_open = before == GatePhase::rising || before == GatePhase::open;
    const bool is_closing =
        gate_.phase() == GatePhase::fading || gate_.phase() == GatePhase::stopped;
    now_.trips += was_open && is_closing ? 1 : 0;
    if (acted && is_zero(applied_D_)) {
        now_.gone_after_s = now_s_ - command_age_from_s_;
    }
    // What this finds comes after the gate, and so fades the force from the next round on.
    const bool is_written = arm_.write(now_s_, applied_D_);
    if (!is_written) {
        late_faults_ = Fault::device_write;
    }
    stop_.tell_still(is_written && gate_.is_still());
}

void ArmServer::tell_state() noexcept {
    if (!post_.has_partner() || !has_pose_) {
        return;
    }
    LinkPacket packet;
    packet.head.kind = PacketKind::state;
    LinkState& state = packet.state;
    state.measured_ns = LinkPost::to_ns(reading_.stamp_s);
    state.pose_D = reading_.pose_D;
    state.twist_D = {shorten(velocity_.velocity(), kFastestTold),
                     shorten(angular_velocity_.velocity(), kFastestTold)};
    state.applied_D = applied_D_;
    state.given = {force_.gave_J(), torque_.gave_J()};
    state.buttons = reading_.buttons;
    state.faults = faults_;
    if (gate_.phase() == GatePhase::stopped) {
        state.faults |= Fault::emergency_stop;
    }
    state.gate = gate_.phase();
    post_.send(now_s_, packet);
}

void ArmServer::publish() noexcept {
    now_.held = post_.has_partner();
    now_.faults = faults_;
    now_.gate = gate_.phase();
    now_.pose_D = reading_.pose_D;
    now_.applied_D = applied_D_;
    now_.round_trip_s = post_.clock().round_trip_s();
    now_.offset_s = post_.clock().offset_s();
    now_.excess_J = force_.excess_J() + torque_.excess_J();
    now_.peak_excess_J = force_.peak_excess_J();
    now_.peak_force_N = std::max(now_.peak_force_N, applied_D_.force.norm());
    now_.counts = post_.counts();
    status_.publish(now_);
}

void ArmServer::silence(double now_s) noexcept {
    gate_.silence();
    applied_D_ = Wrench{};
    (void)arm_.write(now_s, applied_D_);
    if (post_.has_partner()) {
        LinkPacket bye;
        bye.head.kind = PacketKind::bye;
        post_.send(now_s, bye);
        forget_holder();
    }
}

}  // namespace fulcrum
