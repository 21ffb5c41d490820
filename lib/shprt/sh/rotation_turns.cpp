#include "shprt/sh/rotation_turns.h"

#include <algorithm>
#include <cmath>

namespace shprt {
namespace {

// 1 - c^2 - s^2 to about 1e-17: squares of halves that float holds are exact in double.
double lackOfSquares(CosineSine turn) {
  double large = std::abs(turn.c), small = std::abs(turn.s);
  if (large < small) std::swap(large, small);
  const double largeHigh = static_cast<float>(large), largeLow = large - largeHigh;
  const double smallHigh = static_cast<float>(small), smallLow = small - smallHigh;
  return ((1 - largeHigh * largeHigh) - smallHigh * smallHigh) - (largeHigh + large) * largeLow -
         (smallHigh + small) * smallLow;
}

}  // namespace

TurnStepper::TurnStepper(CosineSine turn) : turn_(turn), lack_(lackOfSquares(turn) / 2) {}

TurnPowers::TurnPowers(int degree, CosineSine turn) {
  TurnStepper stepper(turn);
  powers_.push_back({});
  for (int m = 1; m <= degree; ++m) {
    stepper.step();
    powers_.push_back(stepper.current());
  }
}

TurnWorkspace::TurnWorkspace(int degree, const CosineSine turns[3]) {
  const int stride = (degree / 2 + kSwapPadding) / kSwapPadding * kSwapPadding;
  double* next = near_;
  if (stride > kNearStride) {
    far_.resize((12 * static_cast<std::size_t>(stride) + bandScratch(stride)) / kSwapPadding);
    next = far_.front().entries;
  }
  std::fill_n(next, 12 * stride, 0.0);
  TurnStepper steppers[3] = {TurnStepper(turns[0]), TurnStepper(turns[1]), TurnStepper(turns[2])};
  double* const begin = next;
  for (int turn = 0; turn < 3; ++turn)
    for (int parity = 0; parity < 2; ++parity) {
      tables_.turns[turn].cosine[parity] = next;
      tables_.turns[turn].sine[parity] = next + stride;
      next += 2 * stride;
    }
  scratch_ = next;
  for (int m = 0; m <= degree; ++m)
    for (int turn = 0; turn < 3; ++turn) {
      double* const entry = begin + (2 * turn + m % 2) * 2 * stride + m / 2;
      entry[0] = steppers[turn].current().c;
      entry[stride] = steppers[turn].current().s;
      steppers[turn].step();
    }
}

}  // namespace shprt
