// A report as CSV. RFC 4180: rows end in CR LF, a cell with a separator, quote or line end stands
// in quotes, and a quote in it is doubled.
#include "runtime/progress/report_csv.h"

#include "dialogue/unicode.h"
#include "runtime/progress/text_rules.h"

#include <array>

namespace fulcrum::runtime {
namespace {

constexpr const char* kHeader =
    "learner,learner_id,lesson,played,finished,last_played,best_stars,best_score,question,asked,"
    "attempts,right_first_time,right_in_the_end,not_understood,form_wrong,wrong_now,wrong_in_a_row,"
    "stuck,"
    "form_errors,examples,grammar_points,answers_since,moved_on,invited,repaired,last_wrong,"
    "meaning_right,target_judged,target_right,other_form_errors,confidence";
constexpr std::size_t kColumns = 31;
constexpr std::size_t kQuestionColumn = 8;

using Row = std::array<std::string, kColumns>;

// True when a spreadsheet would take the cell for a formula: = + - @, also in their full-width
// forms and after blanks, and control characters.
bool looks_like_formula(std::string_view text) noexcept {
    for (std::size_t at = 0; at < text.size();) {
        const dialogue::Character character = dialogue::character_at(text, at);
        if (is_control(character.code)) {
            return true;
        }
        if (character.code != ' ' && character.code != 0xA0 && character.code != 0x3000) {
            constexpr std::u32string_view kStarts = U"=+-@\uFF1D\uFF0B\uFF0D\uFF20";
            return kStarts.find(character.code) != std::u32string_view::npos;
        }
        at += character.bytes;
    }
    return false;
}

std::string text_cell(const std::string& text) {
    std::string safe = looks_like_formula(text) ? "'" + text : text;
    // Semicolons and tabs separate cells in some countries' spreadsheets.
    if (safe.find_first_of(",;\t\"\r\n") == std::string::npos) {
        return safe;
    }
    std::string quoted = "\"";
    for (const char c : safe) {
        quoted += c == '"' ? "\"\"" : std::string(1, c);
    }
    return quoted + '"';
}

void write_row(const Row& row, std::string& csv) {
    for (std::size_t i = 0; i < row.size(); ++i) {
        csv += (i == 0 ? "" : ",") + row[i];
    }
    csv += "\r\n";
}

std::string optional_cell(const std::optional<std::int32_t>& number) {
    return number ? std::to_string(*number) : "";
}

void fill_question(const QuestionReport& question, Row& row) {
    std::string errors;
    std::string examples;
    for (const FormErrorReport& error : question.form_errors) {
        const char* separator = errors.empty() ? "" : "; ";
        errors += separator + error_cell(error);
        examples += separator + example_cell(error);
    }
    std::string points;
    std::string since;
    for (const GrammarPointReport& point : question.points) {
        const char* separator = points.empty() ? "" : "; ";
        points += separator + point_cell(point);
        since += separator + since_cell(point);
    }
    std::size_t at = kQuestionColumn;
    row[at++] = text_cell(question.question);
    for (const std::int64_t number :
         {question.asked, question.attempts, question.right_first_time, question.right_in_the_end,
          question.not_understood, question.form_wrong, question.wrong_now,
          question.wrong_in_a_row}) {
        row[at++] = std::to_string(number);
    }
    row[at++] = stuck_cell(question.stuck);
    row[at++] = text_cell(errors);
    row[at++] = text_cell(examples);
    row[at++] = text_cell(points);
    row[at++] = text_cell(since);
    for (const std::int64_t number : {question.moved_on, question.invited, question.repaired}) {
        row[at++] = std::to_string(number);
    }
    row[at++] = text_cell(question.last_wrong);
    for (const std::int64_t number : {question.meaning_right, question.target_judged,
                                      question.target_right, question.other_form_errors}) {
        row[at++] = std::to_string(number);
    }
    row[at++] = confidence_cell(question.confidence);
}

void write_lesson(const LessonReport& lesson, const ReportStyle& style, Row row, std::string& csv) {
    row[2] = text_cell(lesson.lesson);
    row[3] = std::to_string(lesson.played);
    row[4] = std::to_string(lesson.finished);
    row[5] = time_cell(lesson.last_played_utc_ms, style);
    row[6] = optional_cell(lesson.best_stars);
    row[7] = optional_cell(lesson.best_score);
    if (lesson.questions.empty()) {
        write_row(row, csv);
    }
    for (const QuestionReport& question : lesson.questions) {
        fill_question(question, row);
        write_row(row, csv);
    }
}

}  // namespace

std::string to_csv(const Report& report, const ReportStyle& style) {
    std::string csv = style.byte_order_mark ? "\xEF\xBB\xBF" : "";
    csv += kHeader;
    csv += "\r\n";
    for (const LearnerReport& learner : report.learners) {
        Row row;
        row[0] = text_cell(learner.learner.nickname);
        row[1] = text_cell(learner.learner.id);
        if (learner.lessons.empty()) {
            write_row(row, csv);
        }
        for (const LessonReport& lesson : learner.lessons) {
            write_lesson(lesson, style, row, csv);
        }
    }
    return csv;
}

}  // namespace fulcrum::runtime
