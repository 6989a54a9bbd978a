#include "dialogue/marking/question_review.h"

#include "dialogue/english/letters.h"
#include "dialogue/template/matcher.h"
#include "dialogue/template/sentences.h"

#include <algorithm>
#include <cstdint>
#include <utility>

namespace fulcrum::dialogue {
namespace {

constexpr int kSamples = 60;  // sentences of one answer

using Slots = std::vector<std::pair<std::string, std::string>>;

/// Whole, right sentences of answer `number`, as they are said, with what they mean.
std::vector<Sample> samples_of(const TemplateSet& set, int number) {
    std::vector<Sample> samples;
    std::uint64_t state = 1;  // the same sentences at each check
    const auto choose = [&](std::size_t n) {
        constexpr std::uint64_t kMultiplier = 6364136223846793005U;  // Knuth's MMIX generator
        constexpr std::uint64_t kIncrement = 1442695040888963407U;
        state = state * kMultiplier + kIncrement;
        return static_cast<std::size_t>(state >> 33U) % n;
    };
    for (int i = 0; i < kSamples; ++i) {
        Sample sample = walk_plainly(set, number, false, choose);
        const bool seen = std::any_of(samples.begin(), samples.end(), [&](const Sample& other) {
            return other.said == sample.said;
        });
        if (!seen && !sample.said.empty()) {
            samples.push_back(std::move(sample));
        }
    }
    return samples;
}

std::string in_quotes(std::string_view sentence) {
    return concat({"\"", sentence_case(sentence), "\""});
}

std::string written(const Slots& slots) {
    std::string text;
    for (const auto& [name, value] : slots) {
        text += concat({text.empty() ? "" : ", ", name, " = ", value});
    }
    return text.empty() ? "nothing" : text;
}

Slots sorted(Slots slots) {
    std::sort(slots.begin(), slots.end());
    return slots;
}

/// Answers all of whose sentences another answer takes.
void find_unreachable(const TemplateSet& set, int number, const std::vector<Sample>& samples,
                      std::vector<std::string>& found) {
    int taker = kNone;
    for (const Sample& sample : samples) {
        const auto parse = match(set, sample.said);
        if (!parse || parse->graph == number) {
            return;
        }
        taker = set.graphs[static_cast<std::size_t>(parse->graph)].answer;
    }
    if (!samples.empty() && taker != number) {
        found.push_back(concat(
            {"answer ", std::to_string(number + 1), " is never taken: what it says is answer ",
             std::to_string(taker + 1), " already, e.g. ", in_quotes(samples.front().said)}));
    }
}

/// A sentence that is taken for something else than what it was made for.
void find_ambiguous(const TemplateSet& set, const std::vector<Sample>& samples,
                    std::vector<std::string>& found) {
    for (const Sample& sample : samples) {
        const auto parse = match(set, sample.said);
        if (parse && parse->cost == 0 && sorted(parse->slots) != sorted(sample.slots)) {
            found.push_back(concat({in_quotes(sample.said), " means ", written(sample.slots),
                                    ", and ", written(parse->slots), " as well"}));
            return;
        }
    }
}

/// Does one of the sentences have those words?
bool has_words(const std::vector<std::string>& sentences, const std::string& words) {
    return std::any_of(sentences.begin(), sentences.end(), [&](const std::string& sentence) {
        const std::string padded = concat({" ", lower_case(sentence), " "});
        const std::size_t at = padded.find(concat({" ", words}));
        return at != std::string::npos &&
               std::string_view(" .,!?").find(padded[at + 1 + words.size()]) !=
                   std::string_view::npos;
    });
}

/// The sentences that have the opposite of one word of `said` instead of it, as far as the templates know its first word.
std::vector<std::string> turned(const TemplateSet& set, const std::string& said,
                                const Opposites& opposites, const std::vector<std::string>& meant) {
    std::vector<std::string> sentences;
    for (std::size_t begin = 0; begin < said.size();) {
        const std::size_t end = std::min(said.find(' ', begin), said.size());
        for (const std::string& opposite : opposites(lower_case(said.substr(begin, end - begin)))) {
            if (set.words.find(opposite.substr(0, opposite.find(' '))) != kNone &&
                !has_words(meant, opposite)) {
                sentences.push_back(std::string(said).replace(begin, end - begin, opposite));
            }
        }
        begin = end + 1;
    }
    return sentences;
}

/// An opposite that is taken for the same answer: nothing tells the lesson which of them was said.
void find_opposite_taken(const TemplateSet& set, const std::vector<Sample>& samples,
                         const Opposites& opposites, const std::vector<std::string>& meant,
                         std::vector<std::string>& found) {
    // "Wind." is short for "no wind": what was left out is not what was turned. What follows from an answer by English means what it says.
    const auto differs = [&](const Parse& parse) {
        const Graph& graph = set.graphs[static_cast<std::size_t>(parse.graph)];
        return graph.short_answer || parse.graph >= set.answers;
    };
    for (const Sample& sample : samples) {
        for (const std::string& other : turned(set, sample.said, opposites, meant)) {
            const auto parse = match(set, other);
            if (parse && parse->cost == 0 && !differs(*parse) &&
                sorted(parse->slots) == sorted(sample.slots)) {
                found.push_back(concat({in_quotes(other), " counts as ", in_quotes(sample.said),
                                        "; give the two words a list, so that the lesson can "
                                        "tell, or the question both in its examples, as right"}));
                return;
            }
        }
    }
}

}  // namespace

std::vector<std::string> review_question(const Question& question, const Opposites& opposites,
                                         const std::vector<std::string>& meant) {
    std::vector<std::string> found;
    const TemplateSet& set = *question.templates;
    for (int number = 0; number < set.answers; ++number) {
        const std::vector<Sample> samples = samples_of(set, number);
        find_unreachable(set, number, samples, found);
        find_ambiguous(set, samples, found);
        find_opposite_taken(set, samples, opposites, meant, found);
    }
    return found;
}

std::vector<SaidBack> said_back(const Question& question) {
    constexpr std::size_t kMostSentences = 6;  // of one answer
    std::vector<SaidBack> all;
    const TemplateSet& set = *question.templates;
    for (int answer = 0; answer < set.answers; ++answer) {
        std::vector<std::string> sentences{render(canonical_pieces(set, answer, {}))};
        for (const Sample& sample : samples_of(set, answer)) {
            std::string sentence = render(canonical_pieces(set, answer, sample.slots));
            if (sentences.size() < kMostSentences &&
                std::find(sentences.begin(), sentences.end(), sentence) == sentences.end()) {
                sentences.push_back(std::move(sentence));
            }
        }
        for (std::string& sentence : sentences) {
            all.push_back({answer, std::move(sentence)});
        }
    }
    return all;
}

std::vector<std::string> unheard_words(const Question& question,
                                       const std::function<bool(std::string_view)>& can_be_heard) {
    const TemplateSet& set = *question.templates;
    std::vector<std::string> words;
    for (const Graph& graph : set.graphs) {
        for (const Arc& arc : graph.arcs) {
            for (const int number : graph.said_by(arc)) {
                const std::string& word = set.words.text(number);
                const bool known = std::find(words.begin(), words.end(), word) != words.end();
                if (arc.code == ErrorCode::none && !known && !can_be_heard(word)) {
                    words.push_back(word);
                }
            }
        }
    }
    return words;
}

}  // namespace fulcrum::dialogue
