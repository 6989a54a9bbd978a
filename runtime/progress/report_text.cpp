#include "runtime/progress/report_text.h"

#include "dialogue/unicode.h"
#include "runtime/progress/text_rules.h"

#include <algorithm>
#include <array>

namespace fulcrum::runtime {
namespace {

constexpr std::size_t kLineColumns = 80;
constexpr std::size_t kLessonIndent = 2;
constexpr std::size_t kTableIndent = 4;
constexpr std::size_t kNoteIndent = 6;
constexpr std::size_t kNameWidth = 20;  // of a question, before its numbers

// The numbers of a question: two header lines and the width of each column.
struct Column {
    const char* above;
    const char* head;
    std::size_t width;
};
constexpr std::array<Column, 7> kNumbers{{{"", "asked", 6},
                                          {"", "attempts", 9},
                                          {"right", "at once", 8},
                                          {"right", "in end", 7},
                                          {"not un-", "derstood", 9},
                                          {"form", "wrong", 6},
                                          {"wrong in", "a row now", 10}}};

// Whatever the database holds, the terminal gets no control characters.
std::string printable(const std::string& text) {
    return kept_text(text);
}

std::string right_aligned(const std::string& text, std::size_t width) {
    return std::string(width - std::min(width, text.size()), ' ') + text;
}

std::string padded(const std::string& text, std::size_t width) {
    return text + std::string(width - std::min(width, display_width(text)), ' ');
}

// Cuts a word that is longer than a line; every piece but the last fills `width`.
std::string_view next_piece(std::string_view word, std::size_t width) {
    std::size_t used = 0;
    std::size_t at = 0;
    while (at < word.size()) {
        const dialogue::Character character = dialogue::character_at(word, at);
        used += static_cast<std::size_t>(dialogue::columns_of(character.code));
        if (used > width && at > 0) {
            break;
        }
        at += character.bytes;
    }
    return word.substr(0, at);
}

// Text in lines of at most 80 columns, broken at blanks; lines after the first are set in by two
// more.
void write_wrapped(const std::string& text, std::size_t indent, std::string& out) {
    std::string line(indent, ' ');
    bool line_has_word = false;
    const auto break_line = [&] {
        out += line + '\n';
        line.assign(indent + 2, ' ');
        line_has_word = false;
    };
    std::size_t at = 0;
    while (at < text.size()) {
        const std::size_t end = std::min(text.find(' ', at), text.size());
        std::string_view word = std::string_view(text).substr(at, end - at);
        at = end + 1;
        if (line_has_word && display_width(line) + 1 + display_width(word) > kLineColumns) {
            break_line();
        }
        while (display_width(line) + (line_has_word ? 1 : 0) + display_width(word) > kLineColumns) {
            const std::string_view piece = next_piece(word, kLineColumns - display_width(line));
            line += piece;
            word.remove_prefix(piece.size());
            break_line();
        }
        line += (line_has_word ? " " : "") + std::string(word);
        line_has_word = true;
    }
    out += line + '\n';
}

void write_notes(const QuestionReport& question, std::string& out) {
    write_wrapped(marks_of(question), kNoteIndent, out);
    std::string points;
    for (const GrammarPointReport& point : question.points) {
        points += (points.empty() ? "slips: " : ", ") + plain_words(point);
    }
    if (!points.empty()) {
        write_wrapped(printable(points), kNoteIndent, out);
    }
    for (const FormErrorReport& error : question.form_errors) {
        write_wrapped(printable(plain_words(error)), kNoteIndent, out);
    }
    if (question.invited > 0) {
        write_wrapped("said once more when asked to: right " + std::to_string(question.repaired) +
                          " of " + std::to_string(question.invited) +
                          (question.invited == 1 ? " time" : " times"),
                      kNoteIndent, out);
    }
    if (question.moved_on > 0) {
        write_wrapped("let go on without a right answer " + times(question.moved_on), kNoteIndent,
                      out);
    }
    if (question.stuck == Stuck::now) {
        write_wrapped(
            "STUCK now: the last " + std::to_string(question.wrong_now) + " answers were not right",
            kNoteIndent, out);
    } else if (question.stuck == Stuck::before) {
        write_wrapped("was stuck before (" + std::to_string(question.wrong_in_a_row) +
                          " answers in a row were not right), and went on",
                      kNoteIndent, out);
    }
}

void write_question(const QuestionReport& question, std::string& out) {
    const std::string name = printable(question.question);
    if (display_width(name) <= kNameWidth) {
        out.append(kTableIndent, ' ').append(padded(name, kNameWidth));
    } else {
        write_wrapped(name, kTableIndent, out);
        out.append(kTableIndent + kNameWidth, ' ');
    }
    const std::array<std::int64_t, kNumbers.size()> numbers{question.asked,
                                                            question.attempts,
                                                            question.right_first_time,
                                                            question.right_in_the_end,
                                                            question.not_understood,
                                                            question.form_wrong,
                                                            question.wrong_now};
    for (std::size_t i = 0; i < numbers.size(); ++i) {
        out += right_aligned(std::to_string(numbers[i]), kNumbers[i].width);
    }
    out += '\n';
    write_notes(question, out);
}

void write_table(const LessonReport& lesson, std::string& out) {
    if (lesson.questions.empty()) {
        write_wrapped("no question answered yet", kTableIndent, out);
        return;
    }
    std::string above(kTableIndent + kNameWidth, ' ');
    std::string head(kTableIndent, ' ');
    head += padded("question", kNameWidth);
    for (const Column& column : kNumbers) {
        above += right_aligned(column.above, column.width);
        head += right_aligned(column.head, column.width);
    }
    out += above + '\n' + head + '\n';
    for (const QuestionReport& question : lesson.questions) {
        write_question(question, out);
    }
}

void write_lesson(const LessonReport& lesson, bool with_questions, const ReportStyle& style,
                  std::string& out) {
    write_wrapped(printable(lesson.lesson) + ": played " + times(lesson.played) + ", finished " +
                      (lesson.finished == 0 ? "not yet" : times(lesson.finished)) + ", last on " +
                      time_cell(lesson.last_played_utc_ms, style),
                  kLessonIndent, out);
    if (lesson.best_stars && lesson.best_score) {
        write_wrapped("best: " + std::to_string(*lesson.best_stars) +
                          (*lesson.best_stars == 1 ? " star" : " stars") + ", score " +
                          std::to_string(*lesson.best_score),
                      kTableIndent, out);
    }
    if (with_questions) {
        write_table(lesson, out);
    }
}

// "(gravity: heavier, said "the egg")".
std::string where_stuck(const LessonReport& lesson, const QuestionReport& question) {
    const std::string said = printable(question.last_wrong);
    return " (" + printable(lesson.lesson) + ": " + printable(question.question) +
           (said.empty() ? "" : ", said \"" + said + "\"") + ")";
}

void write_stuck(const Report& report, std::string& out) {
    std::string names;
    for (const LearnerReport& learner : report.learners) {
        for (const LessonReport& lesson : learner.lessons) {
            for (const QuestionReport& question : lesson.questions) {
                if (question.stuck == Stuck::now) {
                    names += (names.empty() ? "" : ", ") + printable(learner.learner.nickname) +
                             where_stuck(lesson, question);
                }
            }
        }
    }
    write_wrapped(names.empty() ? "Nobody is stuck." : "Stuck now: " + names + ".", 0, out);
}

// The sentence for a report without learners.
std::string nobody(const ProgressFilter& filter) {
    if (!filter.nickname.empty()) {
        return "There is no learner called \"" + printable(filter.nickname) +
               "\" here; fulcrum report without --learner shows everybody.";
    }
    if (!filter.lesson.empty()) {
        return "Nobody has played a lesson called \"" + printable(filter.lesson) +
               "\" here; fulcrum report without --lesson shows all that was played.";
    }
    return "Nobody has played yet. Play a lesson first, for example: fulcrum run gravity";
}

}  // namespace

std::string to_text(const Report& report, const ReportStyle& style) {
    std::string out;
    if (report.learners.empty()) {
        write_wrapped(nobody(report.filter), 0, out);
        return out;
    }
    write_stuck(report, out);
    for (const LearnerReport& learner : report.learners) {
        out += '\n';
        write_wrapped(printable(learner.learner.nickname), 0, out);
        if (learner.guests > 0) {
            write_wrapped("each by itself: fulcrum report --guests", kLessonIndent, out);
        }
        if (learner.lessons.empty()) {
            const std::string lesson = printable(report.filter.lesson);
            write_wrapped(
                lesson.empty() ? "has not played yet" : "has not played " + lesson + " yet",
                kLessonIndent, out);
        }
        for (const LessonReport& lesson : learner.lessons) {
            write_lesson(lesson, learner.guests == 0, style, out);
        }
    }
    return out;
}

}  // namespace fulcrum::runtime
