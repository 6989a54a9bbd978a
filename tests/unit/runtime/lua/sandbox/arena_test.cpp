#include "runtime/lua/sandbox/arena.h"

#include <catch2/catch.hpp>

#include <cstring>
#include <map>
#include <random>

namespace fulcrum::runtime {
namespace {

TEST_CASE(
    "arena: random allocation keeps every block's content, apart from all others, and gives all "
    "back") {
    Arena arena(8U << 20U, 0);
    std::mt19937 random(7);
    std::map<std::uint8_t*, std::pair<std::size_t, std::uint8_t>> blocks;  // block -> size, fill
    const auto check = [](const auto& block) {
        for (std::size_t i = 0; i < block.second.first; ++i) {
            if (block.first[i] != block.second.second) {
                return false;
            }
        }
        return true;
    };
    std::size_t expected_bytes = 0;
    for (int step = 0; step < 20000; ++step) {
        const std::size_t size = random() % 8 == 0 ? 1 + random() % 60000 : 1 + random() % 200;
        const auto fill = static_cast<std::uint8_t>(random());
        if (blocks.size() < 200 && random() % 3 != 0) {
            auto* block = static_cast<std::uint8_t*>(arena.reallocate(nullptr, 0, size));
            REQUIRE(block != nullptr);
            REQUIRE(reinterpret_cast<std::uintptr_t>(block) % kArenaGrainBytes == 0);
            std::memset(block, fill, size);
            blocks[block] = {size, fill};
            expected_bytes += size;
        } else if (!blocks.empty()) {
            auto it = blocks.begin();
            std::advance(it, random() % blocks.size());
            const auto [old_size, old_fill] = it->second;
            REQUIRE(check(*it));
            std::uint8_t* block = it->first;
            blocks.erase(it);
            expected_bytes -= old_size;
            const bool grow = random() % 2 == 0;
            auto* moved =
                static_cast<std::uint8_t*>(arena.reallocate(block, old_size, grow ? size : 0));
            if (grow) {
                REQUIRE(moved != nullptr);
                for (std::size_t i = 0; i < std::min(old_size, size); ++i) {
                    REQUIRE(moved[i] == old_fill);
                }
                std::memset(moved, fill, size);
                blocks[moved] = {size, fill};
                expected_bytes += size;
            }
        }
        REQUIRE(arena.used_bytes() == expected_bytes);
    }
    for (const auto& block : blocks) {
        CHECK(check(block));
    }
}

TEST_CASE("arena: refuses beyond its capacity and goes on after that") {
    Arena arena(1U << 20U, 0);
    CHECK(arena.reallocate(nullptr, 0, 2U << 20U) == nullptr);
    CHECK(arena.n_refused() == 1);
    void* all = arena.reallocate(nullptr, 0, 1U << 20U);
    REQUIRE(all != nullptr);
    CHECK(arena.reallocate(nullptr, 0, 16) == nullptr);
    CHECK(arena.reallocate(all, 1U << 20U, 2U << 20U) == nullptr);  // the old block stays
    std::memset(all, 1, 1U << 20U);
    CHECK(arena.reallocate(all, 1U << 20U, 0) == nullptr);
    CHECK(arena.used_bytes() == 0);
    CHECK(arena.reallocate(nullptr, 0, 1U << 20U) == all);
}

TEST_CASE("arena: the same requests get the same addresses") {
    const auto addresses = [] {
        Arena arena(4U << 20U, 0);
        REQUIRE(arena.is_at_fixed_address());
        std::vector<void*> given;
        for (std::size_t size : {16U, 5000U, 17U, 100000U, 16U, 1024U, 1025U}) {
            given.push_back(arena.reallocate(nullptr, 0, size));
        }
        return given;
    };
    CHECK(addresses() == addresses());
}

TEST_CASE("arena: two slots lie apart, and a taken place is no failure") {
    Arena first(1U << 20U, 0);
    Arena second(1U << 20U, 1);
    Arena third(1U << 20U, 0);
    CHECK(first.is_at_fixed_address());
    CHECK(second.is_at_fixed_address());
    CHECK_FALSE(third.is_at_fixed_address());
    CHECK(third.reallocate(nullptr, 0, 64) != nullptr);
}

}  // namespace
}  // namespace fulcrum::runtime
