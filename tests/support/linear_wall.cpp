#include "tests/support/linear_wall.h"

#include "haptics/math/plain_eigen.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cassert>
#include <cmath>
#include <complex>
#include <numbers>
#include <unsupported/Eigen/MatrixFunctions>

namespace fulcrum::z_width {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;
using Complex = std::complex<double>;

// A linear estimator as s' = A s + b y, v = c s' + d y, with y the newest position; velocities in metres a period.
struct Estimator {
    Eigen::Matrix2d a;
    Eigen::Vector2d b, c;
    double d;
};

Estimator make_estimator(const VelocitySettings& settings, double period_s) {
    assert(settings.method != VelocityMethod::adaptive_window);
    if (settings.method == VelocityMethod::kalman) {
        // Settled gains. State: position and velocity after the correction.
        KalmanVelocity filter;
        filter.start(Vector3::Zero());
        for (int k = 0; k < 100000; ++k) {
            filter.step(Vector3::Zero(), period_s, settings.acceleration_density,
                        settings.noise_bound_m);
        }
        const double g = filter.position_gain();
        const double h = filter.velocity_gain_per_s() * period_s;
        Estimator e{};
        e.a << 1.0 - g, 1.0 - g, -h, 1.0 - h;
        e.b << g, h;
        e.c << 0.0, 1.0;
        e.d = 0.0;
        return e;
    }
    // State: the position before, and the velocity. v = (1 - p) v_before + p (y - y_before).
    const double p = settings.method == VelocityMethod::finite_difference
                         ? 1.0
                         : 1.0 - std::exp(-2.0 * std::numbers::pi * settings.cutoff_Hz * period_s);
    Estimator e{};
    e.a << 0.0, 0.0, -p, 1.0 - p;
    e.b << 1.0, p;
    e.c << 0.0, 1.0;
    e.d = 0.0;
    return e;
}

// The plant over `periods`, in units in which a period and the first mode's mass are 1: exp of [A B; 0 0].
MatrixXd make_plant_step(const LinearWall& wall, double periods) {
    const auto n = static_cast<Index>(wall.modes.size());
    const double T = wall.period_s;
    MatrixXd a = MatrixXd::Zero(2 * n + 1, 2 * n + 1);
    for (Index i = 0; i < n; ++i) {
        const Mode& mode = wall.modes[static_cast<std::size_t>(i)];
        a(2 * i, 2 * i + 1) = 1.0;
        a(2 * i + 1, 2 * i) = -mode.stiffness_N_per_m * T * T / mode.mass_kg;
        a(2 * i + 1, 2 * i + 1) = -mode.damping_Ns_per_m * T / mode.mass_kg;
        for (Index j = 0; j < n; ++j) {
            a(2 * i + 1, 2 * j + 1) -= wall.device_damping_Ns_per_m * T / mode.mass_kg;
        }
        a(2 * i + 1, 2 * n) = wall.modes.front().mass_kg / mode.mass_kg;
    }
    return (a * periods).exp();
}

// Everything that one period changes, on a state of: modes, estimator, forces on their way (newest first).
class Period {
  public:
    explicit Period(const LinearWall& wall)
        : n_(static_cast<Index>(2 * wall.modes.size())),
          estimator_(make_estimator(wall.velocity, wall.period_s)) {
        const double late = wall.delay_s / wall.period_s;
        n_late_ = static_cast<Index>(std::floor(late + 1e-12));
        const double part = std::max(late - static_cast<double>(n_late_), 0.0);
        before_ = make_plant_step(wall, part);
        after_ = make_plant_step(wall, 1.0 - part);
        const double unit = wall.period_s * wall.period_s / wall.modes.front().mass_kg;
        stiffness_ = wall.stiffness_N_per_m * unit;
        damping_ = wall.damping_Ns_per_m * unit / wall.period_s;
    }

    [[nodiscard]] Index size() const { return n_ + 2 + n_late_ + 1; }

