#include "haptics/device/hid/space_mouse.h"

#include "tests/support/virtual_hid.h"

#include <catch2/catch.hpp>

#include <cstdint>
#include <vector>

using namespace fulcrum;
using namespace fulcrum::hid;
using test_support::Bytes;
using test_support::cap_report;

TEST_CASE("space mouse: two reports, one for pushes and one for turns, each leaving the other") {
    CapState cap;
    CHECK(take_cap_report(cap_report(1, {350, -175, 70}), 350.0, cap));
    // Right is right; towards the user is +z; down is -y.
    CHECK(cap.push_D == Vector3(1.0, -0.2, -0.5));
    CHECK(cap.turn_D == Vector3::Zero());
    CHECK(take_cap_report(cap_report(2, {35, 0, -350}), 350.0, cap));
    CHECK(cap.turn_D == Vector3(0.1, 1.0, 0.0));
    CHECK(cap.push_D == Vector3(1.0, -0.2, -0.5));
}

TEST_CASE("space mouse: one report has both") {
    CapState cap;
    CHECK(take_cap_report(cap_report(1, {0, 0, -350, 0, 350, 0}), 350.0, cap));
    CHECK(cap.push_D == Vector3(0.0, 1.0, 0.0));
    CHECK(cap.turn_D == Vector3(0.0, 0.0, 1.0));
    // Some fill their report up.
    Bytes longer = cap_report(1, {0, 0, -350, 0, 350, 0});
    longer.resize(20);
    CHECK(take_cap_report(longer, 350.0, cap));
}

TEST_CASE("space mouse: its frame is turned into ours, not mirrored") {
    // x cross y is z in either.
    CapState x, y, z;
    CHECK(take_cap_report(cap_report(1, {350, 0, 0}), 350.0, x));
    CHECK(take_cap_report(cap_report(1, {0, 350, 0}), 350.0, y));
    CHECK(take_cap_report(cap_report(1, {0, 0, 350}), 350.0, z));
    CHECK(x.push_D.cross(y.push_D) == z.push_D);
}

TEST_CASE("space mouse: buttons are bits, up to 32 of them") {
    CapState cap;
    CHECK(take_cap_report(Bytes{3, 2, 0}, 350.0, cap));
    CHECK(cap.buttons == 2);
    CHECK(take_cap_report(Bytes{3, 1, 0, 0, 0x80, 0xFF, 0xFF}, 350.0, cap));
    CHECK(cap.buttons == 0x80000001);
    CHECK(take_cap_report(Bytes{3, 0}, 350.0, cap));
    CHECK(cap.buttons == 0);
}

TEST_CASE("space mouse: what goes beyond the cap's end counts as its end") {
    CapState cap;
    CHECK(take_cap_report(cap_report(1, {32767, -32768, 351}), 350.0, cap));
    CHECK(cap.push_D == Vector3(1.0, -1.0, -1.0));
}

TEST_CASE("space mouse: reports of no known kind or length change nothing") {
    CapState cap;
    REQUIRE(take_cap_report(cap_report(1, {100, 100, 100, 50, 50, 50}), 350.0, cap));
    REQUIRE(take_cap_report(Bytes{3, 1}, 350.0, cap));
    const CapState before = cap;
    const std::vector<Bytes> garbage{{},
                                     {1},
                                     {1, 2, 3, 4, 5, 6},
                                     cap_report(1, {1, 2, 3, 4}),
                                     {1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12},
                                     {2, 9, 9, 9},
                                     cap_report(2, {1, 2, 3, 4, 5, 6}),
                                     {3},
                                     {0, 9, 9, 9, 9, 9, 9},
                                     {23, 1, 2},
                                     {255, 1, 2, 3, 4, 5, 6}};
    for (const Bytes& report : garbage) {
        CHECK_FALSE(take_cap_report(report, 350.0, cap));
        CHECK(cap.push_D == before.push_D);
        CHECK(cap.turn_D == before.turn_D);
        CHECK(cap.buttons == before.buttons);
    }
}

TEST_CASE("space mouse: known by its numbers") {
    CHECK(is_space_mouse(0x046d, 0xc626));
    CHECK(is_space_mouse(0x256f, 0xc652));
    CHECK_FALSE(is_space_mouse(0x046d, 0xc652));
    CHECK_FALSE(is_space_mouse(0, 0));
}
