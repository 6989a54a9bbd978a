#include "dialogue/english/adjective.h"

#include <catch2/catch.hpp>

#include <algorithm>

using namespace fulcrum::dialogue;

namespace {

// Written by hand from a grammar's rules, not from the program's output. '/' parts forms that are both right.
struct Row {
    const char *positive, *comparative, *superlative;
};
const Row kRows[] = {
    // One syllable.
    {"tall", "taller", "tallest"},
    {"short", "shorter", "shortest"},
    {"long", "longer", "longest"},
    {"old", "older/elder", "oldest/eldest"},
    {"young", "younger", "youngest"},
    {"new", "newer", "newest"},
    {"low", "lower", "lowest"},
    {"slow", "slower", "slowest"},
    {"fast", "faster", "fastest"},
    {"high", "higher", "highest"},
    {"cheap", "cheaper", "cheapest"},
    {"clean", "cleaner", "cleanest"},
    {"cold", "colder", "coldest"},
    {"warm", "warmer", "warmest"},
    {"cool", "cooler", "coolest"},
    {"hard", "harder", "hardest"},
    {"soft", "softer", "softest"},
    {"smooth", "smoother", "smoothest"},
    {"rough", "rougher", "roughest"},
    {"sharp", "sharper", "sharpest"},
    {"blunt", "blunter", "bluntest"},
    {"light", "lighter", "lightest"},
    {"dark", "darker", "darkest"},
    {"bright", "brighter", "brightest"},
    {"small", "smaller", "smallest"},
    {"great", "greater", "greatest"},
    {"quick", "quicker", "quickest"},
    {"thick", "thicker", "thickest"},
    {"strong", "stronger", "strongest"},
    {"weak", "weaker", "weakest"},
    {"loud", "louder", "loudest"},
    {"near", "nearer", "nearest"},
    {"deep", "deeper", "deepest"},
    {"poor", "poorer", "poorest"},
    {"rich", "richer", "richest"},
    {"kind", "kinder", "kindest"},
    {"mild", "milder", "mildest"},
    {"round", "rounder", "roundest"},
    {"steep", "steeper", "steepest"},
    {"stiff", "stiffer", "stiffest"},
    {"tight", "tighter", "tightest"},
    {"full", "fuller", "fullest"},
    {"green", "greener", "greenest"},
    {"brown", "browner", "brownest"},
    {"black", "blacker", "blackest"},
    {"grey", "greyer", "greyest"},
    {"few", "fewer", "fewest"},
    {"calm", "calmer", "calmest"},
    {"broad", "broader", "broadest"},
    {"dull", "duller", "dullest"},
    {"smart", "smarter", "smartest"},
    {"sweet", "sweeter", "sweetest"},
    {"sour", "sourer", "sourest"},
    {"crisp", "crisper", "crispest"},
    {"thin", "thinner", "thinnest"},
    {"big", "bigger", "biggest"},
    {"hot", "hotter", "hottest"},
    {"fat", "fatter", "fattest"},
    {"sad", "sadder", "saddest"},
    {"wet", "wetter", "wettest"},
    {"red", "redder", "reddest"},
    {"flat", "flatter", "flattest"},
    {"slim", "slimmer", "slimmest"},
    {"fit", "fitter", "fittest"},
    {"dim", "dimmer", "dimmest"},
    {"glad", "gladder", "gladdest"},
    {"mad", "madder", "maddest"},
    {"tan", "tanner", "tannest"},
    {"grim", "grimmer", "grimmest"},
    {"hip", "hipper", "hippest"},
    // A final e.
    {"large", "larger", "largest"},
    {"nice", "nicer", "nicest"},
    {"safe", "safer", "safest"},
    {"wide", "wider", "widest"},
    {"late", "later", "latest/last"},
    {"wise", "wiser", "wisest"},
    {"strange", "stranger", "strangest"},
    {"close", "closer", "closest"},
    {"brave", "braver", "bravest"},
    {"pale", "paler", "palest"},
    {"rare", "rarer", "rarest"},
    {"loose", "looser", "loosest"},
    {"huge", "huger", "hugest"},
    {"cute", "cuter", "cutest"},
    {"free", "freer", "freest"},
    {"true", "truer", "truest"},
    {"blue", "bluer", "bluest"},
    {"white", "whiter", "whitest"},
    {"dense", "denser/more dense", "densest/most dense"},
    {"fine", "finer", "finest"},
    // y.
    {"dry", "drier/dryer", "driest/dryest"},
    {"shy", "shyer/shier", "shyest/shiest"},
    {"heavy", "heavier", "heaviest"},
    {"easy", "easier", "easiest"},
    {"happy", "happier", "happiest"},
    {"busy", "busier", "busiest"},
    {"early", "earlier", "earliest"},
    {"funny", "funnier", "funniest"},
    {"dirty", "dirtier", "dirtiest"},
    {"noisy", "noisier", "noisiest"},
    {"pretty", "prettier", "prettiest"},
    {"ugly", "uglier", "ugliest"},
    {"lazy", "lazier", "laziest"},
    {"lucky", "luckier", "luckiest"},
    {"tiny", "tinier", "tiniest"},
    {"shiny", "shinier", "shiniest"},
    {"windy", "windier", "windiest"},
    {"sunny", "sunnier", "sunniest"},
    {"cloudy", "cloudier", "cloudiest"},
    {"rainy", "rainier", "rainiest"},
    {"icy", "icier", "iciest"},
    {"bumpy", "bumpier", "bumpiest"},
    {"rocky", "rockier", "rockiest"},
    {"sticky", "stickier", "stickiest"},
    {"slippery", "more slippery/slipperier", "most slippery/slipperiest"},
    {"silly", "sillier", "silliest"},
    {"hungry", "hungrier", "hungriest"},
    {"thirsty", "thirstier", "thirstiest"},
    {"angry", "angrier", "angriest"},
    {"crazy", "crazier", "craziest"},
    {"healthy", "healthier", "healthiest"},
    {"wealthy", "wealthier", "wealthiest"},
    {"sleepy", "sleepier", "sleepiest"},
    {"dusty", "dustier", "dustiest"},
    {"fluffy", "fluffier", "fluffiest"},
    {"juicy", "juicier", "juiciest"},
    {"tasty", "tastier", "tastiest"},
    {"grey-green", "more grey-green", "most grey-green"},
    {"unhappy", "unhappier/more unhappy", "unhappiest/most unhappy"},
    // Both.
    {"quiet", "quieter/more quiet", "quietest/most quiet"},
    {"clever", "cleverer/more clever", "cleverest/most clever"},
    {"simple", "simpler/more simple", "simplest/most simple"},
    {"gentle", "gentler/more gentle", "gentlest/most gentle"},
    {"narrow", "narrower/more narrow", "narrowest/most narrow"},
    {"shallow", "shallower/more shallow", "shallowest/most shallow"},
    {"friendly", "friendlier/more friendly", "friendliest/most friendly"},
    {"lovely", "lovelier/more lovely", "loveliest/most lovely"},
    {"polite", "politer/more polite", "politest/most polite"},
    {"common", "commoner/more common", "commonest/most common"},
    {"stupid", "stupider/more stupid", "stupidest/most stupid"},
    {"cruel", "crueler/more cruel", "cruelest/most cruel"},
    {"tired", "more tired/tireder", "most tired/tiredest"},
    {"bitter", "bitterer/more bitter", "bitterest/most bitter"},
    // more, most.
    {"famous", "more famous", "most famous"},
    {"useful", "more useful", "most useful"},
    {"careful", "more careful", "most careful"},
    {"modern", "more modern", "most modern"},
    {"boring", "more boring", "most boring"},
    {"bored", "more bored", "most bored"},
    {"crowded", "more crowded", "most crowded"},
    {"careless", "more careless", "most careless"},
    {"massive", "more massive", "most massive"},
    {"distant", "more distant", "most distant"},
    {"giant", "more giant", "most giant"},
    {"golden", "more golden", "most golden"},
    {"wooden", "more wooden", "most wooden"},
    {"fragile", "more fragile", "most fragile"},
    {"rapid", "more rapid", "most rapid"},
    {"fun", "more fun", "most fun"},
    {"real", "more real", "most real"},
    {"beautiful", "more beautiful", "most beautiful"},
    {"expensive", "more expensive", "most expensive"},
    {"difficult", "more difficult", "most difficult"},
    {"interesting", "more interesting", "most interesting"},
    {"dangerous", "more dangerous", "most dangerous"},
    {"important", "more important", "most important"},
    {"comfortable", "more comfortable", "most comfortable"},
    {"delicious", "more delicious", "most delicious"},
    {"popular", "more popular", "most popular"},
    {"powerful", "more powerful", "most powerful"},
    {"magnetic", "more magnetic", "most magnetic"},
    {"elastic", "more elastic", "most elastic"},
    {"transparent", "more transparent", "most transparent"},
    {"flexible", "more flexible", "most flexible"},
    {"colourful", "more colourful", "most colourful"},
    {"intelligent", "more intelligent", "most intelligent"},
    {"enormous", "more enormous", "most enormous"},
    // Irregular.
    {"good", "better", "best"},
    {"bad", "worse", "worst"},
    {"far", "farther/further", "farthest/furthest"},
    {"little", "less/littler", "least/littlest"},
    {"many", "more", "most"},
    {"much", "more", "most"},
};

std::vector<std::string> split(std::string text) {
    std::vector<std::string> parts;
    for (std::size_t bar; (bar = text.find('/')) != std::string::npos; text.erase(0, bar + 1)) {
        parts.push_back(text.substr(0, bar));
    }
    parts.push_back(text);
    return parts;
}

}  // namespace

