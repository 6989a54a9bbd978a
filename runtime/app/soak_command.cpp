// fulcrum soak: every lesson with an arm on which things break by chance, under a virtual clock: no force too large, no fade missed, no
// memory that grows, and the same seed gives the same run.
#include "haptics/base/clock.h"
#include "haptics/link/spoiled_arm.h"
#include "runtime/app/commands.h"
#include "runtime/app/headless.h"
#include "runtime/app/interrupt.h"
#include "runtime/app/run_request.h"
#include "runtime/progress/store.h"

#include <algorithm>
#include <array>
#include <cstdio>
#include <fstream>
#include <functional>
#include <string>
#include <unistd.h>
#include <vector>

namespace fulcrum::runtime {
namespace {

constexpr double kSoakErrors = 0.3;  // of a learner's answers
constexpr double kLiftAfter_s = 3.0;
constexpr double kMostGrowth_MB =
    64.0;  // allocators keep what was freed; a leak in each round passes this

double resident_MB() {
    std::ifstream file("/proc/self/statm");
    double pages = 0.0;
    double resident = 0.0;
    file >> pages >> resident;
    return resident * static_cast<double>(::sysconf(_SC_PAGESIZE)) * 1.0e-6;
}

// Somebody who lifts a stop, a while after it was pressed.
class StopLifter {
  public:
    explicit StopLifter(LessonRun& run) : run_(run) {}
    void step(double now_s) {
        const bool is_stopped = run_.haptic_loop().state().gate == GatePhase::stopped;
        since_s_ = !is_stopped ? -1.0 : since_s_ < 0.0 ? now_s : since_s_;
        if (is_stopped && now_s - since_s_ > kLiftAfter_s) {
            run_.channels().rearm.store(true, std::memory_order_release);
            since_s_ = -1.0;
        }
    }

  private:
    LessonRun& run_;
    double since_s_ = -1.0;
};

struct SoakSum {
    std::array<std::uint64_t, kSpoils> happened{};
    std::uint64_t fades = 0;
    double simulated_s = 0.0;
    double wall_s = 0.0;
    bool failed = false;
};

// One lesson once; tells how it went in a line.
int soak_once(const Installation& installation, const std::string& lesson, std::uint64_t seed,
              double seconds, const SiteLimits& site, SoakSum& sum) {
    const auto folder = find_lesson(installation.places, lesson);
    if (!folder) {
        return complain(folder.error(), 2);
    }
    RunRequest request;
    request.folder = *folder;
    request.plan.site = site;
    request.plan.picture = false;
    request.plan.sound = false;
    request.own_test = true;
    request.seed = seed;
    // Other things break in each lesson.
    request.spoil_seed = seed ^ std::hash<std::string>{}(lesson);
    request.learner_rates = rates_of(kSoakErrors);
    const auto store = make_null_store();
    auto run = LessonRun::create(installation.places, request, *store, installation.catalogue);
    if (!run) {
        return complain(run.error(), 1);
    }
    StopLifter lifter(**run);
    HeadlessSettings settings;
    settings.end_s = seconds;
    settings.afterglow_s = seconds;
    settings.nobody_answers_s = 2.0 * seconds;
    settings.shows_prints = false;
    settings.after_frame = [&](double now_s) { lifter.step(now_s); };
    const auto outcome = run_headless(**run, settings);
    if (!outcome) {
        std::fprintf(stderr, "seed %llu: ", static_cast<unsigned long long>(seed));
        return complain(outcome.error(), 1);
    }
    const SpoiledCounts& counts = *(*run)->spoiled_counts();
    for (std::size_t i = 0; i < kSpoils; ++i) {
        sum.happened[i] += counts.happened[i];
    }
    sum.fades += counts.fades;
    sum.simulated_s += outcome->simulated_s;
    sum.wall_s += outcome->wall_s;
    const bool is_bad = counts.missed_fades > 0 || counts.broken_limits > 0;
    sum.failed |= is_bad;
    std::printf(
        "%-13s seed %-6llu %6.0f s, %4.0f times real time, %4.1f N at most, %llu fades seen, %llu "
        "missed, %llu over a limit, %016llx%s\n",
        lesson.c_str(), static_cast<unsigned long long>(seed), outcome->simulated_s,
        outcome->simulated_s / std::max(outcome->wall_s, 1e-9), counts.peak_N,
        static_cast<unsigned long long>(counts.fades),
        static_cast<unsigned long long>(counts.missed_fades),
        static_cast<unsigned long long>(counts.broken_limits),
        static_cast<unsigned long long>(counts.hash), is_bad ? "  FAILED" : "");
    (void)std::fflush(stdout);
    return 0;
}

int conclude(const SoakSum& sum, double grown_MB) {
    std::printf(
        "In all %.0f s, %.0f times real time, %llu fades; the program grew by %.1f MB after its "
        "first round.\nBroke:",
        sum.simulated_s, sum.simulated_s / std::max(sum.wall_s, 1e-9),
        static_cast<unsigned long long>(sum.fades), grown_MB);
    for (std::size_t i = 1; i < kSpoils; ++i) {
        std::printf("%s %s %llu", i == 1 ? "" : ",", name_of(static_cast<Spoil>(i)),
                    static_cast<unsigned long long>(sum.happened[i]));
    }
    std::printf(".\n");
    if (grown_MB > kMostGrowth_MB) {
        return complain({"the program's memory grew by " + std::to_string(grown_MB) + " MB",
                         {},
                         "look for what is never freed"},
                        1);
    }
    return sum.failed ? complain({"a force was felt that may not be; the line that says FAILED "
                                  "names lesson and seed",
                                  {},
                                  "run it again with --seed and --lesson"},
                                 1)
                      : 0;
}

}  // namespace

int soak_command(const Installation& installation, const Options& options) {
    std::vector<std::string> lessons;
    if (options.lesson.empty()) {
        lessons = list_lesson_names(installation.places);
    } else {
        lessons.push_back(options.lesson);
    }
    const std::uint64_t first = options.seed.value_or(1);
    SoakSum sum;
    double settled_MB = 0.0;
    for (std::uint64_t seed = first; seed < first + options.seeds && !interrupted(); ++seed) {
        for (const std::string& lesson : lessons) {
            if (const int code = soak_once(installation, lesson, seed,
                                           options.seconds.value_or(60.0), options.site, sum);
                code != 0) {
                return code;
            }
        }
        settled_MB = seed == first ? resident_MB() : settled_MB;
    }
    return conclude(sum, std::max(resident_MB() - settled_MB, 0.0));
}

}  // namespace fulcrum::runtime
