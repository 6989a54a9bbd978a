// Progress written down answer by answer, for tests of reports.
#pragma once

#include "runtime/progress/report_cells.h"

#include <cstdint>
#include <string>

namespace fulcrum::runtime::test {

inline constexpr ReportStyle kUtc{.utc = true};
inline constexpr std::int64_t kMorning_utc_ms = 1'772'446'500'000;  // 2026-03-02 10:15 UTC

/// Progress that is written down answer by answer. Ids are plain words: the report does not look
/// into them.
class Diary {
  public:
    explicit Diary(std::string nickname) { learner(std::move(nickname)); }

    Diary& learner(std::string nickname) {
        data.learners.push_back({"id-of-" + nickname, std::move(nickname), 0});
        return *this;
    }
    Diary& session(const std::string& lesson, std::int64_t started_utc_ms = kMorning_utc_ms) {
        SessionRecord session;
        session.id = "session " + std::to_string(data.sessions.size());
        session.learner = data.learners.back().id;
        session.lesson = lesson;
        session.started_utc_ms = started_utc_ms;
        data.sessions.push_back(session);
        return *this;
    }
    Diary& end(std::int32_t stars, std::int32_t score, EndReason reason = EndReason::finished) {
        data.ends.push_back({data.sessions.back().id, kMorning_utc_ms, reason, stars, score, 1});
        return *this;
    }
    // One letter an answer: R right, F right with a wrong form, P the same, to be said once more, S said rightly then, W wrong,
    // U not understood, M the same, and let go on; N right, and V wrong, by who hears the meaning alone.
    Diary& answers(const std::string& question, const std::string& letters) {
        std::int32_t number = 0;
        for (const char letter : letters) {
            AttemptRecord attempt;
            attempt.session = data.sessions.back().id;
            attempt.question = question;
            attempt.attempt = ++number;
            const bool form_wrong = letter == 'F' || letter == 'P';
            attempt.understood = letter != 'U' && letter != 'M';
            attempt.meaning_right = letter == 'R' || letter == 'S' || letter == 'N' || form_wrong;
            attempt.form_known = letter != 'N' && letter != 'V';
            attempt.form_right = letter == 'R' || letter == 'S' || letter == 'W';
            attempt.target_right = attempt.form_right;
            attempt.feedback = letter == 'P'           ? "prompt"
                               : letter == 'M'         ? "moved_on"
                               : letter == 'F'         ? "recast"
                               : !attempt.understood   ? "not_understood"
                               : attempt.meaning_right ? "praise"
                                                       : "wrong_meaning";
            attempt.uptake = letter == 'S' ? "repaired" : "";
            attempt.said = letter == 'W' ? "the egg" : letter == 'M' ? "hm" : "";
            if (form_wrong) {
                attempt.errors = {{"R:ADJ:FORM", "most heavy", "heaviest", "comparison", true}};
            }
            data.attempts.push_back(attempt);
        }
        return *this;
    }

    ProgressData data;
};

}  // namespace fulcrum::runtime::test
