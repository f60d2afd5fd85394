// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include "wave_symbols.h"

#include <orthocone/base/numbers.h>

#include <algorithm>
#include <cmath>

namespace orthocone
{
using Eigen::Vector2d;

namespace
{
/// sin(t) / t
double sinc(const double t)
{
  return t == 0 ? 1 : std::sin(t) / t;
}

GridSymbol<double> in_axes(const double along, const double across, const Vector2d &k)
{
  const Vector2d n = k.normalized();
  GridSymbol<double> symbol;
  symbol.nn = along;
  symbol.xx = along * n[0] * n[0] + across * n[1] * n[1];
  symbol.yy = along * n[1] * n[1] + across * n[0] * n[0];
  symbol.xy = (along - across) * n[0] * n[1];
  return symbol;
}

void add(const GridSymbol<double> &symbol, const double weight, GridSymbol<double> &sum)
{
  sum.nn += weight * symbol.nn;
  sum.xx += weight * symbol.xx;
  sum.xy += weight * symbol.xy;
  sum.yy += weight * symbol.yy;
  sum.nx += weight * symbol.nx;
  sum.ny += weight * symbol.ny;
}
} // namespace

/// Waves on a half-space (Johnson, Contact Mechanics, 1985, 13.2): pressure, and shear along k, move it along
/// themselves by 2 (1 - nu^2) / (E |k|), shear across k by 2 (1 + nu) / (E |k|), and pressure moves it along
/// k by (1 + nu) (1 - 2 nu) / (E |k|), a quarter of a wave apart: towards its crests above the plane, where a
/// normal force pushes up, and to the other side below.
WaveSymbols::WaveSymbols(const HalfSpace &body, const std::optional<HalfSpace> &counterface)
{
  const auto add_body = [this](const HalfSpace &half_space, const double side)
  {
    const double nu = half_space.poisson_ratio, soft = (1 + nu) / half_space.young_modulus;
    in_plane_ += 2 * soft * (1 - nu);
    out_of_plane_ += 2 * soft;
    coupling_ -= side * soft * (1 - 2 * nu);
    compression_ += soft * (1 - 2 * nu) / (1 - nu);
  };
  add_body(body, 1);
  if (counterface)
    add_body(*counterface, -1);
}

GridSymbol<double> WaveSymbols::compliance(const Vector2d &k) const
{
  const double length = k.norm();
  GridSymbol<double> symbol = in_axes(in_plane_ / length, out_of_plane_ / length, k);
  symbol.nx = coupling_ * k[0] / (length * length);
  symbol.ny = coupling_ * k[1] / (length * length);
  return symbol;
}

GridSymbol<double> WaveSymbols::stiffness(const Vector2d &k) const
{
  const double length = k.norm();
  return in_axes(length / in_plane_, length / out_of_plane_, k);
}

GridSymbol<double> WaveSymbols::compliance_of_layer(const double thickness) const
{
  GridSymbol<double> symbol;
  symbol.nn = thickness * compression_;
  symbol.xx = symbol.yy = thickness * out_of_plane_;
  return symbol;
}

GridSymbol<double> WaveSymbols::stiffness_of_layer(const double thickness) const
{
  GridSymbol<double> symbol;
  symbol.nn = 1 / (thickness * compression_);
  symbol.xx = symbol.yy = 1 / (thickness * out_of_plane_);
  return symbol;
}

/// The tractions of a patch are even, so that they contain all waves k + 2 pi (i / width, j / height), each
/// by its mean over the patch, and so does the mean displacement of another patch. The terms fall with the
/// fifth power of the wave number, or the third along the axes: what is left out is less than a
/// thousandth of a patch's own compliance. Entries that are odd vanish where a wave is its own mirror image.
GridSymbol<double> WaveSymbols::compliance_of_patches(const SurfaceGrid &grid, const Vector2d &k) const
{
  constexpr int most = 8;
  GridSymbol<double> sum;
  for (int i = -most; i <= most; ++i)
    for (int j = -most; j <= most; ++j)
    {
      const Vector2d wave(k[0] + 2 * pi * i / grid.width, k[1] + 2 * pi * j / grid.height);
      const double mean = sinc(wave[0] * grid.width / 2) * sinc(wave[1] * grid.height / 2);
      if (wave.isZero(0))
        add(compliance_of_layer(layer_below(grid)), 1, sum);
      else if (mean != 0)
        add(compliance(wave), mean * mean, sum);
    }
  constexpr double rounding = 1e-9;
  const bool is_own_image_x = std::abs(std::sin(k[0] * grid.width)) < rounding,
             is_own_image_y = std::abs(std::sin(k[1] * grid.height)) < rounding;
  if (is_own_image_x)
    sum.nx = sum.xy = 0;
  if (is_own_image_y)
    sum.ny = sum.xy = 0;
  const double area = grid.width * grid.height;
  GridSymbol<double> symbol;
  add(sum, 1 / area, symbol);
  return symbol;
}

double layer_below(const SurfaceGrid &grid)
{
  return std::max(static_cast<double>(grid.n_x) * grid.width, static_cast<double>(grid.n_y) * grid.height);
}
} // namespace orthocone
