#include "haptics/math/spectral_radius.h"

#include <cmath>
#include <limits>

namespace fulcrum {

double compute_spectral_radius(const Eigen::MatrixXd& A) {
    constexpr int kSquarings = 40;
    Eigen::MatrixXd power = A;
    Eigen::MatrixXd square(A.rows(), A.cols());
    double log_radius = 0.0;
    double share = 1.0;
    for (int i = 0; i <= kSquarings; ++i) {
        const double length =
            power.size() > 0 ? power.cwiseAbs().maxCoeff<Eigen::PropagateNaN>() : 0.0;
        if (!std::isfinite(length)) {
            return std::numeric_limits<double>::infinity();
        }
        if (length == 0.0) {
            return 0.0;
        }
        log_radius += share * std::log(length);
        share *= 0.5;
        power /= length;
        square.noalias() = power * power;
        power.swap(square);
    }
    return std::exp(log_radius);
}

}  // namespace fulcrum
