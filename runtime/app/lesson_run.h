// One play of one lesson with everything it needs, built from its plan and nothing more:
//
//   lesson's process -> description -> plan -> hand, haptic loop, world loop, recorder -> session
//
// It owns no thread and no clock: a driver (headless.h, live_loops.h) calls the loops. `frame` halves belong to the lesson
// loop, `haptic_loop` and `world_loop` to their threads or to the same virtual clock.
#pragma once

#include "dialogue/catalogue.h"
#include "haptics/base/error.h"
#include "haptics/dynamics/rigid_loop.h"
#include "haptics/dynamics/world_loop.h"
#include "haptics/flight/kite_loop.h"
#include "haptics/handover/channels.h"
#include "haptics/loop/hands_loop.h"
#include "haptics/loop/haptic_loop.h"
#include "runtime/app/hand_device.h"
#include "runtime/app/places.h"
#include "runtime/app/replayed_input.h"
#include "runtime/app/replayed_stops.h"
#include "runtime/app/run_recorder.h"
#include "runtime/app/run_request.h"
#include "runtime/app/told_replay.h"
#include "runtime/app/world_post.h"
#include "runtime/audio/touch_sound.h"
#include "runtime/lesson/answer_choices.h"
#include "runtime/lesson/first_use.h"
#include "runtime/lesson/session.h"
#include "runtime/lesson/simulated_pupil.h"
#include "runtime/lesson/why_shown.h"
#include "runtime/lua/process/lesson_process.h"
#include "runtime/progress/store.h"
#include "runtime/scene/view.h"

#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace fulcrum::runtime {

/// What came in since the last frame besides the hand.
struct FrameInput {
    double time_s = 0.0;
    std::vector<std::string> keys;
    std::optional<std::string> typed;
    double wheel = 0.0;  ///< notches, away from the user is +
};

/// What the lesson's simulated hand wants of somebody at a desk.
struct HandWish {
    Pose target_W{};
    std::uint32_t buttons = 0;
    std::string key;  ///< to be pressed once; empty for none
};

struct Scenery;  // runtime/lesson/scenery.h

/// A hand beside the first: all that is its own.
struct MoreHand {
    HapticChannels channels{};
    RigidChannels rigid{};
    std::unique_ptr<HandDevice> device;
    std::unique_ptr<HapticLoop> loop;
    std::optional<HandWish> wish;
    std::shared_ptr<const Record> replayed;  ///< of this hand alone; null where none is repeated
    HandChoice choice{};                     ///< as it was settled
    HandFit fit{};                           ///< said and kept
};

/// What a hand's loop is told by a record.
struct ToldChannels {
    HapticChannels haptics{};
    AxleChannels axles{};
    RigidChannels rigid{};
    KiteChannels kite{};
};

/// What a frame asks of the driver.
struct FrameReport {
    std::vector<std::string> sounds;
    std::vector<std::string> printed;
    std::vector<std::string> said;
    std::vector<std::string> spoken;  ///< aloud, by who has a voice
};

class LessonRun {
  public:
    /// Starts the lesson's process, compiles the plan and builds its parts. Everything given outlives the run.
    [[nodiscard]] static Expected<std::unique_ptr<LessonRun>> create(
        const Places& places, const RunRequest& request, ProgressStore& store,
        const dialogue::Catalogue& catalogue);
    LessonRun(const LessonRun&) = delete;
    LessonRun& operator=(const LessonRun&) = delete;
    ~LessonRun();

