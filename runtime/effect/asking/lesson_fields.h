// What a lesson says of itself, and of how it is played in tests.
#pragma once

#include "runtime/effect/field_list.h"
#include "runtime/scene/description.h"
#include "runtime/scene/lesson_limits.h"

namespace fulcrum::runtime::fields {

using enum ParameterType;

inline constexpr std::tuple kLesson{
    field(&LessonDescription::id, {"id", name, "", 0, 0, kRequired, "short name, used in reports"}),
    field(&LessonDescription::title,
          {"title", text, "", 0, kMostTitleBytes, kRequired, "what the list of lessons shows"}),
    field(&LessonDescription::level, {"level", text, "", 0, kMostLevelBytes, "A1",
                                      "level of English: A1, A2, B1, B2, C1 or C2"}),
    field(&LessonDescription::minutes,
          {"minutes", number, "minutes", 0, kMostMinutes, "10", "how long it takes"}),
    field(&LessonDescription::icon,
          {"icon", name, "", 0, 0, "nil",
           "the model that its card shows; by default the first thing that can be held"}),
    field(
        &LessonDescription::order,
        {"order", integer, "", 0, 1000, "0",
         "where its card stands in the list of lessons; those without come last, by their names"}),
    argument({"force_limit", number, "newtons", kLeastForceLimit_N, kMostForceLimit_N, "nil",
              "no force in this lesson is larger; this place and the device may allow less"}),
    field(&LessonDescription::free_english,
          {"free_english", flag, "", 0, 0, "false",
           "what is said beside a question's answers is checked, and good English for it is "
           "shown"}),
    field(&LessonDescription::tries,
          {"tries", integer, "", 1, kMostTries, "4",
           "after so many answers of wrong meaning a question is left, and the lesson goes on; "
           "after "
           "six that are not understood it is left as well"}),
    field(&LessonDescription::sureness,
          {"sureness", number, "", 0, 1, "0.4",
           "what a recogniser of speech hears less surely is asked for again, and neither right "
           "nor "
           "wrong; ./fulcrum run LESSON --sure N says it for one play"}),
    argument(
        {"hands", integer, "", 1, static_cast<double>(kMostHands), "1",
         "how many hands or fingers it can use at once; each has a world:hand { … } of its own, "
         "and where fewer are there it is played with those"}),
    argument({"feedback", texts, "", 0, 0, "nil",
              "what is done about an error of form, by how often it has been made: the first time "
              "the first of these, and so on, from then on the last; \"recast\" (the right "
              "sentence), \"prompt\" (say it once more), \"rule\" (and why), \"replay\" (and "
              "feel it again); { \"recast\", \"prompt\", \"rule\" } by default"})};

inline constexpr std::tuple kRates{
    field(&LearnerRates::wrong, {"wrong", number, "", 0, 1, "0", "wrong in meaning"}),
    field(&LearnerRates::form,
          {"form", number, "", 0, 1, "0", "right in meaning, with an error of form"}),
    field(&LearnerRates::unclear, {"unclear", number, "", 0, 1, "0", "not to be understood"})};

inline constexpr auto kRateRows = parameters_of(kRates);

inline constexpr std::tuple kTest{
    field(
        &LessonTestDescription::hand,
        {"hand", text, "", 0, 48, "", "simulated hand: a Lua file beside the lesson, see motion"}),
    field(&LessonTestDescription::second_hand,
          {"second_hand", text, "", 0, 48, "",
           "likewise of the second hand; without it the lesson is played with one"}),
    field(&LessonTestDescription::say,
          {"say", texts, "", 0, 0, "nil", "what the simulated learner answers, in turn"}),
    argument(
        {"learner", record, "", 0, 0, "nil",
         "who answers instead of say: a simulated learner who knows what is right, and errs in "
         "such "
         "parts of the answers",
         "", kRateRows.data(), kRateRows.size()}),
    field(&LessonTestDescription::expect,
          {"expect", values, "", 0, 0, "nil", "how the lesson must end, see Tests"})};

}  // namespace fulcrum::runtime::fields
