// What moves each hand of a lesson: what was asked for, and what there is for the rest.
//
//   asked for      --hand once a hand, in the lesson's order; the first is always there
//   in a window    the mouse moves the first that has no device, W A S D the next
//   without        simulated hands; of the lesson's own test as many as it names
// A lesson says how many it can use. What is more is not opened, and so without force; with fewer it is played as far as it can be.
//
// Thread: load path.
#pragma once

#include "haptics/base/error.h"
#include "haptics/link/spoiled_arm.h"
#include "runtime/app/arm_kind.h"
#include "runtime/app/hid_hands.h"
#include "runtime/app/played_by.h"
#include "runtime/scene/description.h"

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace fulcrum::runtime {

class OwnArm;

/// `keys`: a pointer of its own that keys move; `none`: nobody is there.
enum class HandKind : std::uint8_t { scripted, mouse, replay, hid, link, keys, none };

/// Whether a hand keeps its own time, so that a lesson without a window has to go as fast as the clock on the wall. (A mouse without a
/// window is a simulated one.)
[[nodiscard]] constexpr bool keeps_time(HandKind kind) noexcept {
    return kind == HandKind::hid || kind == HandKind::link;
}

/// What moves a hand.
struct HandChoice {
    HandKind hand = HandKind::scripted;
    /// Scripted or at a desk: a Lua file, empty for the lesson's own test. Replay: a record.
    std::filesystem::path hand_file;
    HidChoice hid{};           ///< the device of HandKind::hid
    std::string hand_address;  ///< link: HOST:PORT of the arm
    std::string key_file;      ///< link: empty for the default place
    /// Link: an arm at this computer, which the run starts; then the address is found. Null: another's.
    const OwnArmKind* own_arm = nullptr;
    std::vector<std::string> arm_words;   ///< what its process is told besides
    std::shared_ptr<OwnArm> started_arm;  ///< that process, once it was met (arm_line.h)
    std::string arm_name;  ///< link: what the arm calls itself, model and serial, once it was met
    /// Scripted: the hand holds an arm at the other end of a link, on which things break by this seed.
    std::optional<std::uint64_t> spoil_seed;
    SpoiledModel spoil_model = SpoiledModel::desktop;  ///< which arm that is
};

/// Who is there for hands that nobody chose for.
enum class HandsThere : std::uint8_t {
    desk,       ///< a mouse and keys
    simulated,  ///< those of the lesson's own test
    all,        ///< all that the lesson has, those without a file at rest
    nobody,
};

/// Reads a word of --hand: FILE.lua, mouse, keys, hid, hid:PATH, haply, touch, fd, simulated, udp:HOST:PORT, wam:HOST, replay:FILE, none. Refuses what is not there.
[[nodiscard]] Expected<HandChoice> read_hand(const std::string& word, bool in_window,
                                             const std::string& key_file);

/// Refuses a mouse or keys that should move two hands.
[[nodiscard]] Expected<void> check_shared(const HandChoice& first,
                                          const std::vector<HandChoice>& more);

/// What the choices are to be decided by, besides the lesson.
struct HandsOrder {
    HandChoice first{};
    HandsThere there = HandsThere::nobody;
    PlayedBy by = PlayedBy::arm;
};

/// Fills `more` up to the lesson's hands, and takes out what it cannot use. Gives what somebody should know of that, a sentence each;
/// refuses a lesson that needs more hands than there are.
[[nodiscard]] Expected<std::vector<std::string>> settle_hands(const LessonDescription& lesson,
                                                              const HandsOrder& order,
                                                              std::vector<HandChoice>& more);

/// What a hand is moved by, as --hand says it: "mouse", "udp:desk:4701".
[[nodiscard]] std::string name_of(const HandChoice& choice);

}  // namespace fulcrum::runtime
