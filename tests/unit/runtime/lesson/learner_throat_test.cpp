#include "runtime/lesson/learner_throat.h"

#include "tests/unit/runtime/lesson/session_fixture.h"

#include <catch2/catch.hpp>

using namespace fulcrum;
using namespace fulcrum::runtime;

namespace {

SessionRecord session_of(const LearnerId& learner,
                         std::vector<std::pair<std::string, std::string>> settings) {
    SessionRecord session;
    session.id = random_record_id();
    session.learner = learner;
    session.lesson = "gravity";
    session.settings = std::move(settings);
    return session;
}

}  // namespace

TEST_CASE("throat: the learner's newest counts, and of one session what was heard in it") {
    const LearnerId mina = random_record_id();
    const LearnerId tom = random_record_id();
    ProgressData data;
    CHECK_FALSE(find_throat(data, mina));
    data.sessions = {session_of(mina, {{"felt_scale", "1.9"}}),
                     session_of(mina, {{kThroat, "1.50"}})};
    CHECK(find_throat(data, mina) == 1.5);
    data.sessions.push_back(session_of(mina, {{kThroat, "1.50"}, {kThroatHeard, "1.20"}}));
    data.sessions.push_back(session_of(tom, {{kThroatHeard, "1.00"}}));
    data.sessions.push_back(session_of(mina, {}));
    CHECK(find_throat(data, mina) == 1.2);
    CHECK(find_throat(data, tom) == 1.0);
}

TEST_CASE("throat: what could be none is passed over") {
    const LearnerId mina = random_record_id();
    ProgressData data;
    data.sessions = {session_of(mina, {{kThroatHeard, "1.35"}})};
    for (const char* odd : {"", "nan", "inf", "0.9", "2.1", "-1", "1.2x", "one", "1,2"}) {
        data.sessions.push_back(session_of(mina, {{kThroatHeard, odd}}));
    }
    CHECK(find_throat(data, mina) == 1.35);
    for (const double throat : {1.0, 1.2, 1.35, 2.0}) {
        data.sessions.push_back(session_of(mina, {{kThroat, throat_text(throat)}}));
        CHECK(find_throat(data, mina) == throat);
    }
}

TEST_CASE("throat: it is read from the store; one that cannot be read has none") {
    fulcrum::runtime::test::MemoryStore store;
    const Learner mina{random_record_id(), "Mina", 1};
    store.data.sessions = {session_of(mina.id, {{kThroatHeard, "1.20"}})};
    CHECK(read_throat(store, mina) == 1.2);
    CHECK_FALSE(read_throat(*make_null_store(), mina));
}
