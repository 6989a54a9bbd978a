#include "runtime/app/glosses.h"

#include "runtime/app/menu_screen.h"
#include "tests/support/english_words.h"
#include "tests/unit/runtime/rig.h"

using namespace fulcrum::runtime::test;

namespace {

const std::filesystem::path kWords = FULCRUM_SOURCE_DIR "/assets/words";

/// A folder of a lesson with this as its words in Spanish.
void write_words(const std::filesystem::path& folder, const std::string& text) {
    std::filesystem::create_directories(folder / "words");
    std::ofstream(folder / "words" / "es.txt") << text;
}

HomeWords words_in(Language language) {
    HomeWords words(kWords, fulcrum::dialogue::english_words());
    REQUIRE(words.use(language));
    return words;
}

}  // namespace

TEST_CASE(
    "glosses: each word that the catalogue has stands beside the child's own, longer phrases "
    "first") {
    const auto catalogue = fulcrum::dialogue::Catalogue::parse(
        "gloss.heavier = más pesado\ngloss.made = hecho\ngloss.made_of = hecho de\n"
        "gloss.wood = madera\ngloss.apple = manzana\ngloss.egg = huevo\ngloss.egg_plant = x\n");
    REQUIRE(catalogue);
    CHECK(find_glosses("The *Apple* is heavier.", *catalogue) ==
          "apple – manzana · heavier – más pesado");
    CHECK(find_glosses("made of wood, made for an apple", *catalogue) ==
          "made of – hecho de · wood – madera · made – hecho · apple – manzana");
    CHECK(find_glosses("an egg, an apple, an egg: apple!", *catalogue) ==
          "egg – huevo · apple – manzana");
    CHECK(find_glosses("", *catalogue).empty());
    CHECK(find_glosses("Nothing of it.", *catalogue).empty());
    const HomeWords spanish = words_in(Language::spanish);
    const std::string many =
        find_glosses("apple banana egg watermelon bucket heavy", spanish.shown());
    CHECK(std::ranges::count(many, '\xB7') == static_cast<long>(kMostGlosses) - 1);
}

TEST_CASE("glosses: a lesson's own go before the program's, and change with the language") {
    const ScratchFolder scratch;
    write_words(scratch.path(), "title = ¿Qué gema?\ngloss.gem = gema\ngloss.heavier = pesa más\n");
    HomeWords words(kWords, fulcrum::dialogue::english_words());
    Glosses glosses(words, scratch.path());
    CHECK(glosses.of("A gem is heavier than an apple.").empty());
    REQUIRE(words.use(Language::spanish));
    CHECK(glosses.of("A gem is heavier than an apple.") ==
          "gem – gema · heavier – pesa más · than – que · apple – manzana");
    REQUIRE(words.use(Language::english));
    CHECK(glosses.of("A gem is heavier.").empty());
}

TEST_CASE(
    "glosses: a lesson's words that are wrong are one sentence with file and line, and nothing is "
    "lost") {
    const ScratchFolder scratch;
    const std::string file = (scratch.path() / "words" / "es.txt").string();
    const auto error = [&](const std::string& text) {
        write_words(scratch.path(), text);
        const auto words = read_lesson_words(scratch.path(), Language::spanish);
        REQUIRE_FALSE(words);
        return words.error();
    };
    CHECK(error("# mine\ngloss.gem gema\n").where == file + ":2");
    CHECK(error("title = a\n\ngloss.gem = {gema\n").where == file + ":3");
    CHECK(error("title = a\nmenu.back = no\n").where == file + ":2");
    CHECK(error("title = a\nmenu.back = no\n").message.find("menu.back") != std::string::npos);
    CHECK(error("gloss. = no\n").where == file + ":1");
    const HomeWords words = words_in(Language::spanish);
    Glosses glosses(words, scratch.path());
    CHECK(glosses.of("an apple") == "apple – manzana");
    CHECK(read_lesson_words(scratch.path(), Language::korean)->keys().empty());
}

TEST_CASE("glosses: they are shown in a pause and with the answer to a call for help, else not") {
    const HomeWords words = words_in(Language::spanish);
    Glosses glosses(words, {});
    const auto shown = [&](const std::string& said, bool paused) {
        View view;
        view.banner = paused ? "Pausa." : "";
        view.title = "More fruit";
        view.caption = "It is heavier.";
        view.feedback = "You can say: the apple.";
        view.choices.push_back({"the egg", {}});
        show_glosses(said, paused, glosses, view);
        return view;
    };
    const std::string found = "apple – manzana · heavier – más pesado · egg – huevo · more – más";
    CHECK(shown("", true).banner == "Pausa.\n" + found);
    CHECK(shown("", true).feedback == "You can say: the apple.");
    CHECK(shown("I don't know.", false).feedback == "You can say: the apple.\n" + found);
    CHECK(shown("the egg", false).feedback == "You can say: the apple.");
    CHECK(shown("the egg", false).banner.empty());
}

TEST_CASE("glosses: the list has a lesson's own title in the language of the window") {
    LessonCard card;
    card.title = "The gem";
    card.home_titles[Language::spanish] = "La gema";
    const auto title = [&](Language language) {
        return menu_view({card}, {}, fulcrum::dialogue::english_words(), {}, {}, language)
            .menu.at(0)
            .title;
    };
    CHECK(title(Language::spanish) == "La gema");
    CHECK(title(Language::korean) == "The gem");
    CHECK(title(Language::english) == "The gem");
}
