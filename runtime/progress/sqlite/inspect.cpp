#include "runtime/progress/sqlite/inspect.h"

#include "runtime/progress/sqlite/schema.h"

#include <chrono>
#include <optional>
#include <sys/stat.h>
#include <thread>
#include <tuple>

namespace fulcrum::runtime::sqlite {
namespace {

constexpr const char* kElsewhere = "choose another file with --db or move this one away";

// Longer than the clock tick by which file systems note a change (10 ms at most).
constexpr std::chrono::milliseconds kRest{20};

// Exists, size, seconds and nanoseconds of the last change.
using Fingerprint = std::tuple<bool, off_t, time_t, long>;

Fingerprint fingerprint(const std::string& path) {
    struct stat status {};
    const bool there = stat(path.c_str(), &status) == 0;
    return {there, status.st_size, status.st_mtim.tv_sec, status.st_mtim.tv_nsec};
}

bool exists_beside(const std::string& path, const char* suffix, const std::string& vfs) {
    sqlite3_vfs* layer = sqlite3_vfs_find(vfs.empty() ? nullptr : vfs.c_str());
    int there = 0;
    return layer != nullptr &&
           layer->xAccess(layer, (path + suffix).c_str(), SQLITE_ACCESS_EXISTS, &there) ==
               SQLITE_OK &&
           there != 0;
}

void check_owner_and_version(Database& database) {
    const std::int64_t owner = database.number("PRAGMA application_id");
    const std::int64_t version = database.number("PRAGMA user_version");
    const bool empty = database.number("SELECT count(*) FROM sqlite_schema") == 0;
    if (empty && owner == 0 && version == 0) {
        return;
    }
    if (owner != kApplicationId || version < 1) {
        throw Refused({"this database belongs to another program", database.path(), kElsewhere});
    }
    if (version > kSchemaVersion) {
        throw Refused({"this database is of version " + std::to_string(version) +
                           ", newer than this program knows (" + std::to_string(kSchemaVersion) +
                           ")",
                       database.path(), "update Fulcrum or choose another file with --db"});
    }
}

/// What a version says is there must be there: a write that finds it missing would come too late.
void check_columns(Database& database) {
    struct Column {
        const char* table;
        const char* name;
        std::int64_t since;  // the version
    };
    constexpr Column kColumns[] = {{"learner", "nickname", 1},     {"session", "lesson_version", 1},
                                   {"session_end", "stars", 1},    {"attempt", "said", 1},
                                   {"attempt_error", "code", 1},   {"opening", "opened_utc_ms", 1},
                                   {"attempt", "understood", 2},   {"session_setting", "value", 2},
                                   {"attempt_error", "point", 3},  {"attempt", "uptake", 4},
                                   {"hand_setting", "value", 5},   {"attempt", "form_known", 6},
                                   {"attempt_error", "target", 7}, {"class", "name", 8},
                                   {"class_setting", "value", 8},  {"class_card", "secret", 8}};
    const std::int64_t version = database.number("PRAGMA user_version");
    for (const Column& column : kColumns) {
        Statement find(database, "SELECT 1 FROM pragma_table_info(?) WHERE name = ?");
        if (column.since <= version && !find.bind(column.table).bind(column.name).step()) {
            std::string told =
                "this database says that it is of version " + std::to_string(version);
            told.append(", but has no ").append(column.table).append(".").append(column.name);
            throw Refused({told, database.path(), kElsewhere});
        }
    }
}

void check_pages(Database& database) {
    Statement check(database, "PRAGMA quick_check(1)");
    const std::string verdict = check.step() ? check.text() : "no answer";
    if (verdict != "ok") {
        // sqlite's headline "*** in database main ***" says nothing, and more lines would be no
        // sentence.
        const std::size_t headline = verdict.rfind("***", 0) == 0 ? verdict.find('\n') + 1 : 0;
        const std::string first = verdict.substr(headline, verdict.find('\n', headline) - headline);
        throw Refused(error_for(SQLITE_CORRUPT, database.path(), first), SQLITE_CORRUPT);
    }
}

void look(const std::string& path, const std::string& vfs, const char* parameters,
          int busy_timeout_ms) {
    Database database(path, SQLITE_OPEN_READONLY, vfs, parameters);
    sqlite3_busy_timeout(database.handle(), busy_timeout_ms);
    sqlite3_db_config(database.handle(), SQLITE_DBCONFIG_TRUSTED_SCHEMA, 0, nullptr);
    database.run("PRAGMA cell_size_check = ON");
    Transaction snapshot(database, Transaction::Kind::read);
    check_owner_and_version(database);
    check_pages(database);
    check_columns(database);
}

}  // namespace

void inspect(const std::string& path, const std::string& vfs, int busy_timeout_ms) {
    // With a rollback journal beside it the file is half-written by intent; opening it mends it.
    if (exists_beside(path, "-journal", vfs)) {
        return;
    }
    // Without a log nobody is writing: an immutable look takes no locks and leaves nothing beside the file. But somebody
    // may begin meanwhile and tear the look; so a refusal counts only when the file has rested since the look before.
    std::optional<Fingerprint> rested;
    while (!exists_beside(path, "-wal", vfs)) {
        const Fingerprint now = fingerprint(path);
        const auto outcome = guarded([&] { look(path, vfs, "immutable=1", busy_timeout_ms); });
        if (outcome) {
            return;
        }
        if (rested == now) {
            throw Refused(outcome.error());
        }
        rested = now;
        std::this_thread::sleep_for(kRest);
    }
    look(path, vfs, "", busy_timeout_ms);
}

}  // namespace fulcrum::runtime::sqlite
