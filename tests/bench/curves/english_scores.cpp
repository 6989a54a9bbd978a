#include "tests/bench/curves/english_scores.h"

#include "dialogue/english/letters.h"
#include "dialogue/template/sentences.h"
#include "dialogue/template/tokens.h"

#include <algorithm>
#include <array>
#include <fstream>
#include <iterator>
#include <random>
#include <set>
#include <utility>

namespace fulcrum::bench {
namespace {

using namespace fulcrum::dialogue;

/// A sentence as a pupil writes it, and its only error; without a code when it has none or several.
struct Written {
    ErroneousSentence sentence;
    int errors = 0;
};

Written write_down(const Sample& sample) {
    Written written;
    std::string& text = written.sentence.text;
    for (const Piece& piece : sample.pieces) {
        const bool wrong = piece.code != ErrorCode::none;
        // What is right is shown with its capitals: "Jupiter".
        const bool same = lower_case(piece.right) == piece.said;
        const std::string& words = !wrong && same ? piece.right : piece.said;
        if (!text.empty() && !words.empty()) {
            text += ' ';
        }
        if (wrong) {
            ++written.errors;
            written.sentence.code = errant_code(piece.code);
            written.sentence.begin = text.size();
            written.sentence.end = text.size() + words.size();
        }
        text += words;
    }
    text = sentence_case(text) + (text.starts_with("how") || text.starts_with("what") ? "?" : ".");
    return written;
}

/// Blanks that a corpus of tokens has before its commas and apostrophes go.
std::string without_gaps(std::string_view text) {
    std::string joined;
    for (const char letter : text) {
        const bool closes = std::string_view(",.;:?!'").find(letter) != std::string_view::npos;
        if ((closes || letter == ' ') && joined.ends_with(' ')) {
            joined.pop_back();
        }
        if (letter != '"') {
            joined.push_back(letter);
        }
    }
    // "do n't", "it s", "I m": what a corpus parted.
    constexpr std::array<std::pair<std::string_view, std::string_view>, 13> kParted = {
        {{" n't", "n't"},
         {" nt ", "n't "},
         {"it s ", "it's "},
         {"It s ", "It's "},
         {"that s ", "that's "},
         {"That s ", "That's "},
         {"I m ", "I'm "},
         {"i m ", "i'm "},
         {"I ve ", "I've "},
         {"i ve ", "i've "},
         {"there s ", "there's "},
         {" re ", "'re "},
         {" - ", "-"}}};
    for (const auto& [apart, together] : kParted) {
        for (std::size_t at = 0; (at = joined.find(apart, at)) != std::string::npos;) {
            joined.replace(at, apart.size(), together);
            at += together.size();
        }
    }
    return joined;
}

std::vector<std::string> split(std::string_view text, char separator) {
    std::vector<std::string> parts;
    text.remove_suffix(text.ends_with('\r') ? 1 : 0);
    while (true) {
        const std::size_t end = std::min(text.find(separator), text.size());
        parts.emplace_back(text.substr(0, end));
        if (end == text.size()) {
            return parts;
        }
        text.remove_prefix(end + 1);
    }
}

/// For each word of `said`, and the end: is it, or what stands before it, other than in `corrected`? By the longest common
/// part of both.
std::vector<bool> changed_words(const std::vector<Token>& said,
                                const std::vector<std::string>& corrected) {
    const std::size_t n = said.size();
    const std::size_t m = corrected.size();
    std::vector<std::vector<int>> common(n + 1, std::vector<int>(m + 1, 0));
    for (std::size_t i = n; i-- > 0;) {
        for (std::size_t j = m; j-- > 0;) {
            common[i][j] = said[i].text == corrected[j]
                               ? common[i + 1][j + 1] + 1
                               : std::max(common[i + 1][j], common[i][j + 1]);
        }
    }
    std::vector<bool> changed(n + 1, false);
    std::size_t i = 0;
    std::size_t j = 0;
    while (i < n || j < m) {
        if (i < n && j < m && said[i].text == corrected[j]) {
            ++i;
            ++j;
            continue;
        }
        changed[i] = true;
        if (j < m && (i == n || common[i][j + 1] >= common[i + 1][j])) {
            ++j;
        } else {
            ++i;
        }
    }
    return changed;
}

}  // namespace

TemplateSentences make_template_sentences(const Question& question, SentencesOf whose, int n_walks,
                                          unsigned seed) {
    TemplateSentences sentences;
    std::mt19937 random(seed);
    std::set<std::string> seen;
    const auto choose = [&](std::size_t n) { return static_cast<std::size_t>(random()) % n; };
    const TemplateSet& set = *question.templates;
    for (std::size_t number = 0; number < set.graphs.size(); ++number) {
        const Graph& graph = set.graphs[number];
        const bool is_own = std::cmp_less(number, set.answers);
        if (is_own != (whose == SentencesOf::author) || !graph.whole_sentence || graph.nearly ||
            graph.turned_round || graph.short_answer) {
            continue;
        }
        for (int i = 0; i < n_walks; ++i) {
            Written written =
                write_down(walk_plainly(set, static_cast<int>(number), i % 4 != 0, choose));
            if (written.errors > 1 || !seen.insert(written.sentence.text).second) {
                continue;
            }
            if (written.errors == 0) {
                sentences.right.push_back(std::move(written.sentence.text));
            } else {
                sentences.wrong.push_back(std::move(written.sentence));
            }
        }
    }
    return sentences;
}

fulcrum::Expected<std::vector<LearnerLine>> read_learner_lines(const std::string& file) {
    std::ifstream in(file);
    std::string line;
    if (!std::getline(in, line)) {
        return fulcrum::fail("the learners' sentences cannot be read", file,
                             "give a table with tabs");
    }
    const std::vector<std::string> names = split(line, '\t');
    const auto column = [&](std::string_view name) {
        return static_cast<std::size_t>(std::find(names.begin(), names.end(), name) -
                                        names.begin());
    };
    const bool with_types = column("src") < names.size() && column("corrected") < names.size() &&
                            column("types") < names.size();
    const bool with_rules = column("rule") < names.size() && column("assert") < names.size() &&
                            column("source") < names.size();
    if (!with_types && !with_rules) {
        return fulcrum::fail(
            "the table has neither the columns src, corrected and types nor rule, assert and "
            "source",
            file, "name them in its first line");
    }
    std::vector<LearnerLine> lines;
    while (std::getline(in, line)) {
        std::vector<std::string> fields = split(line, '\t');
        fields.resize(names.size());
        LearnerLine learner;
        if (with_types) {
            learner.said = without_gaps(fields[column("src")]);
            learner.corrected = without_gaps(fields[column("corrected")]);
            for (std::string& code : split(fields[column("types")], ',')) {
                if (!code.empty()) {
                    learner.codes.push_back(std::move(code));
                }
            }
        } else {
            const std::string& claim = fields[column("assert")];
            learner.said = fields[column("source")];
            learner.right = claim == "no_lints";
            if (!learner.right && claim != "suggestion_result" &&
                claim != "good_and_bad_suggestions") {
                continue;  // how many there are isn't told
            }
            learner.codes = {fields[column("rule")]};
        }
        lines.push_back(std::move(learner));
    }
    return lines;
}

void add_line(const LearnerLine& line, const CheckedText& checked, EnglishScores& scores) {
    const std::vector<Token> said = tokenise(line.said);
    const std::vector<bool> changed = changed_words(said, words_of(line.corrected));
    std::map<std::string, int> left;
    for (const std::string& code : line.codes) {
        ++scores[code].there;
        ++left[code];
    }
    for (const FreeError& error : checked.errors) {
        EnglishScore& score = scores[std::string(errant_code(error.code))];
        ++score.alarms;
        bool touches = false;
        for (std::size_t i = 0; i <= said.size(); ++i) {
            const std::size_t begin = i < said.size() ? said[i].begin : line.said.size();
            const std::size_t end = i < said.size() ? said[i].end : line.said.size();
            touches = touches || (changed[i] && begin <= error.end && error.begin <= end);
        }
        score.right_place += touches ? 1 : 0;
        if (touches && left[std::string(errant_code(error.code))]-- > 0) {
            ++score.found;
            ++score.named;
        }
    }
}

}  // namespace fulcrum::bench
