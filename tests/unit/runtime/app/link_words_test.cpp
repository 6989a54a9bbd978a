#include "runtime/app/link_words.h"

#include "haptics/base/clock.h"
#include "haptics/link/arm_server.h"
#include "haptics/link/link_faults.h"
#include "runtime/app/hand_device.h"
#include "runtime/link/arm_key.h"
#include "runtime/link/udp_socket.h"
#include "tests/support/scripted_device.h"
#include "tests/unit/runtime/rig.h"

#include <atomic>
#include <chrono>
#include <thread>

using namespace fulcrum::runtime::test;

namespace {

LinkStatus came(Refusal why) {
    LinkStatus status;
    status.counts.received[static_cast<std::size_t>(why)] = 3;
    return status;
}
std::string why(const LinkStatus& status, bool is_refused = false) {
    return to_sentence(explain_silence(status, is_refused, "arm:4701", "keys/arm.key"));
}

// A folder with keys, that is gone afterwards.
struct Keys {
    [[nodiscard]] std::string file(const std::string& name) const { return folder.file(name); }
    [[nodiscard]] ArmKey key(const std::string& name) const {
        return value_of(load_or_make_arm_key(file(name)));
    }
    ScratchFolder folder;
};

// What is said when a program with the key `ours` wants the arm at `port`.
std::string open_at(std::uint16_t port, const std::string& ours) {
    RunRequest request;
    request.hand = HandKind::link;
    request.hand_address = "127.0.0.1:" + std::to_string(port);
    request.key_file = ours;
    const auto hand = HandDevice::open(request, HapticPlan{});
    return hand ? "" : to_sentence(hand.error());
}

// Something at a port that goes on by itself, until the end.
class Peer {
  public:
    template <class Round>
    explicit Peer(Round round)
        : thread_([this, round]() mutable {
              while (!ended_.load()) {
                  round(monotonic_now_s());
                  std::this_thread::sleep_for(std::chrono::microseconds(700));
              }
          }) {}
    ~Peer() {
        ended_.store(true);
        thread_.join();
    }

  private:
    std::atomic<bool> ended_{false};
    std::thread thread_;
};

std::unique_ptr<UdpSocket> listen() {
    return value_of(UdpSocket::listen({"127.0.0.1", 0}));
}

// Answers whatever comes with a welcome sealed with `key`, and with another version where `version` is one.
auto make_answerer(UdpSocket& socket, const ArmKey& key, std::uint16_t version) {
    return [&socket, seal = std::make_shared<SodiumSeal>(key), version](double now_s) {
        PacketBytes bytes{};
        PeerAddress from;
        while (socket.receive(now_s, bytes, from) > 0) {
            LinkPacket welcome;
            welcome.head = {PacketKind::welcome, 1, 2, 1, 1, 0, 0};
            welcome.traits.rate_Hz = 1000.0;
            const std::size_t size = write_packet(welcome, *seal, bytes);
            bytes[4] = static_cast<std::byte>(version);
            (void)socket.send(now_s, from, std::span(bytes).first(size));
        }
    };
}

}  // namespace

TEST_CASE("link words: each silence has a sentence of its own") {
    LinkStatus taken;
    taken.taken = true;
    check_says(why(taken), {"held by another program"});
    check_says(why(came(Refusal::forged)), {"an arm answers with another key"});
    check_says(why(came(Refusal::forged)), {"keys/arm.key"});
    check_says(why(came(Refusal::version)), {"another version of the link"});
    check_says(why({}, true), {"no arm waits there"});
    check_says(why({}), {"no arm answers, and nothing says that there is none"});
    check_says(why({}), {"another key or version"});
    check_says(why({}), {"arm:4701"});
    // What came tells more than a port that was closed for a moment.
    check_says(why(came(Refusal::forged), true), {"another key"});
    // A packet that the way has damaged tells nothing of a key.
    check_says(why(came(Refusal::damaged)), {"no arm answers"});
    for (const Refusal seems : {Refusal::forged, Refusal::version}) {
        LinkStatus damaged = came(Refusal::damaged);
        damaged.counts.received[static_cast<std::size_t>(seems)] = 2;
        check_says(why(damaged), {"no arm answers"});
    }
}

