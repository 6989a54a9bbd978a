#include "runtime/app/question_trials.h"

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

}  // namespace

/// Calls `right` with each.
Expected<bool> QuestionTrials::any_is_right(const QuestionDescription& described,
                                            const std::vector<dialogue::Meaning>& meanings) {
    bool any_right = false;
    for (const dialogue::Meaning& meaning : meanings) {
        const auto verdict = run_.ask_verdict({described.id, meaning.slots});
        if (!verdict) {
            return when(head_of(described) + ", tried with \"" + meaning.said + "\"",
                        verdict.error());
        }
        any_right = any_right || *verdict;
    }
    return any_right;
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
    const auto any_right = any_is_right(*described, meanings.some);
    if (!any_right) {
        failed_ = any_right.error();
    } else if (!*any_right && meanings.all) {
        notes_.push_back(
            "lesson.lua:" + std::to_string(described->line) + ": " + head_of(*described) +
            ": nothing that its sentences can mean is right, \"" + meanings.some.front().said +
            "\" neither; look at the words that `right` compares, and whether it has "
            "a return.");
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
        const auto meanings = dialogue::meanings_of(questions->at(described.id), kMostMeanings);
        if (const auto tried = any_is_right(described, meanings.some); !tried) {
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
        if (auto happened = run.happen_aside(KeyEvent{kKeys[i]}); !happened) {
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
        if (auto happened = run.happen_aside(touch); !happened) {
            return when("when \"" + bodies[i].name + "\" is touched", happened.error());
        }
    }
    return {};
}

}  // namespace fulcrum::runtime
