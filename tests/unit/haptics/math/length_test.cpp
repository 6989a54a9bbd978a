#include "haptics/math/length.h"

#include "tests/support/bad_numbers.h"

#include <catch2/catch.hpp>

#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <new>
#include <random>

namespace fulcrum {
namespace {

TEST_CASE("length: a length is that of Pythagoras, and a direction has length 1") {
    CHECK(compute_length(Vector3(2.0, 3.0, 6.0)) == 7.0);
    CHECK(compute_length(Vector4(1.0, 1.0, 1.0, 1.0)) == 2.0);
    CHECK(compute_direction(Vector3(0.0, -3.0, 4.0)) == Vector3(0.0, -0.6, 0.8));
    std::mt19937 random(7);
    std::uniform_real_distribution<double> any(-1.0, 1.0);
    for (int i = 0; i < 1000; ++i) {
        const Vector3 v(any(random), any(random), any(random));
        REQUIRE(compute_length(v) == Approx(std::hypot(v.x(), v.y(), v.z())).epsilon(4e-16));
        REQUIRE((compute_length(v) * compute_direction(v) - v).norm() <= 4e-16 * v.norm());
    }
}

TEST_CASE("length: numbers whose squares leave the range of double keep all their digits") {
    const Vector3 v(2.0, 3.0, 6.0);
    for (const double scale : {1e-307, 1e-200, 1e-141, 1e-139, 1e139, 1e141, 1e200, 1e307}) {
        CAPTURE(scale);
        CHECK(compute_length(Vector3(scale * v)) == Approx(7.0 * scale).epsilon(4e-16));
        CHECK((compute_direction(Vector3(scale * v)) - v / 7.0).norm() <= 4e-16);
    }
    // Even the smallest number there is has a direction.
    const double least = std::numeric_limits<double>::denorm_min();
    CHECK(compute_length(Vector3(0.0, least, 0.0)) == least);
    CHECK(compute_direction(Vector3(0.0, -least, 0.0)) == Vector3(0.0, -1.0, 0.0));
}

TEST_CASE("length: nothing, infinity and what is no number") {
    CHECK(compute_length(Vector3(0.0, 0.0, 0.0)) == 0.0);
    CHECK(compute_direction(Vector3(0.0, 0.0, 0.0)) == Vector3(0.0, 0.0, 0.0));
    CHECK(compute_length(Vector3(1.0, -kInfinity, 0.0)) == kInfinity);
    CHECK(compute_direction(Vector3(1.0, -kInfinity, 0.0)) == Vector3(1.0, -kInfinity, 0.0));
    for (int i = 0; i < 3; ++i) {
        Vector3 v(1.0, kInfinity, 0.0);
        v[i] = kNan;
        CHECK(std::isnan(compute_length(v)));
        CHECK_FALSE(compute_direction(v).allFinite());
    }
}

TEST_CASE("length: the same bits wherever the vector lies") {
    // Every place that a double may have in 64 bytes; the largest number last, so that the order of summing counts.
    alignas(64) std::array<std::byte, 64 + sizeof(Vector3)> room{};
    std::mt19937 random(11);
    std::uniform_real_distribution<double> any(0.1, 1.0);
    for (int i = 0; i < 2000; ++i) {
        const Vector3 v(any(random), any(random), any(random));
        const double length = compute_length(v);
        const Vector3 direction = compute_direction(v);
        for (std::size_t at = 0; at < 64; at += alignof(Vector3)) {
            const auto* moved = new (&room[at]) Vector3(v);
            REQUIRE(std::bit_cast<std::uint64_t>(compute_length(*moved)) ==
                    std::bit_cast<std::uint64_t>(length));
            REQUIRE(compute_direction(*moved) == direction);
        }
    }
}

}  // namespace
}  // namespace fulcrum
