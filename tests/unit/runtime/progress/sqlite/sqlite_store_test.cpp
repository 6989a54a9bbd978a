// The sqlite store as a whole: what it was given comes back, also to another program; new databases and places.
#include "runtime/progress/sqlite/sqlite_store.h"

#include "runtime/progress/sqlite/schema.h"
#include "tests/unit/runtime/progress/progress_fixture.h"
#include "tests/unit/runtime/rig.h"

#include <sys/stat.h>
#include <unistd.h>

using namespace fulcrum::runtime::test;

namespace {

mode_t mode_of(const std::string& path) {
    struct stat status {};
    REQUIRE(stat(path.c_str(), &status) == 0);
    return status.st_mode & 0777U;
}

}  // namespace

TEST_CASE("store: what was kept is read back by another program") {
    const TemporaryFolder folder;
    const std::string path = folder.file("progress.db");
    Classroom room(path);
    AttemptRecord attempt = attempt_for(room.session.id, "heaviest", 1, true);
    attempt.said = "watermelon is most heavy";
    attempt.form_right = false;
    attempt.answer_s = 0.1 + 0.2;
    attempt.errors = {{"M:DET", "", "the"}, {"R:ADJ:FORM", "most heavy", "heaviest"}};
    const SessionEnd end{room.session.id, 2'000, EndReason::finished, 3, 120, 2};
    REQUIRE(room.store->add_attempt(attempt));
    REQUIRE(room.store->end_session(end));
    room.store.reset();

    auto again = value_of(open_sqlite_store(path));
    REQUIRE(again->keeps());
    const auto data = value_of(again->read({}));
    CHECK(data.learners == std::vector{room.learner});
    CHECK(data.sessions == std::vector{room.session});
    CHECK(data.ends == std::vector{end});
    CHECK(data.attempts == std::vector{attempt});
}

TEST_CASE("store: what turned out in a session stands behind its settings, once") {
    OwnClassroom room;
    const SessionSetting heard{room.session.id, "throat_heard", "1.20"};
    REQUIRE(room.store->add_setting(heard));
    REQUIRE(room.store->add_setting(heard));  // a repeated write
    CHECK_FALSE(room.store->add_setting({room.session.id, "throat_heard", "1.35"}));
    CHECK_FALSE(room.store->add_setting({random_record_id(), "throat_heard", "1.20"}));
    const auto data = value_of(room.store->read({}));
    REQUIRE(data.sessions.size() == 1);
    auto settings = room.session.settings;
    settings.emplace_back("throat_heard", "1.20");
    CHECK(data.sessions.front().settings == settings);
}

TEST_CASE("store: two programs write to one database in turn") {
    OwnClassroom room;
    auto second = value_of(open_sqlite_store(room.path));
    for (int i = 1; i <= 20; ++i) {
        ProgressStore& writer = i % 2 == 0 ? *second : *room.store;
        REQUIRE(writer.add_attempt(attempt_for(room.session.id, "heaviest", i, false)));
    }
    const auto data = value_of(room.store->read({}));
    REQUIRE(data.attempts.size() == 20);
    CHECK(data.attempts[19].attempt == 20);
}

TEST_CASE("store: a nickname enrols once, whatever its capitals, and is bound, not pasted") {
    OwnClassroom room;
    const auto first = room.store->enrol("  민아 ");
    const auto second = room.store->enrol("민아");
    REQUIRE(first);
    REQUIRE(second);
    CHECK(*first == *second);
    CHECK(first->nickname == "민아");
    CHECK(room.store->enrol("MINA")->id == room.learner.id);
    CHECK_FALSE(room.store->add_learner({random_record_id(), "mINA", 5}));

    const std::string robert = "Robert'); DROP TABLE learner;--";
    REQUIRE(room.store->enrol(robert));
    const auto found = value_of(room.store->read({robert, ""}));
    REQUIRE(found.learners.size() == 1);
    CHECK(found.learners[0].nickname == robert);
    CHECK(room.store->read({"' OR '1'='1", ""})->learners.empty());
    CHECK(query(room.path, "SELECT count(*) FROM learner") == "3");
}

TEST_CASE("opening: a new database is private, logged ahead and of this version") {
    const TemporaryFolder folder;
    const std::string path = folder.file("a b#%?/deep/progress.db");
    auto store = value_of(open_sqlite_store(path));
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
    CHECK(folder.entries() == 0);
    write_bytes(folder.file("empty.db"), "");
    CHECK(refusal(folder.file("empty.db")).empty());
}

TEST_CASE("opening: a folder that can't be made or written is one sentence") {
    const TemporaryFolder folder;
    write_bytes(folder.file("file"), "x");
    for (const std::string& path :
         {folder.file("file/progress.db"), std::string("/proc/fulcrum/progress.db"),
          std::string("/proc/progress.db"), folder.file(std::string(300, 'n'))}) {
        const std::string sentence = refusal(path);
        CAPTURE(sentence);
        CHECK(is_sentence_about(sentence, "/"));
        check_says(sentence, {"--db"});
    }
    if (geteuid() != 0) {
        const std::string path = folder.file("progress.db");
        { const Classroom room(path); }
        REQUIRE(chmod(path.c_str(), 0400) == 0);
        check_says(refusal(path), {"can't be opened for writing"});
    }
}

TEST_CASE("opening: a database that another program is writing to is waited for, then refused") {
    OwnClassroom room;
    sqlite::Database other(room.path, SQLITE_OPEN_READWRITE, "");
    SqliteStoreOptions hasty;
    hasty.busy_timeout_ms = 1;
    auto store = value_of(open_sqlite_store(room.path, hasty));
    const AttemptRecord attempt = attempt_for(room.session.id, "heaviest", 1, true);
    other.run("BEGIN IMMEDIATE");
    check_says(refusal(room.path, hasty), {"another program is writing"});
    check_says(error_text(store->add_attempt(attempt)), {"another program is writing"});
    CHECK(store->read({})->attempts.empty());
    other.run("ROLLBACK");
    CHECK(store->add_attempt(attempt));
    CHECK(store->read({})->attempts.size() == 1);
}
