#include "haptics/voxel/distance_field_wide.h"

#include <catch2/catch.hpp>

using namespace fulcrum;

TEST_CASE("distance field wide: taken where the processor has it, and the plain one elsewhere") {
    const FieldKernels* const wide = find_wide_kernels();
    CHECK(all_field_kernels()[0] != nullptr);
    CHECK(all_field_kernels()[1] == wide);
    CHECK(&best_field_kernels() == (wide != nullptr ? wide : all_field_kernels()[0]));
}