TEST_CASE("link words: another key, another version, silence and a closed port are told apart") {
    const Keys keys;
    const ArmKey ours = keys.key("ours.key");
    const ArmKey theirs = keys.key("theirs.key");
    std::uint16_t closed = 0;
    {
        const auto socket = listen();
        closed = socket->port();
        const Peer peer(make_answerer(*socket, theirs, kLinkVersion));
        check_says(open_at(closed, keys.file("ours.key")), {"another key"});
    }
    check_says(open_at(closed, keys.file("ours.key")), {"no arm waits there"});
    {
        const auto socket = listen();
        const Peer peer(make_answerer(*socket, ours, kLinkVersion + 1));
        check_says(open_at(socket->port(), keys.file("ours.key")), {"another version"});
    }
    // An arm with another key says nothing, here and to any stranger; it counts who knocked.
    const auto socket = listen();
    ScriptedDevice device;
    const SodiumSeal seal(theirs);
    SodiumNumbers numbers;
    ArmServer server({}, device, *socket, seal, numbers);
    {
        const Peer peer([&](double now_s) { server.step(now_s); });
        check_says(open_at(socket->port(), keys.file("ours.key")), {"no arm answers"});
    }
    const LinkCounts& counts = server.status().counts;
    CHECK(counts.received[static_cast<std::size_t>(Refusal::forged)] > 10);
    CHECK(counts.sent == 0);
}

TEST_CASE("link words: a way that becomes too long is told once, and once that it is not") {
    LinkStatus status;
    status.too_long = true;
    status.newest_round_trip_s = 0.612;
    CHECK(describe_way(status, 0.25) ==
          "The way to the arm takes 612 ms there and back, too long for forces (250 ms at most): "
          "there are none until it is quicker.");
    status.too_long = false;
    status.newest_round_trip_s = 0.012;
    CHECK(describe_way(status, 0.25) ==
          "The way to the arm takes 12 ms there and back now: forces come back, softly.");
}

TEST_CASE("link words: through sockets, in mid-run, both sentences come, each once") {
    const Keys keys;
    const auto socket = listen();
    FaultyDatagrams line({}, *socket);
    ScriptedDevice device;
    const SodiumSeal seal(keys.key("arm.key"));
    SodiumNumbers numbers;
    ArmServer server({}, device, line, seal, numbers);
    std::atomic<bool> is_slow{false};
    const Peer peer([&](double now_s) {
        line.set({.delay_s = is_slow.load() ? 0.2 : 0.0});
        server.step(now_s);
    });
    RunRequest request;
    request.hand = HandKind::link;
    request.hand_address = "127.0.0.1:" + std::to_string(socket->port());
    request.key_file = keys.file("arm.key");
    const auto hand = value_of(HandDevice::open(request, HapticPlan{}));
    const double began_s = monotonic_now_s();
    const auto play = [&](double seconds) {
        std::string said;
        for (const double until_s = monotonic_now_s() + seconds; monotonic_now_s() < until_s;) {
            const double now_s = monotonic_now_s() - began_s;
            DeviceReading reading;
            (void)hand->device().read(now_s, reading);
            (void)hand->device().write(now_s, {});
            said += hand->take_notice();
            std::this_thread::sleep_for(std::chrono::milliseconds(1));
        }
        return said;
    };
    CHECK(play(1.5).empty());
    is_slow.store(true);
    const std::string slow = play(3.5);
    check_says(slow, {"too long for forces (250 ms at most)"});
    CHECK(slow.find("The way", 1) == std::string::npos);
    is_slow.store(false);
    const std::string quick = play(3.0);
    check_says(quick, {"forces come back, softly"});
    CHECK(quick.find("The way", 1) == std::string::npos);
}
