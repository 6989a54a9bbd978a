#include "dialogue/english/antonyms.h"
#include "dialogue/marking/answer_hints.h"
#include "dialogue/marking/grammar_point.h"
#include "dialogue/marking/mark_answer.h"
#include "dialogue/marking/mark_sentence.h"
#include "dialogue/marking/question_review.h"
#include "dialogue/marking/readings.h"
#include "dialogue/marking/reasons.h"
#include "dialogue/marking/said_spans.h"
#include "tests/unit/dialogue/rig.h"
#include "tests/unit/dialogue/table.h"
#include "tests/unit/dialogue/told_mark.h"

using namespace fulcrum::dialogue;

namespace {

Mark marked(TableScene& scene, const std::string& in) {
    return mark_answer(scene.question(), in);
}

/// What helps with the question: its frame, its choices, an example.
std::string asked(TableScene& scene, const std::string& in) {
    const Question& question = scene.question();
    return in == "frame"     ? sentence_frame(question)
           : in == "example" ? example_sentence(question)
                             : spaced(choices(question), ", ");
}

/// Not understood, and nothing told of it.
std::string nothing(TableScene& scene, const std::string& in) {
    const Mark mark = marked(scene, in);
    return mark.understood || !mark.slots.empty() || !mark.form_errors.empty() ||
                   !mark.corrected.empty()
               ? "something"
               : "nothing";
}

/// "[17, 27) more heavy -> heavier"; without a place where the short form of two words is put right.
std::string errors(TableScene& scene, const std::string& in) {
    std::vector<std::string> all;
    for (const FormError& error : marked(scene, in).form_errors) {
        CHECK(in.substr(error.begin, error.end - error.begin) == error.said);
        all.push_back("[" + std::to_string(error.begin) + ", " + std::to_string(error.end) + ") " +
                      error.said + " -> " + error.right);
    }
    return spaced(all, "; ");
}

/// "right", "wrong" or "?" where only the values behind the probe's name are right, and the errors of form.
std::string verdict(TableScene& scene, const std::string& in) {
    Mark mark = marked(scene, in);
    if (!mark.understood) {
        return "?";
    }
    std::vector<bool> verdicts;
    for (const Slots& reading : readings_of(mark)) {
        verdicts.push_back(std::ranges::any_of(reading, [&](const auto& slot) {
            return (", " + scene.with + ", ").find(", " + slot.second + ", ") != std::string::npos;
        }));
    }
    const std::string codes = codes_of(mark);
    return std::string(settle(mark, verdicts) ? "right" : "wrong") +
           (codes.empty() ? "" : " " + codes);
}

/// The errors that are left once the meaning was found right or wrong.
std::string left_over(TableScene& scene, const std::string& in) {
    Mark mark = marked(scene, in);
    REQUIRE(mark.understood);
    (void)settle(mark, std::vector<bool>(readings_of(mark).size(), scene.with == "right"));
    return codes_of(mark);
}

std::string points(TableScene& scene, const std::string& in) {
    std::vector<std::string> all;
    for (const FormError& error : marked(scene, in).form_errors) {
        all.emplace_back(grammar_point_id(grammar_point(error)));
    }
    return spaced(all);
}

std::string spans(TableScene& scene, const std::string& in) {
    std::vector<std::string> all;
    for (const SaidSpan& span : said_sentences(in, scene.with == "clauses")) {
        const std::string words =
            words_between_blanks(in.substr(span.begin, span.end - span.begin));
        all.push_back(words.substr(1, words.size() - 2));
    }
    return spaced(all, " | ");
}

/// What a review tells first, or of how much it tells.
std::string review(TableScene& scene, const std::string& in) {
    static const auto antonyms = Antonyms::open();
    REQUIRE(antonyms);
    const auto found =
        review_question(scene.question(), [](std::string_view word) { return antonyms->of(word); });
    return in == "count" ? std::to_string(found.size()) : found.empty() ? "" : found.front();
}

const std::map<std::string, Probe> kMarkingProbes{
    {"mark", probe_mark},
    {"match", probe_match},
    {"asked", asked},
    {"nothing", nothing},
    {"errors", errors},
    {"verdict", verdict},
    {"never_right",
     [](TableScene& scene, const std::string& in) {
         return yes_or_no(!verdict(scene, in).starts_with("right"));
     }},
    {"left_over", left_over},
    {"points", points},
    {"spans", spans},
    {"review", review},
    {"accepted",
     [](TableScene& scene, const std::string& in) {
         const Mark mark = marked(scene, in);
         return yes_or_no(mark.understood && mark.form_right());
     }},
    {"has",
     [](TableScene& scene, const std::string& in) {
         return yes_or_no(!marked(scene, in).slot(scene.with).empty());
     }},
    {"reasoned",
     [](TableScene& scene, const std::string& in) {
         const auto mark = mark_with_reason(scene.question(), mark_sentence(scene.question(), in));
         return std::string(mark && mark->claim == Claim::reasoned ? "reasoned" : "same");
     }},
    {"listed",
     [](TableScene&, const std::string& in) {
         const auto list = list_behind(in);
         return std::to_string(list ? list->items.size() : 0);
     }},
    {"compiles", [](TableScene& scene, const std::string&) {
         const auto question = compile_question(scene.source);
         return question ? std::string() : question.error().message;
     }}};

}  // namespace

TEST_CASE("marking: each answer has its meaning, its errors and its recast, as the tables say") {
    hold_tables("marking", kMarkingProbes);
}
