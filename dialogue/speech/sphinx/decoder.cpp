#include "dialogue/speech/sphinx/decoder.h"

#include "dialogue/speech/sound_dictionary.h"
#include "dialogue/speech/sphinx/noise_floor.h"
#include "dialogue/speech/sphinx/pronunciation.h"
#include "dialogue/speech/sphinx/quieten.h"
#include "dialogue/speech/sphinx/stretch.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <pocketsphinx.h>
#include <ps_search.h>
#include <sphinxbase/err.h>
#include <sphinxbase/fsg_model.h>

namespace fulcrum::dialogue {
namespace {

constexpr const char* kGraphName = "question";
constexpr double kNoisyRoom_dB = 36.0;  // from here on the allowance grows
constexpr double kNoisyRange_dB = 5.0;  // until it is whole
constexpr double kLoudRoom_dB = 28.0;   // from here on the noise is taken out
constexpr double kSilence_s = 0.3;      // before and behind, for what was cut close

struct FreeDecoder {
    void operator()(ps_decoder_t* decoder) const { ps_free(decoder); }
};
using Engine = std::unique_ptr<ps_decoder_t, FreeDecoder>;

// Options by name and value; the library copies them.
Engine make_engine(const std::vector<std::string>& options) {
    std::vector<std::string> words{"fulcrum"};
    words.insert(words.end(), options.begin(), options.end());
    std::vector<char*> pointers;
    pointers.reserve(words.size());
    for (std::string& word : words) {
        pointers.push_back(word.data());
    }
    cmd_ln_t* const config = cmd_ln_parse_r(nullptr, ps_args(), static_cast<int>(pointers.size()),
                                            pointers.data(), TRUE);
    if (config == nullptr) {
        return {};
    }
    Engine engine(ps_init(config));
    cmd_ln_free_r(config);
    return engine;
}

// The score of a whole utterance, and its words.
struct Scored {
    std::string text;
    double per_frame = 0.0;
    bool fits = false;
};

Scored score(ps_decoder_t* engine, std::span<const std::int16_t> sound) {
    if (ps_start_stream(engine) < 0 || ps_start_utt(engine) < 0) {
        return {};
    }
    ps_process_raw(engine, sound.data(), sound.size(), FALSE, TRUE);
    if (ps_end_utt(engine) < 0) {
        return {};
    }
    std::int32_t total = 0;
    const char* const text = ps_get_hyp(engine, &total);
    const int frames = ps_get_n_frames(engine);
    if (text == nullptr || *text == '\0' || frames <= 0) {
        return {};
    }
    return {text, static_cast<double>(total) / frames, true};
}

// Whether the end can still be reached by what is left of the arcs; a graph's arcs go upwards.
bool has_way(const WordGraph& graph, const std::vector<bool>& is_known) {
    std::vector<bool> reached(static_cast<std::size_t>(graph.nodes), false);
    reached[0] = true;
    for (bool grows = true; grows;) {
        grows = false;
        for (const WordGraph::Arc& arc : graph.arcs) {
            const bool can = arc.word == kNone || is_known[static_cast<std::size_t>(arc.word)];
            if (can && reached[static_cast<std::size_t>(arc.from)] &&
                !reached[static_cast<std::size_t>(arc.to)]) {
                reached[static_cast<std::size_t>(arc.to)] = grows = true;
            }
        }
    }
    return reached.back();
}

bool is_whole(const WordGraph& graph) {
    const auto in = [](int i, std::size_t n) { return i >= 0 && static_cast<std::size_t>(i) < n; };
    return graph.nodes >= 2 && std::ranges::all_of(graph.arcs, [&](const WordGraph::Arc& arc) {
               const auto n = static_cast<std::size_t>(graph.nodes);
               return in(arc.from, n) && in(arc.to, n) && arc.weight > 0.0 && arc.weight <= 1.0 &&
                      (arc.word == kNone || in(arc.word, graph.words.size()));
           });
}

}  // namespace

struct Decoder::Engines {
    DecoderSettings settings;
    Engine graph;
    Engine sounds;
    bool listens = false;
    double throat = 1.0;  // the learner's

