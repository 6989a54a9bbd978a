#include "runtime/app/home_words.h"

#include "runtime/app/glosses.h"
#include "runtime/render/overlay/menu.h"
#include "runtime/render/overlay/panels.h"
#include "runtime/render/text/fallback_font.h"
#include "runtime/text/utf8.h"
#include "tests/support/english_words.h"
#include "tests/unit/runtime/render/overlay/overlay_fixture.h"
#include "tests/unit/runtime/rig.h"

using namespace fulcrum::runtime::test;

namespace {

const std::filesystem::path kWords = FULCRUM_SOURCE_DIR "/assets/words";
constexpr std::array kOthers{Language::spanish, Language::korean};

/// A text as it stands in the file, with each slot as it is written: {name}.
std::string raw(const fulcrum::dialogue::Catalogue& words, const std::string& key) {
    fulcrum::dialogue::CatalogueSlots slots;
    static const std::array<const char*, 29> kSlots{
        "n",      "of",    "sentence", "rule",    "gap",      "again",  "said",   "asked",
        "then",   "right", "next",     "frame",   "choices",  "base",   "answer", "example",
        "phrase", "name",  "minutes",  "newtons", "metres",   "torque", "felt",   "true",
        "key",    "leave", "keys",     "things",  "direction"};
    for (const char* slot : kSlots) {
        slots.emplace_back(slot, "{" + std::string(slot) + "}");
    }
    for (const char* slot : {"number", "first", "text", "title", "words"}) {
        slots.emplace_back(slot, "{" + std::string(slot) + "}");
    }
    return words.say(key, slots);
}

std::set<std::string> slots_of(const std::string& text) {
    std::set<std::string> slots;
    for (std::size_t at = text.find('{'); at != std::string::npos; at = text.find('{', at + 1)) {
        slots.insert(text.substr(at, text.find('}', at) + 1 - at));
    }
    return slots;
}

bool ends_in(const std::string& key, const char* ending) {
    return key.ends_with(ending);
}

fulcrum::dialogue::Catalogue words_in(Language language) {
    auto words = read_words(kWords, language);
    REQUIRE(words);
    return std::move(*words);
}

/// What a key's slots hold at most, in a picture.
std::string filled(const fulcrum::dialogue::Catalogue& words, const std::string& key) {
    return words.say(key, {{"name", "Maximiliane"},
                           {"minutes", "15"},
                           {"key", "Control"},
                           {"keys", "W, A, S, D"},
                           {"leave", "Escape"},
                           {"text", "Yes. A watermelon is the heaviest."},
                           {"sentence", "lesson.lua:12: there is no such model; mend that line."},
                           {"title", "Which fruit is the heaviest?"},
                           {"things", "the sponge, the pillow"},
                           {"said", "the watermelon is the heaviest"},
                           {"number", "2"},
                           {"n", "12"},
                           {"of", "12"},
                           {"right", "10"},
                           {"words", "is, the heaviest, are"},
                           {"newtons", "12.5"},
                           {"metres", "0.25"},
                           {"torque", "3.1"},
                           {"felt", "12.5"},
                           {"true", "12.5"},
                           {"direction", "up"},
                           {"first", "up"},
                           {"next", "left"}});
}

}  // namespace

TEST_CASE(
    "languages: each catalogue has every key with the same slots, and no text that was left "
    "English") {
    const auto english = fulcrum::dialogue::english_words();
    // Names, signs and units; and what Spanish and English write alike.
    const std::set<std::string> alike{
        "list.comma",           "menu.title",           "settings.language.en",
        "settings.language.es", "settings.language.ko", "hud.force",
        "hud.torque",           "hud.why_share",        "hud.why_field",
        "language.plurals",     "settings.voice.usual", "settings.contrast.usual",
        "settings.motion.usual"};
    for (const Language language : kOthers) {
        const auto words = words_in(language);
        const bool has_one = words.say("language.plurals") == "one other";
        CHECK(has_one == (language == Language::spanish));
        for (const std::string& key : english.keys()) {
            INFO(code_of(language) << ": " << key);
            if (ends_in(key, ".one") && english.has(key.substr(0, key.size() - 3) + "other")) {
                CHECK(words.has(key) == has_one);
            } else {
                CHECK(words.has(key));
            }
            if (words.has(key)) {
                CHECK(slots_of(raw(words, key)) == slots_of(raw(english, key)));
                CHECK((raw(words, key) != raw(english, key) || alike.count(key) == 1));
            }
        }
        for (const std::string& key : words.keys()) {
            INFO(code_of(language) << ": " << key);
            CHECK((english.has(key) || key.starts_with("gloss.")));
        }
    }
}

