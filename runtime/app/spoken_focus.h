// What is chosen on the screen is read aloud once the choice rests, so that who cannot read it, or not see it, hears what would be taken.
//
// Thread: that of the window.
#pragma once

#include <optional>
#include <string>

namespace fulcrum::runtime {

class SpokenFocus {
  public:
    static constexpr double kRest_s =
        0.3;  ///< what is passed over on the way to another is not read

    /// What stands in focus at `now_s` of any clock, empty for nothing: the words to be said now, each time that it is come to once.
    [[nodiscard]] std::optional<std::string> look(const std::string& words, double now_s);

  private:
    std::string words_;
    double since_s_ = 0.0;
    bool is_said_ = true;
};

}  // namespace fulcrum::runtime
