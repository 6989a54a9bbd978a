// What earlier sessions tell of a learner: the size of the throat, and the ladder of feedback that was chosen.
#include "runtime/lesson/learner_throat.h"

#include "runtime/lesson/learner_feedback.h"
#include "tests/unit/runtime/lesson/session_fixture.h"
#include "tests/unit/runtime/rig.h"

using namespace fulcrum::runtime::test;

namespace {

constexpr auto recast = dialogue::FeedbackStep::recast;
constexpr auto rule = dialogue::FeedbackStep::rule;
using Ladder = dialogue::FeedbackLadder;

const LearnerId kMina = random_record_id();
const LearnerId kTom = random_record_id();

SessionRecord session_of(const LearnerId& learner,
                         std::vector<std::pair<std::string, std::string>> settings) {
    return {random_record_id(), learner, "gravity", "", "", 0, std::move(settings)};
}

}  // namespace

TEST_CASE("throat: the learner's newest counts, and of one session what was heard in it") {
    ProgressData data;
    CHECK_FALSE(find_throat(data, kMina));
    data.sessions = {session_of(kMina, {{"felt_scale", "1.9"}}),
                     session_of(kMina, {{kThroat, "1.50"}})};
    CHECK(find_throat(data, kMina) == 1.5);
    data.sessions.push_back(session_of(kMina, {{kThroat, "1.50"}, {kThroatHeard, "1.20"}}));
    data.sessions.push_back(session_of(kTom, {{kThroatHeard, "1.00"}}));
    data.sessions.push_back(session_of(kMina, {}));
    CHECK(find_throat(data, kMina) == 1.2);
    CHECK(find_throat(data, kTom) == 1.0);
}

TEST_CASE("learner's feedback: the newest that was chosen counts, for this learner alone") {
    ProgressData data;
    CHECK(find_feedback(data, kMina).empty());
    data.sessions = {session_of(kMina, {{kFeedback, "rule"}}),
                     session_of(kTom, {{kFeedback, "recast"}}),
                     session_of(kMina, {{kFeedback, "recast,rule"}}),
                     session_of(kMina, {})};  // played once more, and nothing was chosen
    CHECK(find_feedback(data, kMina) == Ladder{recast, rule});
    CHECK(find_feedback(data, kTom) == Ladder{recast});
    data.sessions.push_back(session_of(kMina, {{kFeedback, feedback_text({})}}));
    CHECK(find_feedback(data, kMina).empty());
}

TEST_CASE("throat, learner's feedback: what could be none is passed over") {
    ProgressData data;
    data.sessions = {
        session_of(kMina, {{kThroatHeard, "1.35"}, {kFeedback, feedback_text({recast})}})};
    for (const char* odd : {"", "nan", "inf", "0.9", "2.1", "-1", "1.2x", "one", "1,2"}) {
        data.sessions.push_back(session_of(kMina, {{kThroatHeard, odd}}));
    }
    for (const char* odd : {"", ",", "recast,", "recat", "RULE", "recast rule", "1",
                            "rule,rule,rule,rule,rule,rule,rule,rule,rule"}) {
        data.sessions.push_back(session_of(kMina, {{kFeedback, odd}}));
    }
    CHECK(find_throat(data, kMina) == 1.35);
    CHECK(find_feedback(data, kMina) == Ladder{recast});
    for (const double throat : {1.0, 1.2, 1.35, 2.0}) {
        data.sessions.push_back(session_of(kMina, {{kThroat, throat_text(throat)}}));
        CHECK(find_throat(data, kMina) == throat);
    }
}

TEST_CASE("throat, learner's feedback: read from the store; from an unreadable one there is none") {
    MemoryStore store;
    const Learner mina{kMina, "Mina", 1};
    store.data.sessions = {session_of(kMina, {{kThroatHeard, "1.20"}, {kFeedback, "rule"}})};
    CHECK(read_throat(store, mina) == 1.2);
    CHECK(read_feedback(store, mina) == Ladder{rule});
    const auto nothing = make_null_store();
    CHECK_FALSE(read_throat(*nothing, mina));
    CHECK(read_feedback(*nothing, mina).empty());
}
