#include "runtime/app/hand_fitting.h"

#include "runtime/progress/sqlite/sqlite_store.h"
#include "tests/support/scripted_device.h"
#include "tests/unit/runtime/rig.h"

using namespace fulcrum::runtime::test;

namespace {

DeviceTraits arm_reaching(const Vector3& reach_m) {
    DeviceTraits traits;
    traits.reach_m = reach_m;
    return traits;
}

RunRequest by_arm(const char* learner) {
    RunRequest request;
    request.hand = HandKind::link;
    request.hand_address = "arm:4701";
    request.learner = learner;
    return request;
}

// The same, once it has said what it is.
RunRequest met(const char* learner, const char* name) {
    RunRequest request = by_arm(learner);
    request.arm_name = name;
    return request;
}

}  // namespace

TEST_CASE("hand fitting: a small arm reaches what the usual one, a large one keeps its scale") {
    CHECK(choose_scale({}, arm_reaching(Vector3::Constant(0.2))) == 1.0);
    CHECK(choose_scale({}, arm_reaching({0.1, 0.2, 0.3})) == Approx(2.0));
    CHECK(choose_scale({}, arm_reaching({0.5, 0.6, 0.7})) == 1.0);
    CHECK(choose_scale({}, arm_reaching({0.08, 0.06, 0.01})) == kMostFitScale);
    // Along each axis the usual room lies within what is reached.
    const Vector3 reach_m(0.09, 0.15, 0.4);
    CHECK(choose_scale({}, arm_reaching(reach_m)) * reach_m.minCoeff() >= kUsualReach_m - 1e-12);
    // What is not known, or nonsense, changes nothing; what somebody says goes before.
    CHECK(choose_scale({}, {}) == 1.0);
    CHECK(choose_scale({}, arm_reaching({0.1, 0.1, std::nan("")})) == 1.0);
    CHECK(choose_scale({}, arm_reaching({-0.1, 0.1, 0.1})) == 1.0);
    CHECK(choose_scale({.scale = 1.5}, arm_reaching(Vector3::Constant(0.05))) == 1.0);
}

TEST_CASE("hand fitting: a verdict is of one device alone, but for a bad one that names none") {
    const std::string stick = "a stick";
    const HandFit good{.checked = verdict_of(true, stick)};
    const HandFit moves{.checked = verdict_of(false, stick)};
    const HandFit bad{.checked = bad_verdict_of(stick)};
    CHECK(is_tried(good, true, stick));
    CHECK(is_tried(good, false, stick));
    CHECK_FALSE(is_tried(moves, true, stick));
    CHECK(is_tried(moves, false, stick));
    for (const HandFit& fit : {bad, HandFit{.checked = "not good"}, HandFit{}}) {
        CHECK_FALSE(is_tried(fit, true, stick));
        CHECK_FALSE(is_tried(fit, false, stick));
    }
    CHECK_FALSE(is_tried(good, false, "another"));
    CHECK(is_refused(bad, stick));
    CHECK_FALSE(is_refused(bad, "another"));
    CHECK(is_refused({.checked = "not good"}, stick));
    for (const HandFit& fit : {good, moves, HandFit{}}) {
        CHECK_FALSE(is_refused(fit, stick));
    }
}

TEST_CASE("hand fitting: an arm has a clutch, and a pointer stays what it is") {
    const auto with = [](const RunRequest& request, std::uint32_t buttons) {
        auto inner = std::make_unique<ScriptedDevice>();
        inner->buttons = buttons;
        const auto device = fit_device(request, std::move(inner));
        DeviceReading reading;
        REQUIRE(device->read(0.0, reading));
        return reading;
    };
    RunRequest arm = by_arm("Mina");
    CHECK(any(with(arm, 4U).faults & Fault::clutched));
    CHECK(with(arm, 3U).buttons == 3U);
    arm.fit.clutch_button = 0;
    CHECK(with(arm, 4U).buttons == 4U);
    arm.fit.left_handed = true;
    CHECK(with(arm, 1U).buttons == 2U);
    RunRequest mouse;
    mouse.hand = HandKind::mouse;
    mouse.fit.left_handed = true;
    CHECK(with(mouse, 5U).buttons == 5U);
}

