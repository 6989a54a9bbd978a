// What may go wrong while a force is on: none is left, people are told, and where it can come back it does.
#include "runtime/arms/haply/haply_port.h"
#include "tests/support/scratch_folder.h"
#include "tests/unit/runtime/arms/haply/haply_rig.h"

#include <catch2/catch.hpp>

namespace fulcrum::runtime {
namespace {

using test_support::eventually;
using test_support::HaplyFelt;
using test_support::HaplyOptions;
using test_support::HaplyService;

using Change = std::function<void(HaplyOptions&)>;

const Vector3 kPush{0.0, 1.0, 0.0};
// Messages with a force that may come behind a fault: those on their way. One comes a round, so the machine's load does not count.
constexpr std::uint64_t kOnTheWay = 5;

// One that is pushed with 1 N, whose force alternates by a little so that a state that repeats is seen.
struct Pushed {
    explicit Pushed(const HaplyOptions& options = {}) : rig(options) {
        REQUIRE(rig.open([n = 0](const Vector3&) mutable {
            return Vector3(kPush + Vector3(0.0, ++n / 50 % 2 == 0 ? 0.6 : 0.0, 0.0));
        }));
        REQUIRE(is_felt());
    }
    bool is_felt() {
        return eventually([&] { return rig.service().felt().force_D.y() > 0.9; });
    }
    // Does this to the service; how many pushes came behind it until there were none.
    std::uint64_t pushes_behind(const Change& change) {
        rig.service().change(change);
        REQUIRE(rig.feels_nothing());
        CHECK(eventually([&] { return !rig.seen().is_there; }));
        return rig.service().felt().pushes;
    }
    HaplyRig rig;
};

// The fault, what people are told, and that it is back when the service is as it was.
void check_fault(const Change& fault, const std::string& words, std::uint64_t most_pushes) {
    CAPTURE(words);
    Pushed pushed;
    CHECK(pushed.pushes_behind(fault) <= most_pushes);
    CHECK(pushed.rig.is_told(words));
    pushed.rig.service().change([](HaplyOptions& now) { now = HaplyOptions{}; });
    CHECK(pushed.is_felt());
    CHECK(pushed.rig.is_told("Haply Inverse3 049D is back."));
}

// Likewise, but force stays off, whatever the service says then.
void check_change(const Change& change, const std::string& what) {
    CAPTURE(what);
    Pushed pushed;
    (void)pushed.pushes_behind(change);
    CHECK(pushed.rig.is_told("gives no more force, for somebody has changed " + what));
    pushed.rig.service().change([](HaplyOptions& now) { now = HaplyOptions{}; });
    const HaplyFelt then = pushed.rig.service().felt();
    CHECK(
        eventually([&] { return pushed.rig.service().felt().full_states > then.full_states + 1; }));
    CHECK(pushed.rig.service().felt().pushes == then.pushes);
    CHECK_FALSE(pushed.rig.seen().is_there);
}

}  // namespace

TEST_CASE("haply faults: messages that make no sense") {
    check_fault([](HaplyOptions& now) { now.is_malformed = true; },
                "it sends text that is no message", kOnTheWay);
    check_fault([](HaplyOptions& now) { now.has_no_number = true; }, "whose y makes no sense",
                kOnTheWay);
}

TEST_CASE("haply faults: an arm that is unplugged, without power or not calibrated") {
    check_fault([](HaplyOptions& now) { now.ids.clear(); }, "has gone: plug it in again",
                kOnTheWay);
    check_fault([](HaplyOptions& now) { now.has_power = false; }, "has no power", kOnTheWay);
    check_fault([](HaplyOptions& now) { now.is_calibrated = false; }, "is not calibrated",
                kOnTheWay);
}

TEST_CASE("haply faults: a service that takes commands and answers none") {
    // One command each 10 ms: those of 20 ms, and what was on its way.
    check_fault([](HaplyOptions& now) { now.is_silent = true; }, "does not answer", kOnTheWay);
}

TEST_CASE("haply faults: a service that hangs gets zero as the last of what waits for it") {
    Pushed pushed;
    pushed.rig.service().change([](HaplyOptions& now) { now.hangs = true; });
    CHECK(pushed.rig.is_told("does not answer"));
    CHECK(eventually([&] { return !pushed.rig.seen().is_there; }));
    pushed.rig.service().change([](HaplyOptions& now) { now.hangs = false; });
    CHECK(pushed.is_felt());
    CHECK(pushed.rig.is_told("is back."));
}

TEST_CASE("haply faults: a line that ends in the middle of a frame is opened anew") {
    Pushed pushed;
    const HaplyFelt before = pushed.rig.service().felt();
    pushed.rig.service().change([](HaplyOptions& now) { now.cuts_off = true; });
    CHECK(pushed.rig.is_told("has lost its service, for the connection is cut off"));
    CHECK(pushed.rig.is_told("is back."));
    CHECK(pushed.is_felt());
    CHECK(pushed.rig.service().felt().sessions == before.sessions + 1);
}

TEST_CASE("haply faults: a service that ends is looked for until it is there again") {
    Pushed pushed;
    pushed.rig.service().go_away(true);
    CHECK(pushed.rig.is_told("is not there: 127.0.0.1:"));
    CHECK(pushed.rig.is_told("no Haply service answers"));
    CHECK(pushed.rig.feels_nothing());
    CHECK_FALSE(pushed.rig.seen().is_there);
    pushed.rig.service().go_away(false);
    CHECK(pushed.is_felt());
    CHECK(pushed.rig.is_told("is back."));
    // The proof is asked for anew, and the limit rises anew.
    CHECK(pushed.rig.service().felt().sessions == 2);
}

TEST_CASE("haply faults: a session that begins in another state than the first is not pushed") {
    Pushed pushed;
    pushed.rig.service().go_away(true);
    CHECK(pushed.rig.is_told("no Haply service answers"));
    pushed.rig.service().change([](HaplyOptions& now) { now.basis = "XZY"; });
    pushed.rig.service().go_away(false);
    CHECK(pushed.rig.is_told("its basis is XZY"));
    pushed.rig.service().change([](HaplyOptions& now) { now.basis = "XYZ"; });
    CHECK(pushed.is_felt());
}

TEST_CASE("haply faults: a state that repeats while the force changes") {
    // At 1 kHz those until the force changes, which this one does within 50 rounds of the loop, and 30 ms.
    check_fault([](HaplyOptions& now) { now.repeats = true; }, "tells the same again and again",
                400);
}

TEST_CASE("haply faults: answers that are late, but within the silence, take no force away") {
    Pushed pushed;
    pushed.rig.service().change([](HaplyOptions& now) { now.delay_s = 0.003; });
    const HaplyFelt then = pushed.rig.service().felt();
    CHECK(eventually([&] { return pushed.rig.service().felt().messages > then.messages + 60; }));
    CHECK(pushed.is_felt());
}

TEST_CASE(
    "haply faults: after an answer that came too late each state is that of its own order again") {
    const ScratchFolder folder;
    const std::string path = folder.file("arm.log");
    HaplyRig rig;
    rig.settings().log_file = path;
    // Another force each time, so that an order is told from the one before it.
    REQUIRE(rig.open([n = 0](const Vector3&) mutable {
        return Vector3(0.5 + 1.0e-5 * (++n % 1000), 0.0, 0.0);
    }));
    const auto goes_on = [&](std::uint64_t rounds) {
        const auto then = rig.service().felt().messages;
        return eventually([&] { return rig.service().felt().messages >= then + rounds; });
    };
    REQUIRE(goes_on(300));
    rig.service().change([](HaplyOptions& now) {
        now.delay_s = 0.015;
        now.delays_once = true;
    });
    REQUIRE(goes_on(400));
    rig.port().stop();
    rig.stop_loop();
    // Of the last answers nearly all tell the force of the order just before them.
    std::vector<bool> is_its_own;
    std::ifstream file(path);
    std::string ordered;
    for (std::string line; std::getline(file, line);) {
        const auto number_behind = [&](const char* words) {
            const std::size_t at = line.find("\"x\":", line.find(words));
            return at == std::string::npos ? std::string() : line.substr(at + 4, 7);
        };
        if (line.find(" > ") != std::string::npos) {
            ordered = number_behind("set_cursor_force");
        } else if (!ordered.empty() && line.find("current_cursor_force") != std::string::npos) {
            const double differs =
                std::stod(number_behind("current_cursor_force")) - std::stod(ordered);
            is_its_own.push_back(std::abs(differs) < 0.5e-5);
        }
    }
    REQUIRE(is_its_own.size() > 300);
    CHECK(std::count(is_its_own.end() - 200, is_its_own.end(), true) > 150);
}

TEST_CASE("haply faults: whatever somebody changes in the session ends the force until a restart") {
    check_change([](HaplyOptions& now) { now.basis = "XZY"; }, "the basis");
    check_change([](HaplyOptions& now) { now.mount_scale = 2.0; }, "the mount");
    check_change([](HaplyOptions& now) { now.gate_gain = 0.9; }, "the filters");
}

TEST_CASE("haply faults: a changed transform stands in every state, and ends the force at once") {
    Pushed pushed;
    CHECK(pushed.pushes_behind([](HaplyOptions& now) { now.transform_scale = 2.0; }) <= kOnTheWay);
    CHECK(pushed.rig.is_told("the transform"));
}

TEST_CASE("haply faults: a scale of forces that appears in a wall ends it within the second") {
    Pushed pushed;
    CHECK(pushed.pushes_behind([](HaplyOptions& now) { now.force_scale = 2.0; }) <= 1500);
    CHECK(pushed.rig.is_told("the scale of forces"));
}

// Figures for people, of this machine at this time: test_unit_arms "[.measure]"
TEST_CASE("haply faults: how long a force stays", "[.measure]") {
    struct Named {
        const char* name;
        Change change;
    };
    const Named faults[] = {
        {"nonsense", [](HaplyOptions& now) { now.is_malformed = true; }},
        {"no number", [](HaplyOptions& now) { now.has_no_number = true; }},
        {"no power", [](HaplyOptions& now) { now.has_power = false; }},
        {"unplugged", [](HaplyOptions& now) { now.ids.clear(); }},
        {"silent", [](HaplyOptions& now) { now.is_silent = true; }},
        {"cut off", [](HaplyOptions& now) { now.cuts_off = true; }},
        {"repeats", [](HaplyOptions& now) { now.repeats = true; }},
        {"transform", [](HaplyOptions& now) { now.transform_scale = 2.0; }},
        {"basis", [](HaplyOptions& now) { now.basis = "XZY"; }},
        {"force scale", [](HaplyOptions& now) { now.force_scale = 2.0; }},
    };
    for (const Named& fault : faults) {
        Pushed pushed;
        const double begun_s = monotonic_now_s();
        pushed.rig.service().change(fault.change);
        CHECK(pushed.rig.feels_nothing());
        WARN(fault.name << ": " << 1e3 * (monotonic_now_s() - begun_s)
                        << " ms until nothing is felt");
    }
    Pushed pushed;
    const double begun_s = monotonic_now_s();
    pushed.rig.hang_loop(true);
    CHECK(pushed.rig.feels_nothing());
    WARN("loop hangs: " << 1e3 * (monotonic_now_s() - begun_s) << " ms until nothing is felt");
}

}  // namespace fulcrum::runtime