    [[nodiscard]] const Plan& plan() const { return plan_; }
    [[nodiscard]] const LessonDescription& description() const { return session_->description(); }
    [[nodiscard]] LessonSession& session() { return *session_; }
    /// The first hand's loop.
    [[nodiscard]] HapticLoop& haptic_loop() { return *haptic_loop_; }
    /// A round of all hands: with one of them its loop itself.
    [[nodiscard]] PeriodicTask& hands_loop();
    /// The same round, told stage by stage.
    void step_hands(double now_s, StageListener& listener);
    [[nodiscard]] std::size_t n_hands() const { return 1 + more_hands_.size(); }
    /// The loop of each hand, and what is known of its device.
    [[nodiscard]] std::vector<const HapticLoop*> all_loops() const;
    [[nodiscard]] std::vector<DeviceTraits> all_traits() const;
    /// Told from now on of each frame what the lesson ordered; empty: nobody is.
    void listen_to_lesson(std::function<void(const SessionOutput&)> heard) {
        heard_ = std::move(heard);
    }
    /// What the same lesson would be planned as, were it changed so.
    [[nodiscard]] Expected<Plan> compile_changed(
        const Places& places, const RunRequest& request,
        const std::function<void(LessonDescription&)>& change) const;
    /// The hand that is moved so, counted from 0; none where no hand is.
    [[nodiscard]] std::optional<std::size_t> find_hand(HandKind kind) const;
    /// Whether a simulated person on whose arm things break sees anything to touch now.
    [[nodiscard]] bool sees_thing() const { return hand_->sees_thing(); }
    /// As the lesson's last frame had it; nothing without a world of rigid bodies.
    [[nodiscard]] WorldEffort world_effort() const;
    /// Whether any hand's device gives forces.
    [[nodiscard]] bool renders_force() const;
    /// Null when the plan has none.
    [[nodiscard]] PeriodicTask* world_loop() {
        return world_loop_ ? static_cast<PeriodicTask*>(world_loop_.get()) : rigid_loop_.get();
    }
    /// Likewise.
    [[nodiscard]] KiteLoop* kite_loop() { return kite_loop_.get(); }
    [[nodiscard]] HapticChannels& channels() { return channels_; }
    [[nodiscard]] const LessonProcess& process() const { return *process_; }
    /// The lesson's verdict about a meaning, as things stand; nothing else comes of it. Not between `begin_frame` and its reply.
    [[nodiscard]] Expected<bool> ask_verdict(const JudgeEvent& judge);
    /// Likewise what the lesson tells who asks for something; empty where it does not know that.
    [[nodiscard]] Expected<std::string> ask_knowledge(const AskedEvent& asked);
    /// The lesson hears of the event as of any other; what it replies is not done. An error is the lesson's own.
    [[nodiscard]] Expected<void> happen_aside(const LessonEvent& event);
    [[nodiscard]] const Device& device() const { return hand_->device(); }
    /// What strokes and taps sound like; null when the plan has no sound of touch.
    [[nodiscard]] SoundStream* touch_sound() { return touch_sound_.get(); }
    [[nodiscard]] const HandDevice& hand() const { return *hand_; }
    /// Whether the learner holds the mouse, or the arm, in the left hand.
    [[nodiscard]] bool left_handed() const { return fit_.left_handed.value_or(false); }
    /// Whether this hand's forces are to be tried first; `asked`: somebody will answer.
    [[nodiscard]] bool needs_trial(std::size_t hand, const RunRequest& request, bool asked) const;
    /// The hand's device while no loop of the lesson has it; `begin_anew` it behind.
    [[nodiscard]] HandDevice& hand_to_try(std::size_t hand) { return hand_at(hand); }
    /// The run's request as of this hand alone.
    [[nodiscard]] RunRequest request_of(std::size_t hand, const RunRequest& request) const;
    /// The limits that hold for it.
    [[nodiscard]] const SafetySettings& limits_of(std::size_t hand) const {
        return hand == 0 ? plan_.haptic.safety : plan_.more_hands[hand - 1].safety;
    }
    /// For how long each hand was asked to feel something, and what became of it; of one without motors: what it would have felt.
    /// While their loops do not step.
    [[nodiscard]] std::vector<FeltTime> felt_times() const;
    /// Keeps how it came out for this learner; without force where it was not good, in this run.
    void take_trial(std::size_t hand, const FirstUse& trial, bool asked, const RunRequest& request,
                    ProgressStore& store);
    /// The last gate as the lesson loop knows it.
    [[nodiscard]] GatePhase gate() const { return channels_.state_for_lesson.value().gate; }
    /// What was seen of an arm on which things break; null of another.
    [[nodiscard]] const SpoiledCounts* spoiled_counts() const { return hand_->spoiled_counts(); }
    [[nodiscard]] FeltLimits spoiled_limits() const { return hand_->spoiled_limits(); }
    /// The line of the L:test whose answers are given; 0 where they are somebody else's, or nobody's.
    [[nodiscard]] SourceLine say_line() const { return say_line_; }
    /// How many lines somebody gave to be said, by --say; 0 for none.
    [[nodiscard]] std::size_t n_given_lines() const { return n_given_lines_; }
    /// Whoever is simulated to answer; nobody where a person does.
    [[nodiscard]] const std::optional<SimulatedPupil>& pupil() const { return pupil_; }

    /// One frame, waiting for the lesson's answer. An error means that the lesson has failed.
    [[nodiscard]] Expected<FrameReport> exchange_frame(const FrameInput& input);
    /// The same in two halves that do not wait. `begin_frame` may be called when no answer is outstanding.
    [[nodiscard]] Expected<void> begin_frame(const FrameInput& input);
    [[nodiscard]] std::optional<Expected<FrameReport>> poll_frame();

    /// What the simulated pupil says to the question that is open, or asks while none is, when it is time for it; given once.
    [[nodiscard]] Expected<std::optional<std::string>> hear_pupil(double time_s);
    /// Somebody at a desk plays: what the newest reply of the simulated hand wants; nothing before the first. Taken, its key is pressed.
    [[nodiscard]] std::optional<HandWish> take_wish();
    /// Likewise of the second hand, which presses nothing; nothing where it is not there.
    [[nodiscard]] std::optional<HandWish> second_wish() const;
    /// Answers to the question of now to choose from; none where nothing is asked. Not between `begin_frame` and its reply.
    [[nodiscard]] Expected<std::vector<AnswerChoice>> make_choices();

