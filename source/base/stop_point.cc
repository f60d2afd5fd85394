// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include <orthocone/base/stop_point.h>

#include <utility>

namespace orthocone
{
namespace
{
thread_local const Stoppable *innermost_stoppable = nullptr;
}

Stoppable::Stoppable(std::function<bool()> is_to_stop)
    : is_to_stop_(std::move(is_to_stop)),
      before_(innermost_stoppable)
{
  innermost_stoppable = this;
}

Stoppable::~Stoppable()
{
  innermost_stoppable = before_;
}

void stop_point()
{
  if (innermost_stoppable != nullptr && innermost_stoppable->is_to_stop_())
    throw Stopped();
}
} // namespace orthocone
