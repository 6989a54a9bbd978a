// Reading: all that a filter matches.
#include "runtime/progress/sqlite/queries.h"
#include "tests/unit/runtime/progress/progress_fixture.h"

#include <catch2/catch.hpp>

namespace fulcrum::runtime {
namespace {

using test::attempt_for;
using test::Classroom;
using test::TemporaryFolder;

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

TEST_CASE("store: lists come back with their owners, in the order of their writing") {
    const TemporaryFolder folder;
    Classroom room(folder.file("progress.db"));
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
    const TemporaryFolder folder;
    Classroom room(folder.file("progress.db"));
    REQUIRE(test::run_sql(room.path, "DROP TABLE session_end").empty());
    const auto data = room.store->read({});
    REQUIRE_FALSE(data);
    CHECK(test::is_sentence_about(to_sentence(data.error()), room.path));
}

}  // namespace
}  // namespace fulcrum::runtime
