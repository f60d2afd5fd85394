// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include "quadrilateral_vtu.h"

#include <deal.II/base/utilities.h>

#include <zlib.h>

#include <new>
#include <stdexcept>

namespace orthocone
{
namespace
{
using Bytes = std::vector<unsigned char>;

constexpr unsigned char vtk_triangle = 5;
constexpr unsigned char vtk_quad = 9;

/// Base64 text of zlib's compression in one block, after the sizes that VTK requires. It is compressed fast,
/// as the volume files are.
std::string encoded(const void *const data, const std::size_t n_bytes)
{
  uLongf n_compressed = compressBound(n_bytes);
  Bytes compressed(n_compressed);
  const int outcome =
      compress2(compressed.data(), &n_compressed, static_cast<const Bytef *>(data), n_bytes, Z_BEST_SPEED);
  if (outcome == Z_MEM_ERROR)
    throw std::bad_alloc();
  if (outcome != Z_OK)
    throw std::runtime_error("zlib cannot compress a field of " + std::to_string(n_bytes) + " bytes");
  compressed.resize(n_compressed);
  const auto size = static_cast<std::uint32_t>(n_bytes);
  const std::array<std::uint32_t, 4> header{{1, size, size, static_cast<std::uint32_t>(n_compressed)}};
  const auto *const first = reinterpret_cast<const unsigned char *>(header.data());
  return dealii::Utilities::encode_base64(Bytes(first, first + sizeof(header))) +
         dealii::Utilities::encode_base64(compressed);
}

std::string data_array(const std::string &attributes, const void *const data, const std::size_t n_bytes)
{
  return "<DataArray " + attributes + " format=\"binary\">\n" + encoded(data, n_bytes) + "\n</DataArray>\n";
}

std::string data_array(const std::string &name, const Eigen::MatrixXf &values)
{
  std::string attributes = "type=\"Float32\" Name=\"" + name + "\"";
  if (values.rows() > 1)
    attributes += " NumberOfComponents=\"" + std::to_string(values.rows()) + "\"";
  return data_array(attributes, values.data(), values.size() * sizeof(float));
}

template<typename Number>
std::string data_array(const std::string &attributes, const std::vector<Number> &values)
{
  return data_array(attributes, values.data(), values.size() * sizeof(Number));
}

/// The cells as VTK's. It finds no place in a quadrilateral with two coinciding points, but it does in a
/// triangle.
std::string cells(const std::vector<std::array<std::int32_t, 4>> &quadrilaterals)
{
  std::vector<std::int32_t> connectivity;
  std::vector<std::int32_t> ends;
  Bytes types;
  for (const auto &points : quadrilaterals)
  {
    const bool is_triangle = points.back() == points.front();
    connectivity.insert(connectivity.end(), points.begin(), points.end() - (is_triangle ? 1 : 0));
    ends.push_back(static_cast<std::int32_t>(connectivity.size()));
    types.push_back(is_triangle ? vtk_triangle : vtk_quad);
  }
  return "<Cells>\n" + data_array("type=\"Int32\" Name=\"connectivity\"", connectivity) +
         data_array("type=\"Int32\" Name=\"offsets\"", ends) +
         data_array("type=\"UInt8\" Name=\"types\"", types) + "</Cells>\n";
}

std::string byte_order()
{
  const std::uint16_t one = 1;
  return *reinterpret_cast<const unsigned char *>(&one) == 1 ? "LittleEndian" : "BigEndian";
}
} // namespace

std::string quadrilateral_vtu(const QuadrilateralSurface &surface)
{
  std::string text = "<?xml version=\"1.0\"?>\n<VTKFile type=\"UnstructuredGrid\" version=\"0.1\" "
                     "compressor=\"vtkZLibDataCompressor\" byte_order=\"" +
                     byte_order() + "\">\n<UnstructuredGrid>\n";
  text += "<FieldData>\n<DataArray type=\"Int32\" Name=\"degree\" NumberOfTuples=\"1\" format=\"ascii\">" +
          std::to_string(surface.degree) + "</DataArray>\n</FieldData>\n";
  text += "<Piece NumberOfPoints=\"" + std::to_string(surface.points.cols()) + "\" NumberOfCells=\"" +
          std::to_string(surface.quadrilaterals.size()) + "\">\n";
  text += "<Points>\n" + data_array("points", surface.points) + "</Points>\n" +
          cells(surface.quadrilaterals) + "<PointData>\n";
  for (const auto &field : surface.fields)
    text += data_array(field.name, field.values);
  return text + "</PointData>\n</Piece>\n</UnstructuredGrid>\n</VTKFile>\n";
}
} // namespace orthocone
