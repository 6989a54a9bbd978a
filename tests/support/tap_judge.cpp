#include "tests/support/tap_judge.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <cstddef>
#include <limits>
#include <numbers>
#include <numeric>

namespace fulcrum::test {
namespace {

using Course = std::vector<double>;
constexpr std::size_t kLags = 6;      // of the hand's way: coupling, damper and their filters
constexpr std::size_t kRounds = 60;   // at most
constexpr std::size_t kLeast = 3;     // a shorter touch is none
constexpr double kDecayCounts = 0.3;  // ears and hands tell pitches better than decays
constexpr double kLeastRest = 0.1;    // of a ring that the hand's way alone could explain

double dot(const Course& a, const Course& b) {
    return std::inner_product(a.begin(), a.end(), b.begin(), 0.0);
}

void subtract(double share, const Course& from, Course& course) {
    std::ranges::transform(course, from, course.begin(),
                           [share](double x, double y) { return x - share * y; });
}

// An orthonormal basis of columns, by the modified Gram-Schmidt method, and the triangle with columns = basis * triangle.
class Basis {
  public:
    void add(Course column) {
        std::array<double, kLags> shares{};
        for (std::size_t k = 0; k < columns_.size(); ++k) {
            shares[k] = dot(columns_[k], column);
            subtract(shares[k], columns_[k], column);
        }
        const double length = std::max(std::sqrt(dot(column, column)), 1e-300);
        shares[columns_.size()] = length;
        for (double& x : column) {
            x /= length;
        }
        columns_.push_back(std::move(column));
        triangle_.push_back(shares);
    }
    // What it leaves of a course.
    [[nodiscard]] Course find_rest(Course course) const {
        for (const Course& column : columns_) {
            subtract(dot(column, course), column, course);
        }
        return course;
    }
    // The sum of the columns' shares that come nearest to a course.
    [[nodiscard]] double find_sum(Course course) const {
        std::array<double, kLags> shares{};
        for (std::size_t k = 0; k < columns_.size(); ++k) {
            shares[k] = dot(columns_[k], course);
            subtract(shares[k], columns_[k], course);
        }
        for (std::size_t k = columns_.size(); k-- > 0;) {
            for (std::size_t j = k + 1; j < columns_.size(); ++j) {
                shares[k] -= triangle_[j][k] * shares[j];
            }
            shares[k] /= triangle_[k][k];
        }
        return std::accumulate(shares.begin(), shares.end(), 0.0);
    }

  private:
    std::vector<Course> columns_;
    std::vector<std::array<double, kLags>> triangle_;
};

// From the second round on, until the hand is out.
std::size_t count_rounds(const TapForces& forces) {
    const std::size_t most = std::min(kRounds, forces.depth_m.size());
    const auto out = std::find_if(forces.depth_m.begin() + kLeast,
                                  forces.depth_m.begin() + static_cast<std::ptrdiff_t>(most),
                                  [](double depth_m) { return depth_m < 0.0; });
    return static_cast<std::size_t>(out - forces.depth_m.begin());
}

Basis find_ways(const TapForces& forces, std::size_t n) {
    Basis ways;
    for (std::size_t lag = 0; lag < kLags; ++lag) {
        Course way(n - 1, 0.0);
        for (std::size_t i = std::max<std::size_t>(lag, 1); i < n; ++i) {
            way[i - 1] = forces.depth_m[i - lag];
        }
        ways.add(std::move(way));
    }
    return ways;
}

Course make_ring(double frequency_Hz, double decay_per_s, std::size_t n) {
    Course ring(n - 1);
    for (std::size_t i = 1; i < n; ++i) {
        const double t_s = (static_cast<double>(i) + 0.5) * kTapRound_s;
        ring[i - 1] =
            std::exp(-decay_per_s * t_s) * std::sin(2.0 * std::numbers::pi * frequency_Hz * t_s);
    }
    return ring;
}

double compute_felt_energy(const Course& course_N) {
    double energy = 0.0;
    for (double frequency_Hz = 20.0; frequency_Hz <= 400.0; frequency_Hz += 5.0) {
        std::complex<double> sum = 0.0;
        for (std::size_t i = 0; i < course_N.size(); ++i) {
            sum += course_N[i] * std::polar(1.0, -2.0 * std::numbers::pi * frequency_Hz *
                                                     kTapRound_s * static_cast<double>(i));
        }
        energy += std::norm(sum);
    }
    return energy;
}

}  // namespace

double find_share_sent(const TapForces& forces) {
    return compute_felt_energy(forces.sent_N) / compute_felt_energy(forces.asked_N);
}

TapTraits find_traits(const TapForces& forces) {
    TapTraits traits{1.0, 1.0, 1.0};
    if (forces.depth_m.size() <= kLeast) {
        return traits;
    }
    const std::size_t n = count_rounds(forces);
    const Basis ways = find_ways(forces, n);
    const Course sent(forces.sent_N.begin() + 1,
                      forces.sent_N.begin() + static_cast<std::ptrdiff_t>(n));
    const Course left = ways.find_rest(sent);
    double most = 0.0;
    for (double f = 10.0; f <= 220.0; f *= 1.07) {
        for (double b = 40.0; b <= 190.0; b *= 1.15) {
            const Course ring = make_ring(f, b, n);
            const Course rest = ways.find_rest(ring);
            const double square = dot(rest, rest);
            const double amplitude_N = dot(rest, left) / std::max(square, 1e-300);
            if (square < kLeastRest * kLeastRest * dot(ring, ring) || amplitude_N <= 0.0 ||
                amplitude_N * amplitude_N * square <= most) {
                continue;
            }
            most = amplitude_N * amplitude_N * square;
            Course slow = sent;
            subtract(amplitude_N, ring, slow);
            traits = {f, b, std::max(ways.find_sum(slow), 1.0)};
        }
    }
    return traits;
}

std::string TapJudge::tell(const TapForces& forces) const {
    const TapTraits traits = find_traits(forces);
    const auto find_way = [&](const TapTraits& known) {
        return std::hypot(std::log(known.frequency_Hz / traits.frequency_Hz),
                          kDecayCounts * std::log(known.decay_per_s / traits.decay_per_s),
                          std::log(known.stiffness_N_per_m / traits.stiffness_N_per_m));
    };
    const auto nearest = std::ranges::min_element(
        known_, {}, [&](const auto& known) { return find_way(known.second); });
    return nearest == known_.end() ? "" : nearest->first;
}

}  // namespace fulcrum::test
