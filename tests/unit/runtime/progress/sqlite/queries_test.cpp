#include "runtime/progress/sqlite/queries.h"

#include "runtime/progress/sqlite/schema.h"
#include "runtime/progress/sqlite/sqlite_store.h"
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

TEST_CASE("store: a repeated write leaves one record and is acknowledged") {
    OwnClassroom room;
    AttemptRecord attempt = attempt_for(room.session.id, "heaviest", 1, false);
    attempt.errors = {{"M:DET", "", "the", "article"}};
    const SessionEnd end{room.session.id, 2'000, EndReason::left, 0, 0, 1};
    for (int i = 0; i < 3; ++i) {
        CHECK(room.store->add_learner(room.learner));
        CHECK(room.store->begin_session(room.session));
        CHECK(room.store->add_attempt(attempt));
        CHECK(room.store->end_session(end));
    }
    const auto data = value_of(room.store->read({}));
    CHECK(data.learners.size() == 1);
    CHECK(data.sessions.size() == 1);
    CHECK(data.attempts == std::vector{attempt});
    CHECK(data.ends.size() == 1);
}

TEST_CASE("store: how a hand is set is kept for its learner, each time beside the last") {
    OwnClassroom room;
    const Learner other = *room.store->enrol("Jun");
    const std::string arm = "udp:arm:4701";
    const std::vector<HandSetting> kept = {
        {random_record_id(), room.learner.id, arm, "scale", "2", 1},
        {random_record_id(), room.learner.id, arm, "scale", "1.5", 2},
        {random_record_id(), room.learner.id, "", "handed", "left", 3}};
    for (const HandSetting& setting : kept) {
        CHECK(room.store->add_hand_setting(setting));
        CHECK(room.store->add_hand_setting(setting));  // a repeated write leaves one
    }
    REQUIRE(room.store->add_hand_setting({random_record_id(), other.id, arm, "scale", "3", 4}));
    CHECK(room.store->read({"Mina", {}})->hands == kept);
    CHECK(room.store->read({"mina", "no such lesson"})->hands == kept);
    CHECK(room.store->read({"Jun", {}})->hands.size() == 1);
    // Refused: other content under an id, a learner whom nobody knows, no name, no id.
    HandSetting changed = kept[0];
    changed.value = "9";
    check_says(error_text(room.store->add_hand_setting(changed)), {"under this id"});
    CHECK_FALSE(room.store->add_hand_setting(
        {random_record_id(), random_record_id(), arm, "scale", "1", 1}));
    CHECK_FALSE(room.store->add_hand_setting({random_record_id(), other.id, arm, "", "1", 1}));
    CHECK_FALSE(room.store->add_hand_setting({"short", other.id, arm, "scale", "1", 1}));
    CHECK_FALSE(run_sql(room.path, "UPDATE hand_setting SET value = '9'").empty());
    CHECK(room.store->read({"Mina", {}})->hands == kept);
}

TEST_CASE("store: other content under a kept id is refused and changes nothing") {
    OwnClassroom room;
    AttemptRecord attempt = attempt_for(room.session.id, "heaviest", 1, false);
    attempt.errors = {{"M:DET", "", "the"}};
    REQUIRE(room.store->add_attempt(attempt));

    AttemptRecord other = attempt;
    other.meaning_right = true;
    check_says(error_text(room.store->add_attempt(other)), {"under this id"});
    other = attempt;
    other.errors[0].correction = "a";
    CHECK_FALSE(room.store->add_attempt(other));
    SessionRecord session = room.session;
    session.settings[0].second = "9";
    CHECK_FALSE(room.store->begin_session(session));
    const SessionEnd end{room.session.id, 2'000, EndReason::finished, 3, 120, 2};
    REQUIRE(room.store->end_session(end));
    SessionEnd better = end;
    better.score = 999;
    CHECK_FALSE(room.store->end_session(better));

    const auto data = value_of(room.store->read({}));
    CHECK(data.attempts == std::vector{attempt});
    CHECK(data.sessions == std::vector{room.session});
    CHECK(data.ends == std::vector{end});
}

TEST_CASE("store: an attempt whose errors cannot be kept is not kept either") {
    OwnClassroom room;
    run_sql(room.path,
            "CREATE TRIGGER t BEFORE INSERT ON attempt_error WHEN NEW.position = 1"
            " BEGIN SELECT RAISE(ABORT, 'no second error'); END");
    AttemptRecord attempt = attempt_for(room.session.id, "heaviest", 1, false);
    attempt.errors = {{"M:DET", "", "the"}, {"R:ADJ:FORM", "most heavy", "heaviest"}};
    const std::string sentence = error_text(room.store->add_attempt(attempt));
    check_says(sentence, {"no second error"});
    CHECK(room.store->read({})->attempts.empty());
    CHECK(query(room.path, "SELECT count(*) FROM attempt_error") == "0");
}

TEST_CASE("store: a record whose owner is unknown is refused") {
    OwnClassroom room;
    SessionRecord stray = room.session;
    stray.id = random_record_id();
    stray.learner = random_record_id();
    check_says(error_text(room.store->begin_session(stray)), {"is not known"});
    CHECK_FALSE(room.store->add_attempt(attempt_for(random_record_id(), "heaviest", 1, true)));
    CHECK_FALSE(room.store->end_session({random_record_id(), 0, EndReason::finished, 1, 1, 1}));
}

TEST_CASE("store: facts can't be changed, even by SQL") {
    OwnClassroom room;
    REQUIRE(room.store->add_attempt(attempt_for(room.session.id, "heaviest", 1, false)));
    check_says(run_sql(room.path, "UPDATE attempt SET meaning_right = 1"), {"never changed"});
    CHECK_FALSE(run_sql(room.path, "UPDATE learner SET nickname = 'x'").empty());
    CHECK_FALSE(run_sql(room.path, "UPDATE session SET level = 'C2'").empty());
    CHECK(query(room.path, "SELECT meaning_right FROM attempt") == "0");
}

TEST_CASE("store: an odd answer is mended and kept, not lost") {
    OwnClassroom room;
    AttemptRecord attempt = attempt_for(room.session.id, "heaviest", 1, false);
    attempt.said = std::string("a\0b\x1b[2J\xff", 8);
    attempt.said.append(10'000, 'z');
    REQUIRE(room.store->add_attempt(attempt));
    REQUIRE(room.store->add_attempt(attempt));
    const auto data = room.store->read({});
    REQUIRE(data->attempts.size() == 1);
    const std::string& said = data->attempts[0].said;
    CHECK(said.size() == 4'000);
    CHECK(said.substr(0, 10) == "a b [2J\xEF\xBF\xBD");
}

TEST_CASE("store: filters take a learner, a lesson, or both") {
    OwnClassroom room;
    const auto other = value_of(room.store->enrol("Joon"));
    const SessionRecord kite{random_record_id(), other.id, "kite", "", "A1", 5'000, {}};
    REQUIRE(room.store->begin_session(kite));
    REQUIRE(room.store->add_attempt(attempt_for(room.session.id, "heaviest", 1, true)));
    REQUIRE(room.store->add_attempt(attempt_for(kite.id, "lift", 1, true)));
    REQUIRE(room.store->end_session({kite.id, 6'000, EndReason::finished, 1, 1, 1}));

    CHECK(room.store->read({"joon", ""})->attempts[0].question == "lift");
    CHECK(room.store->read({"joon", ""})->learners.size() == 1);
    CHECK(room.store->read({"", "gravity"})->attempts[0].question == "heaviest");
    CHECK(room.store->read({"", "gravity"})->ends.empty());
    CHECK(room.store->read({"", "gravity"})->learners.size() == 2);
    CHECK(room.store->read({"joon", "gravity"})->sessions.empty());
    CHECK(room.store->read({"", ""})->attempts.size() == 2);
}

TEST_CASE("store: lists come back with their owners, in the order of their writing") {
    OwnClassroom room;
    std::vector<AttemptRecord> attempts;
    for (int i = 1; i <= 30; ++i) {
        attempts.push_back(attempt_for(room.session.id, "heaviest", i, false));
        for (int error = 0; error < i % 4; ++error) {
            attempts.back().errors.push_back({"CODE", std::to_string(i), std::to_string(error)});
        }
        REQUIRE(room.store->add_attempt(attempts.back()));
    }
    CHECK(room.store->read({})->attempts == attempts);
}

TEST_CASE("store: a table that is gone is one sentence") {
    OwnClassroom room;
    REQUIRE(run_sql(room.path, "DROP TABLE session_end").empty());
    CHECK(is_sentence_about(refusal_of(room.store->read({})), room.path));
}

TEST_CASE("rows: an attempt's four verdicts, and what came of it, are not mixed up") {
    OwnClassroom room;
    for (unsigned bits = 0; bits < 16; ++bits) {
        AttemptRecord attempt =
            attempt_for(room.session.id, "q", 1 + static_cast<int>(bits), false);
        attempt.understood = (bits & 1U) != 0;
        attempt.meaning_right = (bits & 2U) != 0;
        attempt.form_right = (bits & 4U) != 0;
        attempt.target_right = (bits & 8U) != 0;
        attempt.confidence = 0.0625 * bits;
        attempt.feedback = "prompt";
        attempt.uptake = "repaired";
        REQUIRE(room.store->add_attempt(attempt));
        CHECK(room.store->read({})->attempts.back() == attempt);
        attempt.id = random_record_id();
        attempt.form_known = attempt.form_right = attempt.target_right = false;
        REQUIRE(room.store->add_attempt(attempt));
        CHECK(room.store->read({})->attempts.back() == attempt);
    }
}

TEST_CASE("rows: a session's and an end's numbers and texts are not mixed up") {
    OwnClassroom room;
    for (int i = 0; i < 3; ++i) {
        const SessionRecord session{
            random_record_id(),      room.learner.id, "lesson", "version", "B2", -7 - i,
            {{"z", "1"}, {"a", "2"}}};
        const SessionEnd end{session.id, 1'000 + i, static_cast<EndReason>(i), i, -40 - i, 5 + i};
        REQUIRE(room.store->begin_session(session));
        REQUIRE(room.store->end_session(end));
        CHECK(room.store->read({})->sessions.back() == session);
        CHECK(room.store->read({})->ends.back() == end);
    }
}

TEST_CASE("store: the null store takes a whole lesson and keeps nothing") {
    const auto store = make_null_store();
    const auto learner = value_of(store->enrol("Mina"));
    CHECK(is_record_id(learner.id));
    const SessionRecord session{random_record_id(), learner.id, "gravity", "", "A1", 0, {}};
    CHECK(store->begin_session(session));
    CHECK(store->add_attempt(attempt_for(session.id, "heaviest", 1, true)));
    CHECK(store->end_session({session.id, 1, EndReason::finished, 3, 9, 1}));
    CHECK(store->read({})->learners.empty());
}

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

TEST_CASE("store: a name means its learner however it is written, and two kept names stay two") {
    OwnClassroom room;
    const Learner jose = value_of(room.store->enrol("Jose\u0301  B"));
    CHECK(jose.nickname == "José  B");
    for (const char* same : {"José B", "JOSÉ b", " jose\u0301\u00A0b "}) {
        CAPTURE(same);
        CHECK(value_of(room.store->enrol(same)) == jose);
        const auto read = value_of(room.store->read({same, ""}));
        REQUIRE(read.learners.size() == 1);
        CHECK(read.learners[0] == jose);
    }
    CHECK(value_of(room.store->enrol("Jose B")).id != jose.id);

    // An older program kept these apart: each is found by its own name, and another spelling means the first.
    const std::vector<Learner> kept{{random_record_id(), "Ünal", 1},
                                    {random_record_id(), "ünal", 2},
                                    {random_record_id(), "Zoe\u0308", 3},
                                    {random_record_id(), "Zoë", 4}};
    for (const Learner& learner : kept) {
        REQUIRE(room.store->add_learner(learner));
    }
    for (const Learner& learner : kept) {
        CHECK(value_of(room.store->enrol(learner.nickname)) == learner);
        CHECK(value_of(room.store->read({learner.nickname, ""})).learners ==
              std::vector<Learner>{learner});
    }
    CHECK(value_of(room.store->enrol("u\u0308nal")) == kept[1]);
    CHECK(value_of(room.store->enrol("ÜNAL")) == kept[0]);
    CHECK(value_of(room.store->enrol("ZOË")) == kept[2]);
    CHECK(value_of(room.store->read({})).learners.size() == 7);
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
