// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include "hdf5_file.h"

#include <orthocone/base/errors.h>
#include <orthocone/base/input_file.h>
#include <orthocone/base/text.h>

#include <hdf5.h>

#include <algorithm>
#include <utility>

namespace orthocone
{
namespace
{
/// An identifier of HDF5, and the function that closes it.
class Handle
{
public:
  Handle(const hid_t id, herr_t (*const close)(hid_t))
      : id_(id),
        close_(close)
  {
  }
  ~Handle()
  {
    if (id_ >= 0)
      close_(id_);
  }
  Handle(const Handle &) = delete;
  Handle &operator=(const Handle &) = delete;

  bool is_open() const { return id_ >= 0; }
  hid_t id() const { return id_; }

private:
  hid_t id_;
  herr_t (*close_)(hid_t);
};

/// Whether a damaged file demands more memory than it has numbers. `n` is the size that it states.
bool claims_too_much(const hid_t array, const hid_t type, const hsize_t n, const hsize_t file_size)
{
  constexpr hsize_t most_compressed = 1100; // times: zlib's bound, of which zeros come near
  const Handle plan(H5Dget_create_plist(array), H5Pclose);
  const hsize_t stored = H5Dget_storage_size(array);
  const hsize_t of_a_byte = H5Pget_nfilters(plan.id()) > 0 ? most_compressed : 1;
  return stored > file_size || n > of_a_byte * stored / std::max<hsize_t>(H5Tget_size(type), 1);
}

/// Reads all numbers of an array into the memory that `make_room` returns for their number.
template<typename MakeRoom>
void read_array(const Hdf5File &file, const hid_t id, const std::string &path, const hid_t type,
                const H5T_class_t wanted, const MakeRoom &make_room)
{
  if (!file.has(path))
    file.fail("there is no array " + path);
  const Handle array(H5Dopen2(id, path.c_str(), H5P_DEFAULT), H5Dclose);
  if (!array.is_open())
    file.fail(path + " is no array");
  const Handle stored(H5Dget_type(array.id()), H5Tclose), space(H5Dget_space(array.id()), H5Sclose);
  const hssize_t n = H5Sget_simple_extent_npoints(space.id());
  if (H5Tget_class(stored.id()) != wanted || n < 0)
    file.fail(path +
              (wanted == H5T_INTEGER ? " does not hold integers" : " does not hold floating-point numbers"));
  if (n > 0 && H5Dget_storage_size(array.id()) == 0)
    file.fail(path + " has no values");
  if (claims_too_much(array.id(), stored.id(), static_cast<hsize_t>(n), file.size()))
    file.fail(path + " states " + std::to_string(n) + " values, which the file does not have");
  if (H5Dread(array.id(), type, H5S_ALL, H5S_ALL, H5P_DEFAULT, make_room(n)) < 0)
    file.fail(path + " cannot be read");
}
} // namespace

Hdf5File::Hdf5File(std::string name, const Access access)
    : name_(std::move(name))
{
  H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr); // the program words its own messages
  const InputFile file(name_, shown_path(name_));
  if (!file.is_ordinary())
    fail("is no ordinary file");
  size_ = file.size();
  if (H5Fis_hdf5(name_.c_str()) <= 0)
    fail("is not an HDF5 file");
  id_ = H5Fopen(name_.c_str(), access == Access::read ? H5F_ACC_RDONLY : H5F_ACC_RDWR, H5P_DEFAULT);
  if (id_ < 0)
    fail("is an HDF5 file, but truncated or damaged");
}

Hdf5File::~Hdf5File()
{
  if (id_ >= 0)
    H5Fclose(id_);
}

void Hdf5File::close()
{
  if (H5Fclose(std::exchange(id_, -1)) < 0)
    fail("cannot be written");
}

bool Hdf5File::has(const std::string &path) const
{
  for (std::size_t end = path.find('/', 1);; end = path.find('/', end + 1))
  {
    if (H5Lexists(id_, path.substr(0, end).c_str(), H5P_DEFAULT) <= 0)
      return false;
    if (end == std::string::npos)
      return true;
  }
}

bool Hdf5File::has_values(const std::string &path) const
{
  if (!has(path))
    return false;
  const Handle array(H5Dopen2(id_, path.c_str(), H5P_DEFAULT), H5Dclose);
  return array.is_open() && H5Dget_storage_size(array.id()) > 0;
}

std::vector<int> Hdf5File::integers(const std::string &path) const
{
  std::vector<int> values;
  read_array(*this, id_, path, H5T_NATIVE_INT, H5T_INTEGER,
             [&](const hssize_t n)
             {
               values.resize(n);
               return values.data();
             });
  return values;
}

Eigen::VectorXd Hdf5File::numbers(const std::string &path) const
{
  Eigen::VectorXd values;
  read_array(*this, id_, path, H5T_NATIVE_DOUBLE, H5T_FLOAT,
             [&](const hssize_t n)
             {
               values.resize(n);
               return values.data();
             });
  if (!values.allFinite())
    fail(path + " has entries that are no numbers");
  return values;
}

int Hdf5File::integer(const std::string &path) const
{
  const std::vector<int> values = integers(path);
  if (values.size() != 1)
    fail(path + " has " + std::to_string(values.size()) + " values instead of one");
  return values.front();
}

void Hdf5File::make_group(const std::string &path)
{
  const Handle group(H5Gcreate2(id_, path.c_str(), H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT), H5Gclose);
  if (!group.is_open())
    fail("cannot be written: " + path);
}

void Hdf5File::write(const std::string &path, const Eigen::VectorXd &values)
{
  const auto n = static_cast<hsize_t>(values.size());
  const Handle space(H5Screate_simple(1, &n, nullptr), H5Sclose);
  const Handle array(
      H5Dcreate2(id_, path.c_str(), H5T_NATIVE_DOUBLE, space.id(), H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT),
      H5Dclose);
  if (!array.is_open() ||
      H5Dwrite(array.id(), H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data()) < 0)
    fail("cannot be written: " + path);
}

void Hdf5File::fail(const std::string &what) const
{
  throw FileError(shown_path(name_) +
                  (what.rfind("is ", 0) == 0 || what.rfind("cannot", 0) == 0 ? " " : ": ") + what);
}
} // namespace orthocone
