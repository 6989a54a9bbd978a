#include "runtime/app/lesson_run.h"

#include "runtime/app/hand_fitting.h"
#include "runtime/app/interrupt.h"
#include "runtime/app/kept_feedback.h"
#include "runtime/app/lesson_parts.h"
#include "runtime/files/shape_cache.h"
#include "runtime/lesson/compose_view.h"
#include "runtime/lesson/learner_feedback.h"
#include "runtime/lesson/learner_throat.h"
#include "runtime/lesson/past_answers.h"
#include "runtime/lesson/questions.h"
#include "runtime/scene/compile_plan.h"
#include "runtime/scene/plan_hands.h"
#include "runtime/text/progress_line.h"

#include <algorithm>
#include <cstdio>

namespace fulcrum::runtime {
namespace {

constexpr const char* kGuest = "guest";
constexpr std::size_t kMostPrints = 8;  // lines a frame: a terminal must not hold the lesson up

// With the user's cache of shapes and a line that says how far it has come; nothing of either where the lesson needs none.
Expected<Plan> compile_shown(const LessonDescription& lesson, PlanOptions options,
                             const SolidLoader& load_solid, const PictureLoader& load_picture) {
    if (!lesson.hand.tool) {
        return compile_plan(lesson, options, load_solid, load_picture);
    }
    const auto folder = default_shape_cache_folder();
    ShapeCache shapes({.folder = folder.value_or(std::filesystem::path{})});
    Expected<Plan> plan = [&] {
        ProgressLine line("Making " + lesson.id + " ready:");
        options.shapes = &shapes;
        options.progress = [&line](double share, std::string_view what) {
            line.say(share, what);
            return !interrupted();
        };
        return compile_plan(lesson, options, load_solid, load_picture);
    }();
    for (const std::string& sentence : shapes.told()) {
        std::fprintf(stderr, "%s\n", sentence.c_str());
    }
    return plan;
}
}  // namespace

LessonRun::~LessonRun() = default;

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
    const auto built = run->load(places, settled)
                           .and_then([&] { return run->open_hand(places, settled); })
                           .and_then([&] { return run->open_more_hands(places, settled, store); })
                           .and_then([&] { return run->build_loops(places, settled); })
                           .and_then([&] { return run->build_session(settled, store, catalogue); });
    if (!built) {
        return tl::unexpected(built.error());
    }
    keep_fit_of(request, store);
    for (std::size_t hand = 1; hand < run->n_hands(); ++hand) {
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
    if (auto models = check_models(places, request.folder, process_->description()); !models) {
        return models;
    }
    scene_ = process_->description();
    scene_.hand.scale *= request.fit.scale.value_or(1.0);
    auto plan = compile(places, request, scene_);
    if (!plan) {
        return tl::unexpected(plan.error());
    }
    plan_ = std::move(*plan);
    hand_notices_ = std::move(started->notices);
    return {};
}

Expected<Plan> LessonRun::compile(const Places& places, const RunRequest& request,
                                  const LessonDescription& scene) const {
    PlanOptions options = request.plan;
    options.device_force_limit_N = force_limit_N(request);
    if (hand_) {
        options.holders = find_holders(request.plan.holders);
    }
    return compile_shown(scene, std::move(options), make_solid_loader(places, request.folder),
                         make_picture_loader(request.folder, scene.hand.scale))
        .and_then([](Plan&& plan) {
            return validate(plan.haptic)
                .and_then([&] {
                    return plan.world   ? validate(*plan.world)
                           : plan.rigid ? validate(*plan.rigid)
                                        : Expected<void>{};
                })
                .map([&] { return std::move(plan); });
        });
}

// What a device can reach is known when it is open.
Expected<void> LessonRun::open_hand(const Places& places, const RunRequest& request) {
    auto hand = HandDevice::open(request, plan_.haptic);
    if (!hand) {
        return tl::unexpected(hand.error());
    }
    hand_ = std::move(*hand);
    if (auto fitted = fit_to_force(places, request); !fitted) {
        return fitted;
    }
    if (const double factor = choose_scale(request.fit, device().traits()); factor != 1.0) {
        fit_to_reach(places, request, 0, factor);
    }
    return validate(plan_.haptic, device().traits());
}

// Only what is in the plan is built.
Expected<void> LessonRun::build_loops(const Places& places, const RunRequest& request) {
    if (plan_.touch_sound) {
        build_touch_sound();
    }
    if (!plan_.haptic.axles.empty()) {
        axles_ = std::make_unique<AxleChannels>();
        channels_.axles = axles_.get();
    }
    if (plan_.kite) {
        kite_ = std::make_unique<KiteChannels>();
        channels_.kite = kite_.get();
        kite_loop_ = std::make_unique<KiteLoop>(plan_.kite->flight,
                                                plan_.kite->rate_hz * plan_.kite->n_parts, *kite_);
    }
    if (plan_.rigid) {
        if (auto built = build_rigid_loop(); !built) {
            return built;
        }
    }
    build_hands(request);
    build_why(request);
    if (auto recorded = build_recorder(places, request); !recorded) {
        return recorded;
    }
    if (plan_.world) {
        std::vector<std::int32_t> solid_bodies;
        for (const SolidPlan& solid : plan_.haptic.solids) {
            solid_bodies.push_back(solid.body);
        }
        world_channels_ = std::make_unique<WorldChannels>();
        world_loop_ = std::make_unique<WorldLoop>(*plan_.world, std::move(solid_bodies),
                                                  *world_channels_, channels_);
    }
    fill_in_memory(plan_, name_of_loop(0), *haptic_loop_);
    for (std::size_t i = 0; i < more_hands_.size(); ++i) {
        fill_in_memory(plan_, name_of_loop(i + 1), *more_hands_[i]->loop);
    }
    return {};
}

// The loop tells what it touches, and each solid that can be heard has its tone.
void LessonRun::build_touch_sound() {
    std::vector<TapTone> tones;
    for (const SolidPlan& solid : plan_.haptic.solids) {
        tones.push_back(solid.surface.audible ? tone_of(solid.surface.transient) : TapTone{});
    }
    touches_ = std::make_unique<TouchRing>();
    channels_.touches = touches_.get();
    touch_sound_ =
        std::make_unique<TouchSound>(*touches_, std::move(tones), 1.0 / plan_.haptic.rate_hz);
    for (PlanStage& stage : plan_.stages) {
        if (stage.loop == "sound" && stage.name == "touch") {
            stage.memory_bytes = sizeof(TouchRing) + sizeof(TouchSound);
        }
    }
}

// Who plays, and who answers.
namespace {

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

Expected<void> LessonRun::build_session(const RunRequest& request, ProgressStore& store,
                                        const dialogue::Catalogue& catalogue) {
    LessonDescription description = scene_;
    at_desk_ = request.by != PlayedBy::arm;
    fit_ = request.fit;
    const auto learner = store.enrol(request.learner.empty() ? kGuest : request.learner);
    if (!learner) {
        return tl::unexpected(learner.error());
    }
    const bool is_known = !request.learner.empty() && learner->nickname != kSimulatedPupil;
    choose_feedback(description, request.feedback.value_or(request.kept_feedback));
    choose_pupil(description, request);
    auto past = recall(store, *learner, description.wants_past);
    if (plan_.recogniser && plan_.hearing.takes_throat && plan_.hearing.throat == 0.0 && is_known) {
        plan_.hearing.throat = read_throat(store, *learner).value_or(0.0);
    }
    auto session =
        LessonSession::create(std::move(description), plan_, catalogue, store, learner->id,
                              version_of(process_->files_read()), std::move(past));
    if (!session) {
        return tl::unexpected(session.error());
    }
    session_ = std::move(*session);
    if (request.feedback && is_known) {
        session_->keep_setting(kFeedback, feedback_text(*request.feedback));
    }
    place_visible_bodies();
    return {};
}

Expected<SessionInput> LessonRun::gather(const FrameInput& input) {
    SessionInput gathered;
    gathered.time_s = input.time_s;
    gathered.dt_s = std::max(0.0, input.time_s - last_frame_s_);
    last_frame_s_ = input.time_s;
    channels_.state_for_lesson.take();
    gathered.hand = seen(*hand_, channels_.state_for_lesson.value());
    gather_more_hands(gathered);
    if (world_channels_) {
        world_channels_->snapshot.take();
        take_rigid_bodies();
        gathered.world = newest_world();
        for (WorldEvent event; world_channels_->events.pop(event);) {
            gathered.world_events.push_back(event);
        }
    }
    if (axles_) {
        axles_->frame.take();
        gathered.axles = newest_axles();
    }
    if (kite_) {
        kite_->frame.take();
        gathered.kite = newest_kite();
    }
    gathered.wheel = input.wheel;
    gathered.keys = input.keys;
    gathered.heard = input.typed;
    if (wish_ && !at_desk_ && !wish_->key.empty()) {
        gathered.keys.push_back(std::exchange(wish_->key, {}));
    }
    if (replayed_) {
        replayed_->add_to(gathered);
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
    look_why(gathered);
    return gathered;
}

// Null before the world's first round, and when the plan has none.
const WorldSnapshot* LessonRun::newest_world() const {
    if (rigid_loop_) {
        return seen_.n_bodies > 0 ? &seen_ : nullptr;
    }
    const bool is_there = world_channels_ && world_channels_->snapshot.value().n_bodies > 0;
    return is_there ? &world_channels_->snapshot.value() : nullptr;
}

WorldEffort LessonRun::world_effort() const {
    const WorldSnapshot* const world = newest_world();
    return world != nullptr ? world->effort : WorldEffort{};
}

const AxleFrame* LessonRun::newest_axles() const {
    return axles_ && axles_->frame.value().n_axles > 0 ? &axles_->frame.value() : nullptr;
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
    channels_.command.publish(output->force);
    lead_more_hands(*output);
    if (axles_) {
        axles_->orders.publish(output->axles);
    }
    if (kite_) {
        order_kite(*output);
    }
    if (auto commanded = command_world(output->world); !commanded) {
        return tl::unexpected(commanded.error());
    }
    if (output->has_hand_target) {
        if (spoiled_counts() != nullptr) {
            look_around();
        }
        hand_->follow(output->hand_target_W, output->hand_buttons);
        wish_ = HandWish{output->hand_target_W, output->hand_buttons, output->hand_key};
    }
    if (output->printed.size() > kMostPrints) {
        output->printed.resize(kMostPrints);
        output->printed.emplace_back("(this frame printed more)");
    }
    return FrameReport{std::move(output->sounds), std::move(output->printed),
                       std::move(output->said), std::move(output->spoken)};
}

Expected<void> LessonRun::command_world(const std::vector<WorldCommand>& commands) {
    return world_channels_ ? to_world_.send(commands, world_channels_->commands) : Expected<void>{};
}

double LessonRun::fade_shown_s() const {
    constexpr double kMargin_s = 0.05;  // some rounds beyond the gate's own fade
    return plan_.haptic.safety.fade_s + kMargin_s;
}

View LessonRun::view(const dialogue::Catalogue& catalogue) const {
    Scenery scenery;
    scenery.time_s = last_frame_s_;
    scenery.hand = seen(*hand_, channels_.state_for_lesson.value());
    scenery.world = newest_world();
    scenery.axles = newest_axles();
    scenery.kite = newest_kite();
    scenery.renders_force = hand_->renders_force();
    const bool points = !scenery.renders_force && hand_->points();
    scenery.ghost = points || plan_.haptic.tool != nullptr;
    scenery.ghost_pose_W = points ? hand_->pointer_W() : scenery.hand.tool_pose_W;
    show_more_hands(scenery);
    return compose_view(session_->description(), plan_, session_->hud(), scenery, catalogue);
}

}  // namespace fulcrum::runtime
