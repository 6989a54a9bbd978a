// Kites between the lesson's process and the program: what a lesson that lies is refused.
#include "tests/support/wire_messages.h"

#include <catch2/catch.hpp>

#include <limits>

namespace fulcrum::runtime {
namespace {

constexpr std::size_t kHead = 5;  // length and kind
const double kNaN = std::numeric_limits<double>::quiet_NaN();

template <class Command>
bool takes(const Command& command, const LessonDescription& lesson) {
    LessonReply reply;
    reply.commands = {command};
    Bytes bytes;
    encode(reply, bytes);
    return decode_reply(std::span(bytes).subspan(kHead), lesson).has_value();
}

bool takes_description(const LessonDescription& description) {
    Bytes bytes;
    encode(description, bytes);
    return decode_description(std::span(bytes).subspan(kHead)).has_value();
}

KiteCommand with(auto change) {
    KiteCommand command;
    command.design = KiteSettings{};
    change(command);
    return command;
}

TEST_CASE("wire: a kite's commands come back as they were, and only to a lesson that has one") {
    const LessonDescription lesson = fulcrum::test::full_description();
    LessonDescription without = lesson;
    without.kite.reset();
    CHECK(takes(with([](KiteCommand&) {}), lesson));
    CHECK_FALSE(takes(with([](KiteCommand&) {}), without));
    CHECK(takes(WindCommand{8.0}, lesson));
    CHECK_FALSE(takes(WindCommand{8.0}, without));
    CHECK_FALSE(takes(WindCommand{-1.0}, lesson));
    CHECK_FALSE(takes(WindCommand{kNaN}, lesson));
}

TEST_CASE("wire: a design that is none, a line or a launch out of range are refused") {
    const LessonDescription lesson = fulcrum::test::full_description();
    const auto refused = [&](auto change) { return !takes(with(change), lesson); };
    CHECK(refused([](KiteCommand& c) { c.design->height_m = kNaN; }));
    CHECK(refused([](KiteCommand& c) { c.design->strips = 0; }));
    CHECK(refused([](KiteCommand& c) { c.design->bridle_m = 0.5; }));  // shorter than the kite
    CHECK(refused([](KiteCommand& c) { c.design->knot_m = 0.0; }));
    CHECK(refused([](KiteCommand& c) { c.line_m = 1.0; }));
    CHECK(refused([](KiteCommand& c) { c.launch_elevation_rad = -0.1; }));
}

TEST_CASE("wire: a description's kite and wind are in their ranges") {
    const auto refused = [](auto change) {
        LessonDescription lesson = fulcrum::test::full_description();
        change(lesson);
        return !takes_description(lesson);
    };
    CHECK_FALSE(refused([](LessonDescription&) {}));
    CHECK(refused([](LessonDescription& l) { l.kite->share = 0.0; }));
    CHECK(refused([](LessonDescription& l) { l.kite->flight.line.segments = 65; }));
    CHECK(refused([](LessonDescription& l) { l.kite->cloth = "a cloth"; }));
    CHECK(refused([](LessonDescription& l) { l.wind.speed_m_per_s = 61.0; }));
    CHECK(refused([](LessonDescription& l) { l.wind.downwind_W.x() = 2.0; }));
}

}  // namespace
}  // namespace fulcrum::runtime
