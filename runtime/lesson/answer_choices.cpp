#include "runtime/lesson/answer_choices.h"

#include "dialogue/english/letters.h"
#include "dialogue/english/opposite.h"
#include "dialogue/marking/mark_answer.h"
#include "dialogue/template/sentences.h"
#include "dialogue/template/tokens.h"

#include <algorithm>
#include <cstdint>
#include <optional>
#include <utility>

namespace fulcrum::runtime {
namespace {

constexpr std::uint64_t kFirst = 0xcbf29ce484222325ULL;
constexpr std::uint64_t kFactor = 0x100000001b3ULL;

using Words = std::vector<std::string>;

// FNV-1a of the question's name (G. Fowler, L. Noll, K.-P. Vo 1991), stepped on at each draw: the same question, the same choices.
class Draws {
  public:
    explicit Draws(const std::string& name) {
        for (const char letter : name) {
            mix(static_cast<unsigned char>(letter));
        }
    }
    template <class Value>
    void shuffle(std::vector<Value>& values) {
        for (std::size_t i = values.size(); i > 1; --i) {
            std::swap(values[i - 1], values[draw(i)]);
        }
    }

  private:
    std::size_t draw(std::size_t n) {
        mix(++count_ & 0xFFU);
        return static_cast<std::size_t>((state_ >> 24U) % n);
    }
    void mix(std::uint64_t byte) { state_ = (state_ ^ byte) * kFactor; }
    std::uint64_t state_ = kFirst;
    std::uint64_t count_ = 0;
};

bool has(const Words& words, const std::string& word) {
    return std::ranges::find(words, word) != words.end();
}

/// "The egg is heavier than the egg.", "metal is soft and hard".
bool is_nonsense(const AnswerSlots& slots) {
    for (std::size_t i = 0; i < slots.size(); ++i) {
        const auto opposites = dialogue::opposites_of(slots[i].second);
        for (std::size_t j = 0; j < i; ++j) {
            if (slots[i].second == slots[j].second ||
                std::ranges::find(opposites, slots[j].second) != opposites.end()) {
                return true;
            }
        }
    }
    return false;
}

bool has_meaning(const std::vector<AnswerChoice>& choices, const AnswerSlots& meaning) {
    return std::ranges::find(choices, meaning, &AnswerChoice::meaning) != choices.end();
}

// The words that a question's sentences may be made with here, and the sentences.
class Maker {
  public:
    Maker(const dialogue::Question& question, const Verdict& verdict, const Words& seen)
        : question_(question), set_(*question.templates), verdict_(verdict), seen_(seen) {
        for (const dialogue::WordList& list : set_.lists) {
            offered_.push_back(words_in_play(list));
        }
    }

    /// What an answer's sentence says with these words, where it is good sense, and right or wrong by the lesson; nothing of what was met.
    Expected<std::optional<AnswerChoice>> make(int answer, const AnswerSlots& slots) {
        if (is_nonsense(slots)) {
            return std::nullopt;
        }
        std::string said = dialogue::render(dialogue::canonical_pieces(set_, answer, slots));
        const dialogue::Mark mark = dialogue::mark_answer(question_, said);
        if (!mark.understood || mark.claim != dialogue::Claim::same || !mark.form_right() ||
            is_nonsense(mark.slots) || walks_++ >= kMostChoiceWalks) {
            return std::nullopt;
        }
        return verdict_(mark.slots).map([&](bool right) {
            return std::optional(AnswerChoice{std::move(said), right, mark.slots});
        });
    }

    /// The first right one of an answer, its words in the order of their lists.
    Expected<std::optional<AnswerChoice>> find_right(int answer) {
        const std::vector<std::size_t> filled = slots_of(answer);
        std::vector<std::size_t> at(filled.size(), 0);
        while (walks_ < kMostChoiceWalks) {
            AnswerSlots slots;
            for (std::size_t i = 0; i < filled.size(); ++i) {
                slots.emplace_back(set_.slots[filled[i]], offered(filled[i])[at[i]]);
            }
            auto made = make(answer, slots);
            if (!made || (*made && (*made)->right)) {
                return made;
            }
            // The last word goes on first.
            std::size_t i = filled.size();
            while (i > 0 && ++at[i - 1] == offered(filled[i - 1]).size()) {
                at[--i] = 0;
            }
            if (i == 0) {
                break;
            }
        }
        return std::nullopt;
    }

    /// Wrong ones that are a right one but for one word, or with two words in each other's places: of each kind in turn, each meaning once.
    /// `right`: right ones.
    Expected<std::vector<AnswerChoice>> find_near(int answer, const AnswerChoice& one, Draws& draws,
                                                  bool right = false) {
        std::vector<std::vector<AnswerSlots>> kinds;
        for (std::size_t i = 0; i < one.meaning.size(); ++i) {
            std::vector<AnswerSlots> kind;
            for (const std::string& word : words_instead(one.meaning[i])) {
                kind.push_back(one.meaning);
                kind.back()[i].second = word;
            }
            draws.shuffle(kind);
            kinds.push_back(std::move(kind));
            for (std::size_t j = 0; j < i; ++j) {
                AnswerSlots turned = one.meaning;
                std::swap(turned[i].second, turned[j].second);
                kinds.push_back({std::move(turned)});
            }
        }
        draws.shuffle(kinds);
        std::vector<AnswerChoice> found;
        for (std::size_t n = 0;
             std::ranges::any_of(kinds, [n](const auto& kind) { return n < kind.size(); }); ++n) {
            for (const auto& kind : kinds) {
                if (n >= kind.size() || found.size() + 1 >= kMostChoices) {
                    continue;
                }
                auto made = make(answer, kind[n]);
                if (!made) {
                    return tl::unexpected(made.error());
                }
                if (*made && (*made)->right == right && (*made)->meaning == kind[n] &&
                    !has_meaning(found, kind[n])) {
                    found.push_back(std::move(**made));
                }
            }
        }
        return found;
    }

