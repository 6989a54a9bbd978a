#include "runtime/arms/haply/haply_message.h"

#include "runtime/arms/haply/haply_frames.h"
#include "tests/support/refused.h"

#include <catch2/catch.hpp>

namespace fulcrum::runtime {
namespace {

// Written after the document's first message, with figures of our own.
constexpr const char* kInventory = R"({
  "session_id": 7, "something": {"new": [1, null]},
  "inverse3": [{
    "device_id": "049D",
    "config": {
      "type": "inverse3x", "port": "/dev/ttyACM0", "handedness": "left", "preset": "defaults",
      "device_info": {"id": "049D", "major_version": 7, "minor_version": 4, "uuid": "u"},
      "basis": {"permutation": "XYZ"},
      "mount": {"position": {"x": 0.5, "y": 0, "z": 0}, "rotation": {"w": 0, "x": 0, "y": 0, "z": 1},
                "scale": {"x": 2, "y": 2, "z": 2}},
      "filters": {"force_gate": {"gain": 0.3}, "damping": {"scalar": 1.5}},
      "gravity_compensation": {"enabled": true, "scaling_factor": 0.8},
      "torque_scaling": {"enabled": false}
    },
    "state": {
      "cursor_position": {"x": 0.01, "y": -0.12, "z": 0.15},
      "cursor_velocity": {"x": 0.1, "y": 0.2, "z": -0.3},
      "current_cursor_force": {"x": 1, "y": 2, "z": 3},
      "control_mode": "idle",
      "transform": {"position": {"x": 0, "y": 0, "z": 0}, "scale": {"x": 1, "y": 3, "z": 1}}
    },
    "status": {"calibrated": true, "in_use": false, "power_supply": true, "ready": true}
  }],
  "verse_grip": [{"device_id": "61", "state": {"button": true, "hall": 3,
     "orientation": {"w": 0.707107, "x": 0, "y": 0.707107, "z": 0}}}],
  "wireless_verse_grip": [
     {"device_id": "62", "state": {"buttons": {"a": false, "b": true, "c": true}, "battery_level": 0.5},
      "status": {"awake": false, "connected": true}},
     {"device_id": "63", "state": {"buttons": {"button_0": true, "button_3": true}}}]
})";

std::string with_position(const std::string& position) {
    return R"({"inverse3":[{"device_id":"049D","state":{"cursor_position":)" + position + "}}]}";
}

}  // namespace

TEST_CASE("haply message: the first one is read as the documents have it") {
    const auto message = parse_haply_message(kInventory);
    REQUIRE(message);
    REQUIRE(message->arms.size() == 1);
    const HaplyArm& arm = message->arms[0];
    CHECK(arm.id == "049D");
    CHECK(arm.position_A == Vector3(0.01, -0.12, 0.15));
    CHECK(arm.velocity_A == Vector3(0.1, 0.2, -0.3));
    CHECK(arm.echo_A == Vector3(1.0, 2.0, 3.0));
    CHECK(arm.transform.scale == Vector3(1.0, 3.0, 1.0));
    CHECK_FALSE(is_identity(arm.transform));
    CHECK(arm.status.is_calibrated == true);
    CHECK(arm.status.is_in_use == false);
    CHECK(arm.status.has_power == true);
    REQUIRE(arm.config);
    CHECK(arm.config->type == "inverse3x");
    CHECK(arm.config->basis == "XYZ");
    CHECK(arm.config->handedness == "left");
    CHECK(arm.config->preset == "defaults");
    CHECK(arm.config->mount.pose.position == Vector3(0.5, 0.0, 0.0));
    CHECK(arm.config->mount.pose.orientation == Quaternion(0.0, 0.0, 0.0, 1.0));
    CHECK(arm.config->mount.scale == Vector3(2.0, 2.0, 2.0));
    CHECK(arm.config->gate_gain == 0.3);
    CHECK(arm.config->damping_Ns_per_m == 1.5);
    CHECK(arm.config->compensates_gravity == true);
    CHECK(arm.config->gravity_scale == 0.8);
    CHECK(arm.config->scales_torque == false);
}

TEST_CASE("haply message: grips of each kind, their buttons by both ways of naming them") {
    const auto message = parse_haply_message(kInventory);
    REQUIRE(message);
    REQUIRE(message->grips.size() == 3);
    CHECK(message->grips[0].id == "61");
    CHECK(message->grips[0].buttons == 1);
    REQUIRE(message->grips[0].orientation_A);
    CHECK(message->grips[0].orientation_A->norm() == Approx(1.0).margin(1e-12));
    CHECK(message->grips[1].buttons == 0b110);
    CHECK_FALSE(message->grips[1].is_awake);
    CHECK_FALSE(message->grips[1].orientation_A);
    CHECK(message->grips[2].buttons == 0b1001);
    CHECK(message->grips[2].is_awake);
}

TEST_CASE("haply message: what is left out is identity, and says nothing of the status") {
    const auto message = parse_haply_message(
        R"({"inverse3":[{"device_id":"A","config":{"mount":{"rotation":{}}},
            "state":{"cursor_position":{"z":0.2},"mode":"idle"}}]})");
    REQUIRE(message);
    const HaplyArm& arm = message->arms.at(0);
    CHECK(arm.position_A == Vector3(0.0, 0.0, 0.2));
    CHECK(arm.velocity_A == Vector3::Zero());
    CHECK(arm.echo_A == Vector3::Zero());
    CHECK(is_identity(arm.transform));
    CHECK(is_identity(arm.config->mount));
    CHECK(arm.config->basis == "XYZ");
    CHECK_FALSE(arm.config->gate_gain);
    CHECK_FALSE(arm.status.is_calibrated);
    CHECK(parse_haply_message("{}")->arms.empty());
}

