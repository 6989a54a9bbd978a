// Asks for memory ahead of its use, so that several misses of the caches are waited for at once.
//
// Thread: any. Cost: an instruction; a hint, it changes no result.
#pragma once

#include <cstddef>

namespace fulcrum {

inline constexpr std::size_t kCacheLine = 64;  ///< bytes, of the processors we know

/// The `bytes` from `start` on will be read soon.
inline void prefetch([[maybe_unused]] const void* start,
                     [[maybe_unused]] std::size_t bytes) noexcept {
#if defined(__GNUC__)
    const auto* const first = static_cast<const char*>(start);
    for (std::size_t at = 0; at < bytes; at += kCacheLine) {
        __builtin_prefetch(first + at);
    }
    __builtin_prefetch(first + bytes - 1);
#endif
}

}  // namespace fulcrum
