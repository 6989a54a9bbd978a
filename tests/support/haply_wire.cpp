#include "tests/support/haply_wire.h"

#include "runtime/arms/websocket/handshake.h"

#include <array>
#include <cstdint>

namespace fulcrum::test_support {
namespace {

std::string make_server_frame(unsigned first, std::string_view body, bool is_long) {
    std::string frame(1, static_cast<char>(first));
    const std::uint64_t size = body.size();
    int n = 0;
    if (is_long || size > 0xffff) {
        frame += static_cast<char>(127);
        n = 8;
    } else if (size > 125) {
        frame += static_cast<char>(126);
        n = 2;
    } else {
        frame += static_cast<char>(size);
    }
    while (n-- > 0) {
        frame += static_cast<char>(size >> (8U * static_cast<unsigned>(n)));
    }
    return frame.append(body);
}

// The frame at the begin, unmasked; its whole size, or 0 while it is not whole.
std::size_t read_client_frame(const std::string& bytes, unsigned& opcode, bool& is_masked,
                              std::string& body) {
    const auto at = [&](std::size_t i) { return static_cast<std::uint8_t>(bytes[i]); };
    if (bytes.size() < 2) {
        return 0;
    }
    std::uint64_t size = at(1) & 0x7fU;
    const std::size_t more = size == 127 ? 8 : size == 126 ? 2 : 0;
    is_masked = (at(1) & 0x80U) != 0;
    const std::size_t mask_at = 2 + more;
    const std::size_t body_at = mask_at + (is_masked ? 4 : 0);
    if (bytes.size() < body_at) {
        return 0;
    }
    size = more > 0 ? 0 : size;
    for (std::size_t i = 0; i < more; ++i) {
        size = size * 256 + at(2 + i);
    }
    if (bytes.size() < body_at + size) {
        return 0;
    }
    opcode = at(0) & 0x0fU;
    body = bytes.substr(body_at, size);
    for (std::size_t i = 0; is_masked && i < body.size(); ++i) {
        body[i] = static_cast<char>(static_cast<std::uint8_t>(body[i]) ^ at(mask_at + i % 4));
    }
    return body_at + size;
}

}  // namespace

std::string make_wire_text(const std::string& text, const WireHabits& habits) {
    std::string all = habits.pings ? make_server_frame(0x89, "are you there", false) : "";
    if (!habits.in_fragments) {
        return all + make_server_frame(0x81, text, habits.long_lengths);
    }
    const std::size_t third = text.size() / 3;
    all += make_server_frame(0x01, text.substr(0, third), habits.long_lengths);
    all += make_server_frame(0x00, text.substr(third, third), habits.long_lengths);
    all += make_server_frame(0x89, "between", false);
    return all + make_server_frame(0x80, text.substr(2 * third), habits.long_lengths);
}

ClientMessages take_client_frames(std::string& bytes) {
    ClientMessages all;
    unsigned opcode = 0;
    bool is_masked = false;
    std::string body;
    for (std::size_t size = 0; (size = read_client_frame(bytes, opcode, is_masked, body)) > 0;) {
        bytes.erase(0, size);
        all.was_unmasked = all.was_unmasked || !is_masked;
        if (opcode == 0x1) {
            all.texts.push_back(body);
        } else if (opcode == 0xa) {
            all.pongs.push_back(body);
        } else if (opcode == 0x8) {
            all.says_goodbye = true;
        }
    }
    return all;
}

std::optional<std::string> answer_upgrade(std::string_view head) {
    constexpr std::string_view kName = "Sec-WebSocket-Key: ";
    const std::size_t at = head.find(kName);
    if (at == std::string_view::npos || head.find("Upgrade: websocket") == std::string_view::npos) {
        return std::nullopt;
    }
    std::string_view key = head.substr(at + kName.size());
    key = key.substr(0, key.find("\r\n"));
    return "HTTP/1.1 101 Switching Protocols\r\nUpgrade: websocket\r\nConnection: Upgrade\r\n"
           "Sec-WebSocket-Accept: " +
           runtime::find_accept(key) + "\r\n\r\n";
}

}  // namespace fulcrum::test_support
