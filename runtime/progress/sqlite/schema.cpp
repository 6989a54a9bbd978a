#include "runtime/progress/sqlite/schema.h"

#include "runtime/progress/records.h"

#include <string>

namespace fulcrum::runtime::sqlite {
namespace {

// Learners, sessions, attempts and errors. Facts can be added and, with their learner, erased, but
// not changed.
constexpr const char* kStep0 = R"sql(
CREATE TABLE learner(
  row INTEGER PRIMARY KEY,
  id TEXT NOT NULL UNIQUE CHECK(length(id) = 32),
  nickname TEXT NOT NULL UNIQUE COLLATE NOCASE CHECK(length(nickname) BETWEEN 1 AND 40),
  enrolled_utc_ms INTEGER NOT NULL) STRICT;
CREATE TABLE session(
  row INTEGER PRIMARY KEY,
  id TEXT NOT NULL UNIQUE CHECK(length(id) = 32),
  learner TEXT NOT NULL REFERENCES learner(id) ON DELETE CASCADE,
  lesson TEXT NOT NULL,
  lesson_version TEXT NOT NULL,
  level TEXT NOT NULL,
  started_utc_ms INTEGER NOT NULL) STRICT;
CREATE INDEX session_of_learner ON session(learner);
CREATE TABLE session_end(
  row INTEGER PRIMARY KEY,
  session TEXT NOT NULL UNIQUE REFERENCES session(id) ON DELETE CASCADE,
  ended_utc_ms INTEGER NOT NULL,
  reason INTEGER NOT NULL CHECK(reason BETWEEN 0 AND 2),
  stars INTEGER NOT NULL CHECK(stars BETWEEN 0 AND 3),
  score INTEGER NOT NULL,
  level_reached INTEGER NOT NULL CHECK(level_reached >= 1)) STRICT;
CREATE TABLE attempt(
  row INTEGER PRIMARY KEY,
  id TEXT NOT NULL UNIQUE CHECK(length(id) = 32),
  session TEXT NOT NULL REFERENCES session(id) ON DELETE CASCADE,
  question TEXT NOT NULL,
  attempt INTEGER NOT NULL CHECK(attempt >= 1),
  said TEXT NOT NULL,
  meaning_right INTEGER NOT NULL CHECK(meaning_right IN (0, 1)),
  form_right INTEGER NOT NULL CHECK(form_right IN (0, 1)),
  slots TEXT NOT NULL,
  answer_s REAL NOT NULL CHECK(answer_s >= 0),
  said_utc_ms INTEGER NOT NULL) STRICT;
CREATE INDEX attempt_of_session ON attempt(session);
CREATE TABLE attempt_error(
  attempt TEXT NOT NULL REFERENCES attempt(id) ON DELETE CASCADE,
  position INTEGER NOT NULL,
  code TEXT NOT NULL,
  span TEXT NOT NULL,
  correction TEXT NOT NULL,
  PRIMARY KEY(attempt, position)) STRICT, WITHOUT ROWID;
CREATE TABLE opening(row INTEGER PRIMARY KEY, opened_utc_ms INTEGER NOT NULL) STRICT;
CREATE TRIGGER learner_is_fact BEFORE UPDATE ON learner
  BEGIN SELECT RAISE(ABORT, 'a kept fact is never changed'); END;
CREATE TRIGGER session_is_fact BEFORE UPDATE ON session
  BEGIN SELECT RAISE(ABORT, 'a kept fact is never changed'); END;
CREATE TRIGGER session_end_is_fact BEFORE UPDATE ON session_end
  BEGIN SELECT RAISE(ABORT, 'a kept fact is never changed'); END;
CREATE TRIGGER attempt_is_fact BEFORE UPDATE ON attempt
  BEGIN SELECT RAISE(ABORT, 'a kept fact is never changed'); END;
CREATE TRIGGER attempt_error_is_fact BEFORE UPDATE ON attempt_error
  BEGIN SELECT RAISE(ABORT, 'a kept fact is never changed'); END;
)sql";

// Answers that no template fitted are told from wrong ones (before, all counted as understood), and
// a session keeps the settings that it was played with.
constexpr const char* kStep1 = R"sql(
ALTER TABLE attempt ADD COLUMN understood INTEGER NOT NULL DEFAULT 1 CHECK(understood IN (0, 1));
CREATE TABLE session_setting(
  session TEXT NOT NULL REFERENCES session(id) ON DELETE CASCADE,
  position INTEGER NOT NULL,
  name TEXT NOT NULL,
  value TEXT NOT NULL,
  PRIMARY KEY(session, position),
  UNIQUE(session, name)) STRICT, WITHOUT ROWID;
CREATE TRIGGER session_setting_is_fact BEFORE UPDATE ON session_setting
  BEGIN SELECT RAISE(ABORT, 'a kept fact is never changed'); END;
)sql";

// An error of form belongs to a point of grammar; those kept before belong to none.
constexpr const char* kStep2 = R"sql(
ALTER TABLE attempt_error ADD COLUMN point TEXT NOT NULL DEFAULT '';
)sql";

