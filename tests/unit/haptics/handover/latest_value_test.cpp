#include "haptics/handover/latest_value.h"

#include <catch2/catch.hpp>

using namespace fulcrum;

TEST_CASE("latest value: nothing to take before the first publish") {
    LatestValue<int> value;
    CHECK_FALSE(value.take());
    CHECK(value.value() == 0);
}

TEST_CASE("latest value: the newest of several is taken, once, and stays readable") {
    LatestValue<int> value;
    value.publish(1);
    value.publish(2);
    value.publish(3);
    CHECK(value.take());
    CHECK(value.value() == 3);
    CHECK_FALSE(value.take());
    CHECK(value.value() == 3);
    value.publish(4);
    CHECK(value.value() == 3);
    CHECK(value.take());
    CHECK(value.value() == 4);
}

TEST_CASE("latest value: publish and take in every order of three never lose the newest") {
    // Each bit of `order`: 1 publish, 0 take; all orders of twelve operations.
    for (unsigned order = 0; order < (1U << 12); ++order) {
        LatestValue<unsigned> value;
        unsigned published = 0;
        unsigned taken = 0;
        for (unsigned i = 0; i < 12; ++i) {
            if ((order >> i & 1U) != 0) {
                value.publish(++published);
            } else {
                REQUIRE(value.take() == (published != taken));
                taken = published;
                REQUIRE(value.value() == published);
            }
        }
    }
}
