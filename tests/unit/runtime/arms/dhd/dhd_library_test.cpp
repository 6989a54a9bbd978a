#include "runtime/arms/dhd/dhd_library.h"

#include "tests/support/maker_stand_in.h"

#include <catch2/catch.hpp>

namespace fulcrum::runtime {

TEST_CASE("dhd library: a library with all functions is loaded, and tells its version") {
    const test_support::MakerStandIn stand_in(FULCRUM_DHD_STAND_IN);
    const auto library = load_dhd(stand_in.path());
    REQUIRE(library);
    CHECK(library->version == "3.17.5");
    CHECK(library->found_as == stand_in.path());
    CHECK(std::string(library->use.get_system_name(0)) == "omega.3");
    CHECK(library->use.set_max_force != nullptr);
    // Not every library has it; this one does not.
    CHECK(library->use.set_max_torque == nullptr);
}

TEST_CASE(
    "dhd library: one that lacks a function, is too old or is not there is refused in a sentence") {
    const test_support::MakerStandIn lacking(FULCRUM_DHD_STAND_IN_LACKING);
    const auto old = load_dhd(lacking.path());
    REQUIRE_FALSE(old);
    CHECK(old.error().message.find("drdIsInitialized") != std::string::npos);
    CHECK(old.error().what_to_do.find("install Force Dimension's SDK 3.14") != std::string::npos);

    const test_support::MakerStandIn aged(FULCRUM_DHD_STAND_IN);
    aged.set("minor", 13);
    const auto aged_library = load_dhd(aged.path());
    REQUIRE_FALSE(aged_library);
    CHECK(aged_library.error().message ==
          "Force Dimension's library is of version 3.13.5, which is too old");

    const auto missing = load_dhd(aged.path() + ".gone");
    REQUIRE_FALSE(missing);
    CHECK(missing.error().message == "no library lies there");
}

}  // namespace fulcrum::runtime
