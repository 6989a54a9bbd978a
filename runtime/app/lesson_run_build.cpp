// How a run comes about; for lesson_run.h.
#include "runtime/app/arm_line.h"
#include "runtime/app/hand_fitting.h"
#include "runtime/app/hand_trial.h"
#include "runtime/app/kept_feedback.h"
#include "runtime/app/lesson_parts.h"
#include "runtime/app/lesson_run.h"
#include "runtime/app/open_hands.h"
#include "runtime/app/run_learner.h"
#include "runtime/app/run_recording.h"
#include "runtime/lesson/learner_feedback.h"
#include "runtime/lesson/questions.h"
#include "runtime/scene/plan_hands.h"

#include <algorithm>
#include <iterator>

namespace fulcrum::runtime {
Expected<std::unique_ptr<LessonRun>> LessonRun::create(const Places& places,
                                                       const RunRequest& request,
                                                       ProgressStore& store,
                                                       const dialogue::Catalogue& catalogue) {
    std::unique_ptr<LessonRun> run(new LessonRun);
    const auto whole = with_record(request);
    if (!whole) {
        return tl::unexpected(whole.error());
    }
    RunRequest settled = with_kept_feedback(*whole, store);
    const RunOrder order{places, settled};
    const auto built =
        run->load(places, store, settled)
            .and_then([&] { return open_hands(order, store, run->plan_, run->hands_); })
            .and_then([&] { return run->build_loops(order); })
            .and_then([&] { return run->build_session(order, store, catalogue); });
    if (!built) {
        return tl::unexpected(built.error());
    }
    RunRequest said = request;
    static_cast<HandChoice&>(said) = static_cast<const HandChoice&>(settled);
    keep_fit_of(said, store);
    for (std::size_t hand = 1; hand < run->hands_.size(); ++hand) {
        keep_fit_of(of_hand(settled, hand), store);
    }
    return run;
}

// The lesson says what it needs, and the plan holds exactly that.
Expected<void> LessonRun::load(const Places& places, ProgressStore& store, RunRequest& request) {
    auto started = start_lesson(places, request);
    if (!started) {
        return tl::unexpected(started.error());
    }
    process_ = std::move(started->process);
    started_notices_ = std::move(started->notices);
    if (auto met = meet_arms(request); !met) {
        return met;
    }
    request = with_kept_fit(request, store);
    return check_models(places, request.folder, process_->description()).and_then([&] {
        return plan_.compile({places, request}, process_->description());
    });
}

// Only what is in the plan is built.
Expected<void> LessonRun::build_loops(const RunOrder& order) {
    const LessonDescription& lesson = process_->description();
    Plan& plan = plan_.plan();
    // Who moves which hand, how the scene was fitted to them, and which of them gives no force.
    plan.notices.insert(plan.notices.end(), started_notices_.begin(), started_notices_.end());
    std::ranges::move(plan_.take_notices(), std::back_inserter(plan.notices));
    std::ranges::move(withhold_refused(hands_, order.request), std::back_inserter(plan.notices));
    for (std::size_t hand = 0; hand < hands_.size(); ++hand) {
        hands_[hand]->channels.add(plan.of_hand(hand), plan.rigid.has_value());
    }
    const auto channels = channels_of(hands_);
    if (auto built = effects_.build({plan, channels, place_at_first(plan_.scene())}); !built) {
        return built;
    }
    effects_.measure(plan.stages);
    const bool is_told = tells_loops(order.request, lesson, hands_);
    for (std::size_t hand = 0; hand < hands_.size(); ++hand) {
        hands_[hand]->build_loop(plan, plan.of_hand(hand), is_told);
    }
    rounds_.build(hands_);
    if (plan.picture && order.request.plan.live) {
        why_.build(lesson, hands_);
    }
    auto recorder = make_recorder(order, lesson, plan, process_->files_read(), hands_);
    if (!recorder) {
        return tl::unexpected(recorder.error());
    }
    recorder_ = std::move(*recorder);
    for (std::size_t hand = 0; hand < hands_.size(); ++hand) {
        hands_[hand]->measure(name_of_loop(hand), plan.stages);
    }
    return {};
}

// Who plays, and who answers.
Expected<void> LessonRun::build_session(const RunOrder& order, ProgressStore& store,
                                        const dialogue::Catalogue& catalogue) {
    const RunRequest& request = order.request;
    LessonDescription description = plan_.scene();
    Plan& plan = plan_.plan();
    at_desk_ = request.by != PlayedBy::arm;
    choose_feedback(description, request.feedback.value_or(request.kept_feedback));
    pupil_ = RunPupil(description, request);
    auto learner = find_learner(order, description, store, plan);
    if (!learner) {
        return tl::unexpected(learner.error());
    }
    auto session =
        LessonSession::create(std::move(description), plan, catalogue, store, learner->id,
                              version_of(process_->files_read()), std::move(learner->known));
    if (!session) {
        return tl::unexpected(session.error());
    }
    session_ = std::move(*session);
    if (request.feedback && learner->is_known) {
        session_->keep_setting(kFeedback, feedback_text(*request.feedback));
    }
    return {};
}

}  // namespace fulcrum::runtime
