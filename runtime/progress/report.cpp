#include "runtime/progress/report.h"

#include "runtime/progress/guest_name.h"
#include "runtime/progress/text_rules.h"

#include <algorithm>
#include <cctype>
#include <map>
#include <unordered_map>
#include <unordered_set>

namespace fulcrum::runtime {
namespace {

bool is_right(const AttemptRecord& attempt) noexcept {
    return attempt.understood && attempt.meaning_right;
}

// The forms of an answer that has been kept with what was said to it; older ones do not tell the taught form from others.
bool target_is_judged(const AttemptRecord& attempt) noexcept {
    return attempt.understood && attempt.form_known && !attempt.feedback.empty();
}

// Where the taught form is wrong one error at least belongs to it, whether it is marked so or older than such marks.
std::int64_t count_other_errors(const AttemptRecord& attempt) {
    const auto of_target = std::ranges::count_if(attempt.errors, &ErrorRecord::target);
    const std::ptrdiff_t least = target_is_judged(attempt) && !attempt.target_right ? 1 : 0;
    return std::max<std::int64_t>(
        std::ssize(attempt.errors) - std::max<std::ptrdiff_t>(of_target, least), 0);
}

void add_example(std::vector<FormExample>& examples, const ErrorRecord& error) {
    const auto known = std::find_if(examples.begin(), examples.end(), [&](const FormExample& one) {
        return one.span == error.span && one.correction == error.correction;
    });
    if (known == examples.end()) {
        examples.push_back({error.span, error.correction, 1});
    } else {
        ++known->count;
    }
}

// The most frequent first; equal ones as they came.
template <class Counted>
void sort_by_count(std::vector<Counted>& list) {
    std::stable_sort(list.begin(), list.end(),
                     [](const auto& a, const auto& b) { return a.count > b.count; });
}

// One question's attempts, taken in the order of their writing.
class QuestionTally {
  public:
    void add(const AttemptRecord& attempt) {
        const bool right = is_right(attempt);
        // A new session, or a number that does not go on counting: the question was put anew.
        if (attempt.session != session_ || attempt.attempt <= number_) {
            close_asking();
            ++report_.asked;
            report_.right_first_time += right ? 1 : 0;
        }
        session_ = attempt.session;
        number_ = attempt.attempt;
        last_right_ = right;

        ++report_.attempts;
        report_.meaning_right += right ? 1 : 0;
        confidences_ += attempt.confidence;
        count_form(attempt);
        // The names are those of dialogue/conversation/conversation.h, as they were kept.
        report_.moved_on += attempt.feedback == "moved_on" ? 1 : 0;
        report_.invited += attempt.feedback == "prompt" ? 1 : 0;
        report_.repaired += attempt.uptake == "repaired" ? 1 : 0;
        if (!right) {
            report_.last_wrong = attempt.said;
        }
        wrong_run_ = right ? 0 : wrong_run_ + 1;
        report_.wrong_in_a_row = std::max(report_.wrong_in_a_row, wrong_run_);
        for (const ErrorRecord& error : attempt.errors) {
            if (!error.point.empty()) {
                GrammarPointReport& point = points_[error.point];
                point.point = error.point;
                point.count += 1;
                point.answers_since = 0;
            }
            FormErrorReport& kind = errors_[error.code];
            kind.code = error.code;
            kind.count += 1;
            kind.span = error.span;
            kind.correction = error.correction;
            add_example(kind.examples, error);
        }
    }

    [[nodiscard]] QuestionReport finish(const std::string& question) {
        close_asking();
        report_.question = question;
        report_.confidence = confidences_ / static_cast<double>(report_.attempts);
        if (report_.wrong_in_a_row >= kStuckAfter) {
            report_.stuck = wrong_run_ >= kStuckAfter ? Stuck::now : Stuck::before;
        }
        report_.wrong_now = wrong_run_;
        for (auto& [code, kind] : errors_) {
            sort_by_count(kind.examples);
            report_.form_errors.push_back(std::move(kind));
        }
        sort_by_count(report_.form_errors);
        for (auto& [name, point] : points_) {
            report_.points.push_back(std::move(point));
        }
        sort_by_count(report_.points);
        return std::move(report_);
    }

  private:
    void count_form(const AttemptRecord& attempt) {
        report_.not_understood += attempt.understood ? 0 : 1;
        const bool judged = attempt.understood && attempt.form_known;
        report_.form_judged += judged ? 1 : 0;
        report_.form_wrong += judged && !attempt.form_right ? 1 : 0;
        report_.target_judged += target_is_judged(attempt) ? 1 : 0;
        report_.target_right += target_is_judged(attempt) && attempt.target_right ? 1 : 0;
        report_.other_form_errors += count_other_errors(attempt);
        for (auto& [name, point] : points_) {
            point.answers_since += judged ? 1 : 0;
        }
    }

    void close_asking() {
        report_.right_in_the_end += last_right_ ? 1 : 0;
        last_right_ = false;
    }

