// What is said to the learner's turns in one play, and by whom: the plan's partner, with the program's own words beside it.
//
//   a turn --take--> own words --> partner --poll--> what is said, in the order of the turns     another partner's words --> a note for the record
//
// Another partner is another implementation of dialogue/partner/partner.h, chosen in `build`.
//
// Thread: lesson loop.  Cost: some lines of the catalogue a turn.
#pragma once

#include "dialogue/partner/own_words.h"
#include "dialogue/partner/partner.h"
#include "runtime/scene/plan.h"

#include <deque>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace fulcrum::runtime {

class Talk {
  public:
    struct Said {
        dialogue::Reply reply;
        bool was_asked = false;  ///< by the learner
    };

    /// The catalogue outlives it.
    [[nodiscard]] static Talk build(const Plan& plan, const dialogue::Catalogue& catalogue);

    /// Its words are the program's own.
    [[nodiscard]] bool is_own() const { return is_own_; }
    /// What the program says to it, whoever talks.
    [[nodiscard]] dialogue::Reply own(const dialogue::Turn& turn) { return own_.say(turn); }
    void take(const dialogue::Turn& turn);
    /// The next that there is at this time of the run.
    [[nodiscard]] std::optional<Said> poll(double time_s);
    /// What another partner said since the last call, for the record.
    [[nodiscard]] std::vector<std::string> take_notes() { return std::exchange(notes_, {}); }
    /// What somebody should know of the partner, a sentence each, once.
    [[nodiscard]] std::vector<std::string> take_troubles();

  private:
    explicit Talk(const dialogue::Catalogue& catalogue) : own_(catalogue) {}

    dialogue::OwnWords own_;
    std::unique_ptr<dialogue::Partner> partner_;
    bool is_own_ = true;
    std::deque<bool> were_asked_;  // turns that were not answered yet
    int said_ = 0;                 // to how many something was
    std::vector<std::string> notes_;
    std::vector<std::string> troubles_;
};

/// What another partner said to a turn, as it stands in a record, and back: "partner 3: Well done!"
[[nodiscard]] std::string partner_note(int turn, std::string_view text);
/// Nothing for another note.
[[nodiscard]] std::optional<PartnerWords> read_partner_note(std::string_view note);

}  // namespace fulcrum::runtime
