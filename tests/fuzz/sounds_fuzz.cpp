// Any bytes as a dictionary of sounds: refused in one sentence that names a line, or every word has sounds; and what learners make of its
// words by rule is pronounced or not, without harm.
#include "dialogue/speech/sound_dictionary.h"
#include "dialogue/speech/sphinx/pronunciation.h"
#include "tests/fuzz/promise.h"

#include <functional>
#include <map>
#include <optional>

namespace {

using namespace fulcrum::dialogue;

bool is_plain(std::string_view text) {
    return std::none_of(text.begin(), text.end(), [](char letter) {
        return static_cast<unsigned char>(letter) < ' ' || letter == 0x7F;
    });
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const std::string text(reinterpret_cast<const char*>(data), size);
    std::map<std::string, std::string, std::less<>> sounds;
    const auto read =
        read_sound_dictionary(text, [&](std::string_view word, std::string_view said) {
            require(!word.empty() && word.find(' ') == std::string_view::npos && is_plain(word));
            require(!said.empty() && is_plain(said) && !said.ends_with(' '));
            sounds.emplace(word, said);
        });
    if (!read) {
        require(!read.error().message.empty() && read.error().message.size() < 300);
        require(read.error().message.find('\n') == std::string::npos);
    } else {
        require(*read > 0 && static_cast<std::size_t>(*read) >= sounds.size());
    }
    const LookUp look_up = [&](std::string_view word) -> std::optional<std::string> {
        const auto found = sounds.find(word);
        return found == sounds.end() ? std::nullopt : std::optional<std::string>(found->second);
    };
    int tried = 0;
    for (const auto& [word, said] : sounds) {
        for (const char* ending : {"", "s", "ed", "est", "ly", "ness"}) {
            const auto made = pronounce(word + ending, look_up);
            require(!made || !made->empty());
        }
        if (++tried == 20) {
            break;
        }
    }
    return 0;
}
