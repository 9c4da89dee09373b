// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "resources/messages/messages.h"

using resources::sentence;  // tests read what a user reads
