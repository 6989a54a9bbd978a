// While it lives, this thread treats denormal numbers as zero: a fading filter must not make a step
// a hundred times slower. On other processors than x86 and 64-bit Arm it does nothing.
//
// Thread: the one that makes it; the former mode comes back when it ends.
#pragma once

#if defined(__SSE2__)
#include <xmmintrin.h>
#define FULCRUM_FLUSHES_TO_ZERO 1
#elif defined(__aarch64__)
#define FULCRUM_FLUSHES_TO_ZERO 1
#endif

namespace fulcrum {

class ScopedFlushToZero {
  public:
    ScopedFlushToZero() noexcept : before_(read_mode()) { write_mode(before_ | kFlush); }
    ~ScopedFlushToZero() { write_mode(before_); }
    ScopedFlushToZero(const ScopedFlushToZero&) = delete;
    ScopedFlushToZero& operator=(const ScopedFlushToZero&) = delete;

  private:
#if defined(__SSE2__)
    using Mode = unsigned;
    static constexpr Mode kFlush = 0x8040;  // MXCSR: FTZ (results) and DAZ (operands)
    static Mode read_mode() noexcept {
        return _mm_getcsr();
    }
    static void write_mode(Mode mode) noexcept {
        _mm_setcsr(mode);
    }
#elif defined(__aarch64__)
    using Mode = unsigned long;
    static constexpr Mode kFlush = 1UL << 24U;  // FPCR: FZ (both)
    static Mode read_mode() noexcept {
        Mode mode = 0;
        asm volatile("mrs %0, fpcr" : "=r"(mode));
        return mode;
    }
    static void write_mode(Mode mode) noexcept {
        asm volatile("msr fpcr, %0" : : "r"(mode) : "memory");
    }
#else
    using Mode = unsigned;
    static constexpr Mode kFlush = 0;
    static Mode read_mode() noexcept {
        return 0;
    }
    static void write_mode(Mode /*mode*/) noexcept {}
#endif
    Mode before_;
};

}  // namespace fulcrum
