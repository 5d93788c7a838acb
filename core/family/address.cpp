#include "core/family/address.h"

namespace camwright {

bool overlap(const Address& a, const Address& b)
{
    if (a.area != b.area)
        return false;
    if (a.isBit && b.isBit)
        return a.byte == b.byte && a.bit == b.bit;
    return a.byte < b.byte + byteWidth(b.type) && b.byte < a.byte + byteWidth(a.type);
}

} // namespace camwright
