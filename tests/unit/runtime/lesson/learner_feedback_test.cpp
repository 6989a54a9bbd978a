#include "runtime/lesson/learner_feedback.h"

#include "tests/unit/runtime/lesson/session_fixture.h"

#include <catch2/catch.hpp>

using namespace fulcrum;
using namespace fulcrum::runtime;

namespace {

constexpr auto recast = dialogue::FeedbackStep::recast;
constexpr auto rule = dialogue::FeedbackStep::rule;

SessionRecord chosen(const LearnerId& learner, const std::string& value) {
    SessionRecord session;
    session.id = random_record_id();
    session.learner = learner;
    session.lesson = "gravity";
    session.settings = {{kFeedback, value}};
    return session;
}

}  // namespace

TEST_CASE("learner's feedback: the newest that was chosen counts, for this learner alone") {
    const LearnerId mina = random_record_id();
    const LearnerId tom = random_record_id();
    ProgressData data;
    CHECK(find_feedback(data, mina).empty());
    data.sessions = {chosen(mina, "rule"), chosen(tom, "recast"), chosen(mina, "recast,rule")};
    data.sessions.emplace_back().learner = mina;  // played once more, and nothing was chosen
    CHECK(find_feedback(data, mina) == dialogue::FeedbackLadder{recast, rule});
    CHECK(find_feedback(data, tom) == dialogue::FeedbackLadder{recast});
    data.sessions.push_back(chosen(mina, feedback_text({})));
    CHECK(find_feedback(data, mina).empty());
}

TEST_CASE("learner's feedback: what is no ladder is passed over") {
    const LearnerId mina = random_record_id();
    ProgressData data;
    data.sessions = {chosen(mina, feedback_text({recast}))};
    for (const char* odd : {"", ",", "recast,", "recat", "RULE", "recast rule", "1",
                            "rule,rule,rule,rule,rule,rule,rule,rule,rule"}) {
        data.sessions.push_back(chosen(mina, odd));
    }
    CHECK(find_feedback(data, mina) == dialogue::FeedbackLadder{recast});
}

TEST_CASE(
    "learner's feedback: it is read from the store; from one that cannot be read there is none") {
    fulcrum::runtime::test::MemoryStore store;
    const Learner mina{random_record_id(), "Mina", 1};
    store.data.sessions = {chosen(mina.id, "rule")};
    CHECK(read_feedback(store, mina) == dialogue::FeedbackLadder{rule});
    CHECK(read_feedback(*make_null_store(), mina).empty());
}
