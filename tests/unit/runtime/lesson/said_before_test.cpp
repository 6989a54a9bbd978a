#include "runtime/lesson/said_before.h"

#include "tests/unit/runtime/rig.h"

using namespace fulcrum::runtime::test;

namespace {

using Texts = std::vector<std::string>;

}  // namespace

TEST_CASE("said before: what stands there comes first, then one further back each time") {
    SaidBefore said;
    for (const char* text : {"one", "two", "three", "four"}) {
        said.add(text);
    }
    const Texts standing{"three", "four"};
    CHECK(said.look_back(standing, 1.0) == standing);
    CHECK(said.shown(1.0).empty());
    CHECK(said.look_back(standing, 2.0) == Texts{"two"});
    CHECK(said.shown(2.0) == "two");
    CHECK(said.look_back(standing, 3.0) == Texts{"one"});
    // Nothing was said before the first.
    CHECK(said.look_back(standing, 4.0) == Texts{"one"});
    CHECK(said.shown(4.0) == "one");
}

TEST_CASE("said before: who waits, and who is told something new, begins with the newest") {
    SaidBefore said;
    said.add("one");
    said.add("two");
    CHECK(said.look_back({}, 1.0) == Texts{"two"});
    CHECK(said.look_back({}, 2.0) == Texts{"one"});
    CHECK(said.shown(2.0 + SaidBefore::kForgets_s).empty());
    CHECK(said.look_back({}, 2.0 + SaidBefore::kForgets_s) == Texts{"two"});
    said.add("three");
    CHECK(said.shown(12.5).empty());
    CHECK(said.look_back({}, 12.5) == Texts{"three"});
    // The same once more is nothing new to hear, but it is new.
    said.add("three");
    CHECK(said.look_back({}, 13.0) == Texts{"three"});
    CHECK(said.look_back({}, 13.5) == Texts{"two"});
}

TEST_CASE("said before: more than is shown at once comes in order, the oldest is forgotten") {
    SaidBefore said;
    const std::size_t many = SaidBefore::kMostKept + 7;
    for (std::size_t i = 1; i <= many; ++i) {
        said.add("line " + std::to_string(i));
    }
    const Texts standing{"line " + std::to_string(many)};
    double now_s = 0.0;
    CHECK(said.look_back(standing, now_s) == standing);
    for (std::size_t i = many - 1; i > many - SaidBefore::kMostKept; --i) {
        CHECK(said.look_back(standing, now_s += 1.0) == Texts{"line " + std::to_string(i)});
    }
    CHECK(said.look_back(standing, now_s + 1.0) == Texts{"line 8"});
}

TEST_CASE("said before: nothing said is nothing to hear, and two lines are shown as one") {
    SaidBefore said;
    said.add("");
    CHECK(said.look_back({}, 0.0).empty());
    CHECK(said.look_back({}, 1.0).empty());
    CHECK(said.shown(1.0).empty());
    // What stands there from before the play is said all the same, again and again.
    CHECK(said.look_back({"x"}, 100.0) == Texts{"x"});
    CHECK(said.look_back({"x"}, 101.0) == Texts{"x"});
    said.add("Look.\nWhich one?");
    CHECK(said.look_back({}, 200.0) == Texts{"Look.\nWhich one?"});
    CHECK(said.shown(200.0) == "Look. Which one?");
}
