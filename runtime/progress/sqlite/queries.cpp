#include "runtime/progress/sqlite/queries.h"

#include "dialogue/unicode.h"
#include "runtime/progress/sqlite/repeats.h"
#include "runtime/progress/sqlite/rows.h"
#include "runtime/progress/text_rules.h"

#include <algorithm>
#include <optional>

namespace fulcrum::runtime::sqlite {
namespace {

// ---- what is kept of a record's texts
// ----------------------------------------------------------------------------

SessionRecord as_kept(SessionRecord session) {
    for (std::string* text : {&session.lesson, &session.lesson_version, &session.level}) {
        *text = kept_text(*text);
    }
    for (auto& [name, value] : session.settings) {
        name = kept_text(name);
        value = kept_text(value);
    }
    return session;
}

AttemptRecord as_kept(AttemptRecord attempt) {
    for (std::string* text :
         {&attempt.question, &attempt.said, &attempt.slots, &attempt.feedback, &attempt.uptake}) {
        *text = kept_text(*text);
    }
    for (ErrorRecord& error : attempt.errors) {
        for (std::string* text : {&error.code, &error.span, &error.correction, &error.point}) {
            *text = kept_text(*text);
        }
    }
    return attempt;
}

// ---- one record by its id, for repeated writes
// -------------------------------------------------------------------

std::optional<Learner> find_learner(Database& database, const RecordId& id) {
    Statement row(database, (std::string(kSelectLearner) + " WHERE learner.id = ?").c_str());
    return row.bind(id).step() ? std::optional(learner_of(row)) : std::nullopt;
}

std::optional<SessionRecord> find_session(Database& database, const RecordId& id) {
    Statement row(database, (std::string(kSelectSession) + " WHERE session.id = ?").c_str());
    if (!row.bind(id).step()) {
        return std::nullopt;
    }
    SessionRecord session = session_of(row);
    Statement setting(
        database, "SELECT name, value FROM session_setting WHERE session = ? ORDER BY position");
    setting.bind(id);
    while (setting.step()) {
        session.settings.push_back(setting_of(setting));
    }
    return session;
}

std::optional<HandSetting> find_hand_setting(Database& database, const RecordId& id) {
    Statement row(database,
                  (std::string(kSelectHandSetting) + " WHERE hand_setting.id = ?").c_str());
    return row.bind(id).step() ? std::optional(hand_setting_of(row)) : std::nullopt;
}

std::optional<SessionEnd> find_end(Database& database, const RecordId& session) {
    Statement row(database, (std::string(kSelectEnd) + " WHERE session_end.session = ?").c_str());
    return row.bind(session).step() ? std::optional(end_of(row)) : std::nullopt;
}

std::optional<AttemptRecord> find_attempt(Database& database, const RecordId& id) {
    Statement row(database, (std::string(kSelectAttempt) + " WHERE attempt.id = ?").c_str());
    if (!row.bind(id).step()) {
        return std::nullopt;
    }
    AttemptRecord attempt = attempt_of(row);
    Statement error(
        database,
        "SELECT code, span, correction, point, target FROM attempt_error WHERE attempt = ?"
        " ORDER BY position");
    error.bind(id);
    while (error.step()) {
        attempt.errors.push_back(error_of(error));
    }
    return attempt;
}

}  // namespace

std::optional<Learner> find_called(Database& database, const std::string& nickname) {
    for (const std::string& name : {nickname, dialogue::composed(nickname)}) {
        Statement exact(database, (std::string(kSelectLearner) + " WHERE nickname = ?").c_str());
        if (exact.bind(name).step()) {
            return learner_of(exact);
        }
    }
    const std::string folded = folded_nickname(nickname);
    Statement each(database, (std::string(kSelectLearner) + " ORDER BY row").c_str());
    while (each.step()) {
        if (Learner learner = learner_of(each); folded_nickname(learner.nickname) == folded) {
            return learner;
        }
    }
    return std::nullopt;
}

Learner enrol(Database& database, const std::string& nickname) {
    if (auto known = find_called(database, nickname)) {
        return *std::move(known);
    }
    auto kept = checked_nickname(dialogue::composed(nickname));
    if (!kept) {
        throw Refused(kept.error());
    }
    Learner learner{random_record_id(), *std::move(kept), utc_now_ms()};
    keep(database, learner);
    return learner;
}

void keep(Database& database, const Learner& learner) {
    if (is_repeat(database, find_learner(database, learner.id), learner, "learner")) {
        return;
    }
    Statement taken(database, "SELECT 1 FROM learner WHERE nickname = ?");
    if (taken.bind(learner.nickname).step()) {
        throw Refused({"another learner has the nickname \"" + learner.nickname + "\"",
                       database.path(), "choose another nickname"});
    }
    Statement(database, "INSERT INTO learner(id, nickname, enrolled_utc_ms) VALUES(?, ?, ?)")
        .bind(learner.id)
        .bind(learner.nickname)
        .bind(learner.enrolled_utc_ms)
        .run();
}

void keep(Database& database, const SessionRecord& given) {
    const SessionRecord session = as_kept(given);
    if (is_repeat(database, find_session(database, session.id), session, "session")) {
        return;
    }
    require(database, "SELECT 1 FROM learner WHERE id = ?", session.learner, "learner");
    Statement(database,
              "INSERT INTO session(id, learner, lesson, lesson_version, level, started_utc_ms)"
              " VALUES(?, ?, ?, ?, ?, ?)")
        .bind(session.id)
        .bind(session.learner)
        .bind(session.lesson)
        .bind(session.lesson_version)
        .bind(session.level)
        .bind(session.started_utc_ms)
        .run();
    std::int64_t position = 0;
    for (const auto& [name, value] : session.settings) {
        Statement(database,
                  "INSERT INTO session_setting(session, position, name, value) VALUES(?, ?, ?, ?)")
            .bind(session.id)
            .bind(position++)
            .bind(name)
            .bind(value)
            .run();
    }
}

// Behind the settings with which the session began.
void keep(Database& database, const SessionSetting& given) {
    const SessionSetting setting{given.session, kept_text(given.name), kept_text(given.value)};
    const auto session = find_session(database, setting.session);
    const auto& settings = session ? session->settings : decltype(session->settings){};
    const auto kept =
        std::ranges::find(settings, setting.name, [](const auto& s) { return s.first; });
    const std::optional<SessionSetting> before =
        kept == settings.end()
            ? std::nullopt
            : std::optional(SessionSetting{setting.session, kept->first, kept->second});
    if (is_repeat(database, before, setting, "setting of the session")) {
        return;
    }
    require(database, "SELECT 1 FROM session WHERE id = ?", setting.session, "session");
    Statement(database,
              "INSERT INTO session_setting(session, position, name, value) VALUES(?, ?, ?, ?)")
        .bind(setting.session)
        .bind(static_cast<std::int64_t>(settings.size()))
        .bind(setting.name)
        .bind(setting.value)
        .run();
}

void keep(Database& database, const HandSetting& given) {
    HandSetting setting = given;
    for (std::string* text : {&setting.device, &setting.name, &setting.value}) {
        *text = kept_text(*text);
    }
    if (is_repeat(database, find_hand_setting(database, setting.id), setting,
                  "setting of a hand")) {
        return;
    }
    require(database, "SELECT 1 FROM learner WHERE id = ?", setting.learner, "learner");
    Statement(database,
              "INSERT INTO hand_setting(id, learner, device, name, value, kept_utc_ms)"
              " VALUES(?, ?, ?, ?, ?, ?)")
        .bind(setting.id)
        .bind(setting.learner)
        .bind(setting.device)
        .bind(setting.name)
        .bind(setting.value)
        .bind(setting.kept_utc_ms)
        .run();
}

void keep(Database& database, const SessionEnd& end) {
    if (is_repeat(database, find_end(database, end.session), end, "end of the session")) {
        return;
    }
    require(database, "SELECT 1 FROM session WHERE id = ?", end.session, "session");
    Statement(database,
              "INSERT INTO session_end(session, ended_utc_ms, reason, stars, score, level_reached)"
              " VALUES(?, ?, ?, ?, ?, ?)")
        .bind(end.session)
        .bind(end.ended_utc_ms)
        .bind(static_cast<std::int64_t>(end.reason))
        .bind(end.stars)
        .bind(end.score)
        .bind(end.level_reached)
        .run();
}

void keep(Database& database, const AttemptRecord& given) {
    const AttemptRecord attempt = as_kept(given);
    if (is_repeat(database, find_attempt(database, attempt.id), attempt, "attempt")) {
        return;
    }
    require(database, "SELECT 1 FROM session WHERE id = ?", attempt.session, "session");
    Statement(
        database,
        "INSERT INTO attempt(id, session, question, attempt, said, understood, meaning_right,"
        " form_right, slots, answer_s, said_utc_ms, target_right, confidence, feedback, uptake,"
        " form_known) VALUES(?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?)")
        .bind(attempt.id)
        .bind(attempt.session)
        .bind(attempt.question)
        .bind(attempt.attempt)
        .bind(attempt.said)
        .bind(attempt.understood)
        .bind(attempt.meaning_right)
        .bind(attempt.form_right)
        .bind(attempt.slots)
        .bind(attempt.answer_s)
        .bind(attempt.said_utc_ms)
        .bind(attempt.target_right)
        .bind(attempt.confidence)
        .bind(attempt.feedback)
        .bind(attempt.uptake)
        .bind(attempt.form_known)
        .run();
    std::int64_t position = 0;
    for (const ErrorRecord& error : attempt.errors) {
        Statement(
            database,
            "INSERT INTO attempt_error(attempt, position, code, span, correction, point, target)"
            " VALUES(?, ?, ?, ?, ?, ?, ?)")
            .bind(attempt.id)
            .bind(position++)
            .bind(error.code)
            .bind(error.span)
            .bind(error.correction)
            .bind(error.point)
            .bind(error.target)
            .run();
    }
}

}  // namespace fulcrum::runtime::sqlite
