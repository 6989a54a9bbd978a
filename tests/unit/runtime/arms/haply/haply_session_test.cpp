#include "runtime/arms/haply/haply_session.h"

#include "haptics/base/clock.h"
#include "tests/support/haply_service.h"
#include "tests/support/loopback_listener.h"
#include "tests/support/refused.h"

#include <catch2/catch.hpp>

namespace fulcrum::runtime {
namespace {

using test_support::HaplyOptions;
using test_support::HaplyService;

constexpr double kTestPatience_s = 10.0;

// What somebody is told who opens the arm of such a service; empty where it opens.
std::string open_with(const std::function<void(HaplyOptions&)>& change,
                      const std::string& id = {}) {
    HaplyOptions options;
    change(options);
    HaplyService service(options);
    MessageLog log;
    const auto session = HaplySession::open(service.port(), id, kTestPatience_s, log);
    return session ? "" : to_sentence(session.error());
}

bool tells(const std::string& sentence, const char* words) {
    return sentence.find(words) != std::string::npos;
}

}  // namespace

TEST_CASE("haply session: the inventory first, then one state for one message") {
    HaplyService service;
    MessageLog log;
    const auto opened = HaplySession::open(service.port(), "", kTestPatience_s, log);
    REQUIRE(opened);
    HaplySession& session = **opened;
    CHECK(session.arm().id == "049D");
    CHECK(session.version() == "3.5.0");
    CHECK(session.word() == ForceWord::vector);
    CHECK(session.force_scale() == 1.0);
    CHECK(session.scale_path() == kHaplyScalePath);
    HaplyMessage message;
    CHECK(session.receive(message, 0.0) == HaplySession::Heard::nothing);
    for (int i = 0; i < 3; ++i) {
        const bool wants_all = i == 1;
        CHECK(session.send({0.1, 0.0, 0.0}, session.word(), wants_all,
                           monotonic_now_s() + kTestPatience_s));
        CHECK(session.receive(message, monotonic_now_s() + kTestPatience_s) ==
              HaplySession::Heard::state);
        REQUIRE(message.arms.size() == 1);
        CHECK(message.arms[0].config.has_value() == wants_all);
        CHECK(message.arms[0].echo_A == Vector3(0.1, 0.0, 0.0));
        CHECK(session.receive(message, 0.0) == HaplySession::Heard::nothing);
    }
    service.change([](HaplyOptions& now) { now.is_malformed = true; });
    CHECK(
        session.send(Vector3::Zero(), session.word(), false, monotonic_now_s() + kTestPatience_s));
    CHECK(session.receive(message, monotonic_now_s() + kTestPatience_s) ==
          HaplySession::Heard::nonsense);
    CHECK(session.why() == "it sends text that is no message");
    service.change([](HaplyOptions& now) { now.cuts_off = true; });
    CHECK(
        session.send(Vector3::Zero(), session.word(), false, monotonic_now_s() + kTestPatience_s));
    CHECK(session.receive(message, monotonic_now_s() + kTestPatience_s) ==
          HaplySession::Heard::gone);
    CHECK(session.why() == "the connection is cut off");
}

TEST_CASE(
    "haply session: a service that tells no scale of forces is taken, one that adds to them is "
    "not") {
    CHECK(open_with([](HaplyOptions& options) { options.force_scale.reset(); }).empty());
    CHECK(open_with([](HaplyOptions& options) { options.force_scale = 0.5; }).empty());
    CHECK(tells(open_with([](HaplyOptions& options) { options.force_scale = 2.0; }),
                "stronger than it is ordered"));
}

TEST_CASE("haply session: each service and each arm that cannot be held is refused in words") {
    CHECK(open_with([](HaplyOptions&) {}).empty());
    CHECK(open_with([](HaplyOptions& options) { options.ids = {"049D", "04BA"}; }, "04BA").empty());
    CHECK(tells(open_with([](HaplyOptions& options) { options.version = "2.4.0"; }),
                "a version that is not known here: 2.4.0"));
    CHECK(tells(open_with([](HaplyOptions& options) { options.version = "3.0.7"; }), "3.0.7"));
    CHECK(tells(open_with([](HaplyOptions& options) { options.version = "unknown"; }), "unknown"));
    CHECK(tells(open_with([](HaplyOptions& options) { options.ids.clear(); }), "has no arm"));
    CHECK(tells(open_with([](HaplyOptions& options) {
                    options.ids = {"049D", "04BA"};
                }),
                "several arms: 049D, 04BA"));
    CHECK(tells(open_with([](HaplyOptions&) {}, "04BA"), "has no arm 04BA"));
    CHECK(tells(open_with([](HaplyOptions& options) { options.is_calibrated = false; }),
                "not calibrated"));
    CHECK(tells(open_with([](HaplyOptions& options) { options.has_power = false; }), "no power"));
    CHECK(tells(open_with([](HaplyOptions& options) { options.is_in_use = true; }),
                "in use by another program"));
    CHECK(tells(open_with([](HaplyOptions& options) { options.basis = "XZY"; }), "basis is XZY"));
    CHECK(tells(open_with([](HaplyOptions& options) { options.mount_scale = 2.0; }), "mount"));
    CHECK(tells(open_with([](HaplyOptions& options) { options.transform_scale = 2.0; }),
                "transform"));
    CHECK(tells(open_with([](HaplyOptions& options) { options.speaks_3_0 = true; }),
                "does not say whether"));
    CHECK(tells(open_with([](HaplyOptions& options) { options.is_malformed = true; }),
                "cannot be understood"));
    CHECK(tells(open_with([](HaplyOptions& options) { options.has_no_number = true; }),
                "whose y makes no sense"));
}

TEST_CASE("haply session: nobody at the port, and somebody who says nothing, are refused in time") {
    MessageLog log;
    std::uint16_t port = 0;
    {
        const test_support::LoopbackListener silent;
        port = silent.port();
        CHECK(is_refused(HaplySession::open(port, "", 0.02, log), "no Haply service answers"));
    }
    const auto refused = HaplySession::open(port, "", kTestPatience_s, log);
    CHECK(is_refused(refused, "no Haply service answers"));
    CHECK(is_refused(refused, "install and start the Haply Inverse Service"));
}

}  // namespace fulcrum::runtime
