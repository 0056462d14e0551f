#include "sim/results/hdf5_handle.hpp"

#include <algorithm>
#include <stdexcept>

namespace wale::hdf5 {
namespace {

constexpr std::size_t growth = 1 << 20;  // bytes by which a file in memory grows

void check(herr_t status, const std::string& what) {
  if (status < 0) throw std::runtime_error("HDF5 cannot " + what);
}

Handle text_type() {
  Handle type(H5Tcopy(H5T_C_S1), H5Tclose, "make a text type");
  check(H5Tset_size(type.id(), H5T_VARIABLE), "make a text type");
  check(H5Tset_cset(type.id(), H5T_CSET_UTF8), "make a text type");
  return type;
}

Handle array_space(const std::vector<hsize_t>& shape) {
  return {H5Screate_simple(static_cast<int>(shape.size()), shape.data(), nullptr), H5Sclose, "make a data space"};
}

/// HDF5 ends a text at its first NUL, so one with a NUL inside would be cut without a word.
const char* text(const std::string& value, const std::string& name) {
  if (value.find('\0') != std::string::npos)
    throw std::runtime_error("HDF5 cannot write " + name + ": a NUL in a text");
  return value.c_str();
}

void set_attribute(hid_t object, const std::string& name, hid_t type, const void* value) {
  const Handle space(H5Screate(H5S_SCALAR), H5Sclose, "make a data space");
  const Handle attribute(H5Acreate2(object, name.c_str(), type, space.id(), H5P_DEFAULT, H5P_DEFAULT), H5Aclose,
                         "write " + name);
  check(H5Awrite(attribute.id(), type, value), "write " + name);
}

void set_text(hid_t object, const std::string& name, const std::string& value) {
  const Handle type = text_type();
  const char* characters = text(value, name);
  set_attribute(object, name, type.id(), &characters);
}

/// For numbers, which HDF5 converts, but not from text.
void get_attribute(hid_t object, const std::string& name, hid_t type, void* value) {
  const Handle attribute(H5Aopen(object, name.c_str(), H5P_DEFAULT), H5Aclose, "read " + name);
  check(H5Aread(attribute.id(), type, value), "read " + name);
}

std::string get_text(hid_t object, const std::string& name) {
  const Handle attribute(H5Aopen(object, name.c_str(), H5P_DEFAULT), H5Aclose, "read " + name);
  const Handle type = text_type(), space(H5Aget_space(attribute.id()), H5Sclose, "read " + name);
  if (H5Sget_simple_extent_npoints(space.id()) != 1) throw std::runtime_error("HDF5 cannot read " + name);
  char* characters = nullptr;
  check(H5Aread(attribute.id(), type.id(), &characters), "read " + name);
  std::string value = characters ? characters : "";
  H5Dvlen_reclaim(type.id(), space.id(), H5P_DEFAULT, &characters);
  return value;
}

/// Chunks of one entry of the first axis, byte-shuffled and deflated lightly.
Handle packing(const std::vector<hsize_t>& shape) {
  Handle list(H5Pcreate(H5P_DATASET_CREATE), H5Pclose, "set up compression");
  std::vector<hsize_t> chunk = shape;
  chunk.front() = 1;
  check(H5Pset_chunk(list.id(), static_cast<int>(chunk.size()), chunk.data()), "set up compression");
  check(H5Pset_shuffle(list.id()), "set up compression");
  check(H5Pset_deflate(list.id(), 1), "set up compression");
  return list;
}

void write_array(hid_t group, const std::string& name, hid_t type, const void* values,
                 const std::vector<hsize_t>& shape, const std::string& unit, bool packed) {
  const Handle space = array_space(shape);
  const bool empty = std::find(shape.begin(), shape.end(), 0) != shape.end();
  const Handle list = packed && !empty ? packing(shape) : Handle();
  const Handle set(H5Dcreate2(group, name.c_str(), type, space.id(), H5P_DEFAULT,
                              list.id() < 0 ? H5P_DEFAULT : list.id(), H5P_DEFAULT),
                   H5Dclose, "write " + name);
  if (!empty) check(H5Dwrite(set.id(), type, H5S_ALL, H5S_ALL, H5P_DEFAULT, values), "write " + name);
  if (!unit.empty()) set_text(set.id(), "unit", unit);
}

Handle open_array(hid_t group, const std::string& name) {
  return {H5Dopen2(group, name.c_str(), H5P_DEFAULT), H5Dclose, "read " + name};
}

std::vector<hsize_t> shape_of(hid_t set, const std::string& name) {
  const Handle space(H5Dget_space(set), H5Sclose, "read " + name);
  const int rank = H5Sget_simple_extent_ndims(space.id());
  check(rank, "read " + name);
  std::vector<hsize_t> shape(static_cast<std::size_t>(rank));
  check(H5Sget_simple_extent_dims(space.id(), shape.data(), nullptr), "read " + name);
  return shape;
}

std::size_t length_of(hid_t set, const std::string& name) {
  const std::vector<hsize_t> shape = shape_of(set, name);
  if (shape.size() != 1) throw std::runtime_error("HDF5 cannot read " + name + ": not a list");
  return static_cast<std::size_t>(shape[0]);
}

void read_array(hid_t set, const std::string& name, hid_t type, void* values) {
  check(H5Dread(set, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, values), "read " + name);
}

}  // namespace

Handle::Handle(hid_t id, Close close, const std::string& what) : id_(id), close_(close) {
  if (id < 0) throw std::runtime_error("HDF5 cannot " + what);
}

Quiet::Quiet() {
  H5Eget_auto2(H5E_DEFAULT, &print_, &data_);
  H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);
}

