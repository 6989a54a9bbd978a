#include "haptics/tool/seen_samples.h"

#include "tests/support/wander.h"

#include <catch2/catch.hpp>

#include <algorithm>
#include <vector>

using namespace fulcrum;

namespace {

constexpr std::size_t kUnits = 3;

std::vector<float> see(SeenSamples& seen, unsigned seed) {
    Random random(seed);
    std::vector<float> all;
    seen.clear();
    for (std::size_t unit = 0; unit < kUnits; ++unit) {
        float* const to = seen.add_unit();
        for (std::size_t i = 0; i < kLeafPoints; ++i) {
            to[i] = static_cast<float>(random.uniform());
            all.push_back(to[i]);
        }
    }
    return all;
}

}  // namespace

TEST_CASE("seen samples: a part's F is the least of its samples, or its only one") {
    SeenSamples seen;
    seen.reserve(kUnits);
    CHECK(seen.n_most_units() == kUnits);
    const std::vector<float> all = see(seen, 1);
    CHECK(seen.n_units() == kUnits);
    for (const std::size_t n_parts : {128U, 32U, 8U, 2U, 1U}) {
        seen.split(n_parts);
        CHECK(seen.n_parts_a_sample() == std::max<std::size_t>(n_parts / kLeafPoints, 1));
        std::size_t n_touch = 0;
        for (std::size_t unit = 0; unit < kUnits; ++unit) {
            for (std::size_t part = 0; part < n_parts; ++part) {
                // Shares of the unit's samples, at least one.
                const std::size_t first = kLeafPoints * unit + part * kLeafPoints / n_parts;
                const std::size_t n = std::max<std::size_t>(kLeafPoints / n_parts, 1);
                const auto begin = all.begin() + static_cast<std::ptrdiff_t>(first);
                const float least =
                    *std::min_element(begin, begin + static_cast<std::ptrdiff_t>(n));
                CHECK(seen.least(unit, part) == least);
                n_touch += least < 0.0F ? 1 : 0;
            }
        }
        CHECK(seen.count_touching() * seen.n_parts_a_sample() == n_touch);
    }
}

TEST_CASE("seen samples: after clearing, nothing of what was seen is left") {
    SeenSamples seen;
    seen.reserve(kUnits);
    see(seen, 1);
    seen.split(1);
    const std::vector<float> all = see(seen, 2);
    seen.split(kLeafPoints);
    CHECK(seen.n_units() == kUnits);
    for (std::size_t part = 0; part < kLeafPoints; ++part) {
        CHECK(seen.least(1, part) == all[kLeafPoints + part]);
    }
    seen.clear();
    seen.split(1);
    CHECK(seen.n_units() == 0);
    CHECK(seen.count_touching() == 0);
}
