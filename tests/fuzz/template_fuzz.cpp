// A template and an utterance, both from anyone: the first half of the input is the template, the second the utterance.
// Further lines of the first half are rules <r1>, <r2>, ….
#include "dialogue/catalogue.h"
#include "dialogue/marking/answer_hints.h"
#include "dialogue/marking/mark_answer.h"
#include "dialogue/template/matcher.h"
#include "tests/fuzz/promise.h"

using namespace fulcrum::dialogue;

namespace {

QuestionSource source_of(std::string_view text) {
    QuestionSource source;
    source.id = "fuzz";
    source.prompt = "What?";
    source.lists = {
        {"thing", {"watermelon", "an egg", "water", "scissors", "the Moon", "bike|bicycle"}},
        {"number", {"2", "21"}},
        {"material", {"metal", "rock", "glass|crystal"}},
        {"feel", {"hard", "sticky", "grey"}}};
    const std::size_t end = text.find('\n');
    source.answers = {std::string(text.substr(0, end))};
    for (int i = 1; end != std::string_view::npos && i < 8; ++i) {
        const std::size_t start = text.find('\n');
        if (start == std::string_view::npos) {
            break;
        }
        text.remove_prefix(start + 1);
        source.rules.emplace_back("r" + std::to_string(i),
                                  std::string(text.substr(0, text.find('\n'))));
    }
    return source;
}

void check_errors(const Mark& mark) {
    for (const FormError& error : mark.form_errors) {
        require(error.code != ErrorCode::none);
        require(error.begin <= error.end && error.end <= mark.said.size());
    }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const std::string_view text(reinterpret_cast<const char*>(data), size);
    const std::string_view first = text.substr(0, size / 2);
    const std::string_view second = text.substr(size / 2);
    (void)Catalogue::parse(first);
    const auto question = compile_question(source_of(first));
    if (!question) {
        require(!question.error().message.empty());
        require(question.error().column >= 0 &&
                question.error().column <= static_cast<int>(size) + 1);
        return 0;
    }
    MatchWork work;
    (void)match(*question->templates, second, &work);
    require(work.steps <= kLargestGraph_arcs * (kMostWords + 1));
    const Mark mark = mark_answer(*question, second);
    require(mark.understood || (mark.slots.empty() && mark.form_errors.empty()));
    check_errors(mark);
    // A number that no list has fills no slot, so nothing is said back.
    const bool names_slots = mark.understood && mark.other_number.empty();
    require(names_slots || mark.corrected.empty());
    // What is said back is understood, without an error.
    if (names_slots && mark.corrected.size() <= kLongestUtterance_bytes) {
        const Mark again = mark_answer(*question, mark.corrected);
        require(again.understood && again.form_right());
    }
    (void)sentence_frame(*question);
    (void)choices(*question);
    return 0;
}
