#include "runtime/lesson/session_log.h"

#include "tests/unit/runtime/lesson/session_fixture.h"

#include <catch2/catch.hpp>

#include <deque>

using namespace fulcrum;
using namespace fulcrum::runtime;
using namespace fulcrum::runtime::test;

namespace {

SessionRecord some_session() {
    SessionRecord session;
    session.id = random_record_id();
    session.lesson = "two";
    return session;
}

MarkedAnswer some_answer() {
    MarkedAnswer answer;
    answer.question = "heaviest";
    answer.mark.said = "apple is most heavy";
    answer.mark.understood = true;
    answer.mark.slots = {{"thing", "apple"}, {"other", "egg"}};
    answer.mark.form_errors.resize(1);
    answer.mark.form_errors[0].code = dialogue::ErrorCode::adjective_form;
    answer.mark.form_errors[0].said = "most heavy";
    answer.mark.form_errors[0].right = "heaviest";
    answer.feedback.attempt = 3;
    answer.feedback.kind = dialogue::FeedbackKind::rule;
    answer.feedback.uptake = dialogue::Uptake::not_repaired;
    answer.mark.confidence = 0.75;
    answer.right = true;
    answer.answer_s = 2.5;
    return answer;
}

MarkedAnswer some_free_answer() {
    MarkedAnswer answer;
    answer.question = "heaviest";
    answer.mark.said = "I think apple more heavier";
    answer.feedback.attempt = 1;
    answer.feedback.kind = dialogue::FeedbackKind::not_understood;
    answer.feedback.free_errors = {
        {dialogue::ErrorCode::missing_determiner, 8, 8, "", "an"},
        {dialogue::ErrorCode::adjective_form, 14, 26, "more heavier", "heavier"}};
    return answer;
}

// Takes everything in and tells later that one write was not kept.
class LateStore final : public ProgressStore {
  public:
    [[nodiscard]] bool keeps() const noexcept override { return true; }
    [[nodiscard]] Expected<Learner> enrol(std::string_view) override { return Learner{}; }
    [[nodiscard]] Expected<void> add_learner(const Learner&) override { return {}; }
    [[nodiscard]] Expected<void> begin_session(const SessionRecord&) override { return {}; }
    [[nodiscard]] Expected<void> add_setting(const SessionSetting&) override { return {}; }
    [[nodiscard]] Expected<void> add_hand_setting(const HandSetting&) override { return {}; }
    [[nodiscard]] Expected<void> end_session(const SessionEnd&) override { return {}; }
    [[nodiscard]] Expected<void> add_attempt(const AttemptRecord&) override { return {}; }
    [[nodiscard]] Expected<ProgressData> read(const ProgressFilter&) override {
        return ProgressData{};
    }
    [[nodiscard]] std::optional<Error> take_trouble() override {
        return std::exchange(trouble, std::nullopt);
    }
    [[nodiscard]] Expected<void> settle(double) override { return settled; }

    std::optional<Error> trouble;
    Expected<void> settled{};
};

}  // namespace

TEST_CASE("session log: what the rules of English find is kept with its point of grammar") {
    MemoryStore store;
    SessionLog log(store, some_session());
    log.keep_attempt(some_free_answer());
    REQUIRE(store.data.attempts.size() == 1);
    const AttemptRecord& attempt = store.data.attempts[0];
    CHECK_FALSE(attempt.understood);
    CHECK_FALSE(attempt.form_right);
    CHECK(attempt.errors ==
          std::vector<ErrorRecord>{{"M:DET", "", "an", "article"},
                                   {"R:ADJ:FORM", "more heavier", "heavier", "comparison"}});
    CHECK(validate(attempt));
}

TEST_CASE("session log: an error is kept as it is read without its sentence") {
    MemoryStore store;
    SessionLog log(store, some_session());
    MarkedAnswer answer = some_answer();
    dialogue::FormError& error = answer.mark.form_errors[0];
    error.code = dialogue::ErrorCode::wrong_preposition;
    error.passive = true;
    error.said = "by";
    error.right = "of";
    log.keep_attempt(answer);
    error.code = dialogue::ErrorCode::missing_preposition;
    error.said = "";
    log.keep_attempt(answer);
    error.code = dialogue::ErrorCode::word_order;
    error.passive = false;
    error.right = "is";
    error.phrase = "is the heaviest";
    log.keep_attempt(answer);
    REQUIRE(store.data.attempts.size() == 3);
    const auto kept = [&](std::size_t i) { return store.data.attempts[i].errors.at(0); };
    CHECK(kept(0) == ErrorRecord{"R:PREP", "made by", "made of", "preposition"});
    CHECK(kept(1) == ErrorRecord{"M:PREP", "made", "made of", "preposition"});
    CHECK(kept(2) == ErrorRecord{"R:WO", "", "is the heaviest", "wording"});
}

