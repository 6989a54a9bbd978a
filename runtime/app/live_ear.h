// How a learner speaks to a lesson in a window: the key that is held, the microphone, what the picture shows of both.
//
//   key, listens?, speaks? --> Ear (hearing/ear.h) --> utterances for the lesson, a microphone for the picture
//
// Thread: that of the window. Cost: microseconds a frame.
#pragma once

#include "dialogue/catalogue.h"
#include "runtime/hearing/ear.h"
#include "runtime/render/glfw/window.h"
#include "runtime/scene/view.h"

#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

namespace fulcrum::runtime {

class LiveEar {
  public:
    /// The key to be held; it types nothing.
    static constexpr std::string_view kKey = "control";

    LiveEar(ListenMode mode, OpenMicrophone open);

    /// True where the learner begins to speak by the key while somebody listens: the program should fall silent.
    [[nodiscard]] bool take_keys(const WindowEvents& events);
    /// How things stand in this frame; what the learner has said.
    [[nodiscard]] std::optional<std::vector<std::int16_t>> step(bool wanted, bool speaks);
    /// What somebody should know, once; empty otherwise.
    [[nodiscard]] std::string take_trouble() { return ear_.take_trouble(); }
    /// Puts the microphone into the line to type in, and a banner where there is none.
    void show(View& view, const dialogue::Catalogue& catalogue) const;

  private:
    ListenMode mode_;
    Ear ear_;
    bool wanted_ = false;
};

}  // namespace fulcrum::runtime
