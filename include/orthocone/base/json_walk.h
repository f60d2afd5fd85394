// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#pragma once

#include <nlohmann/json.hpp>

#include <string>

namespace orthocone
{
/// Goes through JSON before it is read, and stops where values are nested deeper than allowed: the library's
/// reader calls itself, and would overflow the stack.
template<typename Json>
class JsonWalk : public nlohmann::json_sax<Json>
{
public:
  using Base = nlohmann::json_sax<Json>;

  explicit JsonWalk(const unsigned int deepest)
      : deepest_(deepest)
  {
  }

  bool null() override { return true; }
  bool boolean(bool) override { return true; }
  bool number_integer(typename Base::number_integer_t) override { return true; }
  bool number_unsigned(typename Base::number_unsigned_t) override { return true; }
  bool number_float(typename Base::number_float_t, const typename Base::string_t &) override { return true; }
  bool string(typename Base::string_t &) override { return true; }
  bool binary(typename Base::binary_t &) override { return true; }
  bool key(typename Base::string_t &) override { return true; }
  bool start_object(std::size_t) override { return open(); }
  bool end_object() override { return close(); }
  bool start_array(std::size_t) override { return open(); }
  bool end_array() override { return close(); }
  bool parse_error(std::size_t, const std::string &, const nlohmann::detail::exception &) override
  {
    return false;
  }

protected:
  /// An object or array begins or ends; false stops.
  virtual bool open() { return ++depth_ <= deepest_; }
  virtual bool close() { return depth_-- > 0; }

private:
  const unsigned int deepest_;
  unsigned int depth_ = 0;
};
} // namespace orthocone
