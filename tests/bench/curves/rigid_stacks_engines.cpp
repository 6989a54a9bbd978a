// The same stacks and the same wall at rest, hit and dropped, in our world and in other engines.
#include "tests/bench/curves/rigid_stacks.h"
#include "tests/bench/harness/curve.h"

#include <cstdio>

namespace fulcrum::bench {
namespace {

// An engine that needs longer for a course stops there, and says after how many steps.
constexpr double kMostCourse_s = 12.0;
// From where it began: what is farther fell, or was thrown.
constexpr double kMoved_m = 0.02;
// Above each other at first, or nearly.
constexpr double kUpon_m = 6.0e-3;
// How often depths are taken.
constexpr int kLookEach = 10;

/// Boxes that stand upon each other, by their numbers.
struct Upon {
    std::size_t upper;
    int lower;  // -1: the ground
};

std::vector<Upon> find_upon(const StackScene& scene) {
    std::vector<Upon> all;
    for (std::size_t i = 0; i < scene.boxes.size(); ++i) {
        const StackBox& upper = scene.boxes[i];
        if (upper.at_W.y() - upper.half_m.y() < kUpon_m) {
            all.push_back({i, -1});
        }
        for (std::size_t j = 0; j < i; ++j) {
            const StackBox& lower = scene.boxes[j];
            const Vector3 apart =
                (upper.at_W - lower.at_W).cwiseAbs() - upper.half_m - lower.half_m;
            if (upper.at_W.y() > lower.at_W.y() && apart.y() < kUpon_m && apart.x() < 0.0 &&
                apart.z() < 0.0) {
                all.push_back({i, static_cast<int>(j)});
            }
        }
    }
    return all;
}

class Watch {
  public:
    explicit Watch(const StackScene& scene) : scene_(scene), upon_(find_upon(scene)) {}

    // Of boxes that are about where they were.
    void look(const StackEngine& engine) {
        for (const Upon& pair : upon_) {
            const StackBox& upper = scene_.boxes[pair.upper];
            const Vector3 at = engine.place(static_cast<int>(pair.upper));
            const bool is_there = (at - upper.at_W).norm() <= kMoved_m;
            double top_m = 0.0;
            bool has_below = true;
            if (pair.lower >= 0) {
                const StackBox& lower = scene_.boxes[static_cast<std::size_t>(pair.lower)];
                const Vector3 below = engine.place(pair.lower);
                has_below = (below - lower.at_W).norm() <= kMoved_m;
                top_m = below.y() + lower.half_m.y();
            }
            if (is_there && has_below) {
                deepest_m_ = std::max(deepest_m_, top_m + upper.half_m.y() - at.y());
            }
        }
    }
    [[nodiscard]] double deepest_m() const { return deepest_m_; }
    [[nodiscard]] double find_drift_m(const StackEngine& engine) const {
        double drift_m = 0.0;
        for (std::size_t i = 0; i < scene_.boxes.size(); ++i) {
            const Vector3 moved = engine.place(static_cast<int>(i)) - scene_.boxes[i].at_W;
            drift_m = std::max(drift_m, std::hypot(moved.x(), moved.z()));
        }
        return drift_m;
    }
    [[nodiscard]] int count_moved(const StackEngine& engine) const {
        int n = 0;
        for (std::size_t i = 0; i < scene_.boxes.size(); ++i) {
            const Vector3 at = engine.place(static_cast<int>(i));
            // What is no number is gone.
            n += (at - scene_.boxes[i].at_W).norm() <= kMoved_m ? 0 : 1;
        }
        return n;
    }

