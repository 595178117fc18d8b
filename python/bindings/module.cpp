// SPDX-License-Identifier: MIT
#include <exception>
#include <system_error>

#include <nanobind/nanobind.h>

#include "python/bindings/bind.hpp"
#include "text/error.hpp"
#include "text/input_file.hpp"
#include "text/output_folder.hpp"
#include "text/quoting.hpp"

namespace nb = nanobind;

namespace fantail::python {
namespace {

void translate(const std::exception_ptr& trouble, void*) {
  try {
    std::rethrow_exception(trouble);
  } catch (const text::Error& error) {
    PyErr_SetString(PyExc_ValueError, error.what());
  } catch (const text::OutputError& error) {
    PyErr_SetString(PyExc_OSError, text::printable(error.what()).c_str());
  } catch (const std::system_error& error) {
    PyErr_SetString(PyExc_OSError, text::printable(error.what()).c_str());
  }
}

}  // namespace
}  // namespace fantail::python

NB_MODULE(_core, m) {
  m.doc() = "The libraries of Fantail; use the package fantail instead.";
  nb::register_exception_translator(fantail::python::translate);
  fantail::text::check_while_reading(fantail::python::give_up_if_interrupted);
  fantail::python::bind_plans(m);
  fantail::python::bind_scenarios(m);
  fantail::python::bind_flights(m);
  fantail::python::bind_logs(m);
  fantail::python::bind_autopilot(m);
  fantail::python::bind_verbs(m);
}
