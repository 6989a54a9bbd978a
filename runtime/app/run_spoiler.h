// Breaks, by chance and from one seed, what stands around a run under a virtual clock: its world, its lesson, its clock, its disk; the arm
// and the line to it have theirs (haptics/link/spoiled_arm.h).
//
//   world stands still     no round of it; where the plan has one the force must be gone in kMostQuiet_s
//   world is starved       a round every 50 ms alone
//   lesson hangs           no frame of it; the force must be gone in kMostQuiet_s
//   lesson is slow         a frame every 30 to 400 ms alone
//   clock jumps            by 5 ms to 3 s, as after a program that was stopped; the arm has gone on
//   lesson is killed       its process, in the second half of some runs; the force fades and the run ends with a sentence
//   disk is full           after the first seconds of the record, in some runs; it is told at the end, and nothing else may come of it
// Rounds are counted in which a force is left where none may be, and by kind how often one that was felt had gone in time.
//
// Thread: the virtual clock's. Cost: some nanoseconds a tick.
#pragma once

#include "haptics/link/spoiled_arm.h"
#include "haptics/math/split_mix.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <iterator>

namespace fulcrum::runtime {

/// What breaks around a run.
enum class RunSpoil : std::uint8_t {
    nothing,
    world_stands,
    world_starved,
    lesson_hangs,
    lesson_slow,
    clock_jumps,
    lesson_killed,
    disk_full
};
/// Whether the force must go while it lasts; of a world that stands where the run has one.
[[nodiscard]] constexpr bool must_fade(RunSpoil spoil) noexcept {
    return spoil == RunSpoil::world_stands || spoil == RunSpoil::lesson_hangs ||
           spoil == RunSpoil::lesson_killed;
}
inline constexpr std::size_t kRunSpoils = static_cast<std::size_t>(RunSpoil::disk_full) + 1;
[[nodiscard]] constexpr const char* name_of(RunSpoil spoil) noexcept {
    constexpr const char* kNames[] = {"nothing",       "world stands", "world starved",
                                      "lesson hangs",  "lesson slow",  "clock jumps",
                                      "lesson killed", "disk full"};
    static_assert(std::size(kNames) == kRunSpoils);
    return kNames[static_cast<std::size_t>(spoil)];
}

class RunSpoiler {
  public:
    static constexpr double kMostQuiet_s =
        0.35;  ///< 100 ms to notice, 100 ms to fade, up to 74 ms on the line, 50 ms of the arm's brake, a frame

    /// `seconds` is how long the run is; `has_world`: it has a world whose silence must be noticed.
    RunSpoiler(std::uint64_t seed, double seconds) noexcept;
    /// Known when the run is built.
    void begin(bool has_world) noexcept { has_world_ = has_world; }

    /// What breaks first, and when; before the first tick.
    [[nodiscard]] RunSpoil first() const noexcept;
    [[nodiscard]] double first_at_s() const noexcept { return until_s_; }
    /// Beyond every run's end where the lesson is left alone.
    [[nodiscard]] double kills_at_s() const noexcept { return kill_at_s_; }

    /// A tick begins; the force on the hand as of the last one. How much the clock jumps now, seconds, mostly 0.
    [[nodiscard]] double step(double now_s, double force_N) noexcept;
    /// Whether world and kite have their round in this tick, if one is due.
    [[nodiscard]] bool world_runs(double now_s) noexcept;
    /// Whether the lesson has its frame, if one is due.
    [[nodiscard]] bool lesson_runs(double now_s) noexcept;
    /// True once, when the lesson's process is to be killed.
    [[nodiscard]] bool kills_lesson(double now_s) noexcept;
    [[nodiscard]] bool fills_disk() const noexcept { return fills_disk_; }
    [[nodiscard]] bool has_killed() const noexcept { return has_killed_; }
    /// The run is over, with this force on the hand: a lesson that was killed is not there to tell.
    void end(double force_N) noexcept;
    /// Nothing is broken now that must take a force away, and the lesson lives.
    [[nodiscard]] bool may_feel() const noexcept { return !is_silent() && !has_killed_; }
    /// For so long nothing has been broken; 0 while something is, and when the lesson was killed.
    [[nodiscard]] double quiet_s(double now_s) const noexcept;

    [[nodiscard]] const std::array<std::uint64_t, kRunSpoils>& happened() const noexcept {
        return happened_;
    }
    [[nodiscard]] const std::array<std::uint64_t, kRunSpoils>& faded() const noexcept {
        return faded_;
    }
    [[nodiscard]] std::uint64_t missed_fades() const noexcept { return missed_fades_; }
    [[nodiscard]] double bad_since_s() const noexcept { return bad_since_s_; }
    [[nodiscard]] double bad_N() const noexcept { return bad_N_; }
    [[nodiscard]] RunSpoil bad_in() const noexcept { return bad_in_; }

  private:
    [[nodiscard]] double draw(double low, double high) noexcept {
        return low + (high - low) * chance_.draw_chance();
    }
    void choose(double now_s) noexcept;
    void watch_fade(double now_s) noexcept;
    // Whether something is broken that must take the force away.
    [[nodiscard]] bool is_silent() const noexcept {
        return must_fade(spoil_) && (spoil_ != RunSpoil::world_stands || has_world_);
    }

    SplitMix chance_;
    bool has_world_ = false;
    RunSpoil spoil_ = RunSpoil::nothing;
    double from_s_ = 0.0;
    double until_s_;
    double every_s_ = 0.0;  // of what is slow
    double ran_s_ = 0.0;    // when that ran last
    double jump_s_ = 0.0;
    double kill_at_s_;  // beyond the run's end: never
    bool has_killed_ = false;
    bool fills_disk_;
    double force_N_ = 0.0;
    bool felt_before_ = false;  // a force was there when it broke
    bool felt_killed_ = false;
    bool saw_gone_ = false;
    std::uint64_t missed_fades_ = 0;
    double bad_since_s_ = -1.0;
    double bad_N_ = 0.0;
    RunSpoil bad_in_ = RunSpoil::nothing;
    std::array<std::uint64_t, kRunSpoils> happened_{};
    std::array<std::uint64_t, kRunSpoils> faded_{};
};

}  // namespace fulcrum::runtime