  private:
    const StackScene& scene_;
    std::vector<Upon> upon_;
    double deepest_m_ = 0.0;
};

void measure_course(const std::string& name, const EngineCourse& course,
                    const MakeStackEngine& make, int n_steps, Sheet& sheet) {
    const auto engine = make(course.scene);
    Watch watch(course.scene);
    std::vector<double> us;
    double whole_us = 0.0;
    for (int i = 0; i < n_steps && whole_us < 1.0e6 * kMostCourse_s; ++i) {
        course.disturb(*engine, i);
        // Of the processor: what others take of it is no engine's.
        us.push_back(time_once([&] { engine->step(); }).own_us);
        whole_us += us.back();
        if (i % kLookEach == 0) {
            watch.look(*engine);
        }
    }
    const int n_done = static_cast<int>(us.size());
    const double worst_us = *std::ranges::max_element(us);
    const Cost cost = summarise(std::move(us));
    const auto in_mm = [](double m) {
        char text[32];
        std::snprintf(text, sizeof(text), "%.2g", 1.0e3 * m);
        return std::string(text);
    };
    const int n_moved = watch.count_moved(*engine);
    sheet.add({name, course.name, rounded(cost.median_us, 1), rounded(cost.p99_us, 1),
               rounded(worst_us, 1), course.leans ? "" : in_mm(watch.deepest_m()),
               course.rests ? in_mm(watch.find_drift_m(*engine)) : "",
               course.rests ? std::to_string(n_moved) : "", n_done});
}

}  // namespace

std::vector<EngineCourse> make_engine_courses() {
    const auto leave = [](StackEngine&, int) {};
    std::vector<EngineCourse> courses{{"10 at rest", make_stack(10), leave},
                                      {"20 at rest", make_stack(20), leave},
                                      {"20 under 100 kg", make_stack(20, 100.0), leave}};
    courses.push_back({"10 dropped 5 mm apart", make_stack(10, 1.0, 0.005), leave, false});
    courses.push_back({"10, one after the other hit sideways by 15 N for 5 ms", make_stack(10),
                       [](StackEngine& engine, int i) {
                           if (i % 500 < 5) {
                               const double side = i / 500 % 2 == 0 ? 1.0 : -1.0;
                               engine.push(9 - i / 500 % 10, {15.0 * side, 0.0, 0.0});
                           }
                       },
                       false});
    EngineCourse thrown{"10, and a cube that falls on them from 1 m each second", make_stack(10),
                        [](StackEngine& engine, int i) {
                            if (i % 1000 == 999) {
                                engine.throw_from(10, {0.02, 2.0, 0.01}, Vector3::Zero());
                            }
                        },
                        false};
    thrown.scene.boxes.push_back({.at_W = {0.02, 2.0, 0.01}});
    courses.push_back(std::move(thrown));
    EngineCourse wall{"a wall of 100 bricks", make_wall(), leave};
    courses.push_back(wall);
    wall.name = "the wall, hit by 2 kg at 3 m/s";
    wall.rests = false;
    wall.leans = true;
    wall.scene.boxes.push_back({.mass_kg = 2.0, .at_W = {0.93, 0.53, 5.0}});
    wall.disturb = [](StackEngine& engine, int i) {
        if (i == 100) {
            engine.throw_from(100, {0.93, 0.53, 0.4}, {0.0, 0.3, -3.0});
        }
    };
    courses.push_back(std::move(wall));
    return courses;
}

std::vector<std::vector<std::string>> measure_stack_engine(const std::string& name,
                                                           const MakeStackEngine& make,
                                                           const Run& run) {
    Sheet sheet;
    for (const EngineCourse& course : make_engine_courses()) {
        run.progress(0.9, name + ": " + course.name);
        measure_course(name, course, make, run.pick(5000, 300), sheet);
    }
    return sheet.rows;
}

Sheet measure_stack_engines(const Run& run) {
    Sheet sheet{
        "rigid-engines",
        "The same stacks and the same wall, whoever steps them",
        "Cubes of 0.1 m and 1 kg and bricks of 0.2 m and 1 kg, friction 0.6, 5 s at 1 ms a step, "
        "collision detection included, one thread, its processor time, nothing sleeps. Depth: the "
        "deepest that one of two boxes that stood upon each other sank into the other, while both "
        "were within 20 mm of where they began. Moved: boxes farther than 20 mm from there at the "
        "end. A course ends after 12 s of computing.",
        "Ours is the one in which all of these stand exactly where they were put.",
        {"engine", "course", "median µs", "99 % µs", "worst µs", "deep mm", "sideways mm", "moved",
         "steps"}};
    sheet.rows = measure_stack_engine("Fulcrum", make_fulcrum_stack, run);
    return sheet;
}

}  // namespace fulcrum::bench
