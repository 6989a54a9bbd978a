// The store that keeps nothing lets a lesson be played.
#include "runtime/progress/store.h"
#include "tests/unit/runtime/progress/progress_fixture.h"

#include <catch2/catch.hpp>

namespace fulcrum::runtime {
namespace {

using test::attempt_for;

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
