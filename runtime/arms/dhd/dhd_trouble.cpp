#include "runtime/arms/dhd/dhd_trouble.h"

#include <array>
#include <utility>

namespace fulcrum::runtime {
namespace {

using Told = std::pair<DhdTrouble, const char*>;
constexpr std::array kDhdWords{
    Told{DhdTrouble::none, "The arm is ready again: its force comes softly."},
    Told{DhdTrouble::button,
         "The force button at the arm is off: press it when the hand may feel something."},
    Told{DhdTrouble::too_fast,
         "The hand was too fast, and the arm has braked: move slowly, and it goes on by itself."},
    Told{DhdTrouble::watchdog,
         "The arm heard nothing for a moment and took its force away: it goes on by itself; where "
         "that comes often, end what else runs on this computer."},
    Told{DhdTrouble::software,
         "Another program has switched the arm's force off: end that program, and begin again."},
    Told{DhdTrouble::usb,
         "The arm has lost its connection and took its force away: see that its USB cable is in."},
    Told{DhdTrouble::deadman, "The handle was let go: hold it, and the arm goes on."},
    Told{DhdTrouble::other_cause,
         "The arm has braked and does not say why: let go, and press its force button."},
    Told{DhdTrouble::fault,
         "The arm reports a fault: let go, switch it off and on, and begin again."},
    Told{DhdTrouble::call_failed,
         "The arm does not answer: see that it is switched on and its USB cable is in; it goes on "
         "when it is back."},
    Told{DhdTrouble::no_number,
         "The arm tells places that cannot be, so it gives no force: where that stays, switch it "
         "off and on, and begin again."},
    Told{DhdTrouble::not_initialised,
         "The arm has forgotten where its zero is, as after it was switched off: end this, and "
         "begin again."},
    Told{DhdTrouble::another_arm,
         "Another arm is plugged in than the one that this began with: plug that in, or begin "
         "again."},
};

}  // namespace

DhdTrouble trouble_of_cause(int cause) noexcept {
    const bool has_name = cause >= static_cast<int>(DhdTrouble::button) &&
                          cause <= static_cast<int>(DhdTrouble::deadman);
    return has_name ? static_cast<DhdTrouble>(cause) : DhdTrouble::other_cause;
}

bool goes_by_itself(DhdTrouble trouble) noexcept {
    return trouble == DhdTrouble::too_fast || trouble == DhdTrouble::watchdog;
}

std::string words_of(DhdTrouble trouble) {
    for (const auto& [which, words] : kDhdWords) {
        if (which == trouble) {
            return words;
        }
    }
    return "The arm may not be held now.";
}

}  // namespace fulcrum::runtime
