/// The little of HDF5 that results need: files, groups, arrays with a unit, attributes; closed by their owners.
#pragma once

#include <hdf5.h>

#include <string>
#include <utility>
#include <vector>

namespace wale::hdf5 {

/// Owns one HDF5 identifier.
class Handle {
 public:
  using Close = herr_t (*)(hid_t);
  Handle() = default;
  /// Throws std::runtime_error saying `what` failed if `id` is not one.
  Handle(hid_t id, Close close, const std::string& what);
  Handle(Handle&& other) noexcept : id_(std::exchange(other.id_, -1)), close_(other.close_) {}
  Handle& operator=(Handle&& other) noexcept {
    std::swap(id_, other.id_);
    std::swap(close_, other.close_);
    return *this;
  }
  ~Handle() {
    if (id_ >= 0) close_(id_);
  }
  hid_t id() const { return id_; }

 private:
  hid_t id_ = -1;
  Close close_ = nullptr;
};

/// Keeps HDF5 from printing its error stack while it lives: errors are exceptions here.
class Quiet {
 public:
  Quiet();
  Quiet(const Quiet&) = delete;
  Quiet& operator=(const Quiet&) = delete;
  ~Quiet();

 private:
  H5E_auto2_t print_ = nullptr;
  void* data_ = nullptr;
};

/// A group (or a file's root). Every failure is a std::runtime_error that names the dataset or attribute.
class Group {
 public:
  /// A file that is in memory until flush(), which writes it as one piece; else there would be a call to the system for
  /// every dataset and attribute.
  static Group create_file(const std::string& path);
  static Group open_file(const std::string& path);
  /// Writes all that is still in memory.
  void flush() const;

  /// The same group again; the file stays open while any of its groups is.
  Group view() const { return open("."); }
  Group create(const std::string& name) const;
  Group open(const std::string& name) const;
  /// Whether there is a group, an array or an attribute of that name.
  bool has(const std::string& name) const;

  /// An array of any rank, row-major, with the attribute `unit` ("" for a plain number). `packed` compresses it.
  void write(const std::string& name, const std::vector<double>& values, const std::string& unit) const;
  void write(const std::string& name, const std::vector<int>& values, const std::string& unit) const;
  void write(const std::string& name, const std::vector<std::string>& values, const std::string& unit) const;
  void write_block(const std::string& name, const double* values, const std::vector<hsize_t>& shape,
                   const std::string& unit, bool packed) const;

  void read(const std::string& name, std::vector<double>& values) const;
  void read(const std::string& name, std::vector<int>& values) const;
  void read(const std::string& name, std::vector<std::string>& values) const;
  std::vector<hsize_t> shape(const std::string& name) const;
  /// `values` must have room for the whole array.
  void read_block(const std::string& name, double* values) const;

  void set(const std::string& name, double value) const;
  void set(const std::string& name, long value) const;
  void set(const std::string& name, const std::string& value) const;
  void get(const std::string& name, double& value) const;
  void get(const std::string& name, long& value) const;
  void get(const std::string& name, std::string& value) const;
  /// The unit of a dataset of this group.
  std::string unit(const std::string& dataset) const;

 private:
  Group(Handle file, Handle group) : file_(std::move(file)), group_(std::move(group)) {}
  Handle file_;  // empty unless this is the root
  Handle group_;
};

}  // namespace wale::hdf5
