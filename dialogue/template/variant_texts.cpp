#include "dialogue/template/variant_texts.h"

#include "dialogue/english/measure.h"
#include "dialogue/result.h"
#include "dialogue/template/sentence_parts.h"

#include <algorithm>
#include <array>
#include <string_view>
#include <utility>

namespace fulcrum::dialogue {
namespace {

/// What is compared, and the words around it.
struct Compared {
    std::string head, be, middle;  ///< "the {thing}", "is", "from the Sun"
    std::string plain, more;       ///< "(<adjective:heavy>)", "(<comparative:heavy>)"
    std::string first;             ///< "heavy"
    std::string weighs,
        not_weighs;     ///< " weighs ", " does not weigh "; empty where there is no such verb
    std::string about;  ///< the head's one slot; empty for none
    bool has_slot = false;
    bool asks_no_more = true;  ///< nothing else is to be chosen
    Measure measure;
    std::string others, other_subjects;  ///< behind "than", and as a subject
};

/// Makes what follows from one of the author's sentences.
class VariantMaker {
  public:
    VariantMaker(const SentenceParts& parts, const Syntax& syntax)
        : parts_(parts), syntax_(syntax) {}

    std::vector<Variant> make() {
        if (!parts_.is_plain_statement()) {
            return {};
        }
        for (std::size_t i = 0; i < parts_.size() && found_.empty(); ++i) {
            if (i > 0 && parts_.is_be(i)) {
                behind_is(i);
            } else if (parts_.form(i) == "made_of") {
                made_of(i);
            }
        }
        if (found_.empty()) {
            deny();
        }
        return std::move(found_);
    }

  private:
    void add(const std::vector<std::string_view>& texts) { found_.push_back({concat_all(texts)}); }
    void exclude(const std::string& about, const std::vector<std::string_view>& texts) {
        found_.push_back({concat_all(texts), Claim::excluded, about});
    }
    static std::string concat_all(const std::vector<std::string_view>& texts) {
        std::string all;
        for (const std::string_view text : texts) {
            all += text;
        }
        return all;
    }

    void behind_is(std::size_t verb) {
        const std::vector<std::string> compared = parts_.adjectives(verb + 1, "comparative");
        const bool the = parts_.is_word(verb + 1, "the");
        const std::vector<std::string> most =
            the ? parts_.adjectives(verb + 2, "superlative") : std::vector<std::string>{};
        if (!compared.empty()) {
            compare(verb, compared);
        } else if (!most.empty()) {
            exceed(verb, most);
        } else if (parts_.form(verb + 1) == "adjective" &&
                   parts_.slots(verb + 1, verb + 2).size() == 1) {
            describe(verb);
        }
    }

    [[nodiscard]] Compared compared(std::size_t verb, const std::vector<std::string>& words) const {
        Compared it;
        it.head = parts_.text(0, verb);
        it.be = parts_.be(verb);
        const std::vector<std::string> slots = parts_.slots(0, verb);
        it.has_slot = !slots.empty();
        it.about = slots.size() == 1 ? slots[0] : "";
        it.asks_no_more = slots.size() == (it.about.empty() ? 0U : 1U) &&
                          parts_.slots(verb, parts_.than_at(verb + 1)).empty();
        it.measure = words.size() == 1 ? measure_of(words[0]) : Measure{};
        it.first = words[0];
        for (const std::string& word : words) {
            it.plain += (it.plain.empty() ? "(" : "|") + concat({"<adjective:", word, ">"});
            it.more += (it.more.empty() ? "(" : "|") + concat({"<comparative:", word, ">"});
        }
        it.plain += ")";
        it.more += ")";
        const std::string noun = it.about.empty() ? "" : parts_.head_of(it.about);
        const std::string one = concat({"one|thing", noun.empty() ? "" : "|", noun});
        const std::string many = concat({"[(two|three)] (ones|things", noun.empty() ? "" : "|",
                                         noun.empty() ? "" : plural_of(noun), ")|two|three"});
        it.others =
            concat({"(the other [(", one, "|", many, ")]|the others|all the others|all others|",
                    "the rest|all the other (", many, ")|any other (", one, ")|everything else)"});
        it.other_subjects = concat({"[all] (the others|the other (", many, "))"});
        return it;
    }

