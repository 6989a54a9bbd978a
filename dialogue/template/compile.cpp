#include "dialogue/template/compile.h"

#include "dialogue/english/letters.h"
#include "dialogue/english/variant.h"
#include "dialogue/template/graph_builder.h"
#include "dialogue/template/place_answers.h"
#include "dialogue/template/short_answers.h"
#include "dialogue/template/tail_answers.h"
#include "dialogue/template/tokens.h"
#include "dialogue/template/turned_order.h"
#include "dialogue/template/variants.h"

#include <algorithm>
#include <array>
#include <string_view>

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
    // A word of a list is what the lesson is told: what could be several words is for the sentence around it.
    if (const std::size_t sign = entry.find_first_of("[](){}<>;\\"); sign != std::string::npos) {
        const char* const what_to_do =
            "\"; a list holds plain words, with | between two ways to say one, so write the rest "
            "in the sentence";
        return fail(
            concat({"the entry \"", entry, "\" has \"", std::string(1, entry[sign]), what_to_do}));
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
        // The other spelling is as right as this one.
        if (const std::string other = other_spelling(noun.text); !other.empty()) {
            item.spoken.push_back(noun);
            noun.text = other;
        }
        item.spoken.push_back(std::move(noun));
        if (bar == rest.size()) {
            return item;
        }
        rest.remove_prefix(bar + 1);
    }
}

/// Materials that things are told apart by.
constexpr std::array<std::string_view, 26> kMaterials = {
    "metal",  "wood", "plastic", "glass",  "rubber", "paper",  "stone",    "rock",     "steel",
    "iron",   "gold", "silver",  "copper", "cotton", "wool",   "leather",  "clay",     "brick",
    "marble", "silk", "cork",    "tin",    "brass",  "bronze", "concrete", "cardboard"};

/// "Metal" of a metal block, "wood" of a wooden one; empty for what is no material.
std::string material_of(const std::string& attribute) {
    const std::string material = attribute == "wooden"    ? "wood"
                                 : attribute == "woollen" ? "wool"
                                                          : attribute;
    return std::ranges::find(kMaterials, material) == kMaterials.end() ? std::string() : material;
}

/// "Metal" of "metal block": what a block may be told apart by; "" where it is no such noun.
std::string attribute_of(const Noun& noun) {
    const std::size_t space = noun.text.rfind(' ');
    const std::string before = noun.text.substr(0, space == std::string::npos ? 0 : space);
    const bool counts = noun.noun_class == NounClass::count && noun.number() == Number::singular;
    const bool told =
        describes(before) || is_mass_noun(before) || !material_of(lower_case(before)).empty();
    return counts && told && !noun.text.ends_with(" one") ? before : std::string();
}

/// "The block of metal", "the wood block": the same thing, told by its material in other words; "the block made of metal" where making is
/// not what is asked for.
void add_of_material(std::vector<Noun>& spoken, const std::string& attribute,
                     const std::string& head, bool tells_by_making) {
    const std::string material = material_of(lower_case(attribute));
    if (material.empty()) {
        return;
    }
    std::vector<std::string> names = {concat({head, " of ", material})};
    if (tells_by_making) {
        names.push_back(concat({head, " made of ", material}));
        names.push_back(concat({"one made of ", material}));
    }
    if (material != attribute) {
        names.push_back(concat({material, " ", head}));
        names.push_back(concat({material, " one"}));
    }
    for (const std::string& name : names) {
        const bool said = std::ranges::find(spoken, name, &Noun::text) != spoken.end();
        if (!said) {
            spoken.push_back({name, NounClass::count});
        }
    }
}

/// "The metal one" for "the metal block", where no other entry is of metal and the author has no words of that kind.
void add_ones(WordList& list, bool tells_by_making) {
    std::vector<std::string> attributes;
    for (const ListItem& item : list.items) {
        attributes.push_back(attribute_of(item.spoken.front()));
    }
    for (std::size_t i = 0; i < list.items.size(); ++i) {
        std::vector<Noun>& spoken = list.items[i].spoken;
        const bool said = std::any_of(spoken.begin(), spoken.end(),
                                      [](const Noun& noun) { return noun.text.ends_with(" one"); });
        const bool one_of_its_kind =
            std::count(attributes.begin(), attributes.end(), attributes[i]) == 1;
        if (attributes[i].empty() || !one_of_its_kind) {
            continue;
        }
        if (!said) {
            spoken.push_back(understand_noun(attributes[i] + " one"));
        }
        const std::string& whole = spoken.front().text;
        add_of_material(spoken, attributes[i], whole.substr(attributes[i].size() + 1),
                        tells_by_making);
    }
}

