#include "runtime/app/arm_search.h"

#include "tests/unit/runtime/rig.h"

using namespace fulcrum::runtime::test;

namespace {

constexpr OwnArmKind kKind{"some", "some", "Some arm"};

}  // namespace

TEST_CASE(
    "arm search: one that is there is named as it names itself, with the word that takes it") {
    const DeviceEntry arm = read_arm_entry(kKind, {"named omega.3 4711", "at 40001"});
    CHECK(arm.usable);
    CHECK(devices_text({arm}).starts_with(
        "omega.3 4711: 3 axes, force along 3 axes.  --hand some\n"));
}

TEST_CASE("arm search: one that is not says what is missing") {
    const DeviceEntry refused =
        read_arm_entry(kKind, {"error there is no library; install the maker's SDK."});
    CHECK_FALSE(refused.usable);
    CHECK(devices_text({refused}).starts_with(
        "Some arm.\n    there is no library; install the maker's SDK.\n"));
    const DeviceEntry silent = read_arm_entry(kKind, {});
    CHECK_FALSE(silent.usable);
    CHECK(silent.missing == "its program says nothing");
}
