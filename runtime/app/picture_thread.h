// A window's picture, drawn in a thread of its own: whoever plays the lesson never waits for it.
//
//   show(view) -> the newest view -> drawn as finely as comes in time, and shown -> the next newest
// A view that comes while another is drawn takes the place of one that still waits. So a slow picture shows fewer views, and each as new as
// can be; the lesson, the sound and the hand go on at their own rate.
//
// Thread: the window's, but for what is named below. The other thread has the window's context as long as this lives.
#pragma once

#include "runtime/app/picture.h"
#include "runtime/render/glfw/window.h"

#include <array>
#include <condition_variable>
#include <cstdint>
#include <deque>
#include <functional>
#include <mutex>
#include <thread>

namespace fulcrum::runtime {

/// What a click means: a button, or of the answer a choice or the line to type in.
struct PictureSpot {
    int choice = -1;   ///< -1: none
    std::string said;  ///< of the choice, as it was seen
    std::optional<ScreenButton> button{};
};

/// Views of scenes, without the list of lessons.
struct PicturesShown {
    std::array<std::uint64_t, kPictureLevels.size()> of_level{};
    double first_s = 0.0;  ///< monotonic clock
    double last_s = 0.0;
};
/// "330 pictures, 27.5 a second: 8 best, 322 good."
[[nodiscard]] std::string describe(const PicturesShown& shown);

class PictureThread {
  public:
    /// Takes the window's context; waits until the picture is made. The window outlives it.
    [[nodiscard]] static Expected<std::unique_ptr<PictureThread>> start(const Places& places,
                                                                        Window& window);
    /// From the next view on; nothing: as fine as comes in time, which is so from the beginning.
    void set_level(std::optional<PictureLevel> level);
    /// Of what is shown from now on.
    void set_look(const ViewLook& look) { look_ = look; }
    PictureThread(const PictureThread&) = delete;
    PictureThread& operator=(const PictureThread&) = delete;
    /// Waits for the frame that is drawn.
    ~PictureThread();

    /// Draws that next, at the window's size of now. Returns at once.
    void show(View view);
    /// Loads models before the next view is drawn (Picture::load_models). Returns at once; what was wrong is said later.
    void load_models(std::vector<std::string> names, std::filesystem::path lesson_folder);
    /// The same of all that a lesson shows; waits for it.
    [[nodiscard]] std::vector<std::string> load_lesson(const LessonDescription& lesson,
                                                       const std::filesystem::path& lesson_folder);
    /// What was wrong with models since the last call, a sentence each.
    [[nodiscard]] std::vector<std::string> take_notices();
    /// Where the cards of a view's list of lessons are drawn; waits for the frame that is drawn.
    [[nodiscard]] MenuLayout menu_layout(View view);
    /// What can be clicked at this place of the picture that is shown; nothing elsewhere.
    [[nodiscard]] std::optional<PictureSpot> spot_at(double x_px, double y_px) const;
    /// The middle of that choice, or for -1 of the line to type in; nothing where it is not shown.
    [[nodiscard]] std::optional<Vector2> place_of(int choice) const;
    /// Draws that view, shows it, and gives its pixels; waits for it.
    [[nodiscard]] Image show_and_read(View view);
    [[nodiscard]] PicturesShown shown() const;

  private:
    using Work = std::function<void(Picture& picture)>;
    struct Wanted {
        View view;
        int width_px = 0;
        int height_px = 0;
    };
    explicit PictureThread(Window& window) : window_(window) {}
    void run(const Places& places);
    void draw(Picture& picture, const Wanted& wanted);
    void swap(const Picture& picture, const View& view);
    /// Done by the other thread, in order, before the next view; waits until it is done.
    void ask(Work work);

    Window& window_;
    ViewLook look_{};
    mutable std::mutex mutex_;
    std::condition_variable work_came_;
    std::condition_variable made_;
    // Under the mutex.
    std::optional<Wanted> wanted_;
    std::deque<Work> works_;
    bool ends_ = false;
    std::optional<Expected<void>> started_;
    std::vector<std::string> notices_;
    ClickBoxes click_boxes_;  // of the picture that is shown
    std::vector<std::string> choices_;
    std::vector<ScreenButton> buttons_;
    PicturesShown shown_;
    std::optional<PictureLevel> level_;

    QualityControl quality_;  // the other thread's

    std::thread thread_;
};

}  // namespace fulcrum::runtime
