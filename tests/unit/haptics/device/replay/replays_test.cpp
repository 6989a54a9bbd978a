#include "haptics/device/replay/recorded_traits.h"
#include "haptics/device/replay/replay_device.h"

#include <catch2/catch.hpp>

using namespace fulcrum;

namespace {

Record make_record(int n) {
    Record record;
    record.header.lesson = "gravity";
    for (int i = 0; i < n; ++i) {
        RecordSample sample;
        sample.tick = static_cast<std::uint64_t>(i);
        sample.time_s = 0.001 * i;
        sample.stamp_s = 0.001 * i - 0.0003;
        sample.pose_D.position = Vector3(0.001 * i, 0.1, 0.0);
        sample.buttons = static_cast<std::uint32_t>(i % 4);
        sample.faults = i == 5 ? Fault::device_read : Fault::none;
        record.samples.push_back(sample);
    }
    return record;
}

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

TEST_CASE("replay: on the record's own clock every reading is the recorded one to the bit") {
    const Record record = make_record(100);
    ReplayDevice replay(record);
    CHECK(replay.traits().name.find("gravity") != std::string::npos);
    for (int i = 0; i < 100; ++i) {
        DeviceReading reading;
        REQUIRE(replay.read(0.001 * i, reading) == (i != 5));
        REQUIRE(reading.pose_D.position == record.samples[std::size_t(i)].pose_D.position);
        REQUIRE(reading.stamp_s == record.samples[std::size_t(i)].stamp_s);
        REQUIRE(reading.buttons == record.samples[std::size_t(i)].buttons);
        REQUIRE(replay.write(0.001 * i, {Vector3(9, 9, 9), Vector3::Zero()}));
        REQUIRE_FALSE(replay.finished());
    }
    DeviceReading reading;
    CHECK(replay.read(0.5, reading));
    CHECK(replay.finished());
    CHECK(reading.stamp_s == 0.5);
    CHECK(reading.pose_D.position.x() == 0.001 * 99);
    replay.reset();
    CHECK_FALSE(replay.finished());
    CHECK(replay.read(0.0, reading));
    CHECK(reading.pose_D.position.x() == 0.0);
}

TEST_CASE(
    "replay: another clock is moved to the record's, slower and faster reading find the newest "
    "sample") {
    ReplayDevice replay(make_record(100));
    DeviceReading reading;
    CHECK(replay.read(50.0, reading));
    CHECK(reading.pose_D.position.x() == 0.0);
    CHECK(reading.stamp_s == Approx(50.0 - 0.0003));
    CHECK(replay.read(50.0005, reading));
    CHECK(reading.pose_D.position.x() == 0.0);
    CHECK(replay.read(50.0015, reading));
    CHECK(reading.pose_D.position.x() == 0.001);
    CHECK(replay.read(50.0425, reading));
    CHECK(reading.pose_D.position.x() == 0.001 * 42);
    CHECK(replay.read(50.0435, reading));
    CHECK(reading.pose_D.position.x() == 0.001 * 43);
}

TEST_CASE("replay: an empty record gives no pose and is finished") {
    ReplayDevice replay(Record{});
    DeviceReading reading;
    CHECK_FALSE(replay.read(0.0, reading));
    CHECK(replay.finished());
}

TEST_CASE("replay: what a device has noticed by itself is told again, what a loop finds is not") {
    Record record = make_record(10);
    record.samples[2].faults = Fault::clutched | Fault::command_stale;
    record.samples[3].faults = Fault::device_stale | Fault::hand_too_fast;
    ReplayDevice replay(record);
    for (int i = 0; i < 10; ++i) {
        DeviceReading reading;
        (void)replay.read(0.001 * i, reading);
        const Fault told = i == 2 ? Fault::clutched : i == 3 ? Fault::device_stale : Fault::none;
        CHECK(reading.faults == told);
    }
}

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

TEST_CASE("recorded traits: where one is missing there are none; a replay is what was held") {
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
