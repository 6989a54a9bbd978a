// The hold on sqlite: values are never SQL, transactions are whole, errors are sentences.
#include "runtime/progress/sqlite/database.h"

#include "tests/unit/runtime/progress/progress_fixture.h"
#include "tests/unit/runtime/rig.h"

using namespace fulcrum::runtime::test;

namespace {

using namespace fulcrum::runtime::sqlite;
constexpr int kMake = SQLITE_OPEN_READWRITE | SQLITE_OPEN_CREATE;

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

TEST_CASE("database: a path may hold what means something in a URI") {
    const TemporaryFolder folder;
    const std::string path = folder.file("a?b#c%20d e\xEB\xAF\xBC.db");
    Database(path, kMake, "").run("CREATE TABLE t(a)");
    CHECK(query(path, "SELECT count(*) FROM t") == "0");
}
