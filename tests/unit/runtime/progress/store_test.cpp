// The sqlite store keeps what it is given, once; the null store plays along.
#include "runtime/progress/store.h"

#include "runtime/progress/sqlite/sqlite_store.h"
#include "tests/unit/runtime/progress/progress_fixture.h"

#include <catch2/catch.hpp>

#include <limits>

namespace fulcrum::runtime {
namespace {

using test::attempt_for;
using test::Classroom;
using test::error_text;
using test::TemporaryFolder;

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

    auto again = open_sqlite_store(path);
    REQUIRE(again);
    REQUIRE((*again)->keeps());
    const auto data = (*again)->read({});
    REQUIRE(data);
    CHECK(data->learners == std::vector{room.learner});
    CHECK(data->sessions == std::vector{room.session});
    CHECK(data->ends == std::vector{end});
    CHECK(data->attempts == std::vector{attempt});
}

TEST_CASE("store: a repeated write leaves one record and is acknowledged") {
    const TemporaryFolder folder;
    Classroom room(folder.file("progress.db"));
    AttemptRecord attempt = attempt_for(room.session.id, "heaviest", 1, false);
    attempt.errors = {{"M:DET", "", "the"}};
    const SessionEnd end{room.session.id, 2'000, EndReason::left, 0, 0, 1};
    for (int i = 0; i < 3; ++i) {
        CHECK(room.store->add_learner(room.learner));
        CHECK(room.store->begin_session(room.session));
        CHECK(room.store->add_attempt(attempt));
        CHECK(room.store->end_session(end));
    }
    const auto data = room.store->read({});
    REQUIRE(data);
    CHECK(data->learners.size() == 1);
    CHECK(data->sessions.size() == 1);
    CHECK(data->attempts == std::vector{attempt});
    CHECK(data->ends.size() == 1);
}

TEST_CASE("store: other content under a kept id is refused and changes nothing") {
    const TemporaryFolder folder;
    Classroom room(folder.file("progress.db"));
    AttemptRecord attempt = attempt_for(room.session.id, "heaviest", 1, false);
    attempt.errors = {{"M:DET", "", "the"}};
    REQUIRE(room.store->add_attempt(attempt));

    AttemptRecord other = attempt;
    other.meaning_right = true;
    CHECK(error_text(room.store->add_attempt(other)).find("under this id") != std::string::npos);
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

    const auto data = room.store->read({});
    REQUIRE(data);
    CHECK(data->attempts == std::vector{attempt});
    CHECK(data->sessions == std::vector{room.session});
    CHECK(data->ends == std::vector{end});
}

TEST_CASE("store: an attempt whose errors cannot be kept is not kept either") {
    const TemporaryFolder folder;
    Classroom room(folder.file("progress.db"));
    test::run_sql(room.path,
                  "CREATE TRIGGER t BEFORE INSERT ON attempt_error WHEN NEW.position = 1"
                  " BEGIN SELECT RAISE(ABORT, 'no second error'); END");
    AttemptRecord attempt = attempt_for(room.session.id, "heaviest", 1, false);
    attempt.errors = {{"M:DET", "", "the"}, {"R:ADJ:FORM", "most heavy", "heaviest"}};
    const std::string sentence = error_text(room.store->add_attempt(attempt));
    CHECK(sentence.find("no second error") != std::string::npos);
    CHECK(room.store->read({})->attempts.empty());
    CHECK(test::query(room.path, "SELECT count(*) FROM attempt_error") == "0");
}

TEST_CASE("store: a record whose owner is unknown is refused") {
    const TemporaryFolder folder;
    Classroom room(folder.file("progress.db"));
    SessionRecord stray = room.session;
    stray.id = random_record_id();
    stray.learner = random_record_id();
    CHECK(error_text(room.store->begin_session(stray)).find("is not known") != std::string::npos);
    CHECK_FALSE(room.store->add_attempt(attempt_for(random_record_id(), "heaviest", 1, true)));
    CHECK_FALSE(room.store->end_session({random_record_id(), 0, EndReason::finished, 1, 1, 1}));
}

TEST_CASE("store: facts can't be changed, even by SQL") {
    const TemporaryFolder folder;
    Classroom room(folder.file("progress.db"));
    REQUIRE(room.store->add_attempt(attempt_for(room.session.id, "heaviest", 1, false)));
    CHECK(test::run_sql(room.path, "UPDATE attempt SET meaning_right = 1").find("never changed") !=
          std::string::npos);
    CHECK_FALSE(test::run_sql(room.path, "UPDATE learner SET nickname = 'x'").empty());
    CHECK_FALSE(test::run_sql(room.path, "UPDATE session SET level = 'C2'").empty());
    CHECK(test::query(room.path, "SELECT meaning_right FROM attempt") == "0");
}

TEST_CASE("store: a nickname enrols once, whatever its capitals, and is bound, not pasted") {
    const TemporaryFolder folder;
    Classroom room(folder.file("progress.db"));
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
    const auto found = room.store->read({robert, ""});
    REQUIRE(found);
    REQUIRE(found->learners.size() == 1);
    CHECK(found->learners[0].nickname == robert);
    CHECK(room.store->read({"' OR '1'='1", ""})->learners.empty());
    CHECK(test::query(room.path, "SELECT count(*) FROM learner") == "3");
}

TEST_CASE("store: an odd answer is mended and kept, not lost") {
    const TemporaryFolder folder;
    Classroom room(folder.file("progress.db"));
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
    const TemporaryFolder folder;
    Classroom room(folder.file("progress.db"));
    const auto other = room.store->enrol("Joon");
    REQUIRE(other);
    const SessionRecord kite{random_record_id(), other->id, "kite", "", "A1", 5'000, {}};
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

TEST_CASE("store: two programs write to one database in turn") {
    const TemporaryFolder folder;
    Classroom room(folder.file("progress.db"));
    auto second = open_sqlite_store(room.path);
    REQUIRE(second);
    for (int i = 1; i <= 20; ++i) {
        ProgressStore& writer = i % 2 == 0 ? **second : *room.store;
        REQUIRE(writer.add_attempt(attempt_for(room.session.id, "heaviest", i, false)));
    }
    const auto data = room.store->read({});
    REQUIRE(data);
    REQUIRE(data->attempts.size() == 20);
    CHECK(data->attempts[19].attempt == 20);
}

TEST_CASE("store: bad records are refused in one sentence by either store") {
    const TemporaryFolder folder;
    Classroom room(folder.file("progress.db"));
    const auto null_store = make_null_store();
    CHECK_FALSE(null_store->keeps());
    for (ProgressStore* store : {room.store.get(), null_store.get()}) {
        AttemptRecord attempt = attempt_for(room.session.id, "heaviest", 0, true);
        CHECK(error_text(store->add_attempt(attempt)).find("count attempts from 1") !=
              std::string::npos);
        attempt.attempt = 1;
        attempt.answer_s = std::numeric_limits<double>::quiet_NaN();
        CHECK_FALSE(store->add_attempt(attempt));
        attempt.answer_s = -1.0;
        CHECK_FALSE(store->add_attempt(attempt));
        attempt.answer_s = 1.0;
        attempt.errors = {{"", "a", "b"}};
        CHECK_FALSE(store->add_attempt(attempt));
        attempt.errors.clear();
        attempt.id = "1234";
        CHECK_FALSE(store->add_attempt(attempt));
        CHECK_FALSE(store->end_session({room.session.id, 0, EndReason::finished, 4, 0, 1}));
        CHECK_FALSE(store->end_session({room.session.id, 0, EndReason::finished, 0, 0, 0}));
        SessionRecord session = room.session;
        session.id = random_record_id();
        session.settings = {{"a", "1"}, {"a", "2"}};
        CHECK_FALSE(store->begin_session(session));
        session.settings.clear();
        session.lesson.clear();
        CHECK_FALSE(store->begin_session(session));
        CHECK_FALSE(store->enrol("\n"));
        CHECK_FALSE(store->add_learner({random_record_id(), " blank ", 0}));
    }
    CHECK(room.store->read({})->attempts.empty());
}

TEST_CASE("store: the null store takes a whole lesson and keeps nothing") {
    const auto store = make_null_store();
    const auto learner = store->enrol("Mina");
    REQUIRE(learner);
    CHECK(is_record_id(learner->id));
    const SessionRecord session{random_record_id(), learner->id, "gravity", "", "A1", 0, {}};
    CHECK(store->begin_session(session));
    CHECK(store->add_attempt(attempt_for(session.id, "heaviest", 1, true)));
    CHECK(store->end_session({session.id, 1, EndReason::finished, 3, 9, 1}));
    CHECK(store->read({})->learners.empty());
}

}  // namespace
}  // namespace fulcrum::runtime
