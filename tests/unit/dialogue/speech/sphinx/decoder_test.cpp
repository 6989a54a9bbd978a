// What the decoder hears stands in tests/unit/runtime/hearing, where there are voices.
#include "dialogue/speech/sphinx/decoder.h"

#include "tests/support/scratch_folder.h"

#include <catch2/catch.hpp>

#include <cmath>
#include <filesystem>
#include <limits>

using namespace fulcrum::dialogue;

namespace {

Decoder& shared_decoder() {
    static const std::unique_ptr<Decoder> kDecoder = Decoder::create({}).value();
    return *kDecoder;
}

WordGraph one_way(const std::vector<std::string>& words) {
    WordGraph graph;
    graph.words = words;
    graph.nodes = static_cast<int>(words.size()) + 1;
    for (int i = 0; i + 1 < graph.nodes; ++i) {
        graph.arcs.push_back({i, i + 1, i, 1.0});
    }
    return graph;
}

}  // namespace

TEST_CASE("sphinx decoder: settings and models that are not there are refused in one sentence") {
    CHECK(validate(DecoderSettings{}));
    CHECK_FALSE(validate(DecoderSettings{.width = 0.0}));
    CHECK_FALSE(validate(DecoderSettings{.middle = std::numeric_limits<double>::quiet_NaN()}));
    CHECK_FALSE(validate(DecoderSettings{.width = std::numeric_limits<double>::infinity()}));
    CHECK_FALSE(validate(DecoderSettings{.throats = {}}));
    CHECK_FALSE(validate(DecoderSettings{.throats = {1.0, 0.5}}));
    CHECK_FALSE(validate(DecoderSettings{.throats = {std::numeric_limits<double>::quiet_NaN()}}));
    CHECK_FALSE(validate(DecoderSettings{.throats = std::vector<double>(17, 1.0)}));
    // A dictionary that is cut off: PocketSphinx itself would end the process.
    const fulcrum::ScratchFolder folder;
    std::filesystem::create_directories(folder.path() / "en-us");
    folder.write("en-us/mdef", "");
    folder.write("en-us-phone.lm.bin", "");
    folder.write("cmudict-en-us.dict", "egg EH G\nrock R A");
    const auto cut_off = Decoder::create({.models = folder.path().string()});
    REQUIRE_FALSE(cut_off);
    CHECK(cut_off.error().message.find("line 2 has \"A\"") != std::string::npos);
    const auto missing = Decoder::create({.models = "/no/such/folder"});
    REQUIRE_FALSE(missing);
    CHECK(missing.error().message.find("install the package pocketsphinx-en-us") !=
          std::string::npos);
}

TEST_CASE(
    "sphinx decoder: words that nobody knows are told, and a graph without a way is refused") {
    Decoder& decoder = shared_decoder();
    const auto all = decoder.listen(one_way({"the", "egg", "goodest"}));
    REQUIRE(all);
    CHECK(all->empty());
    WordGraph with_unknown = one_way({"the", "egg"});
    with_unknown.words.emplace_back("zyzzyvaq");
    with_unknown.arcs.push_back({0, 1, 2, 1.0});
    CHECK(decoder.listen(with_unknown).value() == std::vector<std::string>{"zyzzyvaq"});
    CHECK_FALSE(decoder.listen(one_way({"the", "zyzzyvaq"})));
    CHECK_FALSE(decoder.listen({}));
    for (const WordGraph::Arc& bad : {WordGraph::Arc{0, 5, 0, 1.0},
                                      {-1, 1, 0, 1.0},
                                      {0, 1, 9, 1.0},
                                      {0, 1, 0, 0.0},
                                      {0, 1, 0, 2.0}}) {
        WordGraph graph = one_way({"the", "egg"});
        graph.arcs.push_back(bad);
        CHECK_FALSE(decoder.listen(graph));
    }
}

TEST_CASE("sphinx decoder: silence, noise and nothing are not taken for an answer") {
    Decoder& decoder = shared_decoder();
    const std::vector<std::int16_t> silence(16000, 0);
    // Before anything is listened for.
    CHECK_FALSE(decoder.listen({}));
    CHECK(decoder.decode(silence).text.empty());
    REQUIRE(decoder.listen(one_way({"the", "watermelon", "is", "the", "heaviest"})));
    CHECK(decoder.decode({}).confidence == 0.0);
    CHECK(decoder.decode(silence).confidence < 0.4);
    std::vector<std::int16_t> noise(16000);
    std::uint32_t state = 1;
    for (std::int16_t& sample : noise) {
        state = state * 1664525U + 1013904223U;
        sample = static_cast<std::int16_t>(static_cast<int>(state >> 18U) - 8192);
    }
    CHECK(decoder.decode(noise).confidence < 0.4);
    CHECK(std::isfinite(decoder.decode(noise).difference));
}
