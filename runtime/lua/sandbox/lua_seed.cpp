#include "runtime/lua/sandbox/lua_seed.h"

#include <array>
#include <cstdint>
#include <cstring>

namespace fulcrum::runtime {
namespace {

constexpr std::uint32_t kSeed = 0x46554C43;

// global_State of Lua 5.4 begins: frealloc, ud, totalbytes, GCdebt, GCestimate, lastatomic, strt
// {pointer, int, int}, two tagged values of 16 bytes, seed.
constexpr std::size_t kSeedOffset = 6 * sizeof(void*) + 16 + std::size_t{2} * 16;

}  // namespace

bool fix_string_seed(std::byte* first_block, std::size_t bytes, lua_Alloc allocator,
                     void* argument) noexcept {
    static_assert(LUA_VERSION_NUM == 504 && sizeof(void*) == 8,
                  "the layout below is that of Lua 5.4, 64 bits");
    std::array<std::byte, sizeof(allocator) + sizeof(argument)> head{};
    std::memcpy(head.data(), &allocator, sizeof(allocator));
    std::memcpy(head.data() + sizeof(allocator), &argument, sizeof(argument));
    for (std::size_t at = 0; at + kSeedOffset + sizeof(kSeed) <= bytes; at += sizeof(void*)) {
        if (std::memcmp(first_block + at, head.data(), head.size()) == 0) {
            std::memcpy(first_block + at + kSeedOffset, &kSeed, sizeof(kSeed));
            return true;
        }
    }
    return false;
}

}  // namespace fulcrum::runtime