TEST_CASE("languages: the same words have a gloss in each") {
    const auto glosses_in = [](Language language) {
        std::vector<std::string> keys = words_in(language).keys();
        std::erase_if(keys, [](const std::string& key) { return !key.starts_with("gloss."); });
        return keys;
    };
    const auto spanish = glosses_in(Language::spanish);
    CHECK(spanish.size() >= 100);
    CHECK(spanish == glosses_in(Language::korean));
}

TEST_CASE("languages: a number takes the form that its language has") {
    const auto minutes = [](Language language, long n) {
        return words_in(language).say_counted("menu.minutes", n, {{"minutes", std::to_string(n)}});
    };
    CHECK(minutes(Language::english, 1) == "1 minute");
    CHECK(minutes(Language::english, 0) == "0 minutes");
    CHECK(minutes(Language::spanish, 1) == "1 minuto");
    CHECK(minutes(Language::spanish, 5) == "5 minutos");
    CHECK(minutes(Language::korean, 1) == "1분");
}

TEST_CASE("languages: a locale's name says which, and English is for all others") {
    CHECK(find_language("ko_KR.UTF-8") == Language::korean);
    CHECK(find_language("es") == Language::spanish);
    CHECK(find_language("es@euro") == Language::spanish);
    for (const char* other : {"", "C", "de_DE.UTF-8", "esperanto", "kok_IN", "en_GB"}) {
        CHECK(find_language(other) == Language::english);
    }
}

TEST_CASE(
    "languages: the words change in their place; what cannot be read is English, with the reason") {
    const ScratchFolder scratch;
    const std::filesystem::path& folder = scratch.path();
    std::ofstream(folder / "es.txt") << "menu.back = Volver\n";
    std::ofstream(folder / "ko.txt") << "menu.back\n";
    HomeWords words(folder, fulcrum::dialogue::english_words());
    const fulcrum::dialogue::Catalogue& shown = words.shown();
    REQUIRE(words.use(Language::spanish));
    CHECK(shown.say("menu.back") == "Volver");
    CHECK(words.english().say("menu.back") == "Back");
    // What a catalogue lacks is English rather than nothing.
    CHECK(shown.say("menu.choose") == "Choose a lesson.");
    const auto used = words.use(Language::korean);
    REQUIRE_FALSE(used);
    CHECK(words.language() == Language::english);
    CHECK(shown.say("menu.back") == "Back");
    if (find_font_with(U"한", false)) {
        CHECK(used.error().where == (folder / "ko.txt").string() + ":1");
    } else {
        CHECK(used.error().what_to_do.find("fonts-nanum") != std::string::npos);
    }
}

