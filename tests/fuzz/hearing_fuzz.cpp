// Any line at all from a program that hears or talks, or to one that hears: read or refused in one sentence, and what was read is written as it is read again.
#include "dialogue/speech/external/hearing_lines.h"
#include "dialogue/speech/external/partner_lines.h"
#include "tests/fuzz/promise.h"

namespace {

using namespace fulcrum::dialogue;

void check(const HearingAnswer& answer) {
    if (const auto* const heard = std::get_if<HeardLine>(&answer)) {
        require(heard->confidence >= 0.0 && heard->confidence <= 1.0);
        require(heard->throat == 0.0 || (heard->throat >= 1.0 && heard->throat <= 2.0));
    }
}

void check(const HearingOrder& /*order*/) {}

// One line, whatever stood in it; written again it is the same.
template <class Read>
void go_round(std::string_view line, const Read& read) {
    const auto first = read(line);
    if (!first) {
        require(!first.error().message.empty());
        require(first.error().message.find('\n') == std::string::npos);
        return;
    }
    check(*first);
    const std::string written = write_line(*first);
    require(written.find('\n') == std::string::npos);
    const auto again = read(written);
    require(again.has_value());
    require(write_line(*again) == written);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const std::string line(reinterpret_cast<const char*>(data), size);
    go_round(line, [](std::string_view text) { return read_answer(text); });
    go_round(line, [](std::string_view text) { return read_order(text); });
    if (const auto said = read_text_line(line)) {
        require(said->text.size() <= 4 * kLongestPartnerText);
        require(said->text.find_first_of("\n\t\x1b\x7f") == std::string::npos);
    }
    return 0;
}
