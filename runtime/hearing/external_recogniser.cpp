#include "runtime/hearing/external_recogniser.h"

#include "haptics/base/clock.h"
#include "runtime/audio/resample.h"
#include "runtime/audio/wav.h"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <iterator>
#include <span>
#include <utility>
#include <variant>

namespace fulcrum::runtime {
namespace {

constexpr std::size_t kPiece = 3200;    // samples a line: 0.2 s
constexpr double kGiveUpLook_s = 0.05;  // so often a run that waits looks whether somebody gives up
constexpr int kLinesEach = 2;           // a program may say so many for each that it gets
constexpr int kMostLinesLeft = 1000;
constexpr int kMostLines = 64;  // taken in one poll
constexpr std::size_t kMostLines_bytes = LineProgram::kLongestLine_bytes;
constexpr std::size_t kMostFile_bytes = 50'000'000;
constexpr std::size_t kMostTroubles = 16;

fulcrum::Expected<std::vector<std::int16_t>> read_recording(const std::string& file) {
    std::ifstream in(file, std::ios::binary);
    std::string bytes((std::istreambuf_iterator<char>(in)), {});
    if (!in || bytes.size() > kMostFile_bytes) {
        return fulcrum::fail("a recording cannot be read, or is too long", file,
                             "give a WAV file of less than five minutes");
    }
    const auto sound = read_wav(bytes);
    if (!sound) {
        return fulcrum::fail(sound.error().message, file, sound.error().what_to_do);
    }
    return to_pcm16(resample(sound->samples, sound->rate_Hz, dialogue::kHeardRate_Hz));
}

}  // namespace

fulcrum::Expected<std::unique_ptr<ExternalRecogniser>> ExternalRecogniser::create(
    HearingSettings settings) {
    auto program = LineProgram::start(settings.words);
    if (!program) {
        return tl::unexpected(program.error());
    }
    return std::unique_ptr<ExternalRecogniser>(
        new ExternalRecogniser(std::move(settings), std::move(*program)));
}

ExternalRecogniser::ExternalRecogniser(HearingSettings settings,
                                       std::unique_ptr<LineProgram> program)
    : settings_(std::move(settings)), program_(std::move(program)) {}

dialogue::Expected<bool> ExternalRecogniser::listen(
    std::shared_ptr<const dialogue::TemplateSet> templates) {
    if (templates == nullptr) {
        return dialogue::fail("there is nothing to listen for; compile a question first");
    }
    stop();
    ++question_;
    listening_ = true;
    order(dialogue::ListenLine{question_, dialogue::make_word_graph(*templates)});
    speak_recording();
    return true;
}

void ExternalRecogniser::speak_recording() {
    if (next_recording_ >= settings_.recordings.size()) {
        return;
    }
    const auto samples = read_recording(settings_.recordings[next_recording_++]);
    if (!samples) {
        tell(to_sentence(samples.error()));
        return;
    }
    hear(*samples);
}

void ExternalRecogniser::hear(std::span<const std::int16_t> all) {
    if (!listening_) {
        return;
    }
    for (std::size_t i = 0; i < all.size(); i += kPiece) {
        const auto piece = all.subspan(i, std::min(kPiece, all.size() - i));
        order(dialogue::AudioLine{question_, {piece.begin(), piece.end()}});
    }
    order(dialogue::EndLine{question_});
    // Who speaks on to a program that says nothing gives it no more time.
    if (!std::exchange(awaits_, true)) {
        waits_until_s_ = monotonic_now_s() + settings_.patience_s;
    }
}

// Each line to it entitles it to some.
void ExternalRecogniser::order(const dialogue::HearingOrder& line) {
    program_->send(write_line(line));
    lines_left_ = std::min(lines_left_ + kLinesEach, kMostLinesLeft);
}

std::vector<dialogue::Hypothesis> ExternalRecogniser::poll() {
    take_lines();
    if (!listening_ || heard_.empty()) {
        return {};
    }
    listening_ = false;
    return std::exchange(heard_, {});
}

// Bounded, whatever it says: the rest is for the next poll, and the program waits.
void ExternalRecogniser::take_lines() {
    std::size_t bytes = 0;
    for (int n = 0; n < kMostLines && bytes < kMostLines_bytes; ++n) {
        const auto line = next_line();
        if (!line) {
            break;
        }
        if (--lines_left_ < 0) {
            program_->end("says much more than it is asked, and was ended");
            break;
        }
        bytes += line->size();
        const auto answer = dialogue::read_answer(*line);
        if (answer) {
            take(*answer);
        } else if (!std::exchange(said_nonsense_, true)) {
            tell("The program that hears said what it should not: " + answer.error().message + ".");
        }
    }
    look_for_its_end();
}

void ExternalRecogniser::end_for_silence() {
    program_->end("has said nothing of what was spoken for " +
                  std::to_string(std::lround(settings_.patience_s)) + " s, and was ended");
}

// A run that waits for what was said does so until then, or until somebody gives up; a live one only looks.
std::optional<std::string> ExternalRecogniser::next_line() {
    if (!settings_.waits || !awaits_) {
        auto line = program_->take();
        if (!line && awaits_ && monotonic_now_s() > waits_until_s_) {
            end_for_silence();
        }
        return line;
    }
    while (!settings_.gives_up || !settings_.gives_up()) {
        const double left_s = waits_until_s_ - monotonic_now_s();
        auto line = program_->wait(std::clamp(left_s, 0.0, kGiveUpLook_s));
        if (line || !program_->trouble().empty()) {
            return line;
        }
        if (left_s <= 0.0) {
            end_for_silence();
            break;
        }
    }
    return {};
}

void ExternalRecogniser::look_for_its_end() {
    if (program_->trouble().empty()) {
        return;
    }
    if (name_ != "none") {
        tell("Nobody hears any more: " + program_->trouble() + "; type the answers.");
    }
    name_ = "none";
    awaits_ = false;
}

void ExternalRecogniser::take(const dialogue::HearingAnswer& answer) {
    if (const auto* const ready = std::get_if<dialogue::ReadyLine>(&answer)) {
        name_ = ready->name;
        hears_form_ = ready->form;
        if (!std::exchange(ready_, true)) {  // its models had to load
            waits_until_s_ = monotonic_now_s() + settings_.patience_s;
        }
    } else if (const auto* const listening = std::get_if<dialogue::ListeningLine>(&answer)) {
        for (const std::string& word : listening->unknown) {
            tell("Nobody knows how \"" + word + "\" sounds, so it is never heard.");
        }
    } else if (const auto* const heard = std::get_if<dialogue::HeardLine>(&answer)) {
        take_words(*heard);
    } else {
        awaits_ = false;
        tell("The program that hears: " + std::get<dialogue::TroubleLine>(answer).sentence + ".");
    }
}

void ExternalRecogniser::take_words(const dialogue::HeardLine& heard) {
    constexpr double kToSomebodyElse = 0.02;
    if (heard.question != question_) {
        return;
    }
    awaits_ = false;
    throat_ = heard.throat > 0.0 ? heard.throat : throat_;
    if (settings_.passes_over && (heard.text.empty() || heard.confidence < kToSomebodyElse)) {
        return;
    }
    // What fits nothing is asked for again, as what is not sure is.
    heard_ = {{heard.text, heard.text.empty() ? 0.0 : heard.confidence, hears_form_}};
}

void ExternalRecogniser::stop() {
    if (listening_) {
        order(dialogue::StopLine{question_});
    }
    listening_ = false;
    awaits_ = false;
    heard_.clear();
}

std::string ExternalRecogniser::take_trouble() {
    if (troubles_.empty()) {
        return {};
    }
    std::string trouble = std::move(troubles_.front());
    troubles_.pop_front();
    return trouble;
}

void ExternalRecogniser::tell(const std::string& sentence) {
    if (troubles_.size() < kMostTroubles && sentence != told_last_) {
        troubles_.push_back(sentence);
        told_last_ = sentence;
    }
}

}  // namespace fulcrum::runtime