/// A list of what things are made of.
bool has_materials(const WordList& list) {
    return std::ranges::any_of(list.items, [](const ListItem& item) {
        return !material_of(lower_case(item.value)).empty();
    });
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
            const bool is_there =
                std::any_of(list.items.begin(), list.items.end(),
                            [&](const ListItem& other) { return other.value == item->value; });
            if (is_there) {
                return fail(where + ": \"" + item->value + "\" stands in it twice; take one out");
            }
            list.items.push_back(std::move(*item));
        }
        result.push_back(std::move(list));
    }
    const bool tells_by_making = std::ranges::none_of(result, has_materials);
    for (WordList& list : result) {
        add_ones(list, tells_by_making);
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

/// Number `i`, or 0 where all are about one thing.
int subject_of(const std::vector<int>& subjects, std::size_t i) {
    return i < subjects.size() ? subjects[i] : 0;
}

/// The answers about `subject` that have a place for all that `graph` means.
std::vector<int> said_rightly(const TemplateSet& set, const Graph& graph,
                              const std::vector<int>& subjects, int subject) {
    std::vector<int> answers;
    for (int i = 0; i < set.answers; ++i) {
        const Graph& answer = set.graphs[static_cast<std::size_t>(i)];
        const bool fits =
            (graph.slots & ~answer.slots) == 0 && (answer.required & ~graph.required) == 0;
        if (fits && subject_of(subjects, static_cast<std::size_t>(i)) == subject) {
            answers.push_back(i);
        }
    }
    return answers;
}

Expected<bool> add_nearly(TemplateSet& set, const ParsedRules& rules,
                          const TemplateSource& source) {
    for (std::size_t i = 0; i < source.nearly.size(); ++i) {
        const std::string where = "nearly " + std::to_string(i + 1);
        auto sentence = build_sentence(set, rules, source.nearly[i]);
        if (!sentence) {
            return within(where, sentence.error());
        }
        Graph& graph = sentence->graph;
        graph.answers =
            said_rightly(set, graph, source.subjects, subject_of(source.nearly_subjects, i));
        if (graph.answers.empty()) {
            return fail(where +
                        ": no answer says the same rightly; give one with the same {slots}");
        }
        graph.answer = graph.answers.front();
        graph.nearly = true;
        graph.whole_sentence = false;
        set.graphs.push_back(std::move(graph));
    }
    return true;
}

}  // namespace

Expected<TemplateSet> compile_templates(const TemplateSource& source) {
    if (source.sentences.empty() || source.sentences.size() > kMostSentences) {
        return fail(concat(
            {"a question needs between 1 and ", std::to_string(kMostSentences), " answers"}));
    }
    if (source.nearly.size() > kMostSentences) {
        return fail(concat({"a question has at most ", std::to_string(kMostSentences),
                            " sentences under nearly"}));
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
    std::vector<FormSlots> forms;
    for (std::size_t i = 0; i < source.sentences.size(); ++i) {
        auto sentence = build_sentence(set, *rules, source.sentences[i], SubjectNumber::unknown,
                                       WordOrder::verb_last_too);
        if (!sentence) {
            return within("answer " + std::to_string(i + 1), sentence.error());
        }
        sentence->graph.answer = static_cast<int>(i);
        set.graphs.push_back(std::move(sentence->graph));
        forms.push_back(std::move(sentence->forms));
    }
    set.answers = static_cast<int>(set.graphs.size());

    if (const auto added = add_nearly(set, *rules, source); !added) {
        return tl::unexpected(added.error());
    }
    add_turned_order(set, *rules, source.sentences);
    if (const auto added = add_short_answers(set, *rules, forms); !added) {
        return within("short answers", added.error());
    }
    add_counted_answers(set, *rules, source.sentences);
    add_tail_answers(set, *rules, source.sentences);
    add_variants(set, *rules, source.sentences);
    add_place_answers(set, *rules, source.sentences);
    for (Graph& graph : set.graphs) {
        graph.says.assign(static_cast<std::size_t>(set.words.size()), false);
        for (const int word : graph.said) {
            graph.says[static_cast<std::size_t>(word)] = true;
        }
    }
    return set;
}

}  // namespace fulcrum::dialogue
