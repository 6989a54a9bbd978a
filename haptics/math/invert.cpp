// The half of dense.h that only loads: it allocates.
#include "haptics/math/dense.h"
#include "haptics/math/plain_eigen.h"

#include <Eigen/LU>

namespace fulcrum {

bool invert(std::span<double> A, std::size_t n) {
    const auto size = static_cast<Eigen::Index>(n);
    Eigen::Map<Eigen::MatrixXd> whole(A.data(), size, size);
    const Eigen::FullPivLU<Eigen::MatrixXd> lu(whole);
    if (!whole.allFinite() || !lu.isInvertible()) {
        return false;
    }
    whole = lu.inverse();
    return true;
}

}  // namespace fulcrum
