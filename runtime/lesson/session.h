// One play of one lesson: turns what happened into a frame for the lesson's Lua, and the Lua's
// commands into what the loops, the picture, the sound and the store do.
//
//   what happened --begin_frame--> LessonFrame --lesson's process--> LessonReply --finish_frame--> what to do
//
// The question of now is question_dialogue.h's, who hears and says it speech.h's, who chooses the words talk.h's, what is kept session_log.h's, what is
// told of it transcript.h's; the commands one by one stand in carry_out.cpp.
//
// Thread: lesson loop. Cost: microseconds, and what the store takes for an answer.
#pragma once

#include "dialogue/catalogue.h"
#include "haptics/base/error.h"
#include "runtime/effect/hinge/play_hinges.h"
#include "runtime/effect/kite/play_kite.h"
#include "runtime/lesson/knowledge.h"
#include "runtime/lesson/question_dialogue.h"
#include "runtime/lesson/session_log.h"
#include "runtime/lesson/session_messages.h"
#include "runtime/lesson/speech.h"
#include "runtime/lesson/talk.h"
#include "runtime/lesson/transcript.h"
#include "runtime/progress/store.h"
#include "runtime/scene/description.h"
#include "runtime/scene/plan.h"

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace fulcrum::runtime {

class LessonSession {
  public:
    /// Compiles the questions. The store and the catalogue outlive the session. `known`: what it asks for.
    [[nodiscard]] static Expected<std::unique_ptr<LessonSession>> create(
        LessonDescription description, const Plan& plan, const dialogue::Catalogue& catalogue,
        ProgressStore& store, LearnerId learner, std::string lesson_version,
        KnownAtFirst known = {});

    /// Keeps what was chosen for this session and its learner, beside its settings.
    void keep_setting(const std::string& name, const std::string& value) {
        log_.keep_setting(name, value);
    }
    /// The message for the lesson's process; valid until the next call.
    [[nodiscard]] const LessonFrame& begin_frame(const SessionInput& input);
    /// The newest one, as it was sent.
    [[nodiscard]] const LessonFrame& newest_frame() const { return frame_; }
    /// Carries the reply out. A reply that names a body, force or question that isn't there is the
    /// lesson's error.
    [[nodiscard]] Expected<SessionOutput> finish_frame(const LessonReply& reply);

    /// Somebody wants to know what the learner says.
    [[nodiscard]] bool listens() const { return speech_.listening(); }
    /// The learner's utterance through a microphone; its words come in a later frame.
    void hear_utterance(std::span<const std::int16_t> utterance) { speech_.hear(utterance); }

    [[nodiscard]] const LessonDescription& description() const { return description_; }
    [[nodiscard]] const SessionHud& hud() const { return hud_; }
    [[nodiscard]] const SessionResult& result() const { return result_; }
    /// The learner may choose from these: it is told of the play.
    void tell_offer(const std::vector<AnswerChoice>& choices) {
        transcript_.offer(time_s_, choices);
    }
    /// The question that is asked now; null when there is none.
    [[nodiscard]] const dialogue::Question* question() const { return dialogue_.question(); }
    /// What the learner may ask for; nothing for most lessons.
    [[nodiscard]] const std::optional<Knowledge>& knowledge() const { return knowledge_; }
    /// Keeps the session's end, once; a session that is dropped without it counts as left.
    void end(EndReason reason);
    /// Waits until the store has kept everything, at most so long; call it when the hand feels nothing any more.
    void settle(double patience_s) { log_.settle(patience_s); }
    /// The sentence of the first write that was not kept, or empty; the lesson goes on without it.
    [[nodiscard]] const std::string& store_trouble() const { return log_.trouble(); }

  private:
    LessonSession(LessonDescription description, const Plan& plan,
                  const dialogue::Catalogue& catalogue, QuestionDialogue dialogue, SessionLog log,
                  std::optional<Knowledge> knowledge, KnownAtFirst known);

    void queue_world_events(const std::vector<WorldEvent>& events);
    void queue_touch_events(const SessionInput& input);
    [[nodiscard]] std::string catch_sound(std::int32_t body) const;
    void hear(const dialogue::Hypothesis& heard);
    [[nodiscard]] bool ask_for(const std::string& words, const dialogue::Hypothesis& heard);
    [[nodiscard]] bool asks_instead(const std::string& words, double confidence) const;
    void take_question(AskedFor asked, double confidence);
    void tell(const std::string& said, const std::string& answer);
    void tell_about(std::int32_t body);
    [[nodiscard]] Expected<void> keep_listening();
    [[nodiscard]] Expected<void> keep_listening_for_asking();
    void take(QuestionTurn turn);
    void keep_said(const MarkedAnswer& answer);
    void keep_said(std::string said);
    void count(const MarkedAnswer& answer);
    void say_back();
    void burst(const Vector3& at_W);
    void show();

    // One for each command a lesson can send; an error when it names something that isn't there.
    Expected<void> carry_out(const MoveCommand& command, SessionOutput& output);
    Expected<void> carry_out(const CoverCommand& command, SessionOutput& output);
    Expected<void> carry_out(const MarkCommand& command, SessionOutput& output);
    Expected<void> carry_out(const LightCommand& command, SessionOutput& output);
    Expected<void> carry_out(const TurnCommand& command, SessionOutput& output);
    Expected<void> carry_out(const KiteCommand& command, SessionOutput& output);
    Expected<void> carry_out(const WindCommand& command, SessionOutput& output);
    Expected<void> carry_out(const FieldChangeCommand& command, SessionOutput& output);
    Expected<void> carry_out(const LessonForceCommand& command, SessionOutput& output);
    Expected<void> carry_out(const CaptionCommand& command, SessionOutput& output);
    Expected<void> carry_out(const AskCommand& command, SessionOutput& output);
    Expected<void> carry_out(const VerdictCommand& command, SessionOutput& output);
    Expected<void> carry_out(const TellCommand& command, SessionOutput& output);
    Expected<void> carry_out(const ScoreCommand& command, SessionOutput& output);
    Expected<void> carry_out(const LevelCommand& command, SessionOutput& output);
    Expected<void> carry_out(const SoundCommand& command, SessionOutput& output);
    Expected<void> carry_out(const ShowHandCommand& command, SessionOutput& output);
    Expected<void> carry_out(const FinishCommand& command, SessionOutput& output);
    Expected<void> carry_out(const EnterCommand& command, SessionOutput& output);
    void finish();
    Expected<void> carry_out(const PrintCommand& command, SessionOutput& output);

    LessonDescription description_;
    const dialogue::Catalogue* catalogue_;
    QuestionDialogue dialogue_;
    std::optional<Knowledge> knowledge_;  // what may be asked for; nothing for most lessons
    std::optional<AskedFor> asked_for_;   // until the lesson has told it
    bool listens_for_asking_ = false;
    std::vector<bool> told_about_;  // by body
    SessionLog log_;
    bool ended_ = false;  // its end is kept
    Speech speech_;
    Talk talk_;
    Transcript transcript_;
    int turn_ = 0;  // of the dialogue's, the one that is listened for

    // What the lesson has asked for so far.
    ForceCommand force_{};
    PlayedHinges hinges_;
    PlayedKite kite_;
    SessionHud hud_{};
    SessionResult result_{};

    // One frame.
    LessonFrame frame_{};
    std::vector<LessonEvent> queued_;
    std::vector<std::string> sounds_;
    std::vector<std::int32_t> touched_bodies_;  // each once, by whichever hand
    double time_s_ = 0.0;
    double clock_s_ = 0.0;  // the loops'
};

}  // namespace fulcrum::runtime
