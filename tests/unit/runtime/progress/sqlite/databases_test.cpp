#include "runtime/progress/report.h"
#include "runtime/progress/report_text.h"
#include "runtime/progress/sqlite/database.h"
#include "runtime/progress/sqlite/inspect.h"
#include "runtime/progress/sqlite/schema.h"
#include "runtime/progress/sqlite/sqlite_store.h"
#include "tests/unit/runtime/progress/progress_fixture.h"
#include "tests/unit/runtime/rig.h"

#include <random>

using namespace fulcrum::runtime::test;
using namespace fulcrum::runtime::sqlite;

namespace {

using namespace fulcrum::runtime::sqlite;
constexpr int kMake = SQLITE_OPEN_READWRITE | SQLITE_OPEN_CREATE;

// A database of that version with a learner, a session, and an attempt for each row of values behind "said".
void make_version(const std::string& path, std::size_t version,
                  std::initializer_list<std::pair<char, const char*>> attempts, char wrong,
                  const char* error) {
    Database database(path, SQLITE_OPEN_READWRITE | SQLITE_OPEN_CREATE, "");
    for (std::size_t step = 0; step < version; ++step) {
        database.run(migrations()[step]);
    }
    database.run(
        ("PRAGMA application_id = 0x46756C63; PRAGMA user_version = " + std::to_string(version))
            .c_str());
    const std::string id(32, 'a');
    Statement(database, "INSERT INTO learner VALUES(1, ?, 'Mina', 5)").bind(id).run();
    Statement(database, "INSERT INTO session VALUES(1, ?, ?, 'gravity', 'v', 'A1', 6)")
        .bind(id)
        .bind(id)
        .run();
    for (const auto& [digit, values] : attempts) {
        const std::string insert =
            std::string(
                "INSERT INTO attempt VALUES(NULL, ?, ?, 'heaviest', 1, 'an egg', 1, 0, "
                "'s', 2.5, 7") +
            values + ")";
        Statement(database, insert.c_str()).bind(std::string(32, digit)).bind(id).run();
    }
    const std::string insert =
        std::string("INSERT INTO attempt_error VALUES(?, 0, 'M:DET', '', 'the'") + error + ")";
    Statement(database, insert.c_str()).bind(std::string(32, wrong)).run();
}

// Two attempts, the second with an error.
void make_version_1(const std::string& path) {
    make_version(path, 1, {{'b', ""}, {'c', ""}}, 'c', "");
}

// Of 60 attempts, every `right_of`-th with a right answer.
void make_full(const std::string& path, int right_of) {
    Classroom room(path);
    for (int i = 1; i <= 60; ++i) {
        REQUIRE(room.store->add_attempt(
            attempt_for(room.session.id, "heaviest", i, i % right_of == 0)));
    }
}

// The sentence with which it is refused; the file stays as it was.
std::string refused_untouched(const std::string& path) {
    const std::string before = bytes_of(path);
    const std::string sentence = refusal(path);
    CHECK(is_sentence_about(sentence, path));
    CHECK(bytes_of(path) == before);
    return sentence;
}

}  // namespace

