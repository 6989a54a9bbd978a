// While it lives, this thread treats denormal numbers as zero: a fading filter must not make a step
// a hundred times slower. On other processors than x86 it does nothing.
//
// Thread: the one that makes it; the former mode comes back when it ends.
#pragma once

#if defined(__SSE2__)
#include <xmmintrin.h>
#endif

namespace fulcrum {

class ScopedFlushToZero {
  public:
#if defined(__SSE2__)
    ScopedFlushToZero() noexcept : before_(_mm_getcsr()) {
        _mm_setcsr(before_ | kFlushAndZero);
    }
    ~ScopedFlushToZero() {
        _mm_setcsr(before_);
    }
#else
    ScopedFlushToZero() noexcept = default;
    ~ScopedFlushToZero() = default;
#endif
    ScopedFlushToZero(const ScopedFlushToZero&) = delete;
    ScopedFlushToZero& operator=(const ScopedFlushToZero&) = delete;

  private:
#if defined(__SSE2__)
    static constexpr unsigned kFlushAndZero = 0x8040;  // FTZ (results) and DAZ (operands)
    unsigned before_;
#endif
};

}  // namespace fulcrum
