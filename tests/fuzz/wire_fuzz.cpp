// Any bytes as what a lesson's process sends. What is taken must be within all limits, and pass again when it is sent on.
#include "runtime/lua/wire/wire.h"
#include "tests/fuzz/promise.h"
#include "tests/support/wire_messages.h"

namespace {

using namespace fulcrum::runtime;

constexpr std::size_t kHead = 5;

template <class Message, class Decode>
void must_pass_again(const Message& message, Decode decode) {
    Bytes bytes;
    encode(message, bytes);
    require(decode(std::span<const std::uint8_t>(bytes).subspan(kHead)).has_value());
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    if (size == 0) {
        return 0;
    }
    static const LessonDescription kScene = fulcrum::test::full_description();
    const std::span<const std::uint8_t> body(data + 1, size - 1);
    const auto take_reply = [](std::span<const std::uint8_t> bytes) {
        return decode_reply(bytes, kScene);
    };
    switch (static_cast<WireKind>(data[0] % 8)) {
        case WireKind::reply:
            if (const auto reply = take_reply(body)) {
                must_pass_again(*reply, take_reply);
            }
            break;
        case WireKind::description:
            if (const auto description = decode_description(body)) {
                must_pass_again(*description, decode_description);
            }
            break;
        case WireKind::frame:
            if (const auto frame = decode_frame(body)) {
                must_pass_again(*frame, decode_frame);
            }
            break;
        case WireKind::error:
            static_cast<void>(decode_error(body));
            break;
        case WireKind::print:
            static_cast<void>(decode_print(body));
            break;
        case WireKind::module_request:
            static_cast<void>(decode_module_request(body));
            break;
        case WireKind::module_answer:
            static_cast<void>(decode_module_answer(body));
            break;
        case WireKind::load:
            static_cast<void>(decode_load(body));
            break;
    }
    return 0;
}
