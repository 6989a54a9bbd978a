#include "runtime/app/lesson_run.h"

#include "haptics/loop/workspace.h"
#include "haptics/record/record.h"
#include "runtime/app/lesson_parts.h"
#include "runtime/lesson/compose_view.h"

#include <algorithm>

#include <cstdio>
#include <fstream>
#include <sstream>

namespace fulcrum::runtime {
namespace {

constexpr const char* kGuest = "guest";
constexpr std::size_t kMostPrints = 8;  // lines a frame: a terminal must not hold the lesson up
// With a mouse, weight is seen: 5 N hang 2 cm lower in the device's frame and follow half as fast.
constexpr double kMouseSag_m_per_N = 0.004;
constexpr double kMouseSlow_per_N = 0.2;

// Changes when the lesson's files change: FNV-1a, 64 bits (Fowler, Noll, Vo), over their bytes.
std::string version_of(const std::vector<std::filesystem::path>& files) {
    std::uint64_t hash = 0xcbf29ce484222325ULL;
    for (const auto& path : files) {
        std::ifstream file(path, std::ios::binary);
        for (char c = 0; file.get(c);) {
            hash = (hash ^ static_cast<unsigned char>(c)) * 0x100000001b3ULL;
        }
    }
    std::ostringstream text;
    text << std::hex << hash;
    return text.str();
}

RecordEventKind record_kind(WorldEvent::Kind kind) {
    return kind == WorldEvent::Kind::caught ? RecordEventKind::caught : RecordEventKind::landed;
}

}  // namespace

LessonRun::~LessonRun() = default;

Expected<std::unique_ptr<LessonRun>> LessonRun::create(const Places& places,
                                                       const RunRequest& request,
                                                       ProgressStore& store,
                                                       const dialogue::Catalogue& catalogue) {
    std::unique_ptr<LessonRun> run(new LessonRun);
    if (auto built = run->build(places, request, store, catalogue); !built) {
        return tl::unexpected(built.error());
    }
    return run;
}

Expected<void> LessonRun::build(const Places& places, const RunRequest& request,
                                ProgressStore& store, const dialogue::Catalogue& catalogue) {
    // The lesson says what it needs …
    auto process = start_lesson(places, request);
    if (!process) {
        return tl::unexpected(process.error());
    }
    process_ = std::move(*process);
    LessonDescription description = process_->description();

    // … the plan holds exactly that …
    auto plan = compile_plan(description, request.plan, make_solid_loader(places, request.folder));
    if (!plan) {
        return tl::unexpected(plan.error());
    }
    plan_ = std::move(*plan);
    if (auto valid = validate(plan_.haptic); !valid) {
        return valid;
    }
    if (auto device = open_device(request); !device) {
        return device;
    }

    // … and only what is in it is built.
    if (auto recorder = open_record(request.record_file, description.id); !recorder) {
        return recorder;
    }
    haptic_loop_ = std::make_unique<HapticLoop>(plan_.haptic, *device_, channels_);
    if (plan_.world) {
        if (auto valid = validate(*plan_.world); !valid) {
            return valid;
        }
        std::vector<std::int32_t> solid_bodies;
        for (const SolidPlan& solid : plan_.haptic.solids) {
            solid_bodies.push_back(solid.body);
        }
        world_channels_ = std::make_unique<WorldChannels>();
        world_loop_ = std::make_unique<WorldLoop>(*plan_.world, std::move(solid_bodies),
                                                  *world_channels_, channels_);
    }
    fill_in_memory(plan_, *haptic_loop_);

    // Who plays, and who answers.
    const auto learner = store.enrol(request.learner.empty() ? kGuest : request.learner);
    if (!learner) {
        return tl::unexpected(learner.error());
    }
    const bool plays_own_test = request.own_test && !description.tests.empty();
    if (plays_own_test || !request.say.empty()) {
        pupil_.emplace(plays_own_test && request.say.empty() ? description.tests.front().say
                                                             : request.say);
    }
    auto session = LessonSession::create(std::move(description), plan_, catalogue, store,
                                         learner->id, version_of(process_->files_read()));
    if (!session) {
        return tl::unexpected(session.error());
    }
    session_ = std::move(*session);
    place_visible_bodies();
    return {};
}

Expected<void> LessonRun::open_record(const std::string& file, const std::string& lesson) {
    if (!plan_.record) {
        return {};
    }
    record_ring_ = std::make_unique<RecordRing>();
    channels_.record = record_ring_.get();
    auto writer = RecordWriter::create(file, {plan_.haptic.rate_hz, lesson});
    if (!writer) {
        return tl::unexpected(writer.error());
    }
    record_.emplace(std::move(*writer));
    return {};
}

Expected<void> LessonRun::open_device(const RunRequest& request) {
    switch (request.hand) {
        case HandKind::scripted: {
            SimulatedHandSettings settings;
            device_ = std::make_unique<SimulatedHand>(settings, hand_target_);
            hand_target_.publish(last_hand_target_);
            return {};
        }
        case HandKind::mouse: {
            PointerSettings settings;
            settings.sag_m_per_N = kMouseSag_m_per_N;
            settings.slow_per_N = kMouseSlow_per_N;
            settings.half_extent_D =
                Vector3::Constant(1.0 / std::max(plan_.haptic.workspace.scale, 0.1));
            device_ = std::make_unique<PointerDevice>(settings, pointer_target_);
            pointer_W_ = plan_.haptic.workspace.pose_WD;
            pointer_target_.publish({});
            return {};
        }
        case HandKind::replay: {
            const auto record = load_record(request.hand_file.string());
            if (!record) {
                return tl::unexpected(record.error());
            }
            device_ = std::make_unique<ReplayDevice>(*record);
            return {};
        }
    }
    return {};
}

void LessonRun::place_visible_bodies() {
    if (!world_channels_) {
        return;
    }
    const auto& bodies = session_->description().bodies;
    for (std::size_t i = 0; i < bodies.size(); ++i) {
        if (bodies[i].visible || bodies[i].solid) {
            WorldCommand place;
            place.kind = WorldCommand::Kind::place;
            place.body = static_cast<std::int32_t>(i);
            place.position_W = bodies[i].position_W;
            world_channels_->commands.push(place);
        }
    }
}

SessionInput LessonRun::gather(const FrameInput& input) {
    SessionInput gathered;
    gathered.time_s = input.time_s;
    gathered.dt_s = std::max(0.0, input.time_s - last_frame_s_);
    last_frame_s_ = input.time_s;
    channels_.state_for_lesson.take();
    gathered.hand = channels_.state_for_lesson.value();
    if (world_channels_) {
        world_channels_->snapshot.take();
        gathered.world = newest_world();
        for (WorldEvent event; world_channels_->events.pop(event);) {
            gathered.world_events.push_back(event);
        }
    }
    gathered.keys = input.keys;
    gathered.heard = input.typed;
    const SessionHud& hud = session_->hud();
    if (pupil_ && hud.question_open && !hud.invited && !gathered.heard) {
        gathered.heard = pupil_->answer(hud.question_asked_at_s, input.time_s);
    }
    record_events(gathered);
    return gathered;
}

// Null before the world's first round, and when the plan has none.
const WorldSnapshot* LessonRun::newest_world() const {
    const bool is_there = world_channels_ && world_channels_->snapshot.value().n_bodies > 0;
    return is_there ? &world_channels_->snapshot.value() : nullptr;
}

void LessonRun::record_events(const SessionInput& input) {
    if (!record_) {
        return;
    }
    const auto keep = [this](const Expected<void>& written) {
        if (!written && trouble_.empty()) {
            trouble_ = to_sentence(written.error());
        }
    };
    keep(record_->drain(*record_ring_));
    for (const WorldEvent& event : input.world_events) {
        keep(record_->append(RecordEvent{event.time_s, record_kind(event.kind), event.body, {}}));
    }
    if (input.heard) {
        keep(record_->append(
            RecordEvent{input.time_s, RecordEventKind::answered, kNoBody, *input.heard}));
    }
}

Expected<FrameReport> LessonRun::exchange_frame(const FrameInput& input) {
    const auto reply = process_->exchange(session_->begin_frame(gather(input)));
    if (!reply) {
        return tl::unexpected(reply.error());
    }
    return conclude(*reply);
}

Expected<void> LessonRun::begin_frame(const FrameInput& input) {
    return process_->send(session_->begin_frame(gather(input)));
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
    channels_.command.publish(output->force);
    for (const WorldCommand& command : output->world) {
        if (world_channels_) {
            world_channels_->commands.push(command);
        }
    }
    if (output->has_hand_target) {
        last_hand_target_.pose_D =
            compute_device_pose(plan_.haptic.workspace, output->hand_target_W);
        last_hand_target_.buttons = output->hand_buttons;
        hand_target_.publish(last_hand_target_);
    }
    if (output->printed.size() > kMostPrints) {
        output->printed.resize(kMostPrints);
        output->printed.emplace_back("(this frame printed more)");
    }
    return FrameReport{std::move(output->sounds), std::move(output->printed)};
}

void LessonRun::point_at(const Vector3& position_W, std::uint32_t buttons) {
    pointer_W_ = Pose::at(position_W);
    pointer_target_.publish(
        {compute_device_pose(plan_.haptic.workspace, pointer_W_).position, buttons});
}

void LessonRun::fail_softly(const std::string& sentence) {
    channels_.lesson_failed.store(true, std::memory_order_release);
    session_->end(EndReason::failed);
    if (record_) {
        (void)record_->append(
            RecordEvent{last_frame_s_, RecordEventKind::failed, kNoBody, sentence});
    }
}

Expected<void> LessonRun::finish_record() {
    if (!record_) {
        return {};
    }
    if (auto drained = record_->drain(*record_ring_); !drained) {
        return drained;
    }
    if (!trouble_.empty()) {
        return fail(trouble_);
    }
    return record_->finish();
}

View LessonRun::view(const dialogue::Catalogue& catalogue) const {
    Scenery scenery;
    scenery.time_s = last_frame_s_;
    scenery.hand = channels_.state_for_lesson.value();
    scenery.world = newest_world();
    scenery.renders_force = device_->traits().renders_force;
    scenery.ghost = !scenery.renders_force;
    scenery.ghost_pose_W = scenery.ghost ? pointer_W_ : scenery.hand.tool_pose_W;
    return compose_view(session_->description(), plan_, session_->hud(), scenery, catalogue);
}

void print_lines(const std::vector<std::string>& lines) {
    for (const std::string& line : lines) {
        std::puts(line.c_str());
    }
    if (!lines.empty()) {
        (void)std::fflush(stdout);
    }
}

void fill_in_memory(Plan& plan, const HapticLoop& loop) {
    for (const StageInfo& built : loop.stages()) {
        for (PlanStage& planned : plan.stages) {
            if (planned.loop == "haptic" && planned.name == built.name) {
                planned.memory_bytes = built.bytes;
            }
        }
    }
}

}  // namespace fulcrum::runtime