TEST_CASE("haply message: whatever makes no sense makes the whole message one of no use") {
    for (const char* text : {"", "{", "[1]", "null", "\"inverse3\"", "{\"inverse3\":", "\xff\xfe",
                             "{\"inverse3\":[{}]} behind it"}) {
        CAPTURE(text);
        CHECK_FALSE(parse_haply_message(text));
    }
    CHECK(parse_haply_message(with_position(R"({"x":0.1,"y":0,"z":0})")));
    for (const char* position :
         {R"({"x":null})", R"({"x":"0.1"})", R"({"x":NaN})", R"({"x":1e999})", R"({"x":-2.1})",
          R"({"x":[0.1]})", "[0,0,0]", "null", "0.1"}) {
        CAPTURE(position);
        CHECK_FALSE(parse_haply_message(with_position(position)));
    }
    for (const char* text :
         {R"({"inverse3":{}})", R"({"inverse3":["049D"]})", R"({"inverse3":[{"device_id":"A"}]})",
          R"({"inverse3":[{"device_id":1,"state":{"cursor_position":{}}}]})",
          R"({"inverse3":[{"device_id":"A","state":{}}]})",
          R"({"inverse3":[{"state":{"cursor_position":{}},"status":{"calibrated":"yes"}}]})",
          R"({"inverse3":[{"state":{"cursor_position":{}},"status":7}]})",
          R"({"inverse3":[{"state":{"cursor_position":{}},"config":{"basis":{"permutation":1}}}]})",
          R"({"verse_grip":[{"state":{"orientation":{"w":0.5}}}]})",
          R"({"verse_grip":[{"state":{"orientation":{"w":0,"x":0}}}]})",
          R"({"verse_grip":[{"state":{"button":1}}]})"}) {
        CAPTURE(text);
        CHECK_FALSE(parse_haply_message(text));
    }
    CHECK(
        is_refused(parse_haply_message(with_position(R"({"y":null})")), "whose y makes no sense"));
}

TEST_CASE("haply message: a megabyte of brackets is refused like any nonsense") {
    CHECK_FALSE(parse_haply_message(std::string(1U << 20U, '[')));
    CHECK_FALSE(parse_haply_message(std::string(1U << 19U, '[') + std::string(1U << 19U, ']')));
}

TEST_CASE("haply message: version and scale of forces, in the envelope of 3.5 and without") {
    CHECK(parse_haply_version(R"({"git_tag":"3.5.0","project_version":"3.4.0.0"})") == "3.5.0");
    CHECK(parse_haply_version(R"({"ok":true,"data":{"git_tag":"","project_version":"3.4.0.0"}})") ==
          "3.4.0.0");
    for (const char* none : {"", "{}", "3.5", R"({"git_tag":35})", R"({"data":"3.5"})", "{"}) {
        CAPTURE(none);
        CHECK(parse_haply_version(none).empty());
    }
    CHECK(parse_haply_force_scale(R"({"ok":true,"data":{"value":0.5,"type_hint":"FLOAT"}})") ==
          0.5);
    CHECK(parse_haply_force_scale(R"({"ok":true,"data":2})") == 2.0);
    CHECK(parse_haply_force_scale("1.5") == 1.5);
    CHECK(parse_haply_force_scale(R"({"force_scale":0.7})") == 0.7);
    CHECK(parse_haply_force_scale(R"({"ok":true,"data":{"devices/force_scale":{"value":2.5}}})") ==
          2.5);
    CHECK(parse_haply_force_scale(R"({"settings":{"devices":{"force_scale":3}}})") == 3.0);
    for (const char* none : {"", "{}", "null", R"({"ok":false,"error":"no"})",
                             R"({"data":{"port":10001}})", R"({"force_scale":"1"})"}) {
        CAPTURE(none);
        CHECK_FALSE(parse_haply_force_scale(none));
    }
}

TEST_CASE("haply frames: right stays right, up goes up, away goes away, and back again") {
    CHECK(haply_to_D(Vector3(1.0, 0.0, 0.0)) == Vector3::UnitX());
    CHECK(haply_to_D(Vector3(0.0, 0.0, 1.0)) == Vector3::UnitY());
    CHECK(haply_to_D(Vector3(0.0, 1.0, 0.0)) == Vector3(0.0, 0.0, -1.0));
    const Vector3 v(0.1, -0.2, 0.3);
    const Vector3 u(-0.4, 0.5, 0.7);
    CHECK(haply_from_D(haply_to_D(v)) == v);
    // Right-handed: a cross product goes over into that of the parts. And power is kept.
    CHECK((haply_to_D(Vector3(v.cross(u))) - haply_to_D(v).cross(haply_to_D(u))).norm() < 1e-15);
    CHECK(haply_to_D(v).dot(haply_to_D(u)) == Approx(v.dot(u)));
    // A turn does to D's vectors what it does to A's.
    const Quaternion turn(AngleAxis(0.7, Vector3(0.6, 0.0, 0.8)));
    CHECK((haply_to_D(turn) * haply_to_D(v) - haply_to_D(turn * v)).norm() < 1e-15);
    CHECK(haply_from_D(haply_to_D(turn)) == turn);
    // A grip that is not turned points away: +Y of its own in A, -Z in D.
    CHECK(haply_to_D(Vector3(Vector3::UnitY())) == -Vector3::UnitZ());
}

}  // namespace fulcrum::runtime
