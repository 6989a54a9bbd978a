#include "haptics/device/replay/recorded_traits.h"

#include "haptics/device/replay/replay_device.h"

#include <catch2/catch.hpp>

using namespace fulcrum;

namespace {

DeviceTraits make_traits() {
    DeviceTraits traits;
    traits.name = "arm";
    traits.renders_force = true;
    traits.max_force_N = 3.3;
    traits.max_torque_Nm = 0.1;
    traits.position_resolution_m = 1.0 / 3e5;
    traits.damping_Ns_per_m = 0.7;
    traits.mass_kg = 0.2;
    return traits;
}

RecordHeader make_header() {
    RecordHeader header;
    header.lesson = "lever";
    header.facts = {{"program.version", "1"}};
    list_traits(make_traits(), header.facts);
    return header;
}

}  // namespace

TEST_CASE("recorded traits: what is listed is found again to the bit") {
    const auto found = find_traits(make_header());
    REQUIRE(found);
    const DeviceTraits expected = make_traits();
    CHECK(found->name == expected.name);
    CHECK(found->renders_force);
    CHECK(found->max_force_N == expected.max_force_N);
    CHECK(found->max_torque_Nm == expected.max_torque_Nm);
    CHECK(found->position_resolution_m == expected.position_resolution_m);
    CHECK(found->damping_Ns_per_m == expected.damping_Ns_per_m);
    CHECK(found->mass_kg == expected.mass_kg);
    CHECK(find_fact(make_header(), "program.version") == "1");
    CHECK_FALSE(find_fact(make_header(), "program"));
}

TEST_CASE("recorded traits: where one is missing or cannot be there are none") {
    const RecordHeader whole = make_header();
    for (std::size_t i = 1; i < whole.facts.size(); ++i) {
        RecordHeader header = whole;
        header.facts.erase(header.facts.begin() + static_cast<std::ptrdiff_t>(i));
        INFO(whole.facts[i].name);
        CHECK_FALSE(find_traits(header));
        if (i > 1) {
            for (const char* bad : {"", "much", "-1", "nan", "inf"}) {
                header = whole;
                header.facts[i].value = bad;
                CHECK_FALSE(find_traits(header));
            }
        }
    }
}

TEST_CASE("recorded traits: a replay is what was held when it was recorded, or takes any force") {
    Record record;
    record.header = make_header();
    const ReplayDevice as_recorded(record);
    CHECK(as_recorded.traits().max_force_N == 3.3);
    CHECK(as_recorded.traits().damping_Ns_per_m == 0.7);
    CHECK(as_recorded.traits().name == "replay of lever");
    record.header.facts.clear();
    const ReplayDevice of_old(record);
    CHECK(of_old.traits().renders_force);
    CHECK(of_old.traits().max_force_N > 1e300);
}
