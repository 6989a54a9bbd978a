// math and utf8. Random numbers are the same in every run: xoshiro256** from the seed that the
// program gives.
//
// Source: Blackman & Vigna, "Scrambled Linear Pseudorandom Number Generators", ACM Trans. Math.
// Softw. 47 (2021), xoshiro256**; splitmix64 fills its state.
#include "runtime/lua/sandbox/safe_library.h"
#include "runtime/lua/sandbox/script_state.h"

#include <bit>

namespace fulcrum::runtime {
namespace {

void seed_random(ScriptState& state, std::uint64_t seed) {
    for (std::uint64_t& word : state.random) {
        seed += 0x9E3779B97F4A7C15U;
        std::uint64_t z = seed;
        z = (z ^ (z >> 30U)) * 0xBF58476D1CE4E5B9U;
        z = (z ^ (z >> 27U)) * 0x94D049BB133111EBU;
        word = z ^ (z >> 31U);
    }
}

std::uint64_t next_random(std::array<std::uint64_t, 4>& s) {
    const std::uint64_t result = std::rotl(s[1] * 5, 7) * 9;
    const std::uint64_t t = s[1] << 17U;
    s[2] ^= s[0];
    s[3] ^= s[1];
    s[1] ^= s[2];
    s[0] ^= s[3];
    s[2] ^= t;
    s[3] = std::rotl(s[3], 45);
    return result;
}

/// math.random(): [0, 1); math.random(n): 1 to n; math.random(low, high).
int safe_random(lua_State* lua) {
    std::uint64_t word = next_random(ScriptState::of(lua).random);
    const int n_arguments = lua_gettop(lua);
    if (n_arguments == 0) {
        constexpr double kUnit = 1.0 / 9007199254740992.0;  // 2^-53
        lua_pushnumber(lua, static_cast<double>(word >> 11U) * kUnit);
        return 1;
    }
    const lua_Integer low = n_arguments == 1 ? 1 : luaL_checkinteger(lua, 1);
    const lua_Integer high = luaL_checkinteger(lua, n_arguments == 1 ? 1 : 2);
    luaL_argcheck(lua, low <= high, n_arguments == 1 ? 1 : 2, "the interval is empty");
    // Numbers beyond the last whole multiple of the range are thrown away: every result is equally
    // likely.
    const std::uint64_t range = static_cast<std::uint64_t>(high) - static_cast<std::uint64_t>(low);
    if (range != UINT64_MAX) {
        const std::uint64_t n = range + 1;
        const std::uint64_t remainder = (UINT64_MAX % n + 1) % n;
        while (remainder != 0 && word > UINT64_MAX - remainder) {
            word = next_random(ScriptState::of(lua).random);
        }
        word %= n;
    }
    lua_pushinteger(lua, std::bit_cast<lua_Integer>(static_cast<std::uint64_t>(low) + word));
    return 1;
}

/// math.randomseed(n): another sequence, the same in every run; without a number the lesson's own.
int safe_randomseed(lua_State* lua) {
    ScriptState& state = ScriptState::of(lua);
    seed_random(state,
                state.settings().seed + static_cast<std::uint64_t>(std::bit_cast<std::uint64_t>(
                                            static_cast<double>(luaL_optnumber(lua, 1, 0.0)))));
    return 0;
}

}  // namespace

void open_safe_math(lua_State* lua) {
    luaL_requiref(lua, LUA_MATHLIBNAME, luaopen_math, 0);
    constexpr luaL_Reg kOurs[] = {
        {"random", safe_random}, {"randomseed", safe_randomseed}, {nullptr, nullptr}};
    luaL_setfuncs(lua, kOurs, 0);
    lua_setglobal(lua, LUA_MATHLIBNAME);
    seed_random(ScriptState::of(lua), ScriptState::of(lua).settings().seed);

    luaL_requiref(lua, LUA_UTF8LIBNAME, luaopen_utf8, 0);
    static constexpr const char* kKept[] = {"char", "codepoint", "len", "offset", "codes", nullptr};
    keep_charged(lua, kKept);
    lua_getfield(lua, -2, "charpattern");
    lua_setfield(lua, -2, "charpattern");
    lua_setglobal(lua, LUA_UTF8LIBNAME);
    lua_pop(lua, 1);
}

}  // namespace fulcrum::runtime
