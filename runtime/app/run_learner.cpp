#include "runtime/app/run_learner.h"

#include "runtime/lesson/learner_throat.h"
#include "runtime/lesson/simulated_pupil.h"

#include <cstdio>

namespace fulcrum::runtime {
namespace {

constexpr const char* kGuest = "guest";

// What the learner answered before, where the lesson asks for it; none, said aloud, where it cannot be read. A simulated pupil begins anew
// each time, so that the same run gives the same bytes.
std::vector<PastAnswers> recall(ProgressStore& store, const Learner& learner, bool is_wanted) {
    if (!is_wanted || learner.nickname == kSimulatedPupil) {
        return {};
    }
    auto past = read_past_answers(store, learner, utc_now_ms());
    if (!past) {
        std::fprintf(stderr, "%s\n", to_sentence(past.error()).c_str());
        return {};
    }
    return std::move(*past);
}

}  // namespace

Expected<RunLearner> find_learner(const RunRequest& request, bool wants_past, ProgressStore& store,
                                  Plan& plan) {
    const auto learner = store.enrol(request.learner.empty() ? kGuest : request.learner);
    if (!learner) {
        return tl::unexpected(learner.error());
    }
    const bool is_known = !request.learner.empty() && learner->nickname != kSimulatedPupil;
    if (plan.recogniser && plan.hearing.takes_throat && plan.hearing.throat == 0.0 && is_known) {
        plan.hearing.throat = read_throat(store, *learner).value_or(0.0);
    }
    return RunLearner{learner->id, is_known, recall(store, *learner, wants_past)};
}

}  // namespace fulcrum::runtime
