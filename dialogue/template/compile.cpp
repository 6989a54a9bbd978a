#include "dialogue/template/compile.h"

#include "dialogue/english/letters.h"
#include "dialogue/template/graph_builder.h"
#include "dialogue/template/tokens.h"

#include <algorithm>
#include <bit>

namespace fulcrum::dialogue {
namespace {

constexpr std::size_t kMostSentences = 64;
constexpr std::size_t kMostEntries = 1000;
constexpr std::size_t kLongestEntry_bytes = 80;

tl::unexpected<Error> within(const std::string& where, const Error& error) {
    return fail(where + ": " + error.message, error.column);
}

/// One entry of a list: the ways to say it stand apart by '|'.
Expected<ListItem> parse_item(const std::string& entry) {
    if (entry.size() > kLongestEntry_bytes) {
        return fail(concat({"an entry is longer than ", std::to_string(kLongestEntry_bytes),
                            " bytes; shorten it"}));
    }
    ListItem item;
    std::string_view rest = entry;
    while (true) {
        const std::size_t bar = std::min(rest.find('|'), rest.size());
        std::string_view spoken = rest.substr(0, bar);
        while (!spoken.empty() && spoken.front() == ' ') {
            spoken.remove_prefix(1);
        }
        while (!spoken.empty() && spoken.back() == ' ') {
            spoken.remove_suffix(1);
        }
        Noun noun = understand_noun(spoken);
        if (words_of(noun.text).empty()) {
            return fail("the entry \"" + entry + "\" has no word in it; write one or take it out");
        }
        if (item.spoken.empty()) {
            item.value = noun.text;
        }
        item.spoken.push_back(std::move(noun));
        if (bar == rest.size()) {
            return item;
        }
        rest.remove_prefix(bar + 1);
    }
}

Expected<std::vector<WordList>> parse_lists(const NamedLists& lists) {
    std::vector<WordList> result;
    std::size_t entries = 0;
    for (const auto& [name, texts] : lists) {
        const std::string where = "list \"" + name + "\"";
        const bool seen =
            std::any_of(result.begin(), result.end(),
                        [&, &wanted = name](const WordList& list) { return list.name == wanted; });
        if (seen || texts.empty()) {
            return fail(where +
                        (seen ? " is given twice; join the two" : " is empty; give it a word"));
        }
        entries += texts.size();
        if (entries > kMostEntries) {
            return fail(where + concat({": the lists have more than ", std::to_string(kMostEntries),
                                        " entries; shorten them"}));
        }
        WordList list{name, {}};
        for (const std::string& text : texts) {
            auto item = parse_item(text);
            if (!item) {
                return within(where, item.error());
            }
            list.items.push_back(std::move(*item));
        }
        result.push_back(std::move(list));
    }
    return result;
}

Expected<ParsedRules> parse_rules(const NamedTexts& rules) {
    ParsedRules result;
    for (const auto& [name, text] : rules) {
        auto syntax = parse_template(text);
        if (!syntax) {
            return within("rule <" + name + ">", syntax.error());
        }
        if (!result.emplace(name, std::move(*syntax)).second) {
            return fail("rule <" + name + "> is given twice; take one out");
        }
    }
    return result;
}

std::size_t arcs_left(const TemplateSet& set) {
    std::size_t used = 0;
    for (const Graph& graph : set.graphs) {
        used += graph.arcs.size();
    }
    return kLargestGraph_arcs - std::min(used, kLargestGraph_arcs);
}

/// True when a right sentence may have no word at all.
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

Expected<Graph> build_sentence(TemplateSet& set, const ParsedRules& rules,
                               const std::string& text) {
    const auto syntax = parse_template(text);
    if (!syntax) {
        return tl::unexpected(syntax.error());
    }
    ArcWriter writer(set, arcs_left(set));
    const int start = writer.add_node();
    const auto built = GraphBuilder(set, writer, rules).build(*syntax, start);
    if (!built) {
        return tl::unexpected(built.error());
    }
    if (writer.full()) {
        return fail(concat({"the templates grow beyond ", std::to_string(kLargestGraph_arcs),
                            " arcs; shorten rules or lists"}));
    }
    const int end = writer.add_node();
    writer.join(built->to, end);
    Graph graph = writer.finish(start, end);
    graph.slots = built->slots;
    graph.required = built->required;
    graph.definite = built->definite;
    if (may_be_empty(graph)) {
        return fail("the sentence may be empty; keep at least one word outside [ ]", 1);
    }
    return graph;
}

/// "The watermelon." and "It is the watermelon." for a sentence whose one required slot says it all.
Expected<bool> add_short_answers(TemplateSet& set, const ParsedRules& rules, int sentence,
                                 int slot) {
    const WordList& list =
        set.lists[static_cast<std::size_t>(set.slot_lists[static_cast<std::size_t>(slot)])];
    const std::uint32_t bit = 1U << static_cast<unsigned>(slot);
    ArcWriter writer(set, arcs_left(set));
    const int start = writer.add_node();
    const int end = writer.add_node();
    add_noun_phrase(writer, list, slot, ArticlePolicy::short_answer, start, end);
    if (writer.full()) {
        return fail(concat({"the templates grow beyond ", std::to_string(kLargestGraph_arcs),
                            " arcs; shorten rules or lists"}));
    }
    Graph bare = writer.finish(start, end);
    bare.slots = bare.required = bit;
    bare.short_answer = true;
    bare.whole_sentence = false;
    bare.answer = sentence;
    set.graphs.push_back(std::move(bare));

    const std::string name = set.slots[static_cast<std::size_t>(slot)];
    const bool definite = (set.graphs[static_cast<std::size_t>(sentence)].definite & bit) != 0;
    const std::string article = definite ? "the" : "<article>";
    auto it_is = build_sentence(
        set, rules, concat({"(it|this|that) is ", article, " {", list.name, ":", name, "}"}));
    if (!it_is) {
        return tl::unexpected(it_is.error());
    }
    it_is->short_answer = true;
    it_is->answer = sentence;
    set.graphs.push_back(std::move(*it_is));
    return true;
}

}  // namespace

Expected<TemplateSet> compile_templates(const TemplateSource& source) {
    if (source.sentences.empty() || source.sentences.size() > kMostSentences) {
        return fail(concat(
            {"a question needs between 1 and ", std::to_string(kMostSentences), " answers"}));
    }
    auto lists = parse_lists(source.lists);
    if (!lists) {
        return tl::unexpected(lists.error());
    }
    const auto rules = parse_rules(source.rules);
    if (!rules) {
        return tl::unexpected(rules.error());
    }
    TemplateSet set;
    set.lists = std::move(*lists);
    for (std::size_t i = 0; i < source.sentences.size(); ++i) {
        auto graph = build_sentence(set, *rules, source.sentences[i]);
        if (!graph) {
            return within("answer " + std::to_string(i + 1), graph.error());
        }
        graph->answer = static_cast<int>(i);
        set.graphs.push_back(std::move(*graph));
    }
    set.answers = static_cast<int>(set.graphs.size());

    // Short answers for the first sentence of each slot that alone is required.
    std::uint32_t done = 0;
    for (int i = 0; i < set.answers; ++i) {
        const std::uint32_t required = set.graphs[static_cast<std::size_t>(i)].required;
        if (std::popcount(required) != 1 || (done & required) != 0) {
            continue;
        }
        done |= required;
        if (const auto added = add_short_answers(set, *rules, i, std::countr_zero(required));
            !added) {
            return within("short answers", added.error());
        }
    }
    return set;
}

}  // namespace fulcrum::dialogue
