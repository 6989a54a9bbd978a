// What a teacher wants to know of the learners' progress: who played what, what went well, who is
// stuck. One struct, computed once; the text (report_text.h) and the CSV (report_csv.h) are written from it, so that they show the
// same numbers.
//
//   asked             times the question was put (a new session, or attempt numbers that begin
//   again) right             the meaning was right; a wrong form is counted apart right_first_time
//   of `asked`, those whose first attempt was right;   right_in_the_end: whose last attempt was
//   wrong_in_a_row    longest run of attempts that were not right, over all sessions, in the order
//   of their writing          wrong_now    the run that the last attempt belongs to, 0 when that was right
//   moved_on, invited, repaired    what was said to the answers, and what the learner made of it; answers that were kept before
//   that was kept count for none
//   meaning_right, target_right of target_judged, other_form_errors, confidence    an answer's four marks, summed, the last as the mean of
//   all attempts. The form that a question teaches counts where it was judged and kept: understood, heard with its form, and not so old that
//   nothing was kept of it.
//   stuck             wrong_in_a_row ≥ 3: `now` while the last three attempts are not right, else `before`
//
// The simulated pupil is no learner of the class: it is left out unless it is asked for by its nickname. Guests (guest_name.h) come once each:
// unless they are asked for, they stand behind the others as one entry, "Guests (12)", with what they played and without their answers.
//
// Thread: any. Cost: in proportion to the attempts.
#pragma once

#include "haptics/base/error.h"
#include "runtime/progress/store.h"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace fulcrum::runtime {

/// So many attempts in a row that are not right make a learner stuck on a question.
inline constexpr std::int64_t kStuckAfter = 3;

enum class Stuck : std::uint8_t { no, before, now };

/// The same words for the same right words, and how often.
struct FormExample {
    std::string span;        ///< the learner's words; empty when something was left out
    std::string correction;  ///< what belongs there; empty when nothing does
    std::int64_t count = 0;
};

/// One kind of error of form in the answers to one question.
struct FormErrorReport {
    std::string code;                   ///< e.g. "R:ADJ:FORM"
    std::int64_t count = 0;             ///< how often it was found
    std::string span;                   ///< the newest example, the learner's words
    std::string correction;             ///< what belongs there
    std::vector<FormExample> examples;  ///< all of them, the most frequent first
};

/// How a point of grammar goes in the answers to one question.
struct GrammarPointReport {
    std::string point;       ///< e.g. "passive_voice"
    std::int64_t count = 0;  ///< errors that belong to it
    std::int64_t answers_since =
        0;  ///< answers whose form was judged since the last of them, that one not counted
};

struct QuestionReport {
    std::string question;
    std::int64_t asked = 0;
    std::int64_t attempts = 0;
    std::int64_t right_first_time = 0;
    std::int64_t right_in_the_end = 0;
    std::int64_t not_understood = 0;     ///< attempts that no template fitted; they are not right
    std::int64_t form_judged = 0;        ///< attempts that were understood and whose form was heard
    std::int64_t form_wrong = 0;         ///< of these, those that had an error of form
    std::int64_t meaning_right = 0;      ///< attempts that were understood and right
    std::int64_t target_judged = 0;      ///< attempts whose taught form was judged
    std::int64_t target_right = 0;       ///< of these, those in which it was right
    std::int64_t other_form_errors = 0;  ///< errors outside the taught form, in all attempts
    double confidence = 0.0;  ///< of what heard them, the mean, 0 to 1; what was typed counts as 1
    std::int64_t wrong_in_a_row = 0;
    std::int64_t wrong_now = 0;
    std::int64_t moved_on = 0;  ///< times the learner was let go on without a right answer
    std::int64_t invited = 0;   ///< times a right answer was to be said once more
    std::int64_t repaired = 0;  ///< of these, those that were then said rightly
    std::string last_wrong{};  ///< the newest words that were not right; empty where there are none
    Stuck stuck = Stuck::no;
    std::vector<FormErrorReport> form_errors;  ///< the most frequent first
    std::vector<GrammarPointReport> points;    ///< the most frequent first
};

struct LessonReport {
    std::string lesson;
    std::int64_t played = 0;                 ///< sessions begun
    std::int64_t finished = 0;               ///< sessions that came to their end
    std::int64_t last_played_utc_ms = 0;     ///< beginning of the newest session
    std::optional<std::int32_t> best_stars;  ///< of all ends; none when no session has an end
    std::optional<std::int32_t> best_score;
    std::vector<QuestionReport> questions;  ///< in the order in which they were first answered
};

struct LearnerReport {
    Learner learner;
    std::vector<LessonReport>
        lessons;  ///< in the order in which they were first played; empty: has not played
    std::size_t guests =
        0;  ///< so many guests together, of whom the learner is only the heading; 0: one learner
};

struct Report {
    ProgressFilter filter;
    std::vector<LearnerReport> learners;  ///< by nickname
};

/// Pure: the same data give the same report. A lesson that nobody has played gives a report without learners, unless one
/// learner is asked for.
[[nodiscard]] Report compute_report(const ProgressData& data, const ProgressFilter& filter = {});

/// Reads what the filter matches and computes the report.
[[nodiscard]] Expected<Report> make_report(ProgressStore& store, const ProgressFilter& filter = {});

}  // namespace fulcrum::runtime
