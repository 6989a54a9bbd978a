#include "runtime/scene/choice_columns.h"

#include <catch2/catch.hpp>

#include <set>

using namespace fulcrum::runtime;

TEST_CASE("choice columns: arrow keys reach each choice, from each") {
    for (int n = 1; n <= 9; ++n) {
        for (const char* key : {"down", "up"}) {
            std::set<int> reached;
            for (int i = 0, at = -1; i < n; ++i) {
                at = next_choice(at, n, key);
                reached.insert(at);
            }
            CHECK(reached.size() == static_cast<std::size_t>(n));
            CHECK(*reached.begin() == 0);
            CHECK(*reached.rbegin() == n - 1);
        }
        for (int i = 0; i < n; ++i) {
            CHECK(next_choice(next_choice(i, n, "down"), n, "up") == i);
        }
    }
}

TEST_CASE("choice columns: right and left go beside, and stay in the picture") {
    // 0 3 / 1 4 / 2
    CHECK(choice_rows(5) == 3);
    CHECK(next_choice(0, 5, "right") == 3);
    CHECK(next_choice(1, 5, "right") == 4);
    CHECK(next_choice(2, 5, "right") == 4);  // nothing is beside the last one
    CHECK(next_choice(3, 5, "right") == 3);
    CHECK(next_choice(4, 5, "left") == 1);
    CHECK(next_choice(3, 5, "left") == 0);
    CHECK(next_choice(0, 5, "left") == 0);
    // One column has nothing beside it.
    for (int n = 1; n <= 2; ++n) {
        CHECK(choice_columns(n) == 1);
        for (int i = 0; i < n; ++i) {
            CHECK(next_choice(i, n, "right") == i);
            CHECK(next_choice(i, n, "left") == i);
        }
    }
    CHECK(choice_columns(3) == 2);
    CHECK(next_choice(-1, 5, "right") == 0);
    CHECK(next_choice(-1, 5, "left") == 4);
}
