// The charts of Otaduy & Lin 2005, figures 4 and 6: a quantity over the milliseconds of a course, a line a variant.
#pragma once

#include "tests/bench/harness/report.h"

#include <cstddef>
#include <utility>
#include <vector>

namespace fulcrum::bench {

/// What is drawn of a sample.
template <class Sample>
struct CourseQuantity {
    const char* name;
    const char* title;
    Axis y;
    double (*value)(const Sample&);
    const char* advice;
};

/// The chart of one quantity; a variant has a `name` and a course.
template <class Sample, class Variants>
[[nodiscard]] LineChart make_course_chart(const CourseQuantity<Sample>& quantity,
                                          const Variants& variants,
                                          const std::vector<std::vector<Sample>>& courses) {
    LineChart chart;
    chart.name = quantity.name;
    chart.title = quantity.title;
    chart.advice = quantity.advice;
    chart.x = {"time", "ms"};
    chart.y = quantity.y;
    for (std::size_t i = 0; i < variants.size(); ++i) {
        chart.draw(
            variants[i].name, courses[i], [](const Sample&) { return true; },
            [](const Sample& sample) { return 1.0e3 * sample.time_s; }, quantity.value);
    }
    return chart;
}

}  // namespace fulcrum::bench
