// Any sound and any course of keys: what the gate cuts out is no longer than it may be, and nothing of what it must not hear. The first bytes
// are the settings, then a byte of state and a scale stand before each block of samples.
#include "dialogue/speech/word_graph.h"
#include "runtime/hearing/utterance_gate.h"
#include "tests/fuzz/promise.h"

namespace {

using namespace fulcrum::runtime;

constexpr std::size_t kSettings = 4;
constexpr std::size_t kBytesABlock = 18;  // state, scale and eight samples that are repeated

GateSettings settings_of(const std::uint8_t* data) {
    GateSettings settings;
    settings.mode = (data[0] & 1U) != 0 ? ListenMode::always : ListenMode::hold;
    settings.before_s = 2.0 * data[1] / 255.0;
    settings.pause_s = 0.1 + 1.9 * data[2] / 255.0;
    settings.most_s = 1.0 + 2.0 * data[3] / 255.0;
    return settings;
}

std::array<std::int16_t, kBlock> block_of(const std::uint8_t* data) {
    std::array<std::int16_t, kBlock> block{};
    for (std::size_t i = 0; i < block.size(); ++i) {
        const std::size_t at = 2 + 2 * (i % 8);
        const auto raw = static_cast<std::int16_t>(data[at] | (data[at + 1] << 8));
        block[i] = static_cast<std::int16_t>(raw >> (data[1] % 16));
    }
    return block;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    if (size < kSettings) {
        return 0;
    }
    const GateSettings settings = settings_of(data);
    require(validate(settings).has_value());
    UtteranceGate gate(settings);
    // Before, what was spoken, and behind it a pause or what comes when the key is up already.
    const double longest_s =
        settings.most_s + 2.0 * settings.before_s + settings.pause_s + settings.release_s + 0.1;
    const auto longest = static_cast<std::size_t>(longest_s * fulcrum::dialogue::kHeardRate_Hz);
    for (std::size_t at = kSettings; at + kBytesABlock <= size; at += kBytesABlock) {
        const std::uint8_t state = data[at];
        const GateInput input{
            .wanted = (state & 1U) != 0, .held = (state & 2U) != 0, .speaks = (state & 4U) != 0};
        // Up to sixteen blocks alike, so that a short input is a long time.
        for (int i = 0; i <= state >> 4U; ++i) {
            const auto block = block_of(data + at);
            const auto utterance = gate.step(block, input);
            require(!(gate.hears() && (!input.wanted || input.speaks)));
            if (utterance) {
                require(input.wanted && !input.speaks);
                require(utterance->size() <= longest);
            }
        }
    }
    return 0;
}
