#include "dialogue/marking/mark_sentence.h"

#include "dialogue/marking/near_miss.h"
#include "dialogue/marking/other_degree.h"
#include "dialogue/marking/readings.h"
#include "dialogue/marking/said_spans.h"
#include "dialogue/marking/wording.h"
#include "dialogue/template/matcher.h"
#include "dialogue/template/resolve_articles.h"
#include "dialogue/template/sentences.h"

#include <algorithm>
#include <string>
#include <vector>

namespace fulcrum::dialogue {
namespace {

/// The article of a taught form belongs to it: "watermelon is heaviest" misses the superlative's "the".
bool belongs_to_target(const std::vector<Piece>& pieces, int at) {
    const PieceRange phrase = phrase_around(pieces, at);
    return std::any_of(pieces.begin() + phrase.first, pieces.begin() + phrase.last,
                       [](const Piece& piece) { return piece.element.target; });
}

/// What an error at `at` is shown in: of a verb out of its place, what it belongs before.
PieceRange shown_around(const std::vector<Piece>& pieces, int at) {
    const Piece& piece = pieces[static_cast<std::size_t>(at)];
    if (piece.element.passive) {
        return passive_around(pieces, at);
    }
    PieceRange range = phrase_around(pieces, at);
    const int next = after(pieces, at);
    if (piece.code == ErrorCode::word_order && next != kNone) {
        range.last = phrase_around(pieces, next).last;
    }
    return range;
}

FormError error_of(const std::vector<Piece>& pieces, int at) {
    const Piece& piece = pieces[static_cast<std::size_t>(at)];
    FormError error;
    error.code = piece.code;
    error.said = piece.said;
    error.begin = piece.begin;
    error.end = piece.end;
    error.right = piece.right;
    error.phrase = render_phrase(pieces, shown_around(pieces, at));
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

/// The phrase of piece `at` of a short answer, found again in its whole sentence: by its slot or its phrase's, or the last slot before it ("hard [and] smooth").
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
    // "Ramps" of "three ramps" is no slot, and the same word there.
    const Element& word = part[static_cast<std::size_t>(at)].element;
    for (int i = 0; word.role == Role::noun && word.slot == kNone && !word.base.empty() &&
                    i < static_cast<int>(whole.size());
         ++i) {
        const Element& other = whole[static_cast<std::size_t>(i)].element;
        if (other.role == Role::noun && other.slot == kNone && other.base == word.base) {
            return phrase_around(whole, i);
        }
    }
    for (int i = phrase.last - 1; i >= 0; --i) {
        if (slot_of(i) != kNone) {
            return phrase_of_slot(whole, slot_of(i));
        }
    }
    return phrase_of_slot(whole, slot_of(static_cast<int>(part.size()) - 1));
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

/// "Mars? It has two moons.": behind a sentence's end a pronoun is a subject of its own.
void allow_new_sentence(std::string_view text, std::vector<Piece>& pieces) {
    std::size_t last = 0;
    for (Piece& piece : pieces) {
        const std::string_view between = text.substr(last, std::max(piece.begin, last) - last);
        if (piece.code == ErrorCode::extra_pronoun && has_sentence_end(between)) {
            piece.code = ErrorCode::none;
            piece.cost = 0;
        }
        last = std::max(last, piece.said.empty() ? last : piece.end);
    }
}

}  // namespace

Mark mark_sentence(const Question& question, std::string_view text, double confidence) {
    Mark mark;
    mark.said = std::string(text.substr(0, kLongestUtterance_bytes));
    mark.confidence = confidence;
    const TemplateSet& set = *question.templates;
    auto parse = match(set, text);
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
    find_readings(question, graph, mark);
    mark.unread_begin = parse->unread;
    mark.unread = mark.said.substr(parse->unread);
    if (graph.nearly) {
        mark_wording(set, *parse, mark);
        return mark;
    }
    allow_new_sentence(text, parse->pieces);
    allow_superlative(question, parse->pieces);
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

}  // namespace fulcrum::dialogue
