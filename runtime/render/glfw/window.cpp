#include "runtime/render/glfw/window.h"

#include "dialogue/unicode.h"
#include "runtime/render/gl/read_framebuffer.h"
#include "runtime/render/glfw/key_names.h"

#include <epoxy/gl.h>
// clang-format off
#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
// clang-format on

#include <algorithm>
#include <atomic>
#include <cstdlib>
#include <dlfcn.h>
#include <unistd.h>

namespace fulcrum::runtime {

namespace {

std::atomic<void (*)() noexcept> leave_lost_screen{nullptr};

// Xlib's, found by name: its header would be the only use of its package.
void watch_for_lost_screen() {
    using Handler = int (*)(void* display);
    const auto set_handler =
        reinterpret_cast<Handler (*)(Handler)>(::dlsym(RTLD_DEFAULT, "XSetIOErrorHandler"));
    if (set_handler != nullptr) {
        set_handler([](void* /*display*/) -> int {
            // Another thread that finds it too waits for the first one's end.
            static std::atomic_flag is_leaving;
            if (is_leaving.test_and_set()) {
                while (true) {
                    ::pause();
                }
            }
            if (const auto leave = leave_lost_screen.load(); leave != nullptr) {
                leave();
            }
            ::_exit(1);
        });
    }
}

bool names_display(const char* variable) {
    const char* value = std::getenv(variable);
    return value != nullptr && *value != '\0';
}

bool names_any_display() {
    return names_display("DISPLAY") || names_display("WAYLAND_DISPLAY");
}

/// What GLFW said last, as a clause; GLFW itself prints nothing.
std::string last_complaint() {
    const char* text = nullptr;
    glfwGetError(&text);
    return text != nullptr ? std::string(" (") + text + ")" : std::string();
}

/// Window's parts are where GLFW's user pointer points.
WindowEvents& events_of(GLFWwindow* window) {
    return *static_cast<WindowEvents*>(glfwGetWindowUserPointer(window));
}

void on_key(GLFWwindow* window, int key, int scancode, int action, int modifiers) {
    const bool printable = key >= GLFW_KEY_SPACE && key <= GLFW_KEY_WORLD_2;
    const std::string name = key_name(
        key, printable || key == GLFW_KEY_UNKNOWN ? glfwGetKeyName(key, scancode) : nullptr);
    if (name.empty()) {
        return;
    }
    const std::string by_place = key_name(key, nullptr);
    const std::string& place = by_place.empty() ? name : by_place;
    if (action == GLFW_RELEASE) {
        events_of(window).released.push_back(name);
        events_of(window).released_places.push_back(place);
        return;
    }
    KeyPress press;
    press.key = name;
    press.place = place;
    press.repeat = action == GLFW_REPEAT;
    press.shift = (modifiers & GLFW_MOD_SHIFT) != 0;
    press.control = (modifiers & GLFW_MOD_CONTROL) != 0;
    press.alt = (modifiers & GLFW_MOD_ALT) != 0;
    events_of(window).pressed.push_back(std::move(press));
}

void on_text(GLFWwindow* window, unsigned int code_point) {
    KeyPress typed;
    dialogue::append_utf8(typed.text, code_point);
    events_of(window).pressed.push_back(std::move(typed));
}

void on_pointer(GLFWwindow* window, double x, double y) {
    // GLFW speaks in screen coordinates; the picture is measured in the framebuffer's pixels.
    int window_width = 0;
    int window_height = 0;
    int width_px = 0;
    int height_px = 0;
    glfwGetWindowSize(window, &window_width, &window_height);
    glfwGetFramebufferSize(window, &width_px, &height_px);
    WindowEvents& events = events_of(window);
    events.pointer_x_px = x * width_px / std::max(window_width, 1);
    events.pointer_y_px = y * height_px / std::max(window_height, 1);
    events.pointer_moved = true;
}

void on_button(GLFWwindow* window, int button, int action, int /*modifiers*/) {
    WindowEvents& events = events_of(window);
    if (button < 0 || button >= static_cast<int>(events.button_down.size())) {
        return;
    }
    const auto index = static_cast<std::size_t>(button);
    events.button_down[index] = action == GLFW_PRESS;
    events.button_press[index] = events.button_press[index] || action == GLFW_PRESS;
    if (action == GLFW_PRESS) {
        events.press_x_px = events.pointer_x_px;
        events.press_y_px = events.pointer_y_px;
    }
}

void on_wheel(GLFWwindow* window, double /*sideways*/, double notches) {
    events_of(window).wheel += notches;
}

void on_resize(GLFWwindow* window, int /*width*/, int /*height*/) {
    events_of(window).resized = true;
}

void on_uncover(GLFWwindow* window) {
    events_of(window).uncovered = true;
}

void on_focus(GLFWwindow* window, int focused) {
    WindowEvents& events = events_of(window);
    events.focused = focused == GLFW_TRUE;
    events.lost_focus = events.lost_focus || !events.focused;
}

void forget_last_poll(WindowEvents& events) {
    events.pressed.clear();
    events.released.clear();
    events.released_places.clear();
    events.button_press = {};
    events.pointer_moved = false;
    events.wheel = 0.0;
    events.resized = false;
    events.uncovered = false;
    events.lost_focus = false;
}

void listen(GLFWwindow* window) {
    glfwSetKeyCallback(window, on_key);
    glfwSetCharCallback(window, on_text);
    glfwSetMouseButtonCallback(window, on_button);
    glfwSetCursorPosCallback(window, on_pointer);
    glfwSetScrollCallback(window, on_wheel);
    glfwSetFramebufferSizeCallback(window, on_resize);
    glfwSetWindowRefreshCallback(window, on_uncover);
    glfwSetWindowFocusCallback(window, on_focus);
}

void ask_for_context() {
    glfwDefaultWindowHints();
    glfwWindowHint(GLFW_CONTEXT_VERSION_MAJOR, 3);
    glfwWindowHint(GLFW_CONTEXT_VERSION_MINOR, 3);
    glfwWindowHint(GLFW_OPENGL_PROFILE, GLFW_OPENGL_CORE_PROFILE);
    glfwWindowHint(GLFW_OPENGL_FORWARD_COMPAT, GLFW_TRUE);
    // The renderer has its own samples, depth and stencil.
    glfwWindowHint(GLFW_DEPTH_BITS, 0);
    glfwWindowHint(GLFW_STENCIL_BITS, 0);
    glfwWindowHint(GLFW_SAMPLES, 0);
    glfwWindowHint(GLFW_SCALE_TO_MONITOR, GLFW_TRUE);
}

/// The monitor that holds most of the window.
GLFWmonitor* monitor_under(GLFWwindow* window) {
    int x = 0;
    int y = 0;
    int width = 0;
    int height = 0;
    glfwGetWindowPos(window, &x, &y);
    glfwGetWindowSize(window, &width, &height);
    int count = 0;
    GLFWmonitor** monitors = glfwGetMonitors(&count);
    GLFWmonitor* best = glfwGetPrimaryMonitor();
    int most = 0;
    for (int i = 0; i < count; ++i) {
        int left = 0;
        int top = 0;
        glfwGetMonitorPos(monitors[i], &left, &top);
        const GLFWvidmode* mode = glfwGetVideoMode(monitors[i]);
        if (mode == nullptr) {
            continue;
        }
        const int across = std::min(x + width, left + mode->width) - std::max(x, left);
        const int down = std::min(y + height, top + mode->height) - std::max(y, top);
        if (std::max(across, 0) * std::max(down, 0) > most) {
            most = across * down;
            best = monitors[i];
        }
    }
    return best;
}

}  // namespace

struct Window::Parts {
    GLFWwindow* window = nullptr;
    WindowEvents events;
    int x = 0;  ///< place and size before the whole screen was taken
    int y = 0;
    int width = 0;
    int height = 0;

