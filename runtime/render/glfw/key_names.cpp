#include "runtime/render/glfw/key_names.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include <array>
#include <utility>

namespace fulcrum::runtime {

namespace {

constexpr std::array<std::pair<int, const char*>, 34> kNames{{
    {GLFW_KEY_SPACE, "space"},
    {GLFW_KEY_ENTER, "return"},
    {GLFW_KEY_KP_ENTER, "return"},
    {GLFW_KEY_ESCAPE, "escape"},
    {GLFW_KEY_BACKSPACE, "backspace"},
    {GLFW_KEY_DELETE, "delete"},
    {GLFW_KEY_TAB, "tab"},
    {GLFW_KEY_LEFT, "left"},
    {GLFW_KEY_RIGHT, "right"},
    {GLFW_KEY_UP, "up"},
    {GLFW_KEY_DOWN, "down"},
    {GLFW_KEY_HOME, "home"},
    {GLFW_KEY_END, "end"},
    {GLFW_KEY_PAGE_UP, "page_up"},
    {GLFW_KEY_PAGE_DOWN, "page_down"},
    {GLFW_KEY_INSERT, "insert"},
    {GLFW_KEY_CAPS_LOCK, "caps_lock"},
    {GLFW_KEY_SCROLL_LOCK, "scroll_lock"},
    {GLFW_KEY_NUM_LOCK, "num_lock"},
    {GLFW_KEY_PRINT_SCREEN, "print_screen"},
    {GLFW_KEY_PAUSE, "pause"},
    {GLFW_KEY_LEFT_SHIFT, "shift"},
    {GLFW_KEY_RIGHT_SHIFT, "shift"},
    {GLFW_KEY_LEFT_CONTROL, "control"},
    {GLFW_KEY_RIGHT_CONTROL, "control"},
    {GLFW_KEY_LEFT_ALT, "alt"},
    {GLFW_KEY_RIGHT_ALT, "alt"},
    {GLFW_KEY_LEFT_SUPER, "super"},
    {GLFW_KEY_RIGHT_SUPER, "super"},
    {GLFW_KEY_MENU, "menu"},
    {GLFW_KEY_KP_ADD, "+"},
    {GLFW_KEY_KP_SUBTRACT, "-"},
    {GLFW_KEY_KP_MULTIPLY, "*"},
    {GLFW_KEY_KP_DIVIDE, "/"},
}};

}  // namespace

std::string key_name(int glfw_key, const char* layout_name) {
    for (const auto& [key, name] : kNames) {
        if (key == glfw_key) {
            return name;
        }
    }
    if (glfw_key >= GLFW_KEY_F1 && glfw_key <= GLFW_KEY_F25) {
        return "f" + std::to_string(glfw_key - GLFW_KEY_F1 + 1);
    }
    if (glfw_key >= GLFW_KEY_KP_0 && glfw_key <= GLFW_KEY_KP_9) {
        return std::to_string(glfw_key - GLFW_KEY_KP_0);
    }
    if (layout_name != nullptr && *layout_name != '\0') {
        return layout_name;
    }
    // Without a layout the key's place on an American keyboard is its name.
    if (glfw_key >= GLFW_KEY_A && glfw_key <= GLFW_KEY_Z) {
        return {static_cast<char>('a' + (glfw_key - GLFW_KEY_A))};
    }
    if (glfw_key >= GLFW_KEY_0 && glfw_key <= GLFW_KEY_9) {
        return {static_cast<char>('0' + (glfw_key - GLFW_KEY_0))};
    }
    return {};
}

}  // namespace fulcrum::runtime
