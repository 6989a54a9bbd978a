#include "haptics/base/sha256.h"

#include <catch2/catch.hpp>

#include <string_view>
#include <vector>

namespace fulcrum {
namespace {

std::string hash(std::string_view text) {
    return to_hex(compute_sha256(std::as_bytes(std::span(text))));
}

// NIST's examples for FIPS 180: one block, two blocks, none at all, and the million letters of its long message.
TEST_CASE("sha256: the standard's examples") {
    CHECK(hash("abc") == "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
    CHECK(hash("abcdbcdecdefdefgefghfghighijhijkijkljklmklmnlmnomnopnopq") ==
          "248d6a61d20638b8e5c026930c3e6039a33ce45964ff2167f6ecedd419db06c1");
    CHECK(hash("") == "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855");
    const std::string long_one(1'000'000, 'a');
    CHECK(hash(long_one) == "cdc76e5c9914fb9281a1c7e284d73e67f1809a48a497200e046d39ccc7112cd0");
}

TEST_CASE("sha256: in parts of any length it is the same") {
    std::vector<std::byte> bytes(300);
    for (std::size_t i = 0; i < bytes.size(); ++i) {
        bytes[i] = static_cast<std::byte>(7 * i & 0xFFU);
    }
    for (std::size_t length : {0U, 1U, 55U, 56U, 63U, 64U, 65U, 119U, 128U, 300U}) {
        const std::span<const std::byte> all(bytes.data(), length);
        for (std::size_t part : {1U, 13U, 64U, 65U}) {
            Sha256 parts;
            for (std::size_t at = 0; at < length; at += part) {
                parts.add(all.subspan(at, std::min(part, length - at)));
            }
            CHECK(parts.finish() == compute_sha256(all));
        }
    }
}

}  // namespace
}  // namespace fulcrum
