// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QColor>
#include <array>

namespace ui::style {

// The colours of what is drawn in the views, which are dark in every theme. Red is for a frame and
// a line only; the stop button's red is its own.

inline constexpr QColor kViewGround{0x0c, 0x0d, 0x11};
inline constexpr QColor kSliceGround{0x00, 0x00, 0x00};
inline constexpr QColor kBetweenViews{0x10, 0x12, 0x16};
inline constexpr QColor kViewFrame{0x2b, 0x31, 0x3c};
inline constexpr QColor kViewText{0xe6, 0xe9, 0xee};
inline constexpr QColor kViewDim{0x98, 0xa2, 0xb3};
inline constexpr QColor kViewButton{16, 18, 22, 170};
inline constexpr QColor kViewFocus{0x4d, 0xa3, 0xff};
/// Around words and lines that lie on the anatomy.
inline constexpr QColor kRim{0, 0, 0, 200};
inline constexpr QColor kViewRim{12, 13, 17, 200};
inline constexpr QColor kReadout{188, 194, 204};
inline constexpr QColor kLetter{255, 217, 51};
inline constexpr QColor kViewAttention{0xe0, 0xa6, 0x3a};

inline constexpr QColor kAxial{0xe0, 0x55, 0x5f};
inline constexpr QColor kCoronal{0x56, 0xb8, 0x70};
inline constexpr QColor kSagittal{0xe0, 0xc1, 0x4a};
inline constexpr QColor kOblique{0xb0, 0x8c, 0xf0};

inline constexpr QColor kContour{255, 170, 90};
inline constexpr QColor kProxyLine{60, 180, 255}, kDeviceLine{255, 110, 50};
inline constexpr QColor kContact{255, 255, 255}, kForceArrow{77, 163, 255};

inline constexpr QColor kCubeLetter{230, 233, 238}, kCubeLine{152, 162, 179};
inline constexpr QColor kCubeDark{31, 35, 43}, kCubeLight{67, 75, 90};

inline constexpr QColor kMeasure{238, 150, 255}, kChosenMeasure{255, 235, 255};
inline constexpr QColor kMeasureRim{0, 0, 0, 190}, kMeasureGround{0, 0, 0, 175};

// tools that take parts away: outlines and handles in one colour, what goes in another
inline constexpr QColor kOutline{77, 163, 255}, kGoes{224, 166, 58};
inline constexpr QColor kHandleRim{12, 13, 17}, kHeldHandle{255, 255, 255};

/// A colour of VTK: red, green and blue from 0 to 1.
using Rgb = std::array<double, 3>;
inline constexpr Rgb kProxy{0.33, 0.52, 0.78};    ///< blue steel
inline constexpr Rgb kTurning{1.00, 0.62, 0.10};  ///< amber: its burr turns
inline constexpr Rgb kCutFace{0.93, 0.56, 0.47};  ///< coral, against bone
inline constexpr Rgb kDevice{1.00, 0.35, 0.10};   ///< orange
inline constexpr Rgb kFilmLetter{1.0, 0.85, 0.2};
inline constexpr Rgb kIvory{0.93, 0.88, 0.78};
inline constexpr Rgb kAirway{0.86, 0.63, 0.60};
inline constexpr Rgb kSkin{0.88, 0.70, 0.58};
inline constexpr Rgb kSoft{0.76, 0.40, 0.34};
inline constexpr Rgb kVessel{0.80, 0.20, 0.17};
inline constexpr Rgb kTooth{0.96, 0.95, 0.90};

}  // namespace ui::style
