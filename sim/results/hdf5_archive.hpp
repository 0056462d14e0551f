/// Two archives with the same members, so that one description of a schema both writes and reads it.
#pragma once

#include <array>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <vector>

#include "sim/fabric.hpp"
#include "sim/results/hdf5_handle.hpp"

namespace wale::hdf5 {

/// What a member is in the file: a number is itself, a truth is 0 or 1, a contact law its name.
inline double stored(double value) { return value; }
inline int stored(int value) { return value; }
inline int stored(bool value) { return value ? 1 : 0; }
inline std::string stored(const std::string& value) { return value; }
inline std::string stored(ContactLaw law) { return std::string(contact_law_names.at(static_cast<std::size_t>(law))); }

inline void restore(double value, double& member) { member = value; }
inline void restore(int value, int& member) { member = value; }
inline void restore(int value, bool& member) { member = value != 0; }
inline void restore(const std::string& value, std::string& member) { member = value; }
inline void restore(const std::string& name, ContactLaw& law) {
  for (std::size_t i = 0; i < contact_law_names.size(); ++i)
    if (name == contact_law_names[i]) {
      law = static_cast<ContactLaw>(i);
      return;
    }
  throw std::runtime_error("HDF5 file has an unknown contact law: " + name);
}

class Writer {
 public:
  explicit Writer(Group group) : group_(std::move(group)) {}
  const Group& group() const { return group_; }
  Writer group(const std::string& name) const { return Writer(group_.create(name)); }

  /// One member of all items, as one dataset.
  template <class Item, class Member>
  void field(const std::string& name, const std::string& unit, const std::vector<Item>& items,
             Member Item::*member) const {
    std::vector<decltype(stored(items.front().*member))> values;
    for (const Item& item : items) values.push_back(stored(item.*member));
    group_.write(name, values, unit);
  }
  template <class Value>
  void list(const std::string& name, const std::string& unit, const std::vector<Value>& values) const {
    group_.write(name, values, unit);
  }
  /// A matrix of three rows, as n x 3 numbers.
  void points(const std::string& name, const std::string& unit, const Points& values) const {
    group_.write_block(name, values.data(), {static_cast<hsize_t>(values.cols()), 3}, unit, false);
  }
  /// One number with a unit.
  void measure(const std::string& name, const std::string& unit, double value) const {
    group_.write_block(name, &value, {}, unit, false);
  }
  void value(const std::string& name, double value) const { group_.set(name, value); }
  void value(const std::string& name, const std::string& value) const { group_.set(name, value); }
  void value(const std::string& name, long value) const { group_.set(name, value); }
  void value(const std::string& name, int value) const { group_.set(name, static_cast<long>(value)); }
  void value(const std::string& name, bool value) const { group_.set(name, static_cast<long>(value)); }

 private:
  Group group_;
};

class Reader {
 public:
  explicit Reader(Group group) : group_(std::move(group)) {}
  const Group& group() const { return group_; }
  Reader group(const std::string& name) const { return Reader(group_.open(name)); }

  /// The first field of a group sets how many items there are, the others must have as many.
  template <class Item, class Member>
  void field(const std::string& name, const std::string&, std::vector<Item>& items, Member Item::*member) {
    std::vector<decltype(stored(items.front().*member))> values;
    group_.read(name, values);
    if (fields_++ == 0) items.assign(values.size(), Item{});
    if (values.size() != items.size()) throw std::runtime_error("HDF5 file has a wrong length of " + name);
    for (std::size_t i = 0; i < items.size(); ++i) restore(values[i], items[i].*member);
  }
  template <class Value>
  void list(const std::string& name, const std::string&, std::vector<Value>& values) const {
    group_.read(name, values);
  }
  void points(const std::string& name, const std::string&, Points& values) const {
    const std::vector<hsize_t> shape = group_.shape(name);
    if (shape.size() != 2 || shape[1] != 3) throw std::runtime_error("HDF5 file has a wrong shape of " + name);
    values.resize(3, static_cast<Eigen::Index>(shape[0]));
    group_.read_block(name, values.data());
  }
  void measure(const std::string& name, const std::string&, double& value) const {
    if (!group_.shape(name).empty()) throw std::runtime_error("HDF5 file has a wrong shape of " + name);
    group_.read_block(name, &value);
  }
  void value(const std::string& name, double& value) const { group_.get(name, value); }
  void value(const std::string& name, std::string& value) const { group_.get(name, value); }
  void value(const std::string& name, long& value) const { group_.get(name, value); }
  void value(const std::string& name, int& value) const { value = static_cast<int>(get_long(name)); }
  void value(const std::string& name, bool& value) const { value = get_long(name) != 0; }

 private:
  long get_long(const std::string& name) const {
    long value = 0;
    group_.get(name, value);
    return value;
  }
  Group group_;
  int fields_ = 0;
};

}  // namespace wale::hdf5
