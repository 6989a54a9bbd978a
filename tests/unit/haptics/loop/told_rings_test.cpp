#include "haptics/loop/told_rings.h"

#include "haptics/flight/kite_loop.h"

#include <catch2/catch.hpp>

#include <memory>
#include <string>
#include <type_traits>
#include <vector>

using namespace fulcrum;

namespace {

// What came out, as "kind tick value".
std::vector<std::string> drain(ToldRings& rings) {
    std::vector<std::string> out;
    rings.drain([&](const auto& told) {
        using T = std::remove_cvref_t<decltype(told.value)>;
        const std::string tick = " " + std::to_string(told.tick);
        if constexpr (std::is_same_v<T, ToldReading>) {
            out.push_back("reading" + tick);
        } else if constexpr (std::is_same_v<T, AxleOrders>) {
            out.push_back("axles" + tick);
        } else {
            out.push_back((std::is_same_v<T, ForceCommand> ? "command"
                           : std::is_same_v<T, WorldFrame> ? "world"
                           : std::is_same_v<T, RigidFrame> ? "rigid"
                                                           : "line") +
                          tick + " " + std::to_string(static_cast<int>(told.value.stamp_s)));
        }
    });
    return out;
}

}  // namespace

TEST_CASE("told rings: of each channel what was taken is kept with its round, once") {
    auto channels = std::make_unique<HapticChannels>();
    AxleChannels axles;
    RigidChannels rigid;
    KiteChannels kite;
    channels->axles = &axles;
    channels->rigid = &rigid;
    channels->kite = &kite;
    ToldRings rings(*channels);
    CHECK(rings.keep(0, {}));
    CHECK(drain(rings).empty());
    ForceCommand command;
    command.stamp_s = 3.0;
    channels->command.publish(command);
    CHECK(rings.keep(1, {}));  // not taken yet
    CHECK(drain(rings).empty());
    REQUIRE(channels->command.take());
    WorldFrame frame;
    frame.stamp_s = 4.0;
    channels->world.publish(frame);
    REQUIRE(channels->world.take());
    CHECK(rings.keep(2, {Fault::clutched, true}));
    CHECK(rings.keep(3, {}));
    axles.orders.publish({});
    REQUIRE(axles.orders.take());
    rigid.frame.publish({5.0});
    REQUIRE(rigid.frame.take());
    kite.line.publish({6.0});
    REQUIRE(kite.line.take());
    CHECK(rings.keep(4, {Fault::none, false}));
    CHECK(drain(rings) == std::vector<std::string>{"command 2 3", "world 2 4", "axles 4",
                                                   "rigid 4 5", "line 4 6", "reading 2",
                                                   "reading 4"});
    CHECK(rings.dropped() == 0);
}

TEST_CASE("told rings: what finds no room is told at once and counted") {
    auto channels = std::make_unique<HapticChannels>();
    ToldRings rings(*channels);
    std::uint64_t tick = 0;
    const auto tell = [&] {
        channels->world.publish({});
        REQUIRE(channels->world.take());
        return rings.keep(tick++, {});
    };
    for (std::size_t i = 0; i < kToldRingCapacity; ++i) {
        REQUIRE(tell());
    }
    CHECK_FALSE(tell());
    CHECK(rings.dropped() == 1);
    CHECK(drain(rings).size() == kToldRingCapacity);
    CHECK(tell());
    CHECK(rings.dropped() == 1);
}
