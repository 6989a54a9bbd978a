// fulcrum-sphinx: hears by PocketSphinx, in a process of its own (hearing_lines.h). Ends with its input.
//
//   --middle N --width N   how sure of its ear it is (decoder.h)      --models FOLDER   where the acoustic model and dictionary are
//   --throats N,N,…        how much smaller than a grown-up's the learner's may be (decoder.h); 1: a grown-up
//   --throat N             how much smaller it is, as far as is known: tried first
#include "dialogue/speech/external/hearing_lines.h"
#include "dialogue/speech/sphinx/decoder.h"

#include <algorithm>
#include <charconv>
#include <cstdio>
#include <exception>
#include <iostream>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace {

using namespace fulcrum::dialogue;

constexpr std::size_t kLongestUtterance = 60 * static_cast<std::size_t>(kHeardRate_Hz);

void say(const HearingAnswer& answer) {
    std::cout << write_line(answer) << std::endl;  // at once: somebody waits for it
}

bool take_number(std::string_view text, double& number) {
    const auto read = std::from_chars(text.data(), text.data() + text.size(), number);
    return read.ec == std::errc{} && read.ptr == text.data() + text.size();
}

bool take_numbers(std::string_view text, std::vector<double>& numbers) {
    numbers.clear();
    for (std::size_t at = 0; at <= text.size();) {
        const std::size_t end = std::min(text.find(',', at), text.size());
        if (!take_number(text.substr(at, end - at), numbers.emplace_back())) {
            return false;
        }
        at = end + 1;
    }
    return true;
}

// Before all others, once.
bool take_first(std::string_view text, std::vector<double>& numbers) {
    double first = 0.0;
    if (!take_number(text, first)) {
        return false;
    }
    std::erase(numbers, first);
    numbers.insert(numbers.begin(), first);
    return true;
}

// False for a name that is none, and for a value that is none of it.
bool take_setting(std::string_view name, std::string_view value, DecoderSettings& settings) {
    if (name == "--models") {
        settings.models = value;
        return !value.empty();
    }
    if (name == "--middle" || name == "--width") {
        return take_number(value, name == "--middle" ? settings.middle : settings.width);
    }
    if (name == "--throats") {
        return take_numbers(value, settings.throats);
    }
    return name == "--throat" && take_first(value, settings.throats);
}

Expected<DecoderSettings> read_settings(std::span<char*> words) {
    DecoderSettings settings;
    for (std::size_t i = 1; i < words.size(); i += 2) {
        const std::string_view name = words[i];
        const std::string_view value = i + 1 < words.size() ? words[i + 1] : "";
        if (!take_setting(name, value, settings)) {
            constexpr std::string_view kTakes =
                "; it takes --middle N, --width N, --throats N,N, --throat N and --models FOLDER";
            return fail(concat({"fulcrum-sphinx does not understand ", name, " ", value, kTakes}));
        }
    }
    return settings;
}

// One question at a time.
class Listener {
  public:
    explicit Listener(Decoder& decoder) : decoder_(decoder) {}

    void operator()(const ListenLine& line) {
        question_ = -1;
        heard_.clear();
        const auto unknown = decoder_.listen(line.graph);
        if (!unknown) {
            say(TroubleLine{unknown.error().message});
            return;
        }
        question_ = line.question;
        say(ListeningLine{line.question, *unknown});
    }
    void operator()(const AudioLine& line) {
        if (line.question == question_ && heard_.size() < kLongestUtterance) {
            heard_.insert(heard_.end(), line.samples.begin(), line.samples.end());
        }
    }
    void operator()(const EndLine& line) {
        if (line.question == question_) {
            const Decoded decoded = decoder_.decode(heard_);
            heard_.clear();
            say(HeardLine{line.question, decoded.text, decoded.confidence, decoder_.throat()});
        }
    }
    void operator()(const StopLine& line) {
        if (line.question == question_) {
            question_ = -1;
            heard_.clear();
        }
    }

  private:
    Decoder& decoder_;
    int question_ = -1;
    std::vector<std::int16_t> heard_;
};

int run(std::span<char*> words) {
    const auto settings = read_settings(words);
    if (!settings) {
        std::fprintf(stderr, "%s.\n", settings.error().message.c_str());
        return 2;
    }
    const auto decoder = Decoder::create(*settings);
    if (!decoder) {
        say(TroubleLine{decoder.error().message});
        return 1;
    }
    say(ReadyLine{"pocketsphinx"});
    Listener listener(**decoder);
    for (std::string line; std::getline(std::cin, line);) {
        if (const auto order = read_order(line)) {
            std::visit(listener, *order);
        } else {
            say(TroubleLine{order.error().message});
        }
    }
    return 0;
}

}  // namespace

int main(int argc, char** argv) {
    try {
        return run({argv, static_cast<std::size_t>(argc)});
    } catch (const std::exception& error) {
        std::fprintf(stderr, "fulcrum-sphinx: %s\n", error.what());
        return 1;
    }
}
