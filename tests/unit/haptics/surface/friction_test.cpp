#include "haptics/surface/friction.h"

#include <catch2/catch.hpp>

#include <limits>

namespace fulcrum {
namespace {

TEST_CASE("friction: settings out of range are refused, and a static part below the dynamic one") {
    CHECK(validate(FrictionSettings{}));
    CHECK(validate(FrictionSettings{0.6, 0.4, 2.0}));
    CHECK(validate(FrictionSettings{5.0, 5.0, 100.0}));
    CHECK_FALSE(validate(FrictionSettings{0.3, 0.4, 0.0}));
    CHECK_FALSE(validate(FrictionSettings{5.1, 0.4, 0.0}));
    CHECK_FALSE(validate(FrictionSettings{0.5, -0.1, 0.0}));
    CHECK_FALSE(validate(FrictionSettings{0.5, 0.1, 101.0}));
    CHECK_FALSE(validate(FrictionSettings{0.5, 0.1, -1.0}));
    CHECK_FALSE(validate(FrictionSettings{0.5, std::numeric_limits<double>::quiet_NaN(), 0.0}));
}

TEST_CASE("friction: a surface has some as soon as one of its parts is there") {
    CHECK_FALSE(FrictionSettings{}.any());
    CHECK(FrictionSettings{0.1, 0.0, 0.0}.any());
    CHECK(FrictionSettings{0.0, 0.0, 0.1}.any());
}

}  // namespace
}  // namespace fulcrum
