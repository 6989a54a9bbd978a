// Lists of words that a rule of English names one by one.
//
// Thread: pure functions.  Cost: one comparison a word.
#pragma once

#include <algorithm>
#include <string_view>

namespace fulcrum::dialogue {

template <class Table>
[[nodiscard]] bool contains(const Table& table, std::string_view word) {
    return std::find(table.begin(), table.end(), word) != table.end();
}

}  // namespace fulcrum::dialogue
