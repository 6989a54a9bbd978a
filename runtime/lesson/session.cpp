#include "runtime/lesson/session.h"

#include "runtime/lesson/questions.h"
#include "runtime/progress/text_rules.h"

#include <algorithm>

namespace fulcrum::runtime {
namespace {

constexpr double kRepeatPatience_s = 12.0;  // an invitation to say it once more waits this long
constexpr std::size_t kLongestAnswer_bytes = 400;
constexpr double kForever_s = 1.0e12;

// Each kind of fruit sounds unlike another; what has no sound of its own makes the common one.
std::string catch_sound(const BodyDescription& body) {
    return "catch_" + body.model;
}

bool is_index(std::int32_t index, std::size_t size) {
    return index >= 0 && static_cast<std::size_t>(index) < size;
}

}  // namespace

LessonSession::LessonSession(LessonDescription description, const Plan& plan,
                             const dialogue::Catalogue& catalogue, ProgressStore& store)
    : description_(std::move(description)), store_(&store), conversation_(catalogue) {
    // Until the lesson says otherwise every declared force is on, where it was declared.
    for (std::size_t i = 0; i < description_.forces.size(); ++i) {
        force_.fields[i].anchor_W = description_.forces[i].field.anchor_W;
    }
    queued_.push_back(ReadyEvent{plan.felt_weight_N, plan.felt_scale});
}

Expected<std::unique_ptr<LessonSession>> LessonSession::create(
    LessonDescription description, const Plan& plan, const dialogue::Catalogue& catalogue,
    ProgressStore& store, LearnerId learner, std::string lesson_version) {
    auto questions = compile_questions(description);
    if (!questions) {
        return tl::unexpected(questions.error());
    }
    std::unique_ptr<LessonSession> session(
        new LessonSession(std::move(description), plan, catalogue, store));
    session->questions_ = std::move(*questions);
    session->record_.id = random_record_id();
    session->record_.learner = std::move(learner);
    session->record_.lesson = session->description_.id;
    session->record_.lesson_version = std::move(lesson_version);
    session->record_.level = session->description_.level;
    session->record_.started_utc_ms = utc_now_ms();
    session->record_.settings = {{"force_limit_N", std::to_string(plan.haptic.safety.max_force_N)},
                                 {"felt_scale", std::to_string(plan.felt_scale)}};
    session->keep([&] { return store.begin_session(session->record_); });
    return session;
}

const LessonFrame& LessonSession::begin_frame(const SessionInput& input) {
    time_s_ = input.time_s;
    frame_.time_s = input.time_s;
    frame_.dt_s = input.dt_s;
    frame_.tool_pose_W = input.hand.tool_pose_W;
    frame_.tool_twist_W = input.hand.tool_twist_W;
    frame_.applied_force_W = input.hand.applied_W.force;
    if (input.world != nullptr) {
        frame_.bodies.assign(input.world->bodies.begin(),
                             input.world->bodies.begin() + input.world->n_bodies);
    } else {
        frame_.bodies.clear();
        for (const BodyDescription& body : description_.bodies) {
            frame_.bodies.push_back({Pose::at(body.position_W), Vector3::Zero(),
                                     body.visible ? BodyWhere::placed : BodyWhere::hidden});
        }
    }

    end_invitation();
    queue_world_events(input.world_events);
    queue_touch_events(input.hand.touched_body);
    for (const std::string& key : input.keys) {
        queued_.push_back(KeyEvent{key});
    }
    if (input.heard) {
        hear(*input.heard);
    }
    frame_.events = std::move(queued_);
    queued_.clear();
    return frame_;
}

void LessonSession::queue_world_events(const std::vector<WorldEvent>& events) {
    for (const WorldEvent& event : events) {
        const bool caught = event.kind == WorldEvent::Kind::caught;
        const BodyDescription& body = description_.bodies[static_cast<std::size_t>(event.body)];
        queued_.push_back(BodyEvent{caught ? BodyEvent::Kind::caught : BodyEvent::Kind::landed,
                                    event.body, event.speed_m_per_s});
        sounds_.push_back(caught ? catch_sound(body) : "landed");
        result_.caught += caught ? 1 : 0;
    }
}

void LessonSession::queue_touch_events(std::int32_t touched_body) {
    if (touched_body == touched_body_) {
        return;
    }
    if (touched_body_ != kNoBody) {
        queued_.push_back(BodyEvent{BodyEvent::Kind::released, touched_body_, 0.0});
    }
    if (touched_body != kNoBody) {
        queued_.push_back(BodyEvent{BodyEvent::Kind::touched, touched_body, 0.0});
    }
    touched_body_ = touched_body;
}

// Words count only while a question is open; the simulated physics then says whether their meaning
// is right.
void LessonSession::hear(const std::string& said) {
    if (!hud_.question_open || awaiting_verdict_) {
        return;
    }
    // Whatever a keyboard or a file gives: clean UTF-8 of a sentence's length.
    std::string words = kept_text(said);
    if (words.size() > kLongestAnswer_bytes) {
        words = kept_text(std::string_view(words).substr(0, kLongestAnswer_bytes));
    }
    dialogue::Mark mark = conversation_.hear(words);
    if (!mark.understood) {
        awaiting_verdict_ = std::move(mark);
        answer(false);
        return;
    }
    queued_.push_back(JudgeEvent{open_question_, mark.slots});
    awaiting_verdict_ = std::move(mark);
}

// The verdict is there: say something that helps, keep the attempt, tell the lesson.
void LessonSession::answer(bool right) {
    const dialogue::Mark mark = std::move(*awaiting_verdict_);
    awaiting_verdict_.reset();
    const dialogue::Feedback feedback = conversation_.respond(mark, right);
    hud_.feedback = feedback.text;
    sounds_.push_back(right ? "right" : "try_again");
    keep_attempt(mark, feedback.attempt, right);

    // Not understood, or invited to say it once more: the question simply stays open.
    const bool same_words_again = !mark.understood && feedback.ask_again;
    if (same_words_again || feedback.may_repeat) {
        open_question(open_question_);
        hud_.invited = feedback.may_repeat;
        repeat_until_s_ = feedback.may_repeat ? time_s_ + kRepeatPatience_s : kForever_s;
        pending_answer_ = feedback.may_repeat ? std::optional(answered_event(mark, right, feedback))
                                              : std::nullopt;
        return;
    }
    queued_.push_back(pending_answer_ ? *pending_answer_ : answered_event(mark, right, feedback));
    pending_answer_.reset();
    hud_.question_open = hud_.invited = false;
    if (!feedback.ask_again) {
        close_question();
    }
}

AnsweredEvent LessonSession::answered_event(const dialogue::Mark& mark, bool right,
                                            const dialogue::Feedback& feedback) const {
    AnsweredEvent answered;
    answered.question = open_question_;
    answered.said = mark.said;
    answered.slots = mark.slots;
    answered.understood = mark.understood;
    answered.right = right;
    answered.form_right = mark.understood && mark.form_right();
    answered.over = !feedback.ask_again;
    answered.attempt = feedback.attempt;
    return answered;
}

// Nobody is held back for form: an invitation to say it once more ends by itself.
void LessonSession::end_invitation() {
    if (pending_answer_ && time_s_ >= repeat_until_s_ && !awaiting_verdict_) {
        queued_.push_back(*pending_answer_);
        pending_answer_.reset();
        close_question();
    }
}

void LessonSession::open_question(const std::string& id) {
    open_question_ = id;
    hud_.question_open = true;
    hud_.invited = false;
    hud_.question_asked_at_s = time_s_;
}

void LessonSession::close_question() {
    hud_.question_open = hud_.invited = false;
    open_question_.clear();
}

void LessonSession::keep_attempt(const dialogue::Mark& mark, int attempt_number, bool right) {
    ++result_.attempts;
    result_.form_errors += static_cast<int>(mark.form_errors.size());
    AttemptRecord attempt;
    attempt.id = random_record_id();
    attempt.session = record_.id;
    attempt.question = open_question_;
    attempt.attempt = attempt_number;
    attempt.said = mark.said;
    attempt.understood = mark.understood;
    attempt.meaning_right = right;
    attempt.form_right = mark.understood && mark.form_right();
    for (const auto& [name, value] : mark.slots) {
        attempt.slots.append(attempt.slots.empty() ? "" : " ")
            .append(name)
            .append("=")
            .append(value);
    }
    attempt.answer_s = std::max(0.0, time_s_ - hud_.question_asked_at_s);
    attempt.said_utc_ms = utc_now_ms();
    for (const dialogue::FormError& error : mark.form_errors) {
        attempt.errors.push_back({std::string(error.errant()), error.said, error.right});
    }
    keep([&] { return store_->add_attempt(attempt); });
}

// A write whose outcome is unknown may be repeated: it carries its own id.
void LessonSession::keep(const std::function<Expected<void>()>& write) {
    Expected<void> written = write();
    if (!written) {
        written = write();
    }
    if (!written && store_trouble_.empty()) {
        store_trouble_ = to_sentence(written.error());
    }
}

void LessonSession::end(EndReason reason) {
    if (ended_) {
        return;
    }
    ended_ = true;
    const SessionEnd end{record_.id, utc_now_ms(),           reason, std::max(hud_.stars, 0),
                         hud_.score, std::max(hud_.level, 1)};
    keep([&] { return store_->end_session(end); });
}

Expected<SessionOutput> LessonSession::finish_frame(const LessonReply& reply) {
    SessionOutput output;
    for (const LessonCommand& command : reply.commands) {
        const bool known = std::visit([&](const auto& c) { return carry_out(c, output); }, command);
        if (!known) {
            return fail("the lesson named something that it never declared", "lesson.lua",
                        "use the bodies, forces and questions that L:start and L:question made");
        }
    }
    force_.stamp_s = time_s_;
    force_.lesson_alive = true;
    output.force = force_;
    output.sounds = std::move(sounds_);
    sounds_.clear();
    if (reply.has_hand_target) {
        output.hand_target_W = reply.hand_target_W;
        output.hand_buttons = reply.hand_buttons;
        output.has_hand_target = true;
    }
    return output;
}

bool LessonSession::carry_out(const MoveCommand& command, SessionOutput& output) {
    const bool needs_body = command.move.kind != WorldCommand::Kind::release;
    if (needs_body && !is_index(command.move.body, description_.bodies.size())) {
        return false;
    }
    if (command.move.kind == WorldCommand::Kind::drop) {
        sounds_.push_back("pop");
    } else if (command.move.kind == WorldCommand::Kind::hold) {
        sounds_.push_back(
            catch_sound(description_.bodies[static_cast<std::size_t>(command.move.body)]));
    }
    output.world.push_back(command.move);
    return true;
}

bool LessonSession::carry_out(const FieldChangeCommand& command, SessionOutput&) {
    if (!is_index(command.force, description_.forces.size())) {
        return false;
    }
    force_.fields[static_cast<std::size_t>(command.force)] = command.field;
    return true;
}

bool LessonSession::carry_out(const LessonForceCommand& command, SessionOutput&) {
    if (!description_.hand.lesson_force) {
        return false;
    }
    force_.linearised = command.force;
    force_.linearised.stamp_s = time_s_;
    return true;
}

bool LessonSession::carry_out(const CaptionCommand& command, SessionOutput&) {
    hud_.caption = command.text;
    hud_.feedback.clear();
    return true;
}

bool LessonSession::carry_out(const AskCommand& command, SessionOutput&) {
    const auto question = questions_.find(command.question);
    if (question == questions_.end()) {
        return false;
    }
    // The same question, asked again after it was felt again, goes on where it was.
    const bool goes_on = command.question == open_question_ && !hud_.question_open;
    const std::vector<std::string> prompt =
        goes_on ? conversation_.prompt_again() : conversation_.ask(question->second);
    hud_.caption.clear();
    for (const std::string& line : prompt) {
        hud_.caption += (hud_.caption.empty() ? "" : "\n") + line;
    }
    hud_.feedback.clear();
    pending_answer_.reset();
    open_question(command.question);
    return true;
}

bool LessonSession::carry_out(const VerdictCommand& command, SessionOutput&) {
    if (!awaiting_verdict_ || command.question != open_question_) {
        return false;
    }
    answer(command.right);
    return true;
}

bool LessonSession::carry_out(const ScoreCommand& command, SessionOutput&) {
    hud_.score = result_.score = command.score;
    return true;
}

bool LessonSession::carry_out(const LevelCommand& command, SessionOutput&) {
    if (hud_.level > 0 && command.level > hud_.level) {
        sounds_.push_back("level_up");
    }
    hud_.level = result_.level = command.level;
    hud_.level_title = command.title;
    return true;
}

bool LessonSession::carry_out(const SoundCommand& command, SessionOutput&) {
    sounds_.push_back(command.name);
    return true;
}

bool LessonSession::carry_out(const FinishCommand& command, SessionOutput&) {
    hud_.stars = result_.stars = std::clamp(command.stars, 0, 3);
    result_.finished = true;
    close_question();
    sounds_.push_back("finish");
    end(EndReason::finished);
    return true;
}

bool LessonSession::carry_out(const PrintCommand& command, SessionOutput& output) {
    output.printed.push_back(command.text);
    return true;
}

}  // namespace fulcrum::runtime
