// SPDX-License-Identifier: BSD-3-Clause
// Nothing: tests/CMakeLists.txt precompiles headers for all tests with this file's target.
