#include "runtime/lua/sandbox/arena.h"
#include "runtime/lua/sandbox/lua_seed.h"
#include "runtime/lua/sandbox/script_error.h"
#include "runtime/lua/sandbox/script_state.h"
#include "tests/unit/runtime/lua/hosted_lesson.h"
#include "tests/unit/runtime/rig.h"

#include <cstring>
#include <random>

using namespace fulcrum::runtime::test;

namespace {

constexpr auto run = [](auto&&... arguments) { return run_script(arguments...); };

}  // namespace

TEST_CASE("arena: random allocation keeps every block's content apart, and gives all back") {
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

TEST_CASE("script: a spent budget is not swallowed by pcall, coroutine or wrap") {
    const std::string sentence = std::string("test.lua:1: ") + kTooLong + ".";
    for (const char* text :
         {"while true do end", "while true do pcall(function() while true do end end) end",
          "return pcall(function() while true do end end)",
          "return coroutine.resume(coroutine.create(function() while true do end end))",
          "while true do coroutine.wrap(function() while true do end end)() end",
          "local co = coroutine.create(function() pcall(function() while true do end end) end) "
          "coroutine.resume(co) return 'out'",
          "pcall(string.rep, 'x', 1000000) pcall(string.find, ('a'):rep(40), ('a?'):rep(40) .. "
          "'b') return 'out'",
          "table.sort({ 1, 2, 3 }, function() while true do end end)"}) {
        ScriptState state({});
        CHECK(run(state, text, 100'000) == sentence);
    }
}

TEST_CASE("script: a charge counts like instructions") {
    ScriptState state({});
    state.begin_budget(1000);
    CHECK_FALSE(state.protect([&](lua_State* lua) { state.charge(lua, 1000); }));
    CHECK(state.used_instructions() == 1000);
    const auto error = state.protect([&](lua_State* lua) { state.charge(lua, 1); });
    REQUIRE(error);
    CHECK(error->message == kTooLong);
}

TEST_CASE("script: memory is capped, and the state works on after a refusal that was caught") {
    ScriptSettings settings;
    settings.memory_bytes = 4U << 20U;
    ScriptState state(settings);
    CHECK(run(state, "local t = {} for i = 1, 1e9 do t[i] = { i } end", 0) ==
          "test.lua:1: this needs more memory than the 4 MB that a lesson may have.");
    CHECK(run(state,
              "local ok, e = pcall(function() local t = {} for i = 1, 1e9 do t[i] = { i } end end) "
              "return tostring(ok) .. e",
              0) == "falsenot enough memory");
    CHECK(run(state, "return 'fine'") == "fine");
}

TEST_CASE("script: a message with wild bytes becomes a clean one") {
    CHECK(clean_text("h\xC3\xA9llo", 2) == "h");
    CHECK(clean_text("h\xC3\xA9llo", 3) == "h\xC3\xA9");
    CHECK(clean_text("\xFF", 9) == "?");
}

TEST_CASE("script: the order of pairs is repeatable here") {
    ScriptState state({});
    CHECK(state.is_repeatable());
}

TEST_CASE("lua seed: the order of names is the same in two states, at any depth of the stack") {
    const std::string text =
        "local t, out = {}, '' for i = 1, 50 do t['n' .. i * 7919] = i end for k in pairs(t) do "
        "out = out .. k end return out";
    const std::string first = run(text);
    const auto deeper = [&](auto self, int depth) -> std::string {
        volatile char space[512] = {static_cast<char>(depth)};
        return depth == 0
                   ? run(text)
                   : self(self, depth - 1) + std::string(static_cast<std::size_t>(space[1]), ' ');
    };
    CHECK(deeper(deeper, 50) == first);
}

TEST_CASE("lua seed: a block that is no Lua state is left alone") {
    std::array<std::byte, 512> block{};
    int argument = 0;
    CHECK_FALSE(fix_string_seed(
        block.data(), block.size(), [](void*, void*, size_t, size_t) -> void* { return nullptr; },
        &argument));
    CHECK(block == std::array<std::byte, 512>{});
}
