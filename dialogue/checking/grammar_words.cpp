#include "dialogue/checking/grammar_words.h"

#include "dialogue/english/opposite.h"
#include "dialogue/english/word_table.h"

#include <array>

namespace fulcrum::dialogue {
namespace {

constexpr auto kArticles = std::to_array<std::string_view>({"a", "an", "the"});
constexpr auto kPossessives =
    std::to_array<std::string_view>({"my", "your", "his", "her", "its", "our", "their"});
constexpr auto kOtherDeterminers = std::to_array<std::string_view>(
    {"this",  "that", "these",   "those", "some",    "any",    "each",
     "every", "no",   "another", "which", "what",    "whose",  "both",
     "all",   "many", "much",    "few",   "several", "either", "neither"});
constexpr auto kModals =
    std::to_array<std::string_view>({"can", "could", "will", "would", "shall", "should", "may",
                                     "might", "must", "cannot", "gonna", "ll"});
constexpr auto kQuestionWords = std::to_array<std::string_view>(
    {"what", "which", "who", "whom", "whose", "why", "where", "when", "how"});
constexpr auto kOtherClosed = std::to_array<std::string_view>(
    {"i",       "you",    "he",       "she",        "it",        "we",      "they",     "me",
     "him",     "us",     "them",     "mine",       "yours",     "hers",    "ours",     "theirs",
     "myself",  "itself", "himself",  "herself",    "one",       "ones",    "be",       "am",
     "is",      "are",    "was",      "were",       "been",      "being",   "do",       "does",
     "did",     "done",   "doing",    "have",       "has",       "had",     "having",   "not",
     "and",     "or",     "but",      "so",         "because",   "if",      "then",     "than",
     "when",    "while",  "although", "though",     "since",     "until",   "unless",   "whether",
     "of",      "in",     "on",       "at",         "to",        "from",    "by",       "with",
     "for",     "about",  "into",     "onto",       "over",      "under",   "above",    "below",
     "near",    "behind", "between",  "through",    "without",   "after",   "before",   "during",
     "against", "around", "off",      "out",        "up",        "down",    "as",       "like",
     "there",   "here",   "very",     "too",        "also",      "just",    "only",     "now",
     "more",    "most",   "less",     "least",      "other",     "others",  "else",     "ever",
     "never",   "always", "often",    "again",      "yes",       "ok",      "okay",     "please",
     "let",     "lets",   "got",      "everything", "something", "nothing", "anything", "everyone",
     "someone", "nobody", "inside",   "outside",    "towards"});
constexpr auto kLinking = std::to_array<std::string_view>(
    {"feel", "look", "sound", "smell", "taste", "seem", "become", "appear"});
constexpr auto kTelling = std::to_array<std::string_view>(
    {"think", "know", "believe", "guess", "said", "say", "says", "thought", "hope", "knew", "felt",
     "mean", "see", "sure", "maybe"});
constexpr auto kStrictlyMass = std::to_array<std::string_view>(
    {"advice",    "information", "furniture",   "luggage", "homework",   "equipment",
     "software",  "hardware",    "knowledge",   "news",    "traffic",    "clothing",
     "jewellery", "jewelry",     "housework",   "gravity", "ransomware", "firmware",
     "music",     "electricity", "punctuation", "money",   "weather"});
constexpr auto kMaterials = std::to_array<std::string_view>(
    {"metal",    "wood",   "plastic",   "rubber",   "glass",   "stone",   "rock",      "iron",
     "steel",    "gold",   "silver",    "copper",   "paper",   "leather", "cotton",    "wool",
     "silk",     "foam",   "clay",      "concrete", "granite", "marble",  "brass",     "bronze",
     "tin",      "bamboo", "cardboard", "cork",     "wax",     "ice",     "sandpaper", "aluminium",
     "aluminum", "velvet", "brick",     "ceramic"});
constexpr auto kCollective = std::to_array<std::string_view>(
    {"people", "police",  "team",       "staff",    "family", "group",  "class",   "data",
     "media",  "crew",    "audience",   "lot",      "number", "couple", "pair",    "rest",
     "series", "species", "government", "majority", "kind",   "sort",   "variety", "band"});
constexpr auto kMorePhysical = std::to_array<std::string_view>(
    {"red",     "blue",    "green",  "yellow",   "white",   "black", "brown", "grey",  "gray",
     "pink",    "purple",  "round",  "bouncy",   "fluffy",  "fuzzy", "furry", "slimy", "shiny",
     "rubbery", "springy", "wooden", "metallic", "elastic", "tiny",  "huge",  "bendy", "spiky",
     "prickly", "grainy",  "icy",    "sandy",    "silky",   "solid", "tough"});
constexpr auto kTimesAndAmounts = std::to_array<std::string_view>(
    {"day",       "time",   "year",    "week",  "month", "hour", "minute", "second",
     "moment",    "night",  "morning", "today", "way",   "bit",  "lot",    "little",
     "little",    "metre",  "meter",   "mile",  "foot",  "inch", "kilo",   "kilometre",
     "kilometer", "reason", "place",   "thing", "kind",  "sort"});
constexpr auto kMonthsAndDays = std::to_array<std::string_view>(
    {"january",   "february",  "march",   "april",    "may",      "june",      "july",
     "august",    "september", "october", "november", "december", "monday",    "tuesday",
     "wednesday", "thursday",  "friday",  "saturday", "sunday",   "christmas", "easter"});
constexpr auto kPlanets = std::to_array<std::string_view>(
    {"mercury", "venus", "mars", "jupiter", "saturn", "uranus", "neptune", "pluto", "ceres"});
constexpr auto kSameInPast =
    std::to_array<std::string_view>({"put", "let", "cut", "hit", "read", "set", "cost", "hurt",
                                     "shut", "beat", "spread", "quit", "bet"});
constexpr auto kLightAdverbs = std::to_array<std::string_view>(
    {"also", "very", "really", "always", "never", "often", "usually", "just", "only", "still", "so",
     "too", "quite", "even", "sometimes", "not", "now", "much"});

}  // namespace

bool is_possessive(std::string_view word) {
    return contains(kPossessives, word);
}

bool is_central_determiner(std::string_view word) {
    return !word.empty() && (contains(kArticles, word) || is_possessive(word));
}

bool is_determiner(std::string_view word) {
    return is_central_determiner(word) || contains(kOtherDeterminers, word);
}

bool is_third_singular(std::string_view word) {
    return word == "it" || word == "he" || word == "she";
}

bool is_other_person(std::string_view word) {
    return word == "i" || word == "you" || word == "we" || word == "they";
}

bool is_modal(std::string_view word) {
    return contains(kModals, word);
}

bool is_question_word(std::string_view word) {
    return contains(kQuestionWords, word);
}

bool is_closed_word(std::string_view word) {
    return is_determiner(word) || is_modal(word) || is_question_word(word) ||
           contains(kOtherClosed, word);
}

bool is_linking_verb(std::string_view base) {
    return contains(kLinking, base);
}

bool is_telling_verb(std::string_view word) {
    return contains(kTelling, word);
}

bool is_same_in_past(std::string_view base) {
    return contains(kSameInPast, base);
}

bool is_strictly_mass(std::string_view noun) {
    return contains(kStrictlyMass, noun);
}

bool is_material(std::string_view noun) {
    return contains(kMaterials, noun);
}

bool is_collective(std::string_view noun) {
    return contains(kCollective, noun);
}

bool is_physical(std::string_view adjective) {
    return contains(kMorePhysical, adjective) || !opposites_of(adjective).empty();
}

bool is_time_or_amount(std::string_view noun) {
    return contains(kTimesAndAmounts, noun);
}

bool is_month_or_day(std::string_view noun) {
    return contains(kMonthsAndDays, noun);
}

bool is_measured(std::string_view word) {
    constexpr auto kMeasured = std::to_array<std::string_view>(
        {"lift", "drag", "weight", "tension", "gravity", "torque", "friction"});
    return contains(kMeasured, word);
}

bool is_planet(std::string_view word) {
    return contains(kPlanets, word);
}

bool is_light_adverb(std::string_view word) {
    return contains(kLightAdverbs, word);
}

}  // namespace fulcrum::dialogue
