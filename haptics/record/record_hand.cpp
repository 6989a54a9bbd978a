// Another hand of a record, as a record of it alone. See record.h.
#include "haptics/record/record.h"

#include <algorithm>

namespace fulcrum {

std::string fact_prefix(std::size_t hand) {
    return "hand " + std::to_string(hand + 1) + ".";
}

RecordHeader header_of_hand(const RecordHeader& header, std::size_t hand) {
    const RecordHand& told = header.more_hands[hand - 1];
    RecordHeader alone = header;
    alone.more_hands.clear();
    alone.max_force_N = told.max_force_N;
    alone.max_torque_Nm = told.max_torque_Nm;
    alone.effects = told.effects;
    // Its own facts stand for the first one's of that name.
    const std::string prefix = fact_prefix(hand);
    for (const RecordFact& own : header.facts) {
        if (!own.name.starts_with(prefix)) {
            continue;
        }
        const std::string name = own.name.substr(prefix.size());
        const auto first = std::ranges::find(alone.facts, name, &RecordFact::name);
        if (first != alone.facts.end()) {
            first->value = own.value;
        }
    }
    std::erase_if(alone.facts,
                  [](const RecordFact& fact) { return fact.name.starts_with("hand "); });
    return alone;
}

std::optional<Record> find_hand(const Record& record, std::size_t hand) {
    if (hand == 0 || hand > record.more_hands.size()) {
        return std::nullopt;
    }
    Record alone;
    static_cast<RecordRounds&>(alone) = record.more_hands[hand - 1];
    alone.header = header_of_hand(record.header, hand);
    alone.version = record.version;
    alone.cut_off = record.cut_off;
    return alone;
}

}  // namespace fulcrum
