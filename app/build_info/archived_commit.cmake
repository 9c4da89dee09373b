# SPDX-License-Identifier: BSD-3-Clause
# git archive writes the commit here, for builds outside a repository.
set(archived "$Format:%H$")
