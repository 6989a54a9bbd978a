#include "runtime/arms/maker_library.h"

#include "tests/support/scratch_folder.h"

#include <catch2/catch.hpp>

#include <array>

namespace fulcrum::runtime {
namespace {

MakerLibrary math_library() {
    return {.called = "the library of mathematics",
            .names = {"libno-such-name.so.1", "libm.so.6"},
            .path = {},
            .how_to_get = "install libc6",
            .before = {"libno-such-helper.so.1"}};
}

}  // namespace

TEST_CASE("maker library: the first name that is there counts, and its functions are those") {
    double (*cosine)(double) = nullptr;
    double (*none)(double) = nullptr;
    const std::array table{required("cos", cosine), if_there("fulcrum_has_no_such", none)};
    const auto found = open_maker_library(math_library(), table);
    REQUIRE(found);
    CHECK(*found == "libm.so.6");
    REQUIRE(cosine != nullptr);
    CHECK(cosine(0.0) == 1.0);
    CHECK(none == nullptr);
}

TEST_CASE("maker library: one sentence names the library, the function, and what to install") {
    double (*none)(double) = nullptr;
    const std::array table{required("fulcrum_has_no_such", none)};
    const auto lacking = open_maker_library(math_library(), table);
    REQUIRE_FALSE(lacking);
    CHECK(to_sentence(lacking.error()) ==
          "libm.so.6: the library of mathematics has no function fulcrum_has_no_such: it is too "
          "old, or another library; install libc6.");

    MakerLibrary library = math_library();
    library.names = {"libno-such-name.so.1", "libno-such-name.so.2"};
    const auto missing = open_maker_library(library, {});
    REQUIRE_FALSE(missing);
    CHECK(to_sentence(missing.error()) ==
          "the library of mathematics is not installed: there is no libno-such-name.so.1, "
          "libno-such-name.so.2; install libc6.");
}

TEST_CASE(
    "maker library: the user's own path counts alone, and a file that is none is told apart") {
    const ScratchFolder folder;
    MakerLibrary library = math_library();
    library.path = folder.file("libm.so");
    const auto missing = open_maker_library(library, {});
    REQUIRE_FALSE(missing);
    CHECK(missing.error().where == library.path);
    CHECK(missing.error().message == "no library lies there");

    folder.write("libm.so", "no library at all");
    const auto broken = open_maker_library(library, {});
    REQUIRE_FALSE(broken);
    CHECK(broken.error().message.starts_with("the library of mathematics does not load: "));
}

}  // namespace fulcrum::runtime
