// The factor of a part of a symmetric positive definite matrix, kept while rows join the part and leave it.
//
//   A_CC = L D L^T;   a row that joins:  L' row l = D^-1 L^-1 a,  d = a_ii - sum D l^2;   one that leaves: what stood behind it is
//   factored anew as L22 D2 L22^T + d l l^T, an update of rank one
// Each row of L is kept from its first entry that is not zero: rows told in the order of a chain cost what the chain is wide.
// A d below a share of a_ii is lost to rounding, for the row follows from others: it is put at that share, and counted.
//
// Thread: that of the solver. Cost: of a join, a leave or a solve at most rows squared; 8 bytes a pair of rows.
// Source: P. Gill, G. Golub, W. Murray, M. Saunders 1974, Methods for modifying matrix factorizations, Math. Comput. 28, method C1;
// D. Baraff 1994, Fast contact force computation for nonpenetrating rigid bodies, SIGGRAPH, section 4.4.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace fulcrum {

class IncrementalLdlt {
  public:
    explicit IncrementalLdlt(std::size_t max_rows);

    void clear() noexcept { n_ = 0; }
    [[nodiscard]] std::size_t size() const noexcept { return n_; }
    /// A row joins at the end: its entries with those that are there, in their order, and its own. False where it was lost to
    /// rounding and mended, or there is no room.
    bool append(std::span<const double> entries, double diagonal) noexcept;
    /// Those behind move up.
    void remove(std::size_t place) noexcept;
    /// b becomes x.
    void solve(std::span<double> b) const noexcept;

  private:
    [[nodiscard]] double* row(std::size_t i) noexcept { return &L_[i * max_rows_]; }
    [[nodiscard]] const double* row(std::size_t i) const noexcept { return &L_[i * max_rows_]; }
    void update_behind(std::size_t place) noexcept;
    std::size_t max_rows_;
    std::size_t n_ = 0;
    std::vector<double> L_, D_, work_;
    std::vector<std::size_t> first_;  // column of a row's first entry
};

}  // namespace fulcrum
