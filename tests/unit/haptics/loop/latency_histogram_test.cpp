#include "haptics/loop/latency_histogram.h"

#include "tests/support/bad_numbers.h"

#include <catch2/catch.hpp>

using namespace fulcrum;

TEST_CASE("latency: quantiles of known counts lie in the right bin, an eighth wide at most") {
    LatencyHistogram histogram;
    CHECK(histogram.compute_quantile_s(0.5) == 0.0);
    for (int i = 1; i <= 1000; ++i) {
        histogram.add(i * 1e-6);
    }
    CHECK(histogram.count() == 1000);
    CHECK(histogram.max_s() == Approx(1000e-6).epsilon(1e-5));
    for (const double share : {0.01, 0.5, 0.9, 0.99, 1.0}) {
        const double quantile_s = histogram.compute_quantile_s(share);
        CHECK(quantile_s >= share * 1000e-6 * (1.0 - 1e-5));
        CHECK(quantile_s <= share * 1000e-6 * 1.126);
        CHECK(quantile_s <= histogram.max_s());
    }
}

TEST_CASE("latency: every nanosecond's bin contains it, borders too") {
    for (std::uint64_t ns = 1; ns < 100000; ns += ns < 100 ? 1 : 97) {
        LatencyHistogram histogram;
        histogram.add(static_cast<double>(ns) * 1e-9 + 1e-13);
        histogram.add(1.0);
        const double quantile_s = histogram.compute_quantile_s(0.5);
        REQUIRE(quantile_s >= static_cast<double>(ns) * 1e-9 * (1.0 - 1e-9));
        REQUIRE(quantile_s <= static_cast<double>(ns) * 1e-9 * 1.1251 + 1e-12);
    }
}

TEST_CASE("latency: times that are none count as zero, endless ones as very long") {
    LatencyHistogram histogram;
    histogram.add(-1.0);
    histogram.add(kNan);
    CHECK(histogram.max_s() == 0.0);
    CHECK(histogram.compute_quantile_s(1.0) == 0.0);
    histogram.add(kInfinity);
    CHECK(histogram.count() == 3);
    CHECK(histogram.max_s() > 1e9);
}