    /// Wrong ones of any answer, where the right one's own sentence has none.
    Expected<std::vector<AnswerChoice>> find_others(Draws& draws) {
        std::vector<std::pair<int, AnswerSlots>> ways;
        for (int answer = 0; answer < set_.answers; ++answer) {
            for (const std::size_t slot : slots_of(answer)) {
                for (const std::string& word : offered(slot)) {
                    ways.emplace_back(answer, AnswerSlots{{set_.slots[slot], word}});
                }
            }
        }
        draws.shuffle(ways);
        std::vector<AnswerChoice> found;
        for (std::size_t i = 0; i < ways.size() && found.size() + 1 < kMostChoices; ++i) {
            auto made = make(ways[i].first, ways[i].second);
            if (!made) {
                return tl::unexpected(made.error());
            }
            if (*made && !(*made)->right && !has_meaning(found, (*made)->meaning)) {
                found.push_back(std::move(**made));
            }
        }
        return found;
    }

    [[nodiscard]] int n_answers() const { return set_.answers; }

  private:
    /// The two where the question asks between two; of a list that names several things that are seen, these alone.
    [[nodiscard]] Words words_in_play(const dialogue::WordList& list) const {
        Words asked = dialogue::asked_between(question_, list);
        if (!asked.empty()) {
            return asked;
        }
        Words all;
        Words there;
        for (const dialogue::ListItem& item : list.items) {
            all.push_back(item.value);
            if (has(seen_, item.value)) {
                there.push_back(item.value);
            }
        }
        return there.size() > 1 ? there : all;
    }
    [[nodiscard]] const Words& offered(std::size_t slot) const {
        return offered_[static_cast<std::size_t>(set_.slot_lists[slot])];
    }
    [[nodiscard]] std::vector<std::size_t> slots_of(int answer) const {
        const std::uint32_t filled = set_.graphs[static_cast<std::size_t>(answer)].slots;
        std::vector<std::size_t> slots;
        for (std::size_t slot = 0; slot < set_.slots.size(); ++slot) {
            if ((filled & (1U << slot)) != 0) {
                slots.push_back(slot);
            }
        }
        return slots;
    }
    /// What may stand for a word of the right answer; nothing where the question itself says it: "metal" of "What is metal like?".
    [[nodiscard]] Words words_instead(const std::pair<std::string, std::string>& filled) const {
        const auto slot = std::ranges::find(set_.slots, filled.first);
        if (slot == set_.slots.end()) {
            return {};
        }
        Words words = offered(static_cast<std::size_t>(slot - set_.slots.begin()));
        const std::string prompt = dialogue::words_between_blanks(question_.prompt);
        const auto is_named = [&](const std::string& word) {
            return prompt.find(dialogue::words_between_blanks(word)) != std::string::npos;
        };
        if (std::ranges::count_if(words, is_named) == 1) {
            if (is_named(filled.second)) {
                return {};
            }
            // "Where is the box now?": on no box.
            std::erase_if(
                words, [&](const std::string& word) { return is_named(word) && has(seen_, word); });
        }
        std::erase(words, filled.second);
        return words;
    }

    const dialogue::Question& question_;
    const dialogue::TemplateSet& set_;
    const Verdict& verdict_;
    const Words& seen_;
    std::vector<Words> offered_;  // by list
    int walks_ = 0;               // what the lesson was asked for
};

}  // namespace

Expected<std::vector<AnswerChoice>> make_choices(const dialogue::Question& question,
                                                 const Verdict& verdict,
                                                 const std::vector<std::string>& seen) {
    Draws draws(question.id);
    Maker maker(question, verdict, seen);
    std::optional<AnswerChoice> right;
    std::vector<AnswerChoice> choices;
    // The first answer is the one that is taught; another one where it says nothing right, or nothing wrong beside it.
    for (int answer = 0; answer < maker.n_answers() && choices.empty(); ++answer) {
        auto found = maker.find_right(answer);
        if (!found) {
            return tl::unexpected(found.error());
        }
        if (!*found) {
            continue;
        }
        auto near = maker.find_near(answer, **found, draws);
        if (!near) {
            return tl::unexpected(near.error());
        }
        if (!right || !near->empty()) {
            right = std::move(*found);
        }
        choices = std::move(*near);
    }
    if (choices.empty()) {
        auto others = maker.find_others(draws);
        // "Now you ask me!": nothing is wrong, and each of them may be asked.
        if (others && others->empty() && right) {
            others = maker.find_near(0, *right, draws, true);
        }
        if (!others) {
            return tl::unexpected(others.error());
        }
        choices = std::move(*others);
    }
    if (right) {
        choices.push_back(std::move(*right));
    }
    draws.shuffle(choices);
    return choices;
}

}  // namespace fulcrum::runtime
