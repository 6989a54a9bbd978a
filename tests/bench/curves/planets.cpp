// Where the planets are, by scripts/lib/planets.lua: what each of its methods errs by over 1800 to 2050, and what it costs in
// Lua.
#include "tests/bench/harness/curve.h"
#include "tests/unit/runtime/lua/hosted_lesson.h"

#include <cstdlib>
#include <fstream>
#include <sstream>
#include <stdexcept>

namespace fulcrum::bench {
namespace {

constexpr std::array kMethods{"circle", "ellipse", "elements"};
constexpr std::array kPlanets{"Mercury", "Venus",  "Earth",  "Mars",
                              "Jupiter", "Saturn", "Uranus", "Neptune"};
constexpr int kPlacesAFrame = 200;

std::string read_text(const std::string& file) {
    std::ifstream in(std::string(FULCRUM_SOURCE_DIR) + '/' + file);
    std::stringstream text;
    text << in.rdbuf();
    if (!in || text.str().empty()) {
        throw std::runtime_error("cannot read " + file);
    }
    return text.str();
}

struct KnownPlace {
    std::string planet;
    double day = 0.0;
    Vector3 place_au{Vector3::Zero()};
};

std::vector<KnownPlace> read_reference() {
    std::istringstream lines(read_text("tests/bench/curves/planets_vsop87.csv"));
    std::vector<KnownPlace> known;
    for (std::string line; std::getline(lines, line);) {
        if (line.starts_with('#') || line.starts_with("planet")) {
            continue;
        }
        std::replace(line.begin(), line.end(), ',', ' ');
        std::istringstream fields(line);
        KnownPlace place;
        fields >> place.planet >> place.day >> place.place_au.x() >> place.place_au.y() >>
            place.place_au.z();
        if (!fields) {
            throw std::runtime_error("planets_vsop87.csv has a line that is no place: " + line);
        }
        known.push_back(place);
    }
    return known;
}

// A lesson in this process that can require the module, as it is shipped.
class Lesson {
  public:
    explicit Lesson(const std::string& body) {
        message_.lesson = {"lesson.lua", "local L = lesson { id = \"t\", title = \"T\" }\n" + body +
                                             "\nreturn L\n"};
        runtime::HostServices services;
        services.find_module = [](const std::string& name) {
            return runtime::ModuleAnswer{name == "planets",
                                         {"lib/planets.lua", read_text("scripts/lib/planets.lua")},
                                         "there is only planets"};
        };
        services.print_while_loading = [this](const std::string& line) { prints_ += line + '\n'; };
        host_ = std::make_unique<runtime::LessonHost>(message_, services);
        if (const auto error = host_->load(); error) {
            throw std::runtime_error(to_sentence(to_error(*error)));
        }
    }
    void play() {
        runtime::LessonFrame frame;
        frame.dt_s = 1.0 / 60.0;
        runtime::LessonReply reply;
        if (const auto error = host_->run_frame(frame, reply); error) {
            throw std::runtime_error(to_sentence(to_error(*error)));
        }
    }
    [[nodiscard]] const std::string& prints() const { return prints_; }

  private:
    runtime::LoadMessage message_;
    std::string prints_;
    std::unique_ptr<runtime::LessonHost> host_;
};

struct Errors {
    double worst_deg = 0.0;
    double rms_deg = 0.0;
};

// What one method errs by for one planet, seen from the Sun.
Errors compute_errors(const std::vector<KnownPlace>& known, const std::string& planet,
                      const std::string& method) {
    std::string days;
    std::vector<Vector3> places;
    for (const KnownPlace& place : known) {
        if (place.planet == planet) {
            days += std::to_string(place.day) + ", ";
            places.push_back(place.place_au);
        }
    }
    // Ten places a line: a script's lines are counted.
    const Lesson lesson("local planets = require 'planets'\nlocal days, line = {" + days +
                        "}, ''\nfor i, day in ipairs(days) do\n  line = line .. "
                        "string.format('%.9f %.9f %.9f ', planets.place('" +
                        planet + "', day, '" + method +
                        "'))\n  if i % 10 == 0 or i == #days then print(line) line = '' end\nend");
    std::istringstream found(lesson.prints());
    Errors errors;
    for (const Vector3& place : places) {
        Vector3 p;
        if (!(found >> p.x() >> p.y() >> p.z())) {
            throw std::runtime_error("a place of " + planet + " was not printed");
        }
        const double error_deg =
            std::atan2(p.cross(place).norm(), p.dot(place)) * 180.0 / std::numbers::pi;
        errors.worst_deg = std::max(errors.worst_deg, error_deg);
        errors.rms_deg += error_deg * error_deg;
    }
    errors.rms_deg = std::sqrt(errors.rms_deg / static_cast<double>(places.size()));
    return errors;
}

Cost measure_place(Run& run, const std::string& planet, const std::string& method) {
    const auto frame = [](const std::string& call) {
        return "local planets = require 'planets'\nlocal day = -70000\nfunction L:update()\n  for "
               "i = 1, " +
               std::to_string(kPlacesAFrame) +
               " do\n    day = day < 18000 and day + 1 or -70000\n" + call + "\n  end\nend";
    };
    const Timing timing{run.pick(200, 40), 1, 10};
    Lesson with(frame("    planets.place('" + planet + "', day, '" + method + "')"));
    Lesson without(frame(""));
    const Cost full = measure_cost([&] { with.play(); }, timing);
    const Cost empty = measure_cost([&] { without.play(); }, timing);
    return {std::max(full.median_us - empty.median_us, 0.0) / kPlacesAFrame,
            std::max(full.p99_us - empty.median_us, 0.0) / kPlacesAFrame, 0};
}

Report run_planets(Run& run) {
    const std::vector<KnownPlace> known = read_reference();
    CostCurve curve;
    curve.name = "planets";
    curve.title = "Where the planets are";
    curve.work =
        "planets.place in Lua, for eight planets on 60 days from 1800 to 2050: evenly round a "
        "circle, on the ellipse of the year 2000, and on Standish's ellipse that changes. The "
        "angle is that seen from the Sun; the time is a place's, less the loop around it.";
    curve.reference =
        "the theory VSOP87 as libnova 0.16 computes it (places in planets_vsop87.csv), itself "
        "within an arc second or so of the numerical ephemerides in these years: a reference, not "
        "a truth";
    curve.knob = {"planet, from the Sun outwards", "", false};
    curve.error = {"largest error, seen from the Sun", "degrees", true};
    curve.extras = {{"error, rms", "degrees", true}};
    curve.default_series = "elements";
    curve.default_knob = 3;
    curve.advice =
        "The changing elements cost little more than the fixed ellipse, for Kepler's equation "
        "takes most of the time; both put a planet where the eye looks for it, and a circle does "
        "not: Mercury is up to 24 degrees off.";
    curve.time_is_per = "place";
    for (const char* method : kMethods) {
        for (std::size_t i = 0; i < kPlanets.size(); ++i) {
            run.progress(static_cast<double>(curve.points.size()) / 24.0, method);
            const Errors errors = compute_errors(known, kPlanets[i], method);
            curve.add(method, static_cast<double>(i + 1), errors.worst_deg,
                      measure_place(run, kPlanets[i], method), {errors.rms_deg});
        }
    }
    return {curve};
}

const Registration kPlanetsCurve{
    {"planets", "places of the planets: circle, ellipse, changing elements", run_planets}};

}  // namespace
}  // namespace fulcrum::bench
