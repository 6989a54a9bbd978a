#include "haptics/base/processor.h"

namespace fulcrum {

bool has_avx2() noexcept {
#ifdef FULCRUM_WIDER_KERNELS
    return __builtin_cpu_supports("avx2") != 0;
#else
    return false;
#endif
}

bool has_avx512() noexcept {
#ifdef FULCRUM_WIDER_KERNELS
    return has_avx2() && __builtin_cpu_supports("avx512f") != 0 &&
           __builtin_cpu_supports("avx512dq") != 0 && __builtin_cpu_supports("avx512vl") != 0 &&
           __builtin_cpu_supports("avx512bw") != 0;
#else
    return false;
#endif
}

}  // namespace fulcrum
