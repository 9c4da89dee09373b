// SPDX-License-Identifier: BSD-3-Clause
// Nothing: CMakeLists.txt precompiles the headers of the windows' tests with this file's target.
