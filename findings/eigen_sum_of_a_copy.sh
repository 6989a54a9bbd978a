#!/usr/bin/env bash
# eigen_sum_of_a_copy.sh: Eigen 3.4.0 (Debian's libeigen3-dev 3.4.0-4), g++, x86-64 without options for the processor.
#
# Guessed: x.segment(1, n).sum() and the sum of a copy of that segment are the same bits, for the numbers and their order are.
# Seen: they are not. sum() adds one by one up to the first number on an aligned address and in packets from there, so the order of
# its additions depends on where in memory the numbers begin, and a copy begins elsewhere. dot() and squaredNorm() of the same
# vectors do not look at addresses and give the same bits. With EIGEN_DONT_VECTORIZE sum() does too.
# So a program that must repeat itself to the bit may not sum blocks of a vector by Eigen, nor trust that a refactoring which copies
# one changes nothing.
#
# Fails when that changes. Needs g++, apt and dpkg-deb; leaves nothing behind.
set -euo pipefail
folder=$(mktemp -d)
trap 'rm -rf -- "$folder"' EXIT
cd "$folder"
apt-get download -qq libeigen3-dev=3.4.0-4 2>/dev/null
dpkg-deb -x libeigen3-dev_3.4.0-4_all.deb .

cat >sums.cpp <<'CPP'
#include <Eigen/Core>
#include <cstdio>
int main() {
    int sums = 0, dots = 0, norms = 0;
    for (int n = 3; n <= 200; ++n) {
        Eigen::VectorXd x(n + 1);
        for (int i = 0; i <= n; ++i) {
            x[i] = 1.0 / (3 + 7 * i);
        }
        const Eigen::VectorXd copy = x.segment(1, n);
        sums += x.segment(1, n).sum() != copy.sum() ? 1 : 0;
        dots += x.segment(1, n).dot(copy) != copy.dot(copy) ? 1 : 0;
        norms += x.segment(1, n).squaredNorm() != copy.squaredNorm() ? 1 : 0;
    }
    std::printf("of 198 lengths differ: %d sums, %d dots, %d norms\n", sums, dots, norms);
}
CPP
expect() {
    g++ -O2 "${@:2}" -I usr/include/eigen3 sums.cpp -o sums
    said=$(./sums)
    printf '%-22s %s\n' "${2:-plain}" "$said"
    grep -qE "$1" <<<"$said" || { echo "this is another behaviour than the one described" >&2 && exit 1; }
}
expect 'differ: [1-9][0-9]* sums, 0 dots, 0 norms'
expect 'differ: 0 sums, 0 dots, 0 norms' -DEIGEN_DONT_VECTORIZE
