// Counts allocations: the trap stands in no_allocation_test.cpp, and holds for the whole program of these tests.
#pragma once

#include <cstdint>

namespace fulcrum {

/// From here on this thread's calls of malloc, calloc, realloc and free are counted, anew.
void arm_allocation_trap() noexcept;
/// Ends that and tells how many there were. Under a sanitizer, which has an allocator of its own: 0.
[[nodiscard]] std::uint64_t disarm_allocation_trap() noexcept;

/// How many there are while `steps` runs.
template <class Steps>
[[nodiscard]] std::uint64_t count_allocations(Steps steps) {
    arm_allocation_trap();
    steps();
    return disarm_allocation_trap();
}

}  // namespace fulcrum