    Engines() = default;
    Engines(const Engines&) = delete;
    Engines& operator=(const Engines&) = delete;
    // The loop of sounds lets go of what it heard last only when it begins anew.
    ~Engines() {
        if (sounds && ps_start_utt(sounds.get()) >= 0) {
            ps_end_utt(sounds.get());
        }
    }

    // As a grown-up of a throat so much larger would have said it, in a quiet room or not.
    [[nodiscard]] Decoded decode(std::span<const std::int16_t> sound, double size,
                                 bool is_quiet) const {
        const std::vector<std::int16_t> slower = stretch(sound, size);
        // Silence beside a room's noise would be taken for the room.
        const auto n_silent =
            is_quiet ? static_cast<std::size_t>(kSilence_s * kHeardRate_Hz) : std::size_t{0};
        std::vector<std::int16_t> padded(slower.size() + 2 * n_silent, 0);
        std::ranges::copy(slower, padded.begin() + static_cast<std::ptrdiff_t>(n_silent));
        const Scored of_graph = score(graph.get(), padded);
        const Scored of_sounds = score(sounds.get(), padded);
        if (!of_graph.fits || !of_sounds.fits) {
            return {};
        }
        return {of_graph.text, 0.0, of_graph.per_frame - of_sounds.per_frame, size};
    }

