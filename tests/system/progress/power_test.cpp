// Power cuts, kills and failing disks at every operation, through a file layer that plays them.
//
// FULCRUM_PROGRESS_TRIALS=n multiplies the number of random trials (default 1; 20 takes a few minutes).
#include "runtime/progress/sqlite/schema.h"
#include "runtime/progress/sqlite/sqlite_store.h"
#include "tests/system/progress/power_vfs.h"
#include "tests/system/progress/workload.h"
#include "tests/unit/runtime/progress/progress_fixture.h"

#include <catch2/catch.hpp>
#include <sqlite3.h>

#include <cstdlib>
#include <functional>

namespace fulcrum::runtime {
namespace {

using test::CutStyle;
using test::Operation;
using test::PowerVfs;
using test::TemporaryFolder;
using test::Workload;
using Synchronous = SqliteStoreOptions::Synchronous;

int trials(int base) {
    const char* factor = std::getenv("FULCRUM_PROGRESS_TRIALS");
    return base * std::max(1, factor == nullptr ? 1 : std::atoi(factor));
}

SqliteStoreOptions through(const PowerVfs& vfs, Synchronous synchronous = Synchronous::full) {
    SqliteStoreOptions options;
    options.synchronous = synchronous;
    options.vfs = vfs.name();
    options.busy_timeout_ms = 0;
    return options;
}

// Writes the records in order until one fails, opening the database anew every `reopen_every`. What was acknowledged.
std::set<std::int64_t> write_until_failure(const std::string& path,
                                           const SqliteStoreOptions& options, const Workload& work,
                                           std::int64_t reopen_every) {
    std::set<std::int64_t> acknowledged;
    std::unique_ptr<ProgressStore> store;
    for (std::int64_t number = 0; number < work.records(); ++number) {
        if (number % reopen_every == 0) {
            store.reset();
            auto opened = open_sqlite_store(path, options);
            if (!opened) {
                return acknowledged;
            }
            store = std::move(*opened);
        }
        if (!work.write(*store, number)) {
            return acknowledged;
        }
        acknowledged.insert(number);
    }
    return acknowledged;
}

// How many acknowledged records are gone. The database must be sound, and repeating all writes must leave each once.
std::size_t lost_and_repeated(const std::string& path, const SqliteStoreOptions& options,
                              const Workload& work, const std::set<std::int64_t>& acknowledged) {
    auto store = open_sqlite_store(path, options);
    REQUIRE(store);
    const auto data = (*store)->read({});
    REQUIRE(data);
    const std::size_t lost = work.missing(*data, acknowledged).size();
    for (std::int64_t number = 0; number < work.records(); ++number) {
        const auto kept = work.write(**store, number);
        CAPTURE(test::error_text(kept), number);
        REQUIRE(kept);
    }
    const auto complete = (*store)->read({});
    REQUIRE(complete);
    REQUIRE(work.is_all_of(*complete));
    REQUIRE(test::query(path, "PRAGMA integrity_check") == "ok");
    return lost;
}

// Cuts the power at random operations of a long workload. How many acknowledged records were lost in all.
std::size_t lost_by_power_cuts(Synchronous synchronous, bool disk_lies, int rounds) {
    PowerVfs vfs;
    // Enough writes for the log to be copied into the file by itself, at 1000 pages.
    const Workload work(1, 260);
    const SqliteStoreOptions options = through(vfs, synchronous);
    std::int64_t operations = 0;
    {
        const TemporaryFolder folder(TemporaryFolder::On::memory);
        vfs.reset();
        REQUIRE(write_until_failure(folder.file("p.db"), options, work, 230).size() == 260);
        operations = vfs.changes();
    }
    std::mt19937 random(5);
    std::size_t lost = 0;
    for (int round = 0; round < rounds; ++round) {
        const TemporaryFolder folder(TemporaryFolder::On::memory);
        const std::string path = folder.file("p.db");
        vfs.reset();
        vfs.lie_about_sync(disk_lies);
        vfs.stop_at(1 + static_cast<std::int64_t>(random()) % operations);
        const auto acknowledged = write_until_failure(path, options, work, 230);
        REQUIRE(vfs.stopped());
        vfs.cut_power(static_cast<CutStyle>(round % 3), static_cast<std::uint32_t>(round));
        vfs.lie_about_sync(false);
        CAPTURE(round, acknowledged.size());
        if (disk_lies) {
            // Such a disk may leave anything, even a damaged file, so only the loss is counted.
            auto store = open_sqlite_store(path, options);
            const auto data = store ? (*store)->read({}) : Expected<ProgressData>{};
            lost += work.missing(data ? *data : ProgressData{}, acknowledged).size();
        } else {
            lost += lost_and_repeated(path, options, work, acknowledged);
        }
    }
    return lost;
}

TEST_CASE("power cut: with synchronous=FULL nothing acknowledged is lost") {
    CHECK(lost_by_power_cuts(Synchronous::full, false, trials(90)) == 0);
}

TEST_CASE("power cut: with synchronous=NORMAL acknowledged records are lost") {
    CHECK(lost_by_power_cuts(Synchronous::normal, false, trials(15)) > 0);
}

TEST_CASE("power cut: on a disk that lies about syncs acknowledged records are lost") {
    CHECK(lost_by_power_cuts(Synchronous::full, true, trials(15)) > 0);
}

TEST_CASE("power cut: at each operation of the first minute, nothing acknowledged is lost") {
    PowerVfs vfs;
    const Workload work(2, 6);
    for (const CutStyle style : {CutStyle::drop, CutStyle::pick, CutStyle::garble}) {
        bool was_cut = true;
        for (std::int64_t at = 1; was_cut; ++at) {
            const TemporaryFolder folder(TemporaryFolder::On::memory);
            vfs.reset();
            vfs.stop_at(at);
            const auto acknowledged =
                write_until_failure(folder.file("p.db"), through(vfs), work, 4);
            was_cut = vfs.stopped();
            vfs.cut_power(style, static_cast<std::uint32_t>(at));
            CAPTURE(at, static_cast<int>(style));
            CHECK(lost_and_repeated(folder.file("p.db"), through(vfs), work, acknowledged) == 0);
        }
    }
}

TEST_CASE("kill, repeat, then power cut: what the repetition acknowledged is not lost") {
    // A killed program leaves commits in the page cache that were never synced. A repeated write finds its record there; it
    // must not be acknowledged before the disk has it.
    PowerVfs vfs;
    const Workload work(3, 6);
    bool was_killed = true;
    for (std::int64_t at = 1; was_killed; ++at) {
        const TemporaryFolder folder(TemporaryFolder::On::memory);
        const std::string path = folder.file("p.db");
        vfs.reset();
        vfs.stop_at(at);
        (void)write_until_failure(path, through(vfs), work, 100);
        was_killed = vfs.stopped();
        vfs.revive();
        std::set<std::int64_t> acknowledged;
        auto store = open_sqlite_store(path, through(vfs));
        REQUIRE(store);
        for (std::int64_t number = 0; number < 3; ++number) {
            REQUIRE(work.write(**store, number));
            acknowledged.insert(number);
        }
        vfs.stop_at(1);  // the very next operation
        store->reset();
        vfs.cut_power(CutStyle::drop, 1);
        CAPTURE(at);
        CHECK(lost_and_repeated(path, through(vfs), work, acknowledged) == 0);
    }
}

// Writes every record, repeating each once when it fails; checks each sentence. What was acknowledged.
std::set<std::int64_t> write_through_faults(const std::string& path, const PowerVfs& vfs,
                                            const Workload& work) {
    std::set<std::int64_t> acknowledged;
    std::unique_ptr<ProgressStore> store;
    for (int tries = 0; tries < 2 && !store; ++tries) {
        auto opened = open_sqlite_store(path, through(vfs));
        if (opened) {
            store = std::move(*opened);
        } else {
            CHECK(test::is_sentence_about(to_sentence(opened.error()), path));
            CHECK(vfs.fault_struck());
        }
    }
    for (std::int64_t number = 0; store && number < work.records(); ++number) {
        for (int tries = 0; tries < 2 && acknowledged.count(number) == 0; ++tries) {
            const auto kept = work.write(*store, number);
            if (kept) {
                acknowledged.insert(number);
            } else {
                CHECK(test::is_sentence_about(to_sentence(kept.error()), path));
            }
        }
    }
    return acknowledged;
}

struct FaultKind {
    Operation operation;
    int code;
};

// Every operation of every kind fails, once or from then on; then the power fails too, or not.
void check_every_fault(const std::function<std::set<std::int64_t>(const std::string&)>& prepare) {
    PowerVfs vfs;
    const Workload work(4, 6);
    for (const FaultKind kind :
         {FaultKind{Operation::open, SQLITE_CANTOPEN},
          FaultKind{Operation::read, SQLITE_IOERR_READ},
          FaultKind{Operation::write, SQLITE_IOERR_WRITE}, FaultKind{Operation::write, SQLITE_FULL},
          FaultKind{Operation::sync, SQLITE_IOERR_FSYNC},
          FaultKind{Operation::truncate, SQLITE_IOERR_TRUNCATE},
          FaultKind{Operation::remove, SQLITE_IOERR_DELETE},
          FaultKind{Operation::share, SQLITE_IOERR_SHMMAP}}) {
        for (int way = 0; way < 4; ++way) {
            const bool lasting = way % 2 == 1;
            bool struck = true;
            for (std::int64_t at = 1; struck; ++at) {
                const TemporaryFolder folder(TemporaryFolder::On::memory);
                const std::string path = folder.file("p.db");
                std::set<std::int64_t> before = prepare(path);
                vfs.reset();
                vfs.fail_at(kind.operation, at, lasting, kind.code);
                auto acknowledged = write_through_faults(path, vfs, work);
                struck = vfs.fault_struck();
                vfs.clear_fault();
                CAPTURE(static_cast<int>(kind.operation), kind.code, lasting, at);
                if (!lasting) {
                    CHECK(acknowledged.size() == static_cast<std::size_t>(work.records()));
                }
                acknowledged.merge(before);
                if (way >= 2) {
                    vfs.cut_power(CutStyle::drop, static_cast<std::uint32_t>(at));
                }
                CHECK(lost_and_repeated(path, through(vfs), work, acknowledged) == 0);
            }
        }
    }
}

TEST_CASE("fault: any operation on a new database may fail; nothing acknowledged is lost") {
    check_every_fault([](const std::string&) { return std::set<std::int64_t>{}; });
}

TEST_CASE("fault: any operation of bringing version 1 up may fail; nothing kept is lost") {
    check_every_fault([](const std::string& path) {
        sqlite::Database database(path, SQLITE_OPEN_READWRITE | SQLITE_OPEN_CREATE, "");
        database.run(sqlite::migrations()[0]);
        database.run("PRAGMA application_id = 0x46756C63; PRAGMA user_version = 1");
        const Learner learner = Workload(4, 6).learner();
        sqlite::Statement(database, "INSERT INTO learner VALUES(1, ?, ?, ?)")
            .bind(learner.id)
            .bind(learner.nickname)
            .bind(learner.enrolled_utc_ms)
            .run();
        return std::set<std::int64_t>{0};
    });
}

}  // namespace
}  // namespace fulcrum::runtime
