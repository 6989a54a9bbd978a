#include "dialogue/marking/readings.h"

#include "dialogue/marking/other_degree.h"

#include <algorithm>

namespace fulcrum::dialogue {
namespace {

Slots with_value(Slots slots, const std::string& slot, const std::string& value) {
    const auto found = std::ranges::find(slots, slot, &Slots::value_type::first);
    if (found == slots.end()) {
        slots.emplace_back(slot, value);
    } else {
        found->second = value;
    }
    return slots;
}

/// The same of another thing. Where that one was said to be what it is compared with, the two change places: nothing is heavier than itself,
/// and "the egg is as heavy as the apple" is not true because of that.
Slots of_another(const Mark& mark, const std::string& slot, const std::string& value) {
    Slots reading = with_value(mark.slots, slot, value);
    const std::string said(mark.slot(slot));
    for (auto& [name, filled] : reading) {
        if (name != slot && filled == value && !said.empty()) {
            filled = said;
        }
    }
    return reading;
}

/// Not the one of two is the other: then as much is said as with that.
bool say_the_other(const Question& question, const WordList& list, const std::string& slot,
                   Mark& mark) {
    const std::vector<std::string> two = asked_between(question, list);
    const std::string said(mark.slot(slot));
    if (two.empty() || std::ranges::find(two, said) == two.end()) {
        return false;
    }
    mark.slots = with_value(mark.slots, slot, two[0] == said ? two[1] : two[0]);
    return true;
}

/// All that is said is right and all that is ruled out is wrong. Where something of it is right and something else isn't, "one, the Moon",
/// that need not be meant as an answer too: nobody understands it; a reason always is. The lesson is told what is wrong.
bool settle_every(Mark& mark, const std::vector<bool>& verdicts) {
    const auto is_right = [&](std::size_t i) { return i < verdicts.size() && verdicts[i]; };
    bool any_right = false;
    bool all_right = true;
    bool denies_right = verdicts.size() < mark.readings.size();
    for (std::size_t i = 0; i < mark.readings.size(); ++i) {
        if (mark.denied[i]) {
            denies_right = denies_right || is_right(i);
            continue;
        }
        if (!is_right(i) && all_right) {
            mark.slots = mark.readings[i];
        }
        any_right = any_right || is_right(i);
        all_right = all_right && is_right(i);
    }
    mark.understood = all_right || !any_right || mark.claim == Claim::reasoned;
    return all_right && !denies_right;
}

}  // namespace

void find_readings(const Question& question, const Graph& graph, Mark& mark) {
    mark.claim = graph.claim;
    if (graph.claim == Claim::same) {
        return;
    }
    if (graph.about == kNone) {
        mark.readings = {mark.slots};
        return;
    }
    const TemplateSet& set = *question.templates;
    const auto about = static_cast<std::size_t>(graph.about);
    const std::string& slot = set.slots[about];
    const WordList& list = set.lists[static_cast<std::size_t>(set.slot_lists[about])];
    if (graph.claim == Claim::excluded) {
        mark.readings = {mark.slots};
        if (say_the_other(question, list, slot, mark)) {
            mark.claim = Claim::same;
            mark.readings.clear();
        }
        return;
    }
    if (graph.claim == Claim::contrary) {
        mark.readings = {mark.slots};
    }
    for (std::size_t i = 0; i < list.items.size() && mark.readings.size() < kMostReadings; ++i) {
        const std::string& value = list.items[i].value;
        Slots reading = graph.claim == Claim::of_none ? of_another(mark, slot, value)
                                                      : with_value(mark.slots, slot, value);
        if (graph.claim != Claim::contrary || reading != mark.slots) {
            mark.readings.push_back(std::move(reading));
        }
    }
}

std::vector<Slots> readings_of(const Mark& mark) {
    return mark.readings.empty() ? std::vector<Slots>{mark.slots} : mark.readings;
}

namespace {

/// What is claimed is true.
bool holds(Mark& mark, const std::vector<bool>& verdicts) {
    const bool first = !verdicts.empty() && verdicts.front();
    const bool any = std::ranges::find(verdicts, true) != verdicts.end();
    if (mark.claim == Claim::same) {
        return first;
    }
    if (mark.claim == Claim::excluded) {
        return !first;
    }
    if (mark.claim == Claim::every || mark.claim == Claim::reasoned) {
        return settle_every(mark, verdicts);
    }
    if (mark.claim == Claim::contrary) {  // of something of which there is something to say
        return !first && any;
    }
    const bool wanted = mark.claim == Claim::of_any && any;
    const auto told = std::ranges::find(verdicts, wanted);
    const auto at = static_cast<std::size_t>(told - verdicts.begin());
    mark.slots = mark.readings[at < mark.readings.size() ? at : 0];
    return mark.claim == Claim::of_any ? any : !any;
}

}  // namespace

bool settle(Mark& mark, const std::vector<bool>& verdicts) {
    const bool is_true = holds(mark, verdicts);
    if (!is_true || mark.claim == Claim::excluded) {
        excuse_other_degree(mark);  // it is no answer, so the question's form need not be meant
    }
    return is_true;
}

}  // namespace fulcrum::dialogue
