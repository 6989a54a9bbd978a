// The article before a list, and the list: the article depends on the noun's class and sound, so each class of noun has
// a branch of its own.
#include "dialogue/english/letters.h"
#include "dialogue/english/unit.h"
#include "dialogue/template/article_writer.h"
#include "dialogue/template/phrases.h"

#include <algorithm>
#include <functional>
#include <map>
#include <string>
#include <utility>

namespace fulcrum::dialogue {
namespace {

/// "It should be {weight}": an adjective alone, of which there are neither one nor several.
bool describes_alone(const Noun& noun, ArticlePolicy policy) {
    return policy == ArticlePolicy::bare && noun.noun_class == NounClass::count &&
           describes(noun.text);
}

Branch branch_of(const Noun& noun, ArticlePolicy policy) {
    const bool measures = policy == ArticlePolicy::bare || policy == ArticlePolicy::short_answer;
    if (measures && is_unit(noun.text)) {
        return Branch::unit;
    }
    switch (noun.noun_class) {
        case NounClass::mass:
            return policy == ArticlePolicy::definite && is_around(noun.text) ? Branch::the_stuff
                                                                             : Branch::bare_or_the;
        case NounClass::plural:
            return Branch::bare_plural;
        case NounClass::name:
        case NounClass::no_noun:
            return Branch::name;
        case NounClass::named_the:
            return Branch::the_name;
        case NounClass::name_or_the:
            return Branch::name_or_the;
        case NounClass::count:
            break;
    }
    if (names_force(noun.text)) {  // where the sentence does not count it
        if (policy == ArticlePolicy::bare) {
            return Branch::bare_or_the;
        }
        if (policy == ArticlePolicy::definite) {
            return Branch::the_stuff;
        }
    }
    if (both_articles(noun.text)) {
        return Branch::with_both;
    }
    return indefinite_article(noun.text) == "an" ? Branch::with_an : Branch::with_a;
}

/// Writes the noun in the number that its list doesn't give.
class OtherNumber {
  public:
    OtherNumber(ArcWriter& writer, ArticlePolicy policy, bool predicate, int place, int to,
                std::function<int(Branch)> node_of)
        : writer_(writer),
          policy_(policy),
          predicate_(predicate),
          place_(place),
          to_(to),
          node_of_(std::move(node_of)) {}

    void add(const Noun& noun, int item, Branch branch) {
        switch (noun.noun_class) {
            case NounClass::count:
                return branch == Branch::bare_or_the || branch == Branch::the_stuff
                           ? plural_of_mass(noun, item, branch)
                           : plural_of_count(noun, item, branch);
            case NounClass::mass:
                return plural_of_mass(noun, item, branch);
            case NounClass::plural:
                return branch == Branch::unit ? wrong(branch, singular_of(noun.text), noun, item)
                                              : singular_of_plural(noun, item);
            default:
                return;
        }
    }

  private:
    /// Right by itself, wrong after a or an, and wrong of the one thing that is there.
    void plural_of_count(const Noun& noun, int item, Branch branch) {
        const std::string plural = plural_of(noun.text);
        if (lower_case(plural) == lower_case(noun.text)) {
            return;
        }
        if (policy_ == ArticlePolicy::after_no) {  // "no tails" is as good as "no tail"
            return right(branch, plural, Number::plural, item);
        }
        const bool with_an = branch == Branch::with_an;
        wrong(with_an ? Branch::plural_after_an : Branch::plural_after_a, plural, noun, item);
        wrong(Branch::plural_of_one, plural, noun, item);
        if (!predicate_) {
            right(Branch::made_plural, plural, Number::plural, item);
        }
    }

    /// "The metals", "woods": wrong, except for kinds of it in general, "Metals are hard".
    void plural_of_mass(const Noun& noun, int item, Branch branch) {
        const std::string plural = plural_of(noun.text);
        if (lower_case(plural) == lower_case(noun.text)) {
            return;
        }
        wrong(Branch::plural_of_one, plural, noun, item);
        if (has_kinds(noun.text) && !predicate_) {
            right(Branch::made_plural, plural, Number::plural, item);
        } else {
            wrong(branch, plural, noun, item);
        }
    }

    /// "The window" of several windows is one of them; nobody says "the scissor".
    void singular_of_plural(const Noun& noun, int item) {
        const std::string singular = singular_of(noun.text);
        if (singular.empty()) {
            return;
        }
        if (is_plural_only(noun.text)) {
            return wrong(Branch::bare_plural, singular, noun, item);
        }
        const bool with_an = indefinite_article(singular) == "an";
        if (policy_ == ArticlePolicy::bare) {  // "from tree": one of them needs its article
            wrong(Branch::bare_plural, singular, noun, item);
            return right(with_an ? Branch::one_with_an : Branch::one_with_a, singular,
                         Number::singular, item);
        }
        right(with_an ? Branch::with_an : Branch::with_a, singular, Number::singular, item);
    }

