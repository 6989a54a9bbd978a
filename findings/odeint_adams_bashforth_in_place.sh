#!/usr/bin/env bash
# odeint_adams_bashforth_in_place.sh: Boost.odeint of Boost 1.81.0 (Debian's libboost1.81-dev 1.81.0-5+deb12u1), g++.
#
# Guessed: adams_bashforth<N> is of order N, as its order() says, whichever overload of do_step is called.
# Seen: only where the result goes to another variable than the state. do_step(system, x, t, dt), which integrate_n_steps and
# integrate_const use too, is of order 1 for every N, and from N = 3 on worse than Euler. The method itself is right; its first N - 1
# steps are not: they come from extrapolation_stepper, which writes a first estimate into the result and then starts its second one
# from there, so it reads a state that it has overwritten. One such step of x' = -x by 0.1 gives 0.789 instead of 0.905.
# The error of the start stays in the solution, nothing warns, and a plot looks plausible. initialize() before the first step, or a
# second variable for the result, cures it. adams_bashforth_moulton starts by Runge-Kutta 4 and is not concerned.
# So an order of accuracy is to be measured through the very call that the program makes.
#
# Fails when that changes. Needs g++, apt and dpkg-deb; leaves nothing behind.
set -euo pipefail
folder=$(mktemp -d)
trap 'rm -rf -- "$folder"' EXIT
cd "$folder"

cat >order.cpp <<'CPP'
#include <boost/numeric/odeint.hpp>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
namespace odeint = boost::numeric::odeint;
using State = std::array<double, 1>;
static void decay(const State& x, State& rate, double) { rate[0] = -x[0]; }

enum class Call { In_place, Integrate, Other_variable, Initialized };
template <int N> static double error_of(Call call, int steps) {
    const double dt = 4.0 / steps;
    odeint::adams_bashforth<N, State> stepper;
    State x = {1.0};
    double t = 0;
    if (call == Call::Integrate) {
        odeint::integrate_n_steps(stepper, decay, x, 0.0, dt, steps);
        return std::fabs(x[0] - std::exp(-4.0));
    }
    int done = 0;
    if (call == Call::Initialized) {
        stepper.initialize(decay, x, t, dt);
        done = N - 1;
    }
    for (; done < steps; ++done) {
        if (call == Call::Other_variable) {
            State next;
            stepper.do_step(decay, x, done * dt, next, dt);
            x = next;
        } else {
            stepper.do_step(decay, x, done * dt, dt);
        }
    }
    return std::fabs(x[0] - std::exp(-4.0));
}

static bool good = true;
template <int N> static void orders() {
    const char* names[] = {"in place", "integrate_n_steps", "other variable", "initialized"};
    for (int k = 0; k < 4; ++k) {
        const double coarse = error_of<N>(Call(k), 320), fine = error_of<N>(Call(k), 640), order = std::log2(coarse / fine);
        std::printf("adams_bashforth<%d> %-18s error of 640 steps %.1e, order %.2f\n", N, names[k], fine, order);
        good = good && std::fabs(order - (k < 2 ? 1 : N)) < 0.2;
    }
}
int main() {
    State by_euler = {1.0};
    odeint::integrate_n_steps(odeint::euler<State>(), decay, by_euler, 0.0, 4.0 / 640, 640);
    const double error = std::fabs(by_euler[0] - std::exp(-4.0));
    std::printf("euler              %-18s error of 640 steps %.1e\n", "integrate_n_steps", error);
    good = error_of<3>(Call::Integrate, 640) > error && error_of<4>(Call::Integrate, 640) > error;
    orders<2>();
    orders<3>();
    orders<4>();
    odeint::extrapolation_stepper<4, State> stepper;
    State x = {1.0}, from = {1.0}, to;
    stepper.do_step(decay, x, 0.0, 0.1);
    stepper.do_step(decay, from, 0.0, to, 0.1);
    std::printf("one step of extrapolation_stepper<4>: in place %.6f, other variable %.6f, exact %.6f\n", x[0], to[0], std::exp(-0.1));
    good = good && std::fabs(x[0] - std::exp(-0.1)) > 0.1 && std::fabs(to[0] - std::exp(-0.1)) < 1e-6;
    return good ? 0 : 1;
}
CPP
apt-get download -qq libboost1.81-dev=1.81.0-5+deb12u1 2>/dev/null || { echo "apt could not download libboost1.81-dev" >&2 && exit 1; }
basename libboost1.81-dev_*.deb
dpkg-deb -x libboost1.81-dev_*.deb .
g++ -O1 -w -isystem usr/include order.cpp -o order
./order || { echo "this is another behaviour than the one described" >&2 && exit 1; }
