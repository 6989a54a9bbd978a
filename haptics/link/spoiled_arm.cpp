#include "haptics/link/spoiled_arm.h"

#include "haptics/math/felt.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>
#include <limits>
#include <utility>

namespace fulcrum {
namespace {

constexpr double kBefore_s = 10.0;  // link time when the run begins: the link is made before
constexpr double kRound_s = 0.001;
constexpr double kHalfRound_s = 0.5 * kRound_s;
constexpr double kGone_N = 1.0e-9;
constexpr double kGone_Nm = 1.0e-9;

SimulatedArmSettings spoiled_settings() {
    SimulatedArmSettings settings = make_desktop_arm();
    settings.max_force_N = kHardForceCap_N;
    settings.human = kArm;
    return settings;
}

// A step of its dynamics and of its computer a round, half as many as it has by itself: for its time.
SimulatedWamSettings wam_settings() {
    SimulatedWamSettings settings;
    settings.longest_step_s = kRound_s;
    settings.grip.push = kArm;
    return settings;
}

ArmServerSettings server_settings(const SafetySettings& own) {
    ArmServerSettings settings;
    settings.safety = own;
    return settings;
}

constexpr std::uint64_t kFirstHash = 0xCBF29CE484222325U;

// As FNV-1a (G. Fowler, L. C. Noll, K.-P. Vo 1991), with words of eight bytes; the high bits come down, for a product moves them up alone.
std::uint64_t mix(std::uint64_t hash, std::uint64_t word) noexcept {
    constexpr std::uint64_t kPrime = 0x100000001B3U;
    const std::uint64_t product = (hash ^ word) * kPrime;
    return product ^ (product >> 32);
}

}  // namespace

SpoiledArm::Arm::Arm(SpoiledModel model, LatestValue<HandTarget>& target) {
    if (model == SpoiledModel::wam) {
        wam = std::move(*SimulatedWam::create(wam_settings(), target));
        device = wam.get();
    } else {
        desktop = std::make_unique<SimulatedArm>(spoiled_settings(), target);
        device = desktop.get();
    }
}

bool SpoiledArm::Arm::read(double now_s, DeviceReading& reading) noexcept {
    (void)device->read(now_s, reading);
    handle_D = reading.pose_D.position;
    reading.pose_D.position += offset_D;
    if (spoil == Spoil::no_number) {
        reading.pose_D.position.y() = std::numeric_limits<double>::quiet_NaN();
    }
    // A clock that is stuck stands where it was told last, however long the program has slept before.
    reading.stamp_s = spoil == Spoil::stuck_sensor ? stamp_s : reading.stamp_s;
    stamps_back += reading.stamp_s < stamp_s ? 1 : 0;
    stamp_s = reading.stamp_s;
    return spoil != Spoil::no_pose;
}

bool SpoiledArm::Arm::write(double now_s, const Wrench& wrench_D) noexcept {
    written_D = wrench_D;
    return device->write(now_s, wrench_D) && spoil != Spoil::motor;
}

void SpoiledArm::Arm::take_hold(bool holds) noexcept {
    if (wam) {
        wam->take_hold(holds ? wam_settings().grip : kNoGrip);
    } else {
        desktop->take_hold(holds ? kArm : kNobody);
    }
}

SealTag SpoiledArm::OpenSeal::make(std::span<const std::byte> message) const noexcept {
    // The checksum tells nearly all damage; this only has to differ with every byte.
    std::uint64_t hash = kFirstHash;
    while (!message.empty()) {
        const std::size_t n = std::min(message.size(), sizeof hash);
        std::uint64_t word = 0;
        std::memcpy(&word, message.data(), n);
        hash = mix(hash, word);
        message = message.subspan(n);
    }
    SealTag tag{};
    for (std::size_t i = 0; i < sizeof hash; ++i) {
        tag[i] = static_cast<std::byte>((hash >> (8 * i)) & 0xFFU);
    }
    return tag;
}

bool SpoiledArm::OpenSeal::holds(std::span<const std::byte> message,
                                 std::span<const std::byte, kSealBytes> tag) const noexcept {
    const SealTag right = make(message);
    return std::equal(right.begin(), right.end(), tag.begin());
}

SpoiledArm::SpoiledArm(std::uint64_t seed, LatestValue<HandTarget>& target,
                       const SafetySettings& own, SpoiledModel model)
    : chance_(seed),
      planned_(target),
      hand_(compute_split_mix(~seed)),
      own_(own),
      arm_(model, wanted_),
      line_({.seed = seed}, channel_.end(0)),
      server_(server_settings(own), arm_, channel_.end(1), seal_, numbers_),
      device_({}, line_, seal_, numbers_) {
    counts_.hash = kFirstHash;
    for (double now_s = 0.0; now_s < 1.0 && !device_.greet(now_s); now_s += kRound_s) {
        server_.step(now_s + kHalfRound_s);
    }
    until_s_ = draw_first(chance_);
    watch_limits(own);
}

void SpoiledArm::keep_limits(const SafetySettings& run) noexcept {
    device_.tell_limits(run);
    watch_limits(run);
}

// A force goes through two gates, the program's and the arm's: each keeps all of its own, and the second what the first one told.
void SpoiledArm::watch_limits(const SafetySettings& run) noexcept {
    limits_ = least_of(felt_limits(run), felt_limits(own_));
}

double SpoiledArm::draw_first(SplitMix& chance) noexcept {
    return 1.0 + (kLongestGap_s - 1.0) * chance.draw_chance();
}

Spoil SpoiledArm::draw_kind(SplitMix& chance) noexcept {
    return static_cast<Spoil>(1 + static_cast<int>(chance.draw_chance() * (kSpoils - 1)));
}

FirstSpoil SpoiledArm::first_of(std::uint64_t seed) noexcept {
    SplitMix chance(seed);
    const double at_s = draw_first(chance);
    return {draw_kind(chance), at_s};
}

SpoiledArm::~SpoiledArm() = default;

const DeviceTraits& SpoiledArm::traits() const noexcept {
    return device_.traits();
}

const LinkFaultCounts& SpoiledArm::line_counts() const noexcept {
    return line_.counts();
}

double SpoiledArm::draw(double low, double high) noexcept {
    return low + (high - low) * chance_.draw_chance();
}

bool SpoiledArm::read(double now_s, DeviceReading& reading) noexcept {
    choose(now_s);
    move_hand(now_s);
    serve(now_s);
    const bool read = device_.read(kBefore_s + now_s, reading);
    reading.stamp_s -= kBefore_s;
    return read;
}

bool SpoiledArm::write(double now_s, const Wrench& wrench_D) noexcept {
    return device_.write(kBefore_s + now_s, wrench_D);
}

void SpoiledArm::move_hand(double now_s) noexcept {
    (void)planned_.take();
    wanted_.publish(hand_.step(now_s, planned_.value(), {arm_.handle_D, felt_D_.force}));
    if (hand_.holds() != holds_) {
        holds_ = hand_.holds();
        arm_.take_hold(holds_);
    }
    counts_.deeds = hand_.done();
}

// A program whose clock has jumped stood still, and the arm did not: its rounds of that time come first. What has had the time to go must
// be gone.
void SpoiledArm::serve(double now_s) noexcept {
    const double since_s = served_s_;
    while (now_s - served_s_ > 1.5 * kRound_s) {
        served_s_ += kRound_s;
        serve_alone(served_s_ - since_s);
    }
    served_s_ = now_s;
    serve_round();
}

void SpoiledArm::sleep(double seconds) noexcept {
    const double since_s = asleep_s_;
    while (asleep_s_ - since_s < seconds) {
        asleep_s_ += kRound_s;
        serve_alone(asleep_s_ - since_s);
    }
}

void SpoiledArm::serve_round() noexcept {
    server_.step(kBefore_s + asleep_s_ + served_s_ - kHalfRound_s);
    watch(served_s_);
}

void SpoiledArm::serve_alone(double since_s) noexcept {
    serve_round();
    if (since_s >= kMostFade_s && !is_gone()) {
        ++counts_.missed_fades;
        blame(served_s_);
    }
}

void SpoiledArm::blame(double now_s) noexcept {
    if (counts_.bad_since_s < 0.0) {
        counts_.bad_since_s = now_s;
        counts_.bad_in = spoil_;
    }
}

void SpoiledArm::choose(double now_s) noexcept {
    if (now_s < until_s_) {
        return;
    }
    if (spoil_ != Spoil::nothing) {
        end();
        from_s_ = now_s;
        until_s_ = now_s + draw(0.5, kLongestGap_s);
        return;
    }
    begin(draw_kind(chance_), now_s);
}

void SpoiledArm::begin(Spoil spoil, double now_s) noexcept {
    spoil_ = spoil;
    from_s_ = now_s;
    until_s_ = now_s + draw(0.3, 2.0);
    felt_before_ = is_felt(felt_D_);
    saw_gone_ = false;
    ++counts_.happened[static_cast<std::size_t>(spoil)];
    arm_.spoil = spoil;
    LinkFaults faults;
    switch (spoil) {
        case Spoil::loss:
            faults.loss = draw(0.01, 0.5);
            faults.burst = 1 + static_cast<int>(draw(0.0, 30.0));
            break;
        case Spoil::delay:
            faults.delay_s = draw(0.001, 0.04);
            break;
        case Spoil::jitter:
            faults.jitter_s = draw(0.001, 0.03);
            faults.reorder = draw(0.0, 0.5);
            break;
        case Spoil::doubles:
            faults.duplicate = draw(0.1, 1.0);
            break;
        case Spoil::damage:
            faults.corrupt = draw(0.01, 1.0);
            break;
        case Spoil::cut:
            faults.loss = 1.0;
            break;
        case Spoil::jump:
            arm_.offset_D += Vector3(draw(-0.1, 0.1), draw(-0.1, 0.1), draw(-0.1, 0.1));
            break;
        case Spoil::arm_stop:
            server_.stop();
            break;
        case Spoil::sleep:
            sleep(draw(0.02, kLongestGap_s));
            break;
        case Spoil::nothing:
        case Spoil::no_pose:
        case Spoil::no_number:
        case Spoil::stuck_sensor:
        case Spoil::motor:
            break;  // the arm's device does these by itself
    }
    line_.set(faults);
}

void SpoiledArm::end() noexcept {
    if (spoil_ == Spoil::arm_stop) {
        server_.rearm();
    }
    spoil_ = Spoil::nothing;
    arm_.spoil = Spoil::nothing;
    arm_.offset_D.setZero();
    line_.set({});
}

bool SpoiledArm::is_gone() const noexcept {
    return counts_.force_N <= kGone_N && counts_.torque_Nm <= kGone_Nm;
}

// What the hand feels, held against what it may, in the arm's own time: a round that a jump of the program's clock ends is longer.
void SpoiledArm::watch(double now_s) noexcept {
    const Wrench felt_D = arm_.written_D;
    const double dt_s = now_s + asleep_s_ - std::exchange(watched_s_, now_s + asleep_s_);
    const ArmServerStatus& status = server_.status();
    if (const FeltLimit broken = judge_.judge(limits_, {status.asked_D, felt_D, status.gate, dt_s});
        broken != FeltLimit::none) {
        ++counts_.broken_limits;
        counts_.broken = counts_.broken == FeltLimit::none ? broken : counts_.broken;
        blame(now_s);
    }
    felt_D_ = felt_D;
    counts_.force_N = felt_D.force.norm();
    counts_.torque_Nm = felt_D.torque.norm();
    counts_.peak_N = std::max(counts_.peak_N, counts_.force_N);
    counts_.peak_Nm = std::max(counts_.peak_Nm, counts_.torque_Nm);
    ++counts_.rounds;
    counts_.felt_rounds += counts_.force_N > kLeastFelt_N ? 1 : 0;
    counts_.turned_rounds += counts_.torque_Nm > kLeastFelt_Nm ? 1 : 0;
    counts_.may_feel = !must_fade(spoil_) && !any(status.faults);
    counts_.stamps_back = arm_.stamps_back;
    // A hand that goes too fast, or is given too much, shuts the arm's gate; the program hears of that as of a command that is not followed.
    if (any(status.faults & (Fault::hand_too_fast | Fault::too_much_energy))) {
        guarded_s_ = now_s;
    }
    counts_.quiet_s =
        spoil_ == Spoil::nothing ? std::max(now_s - std::max(from_s_, guarded_s_), 0.0) : 0.0;
    watch_fade(now_s);
    mix_in(now_s, felt_D);
}

void SpoiledArm::watch_fade(double now_s) noexcept {
    if (!must_fade(spoil_) || now_s - from_s_ < kMostFade_s) {
        return;
    }
    if (!is_gone()) {
        ++counts_.missed_fades;
        blame(now_s);
    } else if (felt_before_ && !saw_gone_) {
        saw_gone_ = true;
        ++counts_.fades;
        ++counts_.faded[static_cast<std::size_t>(spoil_)];
    }
}

void SpoiledArm::mix_in(double now_s, const Wrench& felt_D) noexcept {
    mix_in(&now_s, 1);
    // Where the joints are says where the handle is.
    if (arm_.wam) {
        const JointVector& angles_rad = arm_.wam->state().angle_rad;
        mix_in(angles_rad.data(), static_cast<std::size_t>(angles_rad.size()));
    } else {
        const Vector3 position_D = arm_.desktop->position_D();
        mix_in(position_D.data(), 3);
    }
    mix_in(felt_D.force.data(), 3);
    mix_in(felt_D.torque.data(), 3);
}

void SpoiledArm::mix_in(const double* values, std::size_t n) noexcept {
    for (std::size_t i = 0; i < n; ++i) {
        counts_.hash = mix(counts_.hash, std::bit_cast<std::uint64_t>(values[i]));
    }
}

}  // namespace fulcrum