TEST_CASE("hand fitting: what a learner said once holds at the next run with the same device") {
    const ScratchFolder folder;
    const auto opened = value_of(open_sqlite_store(folder.file("progress.db")));
    ProgressStore& store = *opened;
    RunRequest first = by_arm("Mina");
    first.fit.scale = 2.0;
    first.fit.left_handed = true;
    keep_fit_of(first, store);
    const RunRequest again = with_kept_fit(by_arm("Mina"), store);
    CHECK(again.fit.scale == 2.0);
    CHECK(again.fit.left_handed == true);
    RunRequest other_arm = by_arm("Mina");
    other_arm.hand_address = "arm:4702";
    CHECK_FALSE(with_kept_fit(other_arm, store).fit.scale);
    CHECK(with_kept_fit(other_arm, store).fit.left_handed == true);
    // Nobody in particular keeps nothing.
    const std::size_t before = store.read({})->hands.size();
    RunRequest guest = by_arm("");
    guest.fit.scale = 3.0;
    keep_fit_of(guest, store);
    RunRequest simulated = by_arm(kSimulatedPupil);
    simulated.fit.scale = 3.0;
    keep_fit_of(simulated, store);
    CHECK(store.read({})->hands.size() == before);
    CHECK(with_kept_fit(by_arm(""), store).fit.scale == std::nullopt);
}

TEST_CASE("hand fitting: each device has a name of its own") {
    RunRequest request;
    CHECK(name_device(request) == "simulated hand");
    request.hand = HandKind::mouse;
    CHECK(name_device(request) == "mouse");
    request.hand = HandKind::hid;
    request.hid.node.vendor = 0x046d;
    request.hid.node.product = 0xc626;
    CHECK(name_device(request) == "hid:046d:c626");
    request.hid.node.serial = "A7";
    CHECK(name_device(request) == "hid:046d:c626 A7");
    CHECK(name_device(by_arm("Mina")) == "udp:arm:4701");
    CHECK(name_device(met("Mina", "Arm 1")) == "udp:arm:4701 Arm 1");
    RunRequest own = met("Mina", "omega.3 4711");
    own.own_arm = &kOwnArms.front();
    CHECK(name_device(own) == "arm omega.3 4711");
    request.hand = HandKind::replay;
    CHECK(name_device(request).empty());
}

TEST_CASE("hand fitting: another arm at the same port has nothing of the first") {
    const ScratchFolder folder;
    const auto store = value_of(open_sqlite_store(folder.file("progress.db")));
    RunRequest first = met("Mina", "Arm 1");
    first.fit = {.checked = verdict_of(true, "Arm 1")};
    REQUIRE(set_fit(first.fit, "axes", "y,x,-z"));
    keep_fit_of(first, *store);
    CHECK(with_kept_fit(met("Mina", "Arm 1"), *store).fit.axes);
    const HandFit other = with_kept_fit(met("Mina", "Arm 2"), *store).fit;
    CHECK_FALSE(other.axes);
    CHECK(other.checked.empty());
}

TEST_CASE(
    "hand fitting: what was kept of an address is the arm's that was tried there, and of no "
    "other") {
    const ScratchFolder folder;
    const auto store = value_of(open_sqlite_store(folder.file("progress.db")));
    RunRequest before = by_arm("Mina");
    before.fit = {.scale = 2.0, .checked = verdict_of(true, "Arm 1")};
    keep_fit_of(before, *store);
    const HandFit other = with_kept_fit(met("Mina", "Arm 2"), *store).fit;
    CHECK_FALSE(other.scale);
    CHECK(other.checked.empty());
    const HandFit own = with_kept_fit(met("Mina", "Arm 1"), *store).fit;
    CHECK(own.scale == 2.0);
    CHECK(is_tried(own, true, "Arm 1"));
    // It is kept under its own name from then on: what is said later under the address alone changes nothing.
    before.fit.scale = 3.0;
    keep_fit_of(before, *store);
    CHECK(with_kept_fit(met("Mina", "Arm 1"), *store).fit.scale == 2.0);
}

TEST_CASE(
    "hand fitting: a stick takes over how its kind was set, and is tried anew; its twin has a "
    "verdict of its own") {
    const ScratchFolder folder;
    const auto store = value_of(open_sqlite_store(folder.file("progress.db")));
    RunRequest stick;
    stick.hand = HandKind::hid;
    stick.learner = "Mina";
    stick.fit = {.scale = 2.0, .checked = verdict_of(true, "Stick")};
    keep_fit_of(stick, *store);
    stick.fit = {};
    stick.hid.node.serial = "A7";
    HandFit fit = with_kept_fit(stick, *store).fit;
    CHECK(fit.scale == 2.0);
    CHECK(fit.checked.empty());
    RunRequest tried = stick;
    tried.fit = {.checked = verdict_of(true, "Stick")};
    keep_fit_of(tried, *store);
    CHECK(is_tried(with_kept_fit(stick, *store).fit, true, "Stick"));
    stick.hid.node.serial = "B8";
    CHECK_FALSE(is_tried(with_kept_fit(stick, *store).fit, true, "Stick"));
}
