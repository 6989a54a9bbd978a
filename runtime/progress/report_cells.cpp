#include "runtime/progress/report_cells.h"

#include <algorithm>
#include <array>
#include <cstdio>
#include <ctime>

namespace fulcrum::runtime {

std::string time_cell(std::int64_t utc_ms, const ReportStyle& style) {
    const std::int64_t utc_s = utc_ms >= 0 ? utc_ms / 1000 : (utc_ms - 999) / 1000;
    const auto time = static_cast<std::time_t>(utc_s);
    std::tm parts{};  // any number of milliseconds has a year that fits
    style.utc ? gmtime_r(&time, &parts) : localtime_r(&time, &parts);
    std::array<char, 40> text{};
    const std::size_t size = std::strftime(text.data(), text.size(), "%Y-%m-%d %H:%M %z", &parts);
    return {text.data(), size};
}

const char* stuck_cell(Stuck stuck) noexcept {
    switch (stuck) {
        case Stuck::now:
            return "now";
        case Stuck::before:
            return "before";
        case Stuck::no:
            break;
    }
    return "no";
}

std::string times(std::int64_t count) {
    return count == 1 ? "once" : std::to_string(count) + " times";
}

std::string plain_words(const FormErrorReport& error) {
    constexpr std::size_t kMostExamples = 3;
    const std::size_t shown = std::min(kMostExamples, error.examples.size());
    std::string text = error.code == "R:WO" ? "word order: " : "";
    std::int64_t rest = error.count;
    for (std::size_t i = 0; i < shown; ++i) {
        const FormExample& example = error.examples[i];
        const std::string said = "\"" + example.span + "\"";
        const std::string right = "\"" + example.correction + "\"";
        text += i == 0 ? "" : ", ";
        if (error.code == "R:WO" && example.span.empty()) {
            text.append("the verb too late, for ").append(right);
        } else if (example.span.empty()) {
            text.append("left out ").append(right);
        } else if (example.correction.empty()) {
            text.append(said).append(" where no word belongs");
        } else {
            text.append(said).append(" for ").append(right);
        }
        text.append(" (").append(times(example.count)).append(")");
        rest -= example.count;
    }
    return text + (rest > 0 ? ", and others (" + times(rest) + ")" : "");
}

std::string plain_words(const GrammarPointReport& point) {
    std::string name = point.point == "wording" ? "order of words" : point.point;
    std::replace(name.begin(), name.end(), '_', ' ');
    const std::string since =
        point.answers_since == 0 ? "in the last answer"
        : point.answers_since == 1
            ? "none in the last answer"
            : "none in the last " + std::to_string(point.answers_since) + " answers";
    return name + ' ' + std::to_string(point.count) + " (" + since + ")";
}

std::string confidence_cell(double confidence) {
    std::array<char, 24> text{};
    std::snprintf(text.data(), text.size(), "%.2f", confidence);
    return text.data();
}

std::string marks_of(const QuestionReport& question) {
    const auto of = [](std::int64_t n, std::int64_t all) {
        return std::to_string(n) + " of " + std::to_string(all);
    };
    std::string text = "meaning " + of(question.meaning_right, question.attempts);
    if (question.target_judged == 0 && question.other_form_errors == 0) {
        text += ", form not judged";
    } else {
        text += ", taught form " + of(question.target_right, question.target_judged) +
                ", other form errors " + std::to_string(question.other_form_errors);
    }
    return text + ", confidence " + confidence_cell(question.confidence);
}

std::string point_cell(const GrammarPointReport& point) {
    return point.point + ' ' + std::to_string(point.count);
}

std::string since_cell(const GrammarPointReport& point) {
    return point.point + ' ' + std::to_string(point.answers_since);
}

std::string error_cell(const FormErrorReport& error) {
    return error.code + " " + std::to_string(error.count);
}

std::string example_cell(const FormErrorReport& error) {
    return '"' + error.span + "\" -> \"" + error.correction + '"';
}

}  // namespace fulcrum::runtime
