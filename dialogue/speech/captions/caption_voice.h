// A voice that is read: each sentence stands as long as an early reader needs.
//
//   time = least_s, or words / words_per_s + settle_s when that is longer
//
// Thread: one.  Cost: a queue.
// Source: 89 words a minute is the median of oral reading at the end of the second school year, 53 that of the first
//   (Hasbrouck and Tindal 2006, "Oral Reading Fluency Norms", The Reading Teacher 59(7)); the default lies between.
#pragma once

#include "dialogue/marked_text.h"
#include "dialogue/speech/voice.h"

#include <deque>
#include <string>
#include <string_view>

namespace fulcrum::dialogue {

/// How long captions stand.
struct CaptionSettings {
    double words_per_s = 1.2;  ///< 0.2 to 10: how fast the learner reads
    double settle_s = 0.8;     ///< 0 to 10: to find the caption
    double least_s = 2.0;      ///< 0.1 to 60: even for one word
};

/// A caption on the screen.
struct Caption {
    MarkedText text;
    std::string said;         ///< the same as it was said, with its *asterisks*
    double shown_s = 0.0;     ///< how long it has stood
    double duration_s = 0.0;  ///< how long it will stand
};

/// Puts what is said into captions, one after another. The last one stays until another comes or `stop`.
class CaptionVoice final : public Voice {
  public:
    explicit CaptionVoice(CaptionSettings settings = {});

    void say(std::string_view text) override;
    void step(double dt_s) override;
    void stop() override;
    /// True while the caption hasn't stood its time or another waits.
    [[nodiscard]] bool speaking() const override;
    [[nodiscard]] std::string_view name() const override { return "captions"; }

    /// The caption to draw; its text is empty before the first.
    [[nodiscard]] const Caption& caption() const { return caption_; }
    /// How long `text` would stand, in seconds.
    [[nodiscard]] double reading_time_s(std::string_view text) const;

  private:
    void next();

    CaptionSettings settings_;
    Caption caption_{};
    std::deque<std::string> waiting_;
};

}  // namespace fulcrum::dialogue