    void wrong(Branch branch, const std::string& said, const Noun& noun, int item) {
        ArcText arc{said, noun.text, ErrorCode::noun_number, kSlipCost, false, item};
        arc.number = noun.number();
        writer_.add_arc(node_of_(branch), to_, place_, arc);
    }
    void right(Branch branch, const std::string& said, Number number, int item) {
        if (policy_ == ArticlePolicy::determined && number == Number::plural) {
            return;  // "my stones", where there is one
        }
        writer_.add_arc(node_of_(branch), to_, place_,
                        {said, said, ErrorCode::none, 0, false, item, number});
    }

    ArcWriter& writer_;
    ArticlePolicy policy_;
    bool predicate_;
    int place_, to_;
    std::function<int(Branch)> node_of_;
};

/// Of an adjective: the articles of the noun behind it, or none where it stands `alone`.
Branch describing_branch(const Noun& noun, bool alone) {
    if (alone) {
        return Branch::name;
    }
    return indefinite_article(noun.text) == "an" ? Branch::with_an : Branch::with_a;
}

/// "More long", "more longer" where "longer" is a word of the list.
void add_wrong_degrees(ArcWriter& writer, const WordList& list, int slot, const Noun& noun,
                       int item, int from, int to) {
    const std::string base = compared_of(noun.text);
    if (base.empty()) {
        return;
    }
    constexpr int kOtherDegree = 3;
    const auto is_listed = [&](const std::string& text) {
        return std::any_of(list.items.begin(), list.items.end(), [&](const ListItem& other) {
            return std::any_of(other.spoken.begin(), other.spoken.end(),
                               [&](const Noun& word) { return word.text == text; });
        });
    };
    Element element{Role::adjective};
    element.slot = slot;
    element.base = base;
    element.degree = Degree::comparative;
    const int place = writer.add_element(std::move(element));
    for (const LearnerForm& wrong : learner_forms(base, Degree::comparative)) {
        if (wrong.slip < kOtherDegree && !is_listed(wrong.text)) {
            writer.add_arc(
                from, to, place,
                {wrong.text, noun.text, wrong.code, wrong.slip * kSlipCost, false, item});
        }
    }
}

}  // namespace

bool all_describe(const WordList& list) {
    return std::all_of(list.items.begin(), list.items.end(),
                       [](const ListItem& item) { return describes(item.spoken.front().text); });
}

void add_noun_phrase(ArcWriter& writer, const WordList& list, int slot, ArticlePolicy policy,
                     int from, int to, bool behind_is) {
    // "It is {material}" may speak of rocks; with an article one thing is meant.
    const bool predicate = behind_is && policy != ArticlePolicy::bare;
    const bool adjectives = all_describe(list);
    Element noun_element{Role::noun};
    noun_element.slot = slot;
    const int determiner = writer.add_element({Role::determiner});
    const int place = writer.add_element(std::move(noun_element));

    // A node for each branch that some entry needs; its articles are written when it is first asked for.
    std::map<Branch, int> nodes;
    const auto node_of = [&](Branch branch) {
        if (policy == ArticlePolicy::determined) {
            return from;
        }
        const auto [entry, is_new] = nodes.try_emplace(branch, kNone);
        if (is_new) {
            entry->second = writer.add_node();
            ArticleWriter(writer, policy, predicate, determiner, from, entry->second).write(branch);
        }
        return entry->second;
    };

    OtherNumber other_number(writer, policy, predicate, place, to, node_of);
    for (std::size_t i = 0; i < list.items.size() && !writer.full(); ++i) {
        const std::vector<Noun>& spoken = list.items[i].spoken;
        for (const Noun& noun : spoken) {
            ArcText arc{noun.text, noun.text, ErrorCode::none, 0, &noun == spoken.data()};
            arc.item = static_cast<int>(i);
            arc.number = noun.number();
            const bool alone =
                describes_alone(noun, policy) || (adjectives && policy == ArticlePolicy::bare);
            if (alone || adjectives) {
                // Of "the red one" neither several nor stuff.
                arc.number = alone ? arc.number : Number::singular;
                const int start = node_of(describing_branch(noun, alone));
                writer.add_arc(start, to, place, arc);
                add_wrong_degrees(writer, list, slot, noun, arc.item, start, to);
                continue;
            }
            const Branch branch = branch_of(noun, policy);
            writer.add_arc(node_of(branch), to, place, arc);
            other_number.add(noun, static_cast<int>(i), branch);
        }
    }
}

}  // namespace fulcrum::dialogue
