// SPDX-License-Identifier: BSD-3-Clause
#include "haptics/edit/operators.h"

namespace haptics {

MadeOperator holderOperator(const Volume&, const RemoveHolder&, const EditWatch&) {
  return tl::unexpected(Error{Error::Kind::Unsupported, {"edit-no-holder", {}}, "nothing"});
}

}  // namespace haptics
