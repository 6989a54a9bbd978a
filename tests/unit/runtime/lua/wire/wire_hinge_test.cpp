// Hinges between the lesson's process and the program: what a lesson that lies is refused.
#include "runtime/lua/wire/wire.h"
#include "tests/support/wire_messages.h"

#include <catch2/catch.hpp>

#include <limits>

namespace fulcrum::runtime {
namespace {

constexpr std::size_t kHead = 5;  // length and kind

template <class Message>
Bytes bytes_of(const Message& message) {
    Bytes bytes;
    encode(message, bytes);
    return bytes;
}

bool takes_reply(const TurnCommand& turn) {
    LessonReply reply;
    reply.commands = {turn};
    const Bytes bytes = bytes_of(reply);
    return decode_reply(std::span(bytes).subspan(kHead), fulcrum::test::full_description())
        .has_value();
}

bool takes_description(const LessonDescription& description) {
    const Bytes bytes = bytes_of(description);
    return decode_description(std::span(bytes).subspan(kHead)).has_value();
}

TEST_CASE("wire: a turn of a body without a hinge, or by no number, is refused") {
    CHECK(takes_reply({0, 0.5, -1.0, Vector3(1, 2, 3), 4.0}));
    CHECK(takes_reply({0, {}, {}, {}, {}}));
    CHECK_FALSE(takes_reply({1, 0.5, {}, {}, {}}));  // the egg has none
    CHECK_FALSE(takes_reply({-1, 0.5, {}, {}, {}}));
    CHECK_FALSE(takes_reply({0, std::numeric_limits<double>::quiet_NaN(), {}, {}, {}}));
    CHECK_FALSE(takes_reply({0, {}, 1e3, {}, {}}));
    CHECK_FALSE(takes_reply({0, {}, {}, {}, -1.0}));
}

TEST_CASE("wire: a description whose hinge cannot be is refused") {
    const auto with = [](auto change) {
        LessonDescription d = fulcrum::test::full_description();
        change(d.bodies[0]);
        return takes_description(d);
    };
    CHECK(with([](BodyDescription&) {}));
    CHECK_FALSE(with([](BodyDescription& b) { b.solid = false; }));
    CHECK_FALSE(with([](BodyDescription& b) { b.hinge->inertia_kg_m2 = 0.0; }));
    CHECK_FALSE(with([](BodyDescription& b) { b.hinge->axis_W.x() = 2.0; }));
    CHECK_FALSE(with([](BodyDescription& b) { b.hinge->load_N = -1.0; }));
}

}  // namespace
}  // namespace fulcrum::runtime
