#include "runtime/arms/hd/hd_servo.h"

#include "runtime/arms/hd/hd_start.h"
#include "runtime/arms/hd/hd_trouble.h"
#include "tests/support/maker_stand_in.h"

#include <catch2/catch.hpp>

namespace fulcrum::runtime {
namespace {

// A library whose scheduler the test is.
struct Ticked final : HdExchange {
    test_support::MakerStandIn stand_in{FULCRUM_HD_STAND_IN};
    HdFunctions use = load_hd(stand_in.path())->use;
    HdFound found = *find_hd_arm(use, 10.0);
    HdServo servo{use, found.handle, found.calibration_style, found.traits, *this};
    Wrench wanted{.force = {1.0, 0.0, 0.0}};
    ArmSample newest;
    int exchanges = 0;
    double now_s = 50.0;

    Ticked() {
        use.enable(hd_force_output);
        stand_in.set("scheduler", 1.0);
    }
    [[nodiscard]] Wrench exchange(const ArmSample& sample) noexcept override {
        newest = sample;
        ++exchanges;
        return wanted;
    }
    void tick(int n = 1) {
        for (int i = 0; i < n; ++i) {
            now_s += 0.001;
            servo.tick(now_s);
        }
    }
    [[nodiscard]] Vector3 felt() const {
        return {stand_in.get("force", "x"), stand_in.get("force", "y"), stand_in.get("force", "z")};
    }
    [[nodiscard]] bool is_let_go() const { return !newest.is_there && felt() == Vector3::Zero(); }
};

}  // namespace

TEST_CASE(
    "hd servo: millimetres of a frame that is ours become metres, and forces go as they are") {
    Ticked ticked;
    ticked.stand_in.set("x", 0.01);
    ticked.stand_in.set("y", -0.02);
    ticked.stand_in.set("z", 0.03);
    ticked.stand_in.set("buttons", 2);
    ticked.wanted.force = {0.5, -1.0, 1.5};
    ticked.tick(30);
    REQUIRE(ticked.newest.is_there);
    CHECK(ticked.newest.pose_D.position.x() == Approx(ticked.stand_in.get("at", "x")));
    CHECK(ticked.newest.pose_D.position.y() == Approx(ticked.stand_in.get("at", "y")));
    CHECK(ticked.newest.pose_D.position.z() == Approx(ticked.stand_in.get("at", "z")));
    CHECK(ticked.newest.stamp_s == ticked.now_s);
    CHECK(ticked.newest.buttons == 2);
    CHECK(ticked.felt() == Vector3{0.5, -1.0, 1.5});
    // Each within a frame, of things that it knows.
    CHECK(ticked.servo.trouble() == hd_no_error);
}

TEST_CASE(
    "hd servo: a matrix is read column after column, and is a turn of length 1 though it is skew") {
    Ticked ticked;
    ticked.stand_in.set("turn", 0.6);
    ticked.stand_in.set("skew", 1.0e-3);
    ticked.tick();
    REQUIRE(ticked.newest.is_there);
    CHECK(std::abs(ticked.newest.pose_D.orientation.norm() - 1.0) < 1.0e-12);
    CHECK(ticked.newest.pose_D.orientation.angularDistance(
              Quaternion(AngleAxis(0.6, Vector3::UnitY()))) < 2.0e-3);
}

TEST_CASE("hd servo: no more than the arm's own limit is given, and nothing that is no number") {
    Ticked ticked;
    ticked.wanted.force = {0.0, 30.0, -40.0};
    ticked.tick();
    CHECK(ticked.felt().norm() == Approx(3.3));
    CHECK(ticked.felt().y() > 0.0);
    ticked.wanted.force = {std::numeric_limits<double>::quiet_NaN(), 1.0, 1.0};
    ticked.tick();
    CHECK(ticked.felt() == Vector3::Zero());
}

TEST_CASE(
    "hd servo: there is no force before the arm knows its zero; what helps is done once it can") {
    Ticked ticked;
    ticked.stand_in.set("calibration", hd_needs_person);
    ticked.tick(100);
    CHECK(ticked.servo.trouble() == hd_needs_person);
    CHECK(ticked.is_let_go());
    CHECK(ticked.stand_in.get("asked") == 0.0);
    CHECK(ticked.stand_in.get("updates") == 0.0);

    ticked.stand_in.set("calibration", hd_needs_update);
    ticked.tick(kHdCalibrationEvery);
    CHECK(ticked.stand_in.get("updates") == 1.0);
    CHECK(ticked.stand_in.get("style") == 4.0);
    CHECK(ticked.stand_in.get("asked") == 0.0);
    ticked.tick(kHdCalibrationEvery);
    CHECK(ticked.newest.is_there);
    CHECK(ticked.felt().x() == 1.0);
    CHECK(ticked.stand_in.get("updates") == 1.0);

    // Also where it is lost in the middle: within twenty ticks.
    ticked.stand_in.set("calibration", hd_needs_person);
    ticked.tick(kHdCalibrationEvery);
    CHECK(ticked.is_let_go());
}

TEST_CASE(
    "hd servo: after each error there is no force from the next tick on, for a rest, and then it "
    "is switched on again") {
    for (const std::uint32_t code :
         {0x0102, 0x0200, 0x0201, 0x0202, 0x0203, 0x0204, 0x0300, 0x0302, 0x0303, 0x0402, 0x0600}) {
        INFO(std::hex << code);
        Ticked ticked;
        ticked.tick(5);
        REQUIRE(ticked.felt().x() == 1.0);
        ticked.stand_in.set("raise", code);
        ticked.tick();  // in which it is noticed
        ticked.stand_in.set("asked", 0.0);
        ticked.tick();
        CHECK(ticked.is_let_go());
        CHECK(ticked.servo.trouble() == code);
        const int rest = static_cast<int>(rest_after_s(code) / 0.001);
        ticked.tick(rest - 5);
        CHECK(ticked.is_let_go());
        CHECK(ticked.stand_in.get("asked") == 0.0);
        ticked.tick(10);
        CHECK(ticked.newest.is_there);
        CHECK(ticked.servo.trouble() == hd_no_error);
        CHECK(ticked.felt().x() == 1.0);
    }
}

TEST_CASE("hd servo: an error that comes again and again gives no moment of force") {
    Ticked ticked;
    ticked.tick(5);
    ticked.stand_in.set("raise", hd_bad_configuration);
    ticked.tick();
    ticked.stand_in.set("asked", 0.0);
    for (int i = 0; i < 3000; ++i) {
        if (i % 500 == 0) {
            ticked.stand_in.set("raise", hd_bad_configuration);
        }
        ticked.tick();
    }
    CHECK(ticked.stand_in.get("asked") == 0.0);
}

TEST_CASE("hd servo: a timer's error at first is a habit, and later one like others") {
    Ticked ticked;
    ticked.tick(5);
    ticked.stand_in.set("raise", hd_timer);
    ticked.tick(2);
    CHECK(ticked.newest.is_there);
    ticked.tick(1100);
    ticked.stand_in.set("raise", hd_timer);
    ticked.tick(2);
    CHECK(ticked.is_let_go());
    CHECK(ticked.servo.trouble() == hd_timer);
}

TEST_CASE(
    "hd servo: what is no pose is none, in the tick in which it comes, and when it is over there "
    "is one") {
    for (const auto& [what, value] :
         {std::pair{"tells nothing", 1.0}, {"far away", 1.0}, {"skew", 0.3}}) {
        INFO(what);
        Ticked ticked;
        // Off zero, so that what is far away is far away.
        ticked.stand_in.set("x", 0.02);
        const double until_s = monotonic_now_s() + 0.05;
        while (monotonic_now_s() < until_s) {
            ticked.tick();
        }
        REQUIRE(ticked.newest.is_there);
        ticked.stand_in.set("asked", 0.0);
        ticked.stand_in.set(what, value);
        ticked.tick();
        CHECK(ticked.is_let_go());
        CHECK(is_finite(ticked.newest.pose_D));
        CHECK(ticked.servo.trouble() == kHdNoNumber);
        CHECK(ticked.stand_in.get("asked") == 0.0);
        ticked.stand_in.set(what, 0.0);
        ticked.tick();
        CHECK(ticked.newest.is_there);
        CHECK(ticked.felt().x() == 1.0);
    }
}

TEST_CASE("hd servo: shut it gives no force and leaves the port alone, however often it ticks") {
    Ticked ticked;
    ticked.tick(5);
    ticked.servo.shut();
    const int exchanges = ticked.exchanges;
    ticked.tick(5);
    CHECK(ticked.exchanges == exchanges);
    CHECK(ticked.felt() == Vector3::Zero());
    CHECK(ticked.servo.ticks() == 10);
    CHECK_FALSE(ticked.servo.is_inside());
}

}  // namespace fulcrum::runtime
