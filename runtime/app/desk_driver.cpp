#include "runtime/app/desk_driver.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <cmath>
#include <cstring>
#include <fcntl.h>
#include <sys/ioctl.h>
#include <unistd.h>
#include <utility>

namespace fulcrum::runtime {
namespace {

constexpr double kLeavesEvery_s = 2.0;
constexpr double kNotchEvery_s = 0.1;

// As X11 calls them; others as they are.
std::string key_symbol(const std::string& key) {
    constexpr std::array<std::pair<const char*, const char*>, 8> kSymbols{{{"return", "Return"},
                                                                           {"tab", "Tab"},
                                                                           {"up", "Up"},
                                                                           {"down", "Down"},
                                                                           {"left", "Left"},
                                                                           {"right", "Right"},
                                                                           {"page_up", "Prior"},
                                                                           {"page_down", "Next"}}};
    const auto* const found =
        std::ranges::find_if(kSymbols, [&](const auto& symbol) { return key == symbol.first; });
    return found != kSymbols.end() ? found->second : key;
}

std::string describe_place(const Vector2& place_px) {
    return "mousemove " + std::to_string(std::lround(place_px.x())) + " " +
           std::to_string(std::lround(place_px.y())) + "\n";
}

}  // namespace

std::string describe_deed(const DeskDeed& deed, bool& down) {
    const WindowEvents& events = deed.events;
    std::string lines;
    for (const KeyPress& press : events.pressed) {
        if (!press.text.empty()) {
            lines += press.text == "\"" ? "type '\"'\n" : "type \"" + press.text + "\"\n";
        } else {
            lines += (deed.held.contains(press.key) ? "keydown " : "key ") + key_symbol(press.key) +
                     "\n";
        }
    }
    for (const std::string& key : events.released) {
        lines += "keyup " + key_symbol(key) + "\n";
    }
    if (events.wheel != 0.0) {
        lines += events.wheel > 0.0 ? "click 4\n" : "click 5\n";
    }
    if (events.button_down[0] != down) {
        down = !down;
        lines += down ? "mousedown 1\n" : "mouseup 1\n";
    }
    return lines;
}

Expected<std::unique_ptr<DeskDriver>> DeskDriver::open(const std::string& path) {
    const int file = ::open(path.c_str(), O_WRONLY | O_NONBLOCK | O_CLOEXEC);
    if (file < 0) {
        return fail(std::string("it cannot be written: ") + std::strerror(errno), path,
                    "make a pipe with mkfifo that xdotool reads");
    }
    return std::unique_ptr<DeskDriver>(new DeskDriver(file));
}

DeskDriver::~DeskDriver() {
    (void)::close(file_);
}

void DeskDriver::begin(LessonRun& run, PlayedBy by, std::uint64_t seed,
                       const PictureSize& picture) {
    by_ = by;
    acted_s_ = notched_s_ = left_s_ = 0.0;
    desk_ = std::make_unique<SimulatedDesk>(run, by, seed, picture);
}

// Whether what was written before is not read yet: the pointer then goes straight to where it is to be later.
bool DeskDriver::is_behind() const {
    int unread = 0;
    return !lines_.empty() || (::ioctl(file_, FIONREAD, &unread) == 0 && unread > 0);
}

void DeskDriver::click(const std::optional<Vector2>& place) {
    if (place && !down_) {
        lines_ += describe_place(*place) + "mousedown 1\n";
        down_ = true;  // let go a frame later
    }
}

Expected<void> DeskDriver::act(const LessonInput& input, double now_s, const FindSpot& find_spot) {
    if (!desk_) {
        return {};
    }
    auto deed = desk_->act(input, now_s, now_s - std::exchange(acted_s_, now_s));
    if (!deed) {
        return tl::unexpected(deed.error());
    }
    if (input.ended()) {
        if (now_s - left_s_ > kLeavesEvery_s) {
            left_s_ = now_s;
            click(find_spot(static_cast<int>(input.end_choices().size()) - 1));
        } else if (std::exchange(down_, false)) {
            lines_ += "mouseup 1\n";
        }
        write();
        return {};
    }
    // Who clicks a spot moves there first; the next frame moves back.
    if (deed->spot && !down_) {
        click(find_spot(*deed->spot));
        at_.clear();
    } else {
        // What a notch of the wheel did is seen before the next one.
        if (is_behind() || now_s - notched_s_ < kNotchEvery_s) {
            deed->events.wheel = 0.0;
        } else if (deed->events.wheel != 0.0) {
            notched_s_ = now_s;
        }
        std::string place = describe_place({deed->events.pointer_x_px, deed->events.pointer_y_px});
        const bool presses = deed->events.button_down[0] != down_;
        if (by_ != PlayedBy::keyboard && place != at_ && (presses || !is_behind())) {
            lines_ += place;
            at_ = std::move(place);
        }
        lines_ += describe_deed(*deed, down_);
    }
    write();
    return {};
}

// What a full pipe has no room for is written in a later frame.
void DeskDriver::write() {
    const ssize_t written = ::write(file_, lines_.data(), lines_.size());
    if (written > 0) {
        lines_.erase(0, static_cast<std::size_t>(written));
    }
}

}  // namespace fulcrum::runtime