    /// Where the pointer of this hand points, in the world; for those that have one.
    void point_at(std::size_t hand, const Vector3& position_W, std::uint32_t buttons);
    /// Makes the force fade at once and stay away: the lesson has failed with this sentence.
    void fail_softly(const std::string& sentence);
    /// The same where all is well: the lesson is left.
    void end_softly() { channels_.ended.store(true, std::memory_order_release); }
    /// Until the force is gone after either, and a record shows it.
    [[nodiscard]] double fade_shown_s() const;
    /// True while the device gives no poses or takes no forces.
    [[nodiscard]] bool device_is_lost() const;
    /// True while a force or a torque waits at any gate for its hand to rest.
    [[nodiscard]] bool holds_back() const;
    /// What has happened to the hand's device since the last call, a sentence; empty when nothing has.
    [[nodiscard]] std::string take_device_notice();
    /// What got lost between the loops, a sentence each; none in a good run. Call it when the loops stand still.
    [[nodiscard]] std::vector<std::string> losses() const;
    /// How a hand's forces compare with those of the record that is repeated; null where none is.
    [[nodiscard]] const ReplayCheck* replay_check(std::size_t hand = 0) const {
        return recorder_ ? recorder_->check(hand) : nullptr;
    }
    /// When that record ends, on the run's clock; nothing where none is repeated, or an old one.
    [[nodiscard]] std::optional<double> replay_end_s() const;
    /// Closes the record.
    [[nodiscard]] Expected<void> finish_record();
    /// Whether somebody looks on who may ask why a force is felt.
    [[nodiscard]] bool tells_why() const { return !why_.empty(); }
    /// Why that hand feels its force, as things stand; nothing where nobody may ask, or there is no such hand.
    [[nodiscard]] ViewWhy why(std::size_t hand, const dialogue::Catalogue& catalogue) const;
    /// The picture as things stand.
    [[nodiscard]] View view(const dialogue::Catalogue& catalogue) const;

  private:
    LessonRun() = default;
    /// What the lesson replies to that event alone.
    [[nodiscard]] Expected<LessonReply> ask_aside(const LessonEvent& event);
    // In this order.
    [[nodiscard]] Expected<void> load(const Places& places, RunRequest& request);
    [[nodiscard]] Expected<void> open_hand(const Places& places, const RunRequest& request);
    [[nodiscard]] Expected<void> open_more_hands(const Places& places, const RunRequest& request,
                                                 ProgressStore& store);
    [[nodiscard]] HandDevice& hand_at(std::size_t hand) const {
        return hand == 0 ? *hand_ : *more_hands_[hand - 1]->device;
    }
    /// The hand as lesson and picture see it: one without motors with what would be felt, for no force can hurt there, and a gate that
    /// waits would leave nothing to be seen. Nothing while it is stopped or anything is wrong.
    [[nodiscard]] static HapticState seen(const HandDevice& device, const HapticState& state);
    [[nodiscard]] const HandFit& fit_of(std::size_t hand) const {
        return hand == 0 ? fit_ : more_hands_[hand - 1]->fit;
    }
    [[nodiscard]] Expected<void> build_loops(const Places& places, const RunRequest& request);
    [[nodiscard]] Expected<Plan> compile(const Places& places, const RunRequest& request,
                                         const LessonDescription& scene) const;
    /// The most that all hands can give, newtons: as far as it is known before they are open, or of the first one as it says itself.
    [[nodiscard]] double force_limit_N(const RunRequest& request) const;
    [[nodiscard]] Expected<void> fit_to_force(const Places& places, const RunRequest& request);
    [[nodiscard]] WallHolders find_holders(const WallHolders& repeated) const;
    [[nodiscard]] Expected<Plan> compile_scaled(const Places& places, const RunRequest& request,
                                                std::size_t hand, double factor,
                                                LessonDescription& scene) const;
    [[nodiscard]] Expected<void> scale_as_said(const Places& places, const RunRequest& request,
                                               std::size_t hand, const HandFit& fit);
    void fit_to_reach(const Places& places, const RunRequest& request, std::size_t hand,
                      double factor);
    void withhold_refused(std::size_t hand, const RunRequest& request, const HandFit& fit);
    void build_why(const RunRequest& request);
    void look_why(const SessionInput& gathered);
    [[nodiscard]] Expected<void> build_recorder(const Places& places, const RunRequest& request);
    void build_touch_sound();
    void build_hands(const RunRequest& request);
    void build_more_loops();
    void build_replayed_stops(const RunRequest& request);
    void build_told(const RunRequest& request);
    void build_told_replay(const RunRequest& request);
    [[nodiscard]] HapticChannels& channels_at(std::size_t hand) {
        return hand == 0 ? channels_ : more_hands_[hand - 1]->channels;
    }
    /// Those of the hand's loop: in a run that is told by a record, others than those that the rest of the run has.
    [[nodiscard]] HapticChannels& loop_channels(std::size_t hand) {
        return hand < told_.size() ? told_[hand]->haptics : channels_at(hand);
    }
    void gather_more_hands(SessionInput& gathered);
    void show_more_hands(Scenery& scenery) const;
    void lead_more_hands(const SessionOutput& output);
    [[nodiscard]] Expected<void> build_rigid_loop();
    void take_rigid_bodies();
    [[nodiscard]] Expected<void> build_session(const RunRequest& request, ProgressStore& store,
                                               const dialogue::Catalogue& catalogue);

