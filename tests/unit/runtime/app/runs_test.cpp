#include "haptics/record/record_reader.h"
#include "runtime/app/run_recorder.h"
#include "runtime/app/run_spoiler.h"
#include "runtime/app/soak_report.h"
#include "tests/unit/runtime/rig.h"

using namespace fulcrum::runtime::test;

namespace {

// A minute of ticks, with this force whenever.
RunSpoiler run_spoiler(std::uint64_t seed, double force_N, bool has_world, double& clock_s) {
    RunSpoiler spoiler(seed, 60.0);
    spoiler.begin(has_world);
    for (clock_s = 0.0; clock_s < 60.0; clock_s += 0.001) {
        clock_s += spoiler.step(clock_s, force_N);
        (void)spoiler.world_runs(clock_s);
        (void)spoiler.lesson_runs(clock_s);
        (void)spoiler.kills_lesson(clock_s);
    }
    return spoiler;
}

// In which each kind has happened, and each that must has faded.
SoakRun make_whole() {
    SoakRun run;
    run.arm.deeds.fill(1);
    run.arm.turned_rounds = 5;
    run.n_deadlines = 12;
    for (std::size_t i = 1; i < kSpoils; ++i) {
        run.arm.happened[i] = 2;
        run.arm.faded[i] = must_fade(static_cast<Spoil>(i)) ? 1 : 0;
    }
    for (std::size_t i = 1; i < kRunSpoils; ++i) {
        run.around[i] = 3;
        run.around_faded[i] = must_fade(static_cast<RunSpoil>(i)) ? 1 : 0;
    }
    return run;
}

SoakSum sum_of(const SoakRun& run) {
    SoakSum sum;
    sum.add("gravity", run);
    return sum;
}

}  // namespace

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
    input.clock_s = 0.005;
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
    touching.clock_s = 0.0055;
    touching.world = &world;
    touching.hand.touched_body = 4;
    touching.hand.tool.n_cut = 3;
    touching.hand.tool.n_lacking = {2, 1, 4, 5};
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
         "2 steps were not settled within their rounds: the last force that was is felt"},
        {RecordEventKind::cut, 0.0055, kNoBody,
         "1 steps were wedged: bodies that close upon it wait where they touched"},
        {RecordEventKind::cut, 0.0055, kNoBody,
         "4 steps had more contacts than there is room for: those left out are not felt"},
        {RecordEventKind::cut, 0.0055, kNoBody,
         "5 steps ended before their solver was within its tolerance: the best that it found is "
         "felt"},
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

TEST_CASE("run spoiler: in a few runs each kind has happened, and one seed makes one run") {
    std::array<std::uint64_t, kRunSpoils> all{};
    for (std::uint64_t seed = 1; seed <= 12; ++seed) {
        double end_s = 0.0;
        double again_s = 0.0;
        const RunSpoiler spoiler = run_spoiler(seed, 0.0, true, end_s);
        CHECK(run_spoiler(seed, 0.0, true, again_s).happened() == spoiler.happened());
        CHECK(end_s == again_s);
        CHECK(spoiler.missed_fades() == 0);
        for (std::size_t i = 0; i < kRunSpoils; ++i) {
            all[i] += spoiler.happened()[i];
        }
    }
    for (std::size_t i = 1; i < kRunSpoils; ++i) {
        INFO(name_of(static_cast<RunSpoil>(i)));
        CHECK(all[i] >= 2);
    }
}

TEST_CASE("run spoiler: what breaks first is known before") {
    for (std::uint64_t seed = 1; seed <= 40; ++seed) {
        RunSpoiler spoiler(seed, 60.0);
        const RunSpoil first = spoiler.first();
        const double at_s = spoiler.first_at_s();
        spoiler.begin(true);
        (void)spoiler.step(at_s - 0.01, 0.0);
        CHECK(spoiler.happened()[static_cast<std::size_t>(first)] == 0);
        (void)spoiler.step(at_s, 0.0);
        CHECK(spoiler.happened()[static_cast<std::size_t>(first)] == 1);
    }
}

