// What was said in a play, to be heard again: first what stands there, then one further back each time.
//
//   add "Catch an apple!"   add "This is an apple."   add "Which one …?"        the newest stands in the picture
//   look_back -> 0: what stands there      look_back -> 1: "This is an apple."      look_back -> 2: "Catch an apple!", and stays
//
// Whoever waits for kForgets_s begins with the newest again, and so does everybody when something new is said.
//
// Thread: one.  Cost: a queue of kMostKept texts.
#pragma once

#include <cstddef>
#include <deque>
#include <string>
#include <string_view>
#include <vector>

namespace fulcrum::runtime {

class SaidBefore {
  public:
    static constexpr std::size_t kMostKept = 100;
    static constexpr double kForgets_s = 10.0;

    /// Something was said. The same again, right after itself, counts once; an empty text was not said.
    void add(std::string_view text);
    /// Goes one further back; `standing` is what stands in the picture now, which comes first where there is any. Gives what is
    /// to be said; nothing where nothing was said yet.
    [[nodiscard]] std::vector<std::string> look_back(const std::vector<std::string>& standing,
                                                     double now_s);
    /// What `look_back` came to, to be shown; empty where it stands there anyway, and once that is forgotten.
    [[nodiscard]] std::string shown(double now_s) const;

  private:
    [[nodiscard]] bool looks(double now_s) const { return looked_at_s_ + kForgets_s > now_s; }

    std::deque<std::string> kept_;  // the oldest first
    std::size_t at_ = 0;            // of kept_: what was looked at last
    bool standing_ = false;         // that was what stands there
    double looked_at_s_ = -kForgets_s;
};

}  // namespace fulcrum::runtime
