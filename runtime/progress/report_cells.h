// How a report's values are written, in one place for the text and the CSV.
#pragma once

#include "runtime/progress/report.h"

#include <cstdint>
#include <string>

namespace fulcrum::runtime {

/// How times are shown and files begin.
struct ReportStyle {
    bool utc =
        false;  ///< times in UTC; otherwise in the computer's time zone. Both say their offset
    bool byte_order_mark =
        false;  ///< begin the CSV with one: spreadsheets then read Korean names rightly
};

/// "2026-03-02 10:15 +0900", in the computer's time zone or in UTC.
[[nodiscard]] std::string time_cell(std::int64_t utc_ms, const ReportStyle& style);

/// "no", "before", "now".
[[nodiscard]] const char* stuck_cell(Stuck stuck) noexcept;

/// "once", "4 times".
[[nodiscard]] std::string times(std::int64_t count);

/// An error as a teacher reads it: `left out "the" (4 times), "an" (once)`, `"most heavy" for "heaviest" (once)`, `"it" where no
/// word belongs (once)`, `word order: the verb too late, for "is the heaviest" (once)`. The most frequent examples stand there, the rest is counted.
[[nodiscard]] std::string plain_words(const FormErrorReport& error);

/// A point of grammar as a teacher reads it: `passive voice 3 (none in the last 5 answers)`, `article 1 (in the last answer)`.
[[nodiscard]] std::string plain_words(const GrammarPointReport& point);

/// `passive_voice 3`: a point and how often; for the CSV.
[[nodiscard]] std::string point_cell(const GrammarPointReport& point);

/// `passive_voice 5`: a point and how many answers it has gone well since; for the CSV.
[[nodiscard]] std::string since_cell(const GrammarPointReport& point);

/// "0.87".
[[nodiscard]] std::string confidence_cell(double confidence);

/// The four marks of a question's answers: `meaning 3 of 5, taught form 2 of 4, other form errors 1, confidence 0.87`, or `form not
/// judged` for the two in the middle where it never was.
[[nodiscard]] std::string marks_of(const QuestionReport& question);

/// `R:ADJ:FORM 2`: a code and how often; for the CSV.
[[nodiscard]] std::string error_cell(const FormErrorReport& error);

/// `"most heavy" -> "the heaviest"`; a missing word is `"" -> "the"`.
[[nodiscard]] std::string example_cell(const FormErrorReport& error);

}  // namespace fulcrum::runtime