TEST_CASE(
    "adjective: a table of comparatives and superlatives, both forms where English has both") {
    REQUIRE(std::size(kRows) >= 150);
    for (const Row& row : kRows) {
        INFO(row.positive);
        CHECK(degree_forms(row.positive, Degree::comparative) == split(row.comparative));
        CHECK(degree_forms(row.positive, Degree::superlative) == split(row.superlative));
    }
}

TEST_CASE("adjective: the positive degree is the word itself, and nothing has no degrees") {
    CHECK(degree_forms("heavy", Degree::positive) == std::vector<std::string>{"heavy"});
    CHECK(degree_forms("", Degree::superlative) == std::vector<std::string>{""});
    CHECK(with_ending("", "er").empty());
    CHECK(learner_forms("", Degree::comparative).empty());
    CHECK(learner_forms("", Degree::positive).empty());
}

TEST_CASE("adjective: how it is compared") {
    CHECK(comparison_of("heavy") == Comparison::ending);
    CHECK(comparison_of("quiet") == Comparison::both);
    CHECK(comparison_of("beautiful") == Comparison::more_most);
    CHECK(comparison_of("good") == Comparison::irregular);
}

TEST_CASE("adjective: syllables of words of lessons") {
    const std::pair<const char*, int> rows[] = {
        {"big", 1},       {"large", 1},       {"heavy", 2},   {"simple", 2}, {"quiet", 2},
        {"free", 1},      {"tired", 1},       {"crowded", 2}, {"giant", 2},  {"beautiful", 3},
        {"expensive", 3}, {"interesting", 4}, {"dry", 1},     {"yellow", 2}, {"smooth", 1},
        {"cruel", 2},     {"special", 2},     {"a", 1},       {"", 1}};
    for (const auto& [word, count] : rows) {
        INFO(word);
        CHECK(syllables(word) == count);
    }
}
