// What certainty costs: commits with synchronous=FULL against NORMAL on the same disk, taken in turn so that both see the
// same machine, and how long a large database takes to open. TMPDIR chooses the disk.
#include "haptics/base/clock.h"
#include "runtime/progress/sqlite/sqlite_store.h"
#include "tests/bench/harness/curve.h"
#include "tests/support/scratch_folder.h"

#include <filesystem>

namespace fulcrum::bench {
namespace {

using namespace fulcrum::runtime;
using Synchronous = SqliteStoreOptions::Synchronous;

constexpr int kCommits = 200;           // of each kind, a round
constexpr int kLargeAttempts = 20'000;  // a class of 30 for a school year

AttemptRecord attempt_in(const RecordId& session, int number) {
    AttemptRecord attempt;
    attempt.id = random_record_id();
    attempt.session = session;
    attempt.question = "heaviest";
    attempt.attempt = number;
    attempt.said = "watermelon is most heavy";
    attempt.meaning_right = true;
    attempt.errors = {{"M:DET", "", "the"}, {"R:ADJ:FORM", "most heavy", "heaviest"}};
    return attempt;
}

std::unique_ptr<ProgressStore> open_with(const std::string& path, Synchronous synchronous) {
    SqliteStoreOptions options;
    options.synchronous = synchronous;
    return must(open_sqlite_store(path, options));
}

RecordId begin(ProgressStore& store) {
    const Learner learner = must(store.enrol("Mina"));
    const SessionRecord session{random_record_id(), learner.id, "gravity", "", "A1", 0, {}};
    must(store.begin_session(session));
    return session.id;
}

double commits_per_s(ProgressStore& store, const RecordId& session) {
    const double start_s = monotonic_now_s();
    for (int number = 1; number <= kCommits; ++number) {
        must(store.add_attempt(attempt_in(session, number)));
    }
    return kCommits / (monotonic_now_s() - start_s);
}

double median(std::vector<double> values) {
    std::sort(values.begin(), values.end());
    return values[values.size() / 2];
}

void compare_commits(Sheet& sheet, const ScratchFolder& folder, int rounds) {
    const auto full = open_with(folder.file("full.db"), Synchronous::full);
    const auto normal = open_with(folder.file("normal.db"), Synchronous::normal);
    const RecordId full_session = begin(*full);
    const RecordId normal_session = begin(*normal);
    commits_per_s(*full, full_session);  // warm-up
    commits_per_s(*normal, normal_session);
    std::vector<double> full_rates;
    std::vector<double> normal_rates;
    std::vector<double> ratios;
    for (int round = 0; round < rounds; ++round) {
        full_rates.push_back(commits_per_s(*full, full_session));
        normal_rates.push_back(commits_per_s(*normal, normal_session));
        ratios.push_back(normal_rates.back() / full_rates.back());
    }
    sheet.add(
        {"commits, synchronous=FULL (the default)", median(full_rates), "a second", "nothing"});
    sheet.add({"commits, synchronous=NORMAL", median(normal_rates), "a second",
               "what the disk had not written yet"});
    sheet.add({"NORMAL against FULL", median(ratios), "times as fast", ""});
}

void time_large(Sheet& sheet, const ScratchFolder& folder, int attempts, int rounds) {
    const std::string path = folder.file("large.db");
    {
        const auto store = open_with(path, Synchronous::normal);
        const RecordId session = begin(*store);
        for (int number = 1; number <= attempts; ++number) {
            must(store->add_attempt(attempt_in(session, number)));
        }
    }
    std::vector<double> open_ms;
    std::vector<double> read_ms;
    for (int round = 0; round < rounds; ++round) {
        const double start_s = monotonic_now_s();
        const auto store = open_with(path, Synchronous::full);
        const double opened_s = monotonic_now_s();
        (void)must(store->read({}));
        open_ms.push_back(1e3 * (opened_s - start_s));
        read_ms.push_back(1e3 * (monotonic_now_s() - opened_s));
    }
    const std::string of = " of " + std::to_string(attempts) + " attempts";
    sheet.add(
        {"size" + of, 1e-6 * static_cast<double>(std::filesystem::file_size(path)), "MB", ""});
    sheet.add({"open and check" + of, median(open_ms), "ms", ""});
    sheet.add({"read all" + of, median(read_ms), "ms", ""});
}

Report run_progress(Run& run) {
    Sheet sheet{
        "progress",
        "Keeping progress",
        "Attempts with two errors each are committed one by one, " + std::to_string(kCommits) +
            " of either kind in turn; medians of the rounds. Then a school year of a class is "
            "opened and read.",
        "Keep FULL: even the slower kind commits far more often than a class can answer, and a "
        "power cut takes nothing.",
        {"what", "median", "unit", "a power cut may take"}};
    const ScratchFolder folder;
    compare_commits(sheet, folder, run.pick(11, 1));
    run.progress(0.5, "a large database");
    time_large(sheet, folder, run.pick(kLargeAttempts, 500), run.pick(9, 3));
    return {sheet};
}

const Registration kProgress{
    {"progress", "what a commit costs that nothing can take back", run_progress}};

}  // namespace
}  // namespace fulcrum::bench
