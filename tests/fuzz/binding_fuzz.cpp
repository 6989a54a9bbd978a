// Any bytes as the choices of a lesson that is generated from the binding table: an even first byte makes one of allowed values, an odd one
// a hostile one, with wrong types, fields that are missing or unknown, deep and huge tables, metamethods that call bindings again or fail
// half-way, coroutines and callbacks that declare once more. What its side sends passes the program's own checks.
#include "tests/fuzz/promise.h"
#include "tests/support/both_sides.h"
#include "tests/support/generated_lesson.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace fulcrum::test;
    if (size == 0 || size > 4096) {
        return 0;
    }
    const Choices choices(std::span(data + 1, size - 1));
    const GeneratedLesson lesson = LessonWriter(choices, data[0] % 2 == 1).write();
    LoadMessage message;
    message.lesson = {"lesson.lua", lesson.text};
    message.memory_bytes = 8U << 20U;
    message.load_instructions = 300'000;
    message.frame_instructions = 200'000;
    const BothSides told = play_both_sides(message, choices, 3);
    require(told.program.empty());
    require(told.lesson.find('\n') == std::string::npos);
    return 0;
}
