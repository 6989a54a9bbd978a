#include "runtime/progress/sqlite/rows.h"

namespace fulcrum::runtime::sqlite {

Learner learner_of(Statement& row) {
    Learner learner;
    learner.id = row.text();
    learner.nickname = row.text();
    learner.enrolled_utc_ms = row.number();
    return learner;
}

SessionRecord session_of(Statement& row) {
    SessionRecord session;
    session.id = row.text();
    session.learner = row.text();
    session.lesson = row.text();
    session.lesson_version = row.text();
    session.level = row.text();
    session.started_utc_ms = row.number();
    return session;
}

SessionEnd end_of(Statement& row) {
    SessionEnd end;
    end.session = row.text();
    end.ended_utc_ms = row.number();
    end.reason = static_cast<EndReason>(row.number());
    end.stars = static_cast<std::int32_t>(row.number());
    end.score = static_cast<std::int32_t>(row.number());
    end.level_reached = static_cast<std::int32_t>(row.number());
    return end;
}

AttemptRecord attempt_of(Statement& row) {
    AttemptRecord attempt;
    attempt.id = row.text();
    attempt.session = row.text();
    attempt.question = row.text();
    attempt.attempt = static_cast<std::int32_t>(row.number());
    attempt.said = row.text();
    attempt.understood = row.flag();
    attempt.meaning_right = row.flag();
    attempt.form_right = row.flag();
    attempt.slots = row.text();
    attempt.answer_s = row.real();
    attempt.said_utc_ms = row.number();
    attempt.target_right = row.flag();
    attempt.confidence = row.real();
    attempt.feedback = row.text();
    attempt.uptake = row.text();
    attempt.form_known = row.flag();
    return attempt;
}

HandSetting hand_setting_of(Statement& row) {
    HandSetting setting;
    setting.id = row.text();
    setting.learner = row.text();
    setting.device = row.text();
    setting.name = row.text();
    setting.value = row.text();
    setting.kept_utc_ms = row.number();
    return setting;
}

std::pair<std::string, std::string> setting_of(Statement& row) {
    std::string name = row.text();
    std::string value = row.text();
    return {std::move(name), std::move(value)};
}

ErrorRecord error_of(Statement& row) {
    ErrorRecord error;
    error.code = row.text();
    error.span = row.text();
    error.correction = row.text();
    error.point = row.text();
    error.target = row.flag();
    return error;
}

}  // namespace fulcrum::runtime::sqlite
