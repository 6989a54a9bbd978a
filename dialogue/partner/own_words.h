// The program's own words for a turn, all of them the catalogue's: praise, recast, prompt, rule, help, and what was known of what the learner
// asked. What a partner says instead is partner.h's.
//
// Praise goes round in turn. A wrong meaning never tells the right one, and neither does help.
//
// Thread: one.  Cost: some lines of the catalogue.
// Source: recast, prompt (elicitation) after Lyster and Ranta 1997, "Corrective feedback and learner uptake", Studies in Second Language
//   Acquisition 19(1).
#pragma once

#include "dialogue/catalogue.h"
#include "dialogue/conversation/help.h"
#include "dialogue/partner/partner.h"

#include <cstddef>
#include <string>

namespace fulcrum::dialogue {

class OwnWords {
  public:
    /// The catalogue outlives them.
    explicit OwnWords(const Catalogue& catalogue) : catalogue_(&catalogue) {}

    /// Nothing for a turn that was none.
    [[nodiscard]] Reply say(const Turn& turn);

  private:
    [[nodiscard]] Reply make(std::string key, const CatalogueSlots& slots = {}) const;
    [[nodiscard]] Reply recast(const Mark& mark, const std::string& sentence) const;
    [[nodiscard]] Reply say_to_form(const Turn& turn);
    [[nodiscard]] Reply praise(const Mark& mark);
    [[nodiscard]] Reply say_rule(const Turn& turn, const std::string& sentence) const;
    [[nodiscard]] Reply say_what_follows(const Turn& turn) const;
    [[nodiscard]] Reply say_not_understood(const Turn& turn) const;
    [[nodiscard]] Reply say_wrong(const Turn& turn) const;
    [[nodiscard]] Reply tell(const Help& help) const;
    /// Good English for what was said, before the reply's own words; nothing where no error is seen.
    void show_good_english(const Turn& turn, Reply& reply) const;
    /// The same of the first error that stands alone, in words: no sentence for it was proven. False where none does.
    bool show_good_words(const Turn& turn, Reply& reply) const;
    void put_before(Reply& reply, const char* key, CatalogueSlots slots) const;

    const Catalogue* catalogue_;
    std::size_t praise_ = 0;  ///< next praise in turn
};

}  // namespace fulcrum::dialogue
