// Ids, and records that are refused before any store sees them.
#include "runtime/progress/records.h"

#include "tests/unit/runtime/progress/progress_fixture.h"
#include "tests/unit/runtime/rig.h"

using namespace fulcrum::runtime::test;

TEST_CASE("record ids: 32 hexadecimal digits, no two alike, every digit varies") {
    RecordId changed(32, '0');
    RecordId previous;
    for (int i = 0; i < 200; ++i) {
        const RecordId id = random_record_id();
        CHECK(is_record_id(id));
        CHECK(id != previous);
        for (std::size_t digit = 0; i > 0 && digit < id.size(); ++digit) {
            changed[digit] = id[digit] != previous[digit] ? 'x' : changed[digit];
        }
        previous = id;
    }
    CHECK(changed == RecordId(32, 'x'));
    CHECK_FALSE(is_record_id(""));
    CHECK_FALSE(is_record_id(RecordId(31, 'a')));
    CHECK_FALSE(is_record_id(RecordId(32, 'A')));
    CHECK_FALSE(is_record_id(RecordId(33, 'a')));
    CHECK_FALSE(is_record_id(RecordId(32, 'g')));
}

TEST_CASE("store: bad records are refused in one sentence by either store") {
    OwnClassroom room;
    const auto null_store = make_null_store();
    CHECK_FALSE(null_store->keeps());
    for (ProgressStore* store : {room.store.get(), null_store.get()}) {
        AttemptRecord attempt = attempt_for(room.session.id, "heaviest", 0, true);
        check_says(error_text(store->add_attempt(attempt)), {"count attempts from 1"});
        attempt.attempt = 1;
        attempt.answer_s = std::numeric_limits<double>::quiet_NaN();
        CHECK_FALSE(store->add_attempt(attempt));
        attempt.answer_s = -1.0;
        CHECK_FALSE(store->add_attempt(attempt));
        attempt.answer_s = 1.0;
        for (const double none : {-0.1, 1.1, std::numeric_limits<double>::quiet_NaN()}) {
            attempt.confidence = none;
            CHECK_FALSE(store->add_attempt(attempt));
        }
        attempt.confidence = 1.0;
        attempt.errors = {{"", "a", "b"}};
        CHECK_FALSE(store->add_attempt(attempt));
        attempt.errors.clear();
        CHECK(error_text(validate(attempt)).empty());
        // Of a form that nobody heard there is nothing to keep.
        attempt.form_known = false;
        for (const bool of_target : {false, true}) {
            attempt.form_right = !of_target;
            attempt.target_right = of_target;
            check_says(error_text(store->add_attempt(attempt)), {"a form that nobody heard"});
        }
        attempt.target_right = false;
        attempt.errors = {{"M:DET", "", "the"}};
        CHECK_FALSE(store->add_attempt(attempt));
        attempt.errors.clear();
        CHECK(error_text(validate(attempt)).empty());
        attempt.id = "1234";
        CHECK_FALSE(store->add_attempt(attempt));
        CHECK_FALSE(store->end_session({room.session.id, 0, EndReason::finished, 4, 0, 1}));
        CHECK_FALSE(store->end_session({room.session.id, 0, EndReason::finished, 0, 0, 0}));
        SessionRecord session = room.session;
        session.id = random_record_id();
        session.settings = {{"a", "1"}, {"a", "2"}};
        CHECK_FALSE(store->begin_session(session));
        session.settings.clear();
        session.lesson.clear();
        CHECK_FALSE(store->begin_session(session));
        CHECK_FALSE(store->enrol("\n"));
        CHECK_FALSE(store->add_learner({random_record_id(), " blank ", 0}));
    }
    CHECK(room.store->read({})->attempts.empty());
}