    // Knows the word, or has it taught by the rules of pronunciation.
    [[nodiscard]] bool teach(const std::string& word) const {
        const LookUp look_up = [this](std::string_view text) -> std::optional<std::string> {
            char* const found = ps_lookup_word(graph.get(), std::string(text).c_str());
            if (found == nullptr) {
                return {};
            }
            std::optional<std::string> known(found);
            std::free(found);  // NOLINT(cppcoreguidelines-no-malloc): the library's
            return known;
        };
        if (look_up(word)) {
            return true;
        }
        const auto by_rule = pronounce(word, look_up);
        return by_rule && ps_add_word(graph.get(), word.c_str(), by_rule->c_str(), TRUE) >= 0;
    }
};

Expected<bool> validate(const DecoderSettings& settings) {
    const bool good = std::abs(settings.middle) <= 100.0 && settings.width >= 0.01 &&
                      settings.width <= 100.0 && settings.noise_allowance >= 0.0 &&
                      settings.noise_allowance <= 10.0;
    if (!good) {
        return fail(
            "the recogniser's middle is from -100 to 100, its width from 0.01 to 100, its "
            "allowance for noise from 0 to 10");
    }
    constexpr std::size_t kMostThroats = 16;
    const bool are_throats = std::ranges::all_of(
        settings.throats, [](double size) { return size >= 1.0 && size <= kMostStretch; });
    if (settings.throats.empty() || settings.throats.size() > kMostThroats || !are_throats) {
        return fail("the recogniser tries 1 to 16 throats, each from 1 to 2");
    }
    return true;
}

Decoder::Decoder(std::unique_ptr<Engines> engines) : engines_(std::move(engines)) {}
Decoder::~Decoder() = default;

Expected<std::unique_ptr<Decoder>> Decoder::create(const DecoderSettings& settings) {
    if (auto good = validate(settings); !good) {
        return tl::unexpected(good.error());
    }
    const std::string dictionary = settings.models + "/cmudict-en-us.dict";
    const std::string phones = settings.models + "/en-us-phone.lm.bin";
    const std::string sound_model = settings.models + "/en-us";
    for (const std::string& file : {dictionary, phones, sound_model + "/mdef"}) {
        if (!std::filesystem::exists(file)) {
            return fail(concat({"the recogniser's model ", file,
                                " is missing; install the package pocketsphinx-en-us"}));
        }
    }
    // PocketSphinx ends its process over a dictionary that it cannot read.
    if (auto words = open_sound_dictionary(dictionary, [](std::string_view, std::string_view) {});
        !words) {
        return tl::unexpected(words.error());
    }
    err_set_logfp(nullptr);
    const std::vector<std::string> common{"-hmm", sound_model, "-logfn", "/dev/null"};
    std::vector<std::string> of_graph = common;
    of_graph.insert(of_graph.end(), {"-dict", dictionary});
    std::vector<std::string> of_sounds = common;
    of_sounds.insert(of_sounds.end(), {"-allphone", phones, "-allphone_ci", "yes", "-beam", "1e-20",
                                       "-pbeam", "1e-20", "-lw", "2.0"});
    auto engines = std::make_unique<Engines>();
    engines->settings = settings;
    engines->throat = settings.throats.front();
    engines->graph = make_engine(of_graph);
    engines->sounds = make_engine(of_sounds);
    if (!engines->graph || !engines->sounds) {
        return fail(concat({"the recogniser's models in ", settings.models,
                            " cannot be read; install the package pocketsphinx-en-us anew"}));
    }
    return std::unique_ptr<Decoder>(new Decoder(std::move(engines)));
}

double Decoder::throat() const {
    return engines_->throat;
}

Expected<std::vector<std::string>> Decoder::listen(const WordGraph& graph) {
    engines_->listens = false;
    if (!is_whole(graph)) {
        return fail("the graph of words names nodes or words that it does not have");
    }
    std::vector<std::string> unknown;
    std::vector<bool> is_known;
    for (const std::string& word : graph.words) {
        is_known.push_back(engines_->teach(word));
        if (!is_known.back()) {
            unknown.push_back(word);
        }
    }
    if (!has_way(graph, is_known)) {
        return fail(concat({"nobody knows how these words sound: ",
                            unknown.empty() ? std::string("(none)") : unknown.front(),
                            "; use others in the answers"}));
    }
    logmath_t* const log = ps_get_logmath(engines_->graph.get());
    fsg_model_t* const model = fsg_model_init(kGraphName, log, 1.0F, graph.nodes);
    model->start_state = 0;
    model->final_state = graph.nodes - 1;
    for (const WordGraph::Arc& arc : graph.arcs) {
        const int weight = logmath_log(log, arc.weight);
        if (arc.word == kNone) {
            fsg_model_null_trans_add(model, arc.from, arc.to, weight);
        } else if (is_known[static_cast<std::size_t>(arc.word)]) {
            const std::string& word = graph.words[static_cast<std::size_t>(arc.word)];
            fsg_model_trans_add(model, arc.from, arc.to, weight,
                                fsg_model_word_add(model, word.c_str()));
        }
    }
    glist_free(fsg_model_null_trans_closure(model, nullptr));
    // Taken over, or taken care of: the library keeps its own count.
    const bool taken = ps_set_fsg(engines_->graph.get(), kGraphName, model) >= 0 &&
                       ps_set_search(engines_->graph.get(), kGraphName) >= 0;
    fsg_model_free(model);
    if (!taken) {
        return fail("the recogniser cannot listen for these answers; make them simpler");
    }
    engines_->listens = true;
    return unknown;
}

Decoded Decoder::decode(std::span<const std::int16_t> sound) {
    if (!engines_->listens || sound.empty()) {
        return {};
    }
    const DecoderSettings& settings = engines_->settings;
    // Noise takes from the graph's score more than from that of the sounds.
    const double room_dB = room_below_voice_dB(sound);
    const double noisy = std::clamp((kNoisyRoom_dB - room_dB) / kNoisyRange_dB, 0.0, 1.0);
    const bool is_quiet = room_dB > kNoisyRoom_dB;
    std::vector<std::int16_t> quieter;
    if (room_dB < kLoudRoom_dB) {
        quieter = quieten(sound);
        sound = quieter;
    }
    const double middle = settings.middle - noisy * settings.noise_allowance;
    constexpr double kSure = 2.0;  // widths above the middle: 88 % by the confidence
    Decoded decoded = engines_->decode(sound, engines_->throat, is_quiet);
    if (decoded.text.empty() || decoded.difference < middle + kSure * settings.width) {
        for (const double throat : settings.throats) {
            if (throat == engines_->throat) {
                continue;
            }
            Decoded other = engines_->decode(sound, throat, is_quiet);
            if (!other.text.empty() &&
                (decoded.text.empty() || other.difference > decoded.difference)) {
                decoded = std::move(other);
            }
        }
    }
    if (decoded.text.empty()) {
        return {};
    }
    if (decoded.difference > middle) {
        engines_->throat = decoded.throat;
    }
    decoded.confidence = 1.0 / (1.0 + std::exp(-(decoded.difference - middle) / settings.width));
    return decoded;
}

}  // namespace fulcrum::dialogue
