// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include "checkpoint_json.h"

#include <orthocone/base/json_walk.h>

#include <cmath>
#include <cstring>
#include <limits>
#include <utility>

namespace orthocone::checkpoint_json
{
using Eigen::Index;

unsigned int count_from(const Json &json)
{
  if (!json.is_number_unsigned() || json.get<std::uint64_t>() > std::numeric_limits<unsigned int>::max())
    throw CheckpointError("is damaged (a number is out of range)");
  return json.get<unsigned int>();
}

double number_from(const Json &json)
{
  if (!json.is_number() || !std::isfinite(json.get<double>()))
    throw CheckpointError("is damaged (a number is not finite)");
  return json.get<double>();
}

Json array_json(const Eigen::VectorXd &values)
{
  std::vector<std::uint8_t> bytes(static_cast<std::size_t>(values.size()) * sizeof(double));
  if (!bytes.empty()) // an empty array may have no address
    std::memcpy(bytes.data(), values.data(), bytes.size());
  return Json::binary(std::move(bytes));
}

Eigen::VectorXd array_from(const Json &json, const Index size)
{
  const auto &bytes = json.get_binary();
  if (bytes.size() % sizeof(double) != 0 || static_cast<Index>(bytes.size() / sizeof(double)) != size)
    throw CheckpointError("is damaged (an array has the wrong size)");
  Eigen::VectorXd values(size);
  if (size > 0)
    std::memcpy(values.data(), bytes.data(), bytes.size());
  if (!values.allFinite())
    throw CheckpointError("is damaged (a number is not finite)");
  return values;
}

Json tables_json(const TableMarks &tables)
{
  Json json = Json::object();
  for (const auto &[name, mark] : tables)
    json[name] = {mark.size, mark.checksum};
  return json;
}

TableMarks tables_from(const Json &json)
{
  TableMarks tables;
  for (const auto &[name, mark] : json.items())
    tables[name] = {mark.at(0).get<std::uintmax_t>(), mark.at(1).get<std::uint32_t>()};
  return tables;
}

Json steps_json(const std::vector<unsigned int> &steps)
{
  Json json = Json::array();
  for (std::size_t i = 0; i < steps.size();)
  {
    const unsigned int distance = i + 1 < steps.size() ? steps[i + 1] - steps[i] : 1;
    std::size_t n = 1;
    while (i + n < steps.size() && steps[i + n] - steps[i + n - 1] == distance)
      ++n;
    json.push_back({steps[i], distance, n});
    i += n;
  }
  return json;
}

std::vector<unsigned int> steps_from(const Json &json)
{
  constexpr std::size_t most = 1000000; // steps of a load program
  std::vector<unsigned int> steps;
  for (const Json &part : json)
  {
    const unsigned int n = count_from(part.at(2));
    if (steps.size() + n > most)
      throw CheckpointError("is damaged (a number is out of range)");
    for (unsigned int i = 0; i < n; ++i)
      steps.push_back(count_from(part.at(0)) + i * count_from(part.at(1)));
  }
  return steps;
}

Json line_steps_json(const std::map<std::string, std::vector<unsigned int>> &lines)
{
  Json json = Json::object();
  for (const auto &[name, steps] : lines)
    json[name] = steps_json(steps);
  return json;
}

std::map<std::string, std::vector<unsigned int>> line_steps_from(const Json &json)
{
  constexpr std::size_t most = 10000000; // files of a folder
  std::map<std::string, std::vector<unsigned int>> lines;
  std::size_t n = 0;
  for (const auto &[name, steps] : json.items())
  {
    lines[name] = steps_from(steps);
    n += lines[name].size();
    if (n > most)
      throw CheckpointError("is damaged (a number is out of range)");
  }
  return lines;
}

Json json_from_cbor(const std::string &bytes)
{
  constexpr unsigned int deepest = 19;
  JsonWalk<Json> check(deepest);
  if (!Json::sax_parse(bytes, &check, Json::input_format_t::cbor))
    throw CheckpointError("is damaged (its content is not understood)");
  return Json::from_cbor(bytes);
}
} // namespace orthocone::checkpoint_json
