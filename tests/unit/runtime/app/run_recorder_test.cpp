#include "runtime/app/run_recorder.h"

#include "tests/unit/runtime/rig.h"

using namespace fulcrum::runtime::test;

TEST_CASE("run recorder: rounds, what happened and how it failed stand in the file") {
    const ScratchFolder folder;
    const std::string file = folder.file("run.rec");
    HapticChannels channels;
    RecordHeader header;
    header.lesson = "gravity";
    header.effects = {"weight"};
    header.bodies = {"a", "b", "c", "d", "e"};
    header.facts = {{"option.seed", "7"}};
    auto recorder = value_of(RunRecorder::create(file, header, channels, {"breeze"}));
    REQUIRE(channels.record != nullptr);
    for (std::uint64_t tick = 0; tick < 5; ++tick) {
        RecordRound round;
        round.sample.time_s = 0.001 * static_cast<double>(tick);
        round.sample.gate = tick < 3 ? GatePhase::open : GatePhase::fading;
        round.sample.faults = tick < 3 ? Fault::none : Fault::hand_too_fast | Fault::command_stale;
        round.shares.n = 1;
        round.shares.each_W[0].force.y() = -static_cast<double>(tick);
        REQUIRE(channels.record->push(round));
    }
    WorldSnapshot world;
    world.n_bodies = 2;
    world.bodies[1].where = BodyWhere::falling;
    world.bodies[1].pose_W.position.y() = 0.7;
    SessionInput input;
    input.time_s = 0.005;
    input.world = &world;
    input.world_events = {{WorldEvent::Kind::caught, 2, 0.001, 1.0},
                          {WorldEvent::Kind::landed, 3, 0.002, 1.0}};
    input.keys = {"space"};
    input.wheel = -0.5;
    input.heard = "An egg.";
    recorder->keep_frame(input);
    SessionOutput output;
    output.world = {{WorldCommand::Kind::drop, 4}, {WorldCommand::Kind::release}};
    output.force.fields[0].strength = 0.5;
    output.said = {"4.5 s  asks  Which?"};
    SessionResult result;
    recorder->keep_output(0.005, output, result);
    result.finished = true;
    result.score = 6;
    result.stars = 2;
    output.world.clear();
    output.said.clear();
    recorder->keep_output(0.0053, output, result);
    recorder->keep_output(0.0054, output, result);  // nothing new
    SessionInput touching;
    touching.time_s = 0.0055;
    touching.world = &world;
    touching.hand.touched_body = 4;
    touching.hand.tool.n_cut = 3;
    ContactLateness lateness;
    ContactAge contact({});
    contact.step(1.0, 0.95, 0.001);
    lateness.add(contact);
    contact.step(1.0, 0.875, 0.001);
    lateness.add(contact);
    recorder->watch(&lateness);
    recorder->keep_frame(touching);
    recorder->keep_frame(touching);  // still the same touch, and nothing has moved
    recorder->keep_failure(0.006, "lesson.lua:3: no.");
    CHECK(recorder->dropped() == 0);
    REQUIRE(recorder->finish());

    const auto record = value_of(load_record(file));
    CHECK_FALSE(record.cut_off);
    CHECK(record.header.lesson == "gravity");
    CHECK(record.header.facts == header.facts);
    CHECK(record.header.bodies == header.bodies);
    REQUIRE(record.samples.size() == 5);
    CHECK(record.shares_of(4)[0].force.y() == -4.0);
    REQUIRE(record.bodies.size() == 1);  // the other one is as it was at first
    CHECK((record.bodies[0].body == 1 && record.bodies[0].time_s == 0.005));
    CHECK(record.bodies[0].state.where == BodyWhere::falling);
    CHECK(record.bodies[0].state.pose_W.position.y() == 0.7);

    struct Wanted {
        RecordEventKind kind;
        double time_s;
        std::int32_t body;
        const char* text;
    };
    const Wanted expected[] = {
        {RecordEventKind::gate, 0.0, kNoBody, "open"},
        {RecordEventKind::fault, 0.003, kNoBody, "lesson or world silent, hand too fast"},
        {RecordEventKind::gate, 0.003, kNoBody, "fading"},
        {RecordEventKind::caught, 0.001, 2, ""},
        {RecordEventKind::landed, 0.002, 3, ""},
        {RecordEventKind::pressed, 0.005, kNoBody, "space"},
        {RecordEventKind::wheel, 0.005, kNoBody, "-0.5"},
        {RecordEventKind::answered, 0.005, kNoBody, "An egg."},
        {RecordEventKind::dropped, 0.005, 4, ""},
        {RecordEventKind::released, 0.005, kNoBody, ""},
        {RecordEventKind::switched, 0.005, kNoBody, "breeze on 0.5"},
        {RecordEventKind::said, 0.005, kNoBody, "4.5 s  asks  Which?"},
        {RecordEventKind::finished, 0.0053, kNoBody, "score 6, 2 of 3 stars"},
        {RecordEventKind::touched, 0.0055, 4, ""},
        {RecordEventKind::cut, 0.0055, kNoBody, "3 steps ended before their solver did"},
        {RecordEventKind::cut, 0.0055, kNoBody,
         "1 steps gave less force, for contact was found too late: up to 0.125 s so far"},
        {RecordEventKind::failed, 0.006, kNoBody, "lesson.lua:3: no."}};
    REQUIRE(record.events.size() == std::size(expected));
    for (std::size_t i = 0; i < std::size(expected); ++i) {
        INFO(i);
        CHECK(record.events[i].kind == expected[i].kind);
        CHECK(record.events[i].time_s == expected[i].time_s);
        CHECK(record.events[i].body == expected[i].body);
        CHECK(record.events[i].text == expected[i].text);
    }
}

TEST_CASE("run recorder: a file that cannot be made is refused, a full disk is told at the end") {
    HapticChannels channels;
    CHECK_FALSE(RunRecorder::create("/no/such/folder/run.rec", RecordHeader{}, channels));
    CHECK(channels.record == nullptr);
    auto recorder = RunRecorder::create("/dev/full", RecordHeader{}, channels);
    if (recorder) {
        CHECK_FALSE((*recorder)->finish());
    }
}