// The form that was taught is told from other forms, and what came of an answer is kept; of those kept before only what was known.
constexpr const char* kStep3 = R"sql(
ALTER TABLE attempt ADD COLUMN target_right INTEGER NOT NULL DEFAULT 0 CHECK(target_right IN (0, 1));
ALTER TABLE attempt ADD COLUMN confidence REAL NOT NULL DEFAULT 1.0;
ALTER TABLE attempt ADD COLUMN feedback TEXT NOT NULL DEFAULT '';
ALTER TABLE attempt ADD COLUMN uptake TEXT NOT NULL DEFAULT '';
)sql";

// How a device is set for a learner, and what was found when it was tried.
constexpr const char* kStep4 = R"sql(
CREATE TABLE hand_setting(
  row INTEGER PRIMARY KEY,
  id TEXT NOT NULL UNIQUE CHECK(length(id) = 32),
  learner TEXT NOT NULL REFERENCES learner(id) ON DELETE CASCADE,
  device TEXT NOT NULL,
  name TEXT NOT NULL CHECK(length(name) >= 1),
  value TEXT NOT NULL,
  kept_utc_ms INTEGER NOT NULL) STRICT;
CREATE INDEX hand_setting_of_learner ON hand_setting(learner);
CREATE TRIGGER hand_setting_is_fact BEFORE UPDATE ON hand_setting
  BEGIN SELECT RAISE(ABORT, 'a kept fact is never changed'); END;
)sql";

// Whether the form of an answer was heard at all; those kept before count as heard.
constexpr const char* kStep5 = R"sql(
ALTER TABLE attempt ADD COLUMN form_known INTEGER NOT NULL DEFAULT 1 CHECK(form_known IN (0, 1));
)sql";

// An error of the form that was taught is told from others; of those kept before it is not known.
constexpr const char* kStep6 = R"sql(
ALTER TABLE attempt_error ADD COLUMN target INTEGER NOT NULL DEFAULT 0 CHECK(target IN (0, 1));
)sql";

// Classes, how each is shown, and the pictures by which their pupils are found.
constexpr const char* kStep7 = R"sql(
CREATE TABLE class(
  row INTEGER PRIMARY KEY,
  id TEXT NOT NULL UNIQUE CHECK(length(id) = 32),
  name TEXT NOT NULL UNIQUE COLLATE NOCASE CHECK(length(name) BETWEEN 1 AND 40),
  made_utc_ms INTEGER NOT NULL) STRICT;
CREATE TABLE class_setting(
  row INTEGER PRIMARY KEY,
  id TEXT NOT NULL UNIQUE CHECK(length(id) = 32),
  class TEXT NOT NULL REFERENCES class(id) ON DELETE CASCADE,
  name TEXT NOT NULL CHECK(length(name) >= 1),
  value TEXT NOT NULL,
  kept_utc_ms INTEGER NOT NULL) STRICT;
CREATE TABLE class_card(
  row INTEGER PRIMARY KEY,
  id TEXT NOT NULL UNIQUE CHECK(length(id) = 32),
  class TEXT NOT NULL REFERENCES class(id) ON DELETE CASCADE,
  learner TEXT NOT NULL REFERENCES learner(id) ON DELETE CASCADE,
  card_1 TEXT NOT NULL,
  card_2 TEXT NOT NULL CHECK(card_2 <> card_1),
  secret TEXT NOT NULL CHECK(secret NOT IN (card_1, card_2)),
  kept_utc_ms INTEGER NOT NULL) STRICT;
CREATE INDEX class_card_of_learner ON class_card(learner);
CREATE TRIGGER class_is_fact BEFORE UPDATE ON class
  BEGIN SELECT RAISE(ABORT, 'a kept fact is never changed'); END;
CREATE TRIGGER class_setting_is_fact BEFORE UPDATE ON class_setting
  BEGIN SELECT RAISE(ABORT, 'a kept fact is never changed'); END;
CREATE TRIGGER class_card_is_fact BEFORE UPDATE ON class_card
  BEGIN SELECT RAISE(ABORT, 'a kept fact is never changed'); END;
)sql";

}  // namespace

const std::array<const char*, kSchemaVersion>& migrations() noexcept {
    static constexpr std::array<const char*, kSchemaVersion> kSteps{kStep0, kStep1, kStep2, kStep3,
                                                                    kStep4, kStep5, kStep6, kStep7};
    return kSteps;
}

void migrate(Database& database) {
    Transaction transaction(database, Transaction::Kind::write);
    // Read under the write lock: another program may have brought it up a moment ago.
    const std::int64_t found = database.number("PRAGMA user_version");
    for (auto version = static_cast<std::size_t>(found); version < migrations().size(); ++version) {
        database.run(migrations()[version]);
    }
    if (found < kSchemaVersion) {
        database.run(("PRAGMA application_id = " + std::to_string(kApplicationId)).c_str());
        database.run(("PRAGMA user_version = " + std::to_string(kSchemaVersion)).c_str());
    }
    Statement(database, "INSERT INTO opening(opened_utc_ms) VALUES(?)").bind(utc_now_ms()).run();
    transaction.commit();
}

}  // namespace fulcrum::runtime::sqlite