    QuestionReport report_;
    std::map<std::string, FormErrorReport>
        errors_;  // by code, so that equal counts come in a fixed order
    std::map<std::string, GrammarPointReport> points_;  // by name, likewise
    RecordId session_;
    std::int32_t number_ = 0;
    std::int64_t wrong_run_ = 0;
    bool last_right_ = false;
    double confidences_ = 0.0;
};

// Things by name in the order of their first appearance.
template <class Value>
class InOrder {
  public:
    Value& operator[](const std::string& name) {
        const auto [place, is_new] = places_.try_emplace(name, values_.size());
        if (is_new) {
            values_.emplace_back(name, Value{});
        }
        return values_[place->second].second;
    }
    [[nodiscard]] auto begin() { return values_.begin(); }
    [[nodiscard]] auto end() { return values_.end(); }

  private:
    std::unordered_map<std::string, std::size_t> places_;
    std::vector<std::pair<std::string, Value>> values_;
};

struct LessonTally {
    LessonReport report;
    InOrder<QuestionTally> questions;
};
using LearnerTally = InOrder<LessonTally>;

void add_end(LessonReport& report, const SessionEnd& end) {
    report.finished += end.reason == EndReason::finished ? 1 : 0;
    report.best_stars = std::max(report.best_stars.value_or(end.stars), end.stars);
    report.best_score = std::max(report.best_score.value_or(end.score), end.score);
}

// All guests together, whose answers are left out.
const LearnerId kGuests;

std::unordered_map<LearnerId, LearnerTally> tally(const ProgressData& data,
                                                  const std::unordered_set<LearnerId>& guests) {
    const auto owner_of = [&](const SessionRecord& session) -> const LearnerId& {
        return guests.contains(session.learner) ? kGuests : session.learner;
    };
    std::unordered_map<LearnerId, LearnerTally> learners;
    std::unordered_map<RecordId, const SessionRecord*> sessions;
    for (const SessionRecord& session : data.sessions) {
        sessions[session.id] = &session;
        LessonReport& report = learners[owner_of(session)][session.lesson].report;
        ++report.played;
        report.last_played_utc_ms = std::max(report.last_played_utc_ms, session.started_utc_ms);
    }
    const auto lesson_of = [&](const RecordId& session) -> LessonTally* {
        const auto found = sessions.find(session);
        return found == sessions.end() ? nullptr
                                       : &learners[owner_of(*found->second)][found->second->lesson];
    };
    for (const SessionEnd& end : data.ends) {
        if (LessonTally* lesson = lesson_of(end.session)) {
            add_end(lesson->report, end);
        }
    }
    for (const AttemptRecord& attempt : data.attempts) {
        LessonTally* const lesson = lesson_of(attempt.session);
        if (lesson != nullptr && !guests.contains(sessions[attempt.session]->learner)) {
            lesson->questions[attempt.question].add(attempt);
        }
    }
    return learners;
}

// Of these, who played what the filter matched.
std::size_t count_players(const ProgressData& data, const std::unordered_set<LearnerId>& of) {
    std::unordered_set<LearnerId> players;
    for (const SessionRecord& session : data.sessions) {
        if (of.contains(session.learner)) {
            players.insert(session.learner);
        }
    }
    return players.size();
}

}  // namespace

Report compute_report(const ProgressData& data, const ProgressFilter& filter) {
    std::unordered_set<LearnerId> guests;
    for (const Learner& learner : data.learners) {
        if (filter.nickname.empty() && !filter.each_guest && is_guest_name(learner.nickname)) {
            guests.insert(learner.id);
        }
    }
    auto tallies = tally(data, guests);
    Report report{filter, {}};
    bool played = false;
    const auto add = [&](const Learner& learner, std::size_t n_guests) {
        LearnerReport of_learner{learner, {}, n_guests};
        for (auto& [lesson, lesson_tally] : tallies[learner.id]) {
            LessonReport of_lesson = std::move(lesson_tally.report);
            of_lesson.lesson = lesson;
            for (auto& [question, question_tally] : lesson_tally.questions) {
                of_lesson.questions.push_back(question_tally.finish(question));
            }
            of_learner.lessons.push_back(std::move(of_lesson));
            played = true;
        }
        report.learners.push_back(std::move(of_learner));
    };
    for (const Learner& learner : data.learners) {
        const bool is_pupil = !filter.nickname.empty() || learner.nickname != kSimulatedPupil;
        if (is_pupil && !guests.contains(learner.id)) {
            add(learner, 0);
        }
    }
    if (const std::size_t n_guests = count_players(data, guests); n_guests > 0) {
        add({kGuests, "Guests (" + std::to_string(n_guests) + ")", 0}, n_guests);
    }
    // A lesson's name with a slip in it: a list of all who have not played it would hide that.
    if (!played && !filter.lesson.empty() && filter.nickname.empty()) {
        report.learners.clear();
    }
    std::sort(report.learners.begin(), report.learners.end(), [](const auto& a, const auto& b) {
        const auto place = [](const LearnerReport& one) {
            return std::tuple(one.guests, folded_nickname(one.learner.nickname), one.learner.id);
        };
        return place(a) < place(b);
    });
    return report;
}

Expected<Report> make_report(ProgressStore& store, const ProgressFilter& filter) {
    return store.read(filter).map(
        [&](const ProgressData& data) { return compute_report(data, filter); });
}

}  // namespace fulcrum::runtime
