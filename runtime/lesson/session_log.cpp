#include "runtime/lesson/session_log.h"

#include "dialogue/marking/grammar_point.h"

#include <algorithm>
#include <utility>

namespace fulcrum::runtime {

namespace {

/// What the rules of English found in words that fit no answer, as the questions' own errors are kept.
dialogue::FormError to_form_error(const dialogue::FreeError& found) {
    dialogue::FormError error;
    error.code = found.code;
    error.said = found.said;
    error.begin = found.begin;
    error.end = found.end;
    error.right = found.right;
    // "More heavier": of adjectives the rules find forms of comparison alone.
    const bool compares = found.code == dialogue::ErrorCode::adjective_form;
    error.degree = compares ? dialogue::Degree::comparative : dialogue::Degree::positive;
    return error;
}

/// As a teacher reads it without the sentence: "made by" and not "by", and what a verb that came too late belongs before.
ErrorRecord to_record(const dialogue::FormError& error) {
    using Code = dialogue::ErrorCode;
    ErrorRecord record{std::string(error.errant()), error.said, error.right,
                       std::string(dialogue::grammar_point_id(dialogue::grammar_point(error))),
                       error.target};
    const bool preposition =
        error.code == Code::wrong_preposition || error.code == Code::missing_preposition;
    if (error.passive && preposition) {
        record.span = error.said.empty() ? "made" : "made " + error.said;
        record.correction = "made " + error.right;
    } else if (error.code == Code::word_order && error.said.empty() && !error.phrase.empty()) {
        record.correction = error.phrase;
    }
    return record;
}

}  // namespace

SessionLog::SessionLog(ProgressStore& store, SessionRecord session, bool keeps)
    : store_(&store), keeps_(keeps), session_(std::move(session)) {
    keep([&] { return store_->begin_session(session_); });
}

void SessionLog::keep_attempt(const MarkedAnswer& answer) {
    const dialogue::Mark& mark = answer.mark;
    AttemptRecord attempt;
    attempt.id = random_record_id();
    attempt.session = session_.id;
    attempt.question = answer.question;
    attempt.attempt = answer.feedback.attempt;
    attempt.said = mark.said;
    attempt.understood = mark.understood;
    attempt.meaning_right = answer.right;
    attempt.form_known = mark.form_known;
    attempt.form_right = mark.understood && mark.form_right();
    attempt.target_right = mark.understood && mark.target_right();
    attempt.confidence = mark.confidence;
    attempt.feedback = name_of(answer.feedback.kind);
    attempt.uptake = name_of(answer.feedback.uptake);
    for (const auto& [name, value] : mark.slots) {
        attempt.slots.append(attempt.slots.empty() ? "" : " ")
            .append(name)
            .append("=")
            .append(value);
    }
    attempt.answer_s = answer.answer_s;
    attempt.said_utc_ms = utc_now_ms();
    for (const dialogue::FormError& error : mark.form_errors) {
        attempt.errors.push_back(to_record(error));
    }
    for (const dialogue::FreeError& error : answer.feedback.free_errors) {
        attempt.errors.push_back(to_record(to_form_error(error)));
    }
    keep([&] { return store_->add_attempt(attempt); });
}

void SessionLog::keep_setting(const std::string& name, const std::string& value) {
    const SessionSetting setting{session_.id, name, value};
    keep([&] { return store_->add_setting(setting); });
}

void SessionLog::keep_end(EndReason reason, int stars, int score, int level) {
    if (std::exchange(ended_, true)) {
        return;
    }
    const SessionEnd end{session_.id,        utc_now_ms(), reason,
                         std::max(stars, 0), score,        std::max(level, 1)};
    keep([&] { return store_->end_session(end); });
}

// A write whose outcome is unknown may be repeated: it carries its own id.
void SessionLog::keep(const std::function<Expected<void>()>& write) {
    if (!keeps_) {
        return;
    }
    Expected<void> written = write();
    if (!written) {
        written = write();
    }
    if (!written) {
        note(written.error());
    }
}

void SessionLog::look_for_trouble() {
    if (const auto error = store_->take_trouble()) {
        note(*error);
    }
}

void SessionLog::settle(double patience_s) {
    const Expected<void> settled = store_->settle(patience_s);
    look_for_trouble();
    if (!settled) {
        note(settled.error());
    }
}

void SessionLog::note(const Error& error) {
    if (trouble_.empty()) {
        trouble_ = to_sentence(error);
    }
}

}  // namespace fulcrum::runtime
