#include "runtime/app/felt_notes.h"

#include "runtime/app/installation.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdio>

namespace fulcrum::runtime {
namespace {

constexpr double kNamed_s = 1.0;   // less is a touch in passing
constexpr double kMostShut = 0.5;  // of the time in which a force was asked for

std::string seconds_text(double seconds) {
    std::array<char, 32> text{};
    std::snprintf(text.data(), text.size(), "%.1f s", seconds);
    return text.data();
}

}  // namespace

std::vector<Error> notes_of_felt(std::span<const FeltTime> hands, const std::string& where) {
    std::vector<Error> notes;
    for (std::size_t hand = 0; hand < hands.size(); ++hand) {
        const FeltTime& time = hands[hand];
        const bool is_unfelt = time.felt_s <= 0.0;
        if (time.asked_s < kNamed_s || (!is_unfelt && time.shut_s() <= kMostShut * time.asked_s)) {
            continue;
        }
        const std::string what =
            std::string(hand == 0 ? "the hand" : "the second hand") +
            " was asked to feel a force for " + seconds_text(time.asked_s) +
            (is_unfelt ? " and felt none"
                       : ", and for " + seconds_text(time.shut_s()) + " of them it was kept back");
        if (time.shut_s() <= kMostShut * time.asked_s) {
            notes.push_back({what + ": its device gives none of the kind that was asked for", where,
                             "ask for a force as well as a torque"});
        } else if (time.taken_s > time.waiting_s) {
            notes.push_back({what + ": a fault or a stop had taken it away", where,
                             "see what was told of that, and if the hand was too fast let it move "
                             "more slowly"});
        } else {
            notes.push_back(
                {what + ": one that is there from the start waits until the hand has rested for "
                        "half a second",
                 where, "let the hand rest, or let the force begin at nothing"});
        }
    }
    return notes;
}

void tell_felt(std::span<const FeltTime> hands, const std::string& where) {
    for (const Error& note : notes_of_felt(hands, where)) {
        say(to_sentence(note));
    }
}

bool was_felt(std::span<const FeltTime> hands) {
    return std::ranges::any_of(hands, [](const FeltTime& time) { return time.felt_s > 0.0; });
}

}  // namespace fulcrum::runtime
