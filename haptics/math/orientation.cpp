#include "haptics/math/orientation.h"

#include <array>
#include <cstddef>

namespace fulcrum {

namespace {

// A number as an unrounded pair: value = high + low.
struct Pair {
    double high = 0.0;
    double low = 0.0;
};

Pair two_sum(double a, double b) noexcept {
    const double sum = a + b;
    const double b_part = sum - a;
    const double a_part = sum - b_part;
    return {sum, (a - a_part) + (b - b_part)};
}

Pair two_difference(double a, double b) noexcept {
    return two_sum(a, -b);
}

Pair two_product(double a, double b) noexcept {
    const double product = a * b;
    return {product, std::fma(a, b, -product)};
}

// A sum of doubles kept as parts that do not overlap, smallest first; its sign is that of the last part.
class ExactSum {
  public:
    void add(double value) noexcept {
        std::size_t n_kept = 0;
        for (std::size_t i = 0; i < n_parts_; ++i) {
            const Pair sum = two_sum(value, parts_[i]);
            if (sum.low != 0.0) {
                parts_[n_kept++] = sum.low;
            }
            value = sum.high;
        }
        if (value != 0.0) {
            parts_[n_kept++] = value;
        }
        n_parts_ = n_kept;
    }

    // Adds x y z.
    void add_product(double x, double y, double z) noexcept {
        if (x == 0.0 || y == 0.0 || z == 0.0) {
            return;
        }
        const Pair xy = two_product(x, y);
        for (const double part : {xy.low, xy.high}) {
            const Pair xyz = two_product(part, z);
            add(xyz.low);
            add(xyz.high);
        }
    }

    [[nodiscard]] int sign() const noexcept {
        return n_parts_ == 0 ? 0 : (parts_[n_parts_ - 1] > 0.0 ? 1 : -1);
    }

  private:
    // Six products of three pairs, each of eight products of doubles, four doubles each.
    static constexpr std::size_t kMaxTerms = std::size_t{6} * 8 * 4;
    std::array<double, kMaxTerms> parts_{};
    std::size_t n_parts_ = 0;
};

void add_signed_product(ExactSum& sum, double sign, const Pair& x, const Pair& y,
                        const Pair& z) noexcept {
    for (const double x_part : {x.low, x.high}) {
        for (const double y_part : {y.low, y.high}) {
            for (const double z_part : {z.low, z.high}) {
                sum.add_product(sign * x_part, y_part, z_part);
            }
        }
    }
}

}  // namespace

int orientation_exact(const Vector3& a, const Vector3& b, const Vector3& c,
                      const Vector3& d) noexcept {
    std::array<Pair, 3> u;
    std::array<Pair, 3> v;
    std::array<Pair, 3> w;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const auto i = static_cast<Index>(axis);
        u[axis] = two_difference(b[i], a[i]);
        v[axis] = two_difference(c[i], a[i]);
        w[axis] = two_difference(d[i], a[i]);
    }
    ExactSum sum;
    for (std::size_t i = 0; i < 3; ++i) {
        const std::size_t j = (i + 1) % 3;
        const std::size_t k = (i + 2) % 3;
        add_signed_product(sum, 1.0, u[i], v[j], w[k]);
        add_signed_product(sum, -1.0, u[i], v[k], w[j]);
    }
    return sum.sign();
}

}  // namespace fulcrum