TEST_CASE("run spoiler: a force that stays where nobody speaks is told, with when and in what") {
    double end_s = 0.0;
    std::uint64_t with_world = 0;
    std::uint64_t without = 0;
    for (std::uint64_t seed = 1; seed <= 6; ++seed) {
        const RunSpoiler spoiler = run_spoiler(seed, 1.0, true, end_s);
        with_world += spoiler.missed_fades();
        if (spoiler.missed_fades() > 0) {
            CHECK(spoiler.bad_since_s() > RunSpoiler::kMostQuiet_s);
            CHECK((spoiler.bad_in() == RunSpoil::world_stands ||
                   spoiler.bad_in() == RunSpoil::lesson_hangs));
        }
        without += run_spoiler(seed, 1.0, false, end_s).missed_fades();
    }
    CHECK(without > 0);
    CHECK(with_world > without);
}

TEST_CASE("run spoiler: a force that was felt and goes in time is a fade of its kind") {
    std::array<std::uint64_t, kRunSpoils> all{};
    for (std::uint64_t seed = 1; seed <= 30; ++seed) {
        RunSpoiler spoiler(seed, 60.0);
        spoiler.begin(true);
        double quiet_s = 0.0;
        for (double now_s = 0.0; now_s < 60.0; now_s += 0.001) {
            // There while all is well, and gone a tenth of a second after it is not.
            quiet_s = spoiler.quiet_s(now_s) > 0.0 ? 0.0 : quiet_s + 0.001;
            (void)spoiler.step(now_s, quiet_s < 0.1 ? 1.0 : 0.0);
            (void)spoiler.kills_lesson(now_s);
        }
        CHECK(spoiler.missed_fades() == 0);
        spoiler.end(0.0);
        for (std::size_t i = 0; i < kRunSpoils; ++i) {
            all[i] += spoiler.faded()[i];
        }
        // Nothing that must not go is counted, and where a force is left nothing is.
        RunSpoiler left(seed, 1.0);
        (void)left.step(0.9, 1.0);
        (void)left.kills_lesson(0.999);
        left.end(1.0);
        CHECK(left.faded()[static_cast<std::size_t>(RunSpoil::lesson_killed)] == 0);
    }
    for (std::size_t i = 0; i < kRunSpoils; ++i) {
        INFO(name_of(static_cast<RunSpoil>(i)));
        CHECK((all[i] > 0) == must_fade(static_cast<RunSpoil>(i)));
    }
}

TEST_CASE("run spoiler: what is starved or slow runs now and then, what stands not at all") {
    RunSpoiler spoiler(3, 60.0);
    spoiler.begin(true);
    int n_world = 0;
    int n_lesson = 0;
    int n_ticks = 0;
    for (double now_s = 0.0; now_s < 60.0; now_s += 0.001) {
        now_s += spoiler.step(now_s, 0.0);
        n_world += spoiler.world_runs(now_s) ? 1 : 0;
        n_lesson += spoiler.lesson_runs(now_s) ? 1 : 0;
        ++n_ticks;
    }
    CHECK(n_world < n_ticks);
    CHECK(n_world > n_ticks / 2);
    CHECK(n_lesson < n_ticks);
    CHECK(n_lesson > n_ticks / 2);
}

TEST_CASE("soak report: whole is what has each kind, each fade and each deed of the hand") {
    CHECK(sum_of(make_whole()).has_all());
    CHECK(conclude_soak(sum_of(make_whole()), true, {}) == 0);
    CHECK_FALSE(SoakSum{}.has_all());
    for (std::size_t i = 1; i < kSpoils; ++i) {
        SoakRun run = make_whole();
        run.arm.happened[i] = 0;
        CHECK(sum_of(run).lacks(static_cast<Spoil>(i)));
        CHECK_FALSE(sum_of(run).has_all());
        run = make_whole();
        run.arm.faded[i] = 0;
        CHECK(sum_of(run).has_all() == !must_fade(static_cast<Spoil>(i)));
    }
    for (std::size_t i = 1; i < kRunSpoils; ++i) {
        SoakRun run = make_whole();
        run.around[i] = 0;
        CHECK(sum_of(run).lacks(static_cast<RunSpoil>(i)));
        run = make_whole();
        run.around_faded[i] = 0;
        CHECK(sum_of(run).has_all() == !must_fade(static_cast<RunSpoil>(i)));
    }
    for (std::size_t i = 0; i < kHandDeeds; ++i) {
        SoakRun run = make_whole();
        run.arm.deeds[i] = 0;
        CHECK_FALSE(sum_of(run).has_all());
        CHECK(conclude_soak(sum_of(run), true, {}) == 1);
        CHECK(conclude_soak(sum_of(run), false, {}) == 0);  // one run that is looked at again
    }
}

