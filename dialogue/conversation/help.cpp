#include "dialogue/conversation/help.h"

#include "dialogue/marking/answer_hints.h"
#include "dialogue/template/phrases.h"
#include "dialogue/template/sentences.h"

#include <algorithm>
#include <utility>

namespace fulcrum::dialogue {
namespace {

constexpr std::size_t kMostListed = 12;  // choices that somebody can listen to

/// The phrase of the slot's word in the first answer that has it, with what makes a place of it: "far", "at the end"; empty where it is half of
/// something.
std::string phrase_of(const TemplateSet& set, int slot, const std::string& value) {
    for (int answer = 0; answer < static_cast<int>(set.graphs.size()); ++answer) {
        const std::vector<Piece> pieces =
            canonical_pieces(set, answer, {{set.slots[static_cast<std::size_t>(slot)], value}});
        for (int i = 0; i < static_cast<int>(pieces.size()); ++i) {
            const Piece& piece = pieces[static_cast<std::size_t>(i)];
            if (piece.element.slot != slot) {
                continue;
            }
            PieceRange phrase = phrase_around(pieces, i);
            // "The farther" is half of "the farther, the easier".
            if (piece.element.degree == Degree::comparative && phrase.first < i) {
                return {};
            }
            const bool is_place =
                phrase.first > 0 &&
                is_preposition(pieces[static_cast<std::size_t>(phrase.first - 1)].right);
            phrase.first -= is_place ? 1 : 0;
            return render_phrase(pieces, phrase);
        }
    }
    return {};
}

/// What each of the answers says for its slots, each once; nothing where they leave no choice either.
std::vector<std::string> choices_apart(const Question& question) {
    const TemplateSet& set = *question.templates;
    std::vector<std::string> result;
    for (int slot = 0; slot < static_cast<int>(set.slots.size()); ++slot) {
        const auto list = static_cast<std::size_t>(set.slot_lists[static_cast<std::size_t>(slot)]);
        for (const ListItem& item : set.lists[list].items) {
            std::string phrase = phrase_of(set, slot, item.value);
            if (!phrase.empty() &&
                std::find(result.begin(), result.end(), phrase) == result.end()) {
                result.push_back(std::move(phrase));
            }
        }
    }
    return result.size() > 1 ? result : std::vector<std::string>{};
}

/// The first answer has a word that may be another one in other answers.
bool first_has_slot(const TemplateSet& set) {
    const std::vector<Piece> pieces = canonical_pieces(set, 0, {});
    return std::any_of(pieces.begin(), pieces.end(),
                       [](const Piece& piece) { return piece.element.slot >= 0; });
}

}  // namespace

Help help_for(const Question& question, int rung) {
    const std::string example = example_sentence(question);
    std::vector<std::string> named = choices(question);
    const bool stands_apart =
        named.empty() && !example.ends_with('?') && first_has_slot(*question.templates);
    if (stands_apart) {
        named = choices_apart(question);
    }
    if (stands_apart && !named.empty()) {
        return {Help::Kind::choices, {}, std::move(named)};
    }
    const std::string frame = sentence_frame(question);
    if (!frame.empty() && (rung == 2 || named.size() > kMostListed)) {
        return {Help::Kind::frame, frame, {}};
    }
    if (example.ends_with('?') || named.empty()) {
        return {Help::Kind::example, example, {}};
    }
    return {Help::Kind::choices, {}, std::move(named)};
}

}  // namespace fulcrum::dialogue
