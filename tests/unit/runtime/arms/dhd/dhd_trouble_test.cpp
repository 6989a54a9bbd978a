#include "runtime/arms/dhd/dhd_trouble.h"

#include <catch2/catch.hpp>

#include <set>

namespace fulcrum::runtime {

TEST_CASE("dhd trouble: each has a sentence of its own") {
    std::set<std::string> all;
    for (int i = 0; i <= static_cast<int>(DhdTrouble::another_arm); ++i) {
        const std::string words = words_of(static_cast<DhdTrouble>(i));
        INFO(words);
        CHECK(words.back() == '.');
        CHECK(all.insert(words).second);
        CHECK(words != words_of(static_cast<DhdTrouble>(99)));
    }
}

TEST_CASE(
    "dhd trouble: the arm's six reasons are told by name, and two of them pass by themselves") {
    CHECK(trouble_of_cause(2) == DhdTrouble::too_fast);
    CHECK(trouble_of_cause(3) == DhdTrouble::watchdog);
    CHECK(trouble_of_cause(6) == DhdTrouble::deadman);
    CHECK(trouble_of_cause(0) == DhdTrouble::other_cause);
    CHECK(trouble_of_cause(7) == DhdTrouble::other_cause);
    CHECK(trouble_of_cause(-1) == DhdTrouble::other_cause);
    for (int cause = 0; cause < 8; ++cause) {
        CHECK(goes_by_itself(trouble_of_cause(cause)) == (cause == 2 || cause == 3));
    }
}

}  // namespace fulcrum::runtime
