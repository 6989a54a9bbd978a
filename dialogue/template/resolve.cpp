#include "dialogue/template/resolve.h"

#include "dialogue/english/letters.h"
#include "dialogue/english/making.h"
#include "dialogue/english/noun.h"
#include "dialogue/english/number.h"
#include "dialogue/template/phrases.h"
#include "dialogue/template/resolve_articles.h"
#include "dialogue/template/tokens.h"

#include <algorithm>
#include <array>
#include <iterator>
#include <optional>
#include <string_view>

namespace fulcrum::dialogue {
namespace {

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

/// One thing of what is counted.
bool means_one(const std::string& counted) {
    return counted == "one" || counted == "1" || counted == "a" || counted == "an";
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

/// "There is one", "there are two": nothing is said of what.
void agree_there_alone(std::vector<Piece>& pieces, int number) {
    const Piece& piece = pieces[static_cast<std::size_t>(number)];
    const int next = after(pieces, number);
    const bool counts =
        next != kNone && !pieces[static_cast<std::size_t>(next)].element.base.empty();
    const std::vector<std::string> words = words_of(piece.right);
    const bool is_number = !words.empty() && is_number_word(words.front());
    if (is_number && !counts) {
        agree_there(pieces, number,
                    means_one(lower_case(piece.right)) ? Number::singular : Number::plural);
    }
}

/// "An egg": the article that counts goes by the sound of what it counts.
void sound_counted(Piece& number, const std::string& noun) {
    const std::string counted = lower_case(number.right);
    if ((counted != "a" && counted != "an") || both_articles(noun)) {
        return;
    }
    number.right = std::string(indefinite_article(noun));
    if (number.right != counted && number.code == ErrorCode::none && !number.said.empty()) {
        number.code = ErrorCode::wrong_determiner;
        number.cost = kSlipCost;
    }
}

/// "It has two": the noun may be left out behind a number; not behind "a" and "no".
void leave_out(std::vector<Piece>& pieces, int number, Piece& noun) {
    const std::string counted = lower_case(pieces[static_cast<std::size_t>(number)].right);
    const bool none = counted == "no";
    if (none || counted == "a" || counted == "an") {
        noun.right = none ? plural_of(noun.element.base) : noun.element.base;
        noun.code = ErrorCode::wording;
        noun.cost = kPatternCost;
        Piece& article = pieces[static_cast<std::size_t>(number)];
        article.right = none ? article.right : std::string(indefinite_article(noun.right));
    }
    agree_there(pieces, number, means_one(counted) ? Number::singular : Number::plural);
}

/// "one moon", "two moons": the counted noun goes with the number before it.
void count(std::vector<Piece>& pieces, int at) {
    Piece& noun = pieces[static_cast<std::size_t>(at)];
    if (noun.right.empty()) {
        leave_out(pieces, before(pieces, at), noun);
        return;
    }
    int number = before(pieces, at);
    while (number != kNone &&
           describes(lower_case(pieces[static_cast<std::size_t>(number)].right))) {
        number = before(pieces, number);  // "one small moon"
    }
    const std::string counted =
        number == kNone ? "" : lower_case(pieces[static_cast<std::size_t>(number)].right);
    // "No moon" is as good as "no moons", and is said back as it was said.
    if (counted == "none") {  // "none moons"
        Piece& none = pieces[static_cast<std::size_t>(number)];
        none.right = "no";
        none.code = ErrorCode::wrong_determiner;
        none.cost = kSlipCost;
    }
    const bool is_none = counted == "no" && noun.code == ErrorCode::noun_number;
    const bool is_one = is_none || means_one(counted);
    if (number != kNone) {
        agree_there(pieces, number, is_one ? Number::singular : Number::plural);
    }
    if (!is_one) {
        return;
    }
    const bool is_plural = noun.code == ErrorCode::none;
    noun.right = noun.element.base;
    noun.number = Number::singular;
    if (number != kNone) {
        sound_counted(pieces[static_cast<std::size_t>(number)],
                      pieces[static_cast<std::size_t>(after(pieces, number))].right);
    }
    if (noun.said.empty() || noun.code == ErrorCode::noun_number) {
        noun.code = ErrorCode::none;
        noun.cost = 0;
    } else if (is_plural) {
        noun.code = ErrorCode::noun_number;
        noun.cost = kSlipCost;
    }
}

/// "Apples are heavier than eggs": all of a kind, though the template speaks of the one that is there. As a subject and
/// behind "than" that is right; elsewhere the one is meant.
void allow_kind(std::vector<Piece>& pieces, int at) {
    Piece& noun = pieces[static_cast<std::size_t>(at)];
    const int determiner = at - 1;
    const bool apart = determiner >= 0 && !noun.element.brings_article;
    Piece* article = apart ? &pieces[static_cast<std::size_t>(determiner)] : nullptr;
    const bool bare = article == nullptr
                          ? noun.element.brings_article
                          : article->element.role == Role::determiner && article->said.empty() &&
                                article->code == ErrorCode::missing_determiner;
    if (noun.code != ErrorCode::noun_number || noun.said.empty() || !bare ||
        noun.number != Number::singular) {
        return;
    }
    const std::string kind = understand_noun(noun.right).text;
    const int next = after(pieces, at);
    const int last = before(pieces, apart ? determiner : at);
    const bool subject =
        next != kNone &&
        (pieces[static_cast<std::size_t>(next)].element.role == Role::verb ||
         is_auxiliary(pieces[static_cast<std::size_t>(next)].right)) &&
        (last == kNone || !is_auxiliary(pieces[static_cast<std::size_t>(last)].right));
    const bool compared = last != kNone && pieces[static_cast<std::size_t>(last)].right == "than";
    if ((!subject && !compared) || (is_mass_noun(kind) && !has_kinds(kind))) {
        return;
    }
    noun.right = plural_of(kind);
    noun.number = Number::plural;
    noun.cost -= noun.element.brings_article ? kKindCost : kSlipCost;
    noun.code = noun.cost > 0 ? ErrorCode::spelling : ErrorCode::none;
    if (article != nullptr) {
        article->right.clear();
        article->code = ErrorCode::none;
        article->cost = 0;
    }
}

/// "Nearer the stone" is as good as "nearer to the stone".
void allow_near(std::vector<Piece>& pieces, int preposition) {
    constexpr std::array<std::string_view, 4> kNear = {"near", "nearer", "nearest", "opposite"};
    Piece& to = pieces[static_cast<std::size_t>(preposition)];
    const int last = before(pieces, preposition);
    if (to.code != ErrorCode::missing_preposition || to.right != "to" || last == kNone) {
        return;
    }
    const std::vector<std::string> words = words_of(pieces[static_cast<std::size_t>(last)].right);
    if (std::find(kNear.begin(), kNear.end(), words.back()) != kNear.end()) {
        to.right.clear();
        to.code = ErrorCode::none;
        to.cost = 0;
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

void resolve_adjective(std::vector<Piece>& pieces, int at) {
    const Degree degree = pieces[static_cast<std::size_t>(at)].element.degree;
    if (degree == Degree::comparative) {
        drop_the(pieces, at);
    } else if (degree == Degree::superlative) {
        allow_bare_nearest(pieces, at);
    }
}

void resolve_noun(std::vector<Piece>& pieces, int at) {
    if (!pieces[static_cast<std::size_t>(at)].element.base.empty()) {
        count(pieces, at);
    } else {
        allow_kind(pieces, at);
        agree_there_alone(pieces, at);
    }
}

/// Said where nothing belongs: "heavier *is* than", "of metal *made*", "than the egg *is*".
bool is_late(const Piece& piece) {
    const bool wrong = piece.code == ErrorCode::word_order;
    return piece.right.empty() && !piece.said.empty() && piece.element.role == Role::word &&
           (wrong || piece.code == ErrorCode::none);
}

/// What `late` says is missing at `verb`.
bool is_missing_there(const Piece& verb, const std::string& late) {
    const std::vector<std::string> words = words_of(late);
    const auto says = [&](std::string_view word) {
        return std::find(words.begin(), words.end(), word) != words.end();
    };
    return verb.code == ErrorCode::missing_verb && verb.said.empty() &&
           (verb.element.verb.is_be ? says("is") || says("are")
                                    : verb.element.passive && says(verb.right));
}

/// "The key is metal made": nothing is missed in "is metal", so "made" and its "of" belong in between.
void put_making_back(std::vector<Piece>& pieces, int late) {
    Piece& piece = pieces[static_cast<std::size_t>(late)];
    const auto between = std::find_if(pieces.begin(), pieces.begin() + late, [](const Piece& word) {
        return word.element.passive && word.element.role == Role::word && word.said.empty() &&
               word.right.empty();
    });
    if (piece.element.passive && between != pieces.begin() + late) {
        between->right = "made of";
        std::swap(between->code, piece.code);
        std::swap(between->cost, piece.cost);
    }
}

/// A verb that is missing in its place and comes later is one error, of order.
void settle_order(std::vector<Piece>& pieces, int late) {
    Piece& piece = pieces[static_cast<std::size_t>(late)];
    bool moved = false;
    for (int i = 0; i < late; ++i) {
        Piece& verb = pieces[static_cast<std::size_t>(i)];
        if (is_missing_there(verb, piece.said)) {
            verb.code = moved ? ErrorCode::none : ErrorCode::word_order;
            verb.cost = moved ? 0 : kOrderCost;
            moved = true;
        }
    }
    if (moved) {
        piece.code = ErrorCode::none;
        piece.cost = 0;
    } else {
        put_making_back(pieces, late);
    }
}

void resolve_verb(std::vector<Piece>& pieces, int at) {
    Piece& verb = pieces[static_cast<std::size_t>(at)];
    if (const auto asked = asked_number(pieces, at)) {
        agree(verb, *asked, false);
    } else if (const auto number = subject_number(pieces, at)) {
        const int noun = before(pieces, at);
        const ErrorCode error = pieces[static_cast<std::size_t>(noun)].code;
        agree(verb, *number,
              error == ErrorCode::noun_number || error == ErrorCode::wrong_pronoun ||
                  points_in_other_number(pieces, noun));
    }
}

}  // namespace

void resolve(std::vector<Piece>& pieces) {
    for (int i = 0; i < static_cast<int>(pieces.size()); ++i) {
        if (is_late(pieces[static_cast<std::size_t>(i)])) {
            settle_order(pieces, i);
        }
    }
    for (int i = 0; i < static_cast<int>(pieces.size()); ++i) {
        if (!pieces[static_cast<std::size_t>(i)].right.empty()) {
            part_determiners(pieces, i);
        }
    }
    for (int i = 0; i < static_cast<int>(pieces.size()); ++i) {
        Piece& piece = pieces[static_cast<std::size_t>(i)];
        if (piece.element.role == Role::verb) {
            resolve_verb(pieces, i);
        } else if (piece.element.role == Role::adjective) {
            resolve_adjective(pieces, i);
        } else if (piece.element.role == Role::noun) {
            resolve_noun(pieces, i);
        } else if (piece.element.role == Role::determiner) {
            sound(pieces, i);
        } else if (piece.element.role == Role::preposition) {
            piece.element.passive ? allow_from(pieces, i) : allow_near(pieces, i);
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
