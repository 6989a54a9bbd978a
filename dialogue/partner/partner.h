// Whatever talks back to the learner: praise, recast, prompt, rule, help, and the answer to what the learner asks.
//
//   Turn (what was said, understood and judged), the program's own words for it --take--> partner --poll--> what is said
// A partner chooses words and nothing else. Marks, what is right, how the question stands, what is felt again and what is kept are settled
// before it hears of a turn, so a lesson goes on alike whoever talks, and a partner that says nothing, too late or too much harms nothing.
//
// Thread: one, that of the lesson loop; what a partner does elsewhere is its own affair.  Cost: neither waits, but for a partner that was told to.
#pragma once

#include "dialogue/conversation/turn.h"

#include <optional>
#include <string>
#include <vector>

namespace fulcrum::dialogue {

/// What is said to a turn.
struct Reply {
    std::string
        text;  ///< shown and read aloud; *asterisks* around what is emphasised; empty: nothing
    std::vector<std::string> keys;  ///< of the catalogue, where it is made of those
    bool is_partners = false;  ///< not the program's own words: nobody has checked their English
};

/// The interface of all partners.
class Partner {
  public:
    Partner() = default;
    Partner(const Partner&) = delete;
    Partner& operator=(const Partner&) = delete;
    virtual ~Partner() = default;

    /// A turn, to be answered. `own`: what the program itself says to it (own_words.h).
    virtual void take(const Turn& turn, Reply own) = 0;
    /// The next reply that there is at this time of the run: one for each turn, in their order.
    [[nodiscard]] virtual std::optional<Reply> poll(double time_s) = 0;
    /// What somebody should know of it, a sentence, once; empty otherwise.
    [[nodiscard]] virtual std::string take_trouble() { return {}; }
};

}  // namespace fulcrum::dialogue
