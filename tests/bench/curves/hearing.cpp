// What is heard of synthetic voices: sentences that fit a question, learners' errors in them, and what fits nothing; and the knob that
// decides how sure the recogniser has to be, what is kept against what is wrongly let in.
#include "dialogue/marking/mark_answer.h"
#include "dialogue/speech/sphinx/decoder.h"
#include "runtime/audio/resample.h"
#include "runtime/audio/wav.h"
#include "runtime/files/run_program.h"
#include "tests/bench/harness/curve.h"

#include <atomic>
#include <cstdio>
#include <random>
#include <span>
#include <stdexcept>

namespace fulcrum::bench {
namespace {

using namespace fulcrum::dialogue;

// In the grammar: right ones, and what learners say.
constexpr std::array<std::string_view, 10> kRight{
    "the watermelon is the heaviest", "a banana is the heaviest",
    "the apple is the heaviest",      "the egg is the heaviest",
    "an apple is the heaviest",       "a watermelon is the heaviest",
    "the banana is the heaviest",     "the heaviest is the apple",
    "it is the watermelon",           "the watermelon"};
constexpr std::array<std::string_view, 10> kWrong{
    "watermelon is the heaviest",     "the banana is the most heavy",
    "the apple are the heaviest",     "banana is heaviest",
    "the egg is most heavy",          "the watermelon is heaviest",
    "the apple is the most heaviest", "apple is the most heavy",
    "the banana are the heaviest",    "the watermelon be the heaviest"};
constexpr std::array<std::string_view, 20> kOutside{"I want to go home now",
                                                    "the weather is nice today",
                                                    "my brother plays football",
                                                    "can I have some water please",
                                                    "what time is it",
                                                    "she went to school by bus",
                                                    "the window is open",
                                                    "I do not understand this",
                                                    "look at that big dog",
                                                    "we had pizza for lunch",
                                                    "three and four is seven",
                                                    "where is my pencil",
                                                    "it was raining all day",
                                                    "he is talking to his friend",
                                                    "open your books please",
                                                    "I like reading in the evening",
                                                    "the train was late again",
                                                    "this game is really fun",
                                                    "my favourite colour is blue",
                                                    "nobody knows the answer"};

// As near to the grammar as can be, and another meaning.
constexpr std::array<std::string_view, 8> kNear{
    "the watermelon is not heavy",    "the egg is heavier than the apple",
    "the apple is not the heaviest",  "the banana is not heavier than the egg",
    "the watermelon is the lightest", "the egg is less heavy",
    "nothing is the heaviest",        "the orange is the heaviest"};

constexpr double kNoNoise_dB = 200.0;

struct Condition {
    std::string name;
    std::string program, voice;
    double pitch = 1.0;             // and formants, as a smaller throat has them; as quick
    double noise_dB = kNoNoise_dB;  // white, below the voice's root mean square
};

const std::vector<Condition>& conditions() {
    static const std::vector<Condition> kAll{
        {"flite slt, a woman", "flite", "slt"},
        {"flite rms, a man", "flite", "rms"},
        {"flite awb, a Scot", "flite", "awb"},
        {"espeak-ng en-us", "espeak-ng", "en-us"},
        {"festival kal, a man", "festival", "kal_diphone"},
        {"slt, 2 semitones up", "flite", "slt", 1.122},
        {"slt, 4 semitones up", "flite", "slt", 1.26},
        {"slt, 6 semitones up", "flite", "slt", 1.414},
        {"slt, noise 30 dB below", "flite", "slt", 1.0, 30.0},
        {"slt, noise 25 dB below", "flite", "slt", 1.0, 25.0},
        {"slt, noise 20 dB below", "flite", "slt", 1.0, 20.0},
        {"slt, noise 10 dB below", "flite", "slt", 1.0, 10.0},
    };
    return kAll;
}

// Said slower first, so that what is played quicker is as quick as before.
std::vector<std::string> speaking_words(const Condition& condition, std::string_view text) {
    const std::string sentence(text);
    if (condition.program == "espeak-ng") {
        return {"espeak-ng", "--stdout", "-v", condition.voice, "-s", "140", "--", sentence};
    }
    if (condition.program == "festival") {
        return {"festival", "-b",
                "(begin (voice_" + condition.voice + ") (set! said (utt.synth (Utterance Text \"" +
                    sentence + "\"))) (utt.save.wave said \"/dev/stdout\" 'riff))"};
    }
    return {"flite",
            "-voice",
            condition.voice,
            "--setf",
            "duration_stretch=" + to_text(condition.pitch),
            "-o",
            "/dev/stdout",
            "-t",
            sentence};
}

std::vector<std::int16_t> speak(const Condition& condition, std::string_view text) {
    const std::atomic<bool> never{false};
    const auto wav =
        runtime::run_program({speaking_words(condition, text), 20'000'000, 30.0}, never);
    const auto sound =
        wav.and_then([](const std::string& bytes) { return runtime::read_wav(bytes); });
    if (!sound) {
        throw std::runtime_error(condition.program + " says nothing");
    }
    const auto rate = static_cast<int>(std::lround(sound->rate_Hz * condition.pitch));
    std::vector<float> heard = runtime::resample(sound->samples, rate, kHeardRate_Hz);
    double power = 0.0;
    for (const float x : heard) {
        power += static_cast<double>(x) * static_cast<double>(x);
    }
    const double loudness = std::sqrt(power / std::max(static_cast<double>(heard.size()), 1.0));
    std::mt19937 random(1);
    std::normal_distribution<double> noise(0.0,
                                           loudness * std::pow(10.0, -condition.noise_dB / 20.0));
    // A room is heard before and behind what is said in it.
    const std::size_t margin = condition.noise_dB < kNoNoise_dB ? kHeardRate_Hz * 3 / 10 : 0;
    heard.insert(heard.begin(), margin, 0.0F);
    heard.insert(heard.end(), margin, 0.0F);
    std::vector<std::int16_t> samples;
    for (const float x : heard) {
        samples.push_back(static_cast<std::int16_t>(
            std::lround(std::clamp(x + noise(random), -1.0, 1.0) * 32767.0)));
    }
    return samples;
}

struct Heard {
    double difference = -1.0e3;  // nothing fits
    bool exact = false;
    bool told = false;  // of an error: the mark has one
};

struct HeardAll {
    std::vector<Heard> right, wrong, near, outside;
    double share_of_length = 0.0;
};

// Every so many-th of the sentences.
HeardAll hear(Decoder& decoder, const Question& question, const Condition& condition,
              std::size_t stride) {
    HeardAll all;
    double took_s = 0.0;
    double length_s = 0.0;
    const auto one = [&](std::string_view text) {
        const auto samples = speak(condition, text);
        Decoded decoded;
        took_s += 1.0e-6 * time_by_clock_us([&] { decoded = decoder.decode(samples); });
        length_s += static_cast<double>(samples.size()) / kHeardRate_Hz;
        Heard heard;
        if (!decoded.text.empty()) {
            const Mark mark = mark_answer(question, decoded.text);
            heard = {decoded.difference, decoded.text == text, !mark.form_errors.empty()};
        }
        return heard;
    };
    const auto some = [&](std::span<const std::string_view> texts, std::vector<Heard>& heard) {
        for (std::size_t i = 0; i < texts.size(); i += stride) {
            heard.push_back(one(texts[i]));
        }
    };
    some(kRight, all.right);
    some(kWrong, all.wrong);
    some(kNear, all.near);
    some(kOutside, all.outside);
    all.share_of_length = took_s / length_s;
    return all;
}

// Of those above the threshold.
template <class Which>
double percent(const std::vector<Heard>& heard, double threshold, const Which& which) {
    const auto n = std::ranges::count_if(
        heard, [&](const Heard& each) { return each.difference > threshold && which(each); });
    return 100.0 * static_cast<double>(n) / static_cast<double>(heard.size());
}

bool any(const Heard& /*heard*/) {
    return true;
}
bool is_exact(const Heard& heard) {
    return heard.exact;
}
bool is_told(const Heard& heard) {
    return heard.told;
}

// Each voice is a learner's of its own.
std::unique_ptr<Decoder> listen(const Question& question, const DecoderSettings& settings) {
    auto decoder = must(Decoder::create(settings));
    (void)must(decoder->listen(make_word_graph(*question.templates)));
    return decoder;
}

bool speaks(const Condition& condition) {
    try {
        return !speak(condition, "yes").empty();
    } catch (const std::runtime_error&) {
        return false;
    }
}

// What a throat of the learner's own does for voices that are higher than a grown-up's.
Sheet measure_throats(Run& run, const Question& question, double used) {
    Sheet sheet{"hearing-throats",
                "Voices of smaller throats",
                "The same sentences, right ones and errors, by a model of grown-ups alone and with "
                "the learner's own throat, which is found from what fits; pitch and formants are "
                "raised, the words are as quick.",
                "Leave it on: it costs time only where the first try is not sure.",
                {"semitones up", "throats tried", "heard %", "word for word %", "near: let in %",
                 "outside: let in %", "time over length"}};
    const std::vector<int> semitones = run.pick(std::vector<int>{0, 2, 4, 6}, std::vector<int>{4});
    for (const int up : semitones) {
        const Condition voice{"", "flite", "slt", std::pow(2.0, up / 12.0)};
        for (const bool own : {false, true}) {
            DecoderSettings settings;
            if (!own) {
                settings.throats = {1.0};
            }
            const auto decoder = listen(question, settings);
            const HeardAll all =
                hear(*decoder, question, voice, run.pick(std::size_t{1}, std::size_t{12}));
            std::vector<Heard> inside = all.right;
            inside.insert(inside.end(), all.wrong.begin(), all.wrong.end());
            sheet.add({up, settings.throats.size(), percent(inside, used, any),
                       percent(inside, used, is_exact), percent(all.near, used, any),
                       percent(all.outside, used, any), all.share_of_length});
        }
    }
    return sheet;
}

Report run_hearing(Run& run) {
    QuestionSource source{"heaviest",
                          "Which one is the heaviest?",
                          {"[the|a|an] {thing} is the <superlative:heavy>",
                           "the <superlative:heavy> is [the|a|an] {thing}"},
                          {{"thing", {"watermelon", "apple", "banana", "egg"}}}};
    const Question question = must(compile_question(source));
    constexpr double kLeastConfidence = 0.4;  // below it a lesson asks again
    const DecoderSettings settings;
    const double used =
        settings.middle + settings.width * std::log(kLeastConfidence / (1.0 - kLeastConfidence));
    Sheet voices{
        "hearing-voices",
        "What is heard of synthetic voices",
        "10 right sentences, 10 with a learner's error, 8 of another meaning that lie near, and 20 "
        "that fit nothing, one question; heard: sure enough to be marked.",
        "Let a pupil type where the room is loud.",
        {"voice", "right: heard %", "right: word for word %", "right: called an error %",
         "errors: heard %", "errors: told as errors %", "errors: word for word %", "near: let in %",
         "outside: let in %", "time over length"}};
    Sheet knob{"hearing-threshold",
               "How sure the recogniser has to be",
               "The same sentences of the three clear voices: kept, with errors or without, "
               "against let in from outside the grammar.",
               "Higher where a wrong guess costs more than asking again.",
               {"least difference", "kept %", "near let in %", "outside let in %", "in use"}};
    HeardAll clear;
    const std::size_t n = run.pick(conditions().size(), std::size_t{1});
    constexpr std::size_t kClear = 3;
    for (std::size_t i = 0; i < n; ++i) {
        if (!speaks(conditions()[i])) {
            std::fprintf(stderr, "%s: %s is not installed, so this voice is left out.\n",
                         conditions()[i].name.c_str(), conditions()[i].program.c_str());
            continue;
        }
        const HeardAll all = hear(*listen(question, settings), question, conditions()[i],
                                  run.pick(std::size_t{1}, std::size_t{12}));
        voices.add({conditions()[i].name, percent(all.right, used, any),
                    percent(all.right, used, is_exact), percent(all.right, used, is_told),
                    percent(all.wrong, used, any), percent(all.wrong, used, is_told),
                    percent(all.wrong, used, is_exact), percent(all.near, used, any),
                    percent(all.outside, used, any), all.share_of_length});
        if (i < kClear) {
            for (const auto& [from, to] : {std::pair{&all.right, &clear.right},
                                           {&all.wrong, &clear.right},
                                           {&all.near, &clear.near},
                                           {&all.outside, &clear.outside}}) {
                to->insert(to->end(), from->begin(), from->end());
            }
        }
        run.progress(static_cast<double>(i + 1) / static_cast<double>(n));
    }
    const auto add_threshold = [&](double threshold, const char* in_use) {
        knob.add({threshold, percent(clear.right, threshold, any),
                  percent(clear.near, threshold, any), percent(clear.outside, threshold, any),
                  in_use});
    };
    for (double threshold = -10.0; threshold <= 8.0; threshold += 1.0) {
        add_threshold(threshold, "");
    }
    add_threshold(used, "in use");
    return {voices, knob, measure_throats(run, question, used)};
}

const Registration kHearing{
    {"hearing", "what is heard of synthetic voices, and how sure that has to be", run_hearing}};

}  // namespace
}  // namespace fulcrum::bench
