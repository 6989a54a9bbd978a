// Where answers to choose from stand, and how arrow keys go through them: one column of up to two, else two columns so that
// the scene stays in sight above them. The first column is read down, then the second.
//
//     0  2        down, up: the next one and the one before, from the first column's end to the second's top, and round
//     1  3        right, left: beside it; where there is none, the last one above that place
//
// Thread: any. Cost: none.
#pragma once

#include <algorithm>
#include <string_view>

namespace fulcrum::runtime {

[[nodiscard]] constexpr int choice_columns(int n) {
    return n > 2 ? 2 : 1;
}
/// Of the first column; the second may have one less.
[[nodiscard]] constexpr int choice_rows(int n) {
    return (n + choice_columns(n) - 1) / choice_columns(n);
}

[[nodiscard]] inline bool is_choice_key(std::string_view key) {
    return key == "down" || key == "up" || key == "left" || key == "right";
}

/// Which of `n`, 1 at least, is chosen after such a key; `chosen` is -1 for none before: then down and right begin with the first,
/// up and left with the last.
[[nodiscard]] inline int next_choice(int chosen, int n, std::string_view key) {
    const bool on = key == "down" || key == "right";
    if (chosen < 0) {
        return on ? 0 : n - 1;
    }
    if (key == "down" || key == "up") {
        return (chosen + (on ? 1 : n - 1)) % n;
    }
    const int rows = choice_rows(n);
    const bool in_second = chosen >= rows;
    if (choice_columns(n) == 1 || on == in_second) {
        return chosen;
    }
    return on ? std::min(chosen + rows, n - 1) : chosen - rows;
}

}  // namespace fulcrum::runtime
