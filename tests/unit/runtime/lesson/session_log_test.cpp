#include "runtime/lesson/session_log.h"

#include "tests/unit/runtime/lesson/session_fixture.h"
#include "tests/unit/runtime/rig.h"

#include <deque>

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
class LateStore final : public TestStore {
  public:
    [[nodiscard]] std::optional<Error> take_trouble() override {
        return std::exchange(trouble, std::nullopt);
    }
    [[nodiscard]] Expected<void> settle(double) override { return settled; }

    std::optional<Error> trouble;
    Expected<void> settled{};
};

// A log and what it keeps.
struct Kept {
    MemoryStore store;
    SessionRecord session = some_session();
    SessionLog log{store, session};

    AttemptRecord keep(const MarkedAnswer& answer) {
        log.keep_attempt(answer);
        return store.data.attempts.back();
    }
};

}  // namespace

TEST_CASE("session log: what the rules of English find is kept with its point of grammar") {
    const AttemptRecord attempt = Kept().keep(some_free_answer());
    CHECK_FALSE(attempt.understood);
    CHECK_FALSE(attempt.form_right);
    CHECK(attempt.errors ==
          std::vector<ErrorRecord>{{"M:DET", "", "an", "article"},
                                   {"R:ADJ:FORM", "more heavier", "heavier", "comparison"}});
    CHECK(validate(attempt));
}

TEST_CASE("session log: an error is kept as it is read without its sentence") {
    using dialogue::ErrorCode;
    const struct {
        ErrorCode code;
        bool passive;
        const char *said, *right, *phrase;
        ErrorRecord kept;
    } rows[] = {
        {ErrorCode::wrong_preposition,
         true,
         "by",
         "of",
         "",
         {"R:PREP", "made by", "made of", "preposition"}},
        {ErrorCode::missing_preposition,
         true,
         "",
         "of",
         "",
         {"M:PREP", "made", "made of", "preposition"}},
        {ErrorCode::word_order,
         false,
         "",
         "is",
         "is the heaviest",
         {"R:WO", "", "is the heaviest", "wording"}},
    };
    Kept kept;
    for (const auto& row : rows) {
        MarkedAnswer answer = some_answer();
        dialogue::FormError& error = answer.mark.form_errors[0];
        error.code = row.code;
        error.passive = row.passive;
        error.said = row.said;
        error.right = row.right;
        error.phrase = row.phrase;
        CHECK(kept.keep(answer).errors == std::vector{row.kept});
    }
}

TEST_CASE("session log: beginning, answers and end are kept as they were") {
    Kept kept;
    const AttemptRecord attempt = kept.keep(some_answer());
    kept.log.keep_end(EndReason::finished, 2, 9, 3);
    kept.log.keep_end(EndReason::left, 0, 0, 0);  // once is enough
    CHECK(kept.store.data.sessions == std::vector{kept.session});
    CHECK(kept.store.data.attempts.size() == 1);
    CHECK(is_record_id(attempt.id));
    CHECK(attempt.session == kept.session.id);
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
    REQUIRE(kept.store.data.ends.size() == 1);
    const SessionEnd& end = kept.store.data.ends[0];
    CHECK(end == SessionEnd{kept.session.id, end.ended_utc_ms, EndReason::finished, 2, 9, 3});
    CHECK(kept.log.trouble().empty());
}

TEST_CASE("session log: an error of the taught form is kept as such") {
    MarkedAnswer answer = some_answer();
    answer.mark.form_errors.resize(2);
    answer.mark.form_errors[1].code = dialogue::ErrorCode::missing_determiner;
    answer.mark.form_errors[0].target = true;
    const AttemptRecord attempt = Kept().keep(answer);
    CHECK_FALSE(attempt.target_right);
    CHECK(attempt.errors.at(0).target);
    CHECK_FALSE(attempt.errors.at(1).target);
}

TEST_CASE("session log: where the meaning alone was heard, that is kept, and nothing of the form") {
    Kept kept;
    MarkedAnswer answer = some_answer();
    CHECK(kept.keep(answer).form_known);
    answer.mark = without_form(std::move(answer.mark));
    const AttemptRecord attempt = kept.keep(answer);
    CHECK_FALSE(attempt.form_known);
    CHECK(attempt.meaning_right);
    CHECK_FALSE(attempt.form_right);
    CHECK_FALSE(attempt.target_right);
    CHECK(attempt.errors.empty());
    CHECK(attempt.confidence == 0.75);
    CHECK(validate(attempt));
}

TEST_CASE("session log: a write refused once is repeated, one refused twice is told") {
    Kept kept;
    kept.store.refusals = 1;
    kept.log.keep_attempt(some_answer());
    CHECK(kept.store.data.attempts.size() == 1);
    CHECK(kept.log.trouble().empty());
    // The next ones are tried.
    kept.store.refusals = 2;
    kept.log.keep_attempt(some_answer());
    kept.log.keep_attempt(some_answer());
    CHECK(kept.store.data.attempts.size() == 2);
    check_says(kept.log.trouble(), {"the disk is full"});
}

TEST_CASE("session log: what a store tells later is told, and so is what still waits") {
    const std::optional<Error> full = Error{"the disk is full", "", ""};
    const struct {
        std::optional<Error> later, settling;
        Expected<void> settled;
        const char* told;
    } rows[] = {
        {full, {}, {}, "the disk is full"},
        {{}, full, {}, "the disk is full"},
        {{}, {}, fail("2 records still wait"), "2 records"},
        {{}, {}, {}, ""},
    };
    for (const auto& row : rows) {
        LateStore store;
        SessionLog log(store, some_session());
        log.keep_attempt(some_answer());
        log.look_for_trouble();
        CHECK(log.trouble().empty());
        store.trouble = row.later;
        log.look_for_trouble();
        CHECK(log.trouble().empty() == !row.later.has_value());
        store.trouble = row.settling;
        store.settled = row.settled;
        log.settle(1.0);
        check_says(log.trouble(), {row.told});
        CHECK(log.trouble().empty() == std::string(row.told).empty());
    }
}