TEST_CASE("database: what is bound comes back as it was, and as what it was") {
    const TemporaryFolder folder;
    Database database(folder.file("x.db"), kMake, "");
    database.run("CREATE TABLE t(a TEXT NOT NULL, b INTEGER, c REAL) STRICT");
    const std::string nasty("'); DROP TABLE t;--\0\xF0\x9F\x8D\x89", 24);
    Statement(database, "INSERT INTO t VALUES(?, ?, ?)")
        .bind(nasty)
        .bind(std::int64_t{-9'007'199'254'740'993})
        .bind(0.1 + 0.2)
        .run();
    Statement(database, "INSERT INTO t VALUES(?, ?, ?)")
        .bind(std::string_view{})
        .bind(true)
        .bind(0.0)
        .run();
    Statement row(database, "SELECT a, b, c FROM t ORDER BY rowid");
    REQUIRE(row.step());
    CHECK(row.text() == nasty);
    CHECK(row.number() == -9'007'199'254'740'993);
    CHECK(row.real() == 0.1 + 0.2);
    REQUIRE(row.step());
    CHECK(row.text().empty());
    CHECK(row.flag());
    CHECK_FALSE(row.step());
}

TEST_CASE("database: a transaction that is not committed leaves nothing") {
    const TemporaryFolder folder;
    Database database(folder.file("x.db"), kMake, "");
    database.run("CREATE TABLE t(a)");
    for (const bool commit : {false, true}) {
        Transaction transaction(database, Transaction::Kind::write);
        database.run("INSERT INTO t VALUES(1)");
        if (commit) {
            transaction.commit();
        }
    }
    CHECK(database.number("SELECT count(*) FROM t") == 1);
}

TEST_CASE("database: what is refused becomes one sentence with the path and what to do") {
    const std::string path = "/data/progress.db";
    for (const int code :
         {SQLITE_NOTADB, SQLITE_CORRUPT, SQLITE_FULL, SQLITE_BUSY, SQLITE_READONLY, SQLITE_CANTOPEN,
          SQLITE_IOERR_FSYNC, SQLITE_NOMEM, SQLITE_CONSTRAINT_UNIQUE}) {
        const Error error = error_for(code, path, "two\nlines \x1b[2J");
        CAPTURE(code, to_sentence(error));
        CHECK(is_sentence_about(to_sentence(error), path));
        CHECK_FALSE(error.what_to_do.empty());
        check_lacks(error.message, {"lines"});
    }
    check_says(error_for(SQLITE_FULL, path, "").message, {"full"});
    check_says(error_for(SQLITE_CORRUPT_VTAB, path, "").message, {"damaged"});
    check_says(error_for(SQLITE_IOERR_FSYNC, path, "").message, {"1034"});

    const TemporaryFolder folder;
    Database database(folder.file("x.db"), kMake, "");
    CHECK(error_of(guarded([&] { database.run("SELEC 1"); })).where == folder.file("x.db"));
    CHECK(guarded([] { return 7; }) == 7);
}

TEST_CASE("store: what would be written into a file that is no longer there is refused") {
    for (const bool is_replaced : {false, true}) {
        OwnClassroom room;
        REQUIRE(room.store->add_attempt(attempt_for(room.session.id, "heaviest", 1, true)));
        std::filesystem::rename(room.path, room.path + ".away");
        if (is_replaced) {
            write_bytes(room.path, "another file");
        }
        const std::string told =
            error_text(room.store->add_attempt(attempt_for(room.session.id, "heaviest", 2, true)));
        CAPTURE(told);
        CHECK(is_sentence_about(told, room.path));
        CHECK(told.find("removed or replaced") != std::string::npos);
        // Put back it goes on.
        std::filesystem::rename(room.path + ".away", room.path);
        CHECK(room.store->add_attempt(attempt_for(room.session.id, "heaviest", 2, true)));
    }
}

TEST_CASE("database: a path may hold what means something in a URI") {
    const TemporaryFolder folder;
    const std::string path = folder.file("a?b#c%20d e\xEB\xAF\xBC.db");
    Database(path, kMake, "").run("CREATE TABLE t(a)");
    CHECK(query(path, "SELECT count(*) FROM t") == "0");
}

TEST_CASE("opening: version 1 becomes the newest and keeps every fact") {
    const TemporaryFolder folder;
    const std::string path = folder.file("progress.db");
    make_version_1(path);
    for (int times = 0; times < 2; ++times) {
        auto store = value_of(open_sqlite_store(path));
        const auto data = value_of(store->read({}));
        CHECK(data.learners == std::vector{Learner{std::string(32, 'a'), "Mina", 5}});
        REQUIRE(data.attempts.size() == 2);
        CHECK(data.attempts[0].understood);
        CHECK(data.attempts[0].said == "an egg");
        CHECK_FALSE(data.attempts[0].target_right);  // nobody knows
        CHECK(data.attempts[0].form_known);
        CHECK(data.attempts[0].confidence == 1.0);
        CHECK((data.attempts[0].feedback.empty() && data.attempts[0].uptake.empty()));
        CHECK(data.attempts[1].errors == std::vector{ErrorRecord{"M:DET", "", "the"}});
        // What later versions brought works on what version 1 kept.
        SessionRecord session{
            std::string(32, 'd'),     std::string(32, 'a'), "gravity", "", "A1", 8,
            {{"force_limit_N", "10"}}};
        CHECK(store->begin_session(session));
        CHECK(store->read({})->sessions.back() == session);
        const HandSetting hand{
            std::string(32, 'e'), std::string(32, 'a'), "udp:arm:4701", "scale", "2", 9};
        CHECK(store->add_hand_setting(hand));
        CHECK(store->read({})->hands == std::vector{hand});
        const auto results = value_of(store->read({"Mina", {}, true}));
        CHECK(results.sessions.back() == session);
        CHECK(results.attempts.empty());
        CHECK(results.hands.empty());
    }
    CHECK(query(path, "PRAGMA user_version") == "8");
    CHECK(query(path, "PRAGMA integrity_check") == "ok");
}

TEST_CASE("opening: what version 5 kept counts as heard with its form, and what comes may not") {
    const TemporaryFolder folder;
    const std::string path = folder.file("progress.db");
    make_version(path, 5, {{'a', ", 1, 1, 0.75, 'recast', ''"}}, 'a', ", 'article'");
    AttemptRecord attempt = attempt_for(std::string(32, 'a'), "heaviest", 2, true);
    AttemptRecord formed = attempt_for(std::string(32, 'a'), "heaviest", 3, false);
    formed.errors = {{"R:ADJ:FORM", "most heavy", "heaviest", "comparison", true},
                     {"M:DET", "", "the", "article"}};
    attempt.form_known = attempt.form_right = false;
    for (int times = 0; times < 2; ++times) {
        auto store = value_of(open_sqlite_store(path));
        REQUIRE(store->add_attempt(attempt));
        REQUIRE(store->add_attempt(formed));
        const auto data = value_of(store->read({}));
        REQUIRE(data.attempts.size() == 3);
        const AttemptRecord& old = data.attempts[0];
        CHECK(old.form_known);
        CHECK(old.said == "an egg");
        CHECK(old.meaning_right);
        CHECK_FALSE(old.form_right);
        CHECK(old.target_right);
        CHECK(old.confidence == 0.75);
        CHECK(old.feedback == "recast");
        CHECK(old.errors == std::vector{ErrorRecord{"M:DET", "", "the", "article"}});
        CHECK(data.attempts[1] == attempt);
        CHECK(data.attempts[2] == formed);
    }
    CHECK(query(path, "PRAGMA user_version") == std::to_string(sqlite::kSchemaVersion));
    CHECK(query(path, "PRAGMA integrity_check") == "ok");
    const auto insert = [&](const char* known) {
        return run_sql(path,
                       std::string("INSERT INTO attempt SELECT 9, hex(zeroblob(16)), session, "
                                   "question, 1, said, 1, 1, slots, 1.0, 1, 1, 1, 1.0, '', "
                                   "'', ") +
                           known + " FROM attempt WHERE row = 1");
    };
    check_says(insert("2"), {"CHECK"});
    CHECK(insert("1").empty());
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
    REQUIRE(run_sql(path, "PRAGMA user_version = 9").empty());
    check_says(refused_untouched(path), {"version 9", "update Fulcrum"});
    CHECK(folder.entries() == 1);
}

TEST_CASE("opening: a database without a column of its version is refused, not found out later") {
    const TemporaryFolder folder;
    const std::string path = folder.file("progress.db");
    { const Classroom room(path); }
    REQUIRE(run_sql(path, "ALTER TABLE attempt_error DROP COLUMN point").empty());
    check_says(refused_untouched(path), {"of version 8, but has no attempt_error.point"});
    // Of an older version that column is not asked for.
    REQUIRE(run_sql(path, "ALTER TABLE attempt_error DROP COLUMN target").empty());
    for (const char* column : {"target_right", "confidence", "feedback", "uptake", "form_known"}) {
        REQUIRE(run_sql(path, std::string("ALTER TABLE attempt DROP COLUMN ") + column).empty());
    }
    REQUIRE(run_sql(path,
                    "DROP TABLE class_card; DROP TABLE class_setting; DROP TABLE class; "
                    "DROP TABLE hand_setting; PRAGMA user_version = 2")
                .empty());
    CHECK(refusal(path).empty());
}

TEST_CASE("opening: a newer version that stands only in the log is seen, and the log untouched") {
    const TemporaryFolder folder;
    const std::string path = folder.file("progress.db");
    { const Classroom room(path); }
    const std::string crashed = folder.file("crashed.db");
    {
        sqlite::Database newer(path, SQLITE_OPEN_READWRITE, "");
        newer.run("PRAGMA user_version = 9");
        write_bytes(crashed, bytes_of(path));
        write_bytes(crashed + "-wal", bytes_of(path + "-wal"));
    }
    const std::string before = bytes_of(crashed);
    const std::string log = bytes_of(crashed + "-wal");
    REQUIRE_FALSE(log.empty());
    check_says(refusal(crashed), {"version 9"});
    CHECK(bytes_of(crashed) == before);
    CHECK(bytes_of(crashed + "-wal") == log);
}

TEST_CASE("opening: another program's database is refused and untouched") {
    const TemporaryFolder folder;
    const std::string path = folder.file("photos.db");
    write_bytes(path, "");
    REQUIRE(run_sql(path, "CREATE TABLE photo(x)").empty());
    const std::string before = bytes_of(path);
    check_says(refusal(path), {"another program"});
    REQUIRE(run_sql(path, "PRAGMA application_id = 7; PRAGMA user_version = 1").empty());
    check_says(refusal(path), {"another program"});
    REQUIRE(run_sql(path, "PRAGMA application_id = 0; PRAGMA user_version = 0").empty());
    CHECK(bytes_of(path).substr(100) == before.substr(100));
    CHECK(folder.entries() == 1);
}

TEST_CASE("opening: what is no database is refused and untouched") {
    const TemporaryFolder folder;
    const std::string path = folder.file("letter.db");
    for (const std::string& content :
         {std::string("Dear teacher"), std::string(5'000, 'x'), std::string(4'096, '\0'),
          std::string("SQLite format 3\0", 16)}) {
        write_bytes(path, content);
        check_says(refused_untouched(path),
                   {"choose another file with --db or move this one away"});
    }
    CHECK(folder.entries() == 1);
    CHECK(is_sentence_about(refusal(folder.path()), folder.path()));
}

TEST_CASE("opening: a page that was overwritten is noticed, wherever it lies") {
    constexpr std::size_t kPage = 4096;
    const TemporaryFolder folder(TemporaryFolder::On::memory);
    const std::string path = folder.file("progress.db");
    make_full(path, 1);
    const std::string sound = bytes_of(path);
    REQUIRE(query(path, "PRAGMA page_size") == std::to_string(kPage));
    REQUIRE(query(path, "PRAGMA freelist_count") == "0");
    const std::string damaged = folder.file("damaged.db");
    for (std::size_t page = kPage; page < sound.size(); page += kPage) {
        std::string bytes = sound;
        bytes.replace(page, kPage, kPage, '\x5a');
        write_bytes(damaged, bytes);
        CAPTURE(page / kPage);
        check_says(refusal(damaged), {"is damaged"});
        CHECK(bytes_of(damaged) == bytes);
    }
}

TEST_CASE("opening: a damaged database is refused and untouched, or read without harm") {
    const TemporaryFolder folder(TemporaryFolder::On::memory);
    const std::string path = folder.file("progress.db");
    make_full(path, 2);
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
        write_bytes(damaged, bytes);
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
