#include "runtime/arms/hd/hd_start.h"

#include "tests/support/maker_stand_in.h"

#include <catch2/catch.hpp>

namespace fulcrum::runtime {
namespace {

struct Loaded {
    test_support::MakerStandIn stand_in{FULCRUM_HD_STAND_IN};
    HdFunctions use = load_hd(stand_in.path())->use;
};

}  // namespace

TEST_CASE("hd start: the arm's name, force and reach are what it says, within our own limit") {
    const Loaded loaded;
    const auto found = find_hd_arm(loaded.use, 10.0);
    REQUIRE(found);
    CHECK(found->traits.name == "Touch 50012345678");
    CHECK(found->traits.max_force_N == 3.3);
    CHECK(found->traits.max_torque_Nm == 0.0);
    CHECK(found->traits.reach_m == Vector3{0.08, 0.06, 0.035});
    CHECK(found->calibration_style == 4);
    CHECK(found->facts[0] == ArmFact{"hd driver", "2023.11.15"});
    CHECK(found->facts[2] == ArmFact{"hd force for ever", "0.88 N"});
    CHECK(find_hd_arm(loaded.use, 2.0)->traits.max_force_N == 2.0);
    loaded.stand_in.set("most", 37.5);
    CHECK(find_hd_arm(loaded.use, 10.0)->traits.max_force_N == 10.0);
}

TEST_CASE("hd start: of what it does not tell, or tells wrongly, the least counts") {
    const Loaded loaded;
    loaded.stand_in.set("most", -1.0);
    CHECK(find_hd_arm(loaded.use, 10.0)->traits.max_force_N == 0.88);
    loaded.stand_in.set("tells nothing", 1.0);
    loaded.stand_in.set("styles", 8);
    const auto found = find_hd_arm(loaded.use, 10.0);
    REQUIRE(found);
    CHECK(found->traits.max_force_N == 0.88);
    CHECK(found->traits.reach_m == Vector3::Zero());
    CHECK(found->calibration_style == 4);
}

TEST_CASE("hd start: the style that asks least of people is taken") {
    const Loaded loaded;
    loaded.stand_in.set("styles", 7);
    CHECK(find_hd_arm(loaded.use, 10.0)->calibration_style == 2);
    loaded.stand_in.set("styles", 1);
    CHECK(find_hd_arm(loaded.use, 10.0)->calibration_style == 1);
}

TEST_CASE("hd start: where the default arm has no name it is asked for by its usual ones") {
    const Loaded loaded;
    loaded.stand_in.set("no null name", 1.0);
    CHECK(find_hd_arm(loaded.use, 10.0));
    CHECK(loaded.stand_in.get("tries") == 2.0);
}

TEST_CASE("hd start: without an arm it says why, and what to look at") {
    const Loaded loaded;
    loaded.stand_in.set("no arm", 1.0);
    const auto none = find_hd_arm(loaded.use, 10.0);
    REQUIRE_FALSE(none);
    CHECK(loaded.stand_in.get("tries") == 3.0);
    CHECK(none.error().message == "no arm of OpenHaptics answers (communication error)");
    CHECK(none.error().what_to_do.find("Touch_Setup") != std::string::npos);
    loaded.stand_in.set("why no arm", hd_bad_configuration);
    const auto spoiled = find_hd_arm(loaded.use, 10.0);
    REQUIRE_FALSE(spoiled);
    CHECK(spoiled.error().what_to_do.find("pull its plug out and in") != std::string::npos);
}

}  // namespace fulcrum::runtime
