// Any bytes from what listens where Haply's service should: messages, frames in any pieces, answers by HTTP, and handshakes. What is taken is
// a place, a turn and a force that are numbers; what is not, is refused, and nothing is read past its end. The first byte chooses.
#include "runtime/arms/haply/haply_command.h"
#include "runtime/arms/haply/haply_message.h"
#include "runtime/arms/websocket/frame.h"
#include "runtime/arms/websocket/handshake.h"
#include "runtime/arms/websocket/http.h"
#include "tests/fuzz/promise.h"

namespace {

using namespace fulcrum;
using namespace fulcrum::runtime;

void try_message(std::string_view text) {
    const auto message = parse_haply_message(text);
    if (!message) {
        require(!message.error().message.empty());
        return;
    }
    for (const HaplyArm& arm : message->arms) {
        require(is_finite(arm.position_A) && arm.position_A.cwiseAbs().maxCoeff() <= 2.0);
        require(is_finite(arm.velocity_A) && is_finite(arm.echo_A));
        require(is_finite(arm.transform.pose) && is_finite(arm.transform.scale));
    }
    for (const HaplyGrip& grip : message->grips) {
        require(!grip.orientation_A || std::abs(grip.orientation_A->norm() - 1.0) < 1.0e-9);
    }
}

// In pieces of `step` bytes it is what it is as a whole.
void try_frames(std::string_view bytes, std::size_t step) {
    const auto read = [&](std::size_t piece) {
        FrameReader reader;
        std::string all;
        for (std::size_t at = 0; at < bytes.size(); at += piece) {
            reader.feed(bytes.substr(at, piece));
            auto got = reader.next();
            while (got != FrameReader::Got::nothing && got != FrameReader::Got::broken) {
                require(reader.payload().size() <= kMostMessageBytes);
                all += reader.payload() + "|";
                got = reader.next();
            }
            require((got == FrameReader::Got::broken) == !reader.why().empty());
        }
        return all + std::string(reader.why());
    };
    require(read(step) == read(std::max<std::size_t>(bytes.size(), 1)));
}

void try_http(std::string_view bytes, std::size_t step) {
    HttpReader reader;
    for (std::size_t at = 0; at < bytes.size(); at += step) {
        reader.feed(bytes.substr(at, step));
    }
    reader.end();
    require(reader.state() != HttpReader::State::reading);
    require(reader.state() != HttpReader::State::done || reader.body().size() <= kMostBodyBytes);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    if (size < 2) {
        return 0;
    }
    const std::string_view text(reinterpret_cast<const char*>(data + 1), size - 1);
    const std::size_t step = 1 + data[0] / 4;
    switch (data[0] % 4) {
        case 0:
            try_message(text);
            break;
        case 1:
            try_frames(text, step);
            break;
        case 2:
            try_http(text, step);
            break;
        default: {
            // Nobody answers a question that was not asked.
            require(!check_upgrade(text, text));
            const auto scale = parse_haply_force_scale(text);
            require(!scale || std::isfinite(*scale));
            require(parse_haply_version(text).size() <= text.size());
            (void)choose_force_word(text);
        }
    }
    return 0;
}
