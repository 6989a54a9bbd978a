// What a checker of English found, counted by kind of error, and the sentences that it is tried on: those of the lessons' own
// templates, right or with one error, and a file of learners' sentences that a person has.
#pragma once

#include "dialogue/checking/checker.h"
#include "dialogue/marking/question.h"
#include "haptics/base/error.h"

#include <cstddef>
#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace fulcrum::bench {

/// Of one kind of error.
struct EnglishScore {
    int there = 0;        ///< errors of this kind in the sentences
    int found = 0;        ///< of these: marked where they stand, whatever the kind
    int named = 0;        ///< of these: marked with this kind
    int alarms = 0;       ///< marked with this kind
    int right_place = 0;  ///< of these: where something is wrong
};
using EnglishScores = std::map<std::string, EnglishScore>;

/// A sentence, and what is wrong in it.
struct ErroneousSentence {
    std::string text;
    std::string code;       ///< as ERRANT writes it
    std::size_t begin = 0;  ///< bytes of the error, [begin, end)
    std::size_t end = 0;
};

/// Sentences from the templates of a question: right ones, and such with exactly one error each.
struct TemplateSentences {
    std::vector<std::string> right;
    std::vector<ErroneousSentence> wrong;
};

/// Of the author's own sentences, or of those that follow from them by English alone (dialogue/template/variants.h).
enum class SentencesOf : std::uint8_t { author, english };

/// `n_walks` ways through each whole answer; the same seed gives the same sentences, each once.
[[nodiscard]] TemplateSentences make_template_sentences(const dialogue::Question& question,
                                                        SentencesOf whose, int n_walks,
                                                        unsigned seed);

/// One line of a learners' file.
struct LearnerLine {
    std::string said;
    std::string corrected;  ///< empty: not told
    std::vector<std::string>
        codes;           ///< of what is wrong, as ERRANT writes it, or the file's own name of it
    bool right = false;  ///< nothing is wrong in `said`
};

/// Reads a table with tabs and a line of column names: src, corrected and types; or rule, assert and source.
[[nodiscard]] Expected<std::vector<LearnerLine>> read_learner_lines(const std::string& file);

/// Counts what was found in one line: an error stands where `said` and `corrected` differ.
void add_line(const LearnerLine& line, const dialogue::CheckedText& checked, EnglishScores& scores);

}  // namespace fulcrum::bench
