// The article before a list, and the list: the article depends on the noun's class and sound, so each class of noun has
// a branch of its own.
#include "dialogue/english/letters.h"
#include "dialogue/english/unit.h"
#include "dialogue/template/phrases.h"

#include <algorithm>
#include <array>
#include <functional>
#include <map>
#include <string>
#include <utility>

namespace fulcrum::dialogue {
namespace {

/// Nouns that take the same articles.
enum class Branch : std::uint8_t {
    with_a,           // a watermelon
    with_an,          // an apple
    with_both,        // a herb, an herb
    one_with_a,       // "a tree", where the list has trees and the template no article
    one_with_an,      // "an egg", likewise
    bare_or_the,      // water
    bare_plural,      // scissors
    made_plural,      // watermelons in general, where the list has watermelon
    plural_of_one,    // "the watermelons", where there is one
    name,             // Jupiter, far
    the_name,         // the Moon
    name_or_the,      // Earth, the Earth
    plural_after_a,   // "a watermelons"
    plural_after_an,  // "an apples"
    unit,             // newtons, where no number stands before them
};

/// Writes the articles of one branch between two nodes.
class ArticleWriter {
  public:
    ArticleWriter(ArcWriter& writer, ArticlePolicy policy, bool predicate, int element, int from,
                  int to)
        : writer_(writer),
          policy_(policy),
          predicate_(predicate),
          element_(element),
          from_(from),
          to_(to) {}

    void write(Branch branch) {
        switch (branch) {
            case Branch::with_a:
                return count_noun("a", "an");
            case Branch::with_an:
                return count_noun("an", "a");
            case Branch::with_both:
                return count_noun("a", "");
            case Branch::one_with_a:
                return one_of_several("a", "an");
            case Branch::one_with_an:
                return one_of_several("an", "a");
            case Branch::bare_or_the:
                return without({"some", "this", "that"}, {"these", "those"});
            case Branch::bare_plural:
                return without({"some", "these", "those"}, {"this", "that"});
            case Branch::made_plural:
                return plurals_in_general();
            case Branch::plural_of_one:
                return plurals_that_are_there();
            case Branch::name:
                return only_name();
            case Branch::the_name:
                return with_the(ErrorCode::missing_determiner);
            case Branch::name_or_the:
                return with_the(ErrorCode::none);
            case Branch::plural_after_a:
                return miscounted("a", "an");
            case Branch::plural_after_an:
                return miscounted("an", "a");
            case Branch::unit:
                return no_determiner();
        }
    }

  private:
    void right(std::string_view said, bool canonical) {
        writer_.add_arc(from_, to_, element_, {said, said, ErrorCode::none, 0, canonical});
    }
    /// As good as `belongs`, which is said back.
    void passes(std::string_view said, std::string_view belongs) {
        writer_.add_arc(from_, to_, element_, {said, belongs, ErrorCode::none, 0});
    }
    void wrong(std::string_view said, std::string_view belongs, ErrorCode code) {
        writer_.add_arc(from_, to_, element_, {said, belongs, code, kSlipCost});
    }

    void count_noun(std::string_view own, std::string_view other) {
        const bool definite = policy_ == ArticlePolicy::definite;
        const bool bare = policy_ == ArticlePolicy::bare;
        if (definite) {
            passes(own, "the");
        } else {
            right(own, !bare);
        }
        right("the", definite);
        for (const std::string_view said : {"this", "that", "my", "your", "our", "its"}) {
            right(said, false);
        }
        wrong("these", "this", ErrorCode::wrong_determiner);
        wrong("those", "that", ErrorCode::wrong_determiner);
        if (other.empty()) {
            passes("an", definite ? "the" : "an");
        } else {
            wrong(other, own, ErrorCode::wrong_determiner);
        }
        if (bare || policy_ == ArticlePolicy::short_answer) {
            right("", bare);
        } else {
            wrong("", definite ? "the" : own, ErrorCode::missing_determiner);
        }
        for (const std::string_view article : {"a", "an"}) {
            wrong("the " + std::string(article), "the", ErrorCode::extra_determiner);
        }
    }

    /// The singular of what a list has several of.
    void one_of_several(std::string_view own, std::string_view other) {
        for (const std::string_view said : {own, std::string_view("the"), std::string_view("this"),
                                            std::string_view("that"), std::string_view("one")}) {
            right(said, false);
        }
        wrong(other, own, ErrorCode::wrong_determiner);
    }