    void choose_pupil(const LessonDescription& description, const RunRequest& request);
    void place_visible_bodies();
    void look_around();
    [[nodiscard]] Expected<SessionInput> gather(const FrameInput& input);
    [[nodiscard]] Expected<FrameReport> conclude(const LessonReply& reply);
    [[nodiscard]] Expected<void> command_world(const std::vector<WorldCommand>& commands);
    [[nodiscard]] const WorldSnapshot* newest_world() const;
    [[nodiscard]] const AxleFrame* newest_axles() const;
    [[nodiscard]] const KiteFrame* newest_kite() const;
    void order_kite(const SessionOutput& output);

    std::unique_ptr<LessonProcess> process_;
    LessonDescription scene_{};  // the lesson's, at the scale of this hand
    Plan plan_{};
    HapticChannels channels_{};
    std::unique_ptr<WorldChannels> world_channels_;
    std::unique_ptr<AxleChannels> axles_;  // null when nothing turns
    std::unique_ptr<KiteChannels> kite_;   // null when nothing flies
    std::unique_ptr<HandDevice> hand_;
    std::unique_ptr<HapticLoop> haptic_loop_;
    std::vector<std::unique_ptr<MoreHand>> more_hands_;
    std::vector<std::string> hand_notices_;  // of who moves which
    std::unique_ptr<HandsLoop> hands_loop_;  // null with one hand
    std::unique_ptr<ReplayedStops> stops_;   // around either, where a record is repeated
    std::vector<std::unique_ptr<ToldChannels>>
        told_;                                 // of each hand; none where no record tells all
    std::unique_ptr<ToldReplay> told_replay_;  // instead of those, where one does
    std::unique_ptr<WorldLoop> world_loop_;
    std::unique_ptr<KiteLoop> kite_loop_;
    std::unique_ptr<RigidChannels> rigid_;  // null without rigid bodies, like the next
    std::unique_ptr<RigidLoop> rigid_loop_;
    WorldSnapshot seen_{};                // with rigid bodies: them, and those that stay
    std::unique_ptr<TouchRing> touches_;  // null when touch is not heard, like the next
    std::unique_ptr<TouchSound> touch_sound_;
    // What one hand's force is made of, for the panel that says so.
    struct AskedWhy {
        explicit AskedWhy(WhyShown why) : shown(std::move(why)) {}
        LatestValue<ForceShares> shares;
        WhyShown shown;
    };
    std::vector<std::unique_ptr<AskedWhy>> why_;  // of each hand; none where nobody asks
    std::unique_ptr<RunRecorder> recorder_;       // null when nothing is recorded
    std::unique_ptr<LessonSession> session_;
    std::optional<SimulatedPupil> pupil_;
    HandFit fit_{};                          // said and kept
    std::optional<ReplayedInput> replayed_;  // where a record tells what was done besides the hand
    bool at_desk_ = false;                   // who plays types and chooses the pupil's answers
    std::size_t looked_at_ = kMaxBodies;     // body by its index; none
    std::optional<HandWish> wish_;
    WorldPost to_world_;
    SourceLine say_line_ = 0;
    std::size_t n_given_lines_ = 0;
    double last_frame_s_ = 0.0;
    std::function<void(const SessionOutput&)> heard_;
};

/// What a world is told before the first frame: which bodies are there.
[[nodiscard]] std::vector<WorldCommand> place_at_first(const LessonDescription& lesson);

/// What a lesson's print() said, on the terminal, at once.
void print_lines(const std::vector<std::string>& lines);

/// What a teacher should know of the scene before it is played, on the terminal.
void say_notices(const LessonRun& run);
/// What got lost in a run, likewise.
void say_losses(const LessonRun& run);

/// Writes into the plan's stages of that name how much memory the loop that was built from it uses for each.
void fill_in_memory(Plan& plan, const std::string& name, const HapticLoop& loop);

}  // namespace fulcrum::runtime
