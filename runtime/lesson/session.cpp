#include "runtime/lesson/session.h"

#include "runtime/lesson/better_form.h"
#include "runtime/lesson/free_english.h"
#include "runtime/lesson/learner_throat.h"
#include "runtime/lesson/questions.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

namespace fulcrum::runtime {
namespace {

constexpr const char* kSureness = "sureness";  // the session's setting

// Who stands beside the learner knows better how sure one must be to have heard than the lesson does.
dialogue::ConversationSettings settings_of(const LessonDescription& lesson, const Plan& plan) {
    dialogue::ConversationSettings settings;
    settings.tries = lesson.tries;
    settings.level = lesson.level;
    settings.least_confidence = plan.hearing.sureness.value_or(lesson.sureness);
    return settings;
}

}  // namespace

LessonSession::LessonSession(LessonDescription description, const Plan& plan,
                             const dialogue::Catalogue& catalogue, QuestionDialogue dialogue,
                             SessionLog log, std::optional<Knowledge> knowledge, KnownAtFirst known)
    : description_(std::move(description)),
      catalogue_(&catalogue),
      dialogue_(std::move(dialogue)),
      knowledge_(std::move(knowledge)),
      told_about_(description_.bodies.size(), false),
      log_(std::move(log)),
      speech_(Speech::build(plan)),
      talk_(Talk::build(plan, catalogue)),
      hinges_(description_),
      kite_(description_) {
    // Until the lesson says otherwise every declared force is on, where it was declared.
    for (std::size_t i = 0; i < description_.forces.size(); ++i) {
        force_.fields[i].anchor_W = description_.forces[i].field.anchor_W;
    }
    hud_.covered.resize(description_.bodies.size(), false);
    hud_.marked_N.resize(description_.bodies.size(), 0.0);
    hud_.lights.resize(description_.bodies.size(), BodyLight::off);
    hud_.kite = kite_.seen();
    ReadyEvent ready{plan.felt_weight_N, plan.felt_scale,       {},
                     plan.day,           std::move(known.past), std::move(known.lessons)};
    for (const MaterialFacts& facts : plan.material_facts) {
        ready.materials.push_back(
            {facts.hardness, facts.roughness, facts.slipperiness, facts.stiffness_N_per_m});
    }
    queued_.push_back(std::move(ready));
}

Expected<std::unique_ptr<LessonSession>> LessonSession::create(
    LessonDescription description, const Plan& plan, const dialogue::Catalogue& catalogue,
    ProgressStore& store, LearnerId learner, std::string lesson_version, KnownAtFirst known) {
    auto questions = compile_questions(description);
    if (!questions) {
        return tl::unexpected(questions.error());
    }
    const dialogue::ConversationSettings settings = settings_of(description, plan);
    QuestionDialogue dialogue(std::move(*questions), catalogue, settings);
    if (plan.free_english) {
        // A lesson in real time must not wait for a dictionary between two frames.
        auto check = open_free_english(
            things_of(description),
            plan.live ? dialogue::GrammarOpens::at_once : dialogue::GrammarOpens::for_a_sentence);
        if (!check) {
            return tl::unexpected(check.error());
        }
        dialogue.set_form_check(std::move(*check));
    }
    auto knowledge = Knowledge::compile(description, catalogue);
    if (!knowledge) {
        return tl::unexpected(knowledge.error());
    }
    SessionRecord record;
    record.id = random_record_id();
    record.learner = std::move(learner);
    record.lesson = description.id;
    record.lesson_version = std::move(lesson_version);
    record.level = description.level;
    record.started_utc_ms = utc_now_ms();
    record.settings = {{"force_limit_N", std::to_string(plan.haptic.safety.max_force_N)},
                       {"felt_scale", std::to_string(plan.felt_scale)}};
    if (plan.recogniser) {
        record.settings.emplace_back(kSureness, std::to_string(settings.least_confidence));
    }
    if (plan.recogniser && plan.hearing.throat > 0.0) {
        record.settings.emplace_back(kThroat, throat_text(plan.hearing.throat));
    }
    SessionLog log(store, std::move(record), !description.is_room);
    return std::unique_ptr<LessonSession>(
        new LessonSession(std::move(description), plan, catalogue, std::move(dialogue),
                          std::move(log), std::move(*knowledge), std::move(known)));
}

const LessonFrame& LessonSession::begin_frame(const SessionInput& input) {
    time_s_ = input.time_s;
    clock_s_ = input.clock_s;
    frame_.time_s = input.time_s;
    frame_.dt_s = input.dt_s;
    frame_.tool_pose_W = input.hand.tool_pose_W;
    frame_.tool_twist_W = input.hand.tool_twist_W;
    frame_.buttons = input.hand.buttons;
    frame_.applied_W = input.hand.applied_W;
    frame_.more_hands.clear();
    for (const HapticState& hand : input.more_hands) {
        frame_.more_hands.push_back(
            {hand.tool_pose_W, hand.tool_twist_W, hand.applied_W, hand.buttons});
    }
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

    std::erase_if(hud_.bursts, [&](const SessionHud::Burst& burst) {
        return time_s_ - burst.at_s >= kBurstLasts_s;
    });
    hinges_.take(input, frame_);
    kite_.take(input, frame_);

    log_.look_for_trouble();
    speech_.step(input.dt_s);
    say_back();
    take(dialogue_.step(time_s_));
    queue_world_events(input.world_events);
    queue_touch_events(input);
    for (const std::string& key : input.keys) {
        queued_.push_back(KeyEvent{key});
    }
    if (input.heard) {
        speech_.type(*input.heard);
    }
    if (const auto heard = speech_.poll()) {
        hear(*heard);
    }
    frame_.events = std::move(queued_);
    queued_.clear();
    return frame_;
}

void LessonSession::queue_world_events(const std::vector<WorldEvent>& events) {
    for (const WorldEvent& event : events) {
        const bool caught = event.kind == WorldEvent::Kind::caught;
        queued_.push_back(BodyEvent{caught ? BodyEvent::Kind::caught : BodyEvent::Kind::landed,
                                    event.body, event.speed_m_per_s});
        sounds_.push_back(caught ? catch_sound(event.body) : "landed");
        result_.caught += caught ? 1 : 0;
        if (caught) {
            if (const auto i = static_cast<std::size_t>(event.body); i < frame_.bodies.size()) {
                burst(frame_.bodies[i].pose_W.position);
            }
            tell_about(event.body);
        }
    }
}

// A body is touched from the first hand that comes to it until the last one leaves.
void LessonSession::queue_touch_events(const SessionInput& input) {
    std::vector<std::int32_t> touched;
    const auto add = [&](std::int32_t body) {
        if (body != kNoBody && std::ranges::find(touched, body) == touched.end()) {
            touched.push_back(body);
        }
    };
    add(input.hand.touched_body);
    for (const HapticState& hand : input.more_hands) {
        add(hand.touched_body);
    }
    for (const std::int32_t body : touched_bodies_) {
        if (std::ranges::find(touched, body) == touched.end()) {
            queued_.push_back(BodyEvent{BodyEvent::Kind::released, body, 0.0});
        }
    }
    for (const std::int32_t body : touched) {
        if (std::ranges::find(touched_bodies_, body) == touched_bodies_.end()) {
            queued_.push_back(BodyEvent{BodyEvent::Kind::touched, body, 0.0});
            tell_about(body);
        }
    }
    touched_bodies_ = std::move(touched);
}

// Each kind of fruit sounds unlike another; what has no sound of its own makes the common one.
std::string LessonSession::catch_sound(std::int32_t body) const {
    return "catch_" + description_.bodies[static_cast<std::size_t>(body)].model;
}

// For the words at the end.
void LessonSession::count(const MarkedAnswer& answer) {
    if (answer.feedback.attempt == 1) {
        ++result_.questions;
        result_.right_at_first += answer.right ? 1 : 0;
    }
    const auto practise = [&](const std::string& right) {
        std::vector<std::string>& known = result_.to_practise;
        if (!right.empty() && std::ranges::find(known, right) == known.end()) {
            known.push_back(right);
        }
    };
    for (const dialogue::FormError& error : answer.mark.form_errors) {
        // "The" alone says nothing; "the heaviest" does.
        practise(error.phrase.empty() ? error.right : error.phrase);
    }
    for (const dialogue::FreeError& error : answer.feedback.free_errors) {
        practise(error.right);
    }
}

// What the dialogue came to: the lesson is told, and the learner hears, sees and is kept.
void LessonSession::take(QuestionTurn turn) {
    std::move(turn.events.begin(), turn.events.end(), std::back_inserter(queued_));
    if (turn.answer) {
        transcript_.hear(time_s_, *turn.answer);
        keep_said(*turn.answer);
        // Praise for a question is said together with its answer.
        if (!asked_for_) {
            talk_.take(*turn.answer);
        } else if (talk_.is_own()) {
            transcript_.reply(time_s_, {asked_for_->praise, {}}, false);
        }
        say_back();
    }
    // What was not heard well is no attempt.
    if (turn.answer && turn.answer->feedback.kind != dialogue::FeedbackKind::heard_badly) {
        const MarkedAnswer& answer = *turn.answer;
        sounds_.push_back(answer.right ? "right" : "try_again");
        hud_.mood = answer.right ? ViewMood::happy : ViewMood::thoughtful;
        if (answer.right) {
            burst(frame_.tool_pose_W.position);
        }
        ++result_.attempts;
        result_.form_errors +=
            static_cast<int>(answer.mark.form_errors.size() + answer.feedback.free_errors.size());
        count(answer);
        log_.keep_attempt(answer);
    }
    show();
}

// What was said stands beside the sentence that is told for it.
void LessonSession::keep_said(const MarkedAnswer& answer) {
    using Kind = dialogue::FeedbackKind;
    keep_said(answer.mark.said);
    const Kind kind = answer.feedback.kind;
    const bool is_told = answer.accepted ? kind != Kind::praise
                         : answer.has_more
                             ? !answer.joined.empty()
                             : kind == Kind::recast || kind == Kind::rule || kind == Kind::replay;
    if (is_told) {
        hud_.told = answer.accepted         ? answer.accepted->emphasised
                    : answer.joined.empty() ? answer.mark.emphasised
                                            : answer.joined;
        std::string right = hud_.told;
        std::erase(right, '*');
        hud_.better = emphasise_changes(answer.mark.said, right);
    }
}

void LessonSession::keep_said(std::string said) {
    hud_.said = std::move(said);
    hud_.better.clear();
    hud_.told.clear();
}

// The partner's words, as they come.
void LessonSession::say_back() {
    while (const auto said = talk_.poll(time_s_)) {
        if (!said->reply.text.empty()) {
            speech_.reply(said->reply.text);
        }
        transcript_.reply(time_s_, said->reply, said->was_asked);
    }
}

void LessonSession::burst(const Vector3& at_W) {
    hud_.bursts.push_back({at_W, time_s_});
}

void LessonSession::show() {
    hud_.caption = speech_.instruction();
    hud_.feedback = speech_.last_reply();
    hud_.question_open = dialogue_.is_open();
    hud_.knows = knowledge_.has_value();
    hud_.may_ask = knowledge_.has_value() && !dialogue_.is_open();
    hud_.invited = dialogue_.is_invited();
    hud_.question_asked_at_s = dialogue_.asked_at_s();
}

// The recogniser listens while the learner may speak, and anew each time that they are asked to.
Expected<void> LessonSession::keep_listening() {
    if (!dialogue_.listens()) {
        return keep_listening_for_asking();
    }
    if (speech_.listening() && turn_ == dialogue_.turns() && !listens_for_asking_) {
        return {};
    }
    turn_ = dialogue_.turns();
    listens_for_asking_ = false;
    // Who is to ask may ask for anything that is known.
    return speech_.listen(knowledge_ && dialogue_.wants_question() ? knowledge_->templates()
                                                                   : dialogue_.templates());
}

// Between questions a learner may ask, where the lesson knows anything.
Expected<void> LessonSession::keep_listening_for_asking() {
    const bool may_ask = knowledge_ && !dialogue_.is_open() && !asked_for_;
    if (!may_ask) {
        listens_for_asking_ = false;
        speech_.stop_listening();
        return {};
    }
    if (speech_.listening() && listens_for_asking_) {
        return {};
    }
    listens_for_asking_ = true;
    return speech_.listen_for_asking(knowledge_->templates());
}

void LessonSession::end(EndReason reason) {
    // What was found of the learner's throat, for the next time.
    if (const double throat = speech_.throat(); throat > 0.0 && !ended_) {
        log_.keep_setting(kThroatHeard, throat_text(throat));
    }
    ended_ = true;
    log_.keep_end(reason, hud_.stars, hud_.score, hud_.level);
}

Expected<SessionOutput> LessonSession::finish_frame(const LessonReply& reply) {
    SessionOutput output;
    for (const LessonCommand& command : reply.commands) {
        const auto done = std::visit([&](const auto& c) { return carry_out(c, output); }, command);
        if (!done) {
            return tl::unexpected(done.error());
        }
    }
    dialogue_.end_exchange();
    show();
    if (auto listening = keep_listening(); !listening) {
        return tl::unexpected(listening.error());
    }
    force_.stamp_s = clock_s_;
    force_.lesson_alive = true;
    output.force = force_;
    hinges_.order(output);
    kite_.order(output);
    hud_.kite = kite_.seen();
    output.spoken = speech_.take_spoken();
    for (std::string& trouble : speech_.take_troubles()) {
        output.printed.push_back(std::move(trouble));
    }
    for (std::string& trouble : talk_.take_troubles()) {
        output.printed.push_back(std::move(trouble));
    }
    output.said = transcript_.take();
    output.notes = talk_.take_notes();
    output.sounds = std::move(sounds_);
    sounds_.clear();
    if (reply.has_hand_target) {
        output.hand_target_W = reply.hand_target_W;
        output.hand_buttons = reply.hand_buttons;
        output.has_hand_target = true;
    }
    output.more_aims = reply.more_aims;
    // As in a window: while a question is open, keys are letters of its answer.
    if (!dialogue_.is_open()) {
        output.hand_key = reply.hand_key;
    }
    return output;
}

}  // namespace fulcrum::runtime
