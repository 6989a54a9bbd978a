#include "dialogue/marking/mark.h"

#include "dialogue/english/letters.h"
#include "dialogue/marking/near_miss.h"
#include "dialogue/template/matcher.h"
#include "dialogue/template/sentences.h"

#include <algorithm>

namespace fulcrum::dialogue {
namespace {

/// Which of several errors matters most to a learner: the smaller the number, the more.
int importance(const FormError& error) {
    if (error.target) {
        return 0;
    }
    switch (error.code) {
        case ErrorCode::missing_determiner:
        case ErrorCode::wrong_determiner:
        case ErrorCode::extra_determiner:
            return 2;
        case ErrorCode::spelling:
        case ErrorCode::orthography:
            return 3;
        default:
            return 1;
    }
}

/// The article of a taught form belongs to it: "watermelon is heaviest" misses the superlative's "the".
bool belongs_to_target(const std::vector<Piece>& pieces, int at) {
    const PieceRange phrase = phrase_around(pieces, at);
    return std::any_of(pieces.begin() + phrase.first, pieces.begin() + phrase.last,
                       [](const Piece& piece) { return piece.element.target; });
}

FormError error_of(const std::vector<Piece>& pieces, int at) {
    const Piece& piece = pieces[static_cast<std::size_t>(at)];
    FormError error;
    error.code = piece.code;
    error.said = piece.said;
    error.begin = piece.begin;
    error.end = piece.end;
    error.right = piece.right;
    error.phrase = render_phrase(
        pieces, piece.element.passive ? passive_around(pieces, at) : phrase_around(pieces, at));
    error.base = piece.element.base;
    error.role = piece.element.role;
    error.degree = piece.element.degree;
    error.target = piece.element.target || belongs_to_target(pieces, at);
    error.passive = piece.element.passive;
    if (error.code == ErrorCode::orthography && !piece.short_form.empty()) {
        error.right = error.phrase = piece.short_form;
    }
    return error;
}

/// The phrase around a piece, with the verb where both were written as one: "its".
PieceRange phrase_of(const std::vector<Piece>& pieces, int at) {
    PieceRange range = phrase_around(pieces, at);
    if (pieces[static_cast<std::size_t>(at)].goes_on) {
        while (range.last < static_cast<int>(pieces.size()) &&
               pieces[static_cast<std::size_t>(range.last - 1)].element.role != Role::verb) {
            ++range.last;
        }
    }
    return range;
}

/// The phrase of a short answer, found again in its whole sentence: the one with the same slot.
PieceRange same_phrase(const std::vector<Piece>& whole, int slot) {
    for (int i = 0; i < static_cast<int>(whole.size()); ++i) {
        if (whole[static_cast<std::size_t>(i)].element.slot == slot) {
            return phrase_around(whole, i);
        }
    }
    return {};
}

/// The same for piece `at`: by its slot or its phrase's, or the last slot before it ("hard [and] smooth").
PieceRange same_phrase(const std::vector<Piece>& whole, const std::vector<Piece>& part, int at) {
    const PieceRange phrase = phrase_around(part, at);
    const auto slot_of = [&](int i) { return part[static_cast<std::size_t>(i)].element.slot; };
    const auto same_role = std::find_if(whole.begin(), whole.end(), [&](const Piece& piece) {
        return piece.element.role == part[static_cast<std::size_t>(at)].element.role;
    });
    if (part[static_cast<std::size_t>(at)].element.role == Role::conjunction &&
        same_role != whole.end()) {
        return phrase_around(whole, static_cast<int>(same_role - whole.begin()));
    }
    for (int i = phrase.last - 1; i >= 0; --i) {
        if (slot_of(i) != kNone) {
            return same_phrase(whole, slot_of(i));
        }
    }
    return same_phrase(whole, slot_of(static_cast<int>(part.size()) - 1));
}

/// The whole right sentence; a short answer is completed.
void write_sentences(const TemplateSet& set, const Parse& parse, int main_piece, Mark& mark) {
    const Graph& graph = set.graphs[static_cast<std::size_t>(parse.graph)];
    std::vector<Piece> pieces = parse.pieces;
    PieceRange range = main_piece == kNone ? PieceRange{} : phrase_of(pieces, main_piece);
    if (!graph.whole_sentence || (main_piece == kNone && parse.leaves_out)) {
        pieces = canonical_pieces(set, graph.answer, parse.slots);
        range = main_piece == kNone ? PieceRange{} : same_phrase(pieces, parse.pieces, main_piece);
    }
    mark.corrected = render(pieces);
    mark.emphasised = main_piece == kNone ? mark.corrected : render(pieces, range);
    mark.gapped = main_piece == kNone ? mark.corrected : render(pieces, range, true);
    mark.emphasis = render_phrase(pieces, range);
}

/// An answer of other words than English has for it: the whole sentence is put right.
void mark_wording(const TemplateSet& set, const Parse& parse, std::string_view text, Mark& mark) {
    const Graph& graph = set.graphs[static_cast<std::size_t>(parse.graph)];
    const std::vector<Piece> pieces = canonical_pieces(set, graph.answer, parse.slots);
    mark.corrected = mark.gapped = render(pieces);
    mark.emphasis = render_phrase(pieces, {0, static_cast<int>(pieces.size())});
    mark.emphasised = render(pieces, {0, static_cast<int>(pieces.size())});
    FormError error;
    error.code = ErrorCode::wording;
    error.said = std::string(text);
    error.end = text.size();
    error.right = error.phrase = mark.emphasis;
    error.target = true;
    mark.form_errors.push_back(std::move(error));
}

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

}  // namespace

bool Mark::target_right() const {
    return form_known && std::none_of(form_errors.begin(), form_errors.end(),
                                      [](const FormError& error) { return error.target; });
}

int Mark::other_errors() const {
    return static_cast<int>(std::count_if(form_errors.begin(), form_errors.end(),
                                          [](const FormError& error) { return !error.target; }));
}

const FormError* Mark::main_error() const {
    // An adjective's own form before its article, and "hardly" before "smoth".
    const auto rank = [](const FormError& error) {
        return importance(error) * 4 + (error.role == Role::determiner ? 2 : 0) +
               (error.code == ErrorCode::spelling ? 1 : 0);
    };
    const auto found =
        std::min_element(form_errors.begin(), form_errors.end(),
                         [&](const FormError& a, const FormError& b) { return rank(a) < rank(b); });
    return found == form_errors.end() ? nullptr : &*found;
}

std::string_view Mark::slot(std::string_view name) const {
    const auto found = std::find_if(slots.begin(), slots.end(),
                                    [&](const auto& slot) { return slot.first == name; });
    return found == slots.end() ? std::string_view{} : std::string_view(found->second);
}

Mark mark_answer(const Question& question, std::string_view text, double confidence) {
    Mark mark;
    mark.said = std::string(text.substr(0, kLongestUtterance_bytes));
    mark.confidence = confidence;
    const TemplateSet& set = *question.templates;
    const auto parse = match(set, text);
    if (!parse) {
        find_near_miss(set, text, mark);
        return mark;
    }
    mark.understood = true;
    const Graph& graph = set.graphs[static_cast<std::size_t>(parse->graph)];
    mark.short_answer = graph.short_answer || parse->leaves_out;
    mark.turned_round = graph.turned_round;
    mark.answer = graph.answer;
    mark.slots = parse->slots;
    if (graph.nearly) {
        mark_wording(set, *parse, text, mark);
        return mark;
    }
    std::vector<int> places;
    for (int i = 0; i < static_cast<int>(parse->pieces.size()); ++i) {
        if (parse->pieces[static_cast<std::size_t>(i)].code != ErrorCode::none) {
            mark.form_errors.push_back(error_of(parse->pieces, i));
            places.push_back(i);
        }
    }
    const FormError* main = mark.main_error();
    const int main_piece =
        main == nullptr ? kNone : places[static_cast<std::size_t>(main - mark.form_errors.data())];
    write_sentences(set, *parse, main_piece, mark);
    return mark;
}

std::string example_sentence(const Question& question) {
    return render(canonical_pieces(*question.templates, 0, {}));
}

std::string sentence_frame(const Question& question) {
    const TemplateSet& set = *question.templates;
    std::vector<Piece> pieces = canonical_pieces(set, 0, {});
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
        if (pieces[static_cast<std::size_t>(i)].element.slot != kNone) {
            const PieceRange phrase = phrase_around(pieces, i);
            for (int j = phrase.first; j < phrase.last; ++j) {
                pieces[static_cast<std::size_t>(j)].right = j + 1 == phrase.last ? "…" : "";
            }
        }
    }
    // Two words that are wanted side by side are one gap.
    const auto is_gap = [](const Piece& piece) { return piece.right == "…"; };
    bool behind_gap = false;
    for (Piece& piece : pieces) {
        if (is_gap(piece) && behind_gap) {
            piece.right.clear();
        }
        behind_gap = is_gap(piece) || (behind_gap && piece.right.empty());
    }
    return render(pieces);
}

Mark without_form(Mark mark) {
    mark.form_known = false;
    mark.form_errors.clear();
    mark.emphasised = mark.corrected;
    mark.emphasis.clear();
    mark.gapped.clear();
    return mark;
}

std::vector<std::string> choices(const Question& question) {
    const TemplateSet& set = *question.templates;
    std::vector<std::string> result;
    for (std::size_t slot = 0; slot < set.slots.size(); ++slot) {
        const auto& items = set.lists[static_cast<std::size_t>(set.slot_lists[slot])].items;
        if (items.size() < 2) {
            continue;  // nothing to choose from
        }
        for (const ListItem& item : items) {
            const std::vector<Piece> pieces =
                canonical_pieces(set, 0, {{set.slots[slot], item.value}});
            const std::string phrase =
                render_phrase(pieces, same_phrase(pieces, static_cast<int>(slot)));
            if (!phrase.empty() &&
                std::find(result.begin(), result.end(), phrase) == result.end()) {
                result.push_back(phrase);
            }
        }
    }
    return result;
}

}  // namespace fulcrum::dialogue