    /// Settles the verb, for which nothing may stand between what is compared.
    static void find_verb(Compared& it) {
        if (!it.measure.more.empty() && it.middle.empty()) {
            it.weighs = it.be == "are" ? " weigh " : " weighs ";
            it.not_weighs = it.be == "are" ? " do not weigh " : " does not weigh ";
        }
    }

    /// "Heavier" of two.
    void compare(std::size_t verb, const std::vector<std::string>& words) {
        Compared it = compared(verb, words);
        const std::size_t end = parts_.size();
        const std::size_t than = parts_.than_at(verb + 2);
        it.middle = parts_.text(verb + 2, than);
        find_verb(it);
        const std::string behind = parts_.text(than, end);
        std::string other = behind;
        if (other.starts_with('[') && than + 1 == end) {
            other = other.substr(1, other.size() - 2);
        }
        other = other.starts_with("than ") ? other.substr(5) : std::string();
        const std::vector<std::string> others = parts_.slots(than, end);
        const bool swaps = !it.about.empty() && others.size() == 1 && !other.empty() &&
                           parts_.same_words(it.about, others[0]);
        say_otherwise(it, behind);
        deny_comparison(it, swaps ? std::string() : behind);
        if (swaps) {
            swap(it, other);
        }
        if (it.asks_no_more) {
            no_difference(it);
            if (swaps) {
                no_difference(it, other);
            }
        }
    }

    void say_otherwise(const Compared& it, const std::string& behind) {
        if (it.has_slot) {
            add({it.head, " ", it.be, " ", it.more, " ", it.middle, " than ", it.others});
        }
        if (!it.about.empty() && it.middle.empty()) {
            add({it.head, " ", it.be, " the ", it.more, " (one|of the two|one of the two)"});
            add({"the ", it.more, " one ", it.be, " ", it.head});
        }
        if (it.measure.is_felt && it.middle.empty()) {
            add({it.head, it.be == "are" ? " feel " : " feels ", it.more, " ", behind});
        }
        if (!it.weighs.empty()) {
            const std::string_view has = it.be == "are" ? " have " : " has ";
            const std::string more =
                concat({"[(much|a lot|a bit|a little|far|slightly)] ", it.measure.more});
            for (const std::string& said : {concat({it.head, it.weighs, more}),
                                            concat({it.head, has, more, " ", it.measure.noun})}) {
                add({said, " ", behind});
                add({said, " than ", it.others});
            }
        }
    }

    void deny_comparison(const Compared& it, const std::string& behind) {
        exclude(it.about,
                {it.head, " ", it.be, " not (", it.more, "|(as|so) ", it.plain, ") ", it.middle});
        if (it.has_slot) {
            exclude(it.about, {it.head, " ", it.be, " not (as|so) ", it.plain, " ", it.middle,
                               " as ", it.others});
            exclude(it.about,
                    {it.head, " ", it.be, " not ", it.more, " ", it.middle, " than ", it.others});
        }
        not_at_all(it);
        if (!behind.empty()) {
            exclude(it.about, {it.head, " ", it.be, " not ", it.more, " ", it.middle, " ", behind});
        }
        if (!it.weighs.empty()) {
            exclude(it.about, {it.head, it.not_weighs, "(", it.measure.more, "|as ",
                               it.measure.as_much, ")"});
        }
    }

    /// "The egg is not heavy" compares nothing, so of two things it doesn't say that the other one is heavier.
    void not_at_all(const Compared& it) {
        if (it.has_slot) {
            exclude("", {it.head, " ", it.be, " not ", it.plain, " ", it.middle});
        }
    }

    /// "The egg is not as heavy as the apple" says that the apple is heavier.
    void swap(const Compared& it, const std::string& other) {
        const std::string_view opposite = it.measure.opposite;
        add({other, " ", it.be, " not (as|so) ", it.plain, " ", it.middle, " as ", it.head});
        add({other, " ", it.be, " not ", it.more, " ", it.middle, " than ", it.head});
        add({other, " ", it.be, " less ", it.plain, " ", it.middle, " than ", it.head});
        if (!opposite.empty()) {
            add({it.head, " ", it.be, " not (as|so) <adjective:", opposite, "> ", it.middle, " as ",
                 other});
            add({it.head, " ", it.be, " not <comparative:", opposite, "> ", it.middle, " than ",
                 other});
        }
        if (!it.weighs.empty()) {
            add({other, it.not_weighs, "as ", it.measure.as_much, " as ", it.head});
            add({other, it.not_weighs, it.measure.more, " than ", it.head});
        }
    }

