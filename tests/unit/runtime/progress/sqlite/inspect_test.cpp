// The look before opening: what is refused, and that it stays as it was.
#include "runtime/progress/sqlite/inspect.h"

#include "runtime/progress/report.h"
#include "runtime/progress/sqlite/sqlite_store.h"
#include "tests/unit/runtime/progress/progress_fixture.h"
#include "tests/unit/runtime/rig.h"

#include <random>

using namespace fulcrum::runtime::test;

namespace {

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

TEST_CASE("opening: a newer database is refused and untouched") {
    const TemporaryFolder folder;
    const std::string path = folder.file("progress.db");
    { const Classroom room(path); }
    REQUIRE(run_sql(path, "PRAGMA user_version = 8").empty());
    check_says(refused_untouched(path), {"version 8", "update Fulcrum"});
    CHECK(folder.entries() == 1);
}

TEST_CASE("opening: a database without a column of its version is refused, not found out later") {
    const TemporaryFolder folder;
    const std::string path = folder.file("progress.db");
    { const Classroom room(path); }
    REQUIRE(run_sql(path, "ALTER TABLE attempt_error DROP COLUMN point").empty());
    check_says(refused_untouched(path), {"of version 7, but has no attempt_error.point"});
    // Of an older version that column is not asked for.
    REQUIRE(run_sql(path, "ALTER TABLE attempt_error DROP COLUMN target").empty());
    for (const char* column : {"target_right", "confidence", "feedback", "uptake", "form_known"}) {
        REQUIRE(run_sql(path, std::string("ALTER TABLE attempt DROP COLUMN ") + column).empty());
    }
    REQUIRE(run_sql(path, "DROP TABLE hand_setting; PRAGMA user_version = 2").empty());
    CHECK(refusal(path).empty());
}

TEST_CASE("opening: a newer version that stands only in the log is seen, and the log untouched") {
    const TemporaryFolder folder;
    const std::string path = folder.file("progress.db");
    { const Classroom room(path); }
    const std::string crashed = folder.file("crashed.db");
    {
        sqlite::Database newer(path, SQLITE_OPEN_READWRITE, "");
        newer.run("PRAGMA user_version = 8");
        write_bytes(crashed, bytes_of(path));
        write_bytes(crashed + "-wal", bytes_of(path + "-wal"));
    }
    const std::string before = bytes_of(crashed);
    const std::string log = bytes_of(crashed + "-wal");
    REQUIRE_FALSE(log.empty());
    check_says(refusal(crashed), {"version 8"});
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
