// fulcrum soak: every lesson with a hand that does what it likes, an arm on which things break by chance, and world, lesson, clock and disk as
// well, under a virtual clock: no force or torque beyond the run's own limits, no fade and no deadline missed, no memory that grows, and the
// same seed gives the same run. A run that failed is told with the command that repeats it. Last, how late the loops are in real time.
#include "haptics/base/clock.h"
#include "haptics/base/sanitized.h"
#include "haptics/link/spoiled_arm.h"
#include "haptics/record/record.h"
#include "runtime/app/commands.h"
#include "runtime/app/headless.h"
#include "runtime/app/interrupt.h"
#include "runtime/app/run_request.h"
#include "runtime/app/run_spoiler.h"
#include "runtime/app/soak_report.h"
#include "runtime/lesson/free_english.h"
#include "runtime/progress/store.h"

#include <algorithm>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <functional>
#include <malloc.h>
#if defined(FULCRUM_SANITIZED)
#include <sanitizer/allocator_interface.h>
#endif
#include <string>
#include <sys/resource.h>
#include <unistd.h>
#include <vector>

namespace fulcrum::runtime {
namespace {

constexpr double kSoakErrors = 0.3;  // of a learner's answers
constexpr double kLiftAfter_s = 1.0;
constexpr double kAgainAfter_s = 1.0;
constexpr double kSoakThinking_s = 0.2;
constexpr rlim_t kDiskHolds = 1'000'000;  // bytes of a record: full after some four seconds
constexpr double kRounds_Hz = 1000.0;
constexpr double kRealTime_s = 2.0;             // of each lesson
constexpr std::uint64_t kMostMoreSeeds = 1000;  // looked through for what has not occurred

// Without the pages of what was freed, which allocators keep.
double resident_MB() {
    (void)::malloc_trim(0);
    std::ifstream file("/proc/self/statm");
    double pages = 0.0;
    double resident = 0.0;
    file >> pages >> resident;
    return resident * static_cast<double>(::sysconf(_SC_PAGESIZE)) * 1.0e-6;
}

// What is asked for and not given back.
double in_use_MB() {
#if defined(FULCRUM_SANITIZED)
    return 1.0e-6 * static_cast<double>(::__sanitizer_get_current_allocated_bytes());
#else
    const struct mallinfo2 heap = ::mallinfo2();
    return 1.0e-6 * static_cast<double>(heap.uordblks + heap.hblkhd);
#endif
}

// Of this program and of those that it started and that have ended.
double processor_s() {
    double sum_s = 0.0;
    for (const int who : {RUSAGE_SELF, RUSAGE_CHILDREN}) {
        rusage used{};
        (void)::getrusage(who, &used);
        for (const timeval& part : {used.ru_utime, used.ru_stime}) {
            sum_s += static_cast<double>(part.tv_sec) + 1.0e-6 * static_cast<double>(part.tv_usec);
        }
    }
    return sum_s;
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

constexpr double kNoForce_N = 1.0e-9;

bool was_filled(const SpoiledCounts& arm) {
    return arm.rounds * kRecordSampleBytes > kDiskHolds;
}

// Of a lesson that was killed the run must end, and the force with it; of another it may not. A full disk is told, and nothing else.
std::string find_end_trouble(const RunSpoiler& spoiler, const SpoiledCounts& arm,
                             const Expected<HeadlessOutcome>& outcome,
                             const Expected<void>& recorded) {
    if (!outcome && !spoiler.has_killed()) {
        return to_sentence(outcome.error());
    }
    if (outcome && spoiler.has_killed()) {
        return "the lesson's process was killed and nobody noticed";
    }
    if ((arm.force_N > kNoForce_N || arm.torque_Nm > kNoForce_N) && !outcome) {
        return "a force is left after a lesson that was killed";
    }
    if (recorded && spoiler.fills_disk() && was_filled(arm)) {
        return "the record's disk was full and nobody said so";
    }
    return !recorded && !spoiler.fills_disk() ? to_sentence(recorded.error()) : std::string();
}

std::string find_trouble(const RunSpoiler& spoiler, const SpoiledCounts& arm,
                         const DeadlineWatch& deadlines) {
    if (arm.broken_limits > 0) {
        return std::string(name_of(arm.broken)) + ", during: " + name_of(arm.bad_in);
    }
    if (arm.missed_fades > 0) {
        return std::string("a force that had to be gone, during: ") + name_of(arm.bad_in);
    }
    if (spoiler.missed_fades() > 0) {
        return std::to_string(spoiler.bad_N()) +
               " N that had to be gone, during: " + name_of(spoiler.bad_in());
    }
    return deadlines.n_broken() > 0 ? std::string("late: ") + name_of(deadlines.broken())
                                    : std::string();
}

std::uint64_t spoil_seed_of(const std::string& lesson, std::uint64_t seed) {
    return seed ^ std::hash<std::string>{}(lesson);
}

// A third of the runs have an arm that turns the hand too.
SpoiledModel model_of(std::uint64_t spoil_seed) {
    constexpr std::uint64_t kModels = 3;
    return spoil_seed % kModels == 0 ? SpoiledModel::wam : SpoiledModel::desktop;
}

// Whether a run breaks something, for sure, that was not broken yet: what comes first, and what comes once.
bool brings_more(const std::string& lesson, std::uint64_t seed, double seconds,
                 const SoakSum& sum) {
    constexpr double kShown_s = 0.5;  // before its end
    constexpr double kFelt_s = 3.0;   // by then something may be felt that fades
    constexpr double kFilled_s =
        static_cast<double>(kDiskHolds) / (kRounds_Hz * static_cast<double>(kRecordSampleBytes));
    const std::uint64_t spoil_seed = spoil_seed_of(lesson, seed);
    const FirstSpoil arm = SpoiledArm::first_of(spoil_seed);
    const RunSpoiler around(~spoil_seed, seconds);
    const auto is_in_time = [&](double at_s, bool has_happened) {
        return at_s + kShown_s < seconds && (!has_happened || at_s > kFelt_s);
    };
    const auto is_new = [&](RunSpoil kind, double at_s) {
        return sum.lacks(kind) && is_in_time(at_s, sum.around[static_cast<std::size_t>(kind)] > 0);
    };
    return std::ranges::count(sum.deeds, 0U) > 0 ||
           (sum.turned_rounds == 0 && model_of(spoil_seed) == SpoiledModel::wam) ||
           (sum.lacks(arm.kind) &&
            is_in_time(arm.at_s, sum.happened[static_cast<std::size_t>(arm.kind)] > 0)) ||
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
    request.spoil_model = model_of(*request.spoil_seed);
    request.learner_rates = rates_of(kSoakErrors);
    request.thinking_s = kSoakThinking_s;
    return request;
}

HeadlessSettings make_soak_settings(double seconds) {
    HeadlessSettings settings;
    settings.end_s = seconds;
    settings.afterglow_s = seconds;
    settings.nobody_answers_s = 2.0 * seconds;
    settings.shows_prints = false;
    return settings;
}

Expected<SoakRun> soak_once(const Installation& installation, const std::string& lesson,
                            std::uint64_t seed, double seconds, const SiteLimits& site) {
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
    HeadlessSettings settings = make_soak_settings(seconds);
    settings.spoiler = &spoiler;
    DeadlineWatch deadlines;
    settings.deadlines = &deadlines;
    FeltWatch felt;
    settings.felt = &felt;
    settings.again_after_s = kAgainAfter_s;
    settings.after_frame = [&](double now_s) { lifter.step(now_s); };
    if (spoiler.fills_disk()) {
        disk.fill();
    }
    const double began_s = monotonic_now_s();
    const auto outcome = run_headless(**run, settings);
    const auto recorded = (*run)->finish_record();
    SoakRun result;
    result.arm = *(*run)->hand().spoiled_counts();
    result.model = request.spoil_model;
    result.limits = (*run)->hand().spoiled_limits();
    result.wall_s = monotonic_now_s() - began_s;
    result.simulated_s = static_cast<double>(result.arm.rounds) / kRounds_Hz;
    spoiler.end(result.arm.force_N);
    result.trouble = find_end_trouble(spoiler, result.arm, outcome, recorded);
    if (result.trouble.empty()) {
        result.trouble = find_trouble(spoiler, result.arm, deadlines);
    }
    result.since_s = result.arm.bad_since_s >= 0.0  ? result.arm.bad_since_s
                     : spoiler.bad_since_s() >= 0.0 ? spoiler.bad_since_s()
                                                    : deadlines.broken_at_s();
    result.felt = felt.rounds();
    result.around = spoiler.happened();
    result.around_faded = spoiler.faded();
    if (spoiler.fills_disk() && !was_filled(result.arm)) {
        --result.around[static_cast<std::size_t>(RunSpoil::disk_full)];  // it was over too soon
    }
    for (const Deadline what :
         {Deadline::hands, Deadline::effect, Deadline::frame, Deadline::command}) {
        result.n_deadlines += deadlines.n_met(what);
    }
    return result;
}

// How late the loops are on this machine, as it is: with nothing broken, on their own threads.
Expected<void> tell_lateness(const Installation& installation, const std::string& lesson,
                             double seconds, const SiteLimits& site) {
    const auto folder = find_lesson(installation.places, lesson);
    if (!folder) {
        return tl::unexpected(folder.error());
    }
    RunRequest request = make_soak_request(*folder, lesson, 1, site);
    request.spoil_seed.reset();
    request.plan.live = true;
    const auto store = make_null_store();
    auto run = LessonRun::create(installation.places, request, *store, installation.catalogue);
    if (!run) {
        return tl::unexpected(run.error());
    }
    return run_in_real_time(**run, make_soak_settings(seconds))
        .map([&](const HeadlessOutcome& outcome) {
            std::printf("%-13s in real time: %s\n", lesson.c_str(), outcome.pace.c_str());
        });
}

Expected<void> tell_all_lateness(const Installation& installation,
                                 const std::vector<std::string>& lessons, double seconds,
                                 const SiteLimits& site) {
    for (const std::string& lesson : lessons) {
        if (interrupted()) {
            break;
        }
        if (auto told = tell_lateness(installation, lesson, seconds, site); !told) {
            return told;
        }
    }
    return {};
}

}  // namespace

int soak_command(const Installation& installation, const Options& options) {
    const std::vector<std::string> lessons = options.lesson.empty()
                                                 ? list_lesson_names(installation.places)
                                                 : std::vector{options.lesson};
    const std::uint64_t first = options.seed.value_or(1);
    const double seconds = options.seconds.value_or(60.0);
    SoakSum sum;
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
            const double used_s = processor_s();
            auto run = soak_once(installation, lesson, seed, seconds, options.site);
            if (!run) {
                return complain(run.error(), 2);
            }
            run->processor_s = processor_s() - used_s;
            tell_soak(lesson, seed, seconds, *run);
            sum.add(lesson, *run);
        }
        if (seed == first) {
            // What the first sentence that needs it loads, once, is no growth.
            (void)open_free_english({}, dialogue::GrammarOpens::at_once);
            settled_MB = resident_MB();
            settled_in_use_MB = in_use_MB();
        }
    }
    const SoakGrowth growth{std::max(in_use_MB() - settled_in_use_MB, 0.0),
                            // Sanitizers hold back what was freed, to see a use of it.
                            kSanitized ? 0.0 : std::max(resident_MB() - settled_MB, 0.0)};
    std::fputs(describe_soak(sum, growth).c_str(), stdout);
    const auto told =
        tell_all_lateness(installation, is_soak ? lessons : std::vector<std::string>{},
                          std::min(seconds, kRealTime_s), options.site);
    if (!told) {
        return complain(told.error(), 2);
    }
    return conclude_soak(sum, is_soak, growth);
}

}  // namespace fulcrum::runtime
