#include "dialogue/template/hearing.h"

#include "dialogue/english/determiner.h"
#include "dialogue/english/letters.h"
#include "dialogue/template/tokens.h"

#include <algorithm>
#include <array>
#include <span>

namespace fulcrum::dialogue {
namespace {

/// Words that carry no meaning here.
constexpr std::array<std::string_view, 31> kFillers = {
    "um",      "uh",         "er",         "erm",     "hm",        "hmm",       "mm",     "well",
    "ok",      "okay",       "oh",         "ah",      "yes",       "yeah",      "please", "so",
    "maybe",   "like",       "definitely", "really",  "actually",  "only",      "just",   "now",
    "exactly", "altogether", "probably",   "perhaps", "certainly", "obviously", "simply"};

/// Who is spoken to, first or last: "Miss, it is the egg"; not "it misses a tail".
constexpr std::array<std::string_view, 3> kSpokenTo = {"teacher", "miss", "sir"};

/// Openings and endings of the same kind.
constexpr std::array<std::string_view, 22> kPhrases = {
    "i think that",   "i think",     "i believe that", "i believe",     "i guess that",
    "i guess",        "i feel that", "i feel",         "i know that",   "i know",
    "i would say",    "of course",   "for sure",       "my answer is",  "the answer is",
    "i am sure that", "i am sure",   "let me see",     "in my opinion", "it feels like",
    "you know",       "you see"};

/// Said behind an answer of what it rests on; before one "it" begins it.
constexpr std::array<std::string_view, 11> kRemarks = {"i can feel it",
                                                       "i feel it",
                                                       "i could feel it",
                                                       "i felt it",
                                                       "i felt it in my hand",
                                                       "i feel it in my hand",
                                                       "i think so",
                                                       "i know it",
                                                       "i am very sure",
                                                       "i am sure of it",
                                                       "i saw it"};

/// Asked behind an answer, whether it is so.
constexpr std::array<std::string_view, 6> kTags = {"is not it",   "does not it",   "are not they",
                                                   "do not they", "is that right", "right"};

constexpr std::array<std::string_view, 5> kReasons = {"because", "cause", "cos", "coz", "since"};

/// Begin a clause behind "so": "so it falls"; not "so heavy".
constexpr std::array<std::string_view, 14> kSubjects = {
    "it", "they", "i", "we", "you", "there", "that", "he", "she", "the", "this", "my", "a", "an"};

/// Words of two letters that are never taken for a slip.
constexpr std::array<std::string_view, 35> kShortWords = {
    "am", "an", "as", "at", "be", "by", "do", "eh", "go", "ha", "he", "hi",
    "if", "in", "is", "it", "la", "me", "my", "no", "of", "oh", "on", "or",
    "ox", "pi", "so", "to", "tv", "up", "us", "we", "ye", "yo", "ax"};

/// Contractions without their apostrophe.
struct Contraction {
    std::string_view typed, first, second, written;
};
constexpr std::array kContractions = {
    Contraction{"its", "it", "is", "it's"}, Contraction{"thats", "that", "is", "that's"},
    Contraction{"theyre", "they", "are", "they're"}, Contraction{"im", "i", "am", "I'm"}};

/// Real words that are never taken for a slip of another: a pear is no bear.
constexpr std::array<std::string_view, 134> kRealWords = {
    "pear",     "bear",   "bean",   "beans",  "peach",  "plum",   "lemon",  "melon",  "mango",
    "grape",    "grapes", "lime",   "cherry", "berry",  "onion",  "carrot", "corn",   "nut",
    "nuts",     "egg",    "leg",    "ham",    "fish",   "dish",   "cat",    "hat",    "bat",
    "rat",      "dog",    "cow",    "pig",    "hen",    "duck",   "goose",  "horse",  "house",
    "mouse",    "ball",   "bell",   "box",    "book",   "rock",   "sock",   "clock",  "lock",
    "stone",    "store",  "wood",   "food",   "wool",   "wheel",  "steel",  "paper",  "pepper",
    "water",    "waiter", "winter", "metal",  "medal",  "sand",   "hand",   "band",   "land",
    "stand",    "star",   "stair",  "car",    "cart",   "card",   "chair",  "hair",   "table",
    "cable",    "light",  "right",  "night",  "weight", "height", "eight",  "heavy",  "heaven",
    "lighter",  "later",  "letter", "bigger", "better", "bitter", "butter", "longer", "larger",
    "less",     "least",  "last",   "not",    "now",    "none",   "grass",  "glove",  "word",
    "stove",    "boot",   "coat",   "cap",    "cut",    "cub",    "coil",   "bull",   "wall",
    "cook",     "tablet", "cattle", "castor", "status", "battle", "chain",  "tile",   "time",
    "tired",    "widow",  "robber", "rudder", "stinky", "hare",   "herd",   "sort",   "sofa",
    "slippers", "rack",   "roof",   "male",   "mode",   "close",  "near",   "think"};

using Phrases = std::vector<std::vector<std::string>>;

/// The words of each.
Phrases part(std::span<const std::string_view> phrases) {
    Phrases parted;
    for (const std::string_view phrase : phrases) {
        parted.push_back(words_of(phrase));
    }
    return parted;
}
const Phrases& phrases() {
    static const Phrases kParted = part(kPhrases);
    return kParted;
}
const Phrases& remarks() {
    static const Phrases kParted = part(kRemarks);
    return kParted;
}
const Phrases& tags() {
    static const Phrases kParted = part(kTags);
    return kParted;
}

template <class Table>
bool contains(const Table& table, std::string_view word) {
    return std::find(table.begin(), table.end(), word) != table.end();
}

/// True when `word` is, or is a part of, what a list gives.
bool is_listed(const TemplateSet& set, std::string_view word) {
    for (const WordList& list : set.lists) {
        for (const ListItem& item : list.items) {
            for (const Noun& noun : item.spoken) {
                const std::vector<std::string> words = words_of(noun.text);
                if (contains(words, word)) {
                    return true;
                }
            }
        }
    }
    return false;
}

/// Slips rarely touch the first letter, except by swapping it with the next.
bool starts_alike(const std::string& word, const std::string& text) {
    return word[0] == text[0] || (word.size() > 1 && word[0] == text[1] && word[1] == text[0]);
}

/// The one word of the templates that `text` is a slip of, or kNone. Two letters are too few to tell one little word from
/// another; they may be a slip of a listed noun ("eg").
int nearest_word(const TemplateSet& set, const std::string& text, std::size_t& comparisons) {
    const bool is_short = text.size() == 2 && !contains(kShortWords, text);
    const int allowed = is_short ? 1 : allowed_slip(text.size());
    if (allowed == 0 || contains(kRealWords, text)) {
        return kNone;
    }
    int best = kNone;
    int best_distance = allowed + 1;
    int best_standing = 0;
    bool unique = false;
    for (int number = 0; number < set.words.size(); ++number) {
        const std::string& word = set.words.text(number);
        const int standing = set.standing[static_cast<std::size_t>(number)];
        const auto longer = static_cast<int>(std::max(word.size(), text.size()));
        const auto shorter = static_cast<int>(std::min(word.size(), text.size()));
        if (standing == 0 || word.size() < 3 || longer - shorter > allowed ||
            !starts_alike(word, text)) {
            continue;
        }
        ++comparisons;
        const int distance = edit_distance(word, text);
        const bool more_usual = !is_short && standing > best_standing;
        if (distance < best_distance || (distance == best_distance && more_usual)) {
            best = number;
            best_distance = distance;
            best_standing = standing;
            unique = true;
        } else if (distance == best_distance && (is_short || standing == best_standing)) {
            unique = false;
        }
    }
    const bool found = unique && best_distance <= allowed;
    return found && (!is_short || is_listed(set, set.words.text(best))) ? best : kNone;
}

bool stands_at(const std::vector<Token>& tokens, std::size_t at,
               const std::vector<std::string>& words) {
    return at + words.size() <= tokens.size() &&
           std::equal(
               words.begin(), words.end(), tokens.begin() + static_cast<std::ptrdiff_t>(at),
               [](const std::string& word, const Token& token) { return word == token.text; });
}

/// Marks the words `at` and after as fillers when they are `words`; false when they aren't, or are fillers already.
bool mark_phrase(const std::vector<Token>& tokens, std::size_t at,
                 const std::vector<std::string>& words, std::vector<HeardWord>& heard) {
    if (!stands_at(tokens, at, words) || heard[at + words.size() - 1].filler) {
        return false;
    }
    for (std::size_t i = 0; i < words.size(); ++i) {
        heard[at + i].filler = true;
    }
    return true;
}

bool all_known(const TemplateSet& set, const std::vector<std::string>& words) {
    return std::all_of(words.begin(), words.end(),
                       [&](const std::string& word) { return set.words.find(word) != kNone; });
}

/// Marks what frames an answer as fillers: known phrases at its beginning and end, one behind the other.
void mark_phrases(const TemplateSet& set, const std::vector<Token>& tokens, std::size_t end,
                  std::vector<HeardWord>& heard) {
    bool again = true;
    while (again) {
        again = false;
        const auto is_said = [](const HeardWord& word) { return !word.filler; };
        const auto stop = heard.begin() + static_cast<std::ptrdiff_t>(end);
        const auto first = std::find_if(heard.begin(), stop, is_said);
        std::size_t last = end;
        while (last > 0 && heard[last - 1].filler) {
            --last;
        }
        for (const std::vector<std::string>& words : phrases()) {
            if (all_known(set, words)) {
                continue;  // "it feels like" where the templates speak of how it feels
            }
            const auto begin = static_cast<std::size_t>(first - heard.begin());
            if (begin + words.size() >= last) {
                continue;  // nothing would be left to understand
            }
            if (mark_phrase(tokens, begin, words, heard) ||
                mark_phrase(tokens, last - words.size(), words, heard)) {
                again = true;
                break;
            }
        }
        for (const std::vector<std::string>& words : remarks()) {
            const auto begin = static_cast<std::size_t>(first - heard.begin());
            again = again || (!all_known(set, words) && begin + words.size() < last &&
                              mark_phrase(tokens, last - words.size(), words, heard));
        }
    }
}

/// A token whose letters may have been put right.
struct MendedToken {
    Token token;
    ErrorCode slip = ErrorCode::none;
    std::string_view short_form{};
};

/// The author's own sentences say it, right or wrong; what follows from them by English ("not so heavy") does not count.
bool is_asked_for(const TemplateSet& set, const std::string& text) {
    const int word = set.words.find(text);
    for (int i = 0; word != kNone && i < static_cast<int>(set.graphs.size()); ++i) {
        const Graph& graph = set.graphs[static_cast<std::size_t>(i)];
        if ((i < set.answers || graph.nearly) &&
            std::find(graph.said.begin(), graph.said.end(), word) != graph.said.end()) {
            return true;
        }
    }
    return false;
}

/// Where a reason begins that the templates don't ask for: "… because it is big", "… so that it flies"; the number of tokens without one.
std::size_t reason_of(const TemplateSet& set, const std::vector<MendedToken>& tokens,
                      Reason reason) {
    for (std::size_t i = 1; i < tokens.size(); ++i) {
        const std::string& word = tokens[i].token.text;
        const bool so = reason == Reason::so_too && word == "so" && i + 1 < tokens.size() &&
                        contains(kSubjects, tokens[i + 1].token.text);
        const bool aim =
            word == "so" && i + 1 < tokens.size() && tokens[i + 1].token.text == "that";
        if ((aim || so || begins_reason(word)) && !is_asked_for(set, word)) {
            return i;
        }
    }
    return tokens.size();
}

/// "its": the first part of a contraction without its apostrophe, then the second; empty for other words.
std::vector<MendedToken> parted(const TemplateSet& set, const Token& token) {
    for (const Contraction& contraction : kContractions) {
        if (contraction.typed == token.text && set.words.find(contraction.first) != kNone) {
            return {{{std::string(contraction.first), token.begin, token.end},
                     ErrorCode::orthography,
                     contraction.written},
                    {{std::string(contraction.second), token.end, token.end}, ErrorCode::none}};
        }
    }
    return {};
}

/// Mends "its the watermelon" (the apostrophe is missing) and "water melon" (one word was written as two).
std::vector<MendedToken> mended(const TemplateSet& set, const std::vector<Token>& tokens, Its its) {
    std::vector<MendedToken> result;
    for (std::size_t i = 0; i < tokens.size(); ++i) {
        const bool known = set.words.find(tokens[i].text) != kNone;
        const bool whole = known && (its == Its::owner || tokens[i].text != "its");
        const std::vector<MendedToken> parts =
            whole ? std::vector<MendedToken>{} : parted(set, tokens[i]);
        const std::string both =
            i + 1 < tokens.size() ? tokens[i].text + tokens[i + 1].text : std::string{};
        if (!parts.empty()) {
            result.insert(result.end(), parts.begin(), parts.end());
        } else if (set.words.find(both) != kNone &&
                   !(known && set.words.find(tokens[i + 1].text) != kNone)) {
            result.push_back({{both, tokens[i].begin, tokens[i + 1].end}, ErrorCode::orthography});
            ++i;
        } else {
            result.push_back({tokens[i], ErrorCode::none});
        }
    }
    return result;
}

/// "The a moon": of two determiners side by side one is too many.
void mark_doubled(const std::vector<Token>& tokens, std::vector<HeardWord>& heard) {
    for (std::size_t i = 1; i < heard.size(); ++i) {
        const bool both = !heard[i - 1].filler && !heard[i].filler &&
                          is_sole_determiner(tokens[i - 1].text) &&
                          is_sole_determiner(tokens[i].text);
        heard[i - 1].doubled = heard[i - 1].doubled || both;
        heard[i].doubled = both;
    }
}

}  // namespace

bool begins_reason(std::string_view word) {
    return contains(kReasons, word);
}

bool its_is_open(const TemplateSet& set, std::string_view utterance) {
    const std::vector<Token> tokens = tokenise(utterance);
    return set.words.find("its") != kNone && set.words.find("it") != kNone &&
           std::any_of(tokens.begin(), tokens.end(),
                       [](const Token& token) { return token.text == "its"; });
}

bool is_frame(std::string_view utterance) {
    const std::vector<Token> tokens = tokenise(utterance);
    for (std::size_t at = 0; at < tokens.size();) {
        std::size_t framing = contains(kFillers, tokens[at].text) ? 1 : 0;
        const auto take = [&](const std::vector<std::string>& words) {
            framing = stands_at(tokens, at, words) ? std::max(framing, words.size()) : framing;
        };
        std::ranges::for_each(phrases(), take);
        std::ranges::for_each(remarks(), take);
        std::ranges::for_each(tags(), take);
        if (framing == 0) {
            return false;
        }
        at += framing;
    }
    return true;
}

bool has_consequence(const TemplateSet& set, std::string_view utterance) {
    const std::vector<Token> tokens = tokenise(utterance);
    return !is_asked_for(set, "so") &&
           std::any_of(tokens.begin(), tokens.end(),
                       [](const Token& token) { return token.text == "so"; });
}

namespace {

/// "So, the apple is heavier", where "not so heavy" may be said as well; "the lift is smaller then": "than" has something behind it.
bool opens_or_ends(std::string_view word, std::size_t at, std::size_t end, std::size_t n_words) {
    const bool is_outermost = at == 0 || at + 1 == end;
    return (at == 0 && word == "so") || (is_outermost && n_words > 1 && word == "then");
}

}  // namespace

std::vector<HeardWord> hear_words(const TemplateSet& set, std::string_view utterance,
                                  std::size_t& comparisons, Its its, Reason reasons) {
    std::vector<MendedToken> said = mended(set, tokenise(utterance), its);
    const std::size_t reason = reason_of(set, said, reasons);
    std::vector<Token> tokens;
    std::vector<HeardWord> heard;
    for (MendedToken& mended_token : said) {
        const Token& token = mended_token.token;
        HeardWord word{
            kNone, token.begin, token.end, mended_token.slip, false, mended_token.short_form};
        if (heard.size() >= reason) {
            word.filler = word.unread = true;
        } else {
            word.word = set.words.find(token.text);
        }
        if (word.word == kNone && !word.filler) {
            const bool at_edge = heard.size() + 1 == reason ||
                                 std::all_of(heard.begin(), heard.end(),
                                             [](const HeardWord& before) { return before.filler; });
            word.filler =
                contains(kFillers, token.text) || (at_edge && contains(kSpokenTo, token.text));
            word.word = word.filler ? kNone : nearest_word(set, token.text, comparisons);
            word.slip = word.word == kNone ? word.slip : ErrorCode::spelling;
        }
        word.filler = word.filler || opens_or_ends(token.text, heard.size(),
                                                   std::min(reason, said.size()), said.size());
        heard.push_back(word);
        tokens.push_back(std::move(mended_token.token));
    }
    mark_phrases(set, tokens, reason, heard);
    mark_doubled(tokens, heard);
    return heard;
}

}  // namespace fulcrum::dialogue
