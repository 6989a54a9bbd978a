// What this processor has beyond the least of its architecture, for which everything is compiled. Kernels that gain from more are
// compiled for that as well, each version as a set of functions of its own, and chosen while running; all give the same bits.
//
// Thread: any. Cost: reads what was found before main.
#pragma once

#include <array>
#include <cstddef>

// Whether the compiler builds kernels for more than the least processor, by its target pragma.
#if defined(__GNUC__) && !defined(__clang__) && defined(__x86_64__)
#define FULCRUM_WIDER_KERNELS 1
#endif

namespace fulcrum {

/// Eight numbers of single precision at once. False where the compiler of this library could not use it.
[[nodiscard]] bool has_avx2() noexcept;

/// Sixteen, and AVX2. Likewise.
[[nodiscard]] bool has_avx512() noexcept;

/// Of the versions of a kernel, the plain one first and null where this processor lacks what one needs: the last that it has.
template <class Version, std::size_t N>
[[nodiscard]] constexpr Version widest_of(const std::array<Version, N>& versions) noexcept {
    Version widest = versions.front();
    for (const Version version : versions) {
        widest = version != nullptr ? version : widest;
    }
    return widest;
}

/// The widest kernels that are taken, for people.
[[nodiscard]] inline const char* name_kernels() noexcept {
    return has_avx512() ? "AVX-512" : has_avx2() ? "AVX2" : "plain";
}

}  // namespace fulcrum
