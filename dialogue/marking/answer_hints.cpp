#include "dialogue/marking/answer_hints.h"

#include "dialogue/english/letters.h"
#include "dialogue/template/sentences.h"
#include "dialogue/template/tokens.h"

#include <algorithm>
#include <utility>

namespace fulcrum::dialogue {
namespace {

/// The last word of each slot that the first answer needs.
std::vector<std::pair<std::string, std::string>> last_words(const TemplateSet& set) {
    std::vector<std::pair<std::string, std::string>> words;
    for (std::size_t slot = 0; slot < set.slots.size(); ++slot) {
        if ((set.graphs[0].required & (1U << slot)) != 0) {
            const WordList& list = set.lists[static_cast<std::size_t>(set.slot_lists[slot])];
            words.emplace_back(set.slots[slot], list.items.back().value);
        }
    }
    return words;
}

/// The words of the first answer's slots that the question itself says: "metal" of "What is metal like?"; none of a slot of which it says two, and
/// none that another slot has: in "the ball is next to the {other}" that is another thing.
std::vector<std::pair<std::string, std::string>> words_of_prompt(const Question& question) {
    const TemplateSet& set = *question.templates;
    const std::string prompt = words_between_blanks(question.prompt);
    std::vector<std::pair<std::string, std::string>> words;
    for (std::size_t slot = 0; slot < set.slots.size(); ++slot) {
        std::vector<std::string> said;
        for (const ListItem& item :
             set.lists[static_cast<std::size_t>(set.slot_lists[slot])].items) {
            if (prompt.find(" " + lower_case(item.value) + " ") != std::string::npos) {
                said.push_back(item.value);
            }
        }
        const bool is_taken = said.size() == 1 && std::ranges::any_of(words, [&](const auto& word) {
                                  return word.second == said.front();
                              });
        if ((set.graphs[0].required & (1U << slot)) != 0 && said.size() == 1 && !is_taken) {
            words.emplace_back(set.slots[slot], said.front());
        }
    }
    return words;
}

/// "… is …": nothing in it helps.
bool says_only_is(const std::vector<Piece>& pieces) {
    return std::none_of(pieces.begin(), pieces.end(), [](const Piece& piece) {
        return piece.element.slot == kNone && piece.element.role != Role::determiner &&
               piece.element.role != Role::verb && !piece.right.empty();
    });
}

/// Of a phrase "…" alone; with `keeps_the` also its "the", which gives no noun away.
void leave_gap(PieceRange phrase, bool keeps_the, std::vector<Piece>& pieces) {
    for (int i = phrase.first; i < phrase.last; ++i) {
        std::string& right = pieces[static_cast<std::size_t>(i)].right;
        if (i + 1 == phrase.last) {
            right = "…";
        } else if (!keeps_the || right != "the") {
            right.clear();
        }
    }
}

/// Two words that are wanted side by side are one gap, with the "the" between them: "it is … " for "it is on the egg".
void join_gaps(std::vector<Piece>& pieces) {
    Piece* the = nullptr;  // behind a gap
    bool behind_gap = false;
    for (Piece& piece : pieces) {
        if (behind_gap && piece.right == "the" && the == nullptr) {
            the = &piece;
            continue;
        }
        const bool is_gap = piece.right == "…";
        if (is_gap && behind_gap) {
            piece.right.clear();
            if (the != nullptr) {
                the->right.clear();
            }
        }
        behind_gap = is_gap || (behind_gap && piece.right.empty());
        the = behind_gap && !is_gap ? the : nullptr;
    }
}

/// Adds what the first answer can say for `slot`, each once.
void add_choices(const TemplateSet& set, std::size_t slot, std::vector<std::string>& result) {
    for (const ListItem& item : set.lists[static_cast<std::size_t>(set.slot_lists[slot])].items) {
        const std::vector<Piece> pieces = canonical_pieces(set, 0, {{set.slots[slot], item.value}});
        const std::string phrase =
            render_phrase(pieces, phrase_of_slot(pieces, static_cast<int>(slot)));
        if (!phrase.empty() && std::find(result.begin(), result.end(), phrase) == result.end()) {
            result.push_back(phrase);
        }
    }
}

}  // namespace

std::string example_sentence(const Question& question) {
    return render(canonical_pieces(*question.templates, 0, {}));
}

std::string sentence_frame(const Question& question) {
    const TemplateSet& set = *question.templates;
    std::vector<Piece> pieces = canonical_pieces(set, 0, {});
    const bool is_bare = says_only_is(pieces);
    const auto known =
        is_bare ? words_of_prompt(question) : std::vector<std::pair<std::string, std::string>>{};
    if (!known.empty()) {
        pieces = canonical_pieces(set, 0, known);
    }
    const auto is_known = [&](const Piece& piece) {
        return std::any_of(known.begin(), known.end(), [&](const auto& word) {
            return word.first == set.slots[static_cast<std::size_t>(piece.element.slot)];
        });
    };
    const bool counts = std::any_of(pieces.begin(), pieces.end(), [](const Piece& piece) {
        return piece.element.role == Role::noun && !piece.element.base.empty();
    });
    if (counts) {  // "… eggs", though the list of numbers begins with one
        pieces = canonical_pieces(set, 0, last_words(set));
    }
    const bool says_words = std::any_of(pieces.begin(), pieces.end(), [](const Piece& piece) {
        return piece.element.slot == kNone && piece.element.role != Role::determiner;
    });
    if (!says_words) {
        return {};
    }
    for (int i = 0; i < static_cast<int>(pieces.size()); ++i) {
        const Piece& piece = pieces[static_cast<std::size_t>(i)];
        if (piece.element.slot != kNone && !is_known(piece)) {
            leave_gap(phrase_around(pieces, i), is_bare, pieces);
        }
    }
    join_gaps(pieces);
    return render(pieces);
}

std::vector<std::string> choices(const Question& question) {
    const TemplateSet& set = *question.templates;
    const auto known = words_of_prompt(question);
    std::vector<std::string> all;
    std::vector<std::string> asked;  // without the slots whose word the question says
    for (std::size_t slot = 0; slot < set.slots.size(); ++slot) {
        if (set.lists[static_cast<std::size_t>(set.slot_lists[slot])].items.size() < 2) {
            continue;  // nothing to choose from
        }
        const bool is_known = std::any_of(known.begin(), known.end(), [&](const auto& word) {
            return word.first == set.slots[slot];
        });
        add_choices(set, slot, all);
        if (!is_known) {
            add_choices(set, slot, asked);
        }
    }
    return asked.size() > 1 ? asked : all;
}

}  // namespace fulcrum::dialogue
