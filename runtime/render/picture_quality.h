// How finely a scene is drawn, and how that is chosen: as fine as still comes in time. Words, panels and the list of lessons are always as
// fine as the window.
//
//   took > most_s in the middle of the last looks_at pictures          -> coarser
//   took * (what finer costs) < spare * most_s, for `patience` pictures -> finer
//   finer was too slow after all                                       -> coarser again, and twice the patience from then on
//   even the coarsest was no quicker (a slow wire to the screen, say)  -> as before, and nothing is tried for that long
// So under a load that stays it settles, with ever rarer trials; and of one that goes it recovers.
//
// Thread: that which draws. Cost: a sort of looks_at numbers now and then.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace fulcrum::runtime {

struct PictureQuality {
    int samples = 4;     ///< a pixel, 1 to 16; fewer where the renderer or the driver has fewer
    double scale = 1.0;  ///< of a side in pixels, 0.25 to 1; below 1 there is one sample
};

enum class PictureLevel : std::uint8_t { best, good, fair, fast };
inline constexpr std::array<PictureQuality, 4> kPictureLevels{
    {{4, 1.0}, {1, 1.0}, {1, 0.7}, {1, 0.5}}};

[[nodiscard]] constexpr const PictureQuality& quality_of(PictureLevel level) {
    return kPictureLevels.at(static_cast<std::size_t>(level));
}

struct QualitySettings {
    double most_s = 1.0 / 33.0;  ///< that a picture may take: 30 a second, and a little to spare
    std::size_t looks_at = 8;    ///< pictures
    double spare = 0.8;
    /// At most how many times longer the level before takes (`fulcrum bench picture-levels`, without a graphics card).
    std::array<double, kPictureLevels.size()> finer_costs{1.0, 2.7, 1.4, 1.3};
    double helps = 0.9;  ///< what coarser takes at most of what finer took, else it is none
    int patience = 240;  ///< pictures; after that a finer level is tried
    int longest_patience = 7680;  ///< some minutes
};

class QualityControl {
  public:
    explicit QualityControl(const QualitySettings& settings = {})
        : settings_(settings), patience_(settings.patience) {}

    [[nodiscard]] PictureLevel level() const noexcept { return level_; }
    /// A picture of that level has been drawn and shown, and took so long.
    void take(double took_s);

  private:
    enum class Step : std::uint8_t { none, coarser, finer };
    void step(Step step);
    void wait_longer();
    [[nodiscard]] double middle_of_taken();

    QualitySettings settings_;
    PictureLevel level_ = PictureLevel::best;
    std::vector<double> taken_s_;  // since the last look
    int patience_;
    int n_since_step_ = 0;
    Step last_step_ = Step::none;                     // until the first look behind it
    PictureLevel descent_from_ = PictureLevel::best;  // by steps one right behind the other
    double descent_s_ = 0.0;                          // what that took
    int rest_ = 0;  // pictures for which coarser is not tried: it does not help
};

}  // namespace fulcrum::runtime
