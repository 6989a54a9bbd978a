// How a run comes about; for lesson_run.h.
#include "haptics/device/replay/recorded_traits.h"
#include "runtime/app/hand_fitting.h"
#include "runtime/app/hand_trial.h"
#include "runtime/app/kept_feedback.h"
#include "runtime/app/lesson_parts.h"
#include "runtime/app/lesson_run.h"
#include "runtime/app/run_recording.h"
#include "runtime/lesson/learner_feedback.h"
#include "runtime/lesson/learner_throat.h"
#include "runtime/lesson/past_answers.h"
#include "runtime/lesson/questions.h"
#include "runtime/scene/plan_hands.h"

#include <charconv>
#include <cstdio>
#include <system_error>

namespace fulcrum::runtime {
namespace {

constexpr const char* kGuest = "guest";

// What the record that the first hand repeats has of this one; null where it has nothing, or another file is repeated.
std::shared_ptr<const Record> find_replayed(const RunRequest& request, std::size_t hand) {
    if (hand == 0) {
        return request.replayed;
    }
    const HandChoice& choice = request.more_hands[hand - 1];
    const bool is_of_it = request.replayed && choice.hand == HandKind::replay &&
                          choice.hand_file == request.hand_file;
    auto alone = is_of_it ? find_hand(*request.replayed, hand) : std::nullopt;
    return alone ? std::make_shared<const Record>(std::move(*alone)) : nullptr;
}

// How far it went in the scene then, times the lesson's own scale.
std::optional<double> find_replayed_scale(const RunRequest& request, std::size_t hand) {
    const auto told = find_fact(request.replayed->header, fact_prefix(hand) + kScaleFact);
    double scale = 1.0;
    const bool is_number =
        told && std::from_chars(told->data(), told->data() + told->size(), scale).ec == std::errc{};
    return is_number ? std::optional(scale) : std::nullopt;
}

// What is asked of that hand beside the first; of one that the record is `alone` for, with what that has of it.
Expected<RunRequest> whole_request(const RunRequest& request, std::size_t hand,
                                   const std::shared_ptr<const Record>& alone) {
    RunRequest own = of_hand(request, hand);
    if (!alone) {
        return with_record(std::move(own));
    }
    own.replayed = alone;
    own.fit.scale = own.fit.scale ? own.fit.scale : find_replayed_scale(request, hand);
    return own;
}

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

// How much memory the loop of that hand uses for each of its stages.
void fill_in_memory(Plan& plan, std::size_t hand, const HapticLoop& loop) {
    for (const StageInfo& built : loop.stages()) {
        for (PlanStage& planned : plan.stages) {
            if (planned.loop == name_of_loop(hand) && planned.name == name_of(built.stage)) {
                planned.memory_bytes = built.bytes;
            }
        }
    }
}

}  // namespace

Expected<std::unique_ptr<LessonRun>> LessonRun::create(const Places& places,
                                                       const RunRequest& request,
                                                       ProgressStore& store,
                                                       const dialogue::Catalogue& catalogue) {
    std::unique_ptr<LessonRun> run(new LessonRun);
    const auto whole = with_record(request);
    if (!whole) {
        return tl::unexpected(whole.error());
    }
    RunRequest settled = with_kept_feedback(with_kept_fit(*whole, store), store);
    const RunOrder order{places, settled};
    const auto built = run->load(places, settled)
                           .and_then([&] { return run->open_hands(order, store); })
                           .and_then([&] { return run->build_loops(order); })
                           .and_then([&] { return run->build_session(settled, store, catalogue); });
    if (!built) {
        return tl::unexpected(built.error());
    }
    keep_fit_of(request, store);
    for (std::size_t hand = 1; hand < run->hands_.size(); ++hand) {
        keep_fit_of(of_hand(settled, hand), store);
    }
    return run;
}

// The lesson says what it needs, and the plan holds exactly that.
Expected<void> LessonRun::load(const Places& places, RunRequest& request) {
    auto started = start_lesson(places, request);
    if (!started) {
        return tl::unexpected(started.error());
    }
    process_ = std::move(started->process);
    started_notices_ = std::move(started->notices);
    return check_models(places, request.folder, process_->description()).and_then([&] {
        return plan_.compile({places, request}, process_->description());
    });
}

// As many as are planned; the request has been settled.
Expected<void> LessonRun::open_hands(const RunOrder& order, ProgressStore& store) {
    for (std::size_t hand = 0; hand <= plan().more_hands.size(); ++hand) {
        if (auto opened = open_hand(order, store, hand); !opened) {
            return opened;
        }
    }
    say_what_was_done(order.request);
    return {};
}

// Each device stands before the learner as it is kept for it, and goes as far in the scene as was said or as it reaches. What it can reach
// and hold is known when it is open.
Expected<void> LessonRun::open_hand(const RunOrder& order, ProgressStore& store, std::size_t hand) {
    const RunRequest& request = order.request;
    auto made = std::make_unique<RunHand>();
    made->replayed = find_replayed(request, hand);
    RunRequest own = request;
    if (hand > 0) {
        auto whole = whole_request(request, hand, made->replayed);
        if (!whole) {
            return tl::unexpected(whole.error());
        }
        own = with_kept_fit(*whole, store);
        made->choice = request.more_hands[hand - 1];
        if (auto scaled = plan_.scale_as_said(order, hands_, hand, own.fit); !scaled) {
            return scaled;
        }
    } else {
        made->choice = static_cast<const HandChoice&>(request);
    }
    made->fit = own.fit;
    auto device = HandDevice::open(own, plan().of_hand(hand));
    if (!device) {
        return tl::unexpected(device.error());
    }
    made->device = std::move(*device);
    hands_.push_back(std::move(made));
    const HandDevice& opened = *hands_.back()->device;
    if (hand == 0 || opened.wall_holder()) {
        if (auto fitted = plan_.fit_to_force(order, hands_); !fitted) {
            return fitted;
        }
    }
    const DeviceTraits& traits = opened.device().traits();
    if (const double factor = choose_scale(own.fit, traits); factor != 1.0) {
        plan_.fit_to_reach(order, hands_, hand, factor);
    }
    return validate(plan().of_hand(hand), traits);
}

// Who moves which hand, how the scene was fitted to them, and which of them gives no force.
void LessonRun::say_what_was_done(const RunRequest& request) {
    std::vector<std::string> done = std::move(started_notices_);
    std::ranges::move(plan_.take_notices(), std::back_inserter(done));
    for (std::size_t hand = 0; hand < hands_.size(); ++hand) {
        std::string withheld = withhold_refused(*hands_[hand], hand == 0 ? "" : "second ", request);
        if (!withheld.empty()) {
            done.push_back(std::move(withheld));
        }
    }
    std::ranges::move(done, std::back_inserter(plan_.plan().notices));
}

// Only what is in the plan is built.
Expected<void> LessonRun::build_loops(const RunOrder& order) {
    const LessonDescription& lesson = process_->description();
    Plan& plan = plan_.plan();
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
        fill_in_memory(plan, hand, *hands_[hand]->loop);
    }
    return {};
}

