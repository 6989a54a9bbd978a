// Layout and limits of questions, tests, and what a learner has answered before.
#pragma once

#include "dialogue/marking/feedback_ladder.h"
#include "runtime/lua/wire/wire_archive.h"
#include "runtime/lua/wire/wire_surface.h"

namespace fulcrum::runtime::wire {

template <class Archive, class Texts>
void texts(Archive& a, const char* what, Texts& values) {
    a.list(what, values, kMaxListItems,
           [what](auto& each, auto& value) { each.text(what, value, kMaxTextBytes); });
}

template <class Archive, class Pairs>
void pairs(Archive& a, const char* what, Pairs& values) {
    a.list(what, values, kMaxListItems, [what](auto& each, auto& value) {
        each.text(what, value.first, kMaxNameBytes);
        each.text(what, value.second, kMaxTextBytes);
    });
}

/// What an answer's sentence was filled with: a slot is called as its template says, which is as long as a text.
template <class Archive, class Slots>
void slots(Archive& a, Slots& values) {
    a.list("slots", values, kMaxListItems, [](auto& each, auto& value) {
        each.text("a slot's name", value.first, kMaxTextBytes);
        each.text("a slot", value.second, kMaxTextBytes);
    });
}

template <class Archive, class Lists>
void lists(Archive& a, Lists& values) {
    a.list("lists", values, kMaxListItems, [](auto& each, auto& value) {
        each.name("a list's name", value.first);
        texts(each, "a list", value.second);
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
    a.name("a question's name", q.id);
    a.text("a prompt", q.prompt, kMaxTextBytes);
    texts(a, "answers", q.answers);
    texts(a, "what is nearly an answer", q.nearly);
    lists(a, q.lists);
    a.text("what is said after a wrong meaning", q.again, kMaxTextBytes);
    a.integer("a line", q.line, 0, kMaxLine);
    texts(a, "examples that are right", q.examples.right);
    texts(a, "examples that are wrong", q.examples.wrong);
    texts(a, "examples of a wrong form", q.examples.form);
    ladder(a, q.feedback);
    pairs(a, "rules", q.rules);
}

template <class Archive, class Knowledge>
void knowledge(Archive& a, Knowledge& k) {
    a.name("the name of what is known", k.id);
    texts(a, "ways to ask", k.asked);
    lists(a, k.lists);
    a.integer("a line", k.line, 0, kMaxLine);
    texts(a, "what nearly asks", k.nearly);
    texts(a, "examples that ask rightly", k.examples.right);
    texts(a, "examples that ask with an error", k.examples.form);
    texts(a, "examples that do not ask", k.examples.other);
    pairs(a, "rules", k.rules);
}

/// The hand of a test is a file beside the lesson: "name.lua", nothing that leads elsewhere.
template <class Archive, class Test>
void test(Archive& a, Test& t) {
    a.text("a test's hand", t.hand, kMaxNameBytes);
    a.text("a test's second hand", t.second_hand, kMaxNameBytes);
    if constexpr (Archive::kReads) {
        for (const std::string_view file : {t.hand, t.second_hand}) {
            if (!file.empty() &&
                !(file.ends_with(".lua") && is_name(file.substr(0, file.size() - 4)))) {
                a.refuse("a test's hand", "is not the name of a Lua file beside the lesson");
            }
        }
    }
    texts(a, "a test's lines", t.say);
    pairs(a, "a test's expectations", t.expect);
    optional(a, "a test's learner", t.learner, [](auto& each, auto& rates) {
        each.number("wrong answers", rates.wrong, 0.0, 1.0);
        each.number("errors of form", rates.form, 0.0, 1.0);
        each.number("unclear answers", rates.unclear, 0.0, 1.0);
    });
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
