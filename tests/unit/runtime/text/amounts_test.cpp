#include "runtime/text/amounts.h"

#include "tests/unit/runtime/rig.h"

#include <string>
#include <utility>
#include <vector>

using namespace fulcrum::runtime::test;

TEST_CASE("amounts: bytes are given in the unit that people read") {
    CHECK(bytes_text(0) == "0 B");
    CHECK(bytes_text(999) == "999 B");
    CHECK(bytes_text(1500) == "1.5 kB");
    CHECK(bytes_text(61000000) == "61.0 MB");
}

TEST_CASE("amounts: lengths are told as people read them, without exponents") {
    const std::vector<std::pair<double, std::string>> lengths{
        {1.0e-5, "0.01 mm"}, {5.0e-5, "0.05 mm"},  {0.0005, "0.5 mm"},  {0.001, "1 mm"},
        {0.0125, "12.5 mm"}, {0.12, "120 mm"},     {0.0999, "99.9 mm"}, {0.99949, "999 mm"},
        {0.9996, "1 m"},     {1.234567, "1.23 m"}, {123.456, "123 m"},  {5000.0, "5000 m"}};
    for (const auto& [metres, text] : lengths) {
        CHECK(metres_text(metres) == text);
    }
}

TEST_CASE("amounts: numbers have the decimals that are asked for") {
    CHECK(number_text(1.005, 1) == "1.0");
    CHECK(number_text(-0.256, 2) == "-0.26");
}
