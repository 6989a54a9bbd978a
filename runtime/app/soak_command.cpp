// fulcrum soak: every lesson with an arm on which things break by chance, and world, lesson, clock and disk as well, under a virtual clock: no
// force too large, no fade missed, no memory that grows, and the same seed gives the same run. A run that failed is told with the command
// that repeats it.
#include "haptics/base/clock.h"
#include "haptics/link/spoiled_arm.h"
#include "haptics/record/record.h"
#include "runtime/app/commands.h"
#include "runtime/app/headless.h"
#include "runtime/app/interrupt.h"
#include "runtime/app/run_request.h"
#include "runtime/app/run_spoiler.h"
#include "runtime/progress/store.h"

#include <algorithm>
#include <array>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <functional>
#include <malloc.h>
#include <string>
#include <sys/resource.h>
#include <unistd.h>
#include <vector>

namespace fulcrum::runtime {
namespace {

constexpr double kSoakErrors = 0.3;  // of a learner's answers
constexpr double kLiftAfter_s = 3.0;
constexpr rlim_t kDiskHolds = 1'000'000;  // bytes of a record: full after some four seconds
constexpr double kRounds_Hz = 1000.0;
constexpr double kMostGrowth_MB = 64.0;         // allocators keep what was freed
constexpr std::uint64_t kMostMoreSeeds = 1000;  // looked through for what has not occurred
constexpr double kMostKept_MB = 1.0;  // of what is asked for; a leak in each run passes this

double resident_MB() {
    std::ifstream file("/proc/self/statm");
    double pages = 0.0;
    double resident = 0.0;
    file >> pages >> resident;
    return resident * static_cast<double>(::sysconf(_SC_PAGESIZE)) * 1.0e-6;
}

// What is asked for and not given back; beside it the resident memory also has what the allocator keeps in pieces.
double in_use_MB() {
    const struct mallinfo2 heap = ::mallinfo2();
    return 1.0e-6 * static_cast<double>(heap.uordblks + heap.hblkhd);
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

// A disk that is full after some seconds: a file of the system's own, and a limit on how long this program may make one. Nothing else is
// written meanwhile.
class FullDisk {
  public:
    [[nodiscard]] bool open() {
        name_ = std::filesystem::temp_directory_path() / "fulcrum-soak-XXXXXX";
        const int descriptor = ::mkstemp(name_.data());
        if (descriptor < 0) {
            name_.clear();
            return false;
        }
        ::close(descriptor);
        return true;
    }
    [[nodiscard]] const std::string& file() const { return name_; }
    // From here on, until the disk is gone.
    void fill() {
        (void)std::signal(SIGXFSZ,
                          SIG_IGN);  // a write that is too long is an error, EFBIG, and no signal
        if (!name_.empty() && ::getrlimit(RLIMIT_FSIZE, &before_) == 0) {
            const rlimit full{std::min(kDiskHolds, before_.rlim_max), before_.rlim_max};
            is_full_ = ::setrlimit(RLIMIT_FSIZE, &full) == 0;
        }
    }
    FullDisk() = default;
    FullDisk(const FullDisk&) = delete;
    FullDisk& operator=(const FullDisk&) = delete;
    ~FullDisk() {
        if (is_full_) {
            (void)::setrlimit(RLIMIT_FSIZE, &before_);
        }
        if (!name_.empty()) {
            ::unlink(name_.c_str());
        }
    }

  private:
    std::string name_;
    rlimit before_{};
    bool is_full_ = false;
};

struct SoakSum {
    // Each kind of fault, how often; the first is that there is none.
    std::array<std::uint64_t, kSpoils> happened{};
    std::array<std::uint64_t, kRunSpoils> around{};
    [[nodiscard]] bool has_all() const {
        return std::count(happened.begin() + 1, happened.end(), 0U) == 0 &&
               std::count(around.begin() + 1, around.end(), 0U) == 0;
    }
    std::uint64_t fades = 0;
    double simulated_s = 0.0;
    double wall_s = 0.0;
    bool failed = false;
};

// What one run of a lesson showed.
struct SoakRun {
    SpoiledCounts arm{};
    double simulated_s = 0.0;
    double wall_s = 0.0;
    std::string trouble;  ///< what went wrong, a few words; empty where all was as it must be
    double since_s = -1.0;
};

constexpr double kNoForce_N = 1.0e-9;

bool was_filled(const SpoiledCounts& arm) {
    return arm.rounds * kRecordSampleBytes > kDiskHolds;
}

// Of a lesson that was killed the run must end, and the force with it; of another it may not. A full disk is told, and nothing else.
std::string find_trouble(const RunSpoiler& spoiler, const SpoiledCounts& arm,
                         const Expected<HeadlessOutcome>& outcome, const Expected<void>& recorded) {
    if (!outcome && !spoiler.has_killed()) {
        return to_sentence(outcome.error());
    }
    if (outcome && spoiler.has_killed()) {
        return "the lesson's process was killed and nobody noticed";
    }
    if (arm.force_N > kNoForce_N && !outcome) {
        return "a force is left after a lesson that was killed";
    }
    if (recorded && spoiler.fills_disk() && was_filled(arm)) {
        return "the record's disk was full and nobody said so";
    }
    if (!recorded && !spoiler.fills_disk()) {
        return to_sentence(recorded.error());
    }
    if (arm.broken_limits > 0) {
        return std::string("a force above its limit or a change above the slew, during: ") +
               name_of(arm.bad_in);
    }
    if (arm.missed_fades > 0) {
        return std::string("a force that had to be gone, during: ") + name_of(arm.bad_in);
    }
    return spoiler.missed_fades() > 0
               ? std::to_string(spoiler.bad_N()) +
                     " N that had to be gone, during: " + name_of(spoiler.bad_in())
               : std::string();
}

std::uint64_t spoil_seed_of(const std::string& lesson, std::uint64_t seed) {
    return seed ^ std::hash<std::string>{}(lesson);
}

// Whether a run breaks something, for sure, that was not broken yet: what comes first, and what comes once.
bool brings_more(const std::string& lesson, std::uint64_t seed, double seconds,
                 const SoakSum& sum) {
    constexpr double kShown_s = 0.5;  // before its end
    constexpr double kFilled_s =
        static_cast<double>(kDiskHolds) / (kRounds_Hz * static_cast<double>(kRecordSampleBytes));
    const std::uint64_t spoil_seed = spoil_seed_of(lesson, seed);
    const FirstSpoil arm = SpoiledArm::first_of(spoil_seed);
    const RunSpoiler around(~spoil_seed, seconds);
    const auto is_new = [&](RunSpoil kind, double at_s) {
        return sum.around[static_cast<std::size_t>(kind)] == 0 && at_s + kShown_s < seconds;
    };
    return (sum.happened[static_cast<std::size_t>(arm.kind)] == 0 &&
            arm.at_s + kShown_s < seconds) ||
           is_new(around.first(), around.first_at_s()) ||
           is_new(RunSpoil::lesson_killed, around.kills_at_s()) ||
           (around.fills_disk() && is_new(RunSpoil::disk_full, kFilled_s));
}

RunRequest make_soak_request(const std::filesystem::path& folder, const std::string& lesson,
                             std::uint64_t seed, const SiteLimits& site) {
    RunRequest request;
    request.folder = folder;
    request.plan.site = site;
    request.plan.picture = false;
    request.plan.sound = false;
    request.own_test = true;
    request.seed = seed;
    // Other things break in each lesson.
    request.spoil_seed = spoil_seed_of(lesson, seed);
    request.learner_rates = rates_of(kSoakErrors);
    return request;
}

Expected<SoakRun> soak_once(const Installation& installation, const std::string& lesson,
                            std::uint64_t seed, double seconds, const SiteLimits& site,
                            SoakSum& sum) {
    const auto folder = find_lesson(installation.places, lesson);
    if (!folder) {
        return tl::unexpected(folder.error());
    }
    RunRequest request = make_soak_request(*folder, lesson, seed, site);
    RunSpoiler spoiler(~*request.spoil_seed, seconds);
    FullDisk disk;
    if (spoiler.fills_disk()) {
        if (!disk.open()) {
            return fail("no file can be made in the folder for temporary ones", {},
                        "make room there");
        }
        request.plan.record = true;
        request.record_file = disk.file();
    }
    const auto store = make_null_store();
    auto run = LessonRun::create(installation.places, request, *store, installation.catalogue);
    if (!run) {
        return tl::unexpected(run.error());
    }
    spoiler.begin((*run)->plan().haptic.expects_world);
    StopLifter lifter(**run);
    HeadlessSettings settings;
    settings.end_s = seconds;
    settings.afterglow_s = seconds;
    settings.nobody_answers_s = 2.0 * seconds;
    settings.shows_prints = false;
    settings.spoiler = &spoiler;
    settings.after_frame = [&](double now_s) { lifter.step(now_s); };
    if (spoiler.fills_disk()) {
        disk.fill();
    }
    const double began_s = monotonic_now_s();
    const auto outcome = run_headless(**run, settings);
    const auto recorded = (*run)->finish_record();
    SoakRun result{*(*run)->spoiled_counts(), 0.0, monotonic_now_s() - began_s, {}, -1.0};
    result.simulated_s = static_cast<double>(result.arm.rounds) / kRounds_Hz;
    result.trouble = find_trouble(spoiler, result.arm, outcome, recorded);
    result.since_s = result.arm.bad_since_s >= 0.0 ? result.arm.bad_since_s : spoiler.bad_since_s();
    for (std::size_t i = 0; i < kSpoils; ++i) {
        sum.happened[i] += result.arm.happened[i];
    }
    for (std::size_t i = 0; i < kRunSpoils; ++i) {
        sum.around[i] += spoiler.happened()[i];
    }
    if (spoiler.fills_disk() && !was_filled(result.arm)) {
        --sum.around[static_cast<std::size_t>(RunSpoil::disk_full)];  // it was over too soon
    }
    return result;
}

// A line on how it went, and where it went wrong what somebody needs to see it go wrong again.
void tell(const std::string& lesson, std::uint64_t seed, double seconds, const SoakRun& run) {
    std::printf(
        "%-13s seed %-6llu %6.0f s, %4.0f times real time, %4.1f N at most, %llu fades seen, "
        "%016llx%s\n",
        lesson.c_str(), static_cast<unsigned long long>(seed), run.simulated_s,
        run.simulated_s / std::max(run.wall_s, 1e-9), run.arm.peak_N,
        static_cast<unsigned long long>(run.arm.fades),
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

// `all`: it is a soak, and not one run that is looked at again.
int conclude(const SoakSum& sum, bool all, double grown_MB, double kept_MB) {
    std::printf(
        "In all %.0f s, %.0f times real time, %llu fades; after the first round the program "
        "kept %.2f MB more, and %.1f MB more were resident.\nBroke:",
        sum.simulated_s, sum.simulated_s / std::max(sum.wall_s, 1e-9),
        static_cast<unsigned long long>(sum.fades), kept_MB, grown_MB);
    for (std::size_t i = 1; i < kSpoils; ++i) {
        std::printf("%s %s %llu", i == 1 ? "" : ",", name_of(static_cast<Spoil>(i)),
                    static_cast<unsigned long long>(sum.happened[i]));
    }
    for (std::size_t i = 1; i < kRunSpoils; ++i) {
        std::printf(", %s %llu", name_of(static_cast<RunSpoil>(i)),
                    static_cast<unsigned long long>(sum.around[i]));
    }
    std::printf(".\n");
    if (grown_MB > kMostGrowth_MB || kept_MB > kMostKept_MB) {
        return complain({"the program's memory grew by " + std::to_string(kept_MB) + " MB, " +
                             std::to_string(grown_MB) + " MB resident",
                         {},
                         "look for what is never freed"},
                        1);
    }
    if (all && !sum.has_all() && !interrupted()) {
        return complain({"some kind of fault did not occur, so nothing is known of it",
                         {},
                         "give --seconds 10 or more"},
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

}  // namespace

int soak_command(const Installation& installation, const Options& options) {
    std::vector<std::string> lessons;
    if (options.lesson.empty()) {
        lessons = list_lesson_names(installation.places);
    } else {
        lessons.push_back(options.lesson);
    }
    const std::uint64_t first = options.seed.value_or(1);
    const double seconds = options.seconds.value_or(60.0);
    SoakSum sum;
    const auto play = [&](const std::string& lesson, std::uint64_t seed) -> Expected<void> {
        return soak_once(installation, lesson, seed, seconds, options.site, sum)
            .map([&](const SoakRun& run) {
                tell(lesson, seed, seconds, run);
                sum.fades += run.arm.fades;
                sum.simulated_s += run.simulated_s;
                sum.wall_s += run.wall_s;
                sum.failed |= !run.trouble.empty();
            });
    };
    double settled_MB = 0.0;
    double settled_in_use_MB = 0.0;
    const std::uint64_t end = first + options.seeds;
    const bool is_soak = lessons.size() * options.seeds > 1;
    const std::uint64_t last = is_soak ? end + kMostMoreSeeds : end;
    // Behind the seeds that were asked for: those that bring what has not occurred yet.
    for (std::uint64_t seed = first; seed < last && (seed < end || !sum.has_all()); ++seed) {
        for (const std::string& lesson : lessons) {
            if (interrupted() || (seed >= end && !brings_more(lesson, seed, seconds, sum))) {
                continue;
            }
            if (const auto played = play(lesson, seed); !played) {
                return complain(played.error(), 2);
            }
        }
        if (seed == first) {
            settled_MB = resident_MB();
            settled_in_use_MB = in_use_MB();
        }
    }
    return conclude(sum, is_soak, std::max(resident_MB() - settled_MB, 0.0),
                    std::max(in_use_MB() - settled_in_use_MB, 0.0));
}

}  // namespace fulcrum::runtime
