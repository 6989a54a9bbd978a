#include "dialogue/template/variants.h"

#include "dialogue/template/short_answers.h"
#include "dialogue/template/variant_texts.h"

#include <algorithm>

namespace fulcrum::dialogue {

void add_variants(TemplateSet& set, const ParsedRules& rules,
                  const std::vector<std::string>& sentences) {
    std::vector<std::string> done;
    for (std::size_t i = 0; i < sentences.size(); ++i) {
        const std::size_t own = set.graphs[i].arcs.size();
        for (const Variant& variant : variants_of(set, rules, sentences[i])) {
            const bool has_room = arcs_left(set) > 3 * own;
            if (!has_room || std::ranges::find(done, variant.text) != done.end()) {
                continue;
            }
            done.push_back(variant.text);
            auto built = build_sentence(set, rules, variant.text);
            if (!built) {
                continue;
            }
            Graph& graph = built->graph;
            graph.answer = static_cast<int>(i);
            graph.claim = variant.claim;
            graph.short_answer = variant.is_short;
            const auto slot = std::ranges::find(set.slots, variant.about);
            graph.about =
                slot == set.slots.end() ? kNone : static_cast<int>(slot - set.slots.begin());
            set.graphs.push_back(std::move(graph));
        }
    }
}

}  // namespace fulcrum::dialogue
