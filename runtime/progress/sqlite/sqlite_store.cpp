#include "runtime/progress/sqlite/sqlite_store.h"

#include "runtime/progress/database_path.h"
#include "runtime/progress/sqlite/database.h"
#include "runtime/progress/sqlite/inspect.h"
#include "runtime/progress/sqlite/queries.h"
#include "runtime/progress/sqlite/schema.h"
#include "runtime/progress/text_rules.h"

#include <chrono>
#include <sys/stat.h>
#include <thread>

namespace fulcrum::runtime {
namespace {

using sqlite::Database;
using sqlite::guarded;
using sqlite::Refused;
using sqlite::Transaction;

class SqliteStore final : public ProgressStore {
  public:
    explicit SqliteStore(Database database) : database_(std::move(database)) {}

    [[nodiscard]] bool keeps() const noexcept override { return true; }

    [[nodiscard]] Expected<Learner> enrol(std::string_view nickname) override {
        return checked_nickname(nickname).and_then([&](const std::string& name) {
            return in_transaction([&] { return sqlite::enrol(database_, name); });
        });
    }
    [[nodiscard]] Expected<void> add_learner(const Learner& learner) override {
        return keep(learner);
    }
    [[nodiscard]] Expected<void> begin_session(const SessionRecord& session) override {
        return keep(session);
    }
    [[nodiscard]] Expected<void> add_setting(const SessionSetting& setting) override {
        return keep(setting);
    }
    [[nodiscard]] Expected<void> add_hand_setting(const HandSetting& setting) override {
        return keep(setting);
    }
    [[nodiscard]] Expected<void> end_session(const SessionEnd& end) override { return keep(end); }
    [[nodiscard]] Expected<void> add_attempt(const AttemptRecord& attempt) override {
        return keep(attempt);
    }

    [[nodiscard]] Expected<ProgressData> read(const ProgressFilter& filter) override {
        return guarded([&] {
            const Transaction snapshot(database_, Transaction::Kind::read);
            return sqlite::read(database_, filter);
        });
    }

    [[nodiscard]] Expected<void> add_class_rows(const ClassRows& rows) override {
        return keep(rows);
    }
    [[nodiscard]] Expected<ClassRows> read_classes() override {
        return guarded([&] {
            const Transaction snapshot(database_, Transaction::Kind::read);
            return sqlite::read_classes(database_);
        });
    }

  private:
    template <class Work>
    auto in_transaction(Work&& work) -> Expected<decltype(work())> {
        return guarded([&] {
            Transaction transaction(database_, Transaction::Kind::write);
            if constexpr (std::is_void_v<decltype(work())>) {
                work();
                transaction.commit();
            } else {
                auto result = work();
                transaction.commit();
                return result;
            }
        });
    }

    template <class Record>
    Expected<void> keep(const Record& record) {
        return validate(record).and_then(
            [&] { return in_transaction([&] { sqlite::keep(database_, record); }); });
    }

    Database database_;
};

void configure(Database& database, const SqliteStoreOptions& options) {
    sqlite3_busy_timeout(database.handle(), options.busy_timeout_ms);
    // A database that somebody prepared may hold views or triggers with side effects: they get no
    // functions to call.
    sqlite3_db_config(database.handle(), SQLITE_DBCONFIG_TRUSTED_SCHEMA, 0, nullptr);
    sqlite3_db_config(database.handle(), SQLITE_DBCONFIG_DEFENSIVE, 1, nullptr);
    sqlite3_db_config(database.handle(), SQLITE_DBCONFIG_ENABLE_FKEY, 1, nullptr);
    if (sqlite3_db_readonly(database.handle(), "main") == 1) {
        throw Refused(sqlite::error_for(SQLITE_READONLY, database.path(), "it is read-only"));
    }
    // The switch to the log deletes a rollback journal. Unless its folder is synced too, a power cut may bring the
    // journal back, and it would undo the file under the log.
    database.run("PRAGMA synchronous = EXTRA");
    sqlite::Statement mode(database, "PRAGMA journal_mode = WAL");
    const bool logged = mode.step() && mode.text() == "wal";
    mode.run();  // the switch is only done when the statement has ended
    if (!logged) {
        throw Refused(sqlite::error_for(SQLITE_CANTOPEN, database.path(),
                                        "its file system has no write-ahead log"));
    }
    const bool full = options.synchronous == SqliteStoreOptions::Synchronous::full;
    database.run(full ? "PRAGMA synchronous = FULL" : "PRAGMA synchronous = NORMAL");
}

std::unique_ptr<ProgressStore> open(const std::string& path, const SqliteStoreOptions& options) {
    sqlite::inspect(path, options.vfs, options.busy_timeout_ms);
    Database database(path, SQLITE_OPEN_READWRITE, options.vfs);
    configure(database, options);
    sqlite::migrate(database);
    return std::make_unique<SqliteStore>(std::move(database));
}

/// Where two programs that both read want to write, as in the switch to the log, sqlite refuses one at once instead of
/// asking its busy handler, since neither could ever go on (sqlite.org/c3ref/busy_handler.html). So the one that was
/// refused lets go of everything and begins anew, as long as it was told to wait.
std::unique_ptr<ProgressStore> open_when_free(const std::string& path,
                                              const SqliteStoreOptions& options) {
    using Clock = std::chrono::steady_clock;
    constexpr std::chrono::milliseconds kRest{5};
    const auto give_up = Clock::now() + std::chrono::milliseconds(options.busy_timeout_ms);
    for (;;) {
        try {
            return open(path, options);
        } catch (const Refused& refused) {
            const bool busy = (refused.code() & 0xFF) == SQLITE_BUSY;
            if (!busy || Clock::now() + kRest > give_up) {
                throw;
            }
        }
        std::this_thread::sleep_for(kRest);
    }
}

}  // namespace

Expected<std::unique_ptr<ProgressStore>> open_sqlite_store(const std::string& path,
                                                           const SqliteStoreOptions& options) {
    struct stat status {};
    const bool there = stat(path.c_str(), &status) == 0;
    if (there && !S_ISREG(status.st_mode)) {
        return fail("this is no file", path, "choose another file with --db");
    }
    if (!there && !options.create) {
        return fail("no progress has been kept here yet", path, "play a lesson first");
    }
    if (!there) {
        if (auto made = create_private_file(path); !made) {
            return tl::unexpected<Error>(made.error());
        }
    }
    return guarded([&] { return open_when_free(path, options); });
}

}  // namespace fulcrum::runtime
