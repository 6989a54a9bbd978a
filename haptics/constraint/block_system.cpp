#include "haptics/constraint/block_system.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>

namespace fulcrum {
namespace {

constexpr std::size_t kBits = 64;
constexpr std::size_t kBlocksABody = 32;  // more fill than that has no heap of bodies
// A pivot below this share of what stood in its place is rounding.
constexpr double kLeastPivot = 1.0e-15;
constexpr double kTiny = 1.0e-300;

bool has_bit(const std::uint64_t* row, std::size_t i) noexcept {
    return ((row[i / kBits] >> (i % kBits)) & 1U) != 0;
}
void set_bit(std::uint64_t* row, std::size_t i) noexcept {
    row[i / kBits] |= std::uint64_t{1} << (i % kBits);
}

// What stands in for a pivot that is lost.
double mend(double pivot, double stood, int& n_replaced) noexcept {
    if (pivot > kLeastPivot * std::abs(stood)) {
        return pivot;
    }
    ++n_replaced;
    return std::max(std::abs(stood), kTiny);
}

// The lower triangle of H becomes L of H = L L^T.
int factor_symmetric(Matrix6& H, Vector6& inverse) noexcept {
    int n_replaced = 0;
    const Vector6 stood = H.diagonal();
    for (int k = 0; k < 6; ++k) {
        const double root = std::sqrt(mend(H(k, k), stood[k], n_replaced));
        H(k, k) = root;
        inverse[k] = 1.0 / root;
        for (int i = k + 1; i < 6; ++i) {
            H(i, k) *= inverse[k];
        }
        for (int j = k + 1; j < 6; ++j) {
            const double factor = H(j, k);
            for (int i = j; i < 6; ++i) {
                H(i, j) -= H(i, k) * factor;
            }
        }
    }
    return n_replaced;
}

// H becomes L below the diagonal, whose own is 1, and U.
int factor_general(Matrix6& H, Vector6& inverse) noexcept {
    int n_replaced = 0;
    const Vector6 stood = H.diagonal();
    for (int k = 0; k < 6; ++k) {
        // Friction may turn a pivot's sign; only its size counts.
        H(k, k) = std::copysign(mend(std::abs(H(k, k)), stood[k], n_replaced), H(k, k));
        inverse[k] = 1.0 / H(k, k);
        for (int i = k + 1; i < 6; ++i) {
            H(i, k) *= inverse[k];
        }
        for (int j = k + 1; j < 6; ++j) {
            const double factor = H(k, j);
            for (int i = k + 1; i < 6; ++i) {
                H(i, j) -= H(i, k) * factor;
            }
        }
    }
    return n_replaced;
}

// B becomes B L^-T.
void divide_by_lower_transposed(Matrix6& B, const Matrix6& L, const Vector6& inverse) noexcept {
    for (int k = 0; k < 6; ++k) {
        for (int j = 0; j < k; ++j) {
            B.col(k) -= B.col(j) * L(k, j);
        }
        B.col(k) *= inverse[k];
    }
}
// B becomes B U^-1.
void divide_by_upper(Matrix6& B, const Matrix6& U, const Vector6& inverse) noexcept {
    for (int k = 0; k < 6; ++k) {
        for (int j = 0; j < k; ++j) {
            B.col(k) -= B.col(j) * U(j, k);
        }
        B.col(k) *= inverse[k];
    }
}

// x becomes L^-1 x; L's diagonal is 1 where H is not symmetric.
void solve_lower(const Matrix6& L, const Vector6& inverse, bool symmetric, Vector6& x) noexcept {
    for (int k = 0; k < 6; ++k) {
        if (symmetric) {
            x[k] *= inverse[k];
        }
        for (int i = k + 1; i < 6; ++i) {
            x[i] -= L(i, k) * x[k];
        }
    }
}
// x becomes L^-T x, or U^-1 x.
void solve_upper(const Matrix6& F, const Vector6& inverse, bool symmetric, Vector6& x) noexcept {
    for (int k = 5; k >= 0; --k) {
        for (int i = k + 1; i < 6; ++i) {
            x[k] -= (symmetric ? F(i, k) : F(k, i)) * x[i];
        }
        x[k] *= inverse[k];
    }
}

}  // namespace

BlockSystem::BlockSystem(int max_bodies)
    : max_bodies_(static_cast<std::size_t>(std::max(max_bodies, 1))),
      told_(max_bodies_ * ((max_bodies_ + kBits - 1) / kBits)),
      ordered_(told_),
      neighbours_(told_),
      left_((max_bodies_ + kBits - 1) / kBits),
      block_of_(max_bodies_ * max_bodies_, -1),
      order_(max_bodies_),
      place_(max_bodies_),
      column_begin_(max_bodies_ + 1),
      diagonals_(max_bodies_, Matrix6::Zero()),
      inverse_pivots_(max_bodies_, Vector6::Zero()) {
    const std::size_t all = max_bodies_ * (max_bodies_ - 1) / 2;
    blocks_.resize(std::min(all, kBlocksABody * max_bodies_), Matrix6::Zero());
    mirrors_.resize(blocks_.size(), Matrix6::Zero());
    row_body_.resize(blocks_.size());
}

void BlockSystem::begin(int n_bodies) noexcept {
    n_ = std::min(static_cast<std::size_t>(std::max(n_bodies, 0)), max_bodies_);
    n_words_ = (n_ + kBits - 1) / kBits;
    std::fill_n(told_.begin(), n_ * n_words_, 0);
}

void BlockSystem::add_pair(int body_a, int body_b) noexcept {
    if (body_a < 0 || body_b < 0) {
        return;
    }
    const auto a = static_cast<std::size_t>(body_a);
    const auto b = static_cast<std::size_t>(body_b);
    set_bit(&told_[a * n_words_], b);
    set_bit(&told_[b * n_words_], a);
}

std::size_t BlockSystem::pick_next() const noexcept {
    std::size_t best = 0;
    int fewest = std::numeric_limits<int>::max();
    for (std::size_t body = 0; body < n_; ++body) {
        if (!has_bit(left_.data(), body)) {
            continue;
        }
        int degree = 0;
        for (std::size_t w = 0; w < n_words_; ++w) {
            degree += std::popcount(neighbours_[body * n_words_ + w] & left_[w]);
        }
        if (degree < fewest) {
            fewest = degree;
            best = body;
        }
    }
    return best;
}

bool BlockSystem::eliminate(std::size_t body, std::size_t place) noexcept {
    order_[place] = static_cast<std::uint32_t>(body);
    place_[body] = static_cast<std::uint32_t>(place);
    left_[body / kBits] &= ~(std::uint64_t{1} << (body % kBits));
    const std::uint64_t* mine = &neighbours_[body * n_words_];
    for (std::size_t other = 0; other < n_; ++other) {
        if (!has_bit(mine, other) || !has_bit(left_.data(), other)) {
            continue;
        }
        if (n_blocks_ == blocks_.size()) {
            return false;
        }
        row_body_[n_blocks_] = static_cast<std::uint32_t>(other);
        block_of_[cell(body, other)] = block_of_[cell(other, body)] =
            static_cast<std::int32_t>(n_blocks_++);
        for (std::size_t w = 0; w < n_words_; ++w) {
            neighbours_[other * n_words_ + w] |= mine[w];
        }
        neighbours_[other * n_words_ + other / kBits] &= ~(std::uint64_t{1} << (other % kBits));
    }
    column_begin_[place + 1] = static_cast<std::uint32_t>(n_blocks_);
    return true;
}

bool BlockSystem::find_order() noexcept {
    const auto told_end = told_.begin() + static_cast<std::ptrdiff_t>(n_ * n_words_);
    if (n_ == n_ordered_ && std::equal(told_.begin(), told_end, ordered_.begin())) {
        return true;
    }
    ++n_orders_;
    n_blocks_ = 0;
    n_ordered_ = 0;
    column_begin_[0] = 0;
    std::copy(told_.begin(), told_end, ordered_.begin());
    std::copy(told_.begin(), told_end, neighbours_.begin());
    std::fill_n(block_of_.begin(), n_ * n_, -1);
    std::fill_n(left_.begin(), n_words_, 0);
    for (std::size_t body = 0; body < n_; ++body) {
        set_bit(left_.data(), body);
    }
    for (std::size_t place = 0; place < n_; ++place) {
        if (!eliminate(pick_next(), place)) {
            return false;
        }
    }
    n_ordered_ = n_;
    return true;
}

void BlockSystem::clear(bool symmetric) noexcept {
    symmetric_ = symmetric;
    std::fill_n(diagonals_.begin(), n_, Matrix6::Zero());
    std::fill_n(blocks_.begin(), n_blocks_, Matrix6::Zero());
    if (!symmetric) {
        std::fill_n(mirrors_.begin(), n_blocks_, Matrix6::Zero());
    }
}

void BlockSystem::add(int row_body, int column_body, const Matrix6& K,
                      const Matrix6& opposite_transposed) noexcept {
    const auto row = static_cast<std::size_t>(row_body);
    const auto column = static_cast<std::size_t>(column_body);
    const auto block = static_cast<std::size_t>(block_of_[cell(row, column)]);
    if (place_[row] > place_[column]) {
        blocks_[block] += K;
        if (!symmetric_) {
            mirrors_[block] += opposite_transposed;
        }
    } else {
        blocks_[block] += opposite_transposed.transpose();
        if (!symmetric_) {
            mirrors_[block] += K.transpose();
        }
    }
}

template <bool symmetric>
void BlockSystem::subtract_product(std::size_t row, std::size_t other, std::size_t i,
                                   std::size_t j) noexcept {
    const auto target = static_cast<std::size_t>(block_of_[cell(row, other)]);
    if constexpr (symmetric) {
        blocks_[target] -= blocks_[i] * blocks_[j].transpose();
    } else {
        blocks_[target] -= blocks_[i] * mirrors_[j].transpose();
        mirrors_[target] -= mirrors_[i] * blocks_[j].transpose();
    }
}

template <bool symmetric>
void BlockSystem::eliminate_column(std::size_t column) noexcept {
    const std::size_t begin = column_begin_[column];
    const std::size_t end = column_begin_[column + 1];
    const std::size_t body = order_[column];
    const Matrix6& pivot = diagonals_[body];
    for (std::size_t i = begin; i < end; ++i) {
        if constexpr (symmetric) {
            divide_by_lower_transposed(blocks_[i], pivot, inverse_pivots_[body]);
        } else {
            divide_by_upper(blocks_[i], pivot, inverse_pivots_[body]);
            divide_by_lower_transposed(mirrors_[i], pivot, Vector6::Ones());
        }
    }
    for (std::size_t i = begin; i < end; ++i) {
        const std::size_t row = row_body_[i];
        const Matrix6& opposite = symmetric ? blocks_[i] : mirrors_[i];
        diagonals_[row] -= blocks_[i] * opposite.transpose();
        for (std::size_t j = begin; j < i; ++j) {
            const std::size_t other = row_body_[j];
            if (place_[row] > place_[other]) {
                subtract_product<symmetric>(row, other, i, j);
            } else {
                subtract_product<symmetric>(other, row, j, i);
            }
        }
    }
}

template <bool symmetric>
int BlockSystem::factor_columns() noexcept {
    int n_replaced = 0;
    for (std::size_t column = 0; column < n_; ++column) {
        const std::size_t body = order_[column];
        n_replaced += symmetric ? factor_symmetric(diagonals_[body], inverse_pivots_[body])
                                : factor_general(diagonals_[body], inverse_pivots_[body]);
        eliminate_column<symmetric>(column);
    }
    return n_replaced;
}

int BlockSystem::factor() noexcept {
    return symmetric_ ? factor_columns<true>() : factor_columns<false>();
}

void BlockSystem::solve(std::span<Vector6> g) const noexcept {
    for (std::size_t column = 0; column < n_; ++column) {
        const std::size_t body = order_[column];
        Vector6& x = g[body];
        solve_lower(diagonals_[body], inverse_pivots_[body], symmetric_, x);
        for (std::size_t i = column_begin_[column]; i < column_begin_[column + 1]; ++i) {
            g[row_body_[i]] -= blocks_[i] * x;
        }
    }
    const std::vector<Matrix6>& opposite = symmetric_ ? blocks_ : mirrors_;
    for (std::size_t column = n_; column-- > 0;) {
        const std::size_t body = order_[column];
        Vector6& x = g[body];
        for (std::size_t i = column_begin_[column]; i < column_begin_[column + 1]; ++i) {
            x -= opposite[i].transpose() * g[row_body_[i]];
        }
        solve_upper(diagonals_[body], inverse_pivots_[body], symmetric_, x);
    }
}

}  // namespace fulcrum
