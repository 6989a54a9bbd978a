// What fulcrum soak has seen, of one run and of all, and how it is told.
#pragma once

#include "haptics/link/spoiled_arm.h"
#include "runtime/app/deadline_watch.h"
#include "runtime/app/felt_watch.h"
#include "runtime/app/run_spoiler.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <string>

namespace fulcrum::runtime {

/// What one run of a lesson showed.
struct SoakRun {
    SpoiledModel model = SpoiledModel::desktop;
    SpoiledCounts arm{};
    FeltLimits limits{};
    std::array<std::uint64_t, kRunSpoils> around{};  ///< what broke around it, by RunSpoil
    std::array<std::uint64_t, kRunSpoils> around_faded{};
    std::uint64_t n_deadlines = 0;  ///< met
    FeltRounds felt{};
    double simulated_s = 0.0;
    double wall_s = 0.0;
    double processor_s = 0.0;  ///< of the program and the lesson's process, from loading to the end
    std::string trouble;       ///< what went wrong, a few words; empty where all was as it must be
    double since_s = -1.0;
};

/// What all runs together showed.
class SoakSum {
  public:
    void add(const std::string& lesson, const SoakRun& run);

    /// Whether it has not happened yet, or no force that must fade while it lasts has been seen to.
    [[nodiscard]] bool lacks(Spoil spoil) const;
    [[nodiscard]] bool lacks(RunSpoil spoil) const;
    /// Whether every kind of fault has happened, and each that must has taken a force away, the hand has done all that it does, and felt a torque.
    [[nodiscard]] bool has_all() const;
    /// The lesson that was played long enough to be judged and gave a force in less than two fifths of the time in which it can, or
    /// a tenth of all; empty for none.
    [[nodiscard]] std::string find_seldom_felt() const;
    /// The lesson in which more than a fiftieth of the tool's steps were short of the same, and of what; empty for none.
    [[nodiscard]] std::string find_lacking() const;

    std::array<std::uint64_t, kSpoils> happened{};
    std::array<std::uint64_t, kSpoils> faded{};
    std::array<std::uint64_t, kRunSpoils> around{};
    std::array<std::uint64_t, kRunSpoils> around_faded{};
    std::array<std::uint64_t, kHandDeeds> deeds{};
    std::map<std::string, FeltRounds> felt{};  ///< by lesson
    std::uint64_t n_deadlines = 0;
    std::uint64_t felt_rounds = 0;
    std::uint64_t turned_rounds = 0;
    double simulated_s = 0.0;
    double wall_s = 0.0;
    double processor_s = 0.0;
    bool failed = false;
};

/// How much memory the program kept since the first round of runs, megabytes: of what it asked for, and resident.
struct SoakGrowth {
    double kept_MB = 0.0;
    double resident_MB = 0.0;
};

/// A line on how a run went, and where it went wrong what somebody needs to see it go wrong again.
void tell_soak(const std::string& lesson, std::uint64_t seed, double seconds, const SoakRun& run);
/// All of them, several lines.
[[nodiscard]] std::string describe_soak(const SoakSum& sum, const SoakGrowth& growth);
/// The exit code, and a sentence where it is not 0. `all`: it is a soak, and not one run that is looked at again.
[[nodiscard]] int conclude_soak(const SoakSum& sum, bool all, const SoakGrowth& growth);

}  // namespace fulcrum::runtime
