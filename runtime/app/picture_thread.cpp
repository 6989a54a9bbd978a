#include "runtime/app/picture_thread.h"

#include "haptics/base/clock.h"

#include <algorithm>
#include <cstdio>
#include <future>
#include <iterator>
#include <utility>

namespace fulcrum::runtime {

std::string describe(const PicturesShown& shown) {
    constexpr std::array<const char*, kPictureLevels.size()> kNames{"best", "good", "fair", "fast"};
    std::uint64_t all = 0;
    std::string levels;
    for (std::size_t i = 0; i < kNames.size(); ++i) {
        all += shown.of_level[i];
        if (shown.of_level[i] > 0) {
            levels += (levels.empty() ? ": " : ", ") + std::to_string(shown.of_level[i]) + " " +
                      kNames[i];
        }
    }
    std::array<char, 64> text{};
    const double lasted_s = shown.last_s - shown.first_s;
    std::snprintf(text.data(), text.size(), "%llu pictures, %.1f a second",
                  static_cast<unsigned long long>(all),
                  lasted_s > 0.0 ? static_cast<double>(all - 1) / lasted_s : 0.0);
    return text.data() + levels + ".";
}

Expected<std::unique_ptr<PictureThread>> PictureThread::start(const Places& places,
                                                              Window& window) {
    std::unique_ptr<PictureThread> made(new PictureThread(window));
    window.release_context();
    made->thread_ = std::thread([thread = made.get(), places] { thread->run(places); });
    std::unique_lock lock(made->mutex_);
    made->made_.wait(lock, [&] { return made->started_.has_value(); });
    if (!*made->started_) {
        const Error error = made->started_->error();
        lock.unlock();
        return tl::unexpected(error);
    }
    return made;
}

PictureThread::~PictureThread() {
    {
        const std::scoped_lock lock(mutex_);
        ends_ = true;
    }
    work_came_.notify_one();
    thread_.join();
}

void PictureThread::run(const Places& places) {
    window_.take_context();
    auto picture = Picture::create(places);
    {
        const std::scoped_lock lock(mutex_);
        started_ = picture ? Expected<void>{} : Expected<void>(tl::unexpected(picture.error()));
    }
    made_.notify_one();
    while (picture) {
        std::unique_lock lock(mutex_);
        work_came_.wait(lock, [&] { return ends_ || wanted_ || !works_.empty(); });
        if (ends_) {
            break;
        }
        if (!works_.empty()) {
            const Work work = std::move(works_.front());
            works_.pop_front();
            lock.unlock();
            work(**picture);
        } else {
            const Wanted wanted = *std::exchange(wanted_, std::nullopt);
            lock.unlock();
            draw(**picture, wanted);
        }
    }
    // What it made in the context goes before that.
    picture = tl::unexpected(Error{});
    window_.release_context();
}

void PictureThread::draw(Picture& picture, const Wanted& wanted) {
    std::optional<PictureLevel> level;
    {
        const std::scoped_lock lock(mutex_);
        level = level_;
    }
    const bool adapts = !level;
    level = level.value_or(quality_.level());
    const double began_s = monotonic_now_s();
    picture.draw(wanted.view, wanted.width_px, wanted.height_px, quality_of(*level));
    swap(picture, wanted.view);
    // The list of lessons stands still, and is drawn as finely as can be.
    if (!wanted.view.menu.empty()) {
        return;
    }
    const double ended_s = monotonic_now_s();
    if (adapts) {
        quality_.take(ended_s - began_s);
    }
    const std::scoped_lock lock(mutex_);
    ++shown_.of_level.at(static_cast<std::size_t>(*level));
    shown_.first_s = shown_.first_s == 0.0 ? ended_s : shown_.first_s;
    shown_.last_s = ended_s;
}

void PictureThread::set_level(std::optional<PictureLevel> level) {
    const std::scoped_lock lock(mutex_);
    level_ = level;
}

// From now on a click means what is seen.
void PictureThread::swap(const Picture& picture, const View& view) {
    window_.swap();
    const std::scoped_lock lock(mutex_);
    click_boxes_ = picture.click_boxes();
    buttons_ = view.buttons;
    choices_.clear();
    for (const ViewChoice& choice : view.choices) {
        choices_.push_back(choice.said);
    }
}

void PictureThread::ask(Work work) {
    std::promise<void> done;
    {
        const std::scoped_lock lock(mutex_);
        works_.emplace_back([&](Picture& picture) {
            work(picture);
            done.set_value();
        });
    }
    work_came_.notify_one();
    done.get_future().wait();
}

void PictureThread::show(View view) {
    view.look = look_;
    Wanted wanted{std::move(view), window_.width_px(), window_.height_px()};
    {
        const std::scoped_lock lock(mutex_);
        wanted_ = std::move(wanted);
    }
    work_came_.notify_one();
}

Image PictureThread::show_and_read(View view) {
    view.look = look_;
    const Wanted wanted{std::move(view), window_.width_px(), window_.height_px()};
    Image image;
    ask([&](Picture& picture) {
        picture.draw(wanted.view, wanted.width_px, wanted.height_px);
        image = window_.read_back(wanted.width_px, wanted.height_px);
        swap(picture, wanted.view);
    });
    return image;
}

void PictureThread::load_models(std::vector<std::string> names,
                                std::filesystem::path lesson_folder) {
    {
        const std::scoped_lock lock(mutex_);
        works_.emplace_back(
            [this, names = std::move(names), folder = std::move(lesson_folder)](Picture& picture) {
                std::vector<std::string> told = picture.load_models(names, folder);
                const std::scoped_lock told_lock(mutex_);
                std::ranges::move(told, std::back_inserter(notices_));
            });
    }
    work_came_.notify_one();
}

std::vector<std::string> PictureThread::load_lesson(const LessonDescription& lesson,
                                                    const std::filesystem::path& lesson_folder) {
    std::vector<std::string> told;
    ask([&](Picture& picture) { told = picture.load_models(lesson, lesson_folder); });
    return told;
}

std::vector<std::string> PictureThread::take_notices() {
    const std::scoped_lock lock(mutex_);
    return std::exchange(notices_, {});
}

MenuLayout PictureThread::menu_layout(View view) {
    view.look = look_;
    const int width_px = window_.width_px();
    const int height_px = window_.height_px();
    MenuLayout layout;
    ask([&](Picture& picture) { layout = picture.menu_layout(view, width_px, height_px); });
    return layout;
}

std::optional<PictureSpot> PictureThread::spot_at(double x_px, double y_px) const {
    const std::scoped_lock lock(mutex_);
    const auto find = [&](const std::vector<Box>& boxes, std::size_t n) {
        const auto found =
            std::ranges::find_if(boxes, [&](const Box& box) { return box.holds(x_px, y_px); });
        const auto index = static_cast<std::size_t>(found - boxes.begin());
        return index < std::min(boxes.size(), n) ? std::optional(index) : std::nullopt;
    };
    if (const auto button = find(click_boxes_.buttons, buttons_.size())) {
        return PictureSpot{-1, {}, buttons_[*button]};
    }
    if (const auto choice = find(click_boxes_.choices, choices_.size())) {
        return PictureSpot{static_cast<int>(*choice), choices_[*choice]};
    }
    return click_boxes_.input.holds(x_px, y_px) ? std::optional(PictureSpot{}) : std::nullopt;
}

std::optional<Vector2> PictureThread::place_of(int choice) const {
    const std::scoped_lock lock(mutex_);
    if (choice >= static_cast<int>(std::min(choices_.size(), click_boxes_.choices.size()))) {
        return std::nullopt;
    }
    const Box& box =
        choice < 0 ? click_boxes_.input : click_boxes_.choices[static_cast<std::size_t>(choice)];
    return box.holds(box.middle_x(), box.middle_y())
               ? std::optional(Vector2(box.middle_x(), box.middle_y()))
               : std::nullopt;
}

PicturesShown PictureThread::shown() const {
    const std::scoped_lock lock(mutex_);
    return shown_;
}

}  // namespace fulcrum::runtime
