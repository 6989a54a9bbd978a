#include "runtime/lua/wire/channel.h"
#include "runtime/lua/wire/wire.h"
#include "tests/support/wire_messages.h"
#include "tests/unit/runtime/rig.h"

#include <cstring>
#include <fcntl.h>
#include <sys/socket.h>
#include <unistd.h>

using namespace fulcrum::runtime::test;

namespace {

using Result = Channel::Result;

struct Pair {
    std::array<int, 2> ends{-1, -1};
    Pair() {
        REQUIRE(socketpair(AF_UNIX, SOCK_STREAM, 0, ends.data()) == 0);
        fcntl(ends[0], F_SETFL, O_NONBLOCK);
        fcntl(ends[1], F_SETFL, O_NONBLOCK);
    }
    ~Pair() {
        close(ends[0]);
        close(ends[1]);
    }
};

constexpr std::size_t kHead = 5;  // length and kind

template <class Message>
Bytes bytes_of(const Message& message) {
    Bytes bytes;
    encode(message, bytes);
    return bytes;
}

bool takes_description(const LessonDescription& description) {
    const Bytes bytes = bytes_of(description);
    return decode_description(std::span(bytes).subspan(kHead)).has_value();
}

const double kNaN = std::numeric_limits<double>::quiet_NaN();

template <class Command>
bool takes(const Command& command, const LessonDescription& lesson) {
    LessonReply reply;
    reply.commands = {command};
    const Bytes bytes = bytes_of(reply);
    return decode_reply(std::span(bytes).subspan(kHead), lesson).has_value();
}

bool takes_turn(const TurnCommand& turn) {
    return takes(turn, fulcrum::test::full_description());
}

KiteCommand with(auto change) {
    KiteCommand command;
    command.design = KiteSettings{};
    change(command);
    return command;
}

}  // namespace

TEST_CASE("channel: messages come whole and in order, however they are cut") {
    const Pair pair;
    Channel receiver(pair.ends[0], 1000);
    Bytes stream = bytes_of(PrintCommand{"one"});
    const Bytes two = bytes_of(PrintCommand{"two"});
    stream.insert(stream.end(), two.begin(), two.end());
    RawMessage message;
    std::vector<std::string> got;
    for (const std::uint8_t byte : stream) {
        REQUIRE(send(pair.ends[1], &byte, 1, 0) == 1);
        if (receiver.receive(message) == Result::message) {
            got.push_back(decode_print(message.body)->text);
        }
    }
    CHECK(got == std::vector<std::string>{"one", "two"});
    // Both at once: the second is there without another read.
    CHECK(Channel(pair.ends[1], 1000).send(stream) == stream.size());
    REQUIRE(receiver.receive(message) == Result::message);
    CHECK(decode_print(message.body)->text == "one");
    REQUIRE(receiver.receive(message) == Result::message);
    CHECK(decode_print(message.body)->text == "two");
    CHECK(receiver.receive(message) == Result::nothing);
}

TEST_CASE("channel: a length or kind that can't be is malformed, a closed end is closed") {
    const auto result_of = [](std::uint32_t length, std::uint8_t kind) {
        const Pair pair;
        Bytes bytes(5);
        std::memcpy(bytes.data(), &length, sizeof(length));
        bytes[4] = kind;
        CHECK(Channel(pair.ends[1], 1000).send(bytes) == 5U);
        RawMessage message;
        return Channel(pair.ends[0], 1000).receive(message);
    };
    CHECK(result_of(1, 0) == Result::message);
    CHECK(result_of(2, 0) == Result::nothing);
    CHECK(result_of(0, 0) == Result::malformed);
    CHECK(result_of(1001, 0) == Result::malformed);
    CHECK(result_of(0xFFFFFFFFU, 0) == Result::malformed);
    CHECK(result_of(1, 8) == Result::malformed);
    Pair pair;
    close(pair.ends[1]);
    RawMessage message;
    CHECK(Channel(pair.ends[0], 1000).receive(message) == Result::closed);
    CHECK_FALSE(
        Channel(pair.ends[0], 1000).send(bytes_of(PrintCommand{"x"})));  // and no signal kills us
    pair.ends[1] = -1;
}

TEST_CASE("channel: what the socket does not take is told") {
    const Pair pair;
    const Bytes much(8U << 20U);
    const auto sent = Channel(pair.ends[0], 1000).send(much);
    REQUIRE(sent);
    CHECK(*sent > 0);
    CHECK(*sent < much.size());
}

TEST_CASE("wire: a turn of a body without a hinge, or by no number, is refused") {
    CHECK(takes_turn({0, 0.5, -1.0, Vector3(1, 2, 3), 4.0}));
    CHECK(takes_turn({0, {}, {}, {}, {}}));
    CHECK_FALSE(takes_turn({1, 0.5, {}, {}, {}}));  // the egg has none
    CHECK_FALSE(takes_turn({-1, 0.5, {}, {}, {}}));
    CHECK_FALSE(takes_turn({0, std::numeric_limits<double>::quiet_NaN(), {}, {}, {}}));
    CHECK_FALSE(takes_turn({0, {}, 1e3, {}, {}}));
    CHECK_FALSE(takes_turn({0, {}, {}, {}, -1.0}));
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

TEST_CASE("wire: a slot comes with the name that its template gave it, however long") {
    const std::string name(kMaxTextBytes, 's');  // a template is no longer
    const std::vector<std::pair<std::string, std::string>> slots{{name, "an apple"}};
    LessonFrame frame;
    frame.events = {JudgeEvent{"q", slots}, AskedEvent{"k", slots}};
    AnsweredEvent answered;
    answered.slots = slots;
    frame.events.emplace_back(answered);
    Bytes bytes;
    encode(frame, bytes);
    const auto came = decode_frame(std::span(bytes).subspan(kHead));
    REQUIRE(came);
    CHECK(std::get<JudgeEvent>(came->events.at(0)).slots == slots);
    CHECK(std::get<AskedEvent>(came->events.at(1)).slots == slots);
    CHECK(std::get<AnsweredEvent>(came->events.at(2)).slots == slots);
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
