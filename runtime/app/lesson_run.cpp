#include "runtime/app/lesson_run.h"

#include "runtime/lesson/compose_view.h"

#include <algorithm>

namespace fulcrum::runtime {
namespace {

constexpr std::size_t kMostPrints = 8;  // lines a frame: a terminal must not hold the lesson up

}  // namespace

LessonRun::~LessonRun() = default;

// ---- a frame

Expected<SessionInput> LessonRun::gather(const FrameInput& input) {
    SessionInput gathered;
    gathered.clock_s = input.time_s;
    gathered.time_s = input.time_s - input.paused_s;
    gathered.dt_s = std::max(0.0, gathered.time_s - last_frame_s_);
    last_frame_s_ = gathered.time_s;
    last_clock_s_ = gathered.clock_s;
    look(hands_, gathered);
    effects_.gather(description(), gathered);
    gathered.wheel = input.wheel;
    gathered.keys = input.keys;
    gathered.heard = input.typed;
    std::optional<HandWish>& wish = hands_.front()->wish;
    if (wish && !at_desk_ && !wish->key.empty()) {
        gathered.keys.push_back(std::exchange(wish->key, {}));
    }
    if (pupil_.replayed() != nullptr) {
        pupil_.replayed()->add_to(gathered);
    } else if (!gathered.heard && !at_desk_) {
        auto said = hear_pupil(input.time_s);
        if (!said) {
            return tl::unexpected(said.error());
        }
        gathered.heard = std::move(*said);
    }
    if (recorder_) {
        recorder_->keep_frame(gathered);
    }
    why_.look(gathered);
    return gathered;
}

Expected<FrameReport> LessonRun::exchange_frame(const FrameInput& input) {
    const auto gathered = gather(input);
    if (!gathered) {
        return tl::unexpected(gathered.error());
    }
    const auto reply = process_->exchange(session_->begin_frame(*gathered));
    if (!reply) {
        return tl::unexpected(reply.error());
    }
    return conclude(*reply);
}

Expected<void> LessonRun::begin_frame(const FrameInput& input) {
    return gather(input).and_then([&](const SessionInput& gathered) {
        return process_->send(session_->begin_frame(gathered));
    });
}

std::optional<Expected<FrameReport>> LessonRun::poll_frame() {
    auto reply = process_->poll();
    if (!reply) {
        return std::nullopt;
    }
    if (!*reply) {
        return Expected<FrameReport>(tl::unexpected(reply->error()));
    }
    return conclude(**reply);
}

Expected<FrameReport> LessonRun::conclude(const LessonReply& reply) {
    auto output = session_->finish_frame(reply);
    if (!output) {
        return tl::unexpected(output.error());
    }
    if (recorder_) {
        recorder_->keep_output(last_clock_s_, *output, session_->result());
    }
    if (heard_) {
        heard_(*output);
    }
    for (const auto& hand : hands_) {
        hand->channels.command.publish(output->force);
    }
    if (auto ordered = effects_.order(*output); !ordered) {
        return tl::unexpected(ordered.error());
    }
    still_hand_.look(session_->hud().shown_hand_W, last_frame_s_);
    const bool looks = output->has_hand_target && hand().spoiled_counts() != nullptr;
    lead(hands_, *output,
         looks ? nearest_.look(description(), effects_.frames().world,
                               hands_.front()->state().tool_pose_W.position)
               : std::nullopt);
    if (output->printed.size() > kMostPrints) {
        output->printed.resize(kMostPrints);
        output->printed.emplace_back("(this frame printed more)");
    }
    return FrameReport{std::move(output->sounds), std::move(output->printed),
                       std::move(output->said), std::move(output->spoken)};
}

Expected<std::optional<std::string>> LessonRun::hear_pupil(double time_s) {
    return pupil_.hear(time_s, *session_,
                       [this](const JudgeEvent& judge) { return aside().ask_verdict(judge); });
}

// ---- the end, and the picture

double LessonRun::fade_shown_s() const {
    constexpr double kMargin_s = 0.05;  // some rounds beyond the gate's own fade
    return plan().haptic.safety.fade_s + kMargin_s;
}

void LessonRun::fail_softly(const std::string& sentence) {
    channels().lesson_failed.store(true, std::memory_order_release);
    session_->end(EndReason::failed);
    if (recorder_) {
        recorder_->keep_failure(last_clock_s_, sentence);
    }
}

Expected<void> LessonRun::finish_record() {
    return recorder_ ? recorder_->finish() : Expected<void>{};
}

View LessonRun::view(const dialogue::Catalogue& catalogue, bool calm) const {
    Scenery scenery;
    scenery.calm = calm;
    if (calm) {
        scenery.still_hand_W = still_hand_.seen_W();
    }
    scenery.time_s = last_frame_s_;
    static_cast<EffectFrames&>(scenery) = effects_.frames();
    show(hands_, scenery);
    scenery.ghost |= plan().haptic.tool != nullptr;
    return compose_view(session_->description(), plan(), session_->hud(), scenery, catalogue);
}

}  // namespace fulcrum::runtime
