#include "runtime/app/kept_feedback.h"

#include "runtime/lesson/learner_feedback.h"

namespace fulcrum::runtime {

RunRequest with_kept_feedback(RunRequest request, ProgressStore& store) {
    const bool has_own = !request.learner.empty() && request.learner != kSimulatedPupil;
    if (has_own && !request.replayed) {
        // A name that cannot be one is refused where it is enrolled.
        if (const auto learner = store.enrol(request.learner)) {
            request.kept_feedback = read_feedback(store, *learner);
        }
    }
    return request;
}

}  // namespace fulcrum::runtime
