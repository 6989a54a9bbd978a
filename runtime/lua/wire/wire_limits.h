// How large and how many may be what a lesson and the program tell each other, and which texts may be names.
//
// Thread: any. Cost: one pass over a text.
#pragma once

#include "runtime/scene/lesson_limits.h"

#include <cstdint>
#include <string_view>
#include <vector>

namespace fulcrum::runtime {

inline constexpr std::size_t kMaxSourceBytes = 512U << 10U;  ///< one Lua file
inline constexpr std::size_t kMaxMessageBytes = 2U << 20U;   ///< program -> lesson
inline constexpr std::size_t kMaxAnswerBytes = 512U << 10U;  ///< lesson -> program
inline constexpr std::size_t kMaxNameBytes = 48;    ///< ids, names of bodies, models, sounds, keys
inline constexpr std::size_t kMaxTextBytes = 1000;  ///< captions, prompts, templates, prints
inline constexpr std::size_t kMaxCommands = 256;    ///< in one reply
inline constexpr std::size_t kMaxEvents = 1024;     ///< in one frame
inline constexpr std::size_t kMaxQuestions = 200;
inline constexpr std::size_t kMaxListItems = 200;  ///< answers, list words, test lines, slots
inline constexpr double kMaxSpeed_m_per_s = 1e3;
/// What the program tells of the scene is within this, whatever unit it has: a tool at the edge of a scene is beyond what a lesson may say,
/// and a body that has fallen for long. What a lesson says back of it is within it too.
inline constexpr double kMaxTold = 1e9;
inline constexpr double kMaxLessonForce_N =
    100.0;  ///< of a lesson's force function; the gate limits far below
inline constexpr double kMaxLessonTorque_Nm = 10.0;                  ///< likewise, about the tool
inline constexpr double kMaxLessonStiffness_N_per_m = 5000.0;        ///< each entry of dF/dx
inline constexpr double kMaxLessonDamping_Ns_per_m = 100.0;          ///< each entry of dF/dv
inline constexpr double kMaxLessonTorqueStiffness_Nm_per_m = 500.0;  ///< each entry of dT/dx

/// Messages, one behind another.
using Bytes = std::vector<std::uint8_t>;

/// True when `text` is a name: 1 to kMaxNameBytes of a-z, 0-9, '_' and '-', the first a letter or
/// digit.
[[nodiscard]] bool is_name(std::string_view text);
/// True when `text` is the name of a picture beside a lesson: letters, digits, blanks, '_', '-' and '.', not first a '.' or a
/// blank, kMaxNameBytes at most, ending in .png, .jpg or .jpeg, in capitals or not.
[[nodiscard]] bool is_picture_name(std::string_view text);
/// True for a name followed by .lua: a hand's file beside the lesson, nothing that leads elsewhere.
[[nodiscard]] bool is_hand_file_name(std::string_view text);
/// True when `text` is UTF-8 without overlong forms or surrogates, and has no control characters
/// but newline and tab.
[[nodiscard]] bool is_clean_utf8(std::string_view text);

}  // namespace fulcrum::runtime
