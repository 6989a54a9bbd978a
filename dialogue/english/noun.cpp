#include "dialogue/english/noun.h"

#include "dialogue/english/adjective.h"
#include "dialogue/english/letters.h"
#include "dialogue/english/number.h"
#include "dialogue/english/word_table.h"

#include <algorithm>
#include <array>
#include <map>

namespace fulcrum::dialogue {
namespace {

struct PluralPair {
    std::string_view singular, plural;
};
constexpr std::array kIrregularPlurals = {
    PluralPair{"man", "men"},
    PluralPair{"woman", "women"},
    PluralPair{"child", "children"},
    PluralPair{"foot", "feet"},
    PluralPair{"tooth", "teeth"},
    PluralPair{"goose", "geese"},
    PluralPair{"mouse", "mice"},
    PluralPair{"louse", "lice"},
    PluralPair{"ox", "oxen"},
    PluralPair{"person", "people"},
    PluralPair{"die", "dice"},
    PluralPair{"sheep", "sheep"},
    PluralPair{"fish", "fish"},
    PluralPair{"deer", "deer"},
    PluralPair{"moose", "moose"},
    PluralPair{"salmon", "salmon"},
    PluralPair{"series", "series"},
    PluralPair{"species", "species"},
    PluralPair{"aircraft", "aircraft"},
    PluralPair{"spacecraft", "spacecraft"},
    PluralPair{"swine", "swine"},
    PluralPair{"leaf", "leaves"},
    PluralPair{"knife", "knives"},
    PluralPair{"life", "lives"},
    PluralPair{"wife", "wives"},
    PluralPair{"half", "halves"},
    PluralPair{"loaf", "loaves"},
    PluralPair{"shelf", "shelves"},
    PluralPair{"wolf", "wolves"},
    PluralPair{"calf", "calves"},
    PluralPair{"elf", "elves"},
    PluralPair{"self", "selves"},
    PluralPair{"thief", "thieves"},
    PluralPair{"scarf", "scarves"},
    PluralPair{"hoof", "hooves"},
    PluralPair{"potato", "potatoes"},
    PluralPair{"tomato", "tomatoes"},
    PluralPair{"hero", "heroes"},
    PluralPair{"echo", "echoes"},
    PluralPair{"torpedo", "torpedoes"},
    PluralPair{"volcano", "volcanoes"},
    PluralPair{"mango", "mangoes"},
    PluralPair{"mosquito", "mosquitoes"},
    PluralPair{"cactus", "cacti"},
    PluralPair{"fungus", "fungi"},
    PluralPair{"nucleus", "nuclei"},
    PluralPair{"radius", "radii"},
    PluralPair{"analysis", "analyses"},
    PluralPair{"crisis", "crises"},
    PluralPair{"axis", "axes"},
    PluralPair{"basis", "bases"},
    PluralPair{"phenomenon", "phenomena"},
    PluralPair{"bacterium", "bacteria"},
    PluralPair{"quiz", "quizzes"},
    PluralPair{"snowman", "snowmen"},
    PluralPair{"fireman", "firemen"},
    PluralPair{"policeman", "policemen"},
    PluralPair{"stomach", "stomachs"},
    PluralPair{"monarch", "monarchs"},
    PluralPair{"grandchild", "grandchildren"},
};

constexpr std::array<std::string_view, 138> kMass = {
    "water",       "air",        "wood",      "metal",      "iron",      "steel",     "gold",
    "silver",      "copper",     "plastic",   "paper",      "rubber",    "cotton",    "wool",
    "leather",     "glass",      "sand",      "oil",        "milk",      "juice",     "tea",
    "coffee",      "rice",       "bread",     "butter",     "cheese",    "meat",      "sugar",
    "salt",        "flour",      "soup",      "honey",      "snow",      "ice",       "rain",
    "wind",        "weather",    "gravity",   "torque",     "energy",    "light",     "heat",
    "electricity", "music",      "homework",  "furniture",  "luggage",   "money",     "advice",
    "information", "news",       "knowledge", "equipment",  "traffic",   "software",  "clothing",
    "jewellery",   "jewelry",    "concrete",  "granite",    "marble",    "sandpaper", "clay",
    "dust",        "grass",      "hair",      "lava",       "mud",       "oxygen",    "hydrogen",
    "helium",      "silk",       "foam",      "aluminium",  "aluminum",  "titanium",  "tin",
    "brass",       "bronze",     "velvet",    "nylon",      "bamboo",    "cardboard", "porcelain",
    "cork",        "wax",        "chalk",     "fur",        "denim",     "ivory",     "gravel",
    "cement",      "soil",       "lace",      "linen",      "polyester", "silicone",  "plaster",
    "dough",       "straw",      "ceramic",   "fibreglass", "corn",      "wheat",     "barley",
    "popcorn",     "pasta",      "spaghetti", "garlic",     "ham",       "bacon",     "beef",
    "pork",        "lemonade",   "petrol",    "coal",       "zinc",      "nickel",    "sulphur",
    "carbon",      "nitrogen",   "steam",     "smoke",      "fog",       "ink",       "glue",
    "soap",        "toothpaste", "hay",       "lightning",  "thunder",   "sunlight",  "sunshine",
    "rubbish",     "garbage",    "blood",     "vinegar",    "spinach"};

/// Materials whose plural means kinds of them: metals are hard. (Glasses and papers are other things.)
constexpr std::array<std::string_view, 4> kHasKinds = {"metal", "plastic", "juice", "cheese"};

/// Plural-only nouns without their s are other words, or none that anybody says.
constexpr std::array<std::string_view, 6> kNoSingular = {"glasses", "clothes", "shorts",
                                                         "pants",   "jeans",   "pyjamas"};

constexpr std::array<std::string_view, 14> kPluralOnly = {
    "scissors", "glasses", "trousers", "jeans",    "shorts",     "pants",      "pyjamas",
    "clothes",  "goggles", "pliers",   "tweezers", "binoculars", "headphones", "tongs"};

/// End in s, yet singular.
constexpr std::array<std::string_view, 22> kSingularInS = {
    "bus",        "gas",    "lens",    "plus",      "virus",  "octopus",  "walrus",  "hippopotamus",
    "rhinoceros", "cactus", "compass", "atlas",     "canvas", "pancreas", "physics", "mathematics",
    "tennis",     "series", "species", "christmas", "iris",   "news"};

/// "the" belongs to the name.
constexpr std::array<std::string_view, 2> kNamedThe = {"moon", "sun"};

/// Places, amounts and answers that are no things; "a" and "an" count one.
constexpr std::array<std::string_view, 37> kNoNouns = {
    "yeah",    "sure",   "a",       "an",      "near",    "nearer",    "far",   "farther",
    "further", "close",  "closer",  "up",      "down",    "here",      "there", "above",
    "below",   "inside", "outside", "away",    "forward", "backwards", "yes",   "no",
    "more",    "less",   "both",    "neither", "never",   "always",    "none",  "together",
    "again",   "slowly", "quickly", "faster",  "slower"};

/// With one of these a phrase begins that is no thing: "to the left", "near the support".
constexpr std::array<std::string_view, 39> kPrepositions = {
    "to",    "at",      "on",      "in",      "near",    "nearer", "close",     "closer",
    "far",   "further", "farther", "under",   "over",    "behind", "from",      "by",
    "with",  "without", "between", "next",    "towards", "into",   "beside",    "below",
    "above", "beneath", "inside",  "outside", "against", "along",  "across",    "around",
    "onto",  "off",     "up",      "down",    "through", "among",  "underneath"};

/// With one of these and another word: "just as fast", "more strongly", "none of them", "high up".
constexpr std::array<std::string_view, 16> kNeverHeads = {
    "more", "less", "most", "least", "just", "as",   "equally", "very",
    "so",   "too",  "none", "both",  "all",  "high", "low",     "neither"};
constexpr std::array<std::string_view, 9> kBehindThem = {
    "up", "down", "of", "strongly", "weakly", "as", "fast", "quickly", "slowly"};

/// Adjectives that lessons ask for: "it should be heavy".
constexpr std::array<std::string_view, 62> kDescribing = {
    "light",     "great",    "bright", "heavy",  "big",     "small",   "tiny",   "little", "large",
    "tall",      "short",    "long",   "high",   "low",     "hard",    "soft",   "rough",  "smooth",
    "fast",      "slow",     "strong", "weak",   "hot",     "cold",    "warm",   "wide",   "narrow",
    "thick",     "thin",     "deep",   "wet",    "dry",     "full",    "empty",  "open",   "shut",
    "new",       "old",      "young",  "red",    "blue",    "green",   "yellow", "white",  "black",
    "brown",     "grey",     "purple", "pink",   "right",   "wrong",   "true",   "false",  "easy",
    "difficult", "slippery", "sticky", "wooden", "heavier", "lighter", "higher", "lower"};

/// "one", "two hundred and five", "a hundred".
bool is_number(std::string_view phrase) {
    bool any = phrase.starts_with("a hundred") || phrase.starts_with("a thousand");
    phrase.remove_prefix(any ? 2 : 0);
    while (!phrase.empty()) {
        const std::size_t end = std::min(phrase.find_first_of(" -"), phrase.size());
        const std::string_view word = phrase.substr(0, end);
        if (!is_number_word(word) && !(any && word == "and")) {
            return false;
        }
        any = true;
        phrase.remove_prefix(std::min(end + 1, phrase.size()));
    }
    return any;
}

/// "Equally fast", "none of them", "no one".
bool is_no_head(std::string_view phrase) {
    const std::size_t space = phrase.find(' ');
    if (space == std::string_view::npos) {
        return false;
    }
    const std::string_view rest = phrase.substr(space + 1);
    return phrase == "no one" || (contains(kNeverHeads, phrase.substr(0, space)) &&
                                  contains(kBehindThem, rest.substr(0, rest.find(' '))));
}

bool is_no_noun(const std::string& phrase) {
    const std::size_t space = phrase.find(' ');
    return (space == std::string::npos && contains(kNoNouns, phrase)) ||
           contains(kPrepositions, std::string_view(phrase).substr(0, space)) ||
           is_number(phrase) || is_no_head(phrase);
}

/// The word that carries the number: pair of scissors -> pair; big apple -> apple; block made of wood -> block.
std::string_view head_word(std::string_view phrase) {
    phrase = phrase.substr(0, std::min(phrase.find(" of "), phrase.find(" made of ")));
    const std::size_t space = phrase.find_last_of(" -");
    return space == std::string_view::npos ? phrase : phrase.substr(space + 1);
}

bool ends_with(std::string_view word, std::string_view end) {
    return word.size() >= end.size() && word.substr(word.size() - end.size()) == end;
}

/// The singular of a regular plural: citi(es) -> city, box(es) -> box, window(s) -> window.
std::string regular_singular(const std::string& plural) {
    const std::string stem = plural.substr(0, plural.size() - 1);
    if (ends_with(plural, "ies") && plural.size() > 4) {
        return plural.substr(0, plural.size() - 3) + "y";
    }
    for (const std::string_view end : {"xes", "sses", "shes", "ches", "zzes"}) {
        if (ends_with(plural, end)) {
            return stem.substr(0, stem.size() - 1);
        }
    }
    return stem;
}

/// `phrase` with another word for its head.
std::string with_head(std::string_view phrase, const std::string& word) {
    const std::string_view head = head_word(phrase);
    const auto at = static_cast<std::size_t>(head.data() - phrase.data());
    return std::string(phrase.substr(0, at)) + word + std::string(phrase.substr(at + head.size()));
}

std::string plural_of_word(std::string_view word) {
    const std::string lower = lower_case(word);
    for (const PluralPair& pair : kIrregularPlurals) {
        if (pair.singular == lower) {
            // Keep the first letter as it was written: Man -> Men.
            return word[0] == lower[0] ? std::string(pair.plural) : sentence_case(pair.plural);
        }
    }
    const std::size_t n = lower.size();
    const std::string text(word);
    if (ends_with(lower, "s") || ends_with(lower, "x") || ends_with(lower, "z") ||
        ends_with(lower, "ch") || ends_with(lower, "sh")) {
        return text + "es";
    }
    if (n > 1 && lower[n - 1] == 'y' && !is_vowel_letter(lower[n - 2])) {
        return text.substr(0, n - 1) + "ies";
    }
    return text + "s";
}

}  // namespace

std::string plural_of(std::string_view noun) {
    if (noun.empty()) {
        return {};
    }
    const std::string_view head = head_word(noun);
    if (head.empty() || contains(kPluralOnly, lower_case(head))) {
        return std::string(noun);
    }
    return with_head(noun, plural_of_word(head));
}

std::string singular_of(std::string_view noun) {
    if (!looks_plural(noun)) {
        return {};
    }
    const std::string word = lower_case(head_word(noun));
    if (contains(kNoSingular, word)) {
        return {};
    }
    for (const PluralPair& pair : kIrregularPlurals) {
        if (pair.plural == word) {
            return with_head(noun, std::string(pair.singular));
        }
    }
    return with_head(noun, regular_singular(word));
}

bool is_plural_only(std::string_view noun) {
    return contains(kPluralOnly, lower_case(head_word(noun)));
}

bool looks_plural(std::string_view noun) {
    const std::string word = lower_case(head_word(noun));
    const bool irregular = std::any_of(
        kIrregularPlurals.begin(), kIrregularPlurals.end(),
        [&](const PluralPair& pair) { return pair.plural == word && pair.singular != word; });
    if (irregular || contains(kPluralOnly, word)) {
        return true;
    }
    return word.size() > 2 && ends_with(word, "s") && !ends_with(word, "ss") &&
           !ends_with(word, "us") && !ends_with(word, "is") && !contains(kSingularInS, word);
}

bool is_mass_noun(std::string_view noun) {
    return contains(kMass, lower_case(head_word(noun)));
}

bool names_force(std::string_view noun) {
    constexpr std::array<std::string_view, 4> kForces = {"lift", "drag", "tension", "friction"};
    return contains(kForces, lower_case(noun));
}

bool has_kinds(std::string_view noun) {
    return contains(kHasKinds, lower_case(head_word(noun)));
}

bool is_around(std::string_view noun) {
    const std::string text = lower_case(noun);
    return text == "wind" || text == "weather";
}

namespace {

/// The comparatives of what describes, each with its adjective.
const std::map<std::string, std::string>& comparatives() {
    static const auto all = [] {
        std::map<std::string, std::string> forms;
        for (const std::string_view adjective : kDescribing) {
            forms.emplace(degree_forms(adjective, Degree::comparative).front(), adjective);
        }
        return forms;
    }();
    return all;
}

}  // namespace

bool describes(std::string_view word) {
    const std::string text = lower_case(word);
    return contains(kDescribing, text) || comparatives().contains(text);
}

std::string compared_of(std::string_view word) {
    const auto found = comparatives().find(lower_case(word));
    return found == comparatives().end() ? std::string() : found->second;
}

namespace {

/// Of what stands behind its article, where there is one.
NounClass class_of(std::string_view entry, bool with_the, bool with_indefinite) {
    const bool capital = !entry.empty() && entry[0] >= 'A' && entry[0] <= 'Z';
    const bool initials = entry.size() > 1 && entry[1] >= 'A' && entry[1] <= 'Z';
    const std::string lower = lower_case(entry);
    if (with_indefinite) {
        return NounClass::count;
    }
    if ((lower == "earth" || lower.starts_with("earth's ")) && (capital || with_the)) {
        return NounClass::name_or_the;
    }
    if (with_the || (capital && contains(kNamedThe, lower))) {
        return NounClass::named_the;
    }
    if ((capital && !initials) || (!entry.empty() && entry[0] >= '0' && entry[0] <= '9')) {
        return NounClass::name;
    }
    if (is_mass_noun(entry)) {
        return NounClass::mass;
    }
    return looks_plural(entry) ? NounClass::plural : Noun{}.noun_class;
}

}  // namespace

Noun understand_noun(std::string_view entry) {
    Noun noun;
    if (is_no_noun(lower_case(entry))) {
        return {std::string(entry), NounClass::no_noun};
    }
    bool with_the = false;
    bool with_indefinite = false;
    for (const std::string_view article : {"the ", "a ", "an "}) {
        if (lower_case(entry.substr(0, article.size())) == article &&
            entry.size() > article.size()) {
            with_the = article == "the ";
            with_indefinite = !with_the;
            entry.remove_prefix(article.size());
            break;
        }
    }
    noun.text = std::string(entry);
    noun.noun_class = class_of(entry, with_the, with_indefinite);
    return noun;
}

std::vector<std::string> learner_plurals(std::string_view noun) {
    const std::string right = plural_of(noun);
    const std::string base(noun);
    std::vector<std::string> result;
    const auto add = [&](std::string text) {
        if (text != right && text != base &&
            std::find(result.begin(), result.end(), text) == result.end()) {
            result.push_back(std::move(text));
        }
    };
    if (base.empty()) {
        return result;
    }
    add(base + "s");
    add(base + "es");
    add(right + "s");
    return result;
}

}  // namespace fulcrum::dialogue
