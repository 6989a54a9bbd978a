#include "dialogue/speech/sound_dictionary.h"

#include <algorithm>
#include <array>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <system_error>

namespace fulcrum::dialogue {
namespace {

constexpr std::size_t kLongestLine_bytes = 500;
constexpr std::uintmax_t kLargestFile_bytes = 64U << 20U;  // twenty times all of English

/// ARPAbet's sounds, as American English has them.
constexpr auto kSounds = std::to_array<std::string_view>(
    {"AA", "AE", "AH", "AO", "AW", "AY", "B",  "CH", "D", "DH", "EH", "ER", "EY",
     "F",  "G",  "HH", "IH", "IY", "JH", "K",  "L",  "M", "N",  "NG", "OW", "OY",
     "P",  "R",  "S",  "SH", "T",  "TH", "UH", "UW", "V", "W",  "Y",  "Z",  "ZH"});

bool is_sound(std::string_view sound) {
    return std::find(kSounds.begin(), kSounds.end(), sound) != kSounds.end();
}

/// A letter that no line of text has.
bool is_control(char letter) {
    const auto byte = static_cast<unsigned char>(letter);
    return byte < ' ' || byte == 0x7F;
}

/// The first of `sounds` that is none; empty when all are.
std::string_view no_sound(std::string_view sounds) {
    while (!sounds.empty()) {
        const std::size_t end = std::min(sounds.find(' '), sounds.size());
        const std::string_view sound = sounds.substr(0, end);
        if (!is_sound(sound)) {
            return sound.empty() ? std::string_view(" ") : sound;
        }
        sounds.remove_prefix(std::min(end + 1, sounds.size()));
    }
    return {};
}

/// What is wrong with a line that is no remark; empty when nothing is.
std::string fault_of(std::string_view line) {
    if (line.size() > kLongestLine_bytes) {
        return "is longer than 500 letters; write one word a line";
    }
    if (std::any_of(line.begin(), line.end(), is_control)) {
        return "has a letter that is no text; save it as plain text, in UTF-8";
    }
    const std::size_t space = line.find(' ');
    if (space == std::string_view::npos || space == 0 || space + 1 == line.size()) {
        return "has no word with sounds behind it; the file may be cut off there, get it anew";
    }
    if (const std::string_view wrong = no_sound(line.substr(space + 1)); !wrong.empty()) {
        return concat({"has \"", wrong.substr(0, 20),
                       "\", which is no sound of English; the file may be damaged "
                       "there, get it anew"});
    }
    return {};
}

}  // namespace

Expected<int> read_sound_dictionary(std::string_view text, const TakeSounds& take) {
    int n_words = 0;
    for (int number = 1; !text.empty(); ++number) {
        const std::size_t end = std::min(text.find('\n'), text.size());
        std::string_view line = text.substr(0, end);
        text.remove_prefix(std::min(end + 1, text.size()));
        while (line.ends_with('\r') || line.ends_with(' ')) {
            line.remove_suffix(1);
        }
        if (line.empty() || line.starts_with(";;") || line.starts_with("##")) {
            continue;
        }
        if (const std::string fault = fault_of(line); !fault.empty()) {
            return fail(concat({"line ", std::to_string(number), " ", fault}), 0, number);
        }
        const std::size_t space = line.find(' ');
        take(line.substr(0, space), line.substr(space + 1));
        ++n_words;
    }
    if (n_words == 0) {
        return fail("it has no word; get it anew");
    }
    return n_words;
}

Expected<int> open_sound_dictionary(const std::string& path, const TakeSounds& take) {
    const std::string head = concat({"the dictionary of sounds ", path, " "});
    std::error_code error;
    if (!std::filesystem::is_regular_file(path, error)) {
        return fail(head + (std::filesystem::exists(path, error)
                                ? "is no file; give one, or install the package pocketsphinx-en-us"
                                : "is missing; install the package pocketsphinx-en-us"));
    }
    const std::uintmax_t size = std::filesystem::file_size(path, error);
    if (error || size > kLargestFile_bytes) {
        return fail(head + "is larger than 64 MB; install the package pocketsphinx-en-us anew");
    }
    std::ifstream file(path, std::ios::binary);
    const std::string text((std::istreambuf_iterator<char>(file)),
                           std::istreambuf_iterator<char>());
    if (!file || text.size() != size) {
        return fail(head + "cannot be read; look who may read it");
    }
    auto read = read_sound_dictionary(text, take);
    if (!read) {
        return fail(concat({"the dictionary of sounds ", path, ": ", read.error().message}), 0,
                    read.error().line);
    }
    return read;
}

}  // namespace fulcrum::dialogue
