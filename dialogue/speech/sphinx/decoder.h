// PocketSphinx on a graph of words, and a second opinion on whether anything of it was said at all.
//
//   d = (s_graph - s_sounds) / frames      s: scores of the same sound by the graph, and by a loop of all sounds of English
//   confidence = 1 / (1 + exp(-(d - middle) / width))
// A graph alone takes the nearest of its sentences for whatever it hears, and PocketSphinx' own probability says nothing of that with a
// graph. The loop of sounds bends to anything, so what is said outside the graph fits the loop much better.
// The middle and its width were read off synthetic voices: `fulcrum bench hearing` has the curve, what is kept against what is wrongly let in.
//
// In a room whose noise is less than 36 dB below the voice the same words give a smaller d, and the middle goes down by noise_allowance until
// 31 dB. Nearer noise is not mended by any middle: then the words themselves are heard wrongly, and from 28 dB on the noise is taken out of
// the sound first (quieten.h).
//
// The model is of grown-ups' throats. A child's is shorter: where the learner's last throat is not surely right, all of `throats` are tried
// (stretch.h), the one with the greatest d is taken, and when it is likelier right than not it is the learner's from then on.
//
// The library ends its process where it thinks that nothing helps, so it has one of its own (main.cpp).
//
// Thread: one.  Cost: loading 0.12 s and 60 MB; an utterance some 0.1 of its length a throat that is tried.
// Source: D. Huggins-Daines and others 2006, PocketSphinx: a free, real-time continuous speech recognition system for hand-held devices,
//   ICASSP; the loop: R. Rose, D. Paul 1990, A hidden Markov model based keyword recognition system, ICASSP, section 3 (background score).
#pragma once

#include "dialogue/result.h"
#include "dialogue/speech/word_graph.h"

#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <vector>

namespace fulcrum::dialogue {

struct DecoderSettings {
    std::string models = "/usr/share/pocketsphinx/model/en-us";
    double middle = 3.5;  ///< d at which either is as likely, -100 to 100
    double width = 0.8;   ///< 0.01 to 100
    double noise_allowance =
        1.2;  ///< so much lower is the middle in a noisy room (noise_floor.h), 0 to 10
    /// How much smaller than a grown-up's it may be, 1 to kMostStretch each; the first at first.
    std::vector<double> throats{1.0, 1.2, 1.35, 1.5};
};

/// Refuses numbers out of their range.
[[nodiscard]] Expected<bool> validate(const DecoderSettings& settings);

struct Decoded {
    std::string text;         ///< words of the graph; empty: none fits
    double confidence = 0.0;  ///< 0 to 1
    double difference = 0.0;  ///< d; 0 where nothing fits
    double throat = 1.0;      ///< with which it was heard
};

class Decoder {
  public:
    /// Loads the models; the error names the folder.
    [[nodiscard]] static Expected<std::unique_ptr<Decoder>> create(const DecoderSettings& settings);
    Decoder(const Decoder&) = delete;
    Decoder& operator=(const Decoder&) = delete;
    ~Decoder();

    /// From now on this is what may be heard. Gives the words that nobody knows how to say, whose arcs are left out; refuses a graph of which
    /// nothing is left from start to end.
    [[nodiscard]] Expected<std::vector<std::string>> listen(const WordGraph& graph);
    /// All of one utterance of the learner who spoke before, mono at kHeardRate_Hz.
    [[nodiscard]] Decoded decode(std::span<const std::int16_t> sound);
    /// The learner's, as far as it is known: settings.throats' first until something fitted.
    [[nodiscard]] double throat() const;

  private:
    struct Engines;
    explicit Decoder(std::unique_ptr<Engines> engines);
    std::unique_ptr<Engines> engines_;
};

}  // namespace fulcrum::dialogue
