#include "runtime/text/terminal_text.h"

#include <catch2/catch.hpp>

#include <string>

namespace fulcrum::runtime {
namespace {

TEST_CASE("terminal text: whole characters, as many as fit") {
    CHECK(fit_to_columns("a ball", 20) == "a ball");
    CHECK(fit_to_columns("a ball", 6) == "a ball");
    CHECK(fit_to_columns("a ball", 5) == "a bal");
    CHECK(fit_to_columns("a ball", 0).empty());
    CHECK(fit_to_columns("a ball", -3).empty());
    // Two bytes a letter, one column; an accent of its own takes none.
    CHECK(fit_to_columns("\u00FC\u00FC\u00FC", 2) == "\u00FC\u00FC");
    CHECK(fit_to_columns("u\u0308u\u0308", 1) == "u\u0308");
    // Two columns each: a half is not drawn.
    CHECK(fit_to_columns("\uC9C0\uB81B\uB300", 5) == "\uC9C0\uB81B");
    CHECK(fit_to_columns("\U0001F30D!", 2) == "\U0001F30D");
}

TEST_CASE("terminal text: nothing that a terminal obeys comes through") {
    CHECK(fit_to_columns("red\033[31m\r\nline\a", 40) == "red[31m line");
    CHECK(fit_to_columns("\xFFz", 40) == "\uFFFDz");
}

}  // namespace
}  // namespace fulcrum::runtime
