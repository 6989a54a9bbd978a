#include "runtime/app/run_spoiler.h"

#include "haptics/math/felt.h"

#include <limits>
#include <utility>

namespace fulcrum::runtime {
namespace {

constexpr double kLongestGap_s = 6.0;
constexpr double kStarved_s = 0.05;
constexpr double kGone_N = 1.0e-9;
constexpr double kThird = 1.0 / 3.0;  // of all runs have a killed lesson, and as many a full disk
constexpr int kLasting = 5;           // kinds that begin and end, from world_stands on

}  // namespace

RunSpoiler::RunSpoiler(std::uint64_t seed, double seconds) noexcept : chance_(seed) {
    until_s_ = draw(1.0, kLongestGap_s);
    kill_at_s_ = chance_.draw_chance() < kThird ? draw(0.5, 1.0) * seconds
                                                : std::numeric_limits<double>::infinity();
    fills_disk_ = chance_.draw_chance() < kThird;
    happened_[static_cast<std::size_t>(RunSpoil::disk_full)] = fills_disk_ ? 1 : 0;
}

RunSpoil RunSpoiler::first() const noexcept {
    RunSpoiler ahead = *this;
    ahead.choose(until_s_);
    return ahead.spoil_;
}

double RunSpoiler::step(double now_s, double force_N) noexcept {
    force_N_ = force_N;
    watch_fade(now_s);
    if (now_s >= until_s_) {
        choose(now_s);
    }
    return std::exchange(jump_s_, 0.0);
}

void RunSpoiler::watch_fade(double now_s) noexcept {
    if (!is_silent() || now_s - from_s_ < kMostQuiet_s) {
        return;
    }
    if (force_N_ > kGone_N) {
        ++missed_fades_;
        if (bad_since_s_ < 0.0) {
            bad_since_s_ = now_s;
            bad_in_ = spoil_;
            bad_N_ = force_N_;
        }
    } else if (felt_before_ && !saw_gone_) {
        saw_gone_ = true;
        ++faded_[static_cast<std::size_t>(spoil_)];
    }
}

double RunSpoiler::quiet_s(double now_s) const noexcept {
    return spoil_ == RunSpoil::nothing && !has_killed_ ? now_s - from_s_ : 0.0;
}

void RunSpoiler::end(double force_N) noexcept {
    if (has_killed_ && felt_killed_ && force_N <= kGone_N) {
        ++faded_[static_cast<std::size_t>(RunSpoil::lesson_killed)];
    }
}

void RunSpoiler::choose(double now_s) noexcept {
    from_s_ = now_s;
    felt_before_ = force_N_ > kLeastFelt_N;
    saw_gone_ = false;
    if (spoil_ != RunSpoil::nothing) {
        spoil_ = RunSpoil::nothing;
        until_s_ = now_s + draw(0.5, kLongestGap_s);
        return;
    }
    spoil_ = static_cast<RunSpoil>(1 + static_cast<int>(draw(0.0, 1.0) * kLasting));
    ++happened_[static_cast<std::size_t>(spoil_)];
    until_s_ = now_s + draw(0.3, 2.0);
    every_s_ = spoil_ == RunSpoil::world_starved ? kStarved_s : draw(0.03, 0.4);
    if (spoil_ == RunSpoil::clock_jumps) {
        jump_s_ = draw(0.0, 1.0) < 0.5 ? draw(0.005, 0.1) : draw(0.1, 3.0);
        until_s_ = now_s;  // it is over at once
    }
}

bool RunSpoiler::world_runs(double now_s) noexcept {
    if (spoil_ == RunSpoil::world_starved) {
        if (now_s - ran_s_ < every_s_) {
            return false;
        }
        ran_s_ = now_s;
    }
    return spoil_ != RunSpoil::world_stands;
}

bool RunSpoiler::lesson_runs(double now_s) noexcept {
    if (spoil_ == RunSpoil::lesson_slow) {
        if (now_s - ran_s_ < every_s_) {
            return false;
        }
        ran_s_ = now_s;
    }
    return spoil_ != RunSpoil::lesson_hangs;
}

bool RunSpoiler::kills_lesson(double now_s) noexcept {
    if (has_killed_ || now_s < kill_at_s_) {
        return false;
    }
    has_killed_ = true;
    felt_killed_ = force_N_ > kLeastFelt_N;
    ++happened_[static_cast<std::size_t>(RunSpoil::lesson_killed)];
    return true;
}

}  // namespace fulcrum::runtime