    /// `others` point at what has the other number: "these metal", "this scissors".
    void without(const std::array<std::string_view, 3>& determiners,
                 const std::array<std::string_view, 2>& others) {
        const bool definite = policy_ == ArticlePolicy::definite;
        right("", !definite);
        right("the", definite);
        for (const std::string_view said : determiners) {
            right(said, false);
        }
        right("its", false);
        for (std::size_t i = 0; i < others.size(); ++i) {
            wrong(others[i], determiners[i + 1], ErrorCode::wrong_determiner);
        }
        wrong("a", "", ErrorCode::extra_determiner);
        wrong("an", "", ErrorCode::extra_determiner);
    }

    /// "Apples are heavier": right where any will do; what is there is one thing, see below. Where the template speaks of no
    /// one thing, "these rocks" are pieces of it.
    void plurals_in_general() {
        if (policy_ != ArticlePolicy::definite) {
            right("", false);
            right("some", false);
        }
        if (policy_ == ArticlePolicy::bare) {
            right("these", false);
            right("those", false);
        }
    }

    /// "The apples": there is one, so the noun is wrong (the arc of the noun says so) and its determiner goes with it.
    void plurals_that_are_there() {
        right("the", false);
        passes("these", "this");
        passes("those", "that");
        right("this", false);
        right("that", false);
        if (policy_ == ArticlePolicy::definite) {
            passes("some", "the");
            wrong("", "the", ErrorCode::missing_determiner);
        }
    }

    void only_name() {
        right("", true);
        for (const std::string_view said : {"a", "an", "the", "this", "that"}) {
            wrong(said, "", ErrorCode::extra_determiner);
        }
    }

    void no_determiner() {
        right("", true);
        for (const std::string_view said :
             {"a", "an", "the", "this", "that", "these", "those", "some", "its"}) {
            wrong(said, "", ErrorCode::extra_determiner);
        }
    }

    void with_the(ErrorCode without_it) {
        const bool free = without_it == ErrorCode::none || policy_ == ArticlePolicy::short_answer;
        right("the", true);
        if (free) {
            right("", false);
        } else {
            wrong("", "the", without_it);
        }
        wrong("a", "the", ErrorCode::wrong_determiner);
        wrong("an", "the", ErrorCode::wrong_determiner);
    }

    void miscounted(std::string_view own, std::string_view other) {
        right(own, false);
        wrong(other, own, ErrorCode::wrong_determiner);
        if (predicate_) {
            passes("some", own);
            wrong("", own, ErrorCode::missing_determiner);
        }
    }

    ArcWriter& writer_;
    ArticlePolicy policy_;
    bool predicate_;
    int element_, from_, to_;
};

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
            return Branch::bare_or_the;
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
                return plural_of_count(noun, item, branch);
            case NounClass::mass:
                return plural_of_mass(noun, item);
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
        const bool with_an = branch == Branch::with_an;
        wrong(with_an ? Branch::plural_after_an : Branch::plural_after_a, plural, noun, item);
        wrong(Branch::plural_of_one, plural, noun, item);
        if (!predicate_) {
            right(Branch::made_plural, plural, Number::plural, item);
        }
    }

    /// "The metals", "woods": wrong, except for kinds of it in general, "Metals are hard".
    void plural_of_mass(const Noun& noun, int item) {
        const std::string plural = plural_of(noun.text);
        if (lower_case(plural) == lower_case(noun.text)) {
            return;
        }
        wrong(Branch::plural_of_one, plural, noun, item);
        if (has_kinds(noun.text) && !predicate_) {
            right(Branch::made_plural, plural, Number::plural, item);
        } else {
            wrong(Branch::bare_or_the, plural, noun, item);
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
            if (describes_alone(noun, policy) || (adjectives && policy == ArticlePolicy::bare)) {
                writer.add_arc(node_of(Branch::name), to, place, arc);
                continue;
            }
            if (adjectives) {  // of "the red one" neither several nor stuff
                arc.number = Number::singular;
                const bool an = indefinite_article(noun.text) == "an";
                writer.add_arc(node_of(an ? Branch::with_an : Branch::with_a), to, place, arc);
                continue;
            }
            const Branch branch = branch_of(noun, policy);
            writer.add_arc(node_of(branch), to, place, arc);
            other_number.add(noun, static_cast<int>(i), branch);
        }
    }
}

}  // namespace fulcrum::dialogue
