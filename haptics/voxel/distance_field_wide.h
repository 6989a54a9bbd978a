// The kernels of distance_field_batch.h for processors with AVX-512.
//
// Thread: any. Cost: asks the processor's kind.
#pragma once

#include "haptics/voxel/distance_field_batch.h"

namespace fulcrum {

/// Null where the processor has none of it, or the compiler could not build them.
[[nodiscard]] const FieldKernels* find_wide_kernels() noexcept;

}  // namespace fulcrum