Quiet::~Quiet() { H5Eset_auto2(H5E_DEFAULT, print_, data_); }

Group Group::create_file(const std::string& path) {
  const Handle access(H5Pcreate(H5P_FILE_ACCESS), H5Pclose, "create the file");
  check(H5Pset_fapl_core(access.id(), growth, true), "create the file");
  Handle file(H5Fcreate(path.c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, access.id()), H5Fclose, "create the file");
  Handle root(H5Gopen2(file.id(), "/", H5P_DEFAULT), H5Gclose, "open the file");
  return {std::move(file), std::move(root)};
}

Group Group::open_file(const std::string& path) {
  Handle file(H5Fopen(path.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT), H5Fclose,
              "read this file: it is damaged or not HDF5");
  Handle root(H5Gopen2(file.id(), "/", H5P_DEFAULT), H5Gclose, "open the file");
  return {std::move(file), std::move(root)};
}

void Group::flush() const { check(H5Fflush(group_.id(), H5F_SCOPE_LOCAL), "write the file"); }

Group Group::create(const std::string& name) const {
  return {{},
          {H5Gcreate2(group_.id(), name.c_str(), H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT), H5Gclose, "write " + name}};
}

Group Group::open(const std::string& name) const {
  return {{}, {H5Gopen2(group_.id(), name.c_str(), H5P_DEFAULT), H5Gclose, "find " + name}};
}

bool Group::has(const std::string& name) const {
  const htri_t linked = H5Lexists(group_.id(), name.c_str(), H5P_DEFAULT);
  const htri_t attribute = H5Aexists(group_.id(), name.c_str());
  check(linked, "read " + name);
  check(attribute, "read " + name);
  return linked > 0 || attribute > 0;
}

void Group::write(const std::string& name, const std::vector<double>& values, const std::string& unit) const {
  write_array(group_.id(), name, H5T_NATIVE_DOUBLE, values.data(), {values.size()}, unit, false);
}

void Group::write(const std::string& name, const std::vector<int>& values, const std::string& unit) const {
  write_array(group_.id(), name, H5T_NATIVE_INT, values.data(), {values.size()}, unit, false);
}

void Group::write(const std::string& name, const std::vector<std::string>& values, const std::string& unit) const {
  std::vector<const char*> characters;
  for (const std::string& value : values) characters.push_back(text(value, name));
  write_array(group_.id(), name, text_type().id(), characters.data(), {values.size()}, unit, false);
}

void Group::write_block(const std::string& name, const double* values, const std::vector<hsize_t>& shape,
                        const std::string& unit, bool packed) const {
  write_array(group_.id(), name, H5T_NATIVE_DOUBLE, values, shape, unit, packed);
}

void Group::read(const std::string& name, std::vector<double>& values) const {
  const Handle set = open_array(group_.id(), name);
  values.resize(length_of(set.id(), name));
  if (!values.empty()) read_array(set.id(), name, H5T_NATIVE_DOUBLE, values.data());
}

void Group::read(const std::string& name, std::vector<int>& values) const {
  const Handle set = open_array(group_.id(), name);
  values.resize(length_of(set.id(), name));
  if (!values.empty()) read_array(set.id(), name, H5T_NATIVE_INT, values.data());
}

void Group::read(const std::string& name, std::vector<std::string>& values) const {
  const Handle set = open_array(group_.id(), name);
  const Handle type = text_type(), space(H5Dget_space(set.id()), H5Sclose, "read " + name);
  std::vector<char*> characters(length_of(set.id(), name), nullptr);
  if (!characters.empty()) read_array(set.id(), name, type.id(), characters.data());
  values.clear();
  for (const char* value : characters) values.emplace_back(value ? value : "");
  if (!characters.empty()) H5Dvlen_reclaim(type.id(), space.id(), H5P_DEFAULT, characters.data());
}

std::vector<hsize_t> Group::shape(const std::string& name) const {
  const Handle set = open_array(group_.id(), name);
  return shape_of(set.id(), name);
}

void Group::read_block(const std::string& name, double* values) const {
  const Handle set = open_array(group_.id(), name);
  read_array(set.id(), name, H5T_NATIVE_DOUBLE, values);
}

void Group::set(const std::string& name, double value) const {
  set_attribute(group_.id(), name, H5T_NATIVE_DOUBLE, &value);
}

void Group::set(const std::string& name, long value) const {
  set_attribute(group_.id(), name, H5T_NATIVE_LONG, &value);
}

void Group::set(const std::string& name, const std::string& value) const { set_text(group_.id(), name, value); }

void Group::get(const std::string& name, double& value) const {
  get_attribute(group_.id(), name, H5T_NATIVE_DOUBLE, &value);
}

void Group::get(const std::string& name, long& value) const {
  get_attribute(group_.id(), name, H5T_NATIVE_LONG, &value);
}

void Group::get(const std::string& name, std::string& value) const { value = get_text(group_.id(), name); }

std::string Group::unit(const std::string& dataset) const {
  const Handle set = open_array(group_.id(), dataset);
  return H5Aexists(set.id(), "unit") > 0 ? get_text(set.id(), "unit") : std::string();
}

}  // namespace wale::hdf5
