#include "haptics/base/processor.h"
#include "haptics/voxel/distance_field_batch.h"

#include <catch2/catch.hpp>

using namespace fulcrum;

TEST_CASE("distance field kernels: the widest that the processor has are taken") {
    const auto all = all_field_kernels();
    REQUIRE(all[0] != nullptr);
    CHECK((all[1] != nullptr) == has_avx2());
    CHECK((all[2] != nullptr) == has_avx512());
    CHECK(best_field_kernels().name == name_kernels());
    CHECK(&best_field_kernels() == (has_avx512() ? all[2] : has_avx2() ? all[1] : all[0]));
}
