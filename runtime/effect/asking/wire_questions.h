// Layout and limits of questions, tests, and what a learner has answered before.
#pragma once

#include "dialogue/marking/feedback_ladder.h"
#include "runtime/effect/asking/lesson_fields.h"
#include "runtime/effect/asking/question_fields.h"
#include "runtime/effect/surface/wire_surface.h"
#include "runtime/lua/wire/wire_archive.h"

namespace fulcrum::runtime::wire {

/// What an answer's sentence was filled with: a slot is called as its template says, which is as long as a text.
template <class Archive, class Slots>
void slots(Archive& a, Slots& values) {
    a.list("slots", values, kMaxListItems, [](auto& each, auto& value) {
        each.text("a slot's name", value.first, kMaxTextBytes);
        each.text("a slot", value.second, kMaxTextBytes);
    });
}

/// Steps of feedback on form; none is the usual ladder.
template <class Archive, class Ladder>
void ladder(Archive& a, Ladder& steps) {
    a.list("steps of feedback", steps, dialogue::kLongestLadder, [](auto& each, auto& step) {
        each.choice("a step of feedback", step, dialogue::FeedbackStep::replay);
    });
}

template <class Archive, class Question>
void question(Archive& a, Question& q) {
    fields(a, "a question", fields::kQuestion, q);
    fields(a, "an example", fields::kExamples, q.examples);
    ladder(a, q.feedback);
    a.integer("a line", q.line, 0, kMaxLine);
}

template <class Archive, class Knowledge>
void knowledge(Archive& a, Knowledge& k) {
    fields(a, "what is known", fields::kKnowledge, k);
    fields(a, "an example", fields::kAskedExamples, k.examples);
    a.integer("a line", k.line, 0, kMaxLine);
}

template <class Archive, class Test>
void test(Archive& a, Test& t) {
    fields(a, "a test", fields::kTest, t);
    if constexpr (Archive::kReads) {
        for (const std::string_view file : {t.hand, t.second_hand}) {
            if (!file.empty() && !is_hand_file_name(file)) {
                a.refuse("a test's hand", "is not the name of a Lua file beside the lesson");
            }
        }
    }
    optional(a, "a test's learner", t.learner,
             [](auto& each, auto& rates) { fields(each, "a learner", fields::kRates, rates); });
    a.integer("a line", t.line, 0, kMaxLine);
}

template <class Archive, class Past>
void past_answers(Archive& a, Past& p) {
    constexpr std::int64_t kMany = 1'000'000'000;
    a.text("a lesson of the past", p.lesson, kMaxTextBytes);
    a.text("a question of the past", p.question, kMaxTextBytes);
    a.integer("times asked", p.asked, 0, kMany);
    a.integer("times right", p.right, 0, kMany);
    a.integer("answers not right", p.wrong_now, 0, kMany);
    a.number("days", p.days, 0.0, 1e6);
    a.list("grammar points", p.points, kMaxListItems, [](auto& each, auto& point) {
        each.text("a grammar point", point.first, kMaxTextBytes);
        each.integer("errors", point.second, 0, kMany);
    });
}

}  // namespace fulcrum::runtime::wire
