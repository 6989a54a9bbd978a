// Writing: once, all of a record or nothing, and never again.
#include "runtime/progress/sqlite/queries.h"

#include "tests/unit/runtime/progress/progress_fixture.h"

#include <catch2/catch.hpp>

namespace fulcrum::runtime {
namespace {

using test::attempt_for;
using test::Classroom;
using test::error_text;
using test::TemporaryFolder;

TEST_CASE("store: a repeated write leaves one record and is acknowledged") {
    const TemporaryFolder folder;
    Classroom room(folder.file("progress.db"));
    AttemptRecord attempt = attempt_for(room.session.id, "heaviest", 1, false);
    attempt.errors = {{"M:DET", "", "the", "article"}};
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

TEST_CASE("store: how a hand is set is kept for its learner, each time beside the last") {
    const TemporaryFolder folder;
    Classroom room(folder.file("progress.db"));
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
    CHECK(error_text(room.store->add_hand_setting(changed)).find("under this id") !=
          std::string::npos);
    CHECK_FALSE(room.store->add_hand_setting(
        {random_record_id(), random_record_id(), arm, "scale", "1", 1}));
    CHECK_FALSE(room.store->add_hand_setting({random_record_id(), other.id, arm, "", "1", 1}));
    CHECK_FALSE(room.store->add_hand_setting({"short", other.id, arm, "scale", "1", 1}));
    CHECK_FALSE(
        test::run_sql(folder.file("progress.db"), "UPDATE hand_setting SET value = '9'").empty());
    CHECK(room.store->read({"Mina", {}})->hands == kept);
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

}  // namespace
}  // namespace fulcrum::runtime