    /// "The heaviest" of several.
    void exceed(std::size_t verb, const std::vector<std::string>& words) {
        Compared it = compared(verb, words);
        const std::size_t end = parts_.size();
        std::size_t behind = verb + 3;
        behind += behind < end && is_optional_noun(syntax_, &parts_.part(behind)) ? 1 : 0;
        // "The nearest *to the Sun*"; "of all", "in our solar system" have no place in a comparison.
        const std::size_t first = behind;
        while (behind < end && !parts_.begins_with(behind, "of") &&
               !parts_.begins_with(behind, "in")) {
            ++behind;
        }
        it.middle = parts_.text(first, behind);
        find_verb(it);
        exclude(it.about, {it.head, " ", it.be, " not ", parts_.text(verb + 1, end)});
        add({it.head, " ", it.be, " by far ", parts_.text(verb + 1, end)});
        not_at_all(it);
        if (!it.about.empty()) {
            exceed_others(it);
        }
        if (it.asks_no_more && !it.about.empty()) {
            no_difference(it);
        }
    }

    void exceed_others(const Compared& it) {
        const std::string_view opposite = it.measure.opposite;
        add({it.head, " ", it.be, " ", it.more, " ", it.middle, " than ", it.others});
        add({it.other_subjects, " are not (as|so) ", it.plain, " ", it.middle, " as ", it.head});
        add({"(nothing|nothing else) is ", it.more, " ", it.middle, " than ", it.head});
        exclude(it.about, {it.head, " ", it.be, " not (as|so) ", it.plain, " ", it.middle, " as ",
                           it.others});
        exclude(it.about,
                {it.head, " ", it.be, " not ", it.more, " ", it.middle, " than ", it.others});
        if (!opposite.empty()) {
            add({it.head, " ", it.be, " the least <adjective:", opposite, "> ", it.middle});
            add({it.head, " ", it.be, " not (as|so) <adjective:", opposite, "> ", it.middle, " as ",
                 it.others});
            add({it.other_subjects, " are <comparative:", opposite, "> ", it.middle, " than ",
                 it.head});
        }
        if (it.weighs.empty()) {
            return;
        }
        const std::string most = concat({"[the] ", it.measure.most});
        add({it.head, it.weighs, most, " [of (all|them all|all of them|the three|the four)]"});
        add({it.head, it.weighs, it.measure.more, " than ", it.others});
        add({"the one that weighs ", most, " is ", it.head});
        exclude(it.about, {it.head, it.not_weighs, most});
        add({it.other_subjects, " do not weigh as ", it.measure.as_much, " as ", it.head});
    }

    [[nodiscard]] static std::string same_as(const Compared& it) {
        const bool measured = !it.measure.noun.empty();
        return concat({"(the same|equal|alike|identical|", measured ? "the same " : "",
                       it.measure.noun, measured ? "|" : "", "equally ", it.plain, "|as ", it.plain,
                       " as each other)"});
    }
    void none(const Compared& it, const std::vector<std::string_view>& texts,
              bool is_short = false) {
        found_.push_back({concat_all(texts), Claim::of_none, it.about, is_short});
    }

    /// "They weigh the same", "neither".
    void no_difference(const Compared& it) {
        const std::string they =
            "(they|both|both of them|the two|the two of them|they both|they all|all|all of them)";
        const std::string neither = "(neither|neither one|neither of them|none|none of them)";
        none(it, {they, " are [(both|all)] ", same_as(it)});
        none(it, {neither, " is (", it.more, "|the <superlative:", it.first, ">)"});
        none(it,
             {"(neither|neither one|neither of them|none|none of them|both|both of them|the same)"},
             true);
        none(it, {"(it is the same|there is no difference)"});
        if (!it.measure.noun.empty()) {
            none(it, {they, " have the same ", it.measure.noun});
        }
        if (!it.weighs.empty()) {
            none(it,
                 {they, " [(both|all)] weigh (the same|the same amount|as much as each other)"});
        }
    }

