// What certainty costs: commits a second with synchronous=FULL against NORMAL on the same disk, taken in turn so that both
// see the same machine, and how long a large database takes to open. CSV on standard output.
//
//   bench_progress [FOLDER] [ROUNDS]     FOLDER: where the databases are made, default the system's temporary folder
#include "haptics/base/clock.h"
#include "runtime/progress/sqlite/sqlite_store.h"

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <string>
#include <unistd.h>
#include <vector>

namespace {

using namespace fulcrum;
using namespace fulcrum::runtime;
using Synchronous = SqliteStoreOptions::Synchronous;

constexpr int kCommits = 200;           // of each kind, a round
constexpr int kLargeAttempts = 20'000;  // a class of 30 for a school year

// Ends with one sentence when something that must work did not.
template <class T>
T must(Expected<T> result) {
    if (!result) {
        std::fprintf(stderr, "%s\n", to_sentence(result.error()).c_str());
        std::exit(1);
    }
    if constexpr (!std::is_void_v<T>) {
        return std::move(*result);
    }
}

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

void compare_commits(const std::string& folder, int rounds) {
    const auto full = open_with(folder + "/full.db", Synchronous::full);
    const auto normal = open_with(folder + "/normal.db", Synchronous::normal);
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
    std::printf("commits_per_s,full,%.0f\n", median(full_rates));
    std::printf("commits_per_s,normal,%.0f\n", median(normal_rates));
    std::printf("ratio,normal_to_full,%.2f\n", median(ratios));
}

void time_large(const std::string& folder) {
    const std::string path = folder + "/large.db";
    {
        const auto store = open_with(path, Synchronous::normal);
        const RecordId session = begin(*store);
        for (int number = 1; number <= kLargeAttempts; ++number) {
            must(store->add_attempt(attempt_in(session, number)));
        }
    }
    std::vector<double> open_ms;
    std::vector<double> read_ms;
    for (int round = 0; round < 9; ++round) {
        const double start_s = monotonic_now_s();
        const auto store = open_with(path, Synchronous::full);
        const double opened_s = monotonic_now_s();
        (void)must(store->read({}));
        open_ms.push_back(1e3 * (opened_s - start_s));
        read_ms.push_back(1e3 * (monotonic_now_s() - opened_s));
    }
    std::printf("large_MB,file,%.1f\n",
                1e-6 * static_cast<double>(std::filesystem::file_size(path)));
    std::printf("large_ms,open_with_check,%.1f\n", median(open_ms));
    std::printf("large_ms,read_all,%.1f\n", median(read_ms));
}

}  // namespace

int main(int count, char** arguments) {
    const std::filesystem::path above =
        count > 1 ? std::filesystem::path(arguments[1]) : std::filesystem::temp_directory_path();
    const int rounds = count > 2 ? std::max(1, std::atoi(arguments[2])) : 11;
    std::string folder = (above / "fulcrum-bench-XXXXXX").string();
    if (mkdtemp(folder.data()) == nullptr) {
        std::fprintf(stderr, "%s: no folder can be made there.\n", above.c_str());
        return 1;
    }
    std::printf("# %d rounds of %d commits, an attempt with two errors each; medians\n", rounds,
                kCommits);
    std::printf("what,of,value\n");
    compare_commits(folder, rounds);
    time_large(folder);
    std::filesystem::remove_all(folder);
    return 0;
}
