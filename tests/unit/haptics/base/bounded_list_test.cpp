#include "haptics/base/bounded_list.h"

#include <catch2/catch.hpp>

namespace fulcrum {
namespace {

TEST_CASE("bounded list: takes what it has room for, gives it back, and begins anew") {
    BoundedList<int> list(3);
    CHECK(list.count() == 0);
    CHECK(list.add(4));
    CHECK(list.add(5));
    CHECK(list.add(6));
    CHECK_FALSE(list.add(7));
    REQUIRE(list.all().size() == 3);
    CHECK(list.all()[1] == 5);
    CHECK(list.take_last() == 6);
    CHECK(list.count() == 2);
    list.set_count(9);
    CHECK(list.count() == 3);
    list.clear();
    CHECK(list.all().empty());
    CHECK(list.capacity() == 3);
    BoundedList<int> none(-1);
    CHECK_FALSE(none.add(1));
}

}  // namespace
}  // namespace fulcrum
