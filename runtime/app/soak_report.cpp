#include "runtime/app/soak_report.h"

#include "runtime/app/installation.h"
#include "runtime/app/interrupt.h"
#include "runtime/app/tool_lacks.h"

#include <algorithm>
#include <cstdio>

namespace fulcrum::runtime {
namespace {

constexpr double kMostGrowth_MB = 16.0;  // pages that pieces in use are strewn over
constexpr double kRound_s = 0.001;
constexpr double kMostLacking = 0.02;             // of a lesson's rounds
constexpr double kLeastFelt = 0.4;                // of the time in which a lesson can give a force
constexpr double kLeastOfAll = 0.1;               // of all its time
constexpr std::uint64_t kJudgedRounds = 120'000;  // fewer are chance
constexpr double kMostKept_MB = 1.0;  // of what is asked for; a leak in each run passes this

template <class Counts>
void add_up(const Counts& from, Counts& to) {
    for (std::size_t i = 0; i < to.size(); ++i) {
        to[i] += from[i];
    }
}

// "packets lost 3, a long way 2", of those that `is_told`.
template <class Kind, class Counts, class IsTold>
void list(std::string& text, const Counts& counts, const IsTold& is_told) {
    for (std::size_t i = 0; i < counts.size(); ++i) {
        const auto kind = static_cast<Kind>(i);
        if (is_told(kind)) {
            text += (text.ends_with(":") ? " " : ", ") + std::string(name_of(kind)) + " " +
                    std::to_string(counts[i]);
        }
    }
}

}  // namespace

void SoakSum::add(const std::string& lesson, const SoakRun& run) {
    felt[lesson] += run.felt;
    add_up(run.arm.happened, happened);
    add_up(run.arm.faded, faded);
    add_up(run.around, around);
    add_up(run.around_faded, around_faded);
    add_up(run.arm.deeds, deeds);
    n_deadlines += run.n_deadlines;
    felt_rounds += run.arm.felt_rounds;
    turned_rounds += run.arm.turned_rounds;
    simulated_s += run.simulated_s;
    wall_s += run.wall_s;
    processor_s += run.processor_s;
    failed |= !run.trouble.empty();
}

bool SoakSum::lacks(Spoil spoil) const {
    const auto i = static_cast<std::size_t>(spoil);
    return happened[i] == 0 || (must_fade(spoil) && faded[i] == 0);
}

bool SoakSum::lacks(RunSpoil spoil) const {
    const auto i = static_cast<std::size_t>(spoil);
    return around[i] == 0 || (must_fade(spoil) && around_faded[i] == 0);
}

bool SoakSum::has_all() const {
    // The first of each is that there is none.
    for (std::size_t i = 1; i < kSpoils; ++i) {
        if (lacks(static_cast<Spoil>(i))) {
            return false;
        }
    }
    for (std::size_t i = 1; i < kRunSpoils; ++i) {
        if (lacks(static_cast<RunSpoil>(i))) {
            return false;
        }
    }
    return std::ranges::count(deeds, 0U) == 0 && turned_rounds > 0;
}

std::string SoakSum::find_seldom_felt() const {
    for (const auto& [lesson, rounds] : felt) {
        if (rounds.all >= kJudgedRounds &&
            (rounds.share() < kLeastFelt ||
             static_cast<double>(rounds.felt) < kLeastOfAll * static_cast<double>(rounds.all))) {
            return lesson;
        }
    }
    return {};
}

std::string SoakSum::find_lacking() const {
    for (const auto& [lesson, rounds] : felt) {
        for (std::size_t i = 0; i < kToolLacks; ++i) {
            if (rounds.all >= kJudgedRounds && static_cast<double>(rounds.lacking[i]) >
                                                   kMostLacking * static_cast<double>(rounds.all)) {
                return lesson + " steps of the tool " + kToolLackWords[i];
            }
        }
        if (rounds.all >= kJudgedRounds &&
            static_cast<double>(rounds.world.n_unconverged) >
                kMostLacking * static_cast<double>(rounds.world.n_steps)) {
            return lesson + " " + kUnconvergedWords;
        }
    }
    return {};
}

void tell_soak(const std::string& lesson, std::uint64_t seed, double seconds, const SoakRun& run) {
    std::printf(
        "%-13s %-7s seed %-6llu %6.0f s, %4.0f times real time, %4.0f times its processor time, "
        "%4.1f of %.1f N and %.2f of %.2f "
        "Nm at "
        "most, %llu fades seen, %016llx%s\n",
        lesson.c_str(), name_of(run.model), static_cast<unsigned long long>(seed), run.simulated_s,
        run.simulated_s / std::max(run.wall_s, 1e-9),
        run.simulated_s / std::max(run.processor_s, 1e-9), run.arm.peak_N, run.limits.force_N,
        run.arm.peak_Nm, run.limits.torque_Nm, static_cast<unsigned long long>(run.arm.fades),
        static_cast<unsigned long long>(run.arm.hash), run.trouble.empty() ? "" : "  FAILED");
    if (!run.trouble.empty()) {
        std::printf("  %s\n", run.trouble.c_str());
        if (run.since_s >= 0.0) {
            std::printf("  first after %.3f s\n", run.since_s);
        }
        std::printf("  again: ./fulcrum soak --lesson %s --seed %llu --seeds 1 --seconds %g\n",
                    lesson.c_str(), static_cast<unsigned long long>(seed), seconds);
    }
    (void)std::fflush(stdout);
}

std::string describe_soak(const SoakSum& sum, const SoakGrowth& growth) {
    std::array<char, 400> all{};
    std::snprintf(all.data(), all.size(),
                  "In all %.0f s, %.0f times real time, %.0f times its processor time, with a "
                  "force in %.0f s and a torque in %.0f "
                  "s; after the first round the program kept %.2f MB more, and %.1f MB more were "
                  "resident.\n",
                  sum.simulated_s, sum.simulated_s / std::max(sum.wall_s, 1e-9),
                  sum.simulated_s / std::max(sum.processor_s, 1e-9),
                  1e-3 * static_cast<double>(sum.felt_rounds),
                  1e-3 * static_cast<double>(sum.turned_rounds), growth.kept_MB,
                  growth.resident_MB);
    const auto is_any = [](auto kind) { return static_cast<int>(kind) > 0; };
    const auto fades = [](auto kind) { return must_fade(kind); };
    std::string text = all.data();
    text += "Broke:";
    list<Spoil>(text, sum.happened, is_any);
    list<RunSpoil>(text, sum.around, is_any);
    text += ".\nFaded:";
    list<Spoil>(text, sum.faded, fades);
    list<RunSpoil>(text, sum.around_faded, fades);
    text += ".\nThe hand:";
    list<HandDeed>(text, sum.deeds, [](HandDeed) { return true; });
    text += ".\n";
    for (const auto& [lesson, rounds] : sum.felt) {
        const double all_s = kRound_s * static_cast<double>(rounds.all);
        const double possible_s = kRound_s * static_cast<double>(rounds.possible);
        std::snprintf(
            all.data(), all.size(),
            "Felt in %s: a force in %.0f %% of the %.0f s in which it can be, of %.0f s.\n",
            lesson.c_str(), 100.0 * rounds.share(), possible_s, all_s);
        text += all.data();
        for (std::size_t i = 0; i < kToolLacks; ++i) {
            if (rounds.lacking[i] > 0) {
                text += "In " + lesson + " " + std::to_string(rounds.lacking[i]) +
                        " steps of the tool " + kToolLackWords[i] + ".\n";
            }
        }
        if (rounds.world.n_unconverged > 0) {
            text += "In " + lesson + " " + std::to_string(rounds.world.n_unconverged) + " of " +
                    std::to_string(rounds.world.n_steps) + " " + kUnconvergedWords + "\n";
        }
    }
    return text + "Deadlines under the virtual clock: " + std::to_string(sum.n_deadlines) +
           " met.\n";
}

int conclude_soak(const SoakSum& sum, bool all, const SoakGrowth& growth) {
    if (growth.resident_MB > kMostGrowth_MB || growth.kept_MB > kMostKept_MB) {
        return complain({"the program's memory grew by " + std::to_string(growth.kept_MB) +
                             " MB, " + std::to_string(growth.resident_MB) + " MB resident",
                         {},
                         "look for what is never freed"},
                        1);
    }
    if (all && !sum.has_all() && !interrupted()) {
        return complain({"some kind of fault did not occur, or none was seen to fade that must, so "
                         "nothing is known of it",
                         {},
                         "give --seconds 10 or more"},
                        1);
    }
    if (const std::string lesson = sum.find_seldom_felt(); all && !lesson.empty()) {
        return complain({"in " + lesson +
                             " a force was felt in less than two fifths of the time in which "
                             "it can be, or a tenth of all, so little is known of its forces",
                         {},
                         "let its simulated hand touch, lift and stroke more, and go back to where "
                         "things are"},
                        1);
    }
    if (const std::string lacking = sum.find_lacking(); !lacking.empty()) {
        return complain({"more than a fiftieth of the steps were short of something: in " + lacking,
                         {},
                         "look for what the tool or the bodies are caught in there"},
                        1);
    }
    return sum.failed
               ? complain({"something went wrong that may not; the lines that say FAILED tell "
                           "what, when, and the command that repeats it",
                           {},
                           "send them, with the program's version, to who mends it"},
                          1)
               : interrupt_exit_code();
}

}  // namespace fulcrum::runtime
