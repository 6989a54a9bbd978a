// Why one of Force Dimension's arms may not be held now, and what people are told of it.
//
// Thread: any. Cost: a look at a short list.
// Source: causes 1 to 6: dhdc.h of SDK 3.17.5, the field of dhdGetStatus that says why the force is off.
#pragma once

#include <string>

namespace fulcrum::runtime {

enum class DhdTrouble {
    none = 0,
    button = 1,    ///< somebody pressed its force button
    too_fast = 2,  ///< the arm braked itself, for the handle went faster than it allows
    watchdog = 3,  ///< no order came for the time that it allows
    software = 4,  ///< a program switched it off
    usb = 5,
    deadman = 6,  ///< the handle was let go, of one that feels that
    other_cause,  ///< braked, or without force, for a reason that has no name here
    fault,        ///< the arm says that it has an error
    call_failed,  ///< the library could not reach it
    no_number,    ///< what it told is no pose
    not_initialised,
    another_arm,  ///< another one is plugged in where it was
};

/// Of the number that the arm gives for a force that is off.
[[nodiscard]] DhdTrouble trouble_of_cause(int cause) noexcept;
/// True where the port switches the force on again after a rest; the others need somebody.
[[nodiscard]] bool goes_by_itself(DhdTrouble trouble) noexcept;
/// A sentence: what is, and what to do.
[[nodiscard]] std::string words_of(DhdTrouble trouble);

}  // namespace fulcrum::runtime