    /// The screen's refresh is to be waited for once more: what is full screen may have forgotten it.
    std::atomic<bool> waits_anew{false};

    ~Parts() {
        if (window != nullptr) {
            glfwDestroyWindow(window);
        }
        glfwTerminate();
    }
};

std::string label_at(char place) {
    const char* const name = glfwGetKeyName(GLFW_KEY_A + (place - 'a'), 0);
    glfwGetError(nullptr);
    const std::string found = name != nullptr && *name != '\0' ? name : std::string(1, place);
    std::string label;
    for (std::size_t at = 0; at < found.size();) {
        const dialogue::Character letter = dialogue::character_at(found, at);
        dialogue::append_utf8(label, dialogue::capital_letter(letter.code));
        at += letter.bytes;
    }
    return label;
}

bool display_available() {
    if (!names_any_display()) {
        return false;
    }
    // It is not taken back: an X server whose last client has left begins anew, and refuses who comes back at once.
    const bool available = glfwInit() == GLFW_TRUE;
    glfwGetError(nullptr);
    return available;
}

Window::Window(std::unique_ptr<Parts> parts) : parts_(std::move(parts)) {}
Window::~Window() = default;

Expected<std::unique_ptr<Window>> Window::create(const std::string& title, int width, int height) {
    if (!names_any_display()) {
        return fail("there is no display to open a window on", {},
                    "log in at a screen or run with --headless");
    }
    if (glfwInit() != GLFW_TRUE) {
        return fail("no window can be opened" + last_complaint(), {}, "run with --headless");
    }
    auto parts = std::make_unique<Parts>();
    ask_for_context();
    parts->window =
        glfwCreateWindow(std::max(width, 1), std::max(height, 1), title.c_str(), nullptr, nullptr);
    if (parts->window == nullptr) {
        return fail("no window with OpenGL 3.3 can be opened" + last_complaint(), {},
                    "update the graphics driver or run with --headless");
    }
    watch_for_lost_screen();
    glfwMakeContextCurrent(parts->window);
    glfwSwapInterval(1);
    glfwSetWindowUserPointer(parts->window, &parts->events);
    listen(parts->window);
    // The pointer is somewhere already before it moves.
    double x = 0.0;
    double y = 0.0;
    glfwGetCursorPos(parts->window, &x, &y);
    on_pointer(parts->window, x, y);
    parts->events.focused = glfwGetWindowAttrib(parts->window, GLFW_FOCUSED) == GLFW_TRUE;
    return std::unique_ptr<Window>(new Window(std::move(parts)));
}

void Window::on_lost_screen(void (*leave)() noexcept) noexcept {
    leave_lost_screen = leave;
}

const WindowEvents& Window::poll() {
    forget_last_poll(parts_->events);
    glfwPollEvents();
    parts_->events.close = glfwWindowShouldClose(parts_->window) == GLFW_TRUE;
    return parts_->events;
}

const WindowEvents& Window::wait(double most_s) {
    forget_last_poll(parts_->events);
    glfwWaitEventsTimeout(std::max(most_s, 0.0));
    parts_->events.close = glfwWindowShouldClose(parts_->window) == GLFW_TRUE;
    return parts_->events;
}

void Window::take_context() {
    glfwMakeContextCurrent(parts_->window);
}

void Window::release_context() {
    glfwMakeContextCurrent(nullptr);
}

void Window::swap() {
    if (parts_->waits_anew.exchange(false)) {
        glfwSwapInterval(1);
    }
    glfwSwapBuffers(parts_->window);
}

Image Window::read_back(int width, int height) const {
    return gl::read_framebuffer(0, width, height);
}

void Window::set_fullscreen(bool wanted) {
    if (wanted == fullscreen()) {
        return;
    }
    GLFWwindow* window = parts_->window;
    GLFWmonitor* monitor = monitor_under(window);
    const GLFWvidmode* mode = monitor != nullptr ? glfwGetVideoMode(monitor) : nullptr;
    if (wanted && mode != nullptr) {
        glfwGetWindowPos(window, &parts_->x, &parts_->y);
        glfwGetWindowSize(window, &parts_->width, &parts_->height);
        glfwSetWindowMonitor(window, monitor, 0, 0, mode->width, mode->height, mode->refreshRate);
    } else if (!wanted) {
        glfwSetWindowMonitor(window, nullptr, parts_->x, parts_->y, parts_->width, parts_->height,
                             GLFW_DONT_CARE);
    }
    parts_->waits_anew = true;
}

bool Window::fullscreen() const {
    return glfwGetWindowMonitor(parts_->window) != nullptr;
}

int Window::width_px() const {
    int width = 0;
    int height = 0;
    glfwGetFramebufferSize(parts_->window, &width, &height);
    return width;
}

int Window::height_px() const {
    int width = 0;
    int height = 0;
    glfwGetFramebufferSize(parts_->window, &width, &height);
    return height;
}

}  // namespace fulcrum::runtime