    [[nodiscard]] VectorXd step(const VectorXd& state) const {
        VectorXd next = state;
        // Measure, estimate, compute the force.
        double y = 0.0;
        for (Index i = 0; i < n_; i += 2) {
            y += state(i);
        }
        const Eigen::Vector2d seen = estimator_.a * state.segment<2>(n_) + estimator_.b * y;
        next.segment<2>(n_) = seen;
        const double force =
            -stiffness_ * y - damping_ * (estimator_.c.dot(seen) + estimator_.d * y);
        // The queue: F_k behind it those of the periods before, the last of which acts first.
        const Index queue = n_ + 2;
        for (Index i = n_late_; i > 0; --i) {
            next(queue + i) = state(queue + i - 1);
        }
        next(queue) = force;
        VectorXd plant(n_ + 1);
        plant << state.head(n_), state(queue + n_late_);
        plant = before_ * plant;
        plant(n_) = next(queue + n_late_);
        next.head(n_) = (after_ * plant).head(n_);
        return next;
    }

  private:
    Index n_;
    Estimator estimator_;
    Index n_late_ = 0;
    MatrixXd before_, after_;
    double stiffness_ = 0.0, damping_ = 0.0;
};

}  // namespace

double compute_spectral_radius(const LinearWall& wall) {
    const Period period(wall);
    MatrixXd monodromy(period.size(), period.size());
    for (Index i = 0; i < period.size(); ++i) {
        monodromy.col(i) = period.step(VectorXd::Unit(period.size(), i));
    }
    return monodromy.eigenvalues().cwiseAbs().maxCoeff();
}

double find_linear_boundary(LinearWall wall, double tolerance) {
    return find_largest(
        [&](double stiffness) {
            wall.stiffness_N_per_m = stiffness;
            return compute_spectral_radius(wall) < 1.0;
        },
        1.0, kStiffestLinear_N_per_m, tolerance);
}

double compute_passive_damping(const LinearWall& wall) {
    return wall.stiffness_N_per_m * (0.5 * wall.period_s + wall.delay_s) +
           std::abs(wall.damping_Ns_per_m);
}

double compute_exact_passive_damping(const LinearWall& wall) {
    constexpr int kFrequencies = 20000;
    const Estimator e = make_estimator(wall.velocity, wall.period_s);
    const double late = wall.delay_s / wall.period_s;
    double worst = -std::numeric_limits<double>::infinity();
    for (int i = 1; i <= kFrequencies; ++i) {
        const double theta = std::numbers::pi * i / kFrequencies;
        const Complex z = std::polar(1.0, theta);
        // v / y = c (1 - A / z)^-1 b + d.
        const Eigen::Matrix2cd m = Eigen::Matrix2cd::Identity() - e.a.cast<Complex>() / z;
        const Eigen::Vector2cd seen = m.inverse() * e.b.cast<Complex>();
        const Complex v = (e.c.cast<Complex>().transpose() * seen)(0) + e.d;
        const Complex h = (wall.stiffness_N_per_m + wall.damping_Ns_per_m / wall.period_s * v) *
                          std::polar(1.0, -theta * late);
        worst = std::max(worst, ((1.0 - 1.0 / z) * h).real() / (1.0 - std::cos(theta)));
    }
    return 0.5 * wall.period_s * worst;
}

std::vector<Mode> make_nyquist_hand(int n, double mass_kg, double period_s) {
    std::vector<Mode> modes;
    for (int i = 0; i < n; ++i) {
        const double w = (2.0 * i + 1.0) * std::numbers::pi / period_s;
        modes.push_back({mass_kg, 0.0, mass_kg * w * w});
    }
    return modes;
}

double compute_nyquist_share(int n) {
    double sum = 0.0;
    for (int i = 0; i < n; ++i) {
        sum += 1.0 / ((2.0 * i + 1.0) * (2.0 * i + 1.0));
    }
    return 8.0 / (std::numbers::pi * std::numbers::pi) * sum;
}

}  // namespace fulcrum::z_width
