// A writer program killed at random moments, and several programs at once on one database.
//
// FULCRUM_PROGRESS_TRIALS=n multiplies the number of kills (60; 20 takes a few minutes).
#include "runtime/progress/sqlite/sqlite_store.h"
#include "tests/system/progress/workload.h"
#include "tests/unit/runtime/progress/progress_fixture.h"

#include <catch2/catch.hpp>

#include <chrono>
#include <cstdlib>
#include <fcntl.h>
#include <random>
#include <signal.h>
#include <sstream>
#include <sys/wait.h>
#include <thread>
#include <unistd.h>

namespace fulcrum::runtime {
namespace {

using test::query;
using test::TemporaryFolder;
using test::Workload;

constexpr int kKills = 60;
constexpr int kQueuedKills = 45;

int trials(int base) {
    const char* factor = std::getenv("FULCRUM_PROGRESS_TRIALS");
    return base * std::max(1, factor == nullptr ? 1 : std::atoi(factor));
}

// A running writer, its acknowledgements at the other end of a pipe.
class Writer {
  public:
    enum class Writes : std::uint8_t { one_by_one, queued };
    Writer(const std::string& path, int seed, const Workload& work, std::int64_t first,
           Writes how = Writes::one_by_one) {
        int ends[2];
        REQUIRE(pipe2(ends, O_CLOEXEC) == 0);
        const std::string seed_text = std::to_string(seed);
        const std::string records = std::to_string(work.records());
        const std::string first_text = std::to_string(first);
        process_ = fork();
        REQUIRE(process_ >= 0);
        if (process_ == 0) {
            dup2(ends[1], STDOUT_FILENO);
            execl(FULCRUM_PROGRESS_WRITER, FULCRUM_PROGRESS_WRITER, path.c_str(), seed_text.c_str(),
                  records.c_str(), first_text.c_str(), how == Writes::queued ? "queued" : nullptr,
                  nullptr);
            _exit(127);
        }
        close(ends[1]);
        pipe_ = ends[0];
    }
    Writer(const Writer&) = delete;
    Writer& operator=(const Writer&) = delete;
    ~Writer() { close(pipe_); }

    void kill_it() const { kill(process_, SIGKILL); }

    // Waits for the first acknowledgement.
    void await_first() {
        char byte = 0;
        if (read(pipe_, &byte, 1) == 1) {
            said_ += byte;
        }
    }

    // Waits for its end. The numbers that it said were kept.
    std::set<std::int64_t> finish() {
        char bytes[4096];
        for (ssize_t got = 0; (got = read(pipe_, bytes, sizeof bytes)) > 0;) {
            said_.append(bytes, static_cast<std::size_t>(got));
        }
        waitpid(process_, &status_, 0);
        std::set<std::int64_t> acknowledged;
        std::istringstream numbers(said_);
        for (std::int64_t number = 0; numbers >> number;) {
            acknowledged.insert(number);
        }
        return acknowledged;
    }

    [[nodiscard]] bool was_killed() const { return WIFSIGNALED(status_); }
    [[nodiscard]] bool went_well() const { return WIFEXITED(status_) && WEXITSTATUS(status_) == 0; }

  private:
    pid_t process_ = -1;
    int pipe_ = -1;
    int status_ = 0;
    std::string said_;
};

// Everything acknowledged is there, once, in a sound database.
void check_kept(const std::string& path, const Workload& work,
                const std::set<std::int64_t>& acknowledged) {
    auto store = open_sqlite_store(path);
    REQUIRE(store);
    const auto data = (*store)->read({});
    REQUIRE(data);
    CHECK(work.missing(*data, acknowledged).empty());
    CHECK(query(path, "PRAGMA quick_check") == "ok");
    CHECK(query(path, "SELECT count(*) - count(DISTINCT question) FROM attempt") == "0");
}

// One lesson on one database, killed again and again; each new writer begins with what was not acknowledged.
void kill_at_random(int kills, int seed, Writer::Writes how) {
    std::mt19937 random(17);
    int killed = 0;
    while (killed < trials(kills)) {
        const TemporaryFolder folder;
        const std::string path = folder.file("progress.db");
        const Workload work(static_cast<std::uint64_t>(++seed), 4'000);
        std::set<std::int64_t> acknowledged;
        for (int round = 0; round < 15; ++round) {
            const std::int64_t first = acknowledged.empty() ? 0 : *acknowledged.rbegin() + 1;
            Writer writer(path, seed, work, first, how);
            // Half of them while the database is being opened or made, half while records are written.
            if (round % 2 == 1) {
                writer.await_first();
            }
            std::this_thread::sleep_for(std::chrono::microseconds(random() % 20'000));
            writer.kill_it();
            acknowledged.merge(writer.finish());
            killed += writer.was_killed() ? 1 : 0;
            check_kept(path, work, acknowledged);
        }
        CHECK(acknowledged.size() > 1);
    }
}

TEST_CASE("kill: at random moments nothing acknowledged is lost and nothing is there twice") {
    kill_at_random(kKills, 100, Writer::Writes::one_by_one);
}

TEST_CASE("kill: with a store thread, too, nothing that it counts as kept is lost") {
    kill_at_random(kQueuedKills, 200, Writer::Writes::queued);
}

TEST_CASE("kill: a writer that is left alone keeps every record") {
    const auto how = GENERATE(Writer::Writes::one_by_one, Writer::Writes::queued);
    const TemporaryFolder folder;
    const Workload work(9, 200);
    Writer writer(folder.file("progress.db"), 9, work, 0, how);
    CHECK(writer.finish().size() == 200);
    CHECK(writer.went_well());
    auto store = open_sqlite_store(folder.file("progress.db"));
    REQUIRE(store);
    CHECK(work.is_all_of(*(*store)->read({})));
}

TEST_CASE("several programs: make one database at once, and each keeps its own records") {
    for (int round = 0; round < 4; ++round) {
        const TemporaryFolder folder;
        const std::string path = folder.file("class/progress.db");
        const Workload work(0, 12);
        std::vector<std::unique_ptr<Writer>> writers;
        for (int seed = 1; seed <= 6; ++seed) {
            writers.push_back(std::make_unique<Writer>(path, seed, work, 0));
        }
        for (const auto& writer : writers) {
            CHECK(writer->finish().size() == 12);
            CHECK(writer->went_well());
        }
        CHECK(query(path, "PRAGMA integrity_check") == "ok");
        CHECK(query(path, "SELECT count(*) FROM learner") == "6");
        CHECK(query(path, "SELECT count(*) FROM attempt") == "54");
        CHECK(query(path, "SELECT count(*) FROM session_end") == "6");
    }
}

}  // namespace
}  // namespace fulcrum::runtime
