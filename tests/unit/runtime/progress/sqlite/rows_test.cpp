// Rows to records: each column comes back into its own field.
#include "runtime/progress/sqlite/rows.h"

#include "tests/unit/runtime/progress/progress_fixture.h"

#include <catch2/catch.hpp>

namespace fulcrum::runtime {
namespace {

using test::Classroom;
using test::TemporaryFolder;

TEST_CASE("rows: an attempt's four verdicts, and what came of it, are not mixed up") {
    const TemporaryFolder folder;
    Classroom room(folder.file("progress.db"));
    for (unsigned bits = 0; bits < 16; ++bits) {
        AttemptRecord attempt =
            test::attempt_for(room.session.id, "q", 1 + static_cast<int>(bits), false);
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
    const TemporaryFolder folder;
    Classroom room(folder.file("progress.db"));
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

}  // namespace
}  // namespace fulcrum::runtime
