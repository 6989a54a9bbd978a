// The versions of the kernels of distance_field_batch.h, and which is taken.
#include "haptics/base/prefetch.h"
#include "haptics/base/processor.h"
#include "haptics/voxel/ball_slack.h"
#include "haptics/voxel/distance_field_batch.h"

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>

#if defined(__GNUC__)
// Vectors wider than the processor's never leave this file.
#pragma GCC diagnostic ignored "-Wpsabi"
#endif
#if defined(__SSE2__)
#include <immintrin.h>
#endif

#define FULCRUM_KERNEL plain_kernels
#define FULCRUM_KERNEL_LANES 8
#include "haptics/voxel/distance_field_kernel.h"
#include "haptics/voxel/distance_field_slack_kernel.h"
#include "haptics/voxel/distance_field_slope_kernel.h"
#undef FULCRUM_KERNEL

#ifdef FULCRUM_WIDER_KERNELS
#pragma GCC push_options
#pragma GCC target("avx2")
#define FULCRUM_KERNEL avx2_kernels
#include "haptics/voxel/distance_field_kernel.h"
#include "haptics/voxel/distance_field_slack_kernel.h"
#include "haptics/voxel/distance_field_slope_kernel.h"
#undef FULCRUM_KERNEL
#undef FULCRUM_KERNEL_LANES
#pragma GCC target("avx512f,avx512dq,avx512vl,avx512bw")
#define FULCRUM_KERNEL avx512_kernels
#define FULCRUM_KERNEL_LANES 16
#include "haptics/voxel/distance_field_kernel.h"
#include "haptics/voxel/distance_field_slope_kernel.h"
#undef FULCRUM_KERNEL
#pragma GCC pop_options
#endif
#undef FULCRUM_KERNEL_LANES

namespace fulcrum {

namespace {

constexpr FieldKernels kPlain{"plain",
                              plain_kernels::sample,
                              plain_kernels::sum_leaves,
                              plain_kernels::collect,
                              plain_kernels::sum_slopes,
                              plain_kernels::find_slacks};
#ifdef FULCRUM_WIDER_KERNELS
constexpr FieldKernels kAvx2{"AVX2",
                             avx2_kernels::sample,
                             avx2_kernels::sum_leaves,
                             avx2_kernels::collect,
                             avx2_kernels::sum_slopes,
                             avx2_kernels::find_slacks};
// Balls come in eights.
constexpr FieldKernels kAvx512{"AVX-512",
                               avx512_kernels::sample,
                               avx512_kernels::sum_leaves,
                               avx512_kernels::collect,
                               avx512_kernels::sum_slopes,
                               avx2_kernels::find_slacks};
#endif

}  // namespace

std::array<const FieldKernels*, 3> all_field_kernels() noexcept {
#ifdef FULCRUM_WIDER_KERNELS
    return {&kPlain, has_avx2() ? &kAvx2 : nullptr, has_avx512() ? &kAvx512 : nullptr};
#else
    return {&kPlain, nullptr, nullptr};
#endif
}

const FieldKernels& best_field_kernels() noexcept {
    return *widest_of(all_field_kernels());
}

}  // namespace fulcrum