// Who plays, and who answers.
Expected<void> LessonRun::build_session(const RunRequest& request, ProgressStore& store,
                                        const dialogue::Catalogue& catalogue) {
    LessonDescription description = plan_.scene();
    Plan& plan = plan_.plan();
    at_desk_ = request.by != PlayedBy::arm;
    const auto learner = store.enrol(request.learner.empty() ? kGuest : request.learner);
    if (!learner) {
        return tl::unexpected(learner.error());
    }
    const bool is_known = !request.learner.empty() && learner->nickname != kSimulatedPupil;
    choose_feedback(description, request.feedback.value_or(request.kept_feedback));
    pupil_ = RunPupil(description, request);
    auto past = recall(store, *learner, description.wants_past);
    if (plan.recogniser && plan.hearing.takes_throat && plan.hearing.throat == 0.0 && is_known) {
        plan.hearing.throat = read_throat(store, *learner).value_or(0.0);
    }
    auto session =
        LessonSession::create(std::move(description), plan, catalogue, store, learner->id,
                              version_of(process_->files_read()), std::move(past));
    if (!session) {
        return tl::unexpected(session.error());
    }
    session_ = std::move(*session);
    if (request.feedback && is_known) {
        session_->keep_setting(kFeedback, feedback_text(*request.feedback));
    }
    return {};
}

}  // namespace fulcrum::runtime
