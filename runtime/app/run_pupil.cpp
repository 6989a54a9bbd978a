#include "runtime/app/run_pupil.h"

namespace fulcrum::runtime {
namespace {

// How often a simulated learner errs, where one was asked for or the lesson's own test, null where it is not played, has one.
std::optional<LearnerRates> find_pupil_rates(const RunRequest& request,
                                             const LessonTestDescription* own_test) {
    if (request.learner_rates || own_test == nullptr) {
        return request.learner_rates;
    }
    return own_test->learner;
}

}  // namespace

RunPupil::RunPupil(const LessonDescription& description, const RunRequest& request) {
    if (repeats_input(request)) {
        replayed_.emplace(request.replayed);
        return;
    }
    const bool plays_own_test =
        request.own_test && !description.tests.empty() && request.plan.hearing.recordings.empty();
    const std::optional<LearnerRates> rates =
        find_pupil_rates(request, plays_own_test ? &description.tests.front() : nullptr);
    if (rates && request.say.empty()) {
        pupil_.emplace(LearnerModel(*rates, request.seed), request.thinking_s);
        say_line_ = plays_own_test ? description.tests.front().line : 0;
    } else if (request.learner_without_test && request.say.empty() &&
               (!plays_own_test || description.tests.front().say.empty())) {
        pupil_.emplace(LearnerModel(*request.learner_without_test, request.seed));
    } else if (plays_own_test || !request.say.empty()) {
        const bool says_own = plays_own_test && request.say.empty();
        pupil_.emplace(says_own ? description.tests.front().say : request.say);
        say_line_ = says_own ? description.tests.front().line : 0;
        n_given_lines_ = says_own ? 0 : request.say.size();
    }
}

Expected<std::optional<std::string>> RunPupil::hear(
    double time_s, const LessonSession& session,
    const std::function<Expected<bool>(const JudgeEvent&)>& ask_verdict) {
    const SessionHud& hud = session.hud();
    const dialogue::Question* const question = session.question();
    if (!pupil_) {
        return std::optional<std::string>();
    }
    if (hud.may_ask) {
        return pupil_->ask(time_s);
    }
    if (question == nullptr || !hud.question_open || hud.invited) {
        return std::optional<std::string>();
    }
    return pupil_->answer(hud.question_asked_at_s, time_s, *question,
                          [&](const AnswerSlots& slots) {
                              return ask_verdict({question->id, slots});
                          });
}

}  // namespace fulcrum::runtime
