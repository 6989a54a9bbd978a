// Any bytes as the text of a lesson: loaded and played for two frames in this process, with all limits and a short budget.
#include "runtime/lua/host/lesson_host.h"
#include "tests/fuzz/promise.h"

namespace {

using namespace fulcrum::runtime;

LoadMessage make_message(const std::uint8_t* data, std::size_t size) {
    LoadMessage message;
    message.lesson = {"lesson.lua", std::string(reinterpret_cast<const char*>(data), size)};
    message.memory_bytes = 4U << 20U;
    message.load_instructions = 100'000;
    message.frame_instructions = 50'000;
    return message;
}

void play(LessonHost& host) {
    Bytes bytes;
    encode(host.description(), bytes);
    constexpr std::size_t kHead = 5;
    const auto description = decode_description(std::span(bytes).subspan(kHead));
    // Whatever a lesson sends must pass the program's own checks.
    require(description.has_value());
    LessonFrame frame;
    frame.dt_s = 1.0 / 60.0;
    frame.bodies.resize(description->bodies.size());
    frame.events = {KeyEvent{"space"}};
    for (const auto& question : description->questions) {
        frame.events.emplace_back(JudgeEvent{question.id, {{"thing", "apple"}}});
    }
    for (int i = 0; i < 2; ++i) {
        LessonReply reply;
        if (host.run_frame(frame, reply)) {
            return;
        }
        bytes.clear();
        encode(reply, bytes);
        require(decode_reply(std::span(bytes).subspan(kHead), *description).has_value());
        frame.time_s += frame.dt_s;
    }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    if (size > 16'384) {
        return 0;
    }
    HostServices services;
    services.find_module = [](const std::string&) {
        return ModuleAnswer{false, {}, "there are no modules here"};
    };
    services.print_while_loading = [](const std::string&) {};
    LessonHost host(make_message(data, size), services);
    if (!host.load()) {
        play(host);
    }
    return 0;
}
