#include "runtime/arms/haply/haply_port.h"
#include "tests/support/refused.h"

#include <catch2/catch.hpp>

#include <cmath>

namespace fulcrum::runtime {

TEST_CASE("haply settings: what lies outside its range is refused") {
    check_refused(HaplySettings{},
                  {[](HaplySettings& s) { s.port = 0; },
                   [](HaplySettings& s) { s.device_id = "04 9D"; },
                   [](HaplySettings& s) { s.device_id = std::string(65, 'a'); },
                   {&HaplySettings::rate_Hz, 99.0},
                   {&HaplySettings::rate_Hz, 2001.0},
                   {&HaplySettings::rate_Hz, std::nan("")},
                   {&HaplySettings::rest_wait_s, 0.4},
                   {&HaplySettings::rest_wait_s, 61.0},
                   {&HaplySettings::rest_wait_s, std::nan("")},
                   [](HaplySettings& s) { s.centre_A = Vector3(0.0, 1.1, 0.0); },
                   [](HaplySettings& s) { s.centre_A = Vector3(0.0, 0.0, std::nan("")); }});
    HaplySettings bounds;
    bounds.device_id = "049D";
    bounds.rate_Hz = 100.0;
    bounds.rest_wait_s = 60.0;
    bounds.centre_A = Vector3(1.0, -1.0, 0.0);
    CHECK(validate(bounds));
}

}  // namespace fulcrum::runtime
