#include "dialogue/marking/other_degree.h"

#include "dialogue/marking/readings.h"
#include "tests/unit/dialogue/marking/marked_rows.h"
#include "tests/unit/dialogue/questions.h"

#include <catch2/catch.hpp>

#include <string>
#include <vector>

using namespace fulcrum::dialogue;

namespace {

Question rougher(const std::string& prompt) {
    return compiled({"rougher",
                     prompt,
                     {"[the] {ramp} is <comparative:rough> [than [the] {other}]"},
                     {{"ramp", {"wooden ramp", "ice ramp", "sandpaper ramp"}},
                      {"other", {"wooden ramp", "ice ramp", "sandpaper ramp"}}}});
}

/// The errors that are left once the meaning was found right or wrong.
std::string left_over(const Question& question, const std::string& said, bool right) {
    Mark mark = mark_answer(question, said);
    REQUIRE(mark.understood);
    (void)settle(mark, std::vector<bool>(readings_of(mark).size(), right));
    return codes_of(mark);
}

}  // namespace

TEST_CASE("other degree: of three or more things the superlative is as right as the comparative") {
    check_rows(
        rougher("Which ramp is rougher?"),
        {
            {"the sandpaper ramp is the roughest", "", "The sandpaper ramp is the roughest."},
            {"the sandpaper ramp is rougher", "", "The sandpaper ramp is rougher."},
            {"the sandpaper ramp is roughest", "R:ADJ:FORM", "The sandpaper ramp is *rougher*."},
            {"the sandpaper ramp is the most rough", "R:ADJ:FORM",
             "The sandpaper ramp is *rougher*."},
            {"the sandpaper ramp is the roughest than the ice ramp", "U:DET R:ADJ:FORM",
             "The sandpaper ramp is *rougher* than the ice ramp."},
        });
    // Of two it is the comparative that English wants.
    check_rows(
        rougher("Which is rougher, the wooden ramp or the sandpaper ramp?"),
        {{"the sandpaper ramp is the roughest", "R:ADJ:FORM", "The sandpaper ramp is *rougher*."}});
    check_rows(heavier(), {{"the egg is the heaviest", "R:ADJ:FORM", "The egg is *heavier*."}});
    const Question easier = compiled({"easier",
                                      "Where is it easier?",
                                      {"it is <comparative:easy> {place}"},
                                      {{"place", {"near the pole", "in the middle", "far away"}}}});
    check_rows(easier, {{"it is easiest far away", "", "It is easiest far away."},
                        {"it is more easy far away", "R:ADJ:FORM", "It is *easier* far away."}});
}

TEST_CASE("other degree: what is said rightly is no error of an answer whose meaning is wrong") {
    CHECK(left_over(heavier(), "the egg is heavy", false).empty());
    CHECK(left_over(heavier(), "the egg is heavy", true) == "R:ADJ:FORM");
    CHECK(left_over(heavier(), "the egg is the heaviest", false).empty());
    CHECK(left_over(heavier(), "the egg is more heavy", false) == "R:ADJ:FORM");
    CHECK(left_over(heavier(), "the egg is heavy than the apple", false) == "R:ADJ:FORM");
    CHECK(left_over(heavier(), "egg is heavy", false) == "M:DET");
    CHECK(left_over(heaviest(), "the egg is heavier", false).empty());
    CHECK(left_over(heavier(), "the egg is not lighter than the apple", false).empty());
    CHECK(left_over(heavier(), "the apple is not heavy", true).empty());
    CHECK(left_over(heavier(), "the apple is not heavy", false).empty());
    CHECK(left_over(heaviest(), "the apple is not heavy", false).empty());
}
