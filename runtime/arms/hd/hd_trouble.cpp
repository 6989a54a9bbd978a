#include "runtime/arms/hd/hd_trouble.h"

#include "runtime/arms/hd/hd_library.h"

#include <array>
#include <cstdio>
#include <utility>

namespace fulcrum::runtime {
namespace {

constexpr double kCool_s = 5.0;
constexpr double kRest_s = 1.0;

constexpr std::array<std::pair<std::uint32_t, const char*>, 15> kHdWords{{
    {hd_no_error, "The arm is ready: its force comes softly."},
    {kHdNoNumber,
     "The arm tells places that cannot be, so it gives no force: where that stays, pull its plug "
     "out and in, and begin again."},
    {kHdStandsStill,
     "The arm's own loop stands still, so there is no force: where that stays, pull its plug out "
     "and in, and begin again."},
    {hd_needs_update, "The arm is finding its zero: leave the pen where it is."},
    {hd_needs_person,
     "Put the pen into its inkwell, the hole at the arm's front, and leave it there for a moment: "
     "until then the arm does not know where the pen is, and gives no force."},
    {hd_warm_motors, "The arm is warm: let it rest, and it goes on when it has cooled."},
    {hd_too_much_force,
     "The arm was to give more force than it can and has let go: it goes on by itself."},
    {hd_too_sudden_force,
     "The force changed faster than the arm bears and it has let go: it goes on by itself."},
    {hd_too_fast,
     "The hand was too fast, and the arm has let go: move slowly, and it goes on by itself."},
    {hd_force_error, "The arm could not give the force and has let go: it goes on by itself."},
    {hd_device_fault, "The arm reports a fault: pull its plug out and in, and begin again."},
    {hd_no_connection,
     "The arm does not answer: see that its cables are in; where that stays, begin again."},
    {hd_bad_configuration,
     "The arm's connection is in disorder, as after a program that was killed: pull its plug out "
     "and in, and begin again."},
    {hd_timer, "The arm's own clock is in disorder: where that stays, begin again."},
    {hd_no_licence, "OpenHaptics has no licence here: see that its licence is installed."},
}};

}  // namespace

double rest_after_s(std::uint32_t trouble) noexcept {
    return trouble == hd_warm_motors ? kCool_s : kRest_s;
}

std::string words_of_hd(std::uint32_t trouble) {
    for (const auto& [which, words] : kHdWords) {
        if (which == trouble) {
            return words;
        }
    }
    char line[160];
    (void)std::snprintf(line, sizeof line,
                        "The arm's library reports the error 0x%04x, so there is no force: where "
                        "that stays, begin again.",
                        static_cast<unsigned>(trouble));
    return line;
}

}  // namespace fulcrum::runtime
