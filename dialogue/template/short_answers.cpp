#include "dialogue/template/short_answers.h"

#include "dialogue/template/phrases.h"
#include "dialogue/template/word_order.h"

#include <algorithm>
#include <bit>

namespace fulcrum::dialogue {
namespace {

constexpr std::size_t kMostGraphSlots = 32;  // bits of `Graph::slots`

tl::unexpected<Error> too_large() {
    return fail(concat({"the templates grow beyond ", std::to_string(kLargestGraph_arcs),
                        " arcs; shorten rules or lists"}));
}

std::uint32_t bit_of(int slot) {
    return slot == kNone ? 0U : 1U << static_cast<unsigned>(slot);
}

/// Adds the short answers of one sentence.
class ShortAnswers {
  public:
    ShortAnswers(TemplateSet& set, const ParsedRules& rules, int sentence, SubjectNumber subject)
        : set_(set), rules_(rules), sentence_(sentence), subject_(subject) {}

    /// "The watermelon." and "It is the watermelon."
    Expected<bool> of_noun(int slot) {
        const bool definite = (graph().definite & bit_of(slot)) != 0;
        const bool describing = describes_things(slot);
        const auto bare =
            noun_alone(slot, describing ? ArticlePolicy::bare : ArticlePolicy::short_answer, true);
        if (bare && describing) {  // "it is blue", and not "it is the blue"
            return add(concat({"(it|this|that) is ", reference(slot)}), false);
        }
        return bare ? add(concat({"(it|this|that) is ", definite ? "the " : "<article> ",
                                  reference(slot)}),
                          true)
                    : bare;
    }

    /// "Metal." "It is metal." "It is made of metal." "Made of metal."
    Expected<bool> of_material(int slot) {
        const auto bare = noun_alone(slot, ArticlePolicy::bare, says_it_all(bit_of(slot)));
        if (!bare) {
            return bare;
        }
        for (const std::string& text : {concat({"<it> <made_of:", reference(slot), ">"}),
                                        concat({"<it> is ", reference(slot)})}) {
            if (const auto added = add(text, true); !added) {
                return added;
            }
        }
        return of_alone(slot);
    }

    /// "Hard." "Hard and smooth." "It feels hard and smooth."
    Expected<bool> of_adjectives(const std::vector<int>& slots) {
        std::string phrase;
        std::string closing;
        std::uint32_t bits = 0;
        for (const int slot : slots) {
            const bool required = (graph().required & bit_of(slot)) != 0;
            phrase += concat({phrase.empty() ? ""
                              : required     ? " and "
                                             : " [and ",
                              "<adjective:", reference(slot), ">"});
            closing += required || bits == 0 ? "" : "]";
            bits |= bit_of(slot);
        }
        phrase += closing;
        const auto bare = add(phrase, !says_it_all(bits));
        return bare ? add(concat({"<it> (is|feels) ", phrase}), true) : bare;
    }

  private:
    [[nodiscard]] const Graph& graph() const {
        return set_.graphs[static_cast<std::size_t>(sentence_)];
    }
    /// True when nothing but `slots` is needed for the whole sentence, so that a recast can complete it.
    [[nodiscard]] bool says_it_all(std::uint32_t slots) const {
        return (graph().required & ~slots) == 0;
    }
    /// {list:slot}
    [[nodiscard]] std::string reference(int slot) const {
        const auto number = static_cast<std::size_t>(slot);
        const WordList& list = set_.lists[static_cast<std::size_t>(set_.slot_lists[number])];
        return concat({"{", list.name, ":", set_.slots[number], "}"});
    }

    /// A list of adjectives, "blue", "heavy", which a noun of the sentence follows.
    [[nodiscard]] bool describes_things(int slot) const {
        const auto number = static_cast<std::size_t>(slot);
        const WordList& list = set_.lists[static_cast<std::size_t>(set_.slot_lists[number])];
        return all_describe(list);
    }

    Expected<bool> noun_alone(int slot, ArticlePolicy policy, bool completed) {
        const auto number = static_cast<std::size_t>(slot);
        const WordList& list = set_.lists[static_cast<std::size_t>(set_.slot_lists[number])];
        ArcWriter writer(set_, arcs_left(set_));
        const int start = writer.add_node();
        const int end = writer.add_node();
        add_noun_phrase(writer, list, slot, policy, start, end);
        if (writer.full()) {
            return too_large();
        }
        Graph bare = writer.finish(start, end);
        bare.slots = bare.required = bit_of(slot);
        keep(std::move(bare), !completed);
        return true;
    }

