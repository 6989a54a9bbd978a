// Writing: once, all of a record or nothing, and never again; reading: all that a filter matches, each column in its own field.
#include "runtime/progress/sqlite/queries.h"

#include "tests/unit/runtime/progress/progress_fixture.h"
#include "tests/unit/runtime/rig.h"

using namespace fulcrum::runtime::test;

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
