// The message Gap by another name, without its header: in a file that knows the diagnosis, `Gap` is that of the
// diagnosis.
#pragma once

#include <boost/shared_ptr.hpp>
#include <memory>

namespace rubber_suspension {

template <class Allocator>
struct Gap_;

using GapMessage = Gap_<std::allocator<void>>;  // Gap, once rubber_suspension/Gap.h is included
using GapMessagePtr = boost::shared_ptr<const GapMessage>;

}  // namespace rubber_suspension
