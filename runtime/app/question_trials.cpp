#include "runtime/app/question_trials.h"

#include "dialogue/conversation/help.h"
#include "dialogue/marking/mark_answer.h"
#include "runtime/lesson/questions.h"

#include <algorithm>
#include <array>
#include <utility>

namespace fulcrum::runtime {
namespace {

constexpr std::size_t kMostMeanings = 100;  // of one answer
/// Nobody answers sooner; things that were placed for the question have come to their places.
constexpr double kReading_s = 0.5;

/// What the lesson's own function says went wrong, with what it was called for before it.
tl::unexpected<Error> when(const std::string& tried, Error error) {
    error.message = tried + ": " + error.message;
    return tl::unexpected(std::move(error));
}

std::string head_of(const QuestionDescription& described) {
    return "question \"" + described.id + "\"";
}

std::string line_of(const QuestionDescription& described) {
    return "lesson.lua:" + std::to_string(described.line) + ": " + head_of(described);
}

}  // namespace

Expected<std::size_t> QuestionTrials::count_right(const QuestionDescription& described,
                                                  const std::vector<dialogue::Meaning>& meanings) {
    std::size_t n = 0;
    for (const dialogue::Meaning& meaning : meanings) {
        const auto verdict = run_.aside().ask_verdict({described.id, meaning.slots});
        if (!verdict) {
            return when(head_of(described) + ", tried with \"" + meaning.said + "\"",
                        verdict.error());
        }
        n += *verdict ? 1 : 0;
    }
    return n;
}

Expected<void> QuestionTrials::try_help(const QuestionDescription& described,
                                        const dialogue::Question& question) {
    for (const int rung : {2, 3}) {
        const std::string told = dialogue::help_for(question, rung).sentence;
        const bool has_gap = told.find("…") != std::string::npos;
        const dialogue::Mark mark = dialogue::mark_answer(question, told);
        if (told.empty() || has_gap || told.ends_with('?') || !mark.understood) {
            continue;
        }
        const auto verdict = run_.aside().ask_verdict({described.id, mark.slots});
        if (!verdict) {
            return when(head_of(described) + ", tried with \"" + told + "\"", verdict.error());
        }
        if (*verdict) {
            notes_.push_back(line_of(described) + ": who asks for help is told what is right, \"" +
                             told +
                             "\"; let the first of `answers` have a list for that word, with "
                             "others that are not right.");
            return {};
        }
    }
    return {};
}

bool QuestionTrials::note_unanswerable(const QuestionDescription& described,
                                       const dialogue::Meanings& meanings) {
    if (!meanings.some.empty()) {
        return false;
    }
    notes_.push_back(line_of(described) +
                     ": nobody can answer this question, for not even a sentence of its own "
                     "`answers` is understood; write shorter ones.");
    return true;
}

void QuestionTrials::try_open_one(double now_s) {
    const dialogue::Question* const open = run_.session().question();
    const SessionHud& hud = run_.session().hud();
    const bool has_time = hud.question_open && now_s - hud.question_asked_at_s >= kReading_s;
    if (failed_ || open == nullptr || !has_time || !tried_.insert(open->id).second) {
        return;
    }
    const auto& all = run_.description().questions;
    const auto described = std::ranges::find(all, open->id, &QuestionDescription::id);
    const dialogue::Meanings meanings = dialogue::meanings_of(*open, kMostMeanings);
    if (note_unanswerable(*described, meanings)) {
        return;
    }
    const auto n_right = count_right(*described, meanings.some);
    if (!n_right) {
        failed_ = n_right.error();
    } else if (*n_right == 0 && meanings.all) {
        notes_.push_back(line_of(*described) +
                         ": nothing that its sentences can mean is right, \"" +
                         meanings.some.front().said +
                         "\" neither; look at the words that `right` compares, and whether it has "
                         "a return.");
    } else if (*n_right < meanings.some.size()) {
        if (auto tried = try_help(*described, *open); !tried) {
            failed_ = tried.error();
        }
    }
}

void QuestionTrials::try_others() {
    const auto questions = compile_questions(run_.description());
    if (!questions) {
        return;  // the run would not have begun
    }
    for (const QuestionDescription& described : run_.description().questions) {
        if (failed_ || tried_.contains(described.id)) {
            continue;
        }
        const dialogue::Question& question = questions->at(described.id);
        const auto meanings = dialogue::meanings_of(question, kMostMeanings);
        if (note_unanswerable(described, meanings)) {
            continue;
        }
        const auto n_right = count_right(described, meanings.some);
        Expected<void> tried;
        if (!n_right) {
            tried = tl::unexpected(n_right.error());
        } else if (*n_right < meanings.some.size()) {
            tried = try_help(described, question);
        }
        if (!tried) {
            Error error = tried.error();
            error.what_to_do += (error.what_to_do.empty() ? "" : ", ");
            error.what_to_do +=
                "unless what is missing is there by the time the question is asked: the play did "
                "not come to it";
            notes_.push_back(to_sentence(error));
            return;
        }
    }
}

Expected<void> try_events(LessonRun& run) {
    constexpr std::array kKeys = {"space", "return", "left", "right", "up", "down", "a", "1"};
    // While a question is open, keys are letters of the answer.
    for (std::size_t i = 0; i < kKeys.size() && !run.session().hud().question_open; ++i) {
        if (auto happened = run.aside().happen(KeyEvent{kKeys[i]}); !happened) {
            return when("when the key \"" + std::string(kKeys[i]) + "\" is pressed",
                        happened.error());
        }
    }
    const auto& bodies = run.description().bodies;
    const LessonFrame& frame = run.session().newest_frame();
    for (std::size_t i = 0; i < bodies.size() && i < frame.bodies.size(); ++i) {
        if (!bodies[i].solid || frame.bodies[i].where == BodyWhere::hidden) {
            continue;
        }
        const BodyEvent touch{BodyEvent::Kind::touched, static_cast<std::int32_t>(i), 0.1};
        if (auto happened = run.aside().happen(touch); !happened) {
            return when("when \"" + bodies[i].name + "\" is touched", happened.error());
        }
    }
    return {};
}

}  // namespace fulcrum::runtime