    /// "[made] of metal": with the same errors at the material as the whole sentence has.
    Expected<bool> of_alone(int slot) {
        const auto number = static_cast<std::size_t>(slot);
        const WordList& list = set_.lists[static_cast<std::size_t>(set_.slot_lists[number])];
        ArcWriter writer(set_, arcs_left(set_));
        const int start = writer.add_node();
        const int made = writer.add_node();
        const int of = writer.add_node();
        const int end = writer.add_node();
        writer.join(start, made);
        add_word(writer, "made", "made", {}, start, made);
        add_word(writer, "of", "of", {}, made, of);
        add_material(writer, list, slot, of, end);
        if (writer.full()) {
            return too_large();
        }
        Graph alone = writer.finish(start, end);
        alone.slots = alone.required = bit_of(slot);
        keep(std::move(alone), true);
        return true;
    }

    Expected<bool> add(const std::string& text, bool whole) {
        auto sentence = build_sentence(set_, rules_, text, subject_);
        if (!sentence) {
            return tl::unexpected(sentence.error());
        }
        keep(std::move(sentence->graph), whole);
        return true;
    }

    void keep(Graph graph, bool whole) {
        graph.short_answer = true;
        graph.whole_sentence = whole;
        graph.answer = sentence_;
        set_.graphs.push_back(std::move(graph));
    }

