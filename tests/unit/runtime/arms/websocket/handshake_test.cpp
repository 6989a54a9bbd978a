#include "runtime/arms/websocket/handshake.h"

#include "tests/support/refused.h"

#include <catch2/catch.hpp>

namespace fulcrum::runtime {
namespace {

// Section 1.3's.
constexpr const char* kKey = "dGhlIHNhbXBsZSBub25jZQ==";
constexpr const char* kAnswer =
    "HTTP/1.1 101 Switching Protocols\r\nUpgrade: websocket\r\nConnection: Upgrade\r\n"
    "Sec-WebSocket-Accept: s3pPLMBiTxaQ9kYGzzhZRbK+xOo=";

std::string changed(std::string from, const std::string& to) {
    std::string answer = kAnswer;
    return answer.replace(answer.find(from), from.size(), to);
}

std::span<const std::uint8_t> bytes_of(const std::string& text) {
    return {reinterpret_cast<const std::uint8_t*>(text.data()), text.size()};
}

}  // namespace

TEST_CASE("websocket handshake: base64 as RFC 4648, section 10, has it") {
    CHECK(to_base64(bytes_of("")).empty());
    CHECK(to_base64(bytes_of("f")) == "Zg==");
    CHECK(to_base64(bytes_of("fo")) == "Zm8=");
    CHECK(to_base64(bytes_of("foo")) == "Zm9v");
    CHECK(to_base64(bytes_of("foobar")) == "Zm9vYmFy");
    CHECK(to_base64(bytes_of("the sample nonce")) == kKey);
}

TEST_CASE("websocket handshake: the example of RFC 6455, section 1.3") {
    CHECK(find_accept(kKey) == "s3pPLMBiTxaQ9kYGzzhZRbK+xOo=");
    CHECK(check_upgrade(kAnswer, kKey));
    CHECK(check_upgrade(changed("Connection: Upgrade", "connection: keep-alive, upgrade"), kKey));
    CHECK(check_upgrade(changed("Upgrade: websocket", "UPGRADE: WebSocket"), kKey));
    CHECK(make_upgrade(kKey, 10001).find("\r\nSec-WebSocket-Key: " + std::string(kKey) + "\r\n") !=
          std::string::npos);
    CHECK(make_upgrade(kKey, 10001).starts_with("GET / HTTP/1.1\r\nHost: 127.0.0.1:10001\r\n"));
}

TEST_CASE("websocket handshake: an answer to another question, or to none, is refused") {
    CHECK(is_refused(check_upgrade("220 mail.example ESMTP", kKey), "no HTTP"));
    CHECK(is_refused(check_upgrade(changed("101 Switching Protocols", "200 OK"), kKey),
                     "it says 200"));
    CHECK(is_refused(check_upgrade(changed("websocket", "h2c"), kKey), "something else"));
    CHECK(is_refused(check_upgrade(changed("Connection: Upgrade", "Connection: close"), kKey),
                     "something else"));
    CHECK(is_refused(check_upgrade(kAnswer, "AAAAAAAAAAAAAAAAAAAAAA=="), "nobody here asked"));
    CHECK(is_refused(check_upgrade(changed("s3pP", "s3pp"), kKey), "nobody here asked"));
    CHECK(is_refused(
        check_upgrade(std::string(kAnswer) + "\r\nSec-WebSocket-Extensions: permessage-deflate",
                      kKey),
        "extension"));
}

}  // namespace fulcrum::runtime