    void no_difference(const Compared& it, const std::string& other) {
        none(it, {it.head, " ", it.be, " as ", it.plain, " ", it.middle, " as ", other});
        none(it, {it.head, " and ", other, " are ", same_as(it)});
        if (!it.measure.noun.empty()) {
            none(it, {it.head, " has the same ", it.measure.noun, " as ", other});
            none(it, {it.head, " and ", other, " have the same ", it.measure.noun});
        }
        if (!it.weighs.empty()) {
            none(it, {it.head, it.weighs, "(the same|as much) as ", other});
            none(it, {it.head, " and ", other, " weigh the same"});
        }
    }

    /// "Metal is not soft."
    void describe(std::size_t verb) {
        const std::string feel = parts_.text(verb + 1, verb + 2);
        const std::string about = parts_.slots(verb + 1, verb + 2)[0];
        for (const std::string& head : {parts_.text(0, verb), std::string("(it|this|that)")}) {
            found_.push_back({concat({head, " ", parts_.be(verb), " not [very] ", feel}),
                              Claim::contrary, about});
        }
    }

    /// "It is not made of metal."
    void made_of(std::size_t i) {
        const std::vector<std::string> materials = parts_.slots(i, i + 1);
        if (materials.size() != 1 || materials[0].empty() || i + 1 != parts_.size()) {
            return;
        }
        const std::string form = parts_.text(i, i + 1);  // <made_of:{material}>
        const std::size_t colon = form.find(':');
        const std::string material = form.substr(colon + 1, form.size() - colon - 2);
        if (i > 0) {
            exclude(materials[0], {parts_.text(0, i), " is not [made of] ", material});
        }
        exclude(materials[0], {"(it|this|that) is not [made of] ", material});
        found_.push_back({"not " + material, Claim::excluded, materials[0], true});
    }

    /// "Not" behind the sentence's own verb, where it leaves something to be chosen.
    void deny() {
        const std::vector<std::string> chosen = parts_.slots(0, parts_.size());
        std::size_t at = std::string::npos;
        for (const SyntaxNode& node : syntax_) {
            constexpr std::array<std::string_view, 4> kVerbs = {"is", "are", "should", "must"};
            if (node.kind == SyntaxNode::Kind::word &&
                std::ranges::find(kVerbs, node.text) != kVerbs.end()) {
                at = std::min(at, static_cast<std::size_t>(node.column) - 1);
            }
        }
        const std::string about = chosen.size() == 1 ? chosen[0] : "";
        if (at != std::string::npos && at > 0 && !chosen.empty()) {
            const std::string denied = parts_.denied(at);
            if (denied.find("there is not ") != std::string::npos) {
                return;  // of one thing "there is no", of which no sentence is made here
            }
            exclude(about, {denied});
            // "Not the egg."
            constexpr std::string_view kIsNot = "it is not ";
            if (denied.starts_with(kIsNot)) {
                found_.push_back({denied.substr(kIsNot.size() - 4), Claim::excluded, about, true});
            }
        } else if (at == std::string::npos && !chosen.empty()) {
            deny_deed(about);
        }
    }

    /// "It does not pull it down", "they do not weigh four newtons."
    void deny_deed(const std::string& about) {
        for (std::size_t i = 1; i < parts_.size(); ++i) {
            VerbForms forms;
            const SyntaxNode& word = parts_.part(i);
            if (word.kind == SyntaxNode::Kind::word && understand_verb(word.text, forms) &&
                !forms.is_be) {
                exclude(about, {parts_.text(0, i), word.text == forms.singular ? " does" : " do",
                                " not ", forms.plural, " ", parts_.text(i + 1, parts_.size())});
                return;
            }
        }
        // "Not at the top."
        if (parts_.part(0).kind == SyntaxNode::Kind::word && is_preposition(parts_.part(0).text)) {
            found_.push_back(
                {"not " + parts_.text(0, parts_.size()), Claim::excluded, about, true});
        }
    }

    const SentenceParts& parts_;
    const Syntax& syntax_;
    std::vector<Variant> found_;
};

}  // namespace

std::vector<Variant> variants_of(const TemplateSet& set, const ParsedRules& rules,
                                 const std::string& text) {
    const auto syntax = parse_template(text);
    if (!syntax) {
        return {};
    }
    const SentenceParts parts(set, rules, text, *syntax);
    return VariantMaker(parts, *syntax).make();
}

}  // namespace fulcrum::dialogue
