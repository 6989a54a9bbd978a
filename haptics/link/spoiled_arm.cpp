#include "haptics/link/spoiled_arm.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>
#include <limits>

namespace fulcrum {
namespace {

constexpr double kBefore_s = 10.0;  // link time when the run begins: the link is made before
constexpr double kRound_s = 0.001;
constexpr double kHalfRound_s = 0.5 * kRound_s;
constexpr double kFelt_N = 0.05;
constexpr double kGone_N = 1.0e-9;

SimulatedArmSettings spoiled_settings() {
    SimulatedArmSettings settings = make_desktop_arm();
    settings.max_force_N = kHardForceCap_N;
    settings.human = kArm;
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

bool SpoiledArm::Arm::read(double now_s, DeviceReading& reading) noexcept {
    (void)arm.read(now_s, reading);
    reading.pose_D.position += offset_D;
    switch (spoil) {
        case Spoil::no_pose:
            return false;
        case Spoil::no_number:
            reading.pose_D.position.y() = std::numeric_limits<double>::quiet_NaN();
            return true;
        case Spoil::stuck_sensor:
            reading.stamp_s = since_s;
            return true;
        default:
            return true;
    }
}

bool SpoiledArm::Arm::write(double now_s, const Wrench& wrench_D) noexcept {
    return arm.write(now_s, wrench_D) && spoil != Spoil::motor;
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

SpoiledArm::SpoiledArm(std::uint64_t seed, LatestValue<HandTarget>& target)
    : chance_(seed),
      arm_(spoiled_settings(), target),
      line_({.seed = seed}, channel_.end(0)),
      server_({}, arm_, channel_.end(1), seal_, numbers_),
      device_({.max_force_N = kHardForceCap_N, .max_torque_Nm = kHardTorqueCap_Nm}, line_, seal_,
              numbers_) {
    counts_.hash = kFirstHash;
    for (double now_s = 0.0; now_s < 1.0 && !device_.greet(now_s); now_s += kRound_s) {
        server_.step(now_s + kHalfRound_s);
    }
    until_s_ = draw_first(chance_);
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
    serve(now_s);
    const bool read = device_.read(kBefore_s + now_s, reading);
    reading.stamp_s -= kBefore_s;
    return read;
}

bool SpoiledArm::write(double now_s, const Wrench& wrench_D) noexcept {
    return device_.write(kBefore_s + now_s, wrench_D);
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
    if (since_s >= kMostFade_s && counts_.force_N > kGone_N) {
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
    felt_before_ = force_D_.norm() > kFelt_N;
    saw_gone_ = false;
    ++counts_.happened[static_cast<std::size_t>(spoil)];
    arm_.spoil = spoil;
    arm_.since_s = kBefore_s + now_s;
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

// What the hand feels, held against what it may.
void SpoiledArm::watch(double now_s) noexcept {
    const Vector3 force_D = arm_.arm.force_D();
    const Vector3 x_D = arm_.arm.position_D();
    const double size_N = force_D.norm();
    // A change of one round; a loop that was late may have two in it.
    constexpr double kMostStep_N = 2.0e-3 * 500.0;
    const bool breaks =
        !(size_N <= kHardForceCap_N) || !((force_D - force_D_).norm() <= kMostStep_N + 1e-9);
    if (breaks) {
        ++counts_.broken_limits;
        blame(now_s);
    }
    counts_.force_N = size_N;
    counts_.peak_N = std::max(counts_.peak_N, size_N);
    ++counts_.rounds;
    counts_.felt_rounds += size_N > kFelt_N ? 1 : 0;
    if (must_fade(spoil_) && now_s - from_s_ >= kMostFade_s) {
        if (size_N > kGone_N) {
            ++counts_.missed_fades;
            blame(now_s);
        }
        if (felt_before_ && !saw_gone_ && size_N <= kGone_N) {
            saw_gone_ = true;
            ++counts_.fades;
        }
    }
    force_D_ = force_D;
    for (const double value :
         {now_s, x_D.x(), x_D.y(), x_D.z(), force_D.x(), force_D.y(), force_D.z()}) {
        counts_.hash = mix(counts_.hash, std::bit_cast<std::uint64_t>(value));
    }
}

}  // namespace fulcrum
