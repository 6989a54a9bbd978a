#include "runtime/app/own_arm.h"

#include "tests/support/eventually.h"
#include "tests/support/scratch_folder.h"
#include "tests/unit/runtime/rig.h"

#include <filesystem>

using namespace fulcrum::runtime::test;
using namespace fulcrum::test_support;

namespace {

// An arm's program that is a line of the shell; --port and the port stand behind it.
Expected<std::unique_ptr<OwnArm>> start(const std::string& script) {
    return OwnArm::start({"/bin/sh", "-c", script, "arm"}, "The arm");
}

std::string notice_of(OwnArm& arm) {
    std::string told;
    REQUIRE(eventually([&] { return !(told = arm.take_notice()).empty(); }));
    return told;
}

}  // namespace

TEST_CASE("own arm: it waits where its program says, and what that tells is told once") {
    const auto arm = value_of(start("echo at 4711; echo told The pen is warm.; cat"));
    CHECK(arm->address() == "127.0.0.1:4711");
    CHECK(notice_of(*arm) == "The pen is warm.");
    CHECK(arm->take_notice().empty());
}

TEST_CASE("own arm: what the program refuses is refused in its own words") {
    CHECK(error_of(start("echo error plug in the power supply; exit 2")).message ==
          "The arm: plug in the power supply");
    CHECK(error_of(start("exit 2")).message ==
          "The arm does not begin: the program /bin/sh has ended");
}

TEST_CASE("own arm: one that ends is started again at its port, and both are said") {
    const ScratchFolder folder;
    const std::string mark = (folder.path() / "again").string();
    // The second time it is told the port that it had: --port is $1, the port $2.
    const auto arm = value_of(start("[ \"$2\" = 4711 ] && : >'" + mark +
                                    "'; echo at 4711; [ \"$2\" = 4711 ] && exec cat; exit 1"));
    std::string told;
    REQUIRE(eventually([&] {
        told += arm->take_notice();
        return told.find("The arm is back.") != std::string::npos;
    }));
    CHECK(told.starts_with("The arm has gone: its program is started again."));
    CHECK(std::filesystem::exists(mark));
    CHECK(arm->n_restarts() == 1);
    CHECK(arm->address() == "127.0.0.1:4711");
}

TEST_CASE("own arm: that the arm may move by itself is said the first time, and never again") {
    // It waits only where it is told so the first time, and only where it is not the second.
    const std::string script =
        "case \"$*\" in *--initialise*0) echo at 4711; exit 1;; *--initialise*) echo error told "
        "again;; "
        "*4711) echo at 4711; exec cat;; *) echo error not told;; esac";
    const auto arm =
        value_of(OwnArm::start({"/bin/sh", "-c", script, "arm", "--initialise"}, "The arm"));
    std::string told;
    REQUIRE(eventually([&] {
        told += arm->take_notice();
        return told.find("The arm is back.") != std::string::npos;
    }));
    CHECK(told.find("told again") == std::string::npos);
}

TEST_CASE("own arm: one that is started again is told where it was, so that its middle stays") {
    const std::string script =
        "case \"$*\" in *'4711 --centre 0.1,0.2,0.3') echo at 4711; exec cat;; *4711*) echo error "
        "elsewhere;; "
        "*) echo 'same --centre 0.1,0.2,0.3'; echo at 4711; exit 1;; esac";
    const auto arm = value_of(start(script));
    std::string told;
    REQUIRE(eventually([&] {
        told += arm->take_notice();
        return told.find("The arm is back.") != std::string::npos;
    }));
    CHECK(told.find("elsewhere") == std::string::npos);
}

TEST_CASE("own arm: why one does not come back is said once, however often it is tried") {
    const auto arm = value_of(start("[ \"$2\" = 0 ] && exec echo at 4711; echo error no power"));
    std::string told;
    REQUIRE(eventually([&] {
        told += arm->take_notice();
        return told.find("no power") != std::string::npos;
    }));
    std::this_thread::sleep_for(std::chrono::duration<double>(1.5 * kArmAgain_s));
    CHECK(arm->take_notice().empty());
}

TEST_CASE("own arm: it is given time to take the force away, and ends with the run") {
    const ScratchFolder folder;
    const std::string mark = (folder.path() / "ended").string();
    value_of(start("echo at 4711; cat; : >'" + mark + "'")).reset();
    CHECK(std::filesystem::exists(mark));
}
