#include "dialogue/marking/meanings.h"

#include "dialogue/marking/mark_answer.h"
#include "dialogue/template/sentences.h"

#include <algorithm>
#include <set>
#include <utility>

namespace fulcrum::dialogue {
namespace {

constexpr std::size_t kMostSteps = 2000;  // of which many may mean the same

/// A place of an answer that a list fills.
struct Place {
    std::string name;
    const WordList* list = nullptr;
    std::size_t choices = 0;  ///< one more where it may be left out: that is the last
};

std::vector<Place> places_of(const TemplateSet& set, const Graph& graph) {
    std::vector<Place> places;
    for (std::size_t slot = 0; slot < set.slots.size(); ++slot) {
        const std::uint32_t bit = 1U << slot;
        if ((graph.slots & bit) != 0) {
            const WordList& list = set.lists[static_cast<std::size_t>(set.slot_lists[slot])];
            places.push_back({set.slots[slot], &list,
                              list.items.size() + ((graph.required & bit) != 0 ? 0 : 1)});
        }
    }
    return places;
}

/// Goes through the meanings of one answer.
class Walk {
  public:
    Walk(const Question& question, int graph, std::size_t most, Meanings& found)
        : question_(question),
          set_(*question.templates),
          graph_(graph),
          places_(places_of(set_, set_.graphs[static_cast<std::size_t>(graph)])),
          most_(most),
          found_(found) {}

    void run() {
        std::vector<std::size_t> choice(places_.size(), 0);
        add(choice);
        for (std::size_t place = 0; place < places_.size(); ++place) {
            for (; choice[place] < places_[place].choices; ++choice[place]) {
                add(choice);
            }
            choice[place] = 0;
        }
        // All others, counted up as the digits of a number are.
        std::size_t place = 0;
        std::size_t steps = 0;
        while (place < places_.size()) {
            if (found_.some.size() >= most_ || ++steps > kMostSteps) {
                found_.all = false;
                return;
            }
            add(choice);
            for (place = 0; place < places_.size() && ++choice[place] == places_[place].choices;
                 ++place) {
                choice[place] = 0;
            }
        }
    }

  private:
    void add(const std::vector<std::size_t>& choice) {
        Meaning meaning;
        for (std::size_t place = 0; place < places_.size(); ++place) {
            const auto& items = places_[place].list->items;
            if (choice[place] < items.size()) {
                meaning.slots.emplace_back(places_[place].name, items[choice[place]].value);
            }
        }
        // "near the {place}|far from the {other}": not all that has a list can be said together.
        meaning.said = render(canonical_pieces(set_, graph_, meaning.slots));
        Mark mark = mark_answer(question_, meaning.said);
        meaning.slots = std::move(mark.slots);
        if (mark.understood && mark.other_number.empty() && seen_.insert(meaning.slots).second) {
            found_.some.push_back(std::move(meaning));
        }
    }

    const Question& question_;
    const TemplateSet& set_;
    int graph_;
    std::vector<Place> places_;
    std::size_t most_;
    Meanings& found_;
    std::set<std::vector<std::pair<std::string, std::string>>> seen_;
};

}  // namespace

Meanings meanings_of(const Question& question, std::size_t most) {
    Meanings found;
    const TemplateSet& set = *question.templates;
    for (int graph = 0; std::cmp_less(graph, set.graphs.size()); ++graph) {
        const Graph& sentence = set.graphs[static_cast<std::size_t>(graph)];
        if (sentence.nearly || sentence.claim != Claim::same) {
            continue;  // means what its answer means, or another claim about the same
        }
        Meanings of_answer;
        Walk(question, graph, most, of_answer).run();
        found.all = found.all && of_answer.all;
        for (Meaning& meaning : of_answer.some) {
            const bool seen = std::ranges::any_of(
                found.some, [&](const Meaning& other) { return other.slots == meaning.slots; });
            if (!seen) {
                found.some.push_back(std::move(meaning));
            }
        }
    }
    return found;
}

}  // namespace fulcrum::dialogue
