// Any bytes as the text of a lesson: loaded and played for two frames in this process, with all limits and a short budget.
// Whatever it sends passes the program's own checks.
#include "tests/fuzz/promise.h"
#include "tests/support/both_sides.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace fulcrum::test;
    if (size > 16'384) {
        return 0;
    }
    LoadMessage message;
    message.lesson = {"lesson.lua", std::string(reinterpret_cast<const char*>(data), size)};
    message.memory_bytes = 4U << 20U;
    message.load_instructions = 100'000;
    message.frame_instructions = 50'000;
    require(play_both_sides(message, Choices(size), 2).program.empty());
    return 0;
}
