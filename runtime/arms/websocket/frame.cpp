#include "runtime/arms/websocket/frame.h"

namespace fulcrum::runtime {
namespace {

constexpr std::uint8_t kFin = 0x80;
constexpr std::uint8_t kReserved = 0x70;
constexpr std::uint8_t kOpcodeBits = 0x0f;
constexpr std::uint8_t kMaskBit = 0x80;
constexpr std::uint8_t kLengthBits = 0x7f;
constexpr std::uint8_t kLengthIn16 = 126;
constexpr std::uint8_t kLengthIn64 = 127;

bool is_control(Opcode opcode) {
    return static_cast<std::uint8_t>(opcode) >= static_cast<std::uint8_t>(Opcode::close);
}

void append_length(std::size_t length, std::string& out) {
    const auto append_bytes = [&](int n) {
        for (int i = n - 1; i >= 0; --i) {
            out += static_cast<char>((length >> (8U * static_cast<unsigned>(i))) & 0xffU);
        }
    };
    if (length < kLengthIn16) {
        out += static_cast<char>(kMaskBit | length);
    } else if (length <= 0xffff) {
        out += static_cast<char>(kMaskBit | kLengthIn16);
        append_bytes(2);
    } else {
        out += static_cast<char>(kMaskBit | kLengthIn64);
        append_bytes(8);
    }
}

}  // namespace

void append_frame(Opcode opcode, std::string_view payload, const FrameMask& mask,
                  std::string& out) {
    out += static_cast<char>(kFin | static_cast<std::uint8_t>(opcode));
    append_length(payload.size(), out);
    for (const std::uint8_t byte : mask) {
        out += static_cast<char>(byte);
    }
    for (std::size_t i = 0; i < payload.size(); ++i) {
        out += static_cast<char>(static_cast<std::uint8_t>(payload[i]) ^ mask[i % mask.size()]);
    }
}

void FrameReader::feed(std::string_view bytes) {
    if (!why_.empty()) {
        return;
    }
    // What was taken goes when nothing is left, or when it is more than what is left.
    if (begin_ > buffer_.size() / 2) {
        buffer_.erase(0, begin_);
        begin_ = 0;
    }
    buffer_ += bytes;
}

FrameReader::Got FrameReader::next() {
    Head head;
    while (why_.empty() && read_head(head)) {
        const Got got = take(head);
        if (got != Got::nothing) {
            return got;
        }
    }
    return why_.empty() ? Got::nothing : Got::broken;
}

FrameReader::Got FrameReader::fail(std::string_view why) {
    why_ = why;
    buffer_.clear();
    begin_ = 0;
    return Got::broken;
}

// What can be judged before the length is known; false fails.
bool FrameReader::is_allowed(std::uint8_t first, std::uint8_t second) {
    const auto opcode = static_cast<Opcode>(first & kOpcodeBits);
    if ((first & kReserved) != 0) {
        (void)fail("it uses an extension that nobody agreed on");
    } else if ((second & kMaskBit) != 0) {
        (void)fail("it masks what it sends, as a client does");
    } else if (opcode == Opcode::binary) {
        (void)fail("it sends bytes instead of text");
    } else if (opcode != Opcode::continuation && opcode != Opcode::text &&
               (opcode < Opcode::close || opcode > Opcode::pong)) {
        (void)fail("it sends a frame of a kind that does not exist");
    } else if (is_control(opcode) &&
               ((first & kFin) == 0 || (second & kLengthBits) > kMostControlBytes)) {
        (void)fail("it sends a control frame that is long or in parts");
    } else if (!is_control(opcode) && (opcode == Opcode::continuation) != has_parts_) {
        (void)fail("it sends the parts of messages in disorder");
    }
    return why_.empty();
}

// False while a frame is not whole, and where it is none.
bool FrameReader::read_head(Head& head) {
    const std::size_t n = buffer_.size() - begin_;
    const auto byte = [&](std::size_t i) { return static_cast<std::uint8_t>(buffer_[begin_ + i]); };
    if (n < 2 || !is_allowed(byte(0), byte(1))) {
        return false;
    }
    const std::uint8_t said = byte(1) & kLengthBits;
    const std::size_t more = said == kLengthIn64 ? 8 : said == kLengthIn16 ? 2 : 0;
    if (n < 2 + more) {
        return false;
    }
    std::uint64_t length = more == 0 ? said : 0;
    for (std::size_t i = 0; i < more; ++i) {
        length = (length << 8U) | byte(2 + i);
    }
    head = {.opcode = static_cast<Opcode>(byte(0) & kOpcodeBits),
            .is_last = (byte(0) & kFin) != 0,
            .at = 2 + more,
            .length = 0};
    if (length > kMostMessageBytes ||
        (!is_control(head.opcode) && length > kMostMessageBytes - parts_.size())) {
        (void)fail("it sends a message of more than a megabyte");
        return false;
    }
    head.length = static_cast<std::size_t>(length);
    return n >= head.at + head.length;
}

// A frame that is whole; nothing while its message is not.
FrameReader::Got FrameReader::take(const Head& head) {
    const std::string_view body(buffer_.data() + begin_ + head.at, head.length);
    begin_ += head.at + head.length;
    if (!is_control(head.opcode)) {
        parts_ += body;
        has_parts_ = !head.is_last;
        if (has_parts_) {
            return ++n_parts_ < kMostParts ? Got::nothing
                                           : fail("it sends a message in too many parts");
        }
        n_parts_ = 0;
        payload_.swap(parts_);
        parts_.clear();
        return Got::text;
    }
    payload_ = body;
    return head.opcode == Opcode::ping   ? Got::ping
           : head.opcode == Opcode::pong ? Got::pong
                                         : Got::close;
}

}  // namespace fulcrum::runtime