TEST_CASE("session log: beginning, answers and end are kept as they were") {
    MemoryStore store;
    const SessionRecord session = some_session();
    SessionLog log(store, session);
    log.keep_attempt(some_answer());
    log.keep_end(EndReason::finished, 2, 9, 3);
    log.keep_end(EndReason::left, 0, 0, 0);  // once is enough

    REQUIRE(store.data.sessions.size() == 1);
    CHECK(store.data.sessions[0] == session);
    REQUIRE(store.data.attempts.size() == 1);
    const AttemptRecord& attempt = store.data.attempts[0];
    CHECK(attempt.session == session.id);
    CHECK(is_record_id(attempt.id));
    CHECK(attempt.question == "heaviest");
    CHECK(attempt.said == "apple is most heavy");
    CHECK(attempt.slots == "thing=apple other=egg");
    CHECK(attempt.attempt == 3);
    CHECK(attempt.meaning_right);
    CHECK_FALSE(attempt.form_right);
    CHECK(attempt.target_right);  // the error is none of the taught form's
    CHECK(attempt.confidence == 0.75);
    CHECK(attempt.feedback == "rule");
    CHECK(attempt.uptake == "not_repaired");
    CHECK(attempt.answer_s == 2.5);
    REQUIRE(attempt.errors.size() == 1);
    CHECK(attempt.errors[0].span == "most heavy");
    CHECK(attempt.errors[0].correction == "heaviest");
    CHECK(attempt.errors[0].code == "R:ADJ:FORM");
    CHECK_FALSE(attempt.errors[0].point.empty());
    CHECK_FALSE(attempt.errors[0].target);
    REQUIRE(store.data.ends.size() == 1);
    CHECK(store.data.ends[0].reason == EndReason::finished);
    CHECK(store.data.ends[0].stars == 2);
    CHECK(store.data.ends[0].score == 9);
    CHECK(store.data.ends[0].level_reached == 3);
    CHECK(log.trouble().empty());
}

TEST_CASE("session log: an error of the taught form is kept as such") {
    MemoryStore store;
    SessionLog log(store, some_session());
    MarkedAnswer answer = some_answer();
    answer.mark.form_errors.resize(2);
    answer.mark.form_errors[1].code = dialogue::ErrorCode::missing_determiner;
    answer.mark.form_errors[0].target = true;
    log.keep_attempt(answer);
    const AttemptRecord& attempt = store.data.attempts.at(0);
    CHECK_FALSE(attempt.target_right);
    CHECK(attempt.errors.at(0).target);
    CHECK_FALSE(attempt.errors.at(1).target);
}

TEST_CASE("session log: where the meaning alone was heard, that is kept, and nothing of the form") {
    MemoryStore store;
    SessionLog log(store, some_session());
    MarkedAnswer answer = some_answer();
    log.keep_attempt(answer);
    answer.mark = without_form(std::move(answer.mark));
    log.keep_attempt(answer);
    REQUIRE(store.data.attempts.size() == 2);
    CHECK(store.data.attempts[0].form_known);
    const AttemptRecord& attempt = store.data.attempts[1];
    CHECK_FALSE(attempt.form_known);
    CHECK(attempt.meaning_right);
    CHECK_FALSE(attempt.form_right);
    CHECK_FALSE(attempt.target_right);
    CHECK(attempt.errors.empty());
    CHECK(attempt.confidence == 0.75);
    CHECK(validate(attempt));
}

TEST_CASE(
    "session log: a write that is refused once is repeated with its id, and leaves one record") {
    MemoryStore store;
    SessionLog log(store, some_session());
    store.refusals = 1;
    log.keep_attempt(some_answer());
    CHECK(store.data.attempts.size() == 1);
    CHECK(log.trouble().empty());
}

TEST_CASE("session log: the first write that is not kept is told, the next ones are tried") {
    MemoryStore store;
    SessionLog log(store, some_session());
    store.refusals = 2;
    log.keep_attempt(some_answer());
    log.keep_attempt(some_answer());
    CHECK(store.data.attempts.size() == 1);
    CHECK(log.trouble().find("the disk is full") != std::string::npos);
}

TEST_CASE("session log: what a store tells later is told, and so is what still waits") {
    LateStore store;
    SessionLog log(store, some_session());
    log.keep_attempt(some_answer());
    log.look_for_trouble();
    CHECK(log.trouble().empty());
    SECTION("refused later") {
        store.trouble = Error{"the disk is full", "", ""};
        log.look_for_trouble();
        CHECK(log.trouble().find("the disk is full") != std::string::npos);
    }
    SECTION("refused while the log settles") {
        store.trouble = Error{"the disk is full", "", ""};
        log.settle(1.0);
        CHECK(log.trouble().find("the disk is full") != std::string::npos);
    }
    SECTION("still waiting") {
        store.settled = fail("2 records still wait");
        log.settle(1.0);
        CHECK(log.trouble().find("2 records") != std::string::npos);
    }
    SECTION("all kept") {
        log.settle(1.0);
        CHECK(log.trouble().empty());
    }
}
