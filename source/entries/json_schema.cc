// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include <orthocone/entries/json_schema.h>

#include <nlohmann/json.hpp>

namespace orthocone
{
namespace
{
using Json = nlohmann::ordered_json;

Json object_of(Json properties)
{
  return {{"type", "object"}, {"additionalProperties", false}, {"properties", std::move(properties)}};
}

/// A number where JSON writes it as the program does, or else its text.
Json default_of(const std::string &text)
{
  if (const auto count = parse_count(text))
    return *count;
  const auto number = parse_number(text);
  const Json json = number ? Json(*number) : Json();
  return json.dump() == text ? json : Json(text);
}

Json entry_schema(const Entry &entry)
{
  const std::string unit = entry.unit().empty() ? "" : " Unit: " + entry.unit() + ".";
  Json schema{{"description", entry.help() + unit}, {"default", default_of(entry.text())}};
  if (const std::vector<std::string> words = split(entry.allowed(), '|'); words.size() > 1)
    schema["enum"] = words;
  else
    schema["type"] = {"number", "string"};
  if (entry.is_path())
    schema["format"] = "path";
  return schema;
}
} // namespace

std::string json_schema(const EntryList &list, const std::string &title)
{
  Json sections{{"$schema", {{"type", "string"}}}};
  for (const std::string &section : list.sections())
  {
    Json entries = Json::object();
    for (const Entry &entry : list.entries())
      if (entry.section() == section)
        entries[entry.own_name()] = entry_schema(entry);
    sections[section] = object_of(std::move(entries));
  }
  Json schema{{"$schema", "http://json-schema.org/draft-07/schema#"}, {"title", title}};
  schema.update(object_of(std::move(sections)));
  return schema.dump(2) + "\n";
}
} // namespace orthocone
