#include "dialogue/template/graph.h"

#include <catch2/catch.hpp>

using namespace fulcrum::dialogue;

TEST_CASE("graph: strings are numbered once each") {
    StringTable table;
    CHECK(table.find("a") == kNone);
    const int a = table.intern("a");
    const int b = table.intern("b");
    CHECK(a != b);
    CHECK(table.intern("a") == a);
    CHECK(table.find("b") == b);
    CHECK(table.text(a) == "a");
    CHECK(table.size() == 2);
}
