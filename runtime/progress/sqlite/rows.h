// Rows to records. Each SELECT names its columns in the order in which its function reads them.
#pragma once

#include "runtime/progress/sqlite/database.h"
#include "runtime/progress/store.h"

namespace fulcrum::runtime::sqlite {

inline constexpr const char* kSelectLearner =
    "SELECT learner.id, nickname, enrolled_utc_ms FROM learner";
inline constexpr const char* kSelectSession =
    "SELECT session.id, learner, lesson, lesson_version, level, started_utc_ms FROM session";
inline constexpr const char* kSelectEnd =
    "SELECT session_end.session, ended_utc_ms, reason, stars, score, level_reached FROM "
    "session_end";
inline constexpr const char* kSelectAttempt =
    "SELECT attempt.id, attempt.session, question, attempt, said, understood, meaning_right,"
    " form_right, slots, answer_s, said_utc_ms, target_right, confidence, feedback, uptake,"
    " form_known FROM attempt";
inline constexpr const char* kSelectSetting =
    "SELECT session_setting.session, name, value FROM session_setting";
inline constexpr const char* kSelectHandSetting =
    "SELECT hand_setting.id, hand_setting.learner, device, name, value, kept_utc_ms FROM "
    "hand_setting";
inline constexpr const char* kSelectError =
    "SELECT attempt_error.attempt, code, span, correction, point, target FROM attempt_error";

/// The record in the statement's present row; lists (settings, errors) are left empty.
[[nodiscard]] Learner learner_of(Statement& row);
[[nodiscard]] SessionRecord session_of(Statement& row);
[[nodiscard]] SessionEnd end_of(Statement& row);
[[nodiscard]] AttemptRecord attempt_of(Statement& row);
[[nodiscard]] HandSetting hand_setting_of(Statement& row);
/// As above, from the columns after the owner's id, which the caller has read.
[[nodiscard]] std::pair<std::string, std::string> setting_of(Statement& row);
[[nodiscard]] ErrorRecord error_of(Statement& row);

}  // namespace fulcrum::runtime::sqlite
