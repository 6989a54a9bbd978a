// Older databases are brought up, wholly or not at all.
#include "runtime/progress/sqlite/schema.h"

#include "runtime/progress/sqlite/sqlite_store.h"
#include "tests/unit/runtime/progress/progress_fixture.h"
#include "tests/unit/runtime/rig.h"

using namespace fulcrum::runtime::test;
using namespace fulcrum::runtime::sqlite;

namespace {

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

}  // namespace

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
    }
    CHECK(query(path, "PRAGMA user_version") == "7");
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
