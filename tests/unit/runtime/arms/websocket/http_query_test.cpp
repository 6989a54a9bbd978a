#include "runtime/arms/websocket/http_query.h"

#include "haptics/base/clock.h"
#include "tests/support/eventually.h"
#include "tests/support/loopback_listener.h"
#include "tests/support/refused.h"

#include <catch2/catch.hpp>

#include <thread>

namespace fulcrum::runtime {
namespace {

using test_support::eventually;
using test_support::LoopbackListener;

constexpr double kQuerySoon_s = 10.0;

}  // namespace

TEST_CASE("http query: a question and its answer, without waiting and with") {
    const LoopbackListener listener;
    HttpQuery query;
    CHECK(query.step() == HttpQuery::State::idle);
    query.begin("/version", listener.port(), monotonic_now_s() + kQuerySoon_s);
    CHECK(query.step() == HttpQuery::State::waits);
    auto guest = listener.accept();
    CHECK(guest.read_until("\r\n\r\n").starts_with("GET /version HTTP/1.1\r\n"));
    CHECK(query.step() == HttpQuery::State::waits);
    CHECK(guest.write("HTTP/1.1 200 OK\r\n\r\n{\"git_tag\":"));
    CHECK(guest.write("\"3.5.0\"}"));
    guest.leave();
    CHECK(eventually([&] { return query.step() == HttpQuery::State::done; }));
    CHECK(query.answer().status == 200);
    CHECK(query.answer().body == "{\"git_tag\":\"3.5.0\"}");

    std::thread server([&] {
        const auto other = listener.accept();
        (void)other.read_until("\r\n\r\n");
        (void)other.write("HTTP/1.1 404 Not Found\r\nContent-Length: 2\r\n\r\nno");
    });
    const auto answer = ask_http("/settings", listener.port(), monotonic_now_s() + kQuerySoon_s);
    server.join();
    REQUIRE(answer);
    CHECK(answer->status == 404);
    CHECK(answer->body == "no");
}

TEST_CASE("http query: nobody, no answer in time, and no HTTP fail") {
    HttpQuery query;
    std::uint16_t port = 0;
    {
        const LoopbackListener listener;
        port = listener.port();
        // Taken by the system, and answered by nobody.
        query.begin("/version", port, monotonic_now_s() + 0.02);
        CHECK(eventually([&] { return query.step() == HttpQuery::State::failed; }));
        CHECK(is_refused(ask_http("/version", port, monotonic_now_s() + 0.02), "nobody answers"));
        query.begin("/version", port, monotonic_now_s() + kQuerySoon_s);
        (void)query.step();
        for (int i = 0; i < 3; ++i) {
            // The two before are still in the queue.
            (void)listener.accept().write("220 mail ready\r\n\r\n");
        }
        CHECK(eventually([&] { return query.step() == HttpQuery::State::failed; }));
    }
    CHECK(is_refused(ask_http("/version", port, monotonic_now_s() + kQuerySoon_s), "127.0.0.1:"));
}

}  // namespace fulcrum::runtime
