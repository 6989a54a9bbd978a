#include "runtime/arms/hd/hd_library.h"

#include "tests/support/maker_stand_in.h"

#include <catch2/catch.hpp>

namespace fulcrum::runtime {

TEST_CASE(
    "hd library: a library with all functions is loaded; one that lacks some is refused by name") {
    const test_support::MakerStandIn stand_in(FULCRUM_HD_STAND_IN);
    const auto library = load_hd(stand_in.path());
    REQUIRE(library);
    CHECK(library->found_as == stand_in.path());
    CHECK(std::string(library->use.get_string(hd_model)) == "Touch");

    const test_support::MakerStandIn lacking(FULCRUM_HD_STAND_IN_LACKING);
    const auto refused = load_hd(lacking.path());
    REQUIRE_FALSE(refused);
    CHECK(refused.error().message.find("hdBeginFrame") != std::string::npos);
    CHECK(refused.error().what_to_do.find("install OpenHaptics 3.4") != std::string::npos);

    const auto missing = load_hd(stand_in.path() + ".gone");
    REQUIRE_FALSE(missing);
    CHECK(missing.error().message == "no library lies there");
}

TEST_CASE("hd library: the pile of errors is emptied, and the newest that counts is told") {
    const test_support::MakerStandIn stand_in(FULCRUM_HD_STAND_IN);
    const HdFunctions use = load_hd(stand_in.path())->use;
    CHECK(take_hd_errors(use) == hd_no_error);
    for (const std::uint32_t code : {0x0303, 0x0203, 0x0304}) {
        stand_in.set("raise", code);
    }
    CHECK(take_hd_errors(use, hd_timer) == hd_too_fast);
    CHECK(take_hd_errors(use) == hd_no_error);
    stand_in.set("raise", hd_timer);
    CHECK(take_hd_errors(use) == hd_timer);
    // By value, all of its twelve bytes.
    stand_in.set("raise", hd_timer);
    CHECK(use.get_error().code == hd_timer);
}

}  // namespace fulcrum::runtime
