#include "runtime/lesson/learner_feedback.h"

namespace fulcrum::runtime {

std::string feedback_text(const dialogue::FeedbackLadder& ladder) {
    return ladder.empty() ? kAsLessonSays : dialogue::ladder_text(ladder);
}

dialogue::FeedbackLadder find_feedback(const ProgressData& data, const LearnerId& learner) {
    dialogue::FeedbackLadder newest;
    for (const SessionRecord& session : data.sessions) {
        for (const auto& [name, value] : session.settings) {
            if (session.learner != learner || name != kFeedback) {
                continue;
            }
            const auto ladder = dialogue::read_ladder_text(value);
            if (ladder || value == kAsLessonSays) {
                newest = ladder ? *ladder : dialogue::FeedbackLadder{};
            }
        }
    }
    return newest;
}

dialogue::FeedbackLadder read_feedback(ProgressStore& store, const Learner& learner) {
    const auto data = store.read({learner.nickname, {}});
    return data ? find_feedback(*data, learner.id) : dialogue::FeedbackLadder{};
}

}  // namespace fulcrum::runtime
