#include "runtime/app/hand_device.h"

#include "haptics/record/record_writer.h"
#include "tests/unit/runtime/rig.h"

using namespace fulcrum::runtime::test;

namespace {

HapticPlan plan_with_workspace() {
    HapticPlan plan;
    plan.workspace.pose_WD = Pose::at({1.0, 2.0, 3.0});
    plan.workspace.scale = 2.0;
    return plan;
}

// Where the device has gone after `seconds` at 1 kHz.
DeviceReading play(Device& device, double seconds) {
    DeviceReading reading;
    for (int tick = 0; tick < static_cast<int>(seconds * 1000.0); ++tick) {
        REQUIRE(device.read(0.001 * tick, reading));
    }
    return reading;
}

}  // namespace

TEST_CASE("hand device: the simulated hand follows the lesson's target through the workspace") {
    const auto hand = value_of(HandDevice::open({}, plan_with_workspace()));
    CHECK(hand->device().traits().renders_force);
    hand->follow(Pose::at({1.2, 2.0, 3.0}), 1);
    const DeviceReading reading = play(hand->device(), 3.0);
    CHECK((reading.pose_D.position - Vector3(0.1, 0.0, 0.0)).norm() < 1e-4);
    CHECK(reading.buttons == 1);
    // A mouse that somebody moves meanwhile is not this hand's.
    hand->point_at({9.0, 9.0, 9.0}, 0);
    CHECK((play(hand->device(), 0.5).pose_D.position - Vector3(0.1, 0.0, 0.0)).norm() < 1e-3);
}

TEST_CASE("hand device: the mouse points, renders no force and yields to it on the screen") {
    RunRequest request;
    request.hand = HandKind::mouse;
    const auto hand = value_of(HandDevice::open(request, plan_with_workspace()));
    CHECK_FALSE(hand->device().traits().renders_force);
    CHECK(hand->pointer_W().position == Vector3(1.0, 2.0, 3.0));
    hand->point_at({1.0, 2.4, 3.0}, 2);
    CHECK(hand->pointer_W().position == Vector3(1.0, 2.4, 3.0));
    const Vector3 free_D = play(hand->device(), 2.0).pose_D.position;
    CHECK((free_D - Vector3(0.0, 0.2, 0.0)).norm() < 1e-4);
    REQUIRE(hand->device().write(2.0, Wrench{Vector3(0.0, -5.0, 0.0), Vector3::Zero()}));
    CHECK(play(hand->device(), 2.0).pose_D.position.y() < free_D.y() - 0.01);
}

TEST_CASE("hand device: a record plays again, and one that is none is refused in a sentence") {
    const ScratchFolder folder;
    RunRequest request;
    request.hand = HandKind::replay;
    request.hand_file = folder.file("run.rec");
    CHECK_FALSE(HandDevice::open(request, plan_with_workspace()));
    {
        auto writer = value_of(RecordWriter::create(request.hand_file.string(), RecordHeader{}));
        RecordRound round;
        round.sample.pose_D.position = {0.01, 0.02, 0.03};
        REQUIRE(writer.append(round));
        REQUIRE(writer.finish());
    }
    const auto hand = value_of(HandDevice::open(request, plan_with_workspace()));
    DeviceReading reading;
    REQUIRE(hand->device().read(0.0, reading));
    CHECK((reading.pose_D.position - Vector3(0.01, 0.02, 0.03)).norm() < 1e-12);
}

TEST_CASE("hand device: its limit is known before it is opened, and is what the opened one has") {
    const auto hand = HandDevice::open({}, plan_with_workspace());
    REQUIRE(hand);
    CHECK(HandDevice::force_limit_N({}) == (*hand)->device().traits().max_force_N);
    RunRequest request;
    for (const HandKind unlimited : {HandKind::mouse, HandKind::replay, HandKind::hid}) {
        request.hand = unlimited;
        CHECK(HandDevice::force_limit_N(request) > 1e9);
    }
    request.hid.has_force = true;
    CHECK(HandDevice::force_limit_N(request) == hid::HidHandSettings{}.full_force_N);
}
