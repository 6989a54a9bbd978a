#include "haptics/constraint/incremental_ldlt.h"

#include <algorithm>

namespace fulcrum {
namespace {

constexpr double kLeastDiagonal = 1.0e-11;  // of the diagonal

}  // namespace

IncrementalLdlt::IncrementalLdlt(std::size_t max_rows)
    : max_rows_(max_rows),
      L_(max_rows * max_rows),
      D_(max_rows),
      work_(max_rows),
      first_(max_rows) {}

bool IncrementalLdlt::append(std::span<const double> entries, double diagonal) noexcept {
    if (n_ == max_rows_) {
        return false;
    }
    double* l = row(n_);
    std::size_t begin = 0;
    while (begin < n_ && entries[begin] == 0.0) {
        ++begin;
    }
    first_[n_] = begin;
    double pivot = diagonal;
    // y = L^-1 a in l's place, then l = D^-1 y.
    for (std::size_t j = begin; j < n_; ++j) {
        const double* other = row(j);
        double y = entries[j];
        for (std::size_t m = std::max(begin, first_[j]); m < j; ++m) {
            y -= other[m] * l[m];
        }
        l[j] = y;
    }
    for (std::size_t j = begin; j < n_; ++j) {
        const double y = l[j];
        l[j] = y / D_[j];
        pivot -= y * l[j];
    }
    const double least = kLeastDiagonal * diagonal;
    D_[n_++] = std::max(pivot, least);
    return pivot > least;
}

void IncrementalLdlt::update_behind(std::size_t place) noexcept {
    double alpha = D_[place];
    for (std::size_t i = place + 1; i < n_; ++i) {
        work_[i] = first_[i] <= place ? row(i)[place] : 0.0;
    }
    for (std::size_t j = place + 1; j < n_; ++j) {
        const double p = work_[j];
        if (p == 0.0) {
            continue;
        }
        const double before = D_[j];
        D_[j] = before + alpha * p * p;
        const double beta = p * alpha / D_[j];
        alpha *= before / D_[j];
        for (std::size_t i = j + 1; i < n_; ++i) {
            if (first_[i] <= j) {
                double& l = row(i)[j];
                work_[i] -= p * l;
                l += beta * work_[i];
            }
        }
    }
}

void IncrementalLdlt::remove(std::size_t place) noexcept {
    update_behind(place);
    for (std::size_t i = place + 1; i < n_; ++i) {
        const double* from = row(i);
        double* to = row(i - 1);
        const std::size_t begin = first_[i];
        std::copy(from + std::min(begin, place), from + place, to + std::min(begin, place));
        std::copy(from + std::max(begin, place + 1), from + i, to + std::max(begin, place + 1) - 1);
        first_[i - 1] = begin > place ? begin - 1 : begin;
        D_[i - 1] = D_[i];
    }
    --n_;
}

void IncrementalLdlt::solve(std::span<double> b) const noexcept {
    for (std::size_t i = 0; i < n_; ++i) {
        const double* l = row(i);
        for (std::size_t j = first_[i]; j < i; ++j) {
            b[i] -= l[j] * b[j];
        }
    }
    for (std::size_t i = 0; i < n_; ++i) {
        b[i] /= D_[i];
    }
    for (std::size_t i = n_; i-- > 0;) {
        const double* l = row(i);
        for (std::size_t j = first_[i]; j < i; ++j) {
            b[j] -= l[j] * b[i];
        }
    }
}

}  // namespace fulcrum
