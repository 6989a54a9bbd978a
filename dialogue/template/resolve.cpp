#include "dialogue/template/resolve.h"

#include "dialogue/english/letters.h"
#include "dialogue/english/making.h"
#include "dialogue/template/phrases.h"

#include <algorithm>
#include <array>
#include <iterator>
#include <optional>
#include <string_view>

namespace fulcrum::dialogue {
namespace {

/// The piece before `at` that belongs in the sentence, or kNone.
int before(const std::vector<Piece>& pieces, int at) {
    for (int i = at - 1; i >= 0; --i) {
        if (!pieces[static_cast<std::size_t>(i)].right.empty()) {
            return i;
        }
    }
    return kNone;
}

/// The piece after `at` that belongs in the sentence, or kNone.
int after(const std::vector<Piece>& pieces, int at) {
    for (int i = at + 1; i < static_cast<int>(pieces.size()); ++i) {
        if (!pieces[static_cast<std::size_t>(i)].right.empty()) {
            return i;
        }
    }
    return kNone;
}

/// "How many moons does Saturn have": behind "does" no verb agrees.
bool is_auxiliary(const std::string& word) {
    constexpr std::array<std::string_view, 11> kAuxiliaries = {
        "do", "does", "did", "can", "could", "will", "would", "must", "may", "might", "should"};
    return std::find(kAuxiliaries.begin(), kAuxiliaries.end(), lower_case(word)) !=
           kAuxiliaries.end();
}

/// The number of the subject that ends just before `verb`; none when the template's own verb is to be trusted.
std::optional<Number> subject_number(const std::vector<Piece>& pieces, int verb) {
    const int noun = before(pieces, verb);
    if (noun == kNone || pieces[static_cast<std::size_t>(noun)].element.role != Role::noun) {
        return std::nullopt;
    }
    int start = before(pieces, noun);
    while (start != kNone &&
           pieces[static_cast<std::size_t>(start)].element.role == Role::determiner) {
        start = before(pieces, start);
    }
    if (start == kNone) {
        return pieces[static_cast<std::size_t>(noun)].number;
    }
    // "The weight of {thing} is", "{thing} and {thing:other} are": the noun alone doesn't tell.
    const Piece& head = pieces[static_cast<std::size_t>(start)];
    const bool inside = is_auxiliary(head.right) || head.element.role == Role::preposition ||
                        head.right == "and" || head.right == "or" || head.right == "for" ||
                        head.right == "like";
    return inside ? std::nullopt
                  : std::optional<Number>(pieces[static_cast<std::size_t>(noun)].number);
}

/// "How many moons does Saturn have": in a question the verb goes with the noun right behind it; none when that is no noun.
std::optional<Number> asked_number(const std::vector<Piece>& pieces, int verb) {
    constexpr std::array<std::string_view, 6> kAsking = {"how",   "what", "which",
                                                         "where", "who",  "why"};
    const int first = after(pieces, kNone);
    if (first == kNone || first == verb ||
        std::find(kAsking.begin(), kAsking.end(),
                  lower_case(pieces[static_cast<std::size_t>(first)].right)) == kAsking.end()) {
        return std::nullopt;
    }
    int noun = after(pieces, verb);
    while (noun != kNone &&
           pieces[static_cast<std::size_t>(noun)].element.role == Role::determiner) {
        noun = after(pieces, noun);
    }
    const bool is_noun =
        noun != kNone && pieces[static_cast<std::size_t>(noun)].element.role == Role::noun;
    return is_noun ? std::optional<Number>(pieces[static_cast<std::size_t>(noun)].number)
                   : std::nullopt;
}

/// "These rock are": what points at the noun has the wrong number, and its verb went along.
bool points_in_other_number(const std::vector<Piece>& pieces, int noun) {
    const int determiner = before(pieces, noun);
    return determiner != kNone &&
           is_demonstrative(pieces[static_cast<std::size_t>(determiner)].right) &&
           pieces[static_cast<std::size_t>(determiner)].code == ErrorCode::wrong_determiner;
}

/// The verb goes with `number`; `excused` when its noun was said in another number, which is one error and not two.
void agree(Piece& verb, Number number, bool excused) {
    // An arc without an error says the template's own form, one of agreement the other; "'s" has its arc too.
    const VerbForms& forms = verb.element.verb;
    const bool own_is_singular = verb.right == forms.singular;
    const bool says_own = verb.code == ErrorCode::none;
    verb.right = forms.with(number);
    if (!says_own && verb.code != ErrorCode::agreement) {
        return;  // missing, misspelt or another form: only what belongs there changes
    }
    const bool says_singular = says_own == own_is_singular;
    const bool same = excused || verb.said.empty() || says_singular == (number == Number::singular);
    verb.code = same ? ErrorCode::none : ErrorCode::agreement;
    verb.cost = same ? 0 : kSlipCost;
}

/// "There is one moon", "there are two moons": the verb goes with the number behind it.
void agree_there(std::vector<Piece>& pieces, int number, Number counted) {
    const int verb = before(pieces, number);
    const int there = verb == kNone ? kNone : before(pieces, verb);
    if (there != kNone && lower_case(pieces[static_cast<std::size_t>(there)].right) == "there" &&
        pieces[static_cast<std::size_t>(verb)].element.role == Role::verb) {
        agree(pieces[static_cast<std::size_t>(verb)], counted, false);
    }
}

/// "one moon", "two moons": the counted noun goes with the number before it.
void count(std::vector<Piece>& pieces, int at) {
    Piece& noun = pieces[static_cast<std::size_t>(at)];
    const int number = before(pieces, at);
    const std::string counted =
        number == kNone ? "" : lower_case(pieces[static_cast<std::size_t>(number)].right);
    // "No moon" is as good as "no moons", and is said back as it was said.
    const bool is_none = counted == "no" && noun.code == ErrorCode::noun_number;
    const bool is_one =
        is_none || counted == "one" || counted == "1" || counted == "a" || counted == "an";
    if (number != kNone) {
        agree_there(pieces, number, is_one ? Number::singular : Number::plural);
    }
    if (!is_one) {
        return;
    }
    const bool is_plural = noun.code == ErrorCode::none;
    noun.right = noun.element.base;
    noun.number = Number::singular;
    if (noun.said.empty() || noun.code == ErrorCode::noun_number) {
        noun.code = ErrorCode::none;
        noun.cost = 0;
    } else if (is_plural) {
        noun.code = ErrorCode::noun_number;
        noun.cost = kSlipCost;
    }
}

/// "the heavier than": without "than" it is right.
void drop_the_before_than(std::vector<Piece>& pieces, int adjective) {
    const int the = before(pieces, adjective);
    const int than = after(pieces, adjective);
    if (the == kNone || than == kNone || pieces[static_cast<std::size_t>(than)].right != "than") {
        return;
    }
    Piece& article = pieces[static_cast<std::size_t>(the)];
    const bool optional =
        article.element.role == Role::determiner && article.code == ErrorCode::none;
    if (optional && article.right == "the" && article.element.target) {
        article.right.clear();
        article.code = ErrorCode::extra_determiner;
        article.cost = kSlipCost;
    }
}

/// A literal a or an, by the sound of the next word.
void sound(std::vector<Piece>& pieces, int at) {
    Piece& article = pieces[static_cast<std::size_t>(at)];
    const int next = after(pieces, at);
    if ((article.right != "a" && article.right != "an") || next == kNone) {
        return;
    }
    const Piece& word = pieces[static_cast<std::size_t>(next)];
    if (word.element.role == Role::noun || both_articles(word.right)) {
        return;  // settled by the noun's own branch
    }
    article.right = std::string(indefinite_article(word.right));
    const std::string said = lower_case(article.said);
    if (said == "a" || said == "an") {
        article.code = said == article.right ? ErrorCode::none : ErrorCode::wrong_determiner;
        article.cost = said == article.right ? 0 : kSlipCost;
    }
}

/// "made from" is right where the material was changed in the making: paper is made from wood.
void allow_from(std::vector<Piece>& pieces, int preposition) {
    Piece& piece = pieces[static_cast<std::size_t>(preposition)];
    const auto is_noun = [](const Piece& other) { return other.element.role == Role::noun; };
    const auto at = pieces.begin() + preposition;
    const auto material = std::find_if(at, pieces.end(), is_noun);
    const auto thing = std::find_if(std::reverse_iterator(at), pieces.rend(), is_noun);
    if (lower_case(piece.said) == "from" && material != pieces.end() && thing != pieces.rend() &&
        changed_in_making(thing->right, material->right)) {
        piece.right = "from";
        piece.code = ErrorCode::none;
        piece.cost = 0;
    }
}

}  // namespace

void resolve(std::vector<Piece>& pieces) {
    for (int i = 0; i < static_cast<int>(pieces.size()); ++i) {
        Piece& piece = pieces[static_cast<std::size_t>(i)];
        if (piece.element.role == Role::verb) {
            if (const auto asked = asked_number(pieces, i)) {
                agree(piece, *asked, false);
            } else if (const auto number = subject_number(pieces, i)) {
                const int noun = before(pieces, i);
                agree(piece, *number,
                      pieces[static_cast<std::size_t>(noun)].code == ErrorCode::noun_number ||
                          points_in_other_number(pieces, noun));
            }
        } else if (piece.element.role == Role::adjective &&
                   piece.element.degree == Degree::comparative) {
            drop_the_before_than(pieces, i);
        } else if (piece.element.role == Role::noun && !piece.element.base.empty()) {
            count(pieces, i);
        } else if (piece.element.role == Role::determiner) {
            sound(pieces, i);
        } else if (piece.element.role == Role::preposition && piece.element.passive) {
            allow_from(pieces, i);
        }
    }
}

int total_cost(const std::vector<Piece>& pieces) {
    int sum = 0;
    for (const Piece& piece : pieces) {
        sum += piece.cost;
    }
    return sum;
}

}  // namespace fulcrum::dialogue
