// Whatever speaks to the learner: captions, a synthetic voice, nothing.
//
// Thread: one, that of the lesson loop; sound is made elsewhere.  Cost: `say` and `step` never wait.
#pragma once

#include <string>
#include <string_view>

namespace fulcrum::dialogue {

/// The interface of all voices.
class Voice {
  public:
    Voice() = default;
    Voice(const Voice&) = delete;
    Voice& operator=(const Voice&) = delete;
    virtual ~Voice() = default;

    /// Says `text` after what is still to be said; *asterisks* are emphasis.
    virtual void say(std::string_view text) = 0;
    /// Time goes on by `dt_s` seconds (0 or more).
    virtual void step(double dt_s) = 0;
    /// Falls silent at once and forgets what was still to be said.
    virtual void stop() = 0;
    /// True while something is being said.
    [[nodiscard]] virtual bool speaking() const = 0;
    /// "captions", "null", …; as the command line names it.
    [[nodiscard]] virtual std::string_view name() const = 0;
};

}  // namespace fulcrum::dialogue
