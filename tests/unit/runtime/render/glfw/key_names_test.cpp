#include "runtime/render/glfw/key_names.h"

#include "runtime/render/glfw/window.h"
#include "tests/unit/runtime/rig.h"

using namespace fulcrum::runtime::test;

// GLFW's numbers for keys are those of its documentation; its header stays in its folder.
TEST_CASE("keys: names as lessons know them") {
    CHECK(key_name(32, nullptr) == "space");
    CHECK(key_name(257, nullptr) == "return");
    CHECK(key_name(335, nullptr) == "return");
    CHECK(key_name(256, nullptr) == "escape");
    CHECK(key_name(263, nullptr) == "left");
    CHECK(key_name(290, nullptr) == "f1");
    CHECK(key_name(300, nullptr) == "f11");
    CHECK(key_name(325, nullptr) == "5");
    CHECK(key_name(65, "q") == "q");
    CHECK(key_name(65, nullptr) == "a");
    CHECK(key_name(49, nullptr) == "1");
    CHECK(key_name(59, "\xC3\xB6") == "\xC3\xB6");
    CHECK(key_name(-1, nullptr).empty());
}

TEST_CASE("window: without a display there is none, in one sentence") {
    unsetenv("DISPLAY");
    unsetenv("WAYLAND_DISPLAY");
    CHECK_FALSE(display_available());
    const auto window = Window::create("Fulcrum", 320, 200);
    REQUIRE_FALSE(window);
    const std::string sentence = to_sentence(window.error());
    CHECK(sentence.find("display") != std::string::npos);
    CHECK(sentence.back() == '.');
    // A display that is named and not there is the same.
    setenv("DISPLAY", ":9999", 1);
    CHECK_FALSE(display_available());
    CHECK_FALSE(Window::create("Fulcrum", 320, 200));
    unsetenv("DISPLAY");
}
