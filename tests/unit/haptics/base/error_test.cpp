#include "haptics/base/error.h"

#include <catch2/catch.hpp>

using namespace fulcrum;

TEST_CASE("error: one sentence says where, what and what to do; empty parts leave no trace") {
    CHECK(to_sentence({"the mesh has no triangle", "apple.glb:3", "export it again"}) ==
          "apple.glb:3: the mesh has no triangle; export it again.");
    CHECK(to_sentence({"the mesh has no triangle", "", ""}) == "the mesh has no triangle.");
    CHECK(to_sentence({"there is no mas; did you mean mass?", "a:1", ""}) ==
          "a:1: there is no mas; did you mean mass?");
    CHECK(to_sentence({"stop", "", "let go!"}) == "stop; let go!");
    CHECK(to_sentence({"it ended.", "", ""}) == "it ended.");
    CHECK(to_sentence({}) == ".");
    const Expected<int> failed = fail("a", "b", "c");
    REQUIRE_FALSE(failed);
    CHECK(to_sentence(failed.error()) == "b: a; c.");
}
