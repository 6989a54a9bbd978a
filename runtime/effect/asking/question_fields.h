// What a lesson says of a question, and of what learners may ask.
#pragma once

#include "runtime/effect/field_list.h"
#include "runtime/scene/description.h"

namespace fulcrum::runtime::fields {

using enum ParameterType;

inline constexpr std::tuple kExamples{
    field(&QuestionExamples::right, {"right", texts, "", 0, 0, "nil", "right in meaning and form"}),
    field(&QuestionExamples::wrong,
          {"wrong", texts, "", 0, 0, "nil", "understood, and wrong in meaning"}),
    field(&QuestionExamples::form,
          {"form", texts, "", 0, 0, "nil", "right in meaning, with an error of form"})};

inline constexpr std::tuple kAskedExamples{
    field(&KnowledgeExamples::right,
          {"right", texts, "", 0, 0, "nil", "ask for it in good English"}),
    field(&KnowledgeExamples::form,
          {"form", texts, "", 0, 0, "nil", "ask for it with an error of form"}),
    field(&KnowledgeExamples::other, {"other", texts, "", 0, 0, "nil", "do not ask for it"})};

inline constexpr auto kExampleRows = parameters_of(kExamples);
inline constexpr auto kAskedExampleRows = parameters_of(kAskedExamples);

inline constexpr std::tuple kQuestion{
    field(&QuestionDescription::id,
          {"name", name, "", 0, 0, kRequired, "what world:ask and game.ask call it"}),
    field(&QuestionDescription::prompt,
          {"prompt", text, "", 0, 1000, kRequired, "what the learner is asked"}),
    field(&QuestionDescription::answers,
          {"answers", texts, "", 0, 0, kRequired,
           "templates of the sentences that answer it; the first of several articles is the one "
           "that is said "
           "back: \"[a|an|the] {thing}\" gives \"An apple is …\", \"[the|a|an] {thing}\" gives "
           "\"The "
           "apple is …\""}),
    field(&QuestionDescription::nearly,
          {"nearly", texts, "", 0, 0, "nil",
           "templates of what learners say for them that is no good English: understood, and said "
           "back as the first answer with the same {slots}"}),
    field(&QuestionDescription::lists,
          {"lists", lists, "", 0, 0, "nil",
           "plain words that {name} in a template may stand for, with | between two ways to say "
           "one, such as { size = { \"big|large\", \"small\" } }; no [ ], ( ), { } or < >; {thing} "
           "and {other} are by default the "
           "nouns "
           "of all bodies of the scene, whether they move, are solid or neither; not of those with "
           "noun = \"\""}),
    field(&QuestionDescription::rules,
          {"rules", rules, "", 0, 0, "nil",
           "templates that <name> in a template stands for, such as { place = \"(on|under) the "
           "{thing}\" }; a rule may use another one, not itself"}),
    field(&QuestionDescription::again,
          {"again", text, "", 0, 200, "",
           "what is said after \"Not yet.\" when the meaning is wrong, such as \"Let's weigh both "
           "again.\"; \"Try again.\" by default"}),
    argument(
        {"right", function, "", 0, 0, kRequired,
         "function(answer): is the meaning right? see answer; ./fulcrum check calls it with what "
         "the "
         "answers can mean, when the question is asked"}),
    argument({"examples", record, "", 0, 0, "nil",
              "answers that are marked by ./fulcrum check and test, and must come out as said", "",
              kExampleRows.data(), kExampleRows.size()}),
    argument({"feedback", texts, "", 0, 0, "nil", "as the lesson's, for this question alone"})};

inline constexpr std::tuple kKnowledge{
    field(&KnowledgeDescription::id, {"name", name, "", 0, 0, kRequired, "what it is about"}),
    field(
        &KnowledgeDescription::asked,
        {"asked", texts, "", 0, 0, kRequired,
         "templates of the questions that ask for it, such as \"how heavy is (it|the {thing})\""}),
    field(&KnowledgeDescription::nearly,
          {"nearly", texts, "", 0, 0, "nil",
           "templates of what learners say for them that is no good English: understood, said "
           "back "
           "as the first of `asked` with the same {slots}, and answered"}),
    field(&KnowledgeDescription::lists,
          {"lists", lists, "", 0, 0, "nil",
           "as a question's; a name means the same in all of them; {material} is by default every "
           "material that the program or the lesson has, and some more"}),
    field(&KnowledgeDescription::rules, {"rules", rules, "", 0, 0, "nil", "likewise"}),
    argument(
        {"answer", function, "", 0, 0, kRequired,
         "function(asked, world): the answer as a text, or nil where that is not known; asked "
         "has the "
         "{slots}, and asked.bodies the bodies that they name; ./fulcrum check and test call it "
         "for each way to ask with each word of its lists"}),
    argument({"examples", record, "", 0, 0, "nil",
              "questions that are looked at by ./fulcrum check and test, and must come out as said",
              "", kAskedExampleRows.data(), kAskedExampleRows.size()})};

}  // namespace fulcrum::runtime::fields
