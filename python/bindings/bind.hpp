// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include <nanobind/nanobind.h>
#include <nanobind/ndarray.h>

namespace fantail::python {

// What each file adds to the module.
void bind_autopilot(nanobind::module_& m);
void bind_scenarios(nanobind::module_& m);
void bind_flights(nanobind::module_& m);
void bind_logs(nanobind::module_& m);
void bind_plans(nanobind::module_& m);
void bind_verbs(nanobind::module_& m);

/// Numbers that numpy reads where they lie. Nobody writes to them: several readers have the same ones.
template <typename T, typename Kept>
nanobind::ndarray<nanobind::numpy, const T, nanobind::ndim<1>> column_of(std::vector<Kept>&& values) {
  static_assert(sizeof(T) == sizeof(Kept));
  auto* kept = new std::vector<Kept>{std::move(values)};
  const nanobind::capsule owner{kept, [](void* it) noexcept { delete static_cast<std::vector<Kept>*>(it); }};
  return {kept->data(), {kept->size()}, owner};
}

/// pickle, and so copy.deepcopy and multiprocessing, cannot have an object of the library. They raise a TypeError that
/// says how to pass a `name` to another process instead.
template <typename Class>
void refuse_to_pickle(Class& bound, const char* name, const char* instead) {
  bound.def("__reduce_ex__", [name, instead](nanobind::handle, int) -> nanobind::object {
    throw nanobind::type_error((std::string{"a fantail."} + name + " cannot be pickled; " + instead).c_str());
  });
}

/// Throws what a person who has pressed Ctrl-C means by it. The caller does not hold the interpreter.
void give_up_if_interrupted();

}  // namespace fantail::python
