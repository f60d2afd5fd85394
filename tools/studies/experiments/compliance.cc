// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include "scene.h"

#include <fstream>
#include <iostream>

namespace orthocone::studies
{
namespace
{
/// The whole matrix as doubles, column by column.
void write_matrix(const Scene &model, const std::string &path)
{
  std::ofstream file(path, std::ios::binary);
  const DenseView &w = *model.system().compliance().dense();
  file.write(reinterpret_cast<const char *>(w.data()),
             static_cast<std::streamsize>(w.size() * sizeof(double)));
  if (!file.flush())
    throw std::runtime_error(path + ": cannot be written");
}
} // namespace

void compliance(const Words &words)
{
  const SceneWords scene(words);
  const Scene model(scene.parameters, choose_model(scene.parameters));
  const Compliance &w = model.system().compliance();
  if (const auto path = scene.options.find("matrix"); path != scene.options.end())
    write_matrix(model, path->second);
  std::cout << "x,y,w_nn,w_nx,w_ny,w_xx,w_xy,w_yy\n";
  for (Eigen::Index node = 0; node < w.n_nodes(); ++node)
  {
    const auto &position = model.surface().nodes[node].position;
    const Eigen::Matrix3d block = w.diagonal_block(node);
    std::cout << position[0] << "," << position[1] << "," << block(0, 0) << "," << block(0, 1) << ","
              << block(0, 2) << "," << block(1, 1) << "," << block(1, 2) << "," << block(2, 2) << "\n";
  }
}
} // namespace orthocone::studies
