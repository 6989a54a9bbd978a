#include "haptics/base/processor.h"

#include <catch2/catch.hpp>

#include <string>

using namespace fulcrum;

TEST_CASE("processor: of versions the last is taken that there is, the plain one at least") {
    const int plain = 0;
    const int wide = 0;
    const int wider = 0;
    const int* const none = nullptr;
    CHECK(widest_of(std::array{&plain, none, none}) == &plain);
    CHECK(widest_of(std::array{&plain, &wide, none}) == &wide);
    CHECK(widest_of(std::array{&plain, none, &wider}) == &wider);
    CHECK(widest_of(std::array{&plain, &wide, &wider}) == &wider);
}

TEST_CASE("processor: what has AVX-512 has AVX2, and the name is that of the most") {
    CHECK((has_avx2() || !has_avx512()));
    CHECK(std::string(name_kernels()) == (has_avx512() ? "AVX-512"
                                          : has_avx2() ? "AVX2"
                                                       : "plain"));
}
