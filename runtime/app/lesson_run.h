// One play of one lesson with everything it needs, built from its plan and nothing more:
//
//   lesson's process -> description -> plan -> hands, effects, recorder -> session
//
// A run is a list of hands (run_hand.h), a list of running effects (run_effects.h) and what happens in a frame. It owns no thread and no
// clock: a driver (headless.h, live_loops.h) calls them. `frame` halves belong to the lesson loop, rounds and effects
// to their threads or to the same virtual clock.
#pragma once

#include "dialogue/catalogue.h"
#include "haptics/base/error.h"
#include "runtime/app/lesson_aside.h"
#include "runtime/app/lesson_bodies.h"
#include "runtime/app/lesson_frame.h"
#include "runtime/app/places.h"
#include "runtime/app/run_effects.h"
#include "runtime/app/run_hand.h"
#include "runtime/app/run_plan.h"
#include "runtime/app/run_pupil.h"
#include "runtime/app/run_recorder.h"
#include "runtime/app/run_request.h"
#include "runtime/app/run_rounds.h"
#include "runtime/app/run_why.h"
#include "runtime/lesson/session.h"
#include "runtime/lesson/still_hand.h"
#include "runtime/lua/process/lesson_process.h"
#include "runtime/progress/store.h"
#include "runtime/scene/view.h"

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace fulcrum::runtime {

class LessonRun {
  public:
    /// Starts the lesson's process, compiles the plan and builds its parts. Everything given outlives the run.
    [[nodiscard]] static Expected<std::unique_ptr<LessonRun>> create(
        const Places& places, const RunRequest& request, ProgressStore& store,
        const dialogue::Catalogue& catalogue);
    LessonRun(const LessonRun&) = delete;
    LessonRun& operator=(const LessonRun&) = delete;
    ~LessonRun();

    [[nodiscard]] const Plan& plan() const { return plan_.plan(); }
    [[nodiscard]] const LessonDescription& description() const { return session_->description(); }
    [[nodiscard]] const LessonProcess& process() const { return *process_; }
    [[nodiscard]] LessonSession& session() { return *session_; }
    [[nodiscard]] const LessonSession& session() const { return *session_; }
    [[nodiscard]] RunEffects& effects() { return effects_; }
    [[nodiscard]] const RunHands& hands() const { return hands_; }
    [[nodiscard]] RunHand& hand_at(std::size_t hand) { return *hands_[hand]; }
    /// The first one's.
    [[nodiscard]] HapticLoop& haptic_loop() { return *hands_.front()->loop; }
    [[nodiscard]] HapticChannels& channels() { return hands_.front()->channels; }
    [[nodiscard]] HandDevice& hand() { return *hands_.front()->device; }
    [[nodiscard]] const HandDevice& hand() const { return *hands_.front()->device; }
    /// Whether the learner holds the mouse, or the arm, in the left hand.
    [[nodiscard]] bool left_handed() const {
        return hands_.front()->fit.left_handed.value_or(false);
    }
    /// From now on; an arm's buttons stay as they are until the next run.
    void hold_by(bool left_handed) { hands_.front()->fit.left_handed = left_handed; }
    /// Whoever answers where no person does.
    [[nodiscard]] RunPupil& pupil() { return pupil_; }
    [[nodiscard]] const RunPupil& pupil() const { return pupil_; }
    /// What the same lesson would be planned as, were it changed so.
    [[nodiscard]] Expected<Plan> compile_changed(
        const Places& places, const RunRequest& request,
        const std::function<void(LessonDescription&)>& change) const {
        return plan_.compile_changed({places, request}, hands_, change);
    }

    /// A round of all hands.
    [[nodiscard]] RunRounds& rounds() { return rounds_; }
    /// Told from now on of each frame what the lesson ordered; empty: nobody is.
    void listen_to_lesson(std::function<void(const SessionOutput&)> heard) {
        heard_ = std::move(heard);
    }

    /// One frame, waiting for the lesson's answer. An error means that the lesson has failed.
    [[nodiscard]] Expected<FrameReport> exchange_frame(const FrameInput& input);
    /// The same in two halves that do not wait. `begin_frame` may be called when no answer is outstanding.
    [[nodiscard]] Expected<void> begin_frame(const FrameInput& input);
    [[nodiscard]] std::optional<Expected<FrameReport>> poll_frame();

    /// While no answer is outstanding.
    [[nodiscard]] LessonAside aside() const { return {*process_, *session_}; }
    /// What the simulated pupil says to the question that is open, or asks while none is, when it is time for it; given once.
    [[nodiscard]] Expected<std::optional<std::string>> hear_pupil(double time_s);

    /// Makes the force fade at once and stay away: the lesson has failed with this sentence.
    void fail_softly(const std::string& sentence);
    /// The same where all is well: the lesson is left.
    void end_softly() { channels().ended.store(true, std::memory_order_release); }
    /// Until the force is gone after either, and a record shows it.
    [[nodiscard]] double fade_shown_s() const;
    /// The first hand's last gate as the lesson loop knows it.
    [[nodiscard]] GatePhase gate() const { return hands_.front()->state().gate; }
    /// Rounds that the recorder was too slow for.
    [[nodiscard]] std::uint64_t n_rounds_dropped() const {
        return recorder_ ? recorder_->dropped() : 0;
    }
    /// How a hand's forces compare with those of the record that is repeated; null where none is.
    [[nodiscard]] const ReplayCheck* replay_check(std::size_t hand = 0) const {
        return recorder_ ? recorder_->check(hand) : nullptr;
    }
    /// When the record ends that is repeated, on the run's clock; nothing where none is, or an old one.
    [[nodiscard]] std::optional<double> replay_end_s() const {
        const ReplayedInput* const replayed = pupil_.replayed();
        return replayed != nullptr ? rounds_.replay_end_s(replayed->record(), plan().haptic.rate_hz)
                                   : std::nullopt;
    }
    /// While no frame comes: a record goes on.
    void keep_rounds() {
        if (recorder_) {
            recorder_->keep_rounds();
        }
    }
    /// Closes the record.
    [[nodiscard]] Expected<void> finish_record();

    /// Why a hand feels its force, where somebody looks on who may ask.
    [[nodiscard]] const RunWhy& why() const { return why_; }
    /// The picture as things stand; `calm`: nothing in it is squashed or glides that need not.
    [[nodiscard]] View view(const dialogue::Catalogue& catalogue, bool calm = false) const;

  private:
    LessonRun() = default;
    // In this order.
    [[nodiscard]] Expected<void> load(const Places& places, ProgressStore& store,
                                      RunRequest& request);
    [[nodiscard]] Expected<void> build_loops(const RunOrder& order);
    [[nodiscard]] Expected<void> build_session(const RunOrder& order, ProgressStore& store,
                                               const dialogue::Catalogue& catalogue);

    [[nodiscard]] Expected<SessionInput> gather(const FrameInput& input);
    [[nodiscard]] Expected<FrameReport> conclude(const LessonReply& reply);

    std::unique_ptr<LessonProcess> process_;
    RunPlan plan_;
    RunHands hands_;  // at least one
    RunEffects effects_;
    RunRounds rounds_;
    RunWhy why_;
    std::unique_ptr<RunRecorder> recorder_;  // null when nothing is recorded
    std::unique_ptr<LessonSession> session_;
    RunPupil pupil_;
    NearestThing nearest_;
    StillHand still_hand_;
    std::vector<std::string> started_notices_;  // of who moves which
    bool at_desk_ = false;                      // who plays types and chooses the pupil's answers
    double last_frame_s_ = 0.0;                 // on the lesson's own clock
    double last_clock_s_ = 0.0;
    std::function<void(const SessionOutput&)> heard_;
};

}  // namespace fulcrum::runtime
