#include "runtime/app/run_recording.h"

#include "runtime/app/run_facts.h"
#include "runtime/evidence/replay_check.h"

#include <algorithm>
#include <cstdio>

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

bool tells_loops(const RunRequest& request, const LessonDescription& lesson,
                 const RunHands& hands) {
    return request.replayed && !request.plan.live && tells_all(*request.replayed) &&
           request.replayed->header.lesson == lesson.id &&
           std::ranges::all_of(hands, [](const auto& hand) { return hand->replayed != nullptr; });
}

// The header tells what the run is made with, so everything else is built before.
Expected<std::unique_ptr<RunRecorder>> make_recorder(
    const RunOrder& order, const LessonDescription& lesson, const Plan& plan,
    const std::vector<std::filesystem::path>& files, const RunHands& hands) {
    const RunRequest& request = order.request;
    const bool compares = can_compare(request, lesson);
    if (!plan.record && !compares) {
        return nullptr;
    }
    const RunHand& first = *hands.front();
    FactSources sources{lesson,
                        plan,
                        request,
                        order.places,
                        files,
                        *first.loop,
                        first.device->device().traits(),
                        find_force_limit_N(request, hands)};
    std::vector<HapticChannels*> channels;
    for (const auto& hand : hands) {
        if (!channels.empty()) {
            sources.more_hands.push_back({*hand->loop, hand->device->device().traits()});
        }
        channels.push_back(&hand->loop_channels());
    }
    const RecordHeader header = describe_run(sources);
    std::vector<std::string> forces;
    for (const ForceDescription& force : lesson.forces) {
        forces.push_back(force.name);
    }
    auto made = RunRecorder::create(plan.record ? request.record_file : std::string(), header,
                                    channels, std::move(forces));
    if (!made) {
        return tl::unexpected(made.error());
    }
    RunRecorder& recorder = **made;
    if (plan.record && request.plan.live) {
        recorder.keep_told(channels);
    }
    recorder.watch(first.loop->contact_lateness());
    if (compares) {
        recorder.compare_with(request.replayed, header);
        for (std::size_t hand = 1; hand < hands.size(); ++hand) {
            if (hands[hand]->replayed) {
                recorder.compare_with(hands[hand]->replayed, header_of_hand(header, hand), hand);
            }
        }
    }
    return made;
}

}  // namespace fulcrum::runtime
