#include "runtime/lua/wire/wire_limits.h"

#include "tests/unit/runtime/rig.h"

#include <string>

using namespace fulcrum::runtime::test;

TEST_CASE("wire: names of pictures") {
    for (const char* good : {"felt.png", "IMG_1234.JPG", "my felt.jpeg", "a.b.PNG"}) {
        CHECK(is_picture_name(good));
    }
    for (const char* bad : {"", "felt", "felt.gif", ".png", " a.png", "a/b.png", "a\\b.png",
                            "a\xC3\xA4.png", "c:felt.png"}) {
        CHECK_FALSE(is_picture_name(bad));
    }
    CHECK_FALSE(is_picture_name(std::string(kMaxNameBytes - 3, 'a') + ".png"));
}

TEST_CASE("wire: names and texts") {
    CHECK(is_name("apple_2-b"));
    CHECK_FALSE(is_name(""));
    CHECK_FALSE(is_name("-a"));
    CHECK_FALSE(is_name("Apple"));
    CHECK_FALSE(is_name("a/b"));
    CHECK_FALSE(is_name("a.b"));
    CHECK_FALSE(is_name(std::string_view("a\0b", 3)));
    CHECK_FALSE(is_name(std::string(kMaxNameBytes + 1, 'a')));
    CHECK(is_clean_utf8("caf\xC3\xA9 \xED\x95\x9C \xF0\x9F\x8D\x8E\n\t"));
    CHECK_FALSE(is_clean_utf8("\xC0\x80"));  // overlong
    CHECK_FALSE(is_clean_utf8("\xE0\x80\x80"));
    CHECK_FALSE(is_clean_utf8("\xED\xA0\x80"));      // surrogate
    CHECK_FALSE(is_clean_utf8("\xF4\x90\x80\x80"));  // beyond Unicode
    CHECK_FALSE(is_clean_utf8("\xE2\x82"));          // cut off
    CHECK_FALSE(is_clean_utf8("\xC2\x85"));          // C1 control
    CHECK_FALSE(is_clean_utf8(std::string_view("\0", 1)));
    CHECK_FALSE(is_clean_utf8("\x1B"));
    CHECK_FALSE(is_clean_utf8("\x7F"));
}
