// What a rule holds for wrong in a free sentence, and what belongs there.
#pragma once

#include "dialogue/checking/reading.h"
#include "dialogue/english/error_code.h"

#include <cstddef>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace fulcrum::dialogue {

/// How certain a rule is of itself.
enum class Certainty : std::uint8_t {
    sure,   ///< the words alone show it
    asked,  ///< only a judge of whole sentences can tell: it has to find the corrected one better
};

/// One error that a rule proposes.
struct Proposal {
    ErrorCode code = ErrorCode::none;
    std::size_t begin = 0;  ///< bytes of the text, [begin, end); empty where something is missing
    std::size_t end = 0;
    std::string right;  ///< what belongs there; empty when nothing does
    Certainty certainty = Certainty::sure;
};

/// Collects what rules propose of one sentence.
class Proposals {
  public:
    explicit Proposals(const FreeSentence& sentence) : sentence_(&sentence) {}

    /// Word `i` should be `right`.
    void replace(int i, ErrorCode code, std::string_view right,
                 Certainty certainty = Certainty::sure) {
        replace(i, i + 1, code, right, certainty);
    }
    /// The words [first, last) should be `right`; empty: they go, with a space behind them.
    void replace(int first, int last, ErrorCode code, std::string_view right,
                 Certainty certainty = Certainty::sure);
    /// `missing` belongs before word `i`.
    void insert(int i, ErrorCode code, std::string_view missing,
                Certainty certainty = Certainty::sure);

    [[nodiscard]] std::vector<Proposal> take() { return std::move(list_); }

  private:
    const FreeSentence* sentence_;
    std::vector<Proposal> list_;
};

/// The rules, one a kind of error; each looks at the whole sentence.
/// more heavier, most heavy, heavyer, heavy than, heavier then, very heavier, as heavier as, is heaviest
void find_comparison_errors(const Lexicon& lexicon, const FreeSentence& sentence,
                            Proposals& proposals);
/// a apple, a information, the a, these rock, the Jupiter, is a hard; missing a or the
void find_article_errors(const FreeSentence& sentence, Proposals& proposals);
/// two moon, moones, informations, one of the planet, much moons
void find_number_errors(const Lexicon& lexicon, const FreeSentence& sentence, Proposals& proposals);
/// it have, the planets goes, there is two moons
void find_agreement_errors(const FreeSentence& sentence, Proposals& proposals);
/// does not likes, must to go, must is go, it be heavy, it not have, it turns himself
void find_verb_form_errors(const FreeSentence& sentence, Proposals& proposals);
/// made by metal, is make of, maked, a spaceship made of metal
void find_making_errors(const FreeSentence& sentence, Proposals& proposals);
/// feels hardly, feels like hard, a rock hard, why the rock is hard?
void find_order_errors(const FreeSentence& sentence, Proposals& proposals);
/// it heavy, is very heavy, the rock it is
void find_missing_words(const FreeSentence& sentence, Proposals& proposals);
/// near the pole the arm longer, pressing here easier, the apple and the egg the same, what the weight?
void find_verbless_clauses(const FreeSentence& sentence, Proposals& proposals);
/// is next of the bowl
void find_place_errors(const FreeSentence& sentence, Proposals& proposals);

}  // namespace fulcrum::dialogue
