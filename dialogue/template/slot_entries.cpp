#include "dialogue/template/slot_entries.h"

#include <algorithm>
#include <cstddef>

namespace fulcrum::dialogue {
namespace {

const std::vector<ListItem>& entries_of(const TemplateSet& set, std::size_t slot) {
    return set.lists[static_cast<std::size_t>(set.slot_lists[slot])].items;
}

/// Another slot that is settled says what entry `item` of `slot` does; {thing} and {other} are two lists of the same words.
bool is_said_already(const TemplateSet& set, const std::vector<bool>& settled,
                     const std::vector<int>& wanted, std::size_t slot, int item) {
    const auto value = [&](std::size_t of, int entry) -> const std::string& {
        return entries_of(set, of)[static_cast<std::size_t>(entry)].value;
    };
    for (std::size_t other = 0; other < wanted.size(); ++other) {
        if (other != slot && settled[other] && value(other, wanted[other]) == value(slot, item)) {
            return true;
        }
    }
    return false;
}

}  // namespace

std::vector<int> wanted_entries(const TemplateSet& set,
                                const std::vector<std::pair<std::string, std::string>>& slots) {
    std::vector<int> wanted(set.slots.size(), 0);
    std::vector<bool> settled(set.slots.size(), false);
    for (const auto& [name, value] : slots) {
        const auto slot = std::find(set.slots.begin(), set.slots.end(), name);
        if (slot == set.slots.end()) {
            continue;
        }
        const auto number = static_cast<std::size_t>(slot - set.slots.begin());
        const auto& items = entries_of(set, number);
        const auto found =
            std::find_if(items.begin(), items.end(),
                         [&, &text = value](const ListItem& item) { return item.value == text; });
        if (found != items.end()) {
            wanted[number] = static_cast<int>(found - items.begin());
            settled[number] = true;
        }
    }
    for (std::size_t slot = 0; slot < wanted.size(); ++slot) {
        const int n = static_cast<int>(entries_of(set, slot).size());
        for (int item = 0; item < n && !settled[slot]; ++item) {
            if (!is_said_already(set, settled, wanted, slot, item)) {
                wanted[slot] = item;
                settled[slot] = true;
            }
        }
        settled[slot] = true;
    }
    return wanted;
}

}  // namespace fulcrum::dialogue
