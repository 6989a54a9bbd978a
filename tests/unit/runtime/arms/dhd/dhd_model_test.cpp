#include "runtime/arms/dhd/dhd_model.h"

#include <catch2/catch.hpp>

namespace fulcrum::runtime {

TEST_CASE("dhd model: each arm has its force and reach, left hands those of right ones") {
    CHECK(find_dhd_model(33).force_N == 12.0);
    CHECK(find_dhd_model(33).reach_m == 0.075);
    CHECK(find_dhd_model(36).reach_m == find_dhd_model(34).reach_m);
    CHECK(find_dhd_model(60).force_N == 8.0);
    CHECK(find_dhd_model(60).reach_m == 0.04);
    CHECK(find_dhd_model(60).step_m == Approx(63.5e-6));
    CHECK(find_dhd_model(63).reach_m == 0.15);
    CHECK(find_dhd_model(104).torque_Nm == 0.2);
    CHECK(find_dhd_model(109).reach_m == 0.1125);
}

TEST_CASE("dhd model: an arm that nobody knows is weaker than any other, and its reach unknown") {
    const DhdModel& unknown = find_dhd_model(999);
    CHECK(unknown.reach_m == 0.0);
    CHECK(unknown.torque_Nm == 0.0);
    for (const int type : {33, 34, 35, 36, 37, 60, 63, 104, 105, 108, 109}) {
        CHECK(find_dhd_model(type).type == type);
        CHECK(unknown.force_N < find_dhd_model(type).force_N);
    }
}

}  // namespace fulcrum::runtime
