// A window on the desktop, with keyboard and mouse. The only place that knows GLFW.
//
// Thread: the main thread, as GLFW demands; what draws, `take_context`, `release_context`, `swap` and `read_back`, that which has the context.
// Cost: `swap` waits for the screen's refresh.
#pragma once

#include "haptics/base/error.h"
#include "runtime/render/image.h"

#include <array>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace fulcrum::runtime {

/// One press of a key (also each repetition while it is held), or a character that pressing keys has made.
struct KeyPress {
    /// "space" "return" "escape" "backspace" "delete" "tab" "left" "right" "up" "down" "home" "end"
    /// "page_up" "page_down" "insert" "f1" to "f25", "shift" "control" "alt" "super", or what
    /// stands on the key in small letters: "a", "ö", "1". Empty for text.
    std::string key;
    /// What was typed, UTF-8, keyboard layout applied; empty for a key. It comes after the key that makes it.
    std::string text{};
    /// What stands at the key's place on an American keyboard, whatever the layout: "w" of the key with ц. Empty: `key`.
    std::string place{};
    bool repeat = false;
    bool shift = false;
    bool control = false;
    bool alt = false;
};

/// What happened since the last poll, and how things stand.
struct WindowEvents {
    std::vector<KeyPress> pressed;             ///< keys and text, in the order of typing
    std::vector<std::string> released;         ///< names as in KeyPress
    std::vector<std::string> released_places;  ///< likewise, of the same keys
    double pointer_x_px = 0.0;                 ///< from the left of the framebuffer
    double pointer_y_px = 0.0;                 ///< from the top of the framebuffer
    bool pointer_moved = false;                ///< since the last poll
    std::array<bool, 3> button_down{};         ///< left, right, middle are held now
    std::array<bool, 3> button_press{};        ///< went down since the last poll
    double press_x_px = 0.0;  ///< where the pointer was when a button last went down
    double press_y_px = 0.0;  ///< likewise, from the top
    double wheel = 0.0;       ///< notches since the last poll, away from the user is +
    bool close = false;       ///< the user wants to leave
    bool resized = false;     ///< the framebuffer has another size
    bool uncovered = false;   ///< what was drawn may be lost: draw again
    bool focused = true;
    bool lost_focus = false;  ///< since the last poll: let go of everything that is held
};

/// What stands on the key at that place of an American keyboard, 'a' to 'z', in the user's layout, as on the key: "W", "Ц". For the thread of the
/// window that is there.
[[nodiscard]] std::string label_at(char place);

/// Whether a window can be opened here. Prints nothing.
[[nodiscard]] bool display_available();

/// A window with an OpenGL 3.3 core context, current in the thread that made it. One at a time.
class Window {
  public:
    /// Opens a window; sizes in screen coordinates, at least 1. One sentence when there is no
    /// display or no OpenGL 3.3.
    [[nodiscard]] static Expected<std::unique_ptr<Window>> create(const std::string& title,
                                                                  int width, int height);

    /// Called once in whichever thread finds that the screen is gone (the X server has ended); the program ends when it returns, for no
    /// call of Xlib's comes back from there. Null: it ends at once.
    static void on_lost_screen(void (*leave)() noexcept) noexcept;

    Window(const Window&) = delete;
    Window& operator=(const Window&) = delete;
    ~Window();

    /// Takes in what the user did; returns at once.
    [[nodiscard]] const WindowEvents& poll();

    /// The same after something happened, or after `most_s` seconds at the latest.
    [[nodiscard]] const WindowEvents& wait(double most_s);

    /// The calling thread draws from now on; the one that did must have released the context.
    void take_context();
    void release_context();

    /// Shows the frame that was drawn and waits for the screen's refresh.
    void swap();

    /// What has been drawn since the last `swap`, so large, rows from the top; waits for the drawing to end.
    [[nodiscard]] Image read_back(int width, int height) const;

    /// The whole screen, or the window as it was.
    void set_fullscreen(bool fullscreen);
    [[nodiscard]] bool fullscreen() const;

    [[nodiscard]] int width_px() const;   ///< of the framebuffer, 0 while minimised
    [[nodiscard]] int height_px() const;  ///< of the framebuffer, 0 while minimised

  private:
    struct Parts;
    explicit Window(std::unique_ptr<Parts> parts);
    std::unique_ptr<Parts> parts_;
};

}  // namespace fulcrum::runtime
