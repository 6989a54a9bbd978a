// What goes in and out of a run in one frame of its lesson, besides what hands and effects tell.
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace fulcrum::runtime {

/// What came in since the last frame besides the hand.
struct FrameInput {
    double time_s = 0.0;
    double paused_s = 0.0;  ///< of it the lesson stood still
    std::vector<std::string> keys;
    std::optional<std::string> typed;
    double wheel = 0.0;  ///< notches, away from the user is +
};

/// What a frame asks of the driver.
struct FrameReport {
    std::vector<std::string> sounds;
    std::vector<std::string> printed;
    std::vector<std::string> said;
    std::vector<std::string> spoken;  ///< aloud, by who has a voice
};

}  // namespace fulcrum::runtime
