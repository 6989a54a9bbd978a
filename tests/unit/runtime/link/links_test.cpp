#include "haptics/base/sha256.h"
#include "runtime/link/arm_key.h"
#include "runtime/link/sodium_seal.h"
#include "runtime/link/udp_socket.h"
#include "tests/support/link.h"
#include "tests/unit/runtime/rig.h"

#include <atomic>
#include <chrono>
#include <sys/stat.h>
#include <thread>

using namespace fulcrum::runtime::test;

namespace {

void write_key(const std::filesystem::path& file, const std::string& text, mode_t mode = 0600) {
    std::ofstream(file) << text;
    REQUIRE(::chmod(file.c_str(), mode) == 0);
}

std::span<const std::byte> bytes_of(std::string_view text) {
    return std::as_bytes(std::span(text));
}

ArmKey key_of(std::uint8_t first) {
    ArmKey key;
    for (std::size_t i = 0; i < key.size(); ++i) {
        key[i] = static_cast<std::byte>(first + i);
    }
    return key;
}

// On this computer a packet is there within milliseconds; a second is for one that is very busy.
std::size_t receive_soon(UdpSocket& socket, std::span<std::byte> packet, PeerAddress& from) {
    for (int i = 0; i < 1000; ++i) {
        if (const std::size_t size = socket.receive(0.0, packet, from)) {
            return size;
        }
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
    return 0;
}

}  // namespace

TEST_CASE("arm key: made where it is missing, for its owner alone, and the same the next time") {
    const ScratchFolder folder;
    const auto file = folder.path() / "own" / "arm.key";
    const auto made = value_of(load_or_make_arm_key(file));
    struct stat about {};
    REQUIRE(::stat(file.c_str(), &about) == 0);
    CHECK((about.st_mode & 0777) == 0600);
    CHECK(about.st_size == 65);
    const auto again = value_of(load_or_make_arm_key(file));
    CHECK(again == made);
}

TEST_CASE("arm key: many who make it at once all end with the same one") {
    for (int again = 0; again < 20; ++again) {
        const ScratchFolder folder;
        const auto file = folder.path() / "own" / "arm.key";
        constexpr std::size_t kPrograms = 8;
        std::array<std::optional<ArmKey>, kPrograms> keys;
        std::atomic<std::size_t> n_ready{0};
        std::vector<std::thread> programs;
        for (std::size_t i = 0; i < kPrograms; ++i) {
            programs.emplace_back([&, i] {
                ++n_ready;
                while (n_ready.load() < kPrograms) {
                }
                if (const auto key = load_or_make_arm_key(file)) {
                    keys[i] = *key;
                }
            });
        }
        for (std::thread& program : programs) {
            program.join();
        }
        const auto last = value_of(load_or_make_arm_key(file));
        for (const std::optional<ArmKey>& key : keys) {
            REQUIRE(key);
            CHECK(*key == last);
        }
        // Nothing unfinished is left beside it.
        CHECK(std::distance(std::filesystem::directory_iterator(file.parent_path()), {}) == 1);
    }
}

TEST_CASE("arm key: 64 figures, with or without a line's end") {
    const ScratchFolder folder;
    const auto file = folder.path() / "arm.key";
    const std::string figures = "000102030405060708090a0b0c0d0e0f101112131415161718191a1b1c1d1e1f";
    for (const std::string& text : {figures, figures + "\n"}) {
        write_key(file, text);
        const auto key = value_of(load_or_make_arm_key(file));
        for (std::size_t i = 0; i < key.size(); ++i) {
            CHECK(std::to_integer<std::size_t>(key[i]) == i);
        }
    }
}

TEST_CASE("arm key: what is none, or no secret, is refused with its file, and left as it is") {
    const ScratchFolder folder;
    const auto file = folder.path() / "arm.key";
    const std::string figures(64, 'a');
    for (const std::string& text :
         {std::string(), std::string("x"), figures.substr(1), figures + "a", figures + "\n\n",
          figures.substr(1) + "g", figures.substr(1) + "A", std::string(100'000, 'a')}) {
        write_key(file, text);
        CHECK(error_of(load_or_make_arm_key(file)).where == file.string());
        CHECK(std::filesystem::file_size(file) == text.size());
    }
    for (const mode_t mode : {0640, 0604, 0660}) {
        write_key(file, figures, mode);
        check_says(error_of(load_or_make_arm_key(file)).what_to_do, {"chmod 600"});
    }
}

TEST_CASE("sodium seal: is HMAC-SHA-256, as RFC 4231 has it") {
    // Test case 1 of RFC 4231: key 20 times 0x0B, which zeros make as long as ours; "Hi There".
    ArmKey key{};
    for (std::size_t i = 0; i < 20; ++i) {
        key[i] = std::byte{0x0B};
    }
    const SodiumSeal seal(key);
    CHECK(to_hex(seal.make(bytes_of("Hi There"))) ==
          "b0344c61d8db38535ca8afceaf0bf12b881dc200c9833da726e9376c2e32cff7");
    // Test case 2: "Jefe".
    ArmKey jefe{};
    std::copy_n(bytes_of("Jefe").begin(), 4, jefe.begin());
    CHECK(to_hex(SodiumSeal(jefe).make(bytes_of("what do ya want for nothing?"))) ==
          "5bdcc146bf60754e6a042426089575c75a003f089d2739839dec58b964ec3843");
}

TEST_CASE("sodium seal: agrees with the tests' own, and holds for nothing else") {
    const SodiumSeal seal(key_of(7));
    const test_link::HmacSeal own(7);
    const std::string_view text =
        "any bytes whatever, longer than one block of sixty-four bytes: yes, they are";
    for (std::size_t size = 0; size <= text.size(); ++size) {
        const auto message = bytes_of(text.substr(0, size));
        const SealTag tag = seal.make(message);
        REQUIRE(tag == own.make(message));
        REQUIRE(seal.holds(message, tag));
        SealTag other = tag;
        other[size % other.size()] ^= std::byte{1};
        REQUIRE_FALSE(seal.holds(message, other));
        REQUIRE_FALSE(SodiumSeal(key_of(8)).holds(message, tag));
    }
}

TEST_CASE("sodium seal: session numbers and keys are not drawn twice") {
    SodiumNumbers numbers;
    std::set<std::uint64_t> seen;
    for (int i = 0; i < 1000; ++i) {
        const std::uint64_t number = numbers.draw();
        REQUIRE(number != 0);
        REQUIRE(seen.insert(number).second);
    }
    CHECK(draw_arm_key() != draw_arm_key());
}

TEST_CASE("udp socket: HOST:PORT is read, and what is none gets a sentence") {
    const auto plain = value_of(parse_host_port("localhost:4701"));
    CHECK(plain.host == "localhost");
    CHECK(plain.port == 4701);
    const auto six = value_of(parse_host_port("[::1]:80"));
    CHECK(six.host == "::1");
    for (const char* const bad :
         {"", ":", "localhost", "localhost:", ":4701", "localhost:0", "localhost:65536",
          "localhost:x", "localhost:12x", "::1:80", "[]:80"}) {
        INFO(bad);
        CHECK_FALSE(parse_host_port(bad));
    }
}

TEST_CASE("udp socket: packets go there and back, with whom they are from") {
    const auto arm = value_of(UdpSocket::listen({"127.0.0.1", 0}));
    REQUIRE(arm->port() != 0);
    const auto program = value_of(UdpSocket::connect({"127.0.0.1", arm->port()}));
    std::array<std::byte, 8> packet{};
    PeerAddress from;
    CHECK(arm->receive(0.0, packet, from) == 0);
    const std::array<std::byte, 4> sent{std::byte{1}, std::byte{2}, std::byte{3}, std::byte{4}};
    CHECK(program->send(0.0, {}, sent));
    REQUIRE(receive_soon(*arm, packet, from) == 4);
    CHECK(packet[3] == std::byte{4});
    CHECK(from.size > 0);
    CHECK(arm->send(0.0, from, sent));
    PeerAddress back;
    REQUIRE(receive_soon(*program, packet, back) == 4);
    // The same peer has the same address each time; to nobody nothing goes.
    PeerAddress again;
    CHECK(program->send(0.0, {}, sent));
    REQUIRE(receive_soon(*arm, packet, again) == 4);
    CHECK(again == from);
    CHECK_FALSE(arm->send(0.0, {}, sent));
}

TEST_CASE("udp socket: a packet that is longer than there is room tells its whole size") {
    const auto arm = value_of(UdpSocket::listen({"127.0.0.1", 0}));
    const auto program = value_of(UdpSocket::connect({"127.0.0.1", arm->port()}));
    const std::array<std::byte, 600> sent{};
    CHECK(program->send(0.0, {}, sent));
    std::array<std::byte, 8> packet{};
    PeerAddress from;
    CHECK(receive_soon(*arm, packet, from) == 600);
}

TEST_CASE("udp socket: nobody there is no error, and who comes later is heard") {
    std::uint16_t port = 0;
    {
        const auto gone = value_of(UdpSocket::listen({"127.0.0.1", 0}));
        port = gone->port();
    }
    const auto program = value_of(UdpSocket::connect({"127.0.0.1", port}));
    std::array<std::byte, 8> packet{};
    PeerAddress from;
    for (int i = 0; i < 20; ++i) {
        (void)program->send(0.0, {}, packet);
        CHECK(program->receive(0.0, packet, from) == 0);
    }
    const auto arm = value_of(UdpSocket::listen({"127.0.0.1", port}));
    // The first may still meet the error of the one before.
    (void)program->send(0.0, {}, packet);
    (void)program->send(0.0, {}, packet);
    CHECK(receive_soon(*arm, packet, from) == 8);
}

TEST_CASE("udp socket: a port that is taken and a computer that nobody knows are one sentence") {
    const auto first = value_of(UdpSocket::listen({"127.0.0.1", 0}));
    check_says(error_of(UdpSocket::listen({"127.0.0.1", first->port()})).what_to_do, {"--port"});
    CHECK(error_of(UdpSocket::connect({"no such computer", 4701})).where ==
          "no such computer:4701");
}

TEST_CASE("udp socket: a port where nothing waits is told by its computer, a silent one not") {
    std::uint16_t port = 0;
    {
        const auto silent = value_of(UdpSocket::listen({"127.0.0.1", 0}));
        port = silent->port();
        const auto program = value_of(UdpSocket::connect({"127.0.0.1", port}));
        std::array<std::byte, 8> packet{};
        PeerAddress from;
        CHECK(program->send(0.0, {}, packet));
        CHECK(program->receive(0.0, packet, from) == 0);
        CHECK_FALSE(program->was_refused());
    }
    for (const bool sends_again : {false, true}) {
        const auto program = value_of(UdpSocket::connect({"127.0.0.1", port}));
        std::array<std::byte, 8> packet{};
        PeerAddress from;
        CHECK(program->send(0.0, {}, packet));
        // The answer comes with the next call, whichever that is.
        if (sends_again) {
            std::this_thread::sleep_for(std::chrono::milliseconds(20));
            CHECK_FALSE(program->send(0.0, {}, packet));
        }
        CHECK(program->receive(0.0, packet, from) == 0);
        CHECK(program->was_refused());
    }
}
