// The step path of link_device.h; what opens and closes the link stands in link_device_build.cpp.
#include "haptics/link/link_device.h"

#include "haptics/math/length.h"
#include "haptics/math/rotation.h"

#include <algorithm>
#include <cmath>

namespace fulcrum {
namespace {

constexpr double kTurnPerMetre = 10.0;    // a shift's turn goes back so many radians for each metre
constexpr double kLongestShift_m = 0.05;  // what a link needs more for is no link
constexpr double kLongestShiftPerRound_m = 1.0e-3;
constexpr double kLongestTurn_rad = 0.5;
constexpr double kLongestTurnPerRound_rad = 1.0e-2;
constexpr double kLongestRound_s = 0.05;
constexpr double kAskedFor_N = 0.2;  // what a gate that waits calls calm
constexpr double kAskedFor_Nm = 0.02;
constexpr double kShutFor_s = 0.05;
// Who moves so fast is not for so long where he was.
constexpr double kMoving_m_per_s = 0.05;
constexpr std::int64_t kLongestAtRest_ns = 50'000'000;

bool is_same_arm(const LinkTraits& a, const LinkTraits& b) noexcept {
    return a.name == b.name && a.max_force_N == b.max_force_N &&
           a.max_torque_Nm == b.max_torque_Nm && a.damping_Ns_per_m == b.damping_Ns_per_m &&
           a.mass_kg == b.mass_kg && a.position_resolution_m == b.position_resolution_m;
}

}  // namespace

bool LinkDevice::read(double now_s, DeviceReading& reading) noexcept {
    take_packets(now_s);
    if (post_.has_partner() && now_s - heard_s_ > settings_.lost_after_s) {
        begin_link();
    }
    if (!post_.has_partner()) {
        say_hello(now_s);
    }
    if (has_state_) {
        balance(now_s);
    }
    watch_way(now_s);
    publish();
    if (!has_state_ || post_.clock().round_trip_s() > settings_.most_round_trip_s) {
        return false;
    }
    const bool is_frozen = state_.measured_ns - moved_ns_ > kLongestAtRest_ns;
    reading.stamp_s = stamp_s_;
    reading.pose_D.position = state_.pose_D.position + shift_D_;
    reading.pose_D.orientation = compute_exp(turn_D_) * state_.pose_D.orientation;
    reading.buttons = state_.buttons;
    reading.faults = (state_.faults & Fault::emergency_stop) | find_shut_gate(now_s) |
                     (lost_row_ || is_frozen ? Fault::device_stale : Fault::none);
    return true;
}

void LinkDevice::take_packets(double now_s) noexcept {
    lost_row_ = false;
    post_.begin_round();
    while (const auto opened = post_.open_next(now_s)) {
        take(now_s, *opened);
    }
}

void LinkDevice::take(double now_s, const OpenedPacket& opened) noexcept {
    const PacketKind kind = opened.packet.head.kind;
    if (kind == PacketKind::welcome && !post_.has_partner()) {
        take_welcome(now_s, opened);
        return;
    }
    // A program's own kinds, sent back to it, are no arm's.
    if (kind == PacketKind::hello || kind == PacketKind::command) {
        post_.refuse();
        return;
    }
    if (!post_.accept(now_s, opened)) {
        return;
    }
    heard_s_ = now_s;
    if (kind == PacketKind::bye) {
        begin_link();
    } else if (kind == PacketKind::state && opened.packet.head.sequence > state_number_) {
        lost_row_ = lost_row_ || follows_lost_row(opened.packet.head);
        state_number_ = opened.packet.head.sequence;
        state_sent_ns_ = opened.packet.head.sent_ns;
        take_state(now_s, opened.packet.state);
    }
}

// An arm numbers its welcomes to others as well: what is missing was states only as far as the arm has had rounds for them.
bool LinkDevice::follows_lost_row(const PacketHead& head) const noexcept {
    const double rounds =
        static_cast<double>(head.sent_ns - state_sent_ns_) * 1.0e-9 * arm_.rate_Hz;
    return has_state_ && post_.missing() >= kLostInARow &&
           rounds >= static_cast<double>(kLostInARow);
}

// Clocks are compared ever better: for that a stamp neither goes back nor stands, or a velocity would have no bound. It goes on by half of
// what the arm's clock did at least; what was not measured later has no later stamp.
void LinkDevice::take_state(double now_s, const LinkState& state) noexcept {
    constexpr double kLeastPace = 0.5;
    const double since_s = 1.0e-9 * static_cast<double>(state.measured_ns - state_.measured_ns);
    const double stamp_s = post_.compute_usual_arrival_s(now_s, state.measured_ns);
    if (!has_state_) {
        stamp_s_ = stamp_s;
    } else if (since_s > 0.0) {
        // Whatever an arm says of its clock, nothing is measured after it is heard of.
        stamp_s_ = std::min(std::max(stamp_s, stamp_s_ + kLeastPace * since_s), now_s);
    }
    const bool is_elsewhere = state.pose_D.position != state_.pose_D.position;
    if (!has_state_ || is_elsewhere || !(state.twist_D.linear.norm() > kMoving_m_per_s)) {
        moved_ns_ = state.measured_ns;
    }
    state_ = state;
    has_state_ = true;
}

void LinkDevice::take_welcome(double now_s, const OpenedPacket& opened) noexcept {
    // It answers this session's hello, whose number was drawn at random: it cannot be older.
    if (opened.packet.head.receiver != post_.session()) {
        post_.refuse();
        return;
    }
    const LinkTraits& arm = opened.packet.traits;
    now_.taken = arm.taken != 0;
    now_.changed = knows_arm_ && !is_same_arm(arm, arm_);
    if (now_.taken || now_.changed) {
        return;
    }
    if (!knows_arm_) {
        arm_ = arm;
        knows_arm_ = true;
    }
    post_.set_partner(opened.packet.head.sender, opened.from);
    if (post_.accept(now_s, opened)) {
        heard_s_ = now_s;
        ++now_.sessions;
    }
}

void LinkDevice::say_hello(double now_s) noexcept {
    if (said_hello_s_ >= 0.0 && now_s - said_hello_s_ < kHelloEvery_s) {
        return;
    }
    said_hello_s_ = now_s;
    LinkPacket hello;
    hello.head.kind = PacketKind::hello;
    post_.send_to(now_s, hello, 0, {});
}

void LinkDevice::begin_link() noexcept {
    post_.begin_session();
    has_state_ = false;
    state_number_ = 0;
    counts_motion_ = false;
    sent_D_ = Wrench{};
    force_.reset();
    torque_.reset();
    shift_D_.setZero();
    turn_D_.setZero();
}

// Counts what crossed the link since the last round, and moves the scene's hand where the link was active.
void LinkDevice::balance(double now_s) noexcept {
    if (!counts_motion_) {
        counts_motion_ = true;
        counted_D_ = state_.pose_D;
        counted_s_ = now_s;
        return;
    }
    const double dt_s = std::min(now_s - counted_s_, kLongestRound_s);
    if (!(dt_s > 0.0)) {
        return;
    }
    force_.step(sent_D_.force, state_.pose_D.position - counted_D_.position, state_.given.force_J,
                dt_s);
    // As the scene sees it turn: its hand is turned by the shift.
    const Vector3 turned_D =
        compute_log(state_.pose_D.orientation * counted_D_.orientation.conjugate());
    torque_.step(sent_D_.torque, compute_exp(turn_D_) * turned_D, state_.given.torque_J, dt_s);
    counted_D_ = state_.pose_D;
    counted_s_ = now_s;
    if (settings_.balances_energy) {
        shift_hand(dt_s);
    }
}

void LinkDevice::shift_hand(double dt_s) noexcept {
    const auto go_back = [dt_s](EnergyBalance& port, const Vector3& force, const Vector3& shift,
                                double reach) {
        return Vector3(shift + port.shift_back(force, -shorten(shift, reach), dt_s));
    };
    const double reach_m = settings_.return_m_per_s * dt_s;
    shift_D_ = go_back(force_, sent_D_.force, shift_D_, reach_m);
    turn_D_ = go_back(torque_, sent_D_.torque, turn_D_, reach_m * kTurnPerMetre);
    // Only what is really moved is settled.
    shift_D_ += force_.shift(
        sent_D_.force, std::clamp(kLongestShift_m - shift_D_.norm(), 0.0, kLongestShiftPerRound_m));
    turn_D_ += torque_.shift(sent_D_.torque, std::clamp(kLongestTurn_rad - turn_D_.norm(), 0.0,
                                                        kLongestTurnPerRound_rad));
}

// An arm that lets nothing through while it is asked for a force has faded by itself: the scene must not go on as if it were felt.
// Both gates then begin anew together.
Fault LinkDevice::find_shut_gate(double now_s) noexcept {
    const bool is_shut = state_.gate == GatePhase::waiting || state_.gate == GatePhase::fading;
    const bool asks = sent_D_.force.norm() > kAskedFor_N || sent_D_.torque.norm() > kAskedFor_Nm;
    if (!is_shut || !asks) {
        shut_since_s_ = now_s;
    }
    const double patience_s = kShutFor_s + post_.clock().round_trip_s();
    return now_s - shut_since_s_ > patience_s ? Fault::command_stale : Fault::none;
}

bool LinkDevice::write(double now_s, const Wrench& wrench_D) noexcept {
    if (!post_.has_partner() || !is_finite(wrench_D)) {
        return false;
    }
    if (sent_s_ >= 0.0 && now_s - sent_s_ < kSendEvery_s && now_s >= sent_s_) {
        return true;
    }
    sent_s_ = now_s;
    sent_D_ = wrench_D;
    LinkPacket packet;
    packet.head.kind = PacketKind::command;
    packet.command.wrench_D = wrench_D;
    packet.command.max_force_N = settings_.max_force_N;
    packet.command.max_torque_Nm = settings_.max_torque_Nm;
    packet.command.max_slew_N_per_s = settings_.max_slew_N_per_s;
    packet.command.given = {force_.gave_J(), torque_.gave_J()};
    post_.send(now_s, packet);
    return true;
}

// One packet that waited somewhere is no long way, and without any nothing is known of it.
void LinkDevice::watch_way(double now_s) noexcept {
    const bool is_long = post_.clock().newest_round_trip_s() > settings_.most_round_trip_s;
    if (!has_state_ || !post_.clock().is_known() || is_long == now_.too_long) {
        way_since_s_ = now_s;
    } else if (now_s - way_since_s_ > kWayFor_s) {
        now_.too_long = is_long;
    }
}

void LinkDevice::publish() noexcept {
    now_.linked = has_state_;
    now_.offset_s = post_.clock().offset_s();
    now_.round_trip_s = post_.clock().round_trip_s();
    now_.newest_round_trip_s = post_.clock().newest_round_trip_s();
    now_.shift_m = shift_D_.norm();
    now_.peak_excess_J = force_.peak_excess_J();
    now_.arm_faults = state_.faults;
    now_.arm_gate = state_.gate;
    now_.counts = post_.counts();
    status_.publish(now_);
}

}  // namespace fulcrum
