// What a lesson's run has to do with records: its own, and the one that it repeats; for lesson_run.cpp.
#include "runtime/app/lesson_run.h"
#include "runtime/app/run_facts.h"
#include "runtime/evidence/replay_check.h"

#include <algorithm>
#include <cstdio>
#include <string>

namespace fulcrum::runtime {
namespace {

// Threads that keep their own time meet at other moments each time: only where the run that repeats does not can forces be the same to the
// bit.
bool can_compare(const RunRequest& request, const LessonDescription& lesson) {
    if (!request.replayed || request.plan.live) {
        return false;
    }
    if (request.replayed->header.lesson != lesson.id) {
        std::fprintf(stderr,
                     "The record is of the lesson \"%s\", so its forces are not compared.\n",
                     request.replayed->header.lesson.c_str());
        return false;
    }
    return true;
}

}  // namespace

// A record of a run in real time tells each hand's loop all that it was told; of one whose every hand is repeated, in its lesson. In a
// window it is a hand alone: there the loops keep their own time.
void LessonRun::build_told(const RunRequest& request) {
    const auto is_told = [](const std::unique_ptr<MoreHand>& hand) {
        return hand->replayed != nullptr;
    };
    if (!request.replayed || request.plan.live || !tells_all(*request.replayed) ||
        request.replayed->header.lesson != process_->description().id ||
        !std::ranges::all_of(more_hands_, is_told)) {
        return;
    }
    for (std::size_t hand = 0; hand < n_hands(); ++hand) {
        const HapticChannels& others = channels_at(hand);
        auto told = std::make_unique<ToldChannels>();
        told->haptics.axles = others.axles != nullptr ? &told->axles : nullptr;
        told->haptics.rigid = others.rigid != nullptr ? &told->rigid : nullptr;
        told->haptics.kite = others.kite != nullptr ? &told->kite : nullptr;
        told->haptics.touches = others.touches;
        told_.push_back(std::move(told));
    }
}

void LessonRun::build_told_replay(const RunRequest& request) {
    std::vector<ToldReplay::Hand> hands;
    for (std::size_t i = 0; i < told_.size(); ++i) {
        hands.push_back({i == 0 ? request.replayed : more_hands_[i - 1]->replayed,
                         i == 0 ? haptic_loop_.get() : more_hands_[i - 1]->loop.get(),
                         &loop_channels(i), &channels_at(i)});
    }
    if (!hands.empty()) {
        told_replay_ = std::make_unique<ToldReplay>(std::move(hands));
    }
}

// Somebody at a window may ask; before the loops begin, for the haptic thread looks at the channel in each round.
void LessonRun::build_why(const RunRequest& request) {
    if (!plan_.picture || !request.plan.live || haptic_loop_->effects().empty()) {
        return;
    }
    const auto build = [&](const HapticLoop& loop, HapticChannels& channels) {
        why_.push_back(
            std::make_unique<AskedWhy>(WhyShown(loop.effects(), process_->description().forces,
                                                {loop.max_force_N(), loop.max_torque_Nm()})));
        channels.shares = &why_.back()->shares;
    };
    build(*haptic_loop_, channels_);
    for (const auto& hand : more_hands_) {
        build(*hand->loop, hand->channels);
    }
}

void LessonRun::look_why(const SessionInput& gathered) {
    for (std::size_t hand = 0; hand < why_.size(); ++hand) {
        AskedWhy& why = *why_[hand];
        if (why.shares.take()) {
            why.shown.look(why.shares.value(),
                           hand == 0 ? gathered.hand : gathered.more_hands[hand - 1],
                           gathered.time_s);
        }
    }
}

ViewWhy LessonRun::why(std::size_t hand, const dialogue::Catalogue& catalogue) const {
    if (hand >= why_.size()) {
        return {};
    }
    ViewWhy why = why_[hand]->shown.show(catalogue);
    if (why_.size() > 1) {
        why.title = catalogue.say("hud.why_of", {{"number", std::to_string(hand + 1)}});
    }
    return why;
}

// The header tells what the run is made with, so everything else is built before.
Expected<void> LessonRun::build_recorder(const Places& places, const RunRequest& request) {
    const LessonDescription& lesson = process_->description();
    const bool compares = can_compare(request, lesson);
    if (!plan_.record && !compares) {
        return {};
    }
    FactSources sources{lesson,
                        plan_,
                        request,
                        places,
                        process_->files_read(),
                        *haptic_loop_,
                        device().traits(),
                        force_limit_N(request)};
    std::vector<HapticChannels*> channels{&loop_channels(0)};
    for (const auto& hand : more_hands_) {
        sources.more_hands.push_back({*hand->loop, hand->device->device().traits()});
        channels.push_back(&loop_channels(channels.size()));
    }
    const RecordHeader header = describe_run(sources);
    std::vector<std::string> forces;
    for (const ForceDescription& force : lesson.forces) {
        forces.push_back(force.name);
    }
    auto recorder = RunRecorder::create(plan_.record ? request.record_file : std::string(), header,
                                        channels, std::move(forces));
    if (!recorder) {
        return tl::unexpected(recorder.error());
    }
    recorder_ = std::move(*recorder);
    if (plan_.record && request.plan.live) {
        recorder_->keep_told(channels);
    }
    recorder_->watch(haptic_loop_->contact_lateness());
    if (compares) {
        recorder_->compare_with(request.replayed, header);
        for (std::size_t i = 0; i < more_hands_.size(); ++i) {
            if (more_hands_[i]->replayed) {
                recorder_->compare_with(more_hands_[i]->replayed, header_of_hand(header, i + 1),
                                        i + 1);
            }
        }
    }
    return {};
}

std::optional<double> LessonRun::replay_end_s() const {
    if (!replayed_ || replayed_->record().samples.empty()) {
        return std::nullopt;
    }
    // Half a round behind the last one, so that it is the last here too.
    constexpr double kHalf = 0.5;
    if (told_replay_) {
        return (static_cast<double>(told_replay_->n_rounds()) - kHalf) / plan_.haptic.rate_hz;
    }
    return replayed_->record().samples.back().time_s + kHalf / plan_.haptic.rate_hz;
}

void LessonRun::fail_softly(const std::string& sentence) {
    channels_.lesson_failed.store(true, std::memory_order_release);
    session_->end(EndReason::failed);
    if (recorder_) {
        recorder_->keep_failure(last_frame_s_, sentence);
    }
}

Expected<void> LessonRun::finish_record() {
    return recorder_ ? recorder_->finish() : Expected<void>{};
}

}  // namespace fulcrum::runtime
