#include "dialogue/marking/mark.h"

#include "dialogue/english/letters.h"
#include "dialogue/marking/near_miss.h"
#include "dialogue/marking/other_degree.h"
#include "dialogue/marking/readings.h"
#include "dialogue/marking/said_spans.h"
#include "dialogue/marking/sentence_marks.h"
#include "dialogue/marking/wording.h"
#include "dialogue/template/matcher.h"
#include "dialogue/template/resolve_articles.h"
#include "dialogue/template/sentences.h"
#include "dialogue/template/tokens.h"

#include <algorithm>
#include <optional>
#include <utility>

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
    const auto found = std::ranges::min_element(form_errors, {}, rank);
    return found == form_errors.end() ? nullptr : &*found;
}

std::string_view Mark::slot(std::string_view name) const {
    const auto found = std::find_if(slots.begin(), slots.end(),
                                    [&](const auto& slot) { return slot.first == name; });
    return found == slots.end() ? std::string_view{} : std::string_view(found->second);
}

Mark mark_answer(const Question& question, std::string_view text, double confidence) {
    Mark whole = mark_sentence(question, text, confidence);
    std::optional<Mark> by_sentences = mark_sentences(question, whole);
    return by_sentences ? std::move(*by_sentences) : std::move(whole);
}

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

std::string example_sentence(const Question& question) {
    return render(canonical_pieces(*question.templates, 0, {}));
}

namespace {

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

}  // namespace

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

Mark without_form(Mark mark) {
    mark.form_known = false;
    mark.form_errors.clear();
    mark.emphasised = mark.corrected;
    mark.emphasis.clear();
    mark.gapped.clear();
    return mark;
}

namespace {

/// Adds what the first answer can say for `slot`, each once.
void add_choices(const TemplateSet& set, std::size_t slot, std::vector<std::string>& result) {
    for (const ListItem& item : set.lists[static_cast<std::size_t>(set.slot_lists[slot])].items) {
        const std::vector<Piece> pieces = canonical_pieces(set, 0, {{set.slots[slot], item.value}});
        const std::string phrase =
            render_phrase(pieces, same_phrase(pieces, static_cast<int>(slot)));
        if (!phrase.empty() && std::find(result.begin(), result.end(), phrase) == result.end()) {
            result.push_back(phrase);
        }
    }
}

}  // namespace

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
