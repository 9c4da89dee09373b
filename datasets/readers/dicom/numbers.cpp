// SPDX-License-Identifier: BSD-3-Clause
#include "datasets/readers/dicom/numbers.h"

#include <vtkDICOMVR.h>
#include <vtkDICOMValue.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <string>

namespace datasets {
namespace {

/// Without the padding around it: spaces, and zeros behind, which some programs write.
std::string_view withoutPadding(std::string_view text) {
  while (!text.empty() && (text.back() == ' ' || text.back() == '\0')) text.remove_suffix(1);
  while (!text.empty() && text.front() == ' ') text.remove_prefix(1);
  return text;
}

template <class Number>
std::optional<Number> wholeNumber(std::string_view text, std::string_view letters) {
  text = withoutPadding(text);
  if (text.find_first_not_of(letters) != text.npos) return {};
  if (text.starts_with('+')) {
    text.remove_prefix(1);
    if (text.starts_with('-')) return {};
  }
  Number number{};
  const char* end = text.data() + text.size();
  const auto [stopped, error] = std::from_chars(text.data(), end, number);
  if (error != std::errc{} || stopped != end) return {};
  return number;
}

bool isBinary(vtkDICOMVR representation) {
  using VR = vtkDICOMVR;
  for (const VR known : {VR(VR::US), VR(VR::SS), VR(VR::UL), VR(VR::SL), VR(VR::FL), VR(VR::FD)})
    if (representation == known) return true;
  return false;
}

}  // namespace

std::optional<double> decimalString(std::string_view text) {
  return wholeNumber<double>(text, "0123456789+-.eE");
}

std::optional<int> integerString(std::string_view text) {
  return wholeNumber<int>(text, "0123456789+-");
}

std::optional<std::vector<double>> numbersIn(const vtkDICOMValue& value) {
  std::vector<double> numbers;
  for (const std::optional<double>& number : eachNumberIn(value)) {
    if (!number) return {};
    numbers.push_back(*number);
  }
  return numbers;
}

std::vector<std::optional<double>> eachNumberIn(const vtkDICOMValue& value) {
  if (!value.IsValid()) return {};
  if (isBinary(value.GetVR())) {
    std::vector<double> numbers(value.GetNumberOfValues());
    if (!numbers.empty()) value.GetValues(numbers.data(), numbers.size());
    std::vector<std::optional<double>> finite;
    for (const double x : numbers)
      finite.push_back(std::isfinite(x) ? std::optional(x) : std::nullopt);
    return finite;
  }
  const std::string text = value.AsString();
  std::vector<std::optional<double>> numbers;
  if (withoutPadding(text).empty()) return numbers;
  for (std::string_view rest = text;;) {
    const auto end = rest.find('\\');
    numbers.push_back(decimalString(rest.substr(0, end)));
    if (end == rest.npos) return numbers;
    rest.remove_prefix(end + 1);
  }
}

}  // namespace datasets
