#include "runtime/app/run_learner.h"

#include "runtime/app/installation.h"
#include "runtime/app/lesson_cards.h"
#include "runtime/lesson/learner_throat.h"
#include "runtime/lesson/past_answers.h"
#include "runtime/lesson/simulated_pupil.h"

namespace fulcrum::runtime {
namespace {

// What the learner answered before, where the lesson asks for it; none, said aloud, where it cannot be read. A simulated pupil begins anew
// each time, so that the same run gives the same bytes.
std::vector<PastAnswers> recall(ProgressStore& store, const Learner& learner, bool is_wanted) {
    if (!is_wanted || learner.nickname == kSimulatedPupil) {
        return {};
    }
    auto past = read_past_answers(store, learner, utc_now_ms());
    if (!past) {
        say(to_sentence(past.error()));
        return {};
    }
    return std::move(*past);
}

}  // namespace

Expected<RunLearner> find_learner(const RunOrder& order, const LessonDescription& lesson,
                                  ProgressStore& store, Plan& plan) {
    const RunRequest& request = order.request;
    if (lesson.is_room) {
        // As above: a simulated pupil has done nothing before.
        const std::string name = request.learner == kSimulatedPupil ? "" : request.learner;
        RunLearner visitor;
        visitor.known.lessons =
            !request.lessons.empty()
                ? request.lessons
                : list_known_lessons(read_lesson_cards(order.places), read_best_stars(store, name));
        return visitor;
    }
    const auto learner = store.enrol(request.player());
    if (!learner) {
        return tl::unexpected(learner.error());
    }
    const bool is_known = !request.learner.empty() && learner->nickname != kSimulatedPupil;
    if (plan.recogniser && plan.hearing.takes_throat && plan.hearing.throat == 0.0 && is_known) {
        plan.hearing.throat = read_throat(store, *learner).value_or(0.0);
    }
    return RunLearner{learner->id, is_known, {recall(store, *learner, lesson.wants_past), {}}};
}

}  // namespace fulcrum::runtime
