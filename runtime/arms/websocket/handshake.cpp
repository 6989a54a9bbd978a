#include "runtime/arms/websocket/handshake.h"

#include "runtime/arms/websocket/http.h"
#include "runtime/arms/websocket/sha1.h"

#include <algorithm>

namespace fulcrum::runtime {
namespace {

// One of the words between commas.
bool names_word(std::string_view list, std::string_view word) {
    while (!list.empty()) {
        const std::size_t comma = std::min(list.find(','), list.size());
        std::string_view one = list.substr(0, comma);
        list.remove_prefix(std::min(comma + 1, list.size()));
        while (one.starts_with(' ')) {
            one.remove_prefix(1);
        }
        while (one.ends_with(' ')) {
            one.remove_suffix(1);
        }
        if (is_same_word(one, word)) {
            return true;
        }
    }
    return false;
}

}  // namespace

std::string to_base64(std::span<const std::uint8_t> bytes) {
    constexpr std::string_view kLetters =
        "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string text;
    for (std::size_t i = 0; i < bytes.size(); i += 3) {
        const std::size_t n = std::min<std::size_t>(3, bytes.size() - i);
        std::uint32_t three = 0;
        for (std::size_t j = 0; j < 3; ++j) {
            three = (three << 8U) | (j < n ? bytes[i + j] : 0U);
        }
        for (std::size_t j = 0; j < 4; ++j) {
            text += j <= n ? kLetters[(three >> (18U - 6U * j)) & 63U] : '=';
        }
    }
    return text;
}

std::string find_accept(std::string_view key) {
    std::string text(key);
    text += "258EAFA5-E914-47DA-95CA-C5AB0DC85B11";
    return to_base64(compute_sha1(text));
}

std::string make_upgrade(std::string_view key, std::uint16_t port) {
    std::string text = "GET / HTTP/1.1\r\nHost: 127.0.0.1:" + std::to_string(port);
    text += "\r\nUpgrade: websocket\r\nConnection: Upgrade\r\nSec-WebSocket-Key: ";
    text += key;
    text += "\r\nSec-WebSocket-Version: 13\r\n\r\n";
    return text;
}

Expected<void> check_upgrade(std::string_view answer_head, std::string_view key) {
    const auto head = parse_http_head(answer_head);
    if (!head) {
        return fail("what answers speaks no HTTP");
    }
    if (head->status != 101) {
        return fail("what answers opens no WebSocket: it says " + std::to_string(head->status));
    }
    if (!is_same_word(head->find("upgrade"), "websocket") ||
        !names_word(head->find("connection"), "upgrade")) {
        return fail("what answers opens something else than a WebSocket");
    }
    if (head->find("sec-websocket-accept") != find_accept(key)) {
        return fail("what answers opens a WebSocket that nobody here asked for");
    }
    // None was asked for.
    if (!head->find("sec-websocket-extensions").empty() ||
        !head->find("sec-websocket-protocol").empty()) {
        return fail("what answers wants an extension or a protocol that nobody asked for");
    }
    return {};
}

}  // namespace fulcrum::runtime
