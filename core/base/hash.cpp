#include "core/base/hash.h"

#include <sodium.h>

namespace camwright {

Hash hashOf(ByteSpan bytes)
{
    Hash out;
    crypto_generichash(out.bytes.data(), out.bytes.size(), bytes.data(), bytes.size(), nullptr, 0);
    return out;
}

std::string toHex(const Hash& hash)
{
    std::string out(hash.bytes.size() * 2 + 1, '\0');
    sodium_bin2hex(out.data(), out.size(), hash.bytes.data(), hash.bytes.size());
    out.pop_back();
    return out;
}

} // namespace camwright
