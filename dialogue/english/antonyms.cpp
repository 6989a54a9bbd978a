#include "dialogue/english/antonyms.h"

#include "dialogue/english/adjective.h"
#include "dialogue/english/opposite.h"
#include "dialogue/english/verb.h"
#include "dialogue/english/wordnet_line.h"

#include <algorithm>
#include <array>
#include <optional>
#include <utility>

namespace fulcrum::dialogue {
namespace {

constexpr std::array<std::string_view, 4> kDataEndings = {"noun", "verb", "adj", "adv"};

/// Of words that WordNet has not: prepositions, numbers and whole answers, each pair both ways.
constexpr std::array<std::pair<std::string_view, std::string_view>, 16> kSmallWords = {{
    {"with", "without"},
    {"above", "below"},
    {"over", "under"},
    {"before", "after"},
    {"on", "off"},
    {"in", "out"},
    {"into", "out of"},
    {"on", "under"},
    {"yes", "no"},
    {"more", "less"},
    {"up", "down"},
    {"all", "none"},
    {"always", "never"},
    {"inside", "outside"},
    {"towards", "away from"},
    {"left", "right"},
}};

/// The verbs that "not" goes behind.
constexpr std::array<std::string_view, 14> kNegated = {"is",   "are",   "was",    "were", "do",
                                                       "does", "did",   "has",    "have", "can",
                                                       "will", "would", "should", "must"};

void add_once(std::string word, std::vector<std::string>& words) {
    if (!word.empty() && std::find(words.begin(), words.end(), word) == words.end()) {
        words.push_back(std::move(word));
    }
}

/// "able(p)" is "able", where it stands in a sentence only.
std::string_view bare_word(std::string_view word) {
    return word.substr(0, word.find('('));
}

std::optional<WordKind> kind_of(std::string_view letter) {
    return letter == "n"                    ? std::optional(WordKind::noun)
           : letter == "v"                  ? std::optional(WordKind::verb)
           : letter == "a" || letter == "s" ? std::optional(WordKind::adjective)
           : letter == "r"                  ? std::optional(WordKind::adverb)
                                            : std::nullopt;
}

/// A line of a data file: the words of one sense, and what it points to.
struct Sense {
    std::vector<std::string_view> words;
    std::string_view pointers;  ///< "! 01189386 a 0101 & …"
    std::size_t n_pointers = 0;
};

Sense read_sense(std::string_view data, std::size_t offset) {
    Sense sense;
    if (offset >= data.size()) {
        return sense;
    }
    std::string_view line = data.substr(offset);
    line = line.substr(0, line.find('\n'));
    for (int before_count = 0; before_count < 3; ++before_count) {
        take_field(line);
    }
    const std::size_t n_words = number_in(take_field(line), 16);
    for (std::size_t i = 0; i < n_words && !line.empty(); ++i) {
        sense.words.push_back(bare_word(take_field(line)));
        take_field(line);  // its number
    }
    sense.n_pointers = number_in(take_field(line), 10);
    sense.pointers = line;
    return sense;
}

/// The offsets of an entry's senses, which stand at the end of its line in the index: "heavy a 27 5 ! & = + ; 27 7 01184932 …".
std::vector<std::size_t> senses_of(std::string_view line) {
    std::vector<std::size_t> senses;
    take_field(line);
    take_field(line);
    const std::size_t n_senses = number_in(take_field(line), 10);
    const std::size_t n_symbols = number_in(take_field(line), 10);
    for (std::size_t i = 0; i < n_symbols + 2 && !line.empty(); ++i) {
        take_field(line);
    }
    for (std::size_t i = 0; i < n_senses && !line.empty(); ++i) {
        senses.push_back(number_in(take_field(line), 10));
    }
    return senses;
}

/// The opposite of an adjective in the degree of `said`, a form of `entry`.
std::string in_degree_of(std::string_view said, std::string_view entry, std::string_view opposite) {
    for (const Degree degree : {Degree::comparative, Degree::superlative}) {
        const std::vector<std::string> forms = degree_forms(entry, degree);
        if (std::find(forms.begin(), forms.end(), said) != forms.end()) {
            return degree_forms(opposite, degree).front();
        }
    }
    return {};
}

/// `opposite` in the form that `said` is of `entry`; empty where that is not known.
std::string in_form_of(std::string_view said, std::string_view entry, std::string_view opposite,
                       WordKind kind) {
    if (said == entry) {
        return std::string(opposite);
    }
    if (kind == WordKind::adjective) {
        return in_degree_of(said, entry, opposite);
    }
    return said == third_person(entry) ? third_person(opposite) : std::string{};
}

void add_small_words(std::string_view word, std::vector<std::string>& found) {
    for (const auto& [one, other] : kSmallWords) {
        if (word == one || word == other) {
            add_once(std::string(word == one ? other : one), found);
        }
    }
    if (std::find(kNegated.begin(), kNegated.end(), word) != kNegated.end()) {
        add_once(word == "can"    ? "can't"
                 : word == "will" ? "won't"
                                  : std::string(word) + "n't",
                 found);
        add_once(word == "can" ? "cannot" : std::string(word) + " not", found);
    }
}

}  // namespace

Antonyms::Antonyms(Lexicon lexicon, std::vector<SortedLines> indexes, std::vector<SortedLines> data)
    : lexicon_(std::move(lexicon)), indexes_(std::move(indexes)), data_(std::move(data)) {}

Expected<Antonyms> Antonyms::open(std::string_view folder) {
    constexpr std::string_view kFrom = "wordnet-base";
    auto lexicon = Lexicon::open(folder);
    if (!lexicon) {
        return tl::unexpected<Error>(lexicon.error());
    }
    std::vector<SortedLines> indexes;
    std::vector<SortedLines> data;
    for (const std::string_view ending : kDataEndings) {
        auto index = SortedLines::open(concat({folder, "/index.", ending}), kFrom);
        if (!index) {
            return tl::unexpected<Error>(index.error());
        }
        auto senses = SortedLines::open(concat({folder, "/data.", ending}), kFrom);
        if (!senses) {
            return tl::unexpected<Error>(senses.error());
        }
        indexes.push_back(std::move(*index));
        data.push_back(std::move(*senses));
    }
    return Antonyms(std::move(*lexicon), std::move(indexes), std::move(data));
}

std::vector<std::string> Antonyms::of_entry(std::string_view entry, WordKind kind) const {
    std::vector<std::string> found;
    const std::string_view lines =
        indexes_[static_cast<std::size_t>(kind)].starting_with(concat({entry, " "}));
    for (const std::size_t offset : senses_of(lines.substr(0, lines.find('\n')))) {
        const Sense sense = read_sense(data_[static_cast<std::size_t>(kind)].text(), offset);
        std::string_view pointers = sense.pointers;
        for (std::size_t i = 0; i < sense.n_pointers && !pointers.empty(); ++i) {
            const std::string_view symbol = take_field(pointers);
            const std::size_t to = number_in(take_field(pointers), 10);
            const auto to_kind = kind_of(take_field(pointers));
            const std::size_t words =
                number_in(take_field(pointers), 16);  // from, to: one byte each
            const std::size_t from_word = words >> 8U;
            const std::size_t to_word = words & 0xFFU;
            if (symbol != "!" || !to_kind || from_word == 0 || from_word > sense.words.size() ||
                sense.words[from_word - 1] != entry) {
                continue;
            }
            const Sense other = read_sense(data_[static_cast<std::size_t>(*to_kind)].text(), to);
            if (to_word > 0 && to_word <= other.words.size()) {
                add_once(std::string(other.words[to_word - 1]), found);
            }
        }
    }
    return found;
}

std::vector<std::string> Antonyms::of(std::string_view word) const {
    std::vector<std::string> found;
    add_small_words(word, found);
    for (const WordKind kind : kWordKinds) {
        std::vector<std::string> entries = lexicon_.bases(word, kind);
        entries.emplace_back(word);
        for (const std::string& entry : entries) {
            std::vector<std::string> opposites = of_entry(entry, kind);
            if (kind == WordKind::adjective) {
                for (const std::string_view known : opposites_of(entry)) {
                    add_once(std::string(known), opposites);
                }
            }
            for (const std::string& opposite : opposites) {
                add_once(in_form_of(word, entry, opposite, kind), found);
            }
        }
    }
    return found;
}

}  // namespace fulcrum::dialogue
