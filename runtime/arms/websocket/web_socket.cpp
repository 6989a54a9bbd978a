#include "runtime/arms/websocket/web_socket.h"

#include "haptics/base/clock.h"
#include "runtime/arms/websocket/handshake.h"
#include "runtime/arms/websocket/http.h"

#include <algorithm>
#include <sys/random.h>

namespace fulcrum::runtime {
namespace {

constexpr int kMostPings = 64;         // before one message: nobody who means well sends more
constexpr double kPongWait_s = 0.005;  // a ping's answer that does not go at once, goes never
constexpr double kDribble_s = 0.005;   // beyond a deadline that has passed

// False where the system has none to give.
template <class Bytes>
bool fill_randomly(Bytes& bytes) noexcept {
    return ::getrandom(bytes.data(), bytes.size(), GRND_NONBLOCK) ==
           static_cast<ssize_t>(bytes.size());
}

std::string name_socket(std::uint16_t port) {
    return "127.0.0.1:" + std::to_string(port);
}

// What stands before the empty line; what came behind it goes to `rest`.
Expected<std::string> receive_head(LoopbackSocket& line, double deadline_s, std::string& rest) {
    std::string all;
    for (;;) {
        const auto received = line.receive(all, deadline_s);
        const std::size_t end = all.find("\r\n\r\n");
        if (end != std::string::npos) {
            rest = all.substr(end + 4);
            all.resize(end);
            return all;
        }
        if (received != LoopbackSocket::Received::some || all.size() > kMostHeadBytes) {
            return fail("what listens there does not answer as a WebSocket does");
        }
    }
}

}  // namespace

Expected<std::unique_ptr<WebSocket>> WebSocket::connect(std::uint16_t port, double deadline_s) {
    const auto refuse = [&](Error error) {
        error.where = name_socket(port);
        return tl::unexpected<Error>(std::move(error));
    };
    LoopbackSocket line = LoopbackSocket::begin(port);
    if (!line.is_connected(deadline_s)) {
        return refuse({"nobody listens there", "", ""});
    }
    HandshakeNonce nonce{};
    if (!fill_randomly(nonce)) {
        return refuse({"this computer has no random numbers to give yet", "", "try again"});
    }
    const std::string key = to_base64(nonce);
    const std::string upgrade = make_upgrade(key, port);
    if (line.send(upgrade, deadline_s) != upgrade.size()) {
        return refuse({"what listens there takes no question", "", ""});
    }
    std::string rest;
    const auto head = receive_head(line, deadline_s, rest);
    if (!head) {
        return refuse(head.error());
    }
    if (const auto good = check_upgrade(*head, key); !good) {
        return refuse(good.error());
    }
    std::unique_ptr<WebSocket> made(new WebSocket(std::move(line)));
    made->reader_.feed(rest);
    return made;
}

bool WebSocket::send_frame(Opcode opcode, std::string_view payload, double deadline_s) noexcept {
    FrameMask mask{};
    frame_.clear();
    if (!line_.is_open() || !fill_randomly(mask)) {
        return false;
    }
    append_frame(opcode, payload, mask, frame_);
    return line_.send(frame_, deadline_s) == frame_.size();
}

bool WebSocket::send(std::string_view text, double deadline_s) noexcept {
    if (send_frame(Opcode::text, text, deadline_s)) {
        return true;
    }
    // Half a frame may have gone: nothing that came behind it would be understood.
    (void)leave("it takes nothing more");
    return false;
}

WebSocket::Heard WebSocket::receive(std::string& text, double deadline_s) noexcept {
    int n_pings = 0;
    // Whoever sends without end, and no message, is heard no longer than one who is silent.
    const double until_s = std::max(deadline_s, monotonic_now_s() + kDribble_s);
    while (why_.empty()) {
        const FrameReader::Got got = reader_.next();
        switch (got) {
            case FrameReader::Got::text:
                text = reader_.payload();
                return Heard::text;
            case FrameReader::Got::ping:
            case FrameReader::Got::pong:
                if (++n_pings > kMostPings) {
                    return leave("it sends pings instead of messages");
                }
                if (got == FrameReader::Got::ping && !answer_ping(deadline_s)) {
                    return leave("it takes nothing more");
                }
                continue;
            case FrameReader::Got::close:
                return leave("it has closed the connection");
            case FrameReader::Got::broken:
                return leave(reader_.why());
            case FrameReader::Got::nothing:
                break;
        }
        if (monotonic_now_s() > until_s) {
            return Heard::nothing;
        }
        received_.clear();
        switch (line_.receive(received_, deadline_s)) {
            case LoopbackSocket::Received::some:
                reader_.feed(received_);
                break;
            case LoopbackSocket::Received::nothing:
                return Heard::nothing;
            case LoopbackSocket::Received::closed:
                return leave("the connection is cut off");
        }
    }
    return Heard::gone;
}

bool WebSocket::answer_ping(double deadline_s) noexcept {
    return send_frame(Opcode::pong, reader_.payload(),
                      std::max(deadline_s, monotonic_now_s() + kPongWait_s));
}

WebSocket::Heard WebSocket::leave(std::string_view why) noexcept {
    if (why_.empty()) {
        why_ = why;
    }
    line_.close();
    return Heard::gone;
}

void WebSocket::close() noexcept {
    if (line_.is_open()) {
        // 1000: the purpose is fulfilled (RFC 6455, 7.4.1).
        constexpr std::string_view kNormal("\x03\xe8", 2);
        (void)send_frame(Opcode::close, kNormal, 0.0);
        (void)leave("it was closed here");
    }
}

}  // namespace fulcrum::runtime