TEST_CASE("felt watch: what can be felt is what nothing keeps away, by a hand or by the scene") {
    FeltWatch watch;
    HapticState asks;
    asks.gate = GatePhase::open;
    asks.commanded_W.force.y() = 1.0;
    HapticState faulty = asks;
    faulty.faults = Fault::command_stale;
    HapticState waits = asks;
    waits.gate = GatePhase::waiting;
    HapticState idle;
    idle.gate = GatePhase::open;
    watch.hands_stepped(asks, 1.0, true, false);
    watch.hands_stepped(asks, 0.0, true, false);
    watch.hands_stepped(asks, 0.0, false, true);   // something is broken
    watch.hands_stepped(faulty, 0.0, true, true);  // or told
    watch.hands_stepped(idle, 0.0, true, false);   // nothing to feel
    watch.hands_stepped(idle, 0.0, true, true);
    watch.hands_stepped(waits, 0.0, true, false);  // a weight that nobody can let go of
    watch.hands_stepped(waits, 0.0, true, true);   // who touches can
    CHECK(watch.rounds().all == 8);
    CHECK(watch.rounds().possible == 4);
    CHECK(watch.rounds().felt == 1);
    CHECK(watch.rounds().share() == 0.25);
}

TEST_CASE(
    "soak report: a lesson whose force is seldom felt is named, one played too short is not") {
    const auto judge = [](std::uint64_t all, std::uint64_t possible, std::uint64_t felt) {
        SoakRun run = make_whole();
        run.felt = {all, possible, felt};
        return sum_of(run);
    };
    CHECK(judge(120'000, 80'000, 42'000).find_seldom_felt().empty());
    CHECK(judge(120'000, 80'000, 20'000).find_seldom_felt() == "gravity");
    CHECK(judge(120'000, 5'000, 5'000).find_seldom_felt() == "gravity");  // hardly ever possible
    CHECK(judge(30'000, 20'000, 0).find_seldom_felt().empty());
    CHECK(conclude_soak(judge(120'000, 80'000, 20'000), true, {}) == 1);
    CHECK(conclude_soak(judge(120'000, 80'000, 20'000), false, {}) == 0);
    CHECK(describe_soak(judge(120'000, 80'000, 20'000), {})
              .find("Felt in gravity: a force in 25 % of the 80 s in which it can be, of 120 s.") !=
          std::string::npos);
}

TEST_CASE("soak report: a soak in which no torque was felt says nothing of torques") {
    SoakRun run = make_whole();
    run.arm.turned_rounds = 0;
    CHECK_FALSE(sum_of(run).has_all());
    CHECK(conclude_soak(sum_of(run), true, {}) == 1);
}

TEST_CASE("soak report: trouble, and memory that grows, fail it") {
    SoakRun run = make_whole();
    run.trouble = "late: a frame of the lesson";
    CHECK(conclude_soak(sum_of(run), true, {}) == 1);
    CHECK(conclude_soak(sum_of(make_whole()), true, {2.0, 0.0}) == 1);
    CHECK(conclude_soak(sum_of(make_whole()), true, {0.0, 100.0}) == 1);
    CHECK(conclude_soak(sum_of(make_whole()), true, {0.5, 10.0}) == 0);
}

TEST_CASE("soak report: how fast it was is told by the clock and by what the processor did") {
    SoakRun run = make_whole();
    run.simulated_s = 600.0;
    run.wall_s = 12.0;
    run.processor_s = 5.0;
    SoakSum sum = sum_of(run);
    sum.add("gravity", run);
    const std::string text = describe_soak(sum, {});
    INFO(text);
    CHECK(text.find("In all 1200 s, 50 times real time, 120 times its processor time, with") == 0);
}

TEST_CASE("soak report: each kind is told with how often it broke and how often it faded") {
    const std::string text = describe_soak(sum_of(make_whole()), {0.1, 2.0});
    INFO(text);
    check_says(text,
               {"Broke: packets lost 2, a long way 2", ", disk full 3.",
                "Faded: cable pulled 1, no pose 1, no number 1, a stuck sensor 1, motor refuses "
                "1, stop at the arm 1, world stands 1, lesson hangs 1, lesson killed 1.",
                "The hand: follows 1, presses 1, slides 1, jerks 1, lets go 1, touches 1.",
                "Deadlines under the virtual clock: 12 met."});
}
