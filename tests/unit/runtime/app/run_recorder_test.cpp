#include "runtime/app/run_recorder.h"

#include <catch2/catch.hpp>

#include <cstdlib>
#include <filesystem>

using namespace fulcrum;
using namespace fulcrum::runtime;

TEST_CASE("run recorder: rounds, what happened and how it failed stand in the file") {
    std::string folder = (std::filesystem::temp_directory_path() / "fulcrum_rec_XXXXXX").string();
    REQUIRE(mkdtemp(folder.data()) != nullptr);
    const std::string file = folder + "/run.rec";
    HapticChannels channels;
    auto recorder = RunRecorder::create(file, {1000.0, "gravity"}, channels);
    REQUIRE(recorder);
    REQUIRE(channels.record != nullptr);
    for (std::uint64_t tick = 0; tick < 5; ++tick) {
        RecordSample sample;
        sample.time_s = 0.001 * static_cast<double>(tick);
        REQUIRE(channels.record->push(sample));
    }
    SessionInput input;
    input.time_s = 0.005;
    input.world_events = {{WorldEvent::Kind::caught, 2, 0.001, 1.0},
                          {WorldEvent::Kind::landed, 3, 0.002, 1.0}};
    input.heard = "An egg.";
    (*recorder)->keep_frame(input);
    SessionInput touching;
    touching.time_s = 0.0055;
    touching.hand.touched_body = 4;
    (*recorder)->keep_frame(touching);
    (*recorder)->keep_frame(touching);  // still the same touch
    (*recorder)->keep_failure(0.006, "lesson.lua:3: no.");
    CHECK((*recorder)->dropped() == 0);
    REQUIRE((*recorder)->finish());

    const auto record = load_record(file);
    REQUIRE(record);
    CHECK_FALSE(record->cut_off);
    CHECK(record->header.lesson == "gravity");
    CHECK(record->samples.size() == 5);
    REQUIRE(record->events.size() == 5);
    CHECK((record->events[0].kind == RecordEventKind::caught && record->events[0].body == 2));
    CHECK((record->events[1].kind == RecordEventKind::landed && record->events[1].body == 3));
    CHECK((record->events[2].kind == RecordEventKind::answered &&
           record->events[2].text == "An egg."));
    CHECK((record->events[3].kind == RecordEventKind::touched && record->events[3].body == 4));
    CHECK((record->events[4].kind == RecordEventKind::failed &&
           record->events[4].text == "lesson.lua:3: no."));
    std::filesystem::remove_all(folder);
}

TEST_CASE("run recorder: a file that cannot be made is refused, a full disk is told at the end") {
    HapticChannels channels;
    CHECK_FALSE(RunRecorder::create("/no/such/folder/run.rec", {1000.0, "x"}, channels));
    CHECK(channels.record == nullptr);
    auto recorder = RunRecorder::create("/dev/full", {1000.0, "x"}, channels);
    if (recorder) {
        CHECK_FALSE((*recorder)->finish());
    }
}
