#include "runtime/lesson/answer_choices.h"

#include "dialogue/marking/mark_answer.h"
#include "dialogue/template/sentences.h"

#include <algorithm>
#include <cstdint>
#include <set>

namespace fulcrum::runtime {
namespace {

constexpr std::uint64_t kFirst = 0xcbf29ce484222325ULL;
constexpr std::uint64_t kFactor = 0x100000001b3ULL;

// FNV-1a of the question's name (G. Fowler, L. Noll, K.-P. Vo 1991), stepped on at each draw: the same question, the same choices.
class Draws {
  public:
    explicit Draws(const std::string& name) {
        for (const char letter : name) {
            mix(static_cast<unsigned char>(letter));
        }
    }
    std::size_t operator()(std::size_t n) {
        mix(++count_ & 0xFFU);
        return static_cast<std::size_t>((state_ >> 24U) % n);
    }

  private:
    void mix(std::uint64_t byte) { state_ = (state_ ^ byte) * kFactor; }
    std::uint64_t state_ = kFirst;
    std::uint64_t count_ = 0;
};

// A right sentence of any of the question's answers, as a recast has it.
std::string draw_sentence(const dialogue::TemplateSet& set, Draws& draw) {
    const auto graph = static_cast<int>(draw(static_cast<std::size_t>(set.answers)));
    const dialogue::Sample sample =
        dialogue::walk(set, graph, false, [&](std::size_t n) { return draw(n); });
    return dialogue::render(dialogue::canonical_pieces(set, graph, sample.slots));
}

// "The egg is heavier than the egg."
bool says_twice(const AnswerSlots& slots) {
    std::set<std::string> words;
    return !std::ranges::all_of(slots,
                                [&](const auto& slot) { return words.insert(slot.second).second; });
}

}  // namespace

Expected<std::vector<AnswerChoice>> make_choices(const dialogue::Question& question,
                                                 const Verdict& verdict) {
    Draws draw(question.id);
    std::vector<AnswerChoice> choices;
    std::set<AnswerSlots> met;
    std::set<std::string> said_before;
    bool has_right = false;
    const auto is_full = [&] {
        return choices.size() >= (has_right ? kMostChoices : kMostChoices - 1);
    };
    for (int i = 0; i < kMostChoiceWalks && !(has_right && is_full()); ++i) {
        const std::string said = draw_sentence(*question.templates, draw);
        if (!said_before.insert(said).second) {
            continue;
        }
        const dialogue::Mark mark = dialogue::mark_answer(question, said);
        if (!mark.understood || mark.claim != dialogue::Claim::same || !mark.form_right() ||
            says_twice(mark.slots) || !met.insert(mark.slots).second) {
            continue;
        }
        const auto right = verdict(mark.slots);
        if (!right) {
            return tl::unexpected(right.error());
        }
        // One that is right, and as many others as there is room for.
        if (*right ? !has_right : !is_full()) {
            choices.push_back({said, *right, mark.slots});
            has_right |= *right;
        }
    }
    for (std::size_t i = choices.size(); i > 1; --i) {
        std::swap(choices[i - 1], choices[draw(i)]);
    }
    return choices;
}

}  // namespace fulcrum::runtime
