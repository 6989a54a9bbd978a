#include "runtime/arms/haply/haply_port.h"

#include "haptics/device/watched/sensor_guard.h"
#include "runtime/arms/haply/haply_traits.h"
#include "tests/support/scratch_folder.h"
#include "tests/unit/runtime/arms/haply/haply_rig.h"

#include <catch2/catch.hpp>

#include <sstream>

namespace fulcrum::runtime {
namespace {

using test_support::eventually;
using test_support::HaplyOptions;
using test_support::HaplyService;
using test_support::StandInGrip;

std::string find_fact(const ArmPort& port, const std::string& name) {
    for (const ArmFact& fact : port.facts()) {
        if (fact.first == name) {
            return fact.second;
        }
    }
    return "none";
}

bool comes_to(HaplyRig& rig, const Vector3& position_D, double within_m) {
    return eventually([&] {
        const RigSeen seen = rig.seen();
        return seen.is_there && (seen.reading.pose_D.position - position_D).norm() < within_m;
    });
}

}  // namespace

TEST_CASE("haply port: a place is in frame D, from the middle of the arm's space") {
    HaplyRig rig;
    REQUIRE(rig.open(always(Vector3::Zero())));
    CHECK(rig.port().traits().name == "Haply Inverse3 049D");
    CHECK(comes_to(rig, Vector3::Zero(), 2.0e-3));
    for (const Vector3& place :
         {Vector3(0.03, 0.0, 0.0), Vector3(0.0, 0.03, 0.0), Vector3(0.0, 0.0, 0.03)}) {
        rig.service().move_hand(place);
        CHECK(comes_to(rig, place, 2.0e-3));
    }
    CHECK(rig.told_but_silence().empty());
    CHECK_FALSE(rig.service().felt().was_unmasked);
}

TEST_CASE("haply port: a wall holds the hand where its springs balance, in each direction") {
    HaplyRig rig;
    constexpr double kWall_N_per_m = 500.0;
    REQUIRE(rig.open([](const Vector3& p) { return Vector3(-kWall_N_per_m * p); }));
    for (int axis = 0; axis < 3; ++axis) {
        CAPTURE(axis);
        // kArm's 135 N/m pull 20 mm away: 4.25 mm remain, and 2.1 N.
        rig.service().move_hand(0.02 * Vector3::Unit(axis));
        const double share = kArm.stiffness_N_per_m / (kArm.stiffness_N_per_m + kWall_N_per_m);
        const Vector3 place = 0.02 * share * Vector3::Unit(axis);
        CHECK(comes_to(rig, place, 1.5e-3));
        CHECK(eventually(
            [&] { return (rig.service().felt().force_D + kWall_N_per_m * place).norm() < 0.6; }));
    }
    CHECK(rig.service().felt().peak_N < kHaplyForce_N + 1.0e-6);
    CHECK(find_fact(rig.port(), "haply force word") == "vector");
}

TEST_CASE("haply port: never more than the arm's limit, and nothing that is no number") {
    HaplyRig rig;
    REQUIRE(rig.open(always({0.0, 40.0, 0.0})));
    CHECK(rig.feels({0.0, kHaplyForce_N, 0.0}));
    rig.push(always({0.0, std::nan(""), 0.0}));
    CHECK(rig.feels_nothing());
    CHECK(rig.service().felt().peak_N < kHaplyForce_N + 1.0e-6);
}

TEST_CASE("haply port: the other word is found, each way round") {
    const auto word_with = [](const std::string& version, bool takes_vector) {
        HaplyOptions options;
        options.version = version;
        options.takes_vector = takes_vector;
        options.takes_values = !takes_vector;
        HaplyRig rig(options);
        REQUIRE(rig.open(always({1.0, 0.0, 0.0})));
        CHECK(rig.feels({1.0, 0.0, 0.0}));
        return find_fact(rig.port(), "haply force word");
    };
    CHECK(word_with("3.5.0", true) == "vector");
    CHECK(word_with("3.5.0", false) == "values");
    CHECK(word_with("3.4.8", false) == "values");
    CHECK(word_with("3.4.8", true) == "vector");
}

TEST_CASE("haply port: where no echo comes, no more than 0.2 N were tried, and then none") {
    HaplyOptions options;
    options.takes_values = true;
    options.echoes = false;
    HaplyRig rig(options);
    REQUIRE(rig.open(always({1.0, 0.0, 0.0})));
    CHECK(rig.is_told("takes no force from here"));
    CHECK(rig.feels_nothing());
    CHECK(rig.service().felt().peak_N < 0.2 + 1.0e-6);
    // Its place is still told, and so is the fault.
    CHECK(eventually([&] { return rig.seen().reading.faults == Fault::device_write; }));
    CHECK(rig.seen().is_there);
}

TEST_CASE("haply port: a loop that hangs is felt no longer than its silence") {
    HaplyRig rig;
    REQUIRE(rig.open(always({0.0, 1.0, 0.0})));
    REQUIRE(rig.feels({0.0, 1.0, 0.0}));
    rig.hang_loop(true);
    const auto before = rig.service().felt();
    CHECK(rig.feels_nothing());
    // The stream goes on: one zero a round.
    const auto after = rig.service().felt();
    CHECK(eventually([&] { return rig.service().felt().messages > after.messages + 50; }));
    // At 1 kHz those of 20 ms, and what was on its way.
    CHECK(rig.service().felt().pushes - before.pushes <= 30);
    rig.hang_loop(false);
    CHECK(rig.feels({0.0, 1.0, 0.0}));
}

TEST_CASE("haply port: stopped, it leaves no force, says goodbye, and is gone within a second") {
    HaplyRig rig;
    REQUIRE(rig.open(always({0.0, 1.0, 0.0})));
    REQUIRE(rig.feels({0.0, 1.0, 0.0}));
    const double begun_s = monotonic_now_s();
    rig.port().stop();
    CHECK(monotonic_now_s() - begun_s < 1.0);
    CHECK(rig.feels_nothing());
    CHECK(eventually([&] { return !rig.service().felt().has_session; }));
    CHECK(rig.service().felt().said_goodbye);
    CHECK(eventually([&] { return !rig.seen().is_there; }));
    rig.port().stop();
}

TEST_CASE("haply port: a grip turns the tool and has its buttons; asleep it keeps its turn") {
    HaplyOptions options;
    options.grip = StandInGrip::wireless;
    options.grip_buttons = "a,c";
    HaplyRig rig(options);
    const Quaternion turn(AngleAxis(0.8, Vector3(0.6, 0.0, 0.8)));
    rig.service().move_hand(Vector3::Zero(), turn);
    REQUIRE(rig.open(always(Vector3::Zero())));
    const auto is_turned = [&] {
        return rig.seen().reading.pose_D.orientation.angularDistance(turn) < 1.0e-6;
    };
    CHECK(eventually([&] { return is_turned() && rig.seen().reading.buttons == 0b101; }));
    rig.service().change([](HaplyOptions& now) { now.grip = StandInGrip::asleep; });
    CHECK(eventually([&] { return rig.seen().reading.buttons == 0; }));
    rig.service().change([](HaplyOptions& now) { now.grip = StandInGrip::none; });
    CHECK(is_turned());
    CHECK(rig.seen().is_there);
    rig.service().change([](HaplyOptions& now) {
        now.grip = StandInGrip::wireless;
        now.grip_buttons = "button_1";
    });
    CHECK(eventually([&] { return rig.seen().reading.buttons == 0b10; }));
    CHECK(rig.told_but_silence().empty());
}

TEST_CASE("haply port: however messages are cut, counted and shortened, it is the same arm") {
    HaplyOptions options;
    options.wire = {.in_fragments = true, .pings = true, .long_lengths = true};
    options.leaves_out = true;
    options.grip = StandInGrip::wired;
    HaplyRig rig(options);
    REQUIRE(rig.open(always({0.0, 0.0, 1.0})));
    CHECK(rig.feels({0.0, 0.0, 1.0}));
    CHECK(eventually([&] { return rig.service().felt().pongs > 20; }));
    // A state of the 3.0 form has another word for the mode, and tells nothing of the status.
    rig.service().change([](HaplyOptions& now) { now.speaks_3_0 = true; });
    const auto messages = rig.service().felt().messages;
    CHECK(eventually([&] { return rig.service().felt().messages > messages + 100; }));
    CHECK(rig.feels({0.0, 0.0, 1.0}));
    CHECK(rig.told_but_silence().empty());
}

TEST_CASE("haply port: the middle is where the handle rests, and who never rests is told") {
    HaplyRig rig;
    rig.settings().centre_A.reset();
    const Vector3 middle(0.02, -0.01, 0.03);
    rig.service().move_hand(middle);
    REQUIRE(eventually([&] { return (rig.service().felt().position_D - middle).norm() < 1.0e-3; }));
    REQUIRE(rig.open(always(Vector3::Zero())));
    CHECK(comes_to(rig, Vector3::Zero(), 2.0e-3));
    rig.service().move_hand(middle + Vector3(0.0, 0.02, 0.0));
    CHECK(comes_to(rig, {0.0, 0.02, 0.0}, 2.5e-3));

    HaplyRig restless;
    restless.settings().centre_A.reset();
    restless.settings().rest_wait_s = 1.0;
    restless.service().move_hand(Vector3::Zero(), Quaternion::Identity(), 0.2);
    CHECK_FALSE(restless.open(always(Vector3::Zero())));
    CHECK(restless.why.find("never still") != std::string::npos);
}

TEST_CASE("haply port: messages are kept as they came where a file is named") {
    const ScratchFolder folder;
    HaplyRig rig;
    rig.settings().log_file = folder.file("arm.log");
    REQUIRE(rig.open(always({1.0, 0.0, 0.0})));
    CHECK(rig.feels({1.0, 0.0, 0.0}));
    rig.port().stop();
    rig.stop_loop();
    std::ifstream file(folder.file("arm.log"));
    std::ostringstream all;
    all << file.rdbuf();
    CHECK(all.str().find("< {\"git_describe\"") != std::string::npos);
    CHECK(all.str().find("\"permutation\":\"XYZ\"") != std::string::npos);
    CHECK(all.str().find("> {\"inverse3\":[{\"device_id\":\"049D\"") != std::string::npos);

    HaplyRig other;
    other.settings().log_file = folder.file("no/arm.log");
    CHECK_FALSE(other.open(always(Vector3::Zero())));
    CHECK(other.why.find("cannot be kept there") != std::string::npos);
}

TEST_CASE("haply port: what is known of its sensors is taken by the guard") {
    HaplyRig rig;
    REQUIRE(rig.open(always(Vector3::Zero())));
    CHECK(validate(rig.port().sensor()));
    CHECK(rig.port().sensor().trembles_within_s > 0.0);
}

// Figures for people, of this machine at this time: test_unit_arms "[.measure]"
TEST_CASE("haply port: rate, and age of a place when it is read", "[.measure]") {
    HaplyRig rig;
    REQUIRE(rig.open(always({0.0, 0.5, 0.0})));
    REQUIRE(rig.feels({0.0, 0.5, 0.0}));
    const auto before = rig.service().felt().messages;
    const double begun_s = monotonic_now_s();
    std::vector<double> ages_s;
    rig.stop_loop();
    for (double next_s = begun_s; next_s < begun_s + 3.0; next_s += 0.001) {
        std::this_thread::sleep_for(std::chrono::duration<double>(next_s - monotonic_now_s()));
        const double now_s = monotonic_now_s();
        DeviceReading reading;
        if (rig.device().read(now_s, reading)) {
            ages_s.push_back(now_s - reading.stamp_s);
        }
        (void)rig.device().write(now_s, {.force = Vector3(0.0, 0.5, 0.0)});
    }
    const double seconds = monotonic_now_s() - begun_s;
    const auto rounds = rig.service().felt().messages - before;
    std::sort(ages_s.begin(), ages_s.end());
    REQUIRE_FALSE(ages_s.empty());
    const auto at = [&](double share) {
        return 1e6 *
               ages_s[static_cast<std::size_t>(share * static_cast<double>(ages_s.size() - 1))];
    };
    WARN(rounds << " rounds in " << seconds << " s (" << static_cast<double>(rounds) / seconds
                << " Hz); age of a place, us: p50 " << at(0.5) << ", p90 " << at(0.9) << ", p99 "
                << at(0.99) << ", most " << at(1.0) << "; read " << ages_s.size());
}

}  // namespace fulcrum::runtime
