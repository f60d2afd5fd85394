// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include <orthocone/app/program.h>

int main(const int argc, const char *const *const argv)
{
  orthocone::run_program(argc, argv);
}