TEST_CASE("languages: every text fits where it stands, at 1280 x 720 and 960 x 540") {
    Font font = andika();
    const auto check_whole = [](const Paragraph& words) { CHECK_FALSE(words.shortened); };
    for (const Language language : {Language::english, Language::spanish, Language::korean}) {
        if (language == Language::korean && !find_font_with(U"한", false)) {
            WARN("skipped: no font has Korean letters; the package fonts-nanum is missing");
            continue;
        }
        const auto words = words_in(language);
        for (const auto& [width, height] : {std::pair{1280, 720}, {960, 540}}) {
            const Measure measure(width, height);
            for (const std::string& key : words.keys()) {
                INFO(code_of(language) << ", " << width << " x " << height << ": " << key);
                const std::string text = filled(words, key);
                View view;
                if (key.starts_with("settings.") || key.starts_with("picture.") ||
                    key.starts_with("menu.minutes") || key == "menu.back" || key == "menu.guest") {
                    // As many cards as there are at most where these words stand.
                    const std::size_t dots =
                        static_cast<std::size_t>(std::count(key.begin(), key.end(), '.'));
                    for (int i = 0; i < 13; ++i) {
                        ViewMenuItem item;
                        item.icon = "apple";
                        (dots == 2 ? item.subtitle : item.title) =
                            (key.starts_with("menu.minutes") ? "A1 · " : "") + text;
                        view.menu.push_back(item);
                    }
                    const MenuLayout layout =
                        lay_out_menu(view, measure, std::vector<runtime::Box>{});
                    REQUIRE_FALSE(layout.cards.empty());
                    const CardWords card = set_card_words(view, layout.cards[0], font, measure);
                    check_whole(card.title);
                    check_whole(card.subtitle);
                    continue;
                }
                view = busy();
                if (key.starts_with("hud.way_") || key.starts_with("hud.why_")) {
                    view.feedback.clear();
                    view.why.visible = true;
                    view.why.title = words.say("hud.why");
                    view.why.shares = {{text, text, 0.5, false}};
                    if (key == "hud.why_help" || key == "hud.why_of") {
                        view.why.shares.clear();
                        view.why.title = text;
                    } else if (!key.starts_with("hud.way_") && key != "hud.why_share") {
                        view.why.shares[0].amount =
                            key == "hud.why_nothing"
                                ? std::string()
                                : words.say("hud.why_share",
                                            {{"newtons", "12.5"},
                                             {"direction",
                                              words.say("hud.way_and",
                                                        {{"first", words.say("hud.way_left")},
                                                         {"next", words.say("hud.way_up")}})}});
                    } else {
                        view.why.shares[0].name = "it";
                    }
                } else if (key.find(".way.") != std::string::npos ||
                           key.find("_way.") != std::string::npos ||
                           key.find("stronger.") != std::string::npos || key == "end.next" ||
                           key == "end.menu" || key == "end.play_again") {
                    view.choices.assign(6, {text, {}});
                } else if (key.starts_with("end.")) {
                    view.stars = 3;
                    view.feedback.clear();
                    view.caption.clear();
                    view.end_note = text;
                } else if (key.starts_with("first_use.") || key.starts_with("who.") ||
                           key.starts_with("menu.")) {
                    view.caption = text;
                } else if (key.starts_with("hud.") || key.starts_with("banner.")) {
                    view.banner = text;
                    view.microphone.visible = true;
                    view.microphone.words = text;
                } else {
                    view.feedback = text;
                }
                const PanelLayout layout = lay_out_panels(view, font, measure);
                for (const Panel* panel :
                     {&layout.banner, &layout.feedback, &layout.caption, &layout.stars}) {
                    check_whole(panel->words);
                    check_whole(panel->second);
                }
                for (const Panel& choice : layout.choices) {
                    check_whole(choice.words);
                }
                check_whole(layout.why.title);
                for (const auto& row : layout.why.rows) {
                    check_whole(row.name);
                    check_whole(row.amount);
                }
                check_apart(layout.shown(), measure);
            }
            // The longest glosses, where they are shown.
            std::vector<std::string> glosses;
            for (const std::string& key : words.keys()) {
                if (key.starts_with("gloss.")) {
                    glosses.push_back(key.substr(6));
                    std::ranges::replace(glosses.back(), '_', ' ');
                }
            }
            std::ranges::sort(glosses, std::greater<>(), [&](const std::string& word) {
                return find_glosses(word, words).size();
            });
            if (!glosses.empty()) {
                std::string line;
                for (std::size_t i = 0; i < kMostGlosses; ++i) {
                    line += glosses[i] + ", ";
                }
                View view = busy();
                view.banner = filled(words, "hud.paused") + "\n" + find_glosses(line, words);
                view.feedback =
                    "You can say: the *apple* or the *egg*.\n" + find_glosses(line, words);
                const PanelLayout layout = lay_out_panels(view, font, measure);
                CHECK_FALSE(layout.banner.words.shortened);
                CHECK_FALSE(layout.feedback.words.shortened);
                check_apart(layout.shown(), measure);
            }
            // A hint in the answer line is smaller where it is long, but can be read.
            for (const char* key : {"hud.type_here", "hud.ask_here", "hud.choose_here", "hud.speak",
                                    "hud.hold_to_speak", "hud.listen_first"}) {
                INFO(code_of(language) << ", " << width << " x " << height << ": " << key);
                View view;
                view.input_visible = true;
                view.microphone.visible = true;
                view.microphone.words = filled(words, key);
                CHECK(lay_out_panels(view, font, measure).input.words.size_px >= 12);
            }
        }
    }
}

TEST_CASE("languages: no letter of a catalogue is drawn as the sign for a missing one") {
    Font font = andika();
    const auto missing = font.shape(Face::regular, U"\uFFFD", false).at(0);
    for (const Language language : {Language::english, Language::spanish, Language::korean}) {
        if (language == Language::korean && !find_font_with(U"한", false)) {
            WARN("skipped: no font has Korean letters; the package fonts-nanum is missing");
            continue;
        }
        const auto words = words_in(language);
        for (const std::string& key : words.keys()) {
            for (const Face face : {Face::regular, Face::bold}) {
                for (const TextLine& line :
                     set_text(font, plain_text(filled(words, key)), {24, face}).lines) {
                    for (const PlacedLetter& letter : line.letters) {
                        INFO(code_of(language) << ": " << key);
                        CHECK((letter.shaped.glyph != 0 && (letter.shaped.face != missing.face ||
                                                            letter.shaped.glyph != missing.glyph)));
                    }
                }
            }
        }
    }
}
