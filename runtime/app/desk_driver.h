// A simulated player of a lesson in a window (simulated_desk.h), whose hands are another program's: what would be done is written as xdotool
// reads it, line by line, and nothing counts but what then comes back from the screen.
//
//   mousemove X Y   mousedown 1   mouseup 1   click 4 (the wheel, away)   keydown a   keyup a   key Return   type " "
// The window's upper left corner is the screen's.
//
// Thread: that of the window. Cost: microseconds a frame; a reader that is slow holds nothing up, and is sent no place but the newest.
#pragma once

#include "runtime/app/simulated_desk.h"

#include <functional>
#include <memory>
#include <string>

namespace fulcrum::runtime {

class DeskDriver {
  public:
    /// Where a spot of the picture is, as LessonInput::pick has it; nothing where it is not shown.
    using FindSpot = std::function<std::optional<Vector2>(int spot)>;

    /// Writes to that file or pipe, which is there. One sentence where it cannot be written.
    [[nodiscard]] static Expected<std::unique_ptr<DeskDriver>> open(const std::string& path);
    DeskDriver(const DeskDriver&) = delete;
    DeskDriver& operator=(const DeskDriver&) = delete;
    ~DeskDriver();

    /// From now on plays this, which is there until the player leaves it.
    void begin(LessonRun& run, PlayedBy by, std::uint64_t seed, const PictureSize& picture);
    void leave() { desk_.reset(); }
    /// Does what is done at `now_s`, of who sees this; at the end the last choice is clicked, which leaves. An error is the lesson's own.
    [[nodiscard]] Expected<void> act(const LessonInput& input, double now_s,
                                     const FindSpot& find_spot);

  private:
    explicit DeskDriver(int file) : file_(file) {}
    void click(const std::optional<Vector2>& place);
    [[nodiscard]] bool is_behind() const;
    void write();

    int file_;
    std::unique_ptr<SimulatedDesk> desk_{};
    PlayedBy by_ = PlayedBy::mouse;
    std::string lines_{};
    std::string at_{};  // where the pointer was sent last
    bool down_ = false;
    double acted_s_ = 0.0;
    double notched_s_ = 0.0;
    double left_s_ = 0.0;  // when leaving was tried last
};

/// What xdotool reads of keys, wheel and left button; `down`: whether that was, and is then.
[[nodiscard]] std::string describe_deed(const DeskDeed& deed, bool& down);

}  // namespace fulcrum::runtime
