// Opening a database: new, older, newer, damaged, of another program, not to be reached.
#include "runtime/progress/report.h"
#include "runtime/progress/sqlite/schema.h"
#include "runtime/progress/sqlite/sqlite_store.h"
#include "tests/unit/runtime/progress/progress_fixture.h"

#include <catch2/catch.hpp>
#include <sqlite3.h>

#include <filesystem>
#include <random>
#include <sys/stat.h>
#include <unistd.h>

namespace fulcrum::runtime {
namespace {

using test::attempt_for;
using test::bytes_of;
using test::Classroom;
using test::is_sentence_about;
using test::query;
using test::run_sql;
using test::TemporaryFolder;

// The sentence of a refused opening; "" when it opened.
std::string refusal(const std::string& path, const SqliteStoreOptions& options = {}) {
    const auto opened = open_sqlite_store(path, options);
    return opened ? "" : to_sentence(opened.error());
}

std::size_t files_in(const TemporaryFolder& folder) {
    const std::filesystem::directory_iterator files(folder.path());
    return static_cast<std::size_t>(std::distance(begin(files), end(files)));
}

mode_t mode_of(const std::string& path) {
    struct stat status {};
    REQUIRE(stat(path.c_str(), &status) == 0);
    return status.st_mode & 0777U;
}

// A database of version 1 with a learner, a session and two attempts, one of them with an error.
void make_version_1(const std::string& path) {
    using namespace sqlite;
    Database database(path, SQLITE_OPEN_READWRITE | SQLITE_OPEN_CREATE, "");
    database.run(migrations()[0]);
    database.run("PRAGMA application_id = 0x46756C63; PRAGMA user_version = 1");
    const std::string id(32, 'a');
    Statement(database, "INSERT INTO learner VALUES(1, ?, 'Mina', 5)").bind(id).run();
    Statement(database, "INSERT INTO session VALUES(1, ?, ?, 'gravity', 'v', 'A1', 6)")
        .bind(id)
        .bind(id)
        .run();
    for (const char digit : {'b', 'c'}) {
        Statement(
            database,
            "INSERT INTO attempt VALUES(NULL, ?, ?, 'heaviest', 1, 'an egg', 1, 0, 's', 2.5, 7)")
            .bind(std::string(32, digit))
            .bind(id)
            .run();
    }
    Statement(database, "INSERT INTO attempt_error VALUES(?, 0, 'M:DET', '', 'the')")
        .bind(std::string(32, 'c'))
        .run();
}

TEST_CASE("opening: a new database is private, logged ahead and of this version") {
    const TemporaryFolder folder;
    const std::string path = folder.file("a b#%?/deep/progress.db");
    auto store = open_sqlite_store(path);
    REQUIRE(store);
    CHECK(mode_of(path) == 0600);
    CHECK(mode_of(path + "-wal") == 0600);
    CHECK(mode_of(folder.file("a b#%?")) == 0700);
    CHECK(mode_of(folder.file("a b#%?/deep")) == 0700);
    CHECK(query(path, "PRAGMA journal_mode") == "wal");
    CHECK(query(path, "PRAGMA user_version") == std::to_string(sqlite::kSchemaVersion));
    CHECK(query(path, "PRAGMA application_id") == std::to_string(sqlite::kApplicationId));
}

TEST_CASE("opening: an empty file becomes a database, an empty folder stays empty on request") {
    const TemporaryFolder folder;
    CHECK(is_sentence_about(refusal(folder.file("none.db"), {.create = false, .vfs = ""}),
                            folder.file("none.db")));
    CHECK(files_in(folder) == 0);
    test::write_bytes(folder.file("empty.db"), "");
    CHECK(refusal(folder.file("empty.db")).empty());
}

TEST_CASE("opening: version 1 becomes version 2 and keeps every fact") {
    const TemporaryFolder folder;
    const std::string path = folder.file("progress.db");
    make_version_1(path);
    for (int times = 0; times < 2; ++times) {
        auto store = open_sqlite_store(path);
        REQUIRE(store);
        const auto data = (*store)->read({});
        REQUIRE(data);
        CHECK(data->learners == std::vector{Learner{std::string(32, 'a'), "Mina", 5}});
        REQUIRE(data->attempts.size() == 2);
        CHECK(data->attempts[0].understood);
        CHECK(data->attempts[0].said == "an egg");
        CHECK(data->attempts[1].errors == std::vector{ErrorRecord{"M:DET", "", "the"}});
        // What version 2 brought works on what version 1 kept.
        SessionRecord session{
            std::string(32, 'd'),     std::string(32, 'a'), "gravity", "", "A1", 8,
            {{"force_limit_N", "10"}}};
        CHECK((*store)->begin_session(session));
        CHECK((*store)->read({})->sessions.back() == session);
    }
    CHECK(query(path, "PRAGMA user_version") == "2");
    CHECK(query(path, "PRAGMA integrity_check") == "ok");
}

TEST_CASE("opening: a step that fails leaves the older version as it was") {
    const TemporaryFolder folder;
    const std::string path = folder.file("progress.db");
    make_version_1(path);
    // The second half of the step meets a table that stands in its way.
    REQUIRE(run_sql(path, "CREATE TABLE session_setting(x)").empty());
    CHECK(is_sentence_about(refusal(path), path));
    CHECK(query(path, "PRAGMA user_version") == "1");
    CHECK(
        query(path, "SELECT count(*) FROM pragma_table_info('attempt') WHERE name='understood'") ==
        "0");
    REQUIRE(run_sql(path, "DROP TABLE session_setting").empty());
    CHECK(refusal(path).empty());
}

TEST_CASE("opening: a newer database is refused and untouched") {
    const TemporaryFolder folder;
    const std::string path = folder.file("progress.db");
    { const Classroom room(path); }
    REQUIRE(run_sql(path, "PRAGMA user_version = 3").empty());
    const std::string before = bytes_of(path);
    const std::string sentence = refusal(path);
    CHECK(is_sentence_about(sentence, path));
    CHECK(sentence.find("version 3") != std::string::npos);
    CHECK(sentence.find("update Fulcrum") != std::string::npos);
    CHECK(bytes_of(path) == before);
    CHECK(files_in(folder) == 1);
}

TEST_CASE("opening: a newer version that stands only in the log is seen, and the log untouched") {
    const TemporaryFolder folder;
    const std::string path = folder.file("progress.db");
    { const Classroom room(path); }
    const std::string crashed = folder.file("crashed.db");
    {
        sqlite::Database newer(path, SQLITE_OPEN_READWRITE, "");
        newer.run("PRAGMA user_version = 3");
        test::write_bytes(crashed, bytes_of(path));
        test::write_bytes(crashed + "-wal", bytes_of(path + "-wal"));
    }
    const std::string before = bytes_of(crashed);
    const std::string log = bytes_of(crashed + "-wal");
    REQUIRE_FALSE(log.empty());
    CHECK(refusal(crashed).find("version 3") != std::string::npos);
    CHECK(bytes_of(crashed) == before);
    CHECK(bytes_of(crashed + "-wal") == log);
}

TEST_CASE("opening: another program's database is refused and untouched") {
    const TemporaryFolder folder;
    const std::string path = folder.file("photos.db");
    test::write_bytes(path, "");
    REQUIRE(run_sql(path, "CREATE TABLE photo(x)").empty());
    const std::string before = bytes_of(path);
    CHECK(refusal(path).find("another program") != std::string::npos);
    REQUIRE(run_sql(path, "PRAGMA application_id = 7; PRAGMA user_version = 1").empty());
    CHECK(refusal(path).find("another program") != std::string::npos);
    REQUIRE(run_sql(path, "PRAGMA application_id = 0; PRAGMA user_version = 0").empty());
    CHECK(bytes_of(path).substr(100) == before.substr(100));
    CHECK(files_in(folder) == 1);
}

TEST_CASE("opening: what is no database is refused and untouched") {
    const TemporaryFolder folder;
    const std::string path = folder.file("letter.db");
    for (const std::string& content :
         {std::string("Dear teacher"), std::string(5'000, 'x'), std::string(4'096, '\0'),
          std::string("SQLite format 3\0", 16)}) {
        test::write_bytes(path, content);
        const std::string sentence = refusal(path);
        CAPTURE(sentence);
        CHECK(is_sentence_about(sentence, path));
        CHECK(sentence.find("choose another file with --db or move this one away") !=
              std::string::npos);
        CHECK(bytes_of(path) == content);
    }
    CHECK(files_in(folder) == 1);
    CHECK(is_sentence_about(refusal(folder.path()), folder.path()));
}

TEST_CASE("opening: a damaged database is refused and untouched, or read without harm") {
    const TemporaryFolder folder(TemporaryFolder::On::memory);
    const std::string path = folder.file("progress.db");
    {
        Classroom room(path);
        for (int i = 1; i <= 60; ++i) {
            REQUIRE(
                room.store->add_attempt(attempt_for(room.session.id, "heaviest", i, i % 2 == 0)));
        }
    }
    const std::string sound = bytes_of(path);
    const std::string damaged = folder.file("damaged.db");
    std::mt19937 random(11);
    int refused = 0;
    for (int round = 0; round < 120; ++round) {
        std::string bytes = sound;
        if (round % 10 == 0) {
            bytes.resize(random() % bytes.size());
        }
        for (int flips = 1 + round % 20; flips > 0 && !bytes.empty(); --flips) {
            bytes[random() % bytes.size()] = static_cast<char>(random());
        }
        test::write_bytes(damaged, bytes);
        auto opened = open_sqlite_store(damaged);
        if (!opened) {
            ++refused;
            CAPTURE(to_sentence(opened.error()));
            CHECK(is_sentence_about(to_sentence(opened.error()), damaged));
            CHECK(bytes_of(damaged) == bytes);
        } else if (const auto data = (*opened)->read({}); data) {
            CHECK_FALSE(to_text(compute_report(*data)).empty());
        } else {
            CHECK(is_sentence_about(to_sentence(data.error()), damaged));
        }
        if (opened) {
            opened->reset();
        }
        std::filesystem::remove(damaged + "-wal");
        std::filesystem::remove(damaged + "-shm");
    }
    CHECK(refused > 40);
}

TEST_CASE("opening: a folder that can't be made or written is one sentence") {
    const TemporaryFolder folder;
    test::write_bytes(folder.file("file"), "x");
    for (const std::string& path :
         {folder.file("file/progress.db"), std::string("/proc/fulcrum/progress.db"),
          std::string("/proc/progress.db"), folder.file(std::string(300, 'n'))}) {
        const std::string sentence = refusal(path);
        CAPTURE(sentence);
        CHECK(is_sentence_about(sentence, "/"));
        CHECK(sentence.find("--db") != std::string::npos);
    }
    if (geteuid() != 0) {
        const std::string path = folder.file("progress.db");
        { const Classroom room(path); }
        REQUIRE(chmod(path.c_str(), 0400) == 0);
        CHECK(refusal(path).find("can't be opened for writing") != std::string::npos);
    }
}

TEST_CASE("opening: a database that another program is writing to is waited for, then refused") {
    const TemporaryFolder folder;
    Classroom room(folder.file("progress.db"));
    sqlite::Database other(room.path, SQLITE_OPEN_READWRITE, "");
    SqliteStoreOptions hasty;
    hasty.busy_timeout_ms = 1;
    auto store = open_sqlite_store(room.path, hasty);
    REQUIRE(store);
    const AttemptRecord attempt = attempt_for(room.session.id, "heaviest", 1, true);
    other.run("BEGIN IMMEDIATE");
    CHECK(refusal(room.path, hasty).find("another program is writing") != std::string::npos);
    CHECK(test::error_text((*store)->add_attempt(attempt)).find("another program is writing") !=
          std::string::npos);
    CHECK((*store)->read({})->attempts.empty());
    other.run("ROLLBACK");
    CHECK((*store)->add_attempt(attempt));
    CHECK((*store)->read({})->attempts.size() == 1);
}

}  // namespace
}  // namespace fulcrum::runtime
