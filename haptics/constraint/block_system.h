// Solves H x = g where H consists of 6 x 6 blocks, one a body and two a pair of bodies that touch.
//
//   symmetric and positive definite: H = L L^T;   else H = L U, without exchanging rows
// by blocks, bodies in an order of elimination chosen for little fill: next is always the body with the fewest neighbours left
// (least number first where they are equal), and its neighbours become neighbours of each other. A stack, a chain or a tree gets no
// fill at all, and costs in proportion to its bodies. The order follows from the pairs alone, so an answer is the same to the bit
// whatever was solved before; it is kept while the pairs are the same.
//
// A pivot lost to rounding is replaced by what stood there before, and counted: the answer is finite and damped there.
//
// Thread: that of the solver. Cost: some 0.2 us a body of a chain, 0.4 where H is not symmetric; of finding the order, bodies
// squared. 4 bytes a pair of bodies, 600 a block.
// Source: A. George, J. Liu 1989, The evolution of the minimum degree ordering algorithm, SIAM Review 31; G. Golub, C. Van Loan,
// Matrix Computations, 3.2 and 4.2.
#pragma once

#include "haptics/constraint/contact_problem.h"

#include <cstdint>
#include <span>
#include <vector>

namespace fulcrum {

class BlockSystem {
  public:
    explicit BlockSystem(int max_bodies);

    /// Bodies without pairs.
    void begin(int n_bodies) noexcept;
    /// Tells of a pair; after all are told `has_order` is asked.
    void add_pair(int body_a, int body_b) noexcept;
    /// True when all pairs have blocks; finds an order where the pairs are others than last time. False: more fill than was reserved.
    bool find_order() noexcept;

    /// All blocks become zero. Of a symmetric H the blocks given by `add` stand for those opposite as well.
    void clear(bool symmetric) noexcept;
    /// H's block of a body; of a symmetric H its lower triangle counts.
    [[nodiscard]] Matrix6& diagonal(int body) noexcept {
        return diagonals_[static_cast<std::size_t>(body)];
    }
    /// Adds to H's blocks (row body, column body) and, transposed, (column body, row body).
    void add(int row_body, int column_body, const Matrix6& K,
             const Matrix6& opposite_transposed) noexcept;

    /// Returns how many pivots had to be replaced.
    int factor() noexcept;
    /// g becomes x; one vector a body.
    void solve(std::span<Vector6> g) const noexcept;

    [[nodiscard]] std::size_t n_blocks() const noexcept { return n_blocks_; }
    /// How often an order was found.
    [[nodiscard]] int n_orders() const noexcept { return n_orders_; }

  private:
    [[nodiscard]] std::size_t cell(std::size_t row, std::size_t column) const noexcept {
        return row * n_ + column;
    }
    [[nodiscard]] std::size_t pick_next() const noexcept;
    bool eliminate(std::size_t body, std::size_t place) noexcept;
    template <bool symmetric>
    int factor_columns() noexcept;
    template <bool symmetric>
    void eliminate_column(std::size_t column) noexcept;
    template <bool symmetric>
    void subtract_product(std::size_t row, std::size_t other, std::size_t i,
                          std::size_t j) noexcept;

    std::size_t max_bodies_;
    std::size_t n_words_ = 0;  // a row of the graph
    std::size_t n_ = 0;
    std::size_t n_ordered_ = 0;  // bodies of the order that is there; 0: none
    std::size_t n_blocks_ = 0;
    int n_orders_ = 0;
    bool symmetric_ = true;

    // The graph while an order is found: bit b of row a says that a and b are neighbours. `ordered_`: of the order that is there.
    std::vector<std::uint64_t> told_, ordered_, neighbours_, left_;

    std::vector<std::int32_t> block_of_;        // a pair of bodies, either way round; -1: none
    std::vector<std::uint32_t> order_, place_;  // body at a place, place of a body
    std::vector<std::uint32_t> column_begin_;   // of each place, into the two below
    std::vector<std::uint32_t> row_body_;       // bodies eliminated later
    std::vector<Matrix6> diagonals_;       // by body; in `factor` they become L's, or L's and U's
    std::vector<Matrix6> blocks_;          // row: the body eliminated later
    std::vector<Matrix6> mirrors_;         // the blocks opposite, transposed
    std::vector<Vector6> inverse_pivots_;  // by body
};

}  // namespace fulcrum