    TemplateSet& set_;
    const ParsedRules& rules_;
    int sentence_;
    SubjectNumber subject_;
};

/// The number of what is made: of all that a list has, or of the template's own words.
SubjectNumber number_of_subject(const TemplateSet& set, const FormSlots& forms) {
    if (forms.material == kNone || forms.things == kNone) {
        return forms.subject;
    }
    const auto slot = static_cast<std::size_t>(forms.things);
    const WordList& list = set.lists[static_cast<std::size_t>(set.slot_lists[slot])];
    std::size_t plurals = 0;
    for (const ListItem& item : list.items) {
        plurals += item.spoken.front().number() == Number::plural ? 1 : 0;
    }
    return plurals == 0                   ? SubjectNumber::singular
           : plurals == list.items.size() ? SubjectNumber::plural
                                          : SubjectNumber::unknown;
}

/// A slot of the same name as `slot` that is filled from another list; kNone when there is no room.
int twin_slot(TemplateSet& set, int slot, int list) {
    if (set.slots.size() >= kMostGraphSlots) {
        return kNone;
    }
    set.slots.push_back(set.slots[static_cast<std::size_t>(slot)]);
    set.slot_lists.push_back(list);
    return static_cast<int>(set.slots.size()) - 1;
}

/// "Metal is made of a spaceship.": the words for both are known, so it is understood for what it says.
Expected<bool> add_turned_round(TemplateSet& set, int sentence, const FormSlots& forms) {
    const int things = set.slot_lists[static_cast<std::size_t>(forms.things)];
    const int materials = set.slot_lists[static_cast<std::size_t>(forms.material)];
    if (things == materials) {
        return true;
    }
    const int subject = twin_slot(set, forms.things, materials);
    const int object = twin_slot(set, forms.material, things);
    if (object == kNone) {
        return true;
    }
    ArcWriter writer(set, arcs_left(set));
    const int start = writer.add_node();
    const int verb = writer.add_node();
    const int end = writer.add_node();
    add_noun_phrase(writer, set.lists[static_cast<std::size_t>(materials)], subject,
                    ArticlePolicy::bare, start, verb);
    const int preposition = add_made_of(writer, {.after_list = true}, Making::whole, verb);
    add_noun_phrase(writer, set.lists[static_cast<std::size_t>(things)], object,
                    ArticlePolicy::indefinite, preposition, end);
    if (writer.full()) {
        return too_large();
    }
    Graph graph = writer.finish(start, end);
    graph.slots = graph.required = bit_of(subject) | bit_of(object);
    graph.turned_round = true;
    graph.answer = sentence;
    set.graphs.push_back(std::move(graph));
    return true;
}

/// The slots for which short answers of `graph` are worth having; they depend on what it teaches.
std::uint32_t asked_slots(const Graph& graph, const FormSlots& forms) {
    if (forms.material != kNone) {
        return bit_of(forms.material) & graph.required;
    }
    if (!forms.adjectives.empty()) {
        return bit_of(forms.adjectives[0]) & graph.required;
    }
    return std::popcount(graph.required) == 1 ? graph.required : 0;
}

}  // namespace

std::size_t arcs_left(const TemplateSet& set) {
    std::size_t used = 0;
    for (const Graph& graph : set.graphs) {
        used += graph.arcs.size();
    }
    return kLargestGraph_arcs - std::min(used, kLargestGraph_arcs);
}

bool may_be_empty(const Graph& graph) {
    std::vector<bool> reached(static_cast<std::size_t>(graph.nodes()), false);
    reached[0] = true;
    for (const Arc& arc : graph.arcs) {
        if (arc.word_count == 0 && arc.code == ErrorCode::none &&
            reached[static_cast<std::size_t>(arc.from)]) {
            reached[static_cast<std::size_t>(arc.to)] = true;
        }
    }
    return reached.back();
}

Expected<BuiltSentence> build_sentence(TemplateSet& set, const ParsedRules& rules,
                                       const std::string& text, SubjectNumber pronoun,
                                       WordOrder order) {
    const auto syntax = parse_template(text);
    if (!syntax) {
        return tl::unexpected(syntax.error());
    }
    ArcWriter writer(set, arcs_left(set));
    const int start = writer.add_node();
    GraphBuilder builder(set, writer, rules, pronoun);
    const auto built = builder.build(*syntax, start);
    if (!built) {
        return tl::unexpected(built.error());
    }
    if (writer.full()) {
        return too_large();
    }
    const int end = writer.add_node();
    writer.join(built->to, end);
    if (order == WordOrder::verb_last_too) {
        add_verb_last(writer, start, end);
    }
    BuiltSentence sentence{writer.finish(start, end), builder.form_slots()};
    sentence.graph.slots = built->slots;
    sentence.graph.required = built->required;
    sentence.graph.definite = built->definite;
    if (may_be_empty(sentence.graph)) {
        return fail("the sentence may be empty; keep at least one word outside [ ]", 1);
    }
    return sentence;
}

Expected<bool> add_short_answers(TemplateSet& set, const ParsedRules& rules,
                                 const std::vector<FormSlots>& forms) {
    // For the first sentence of each slot that is asked for.
    std::uint32_t done = 0;
    for (int i = 0; i < set.answers; ++i) {
        const FormSlots& own = forms[static_cast<std::size_t>(i)];
        const std::uint32_t asked = asked_slots(set.graphs[static_cast<std::size_t>(i)], own);
        if (asked == 0 || (done & asked) != 0) {
            continue;
        }
        done |= asked;
        ShortAnswers answers(set, rules, i, number_of_subject(set, own));
        const auto added = own.material != kNone     ? answers.of_material(own.material)
                           : !own.adjectives.empty() ? answers.of_adjectives(own.adjectives)
                                                     : answers.of_noun(std::countr_zero(asked));
        if (!added) {
            return added;
        }
    }
    for (int i = 0; i < set.answers; ++i) {
        const FormSlots& own = forms[static_cast<std::size_t>(i)];
        if (own.material != kNone && own.things != kNone) {
            if (const auto added = add_turned_round(set, i, own); !added) {
                return added;
            }
        }
    }
    return true;
}

void add_counted_answers(TemplateSet& set, const ParsedRules& rules,
                         const std::vector<std::string>& sentences) {
    for (std::size_t i = 0; i < sentences.size(); ++i) {
        const std::string_view sentence = sentences[i];
        for (const std::string_view head :
             {"there are ", "there is ", "there (is|are) ", "there (are|is) "}) {
            const std::string tail(sentence.starts_with(head) ? sentence.substr(head.size()) : "");
            const bool is_said =
                std::find(sentences.begin(), sentences.end(), tail) != sentences.end();
            if (tail.find("<plural:") == std::string::npos || is_said ||
                arcs_left(set) <= 2 * set.graphs[i].arcs.size()) {
                continue;
            }
            if (auto counted = build_sentence(set, rules, tail)) {
                counted->graph.short_answer = true;
                counted->graph.whole_sentence = false;
                counted->graph.answer = static_cast<int>(i);
                set.graphs.push_back(std::move(counted->graph));
            }
        }
    }
}

}  // namespace fulcrum::dialogue
