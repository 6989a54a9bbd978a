#include "haptics/base/flush_to_zero.h"

#include <catch2/catch.hpp>

using namespace fulcrum;

TEST_CASE("flush to zero: denormals vanish within the scope and live again after it") {
    volatile double small = 4e-308;
    CHECK(small * 0.5 != 0.0);
#ifdef FULCRUM_FLUSHES_TO_ZERO
    {
        const ScopedFlushToZero flush_to_zero;
        CHECK(small * 0.5 == 0.0);
    }
#endif
    CHECK(small * 0.5 != 0.0);
}
