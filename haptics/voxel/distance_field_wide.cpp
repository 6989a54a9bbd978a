#include "haptics/voxel/distance_field_wide.h"

#include "haptics/base/prefetch.h"

#include <array>
#include <cstddef>
#include <cstdint>

#if defined(__GNUC__) && !defined(__clang__) && defined(__x86_64__)

#include <immintrin.h>

#pragma GCC diagnostic ignored "-Wpsabi"
#pragma GCC push_options
#pragma GCC target("avx512f,avx512dq,avx512vl,avx512bw")
#define FULCRUM_KERNEL wide_kernels
#define FULCRUM_KERNEL_LANES 16
#include "haptics/voxel/distance_field_kernel.h"
#include "haptics/voxel/distance_field_slope_kernel.h"
#undef FULCRUM_KERNEL
#undef FULCRUM_KERNEL_LANES
#pragma GCC pop_options

namespace fulcrum {

namespace {

constexpr FieldKernels kWide{"16 lanes, AVX-512", wide_kernels::sample, wide_kernels::sum_leaves,
                             wide_kernels::collect, wide_kernels::sum_slopes};

}  // namespace

const FieldKernels* find_wide_kernels() noexcept {
    const bool has_all =
        __builtin_cpu_supports("avx512f") != 0 && __builtin_cpu_supports("avx512dq") != 0 &&
        __builtin_cpu_supports("avx512vl") != 0 && __builtin_cpu_supports("avx512bw") != 0;
    return has_all ? &kWide : nullptr;
}

}  // namespace fulcrum

#else

namespace fulcrum {

const FieldKernels* find_wide_kernels() noexcept {
    return nullptr;
}

}  // namespace fulcrum

#endif
