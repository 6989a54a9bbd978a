#include "dialogue/speech/sound_dictionary.h"

#include "tests/support/scratch_folder.h"

#include <catch2/catch.hpp>

#include <map>
#include <string>

using namespace fulcrum::dialogue;

namespace {

using Read = std::map<std::string, std::string>;

Expected<int> read_into(std::string_view text, Read& read) {
    return read_sound_dictionary(
        text, [&](std::string_view word, std::string_view sounds) { read.emplace(word, sounds); });
}

std::string fault(std::string_view text) {
    Read read;
    const auto result = read_into(text, read);
    return result ? "" : result.error().message;
}

}  // namespace

TEST_CASE(
    "sound dictionary: words with their sounds; remarks, blank lines and other ends of lines") {
    Read read;
    const auto n = read_into(
        ";; remark\r\napple AE P AH L\r\n\nread R IY D\nread(2) R EH D\n## end\ncafé K AH F EY",
        read);
    REQUIRE(n);
    CHECK(*n == 4);
    CHECK(read == Read{{"apple", "AE P AH L"},
                       {"read", "R IY D"},
                       {"read(2)", "R EH D"},
                       {"café", "K AH F EY"}});
}

TEST_CASE("sound dictionary: what is malformed is refused with its line, in one sentence") {
    struct {
        std::string text, message;
    } const rows[] = {
        {"apple AE P AH L\negg",
         "line 2 has no word with sounds behind it; the file may be cut off there, get it anew"},
        {"apple AE P A",
         "line 1 has \"A\", which is no sound of English; the file may be damaged there, get it "
         "anew"},
        {"apple ",
         "line 1 has no word with sounds behind it; the file may be cut off there, get it anew"},
        {" AE P",
         "line 1 has no word with sounds behind it; the file may be cut off there, get it anew"},
        {"apple AE  P",
         "line 1 has \" \", which is no sound of English; the file may be damaged there, get it "
         "anew"},
        {"apple 사과",
         "line 1 has \"사과\", which is no sound of English; the file may be damaged there, get it "
         "anew"},
        {std::string("apple AE\0P", 10),
         "line 1 has a letter that is no text; save it as plain text, in UTF-8"},
        {std::string("a\0p\0 \0A\0", 8),
         "line 1 has a letter that is no text; save it as plain text, in UTF-8"},
        {"egg EH G\nap\x1b[31mple AE",
         "line 2 has a letter that is no text; save it as plain text, in UTF-8"},
        {std::string(10'000'000, 'a'), "line 1 is longer than 500 letters; write one word a line"},
        {"", "it has no word; get it anew"},
        {";; nothing\n\n", "it has no word; get it anew"},
    };
    for (const auto& row : rows) {
        INFO(row.text.substr(0, 40));
        CHECK(fault(row.text) == row.message);
    }
}

TEST_CASE(
    "sound dictionary: a file that is missing, a folder, and one that is damaged name themselves") {
    const fulcrum::ScratchFolder folder;
    const auto message = [](const std::string& path) {
        const auto opened = open_sound_dictionary(path, [](std::string_view, std::string_view) {});
        return opened ? std::to_string(*opened) : opened.error().message;
    };
    const std::string path = (folder.path() / "words.dict").string();
    CHECK(message(path) == "the dictionary of sounds " + path +
                               " is missing; install the package pocketsphinx-en-us");
    CHECK(message(folder.path().string()) ==
          "the dictionary of sounds " + folder.path().string() +
              " is no file; give one, or install the package pocketsphinx-en-us");
    folder.write("words.dict", "egg EH G\n");
    CHECK(message(path) == "1");
    folder.write("words.dict", "egg EH G \nrock R AA  ");
    CHECK(message(path) == "2");
    folder.write("words.dict", "egg EH G\nrock R A");
    CHECK(message(path).starts_with("the dictionary of sounds " + path + ": line 2 has \"A\""));
}
