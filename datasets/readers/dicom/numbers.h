// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string_view>
#include <vector>

class vtkDICOMValue;

namespace datasets {

/// A decimal string (DS) as PS3.5 6.2 writes it, spaces around it included: "-1.5E3". Returns
/// nullopt for anything else: a comma, a unit, "nan", "0x10", a number beyond a double. More than
/// the 16 characters of the standard are accepted, since many programs write all digits of a
/// double.
std::optional<double> decimalString(std::string_view text);

/// An integer string (IS), of 32 bits.
std::optional<int> integerString(std::string_view text);

/// The numbers of an element, text or binary. Returns an empty vector if the element is absent or
/// empty, and nullopt if a value is not a finite number.
std::optional<std::vector<double>> numbersIn(const vtkDICOMValue& value);
/// The same, with nullopt in the place of each value that is not a finite number.
std::vector<std::optional<double>> eachNumberIn(const vtkDICOMValue& value);

}  // namespace datasets
