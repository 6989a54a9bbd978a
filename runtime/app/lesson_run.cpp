#include "runtime/app/lesson_run.h"

#include "runtime/lesson/compose_view.h"

#include <algorithm>

namespace fulcrum::runtime {
namespace {

constexpr std::size_t kMostPrints = 8;  // lines a frame: a terminal must not hold the lesson up

}  // namespace

LessonRun::~LessonRun() = default;

std::optional<std::size_t> LessonRun::find_hand(HandKind kind) const {
    const auto find = [this](auto&& is_it) -> std::optional<std::size_t> {
        const auto found =
            std::ranges::find_if(hands_, [&](const auto& hand) { return is_it(*hand->device); });
        return found == hands_.end()
                   ? std::nullopt
                   : std::optional(static_cast<std::size_t>(found - hands_.begin()));
    };
    const auto of_kind = find([&](const HandDevice& device) { return device.kind() == kind; });
    // What was unplugged is moved by the mouse.
    return of_kind || kind != HandKind::mouse
               ? of_kind
               : find([](const HandDevice& device) { return device.stands_in(); });
}

bool LessonRun::renders_force() const {
    return std::ranges::any_of(hands_,
                               [](const auto& hand) { return hand->device->renders_force(); });
}

bool LessonRun::device_is_lost() const {
    return std::ranges::any_of(hands_, [](const auto& hand) { return hand->is_lost(); });
}

bool LessonRun::holds_back() const {
    for (std::size_t hand = 0; hand < hands_.size(); ++hand) {
        if (hands_[hand]->holds_back(limits_of(hand))) {
            return true;
        }
    }
    return false;
}

std::string LessonRun::take_device_notice() {
    std::string notice;
    for (const auto& hand : hands_) {
        if (const std::string more = hand->device->take_notice(); !more.empty()) {
            notice += (notice.empty() ? "" : " ");
            notice += (hand == hands_.front() ? "" : "The second hand: ") + more;
        }
    }
    return notice;
}

// ---- a frame

Expected<SessionInput> LessonRun::gather(const FrameInput& input) {
    SessionInput gathered;
    gathered.time_s = input.time_s;
    gathered.dt_s = std::max(0.0, input.time_s - last_frame_s_);
    last_frame_s_ = input.time_s;
    for (const auto& hand : hands_) {
        hand->channels.state_for_lesson.take();
        if (hand == hands_.front()) {
            gathered.hand = hand->seen();
        } else {
            gathered.more_hands.push_back(hand->seen());
        }
    }
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
        recorder_->keep_output(last_frame_s_, *output, session_->result());
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
    lead_hands(*output);
    if (output->printed.size() > kMostPrints) {
        output->printed.resize(kMostPrints);
        output->printed.emplace_back("(this frame printed more)");
    }
    return FrameReport{std::move(output->sounds), std::move(output->printed),
                       std::move(output->said), std::move(output->spoken)};
}

// The lesson speaks to all alike; a simulated one goes where its own script wants, and on an arm on which things break to what it sees.
void LessonRun::lead_hands(const SessionOutput& output) {
    if (output.has_hand_target) {
        if (hand().spoiled_counts() != nullptr) {
            hand().see(nearest_.look(description(), effects_.frames().world,
                                     hands_.front()->state().tool_pose_W.position));
        }
        hands_.front()->aim({output.hand_target_W, output.hand_buttons, output.hand_key});
    }
    const std::size_t n = std::min(output.more_aims.size(), hands_.size() - 1);
    for (std::size_t i = 0; i < n; ++i) {
        if (const HandAim& aim = output.more_aims[i]; aim.is_given) {
            hands_[i + 1]->aim({aim.target_W, aim.buttons, {}});
        }
    }
}

// ---- what the lesson's own functions say aside, while nothing else happens

Expected<LessonReply> LessonRun::ask_aside(const LessonEvent& event) {
    LessonFrame frame = session_->newest_frame();
    frame.dt_s = 0.0;
    frame.events = {event};
    frame.only_asks = true;
    return process_->exchange(frame);
}

Expected<bool> LessonRun::ask_verdict(const JudgeEvent& judge) {
    return ask_aside(judge).map([](const LessonReply& reply) {
        return std::ranges::any_of(reply.commands, [](const LessonCommand& command) {
            const auto* verdict = std::get_if<VerdictCommand>(&command);
            return verdict != nullptr && verdict->right;
        });
    });
}

Expected<std::string> LessonRun::ask_knowledge(const AskedEvent& asked) {
    return ask_aside(asked).map([](const LessonReply& reply) {
        for (const LessonCommand& command : reply.commands) {
            if (const auto* told = std::get_if<TellCommand>(&command)) {
                return told->text;
            }
        }
        return std::string();
    });
}

Expected<void> LessonRun::happen_aside(const LessonEvent& event) {
    return ask_aside(event).map([](const LessonReply& /*reply*/) {});
}

Expected<std::vector<AnswerChoice>> LessonRun::make_choices() {
    const dialogue::Question* const question = session_->question();
    if (question == nullptr) {
        return std::vector<AnswerChoice>();
    }
    return fulcrum::runtime::make_choices(*question, [&](const AnswerSlots& slots) {
        return ask_verdict({question->id, slots});
    });
}

Expected<std::optional<std::string>> LessonRun::hear_pupil(double time_s) {
    return pupil_.hear(time_s, *session_,
                       [this](const JudgeEvent& judge) { return ask_verdict(judge); });
}

std::optional<HandWish> LessonRun::take_wish() {
    std::optional<HandWish>& kept = hands_.front()->wish;
    std::optional<HandWish> wish = kept;
    if (kept) {
        kept->key.clear();
    }
    return wish;
}

// ---- the end, and the picture

double LessonRun::fade_shown_s() const {
    constexpr double kMargin_s = 0.05;  // some rounds beyond the gate's own fade
    return plan().haptic.safety.fade_s + kMargin_s;
}

std::optional<double> LessonRun::replay_end_s() const {
    const ReplayedInput* const replayed = pupil_.replayed();
    if (replayed == nullptr || replayed->record().samples.empty()) {
        return std::nullopt;
    }
    // Half a round behind the last one, so that it is the last here too.
    constexpr double kHalf = 0.5;
    const double rate_hz = plan().haptic.rate_hz;
    if (const ToldReplay* const told = rounds_.told()) {
        return (static_cast<double>(told->n_rounds()) - kHalf) / rate_hz;
    }
    return replayed->record().samples.back().time_s + kHalf / rate_hz;
}

void LessonRun::fail_softly(const std::string& sentence) {
    channels().lesson_failed.store(true, std::memory_order_release);
    session_->end(EndReason::failed);
    if (recorder_) {
        recorder_->keep_failure(last_frame_s_, sentence);
    }
}

Expected<void> LessonRun::finish_record() {
    return recorder_ ? recorder_->finish() : Expected<void>{};
}

View LessonRun::view(const dialogue::Catalogue& catalogue) const {
    Scenery scenery;
    scenery.time_s = last_frame_s_;
    static_cast<EffectFrames&>(scenery) = effects_.frames();
    const HandScenery first = hands_.front()->scenery();
    scenery.hand = first.hand;
    scenery.renders_force = hand().renders_force();
    scenery.ghost = first.ghost || plan().haptic.tool != nullptr;
    scenery.ghost_pose_W = first.ghost_pose_W;
    for (std::size_t i = 1; i < hands_.size(); ++i) {
        scenery.more_hands.push_back(hands_[i]->scenery());
    }
    return compose_view(session_->description(), plan(), session_->hud(), scenery, catalogue);
}

}  // namespace fulcrum::runtime
