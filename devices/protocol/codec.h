#pragma once

#include "core/base/bytes.h"
#include "core/base/result.h"
#include "core/online/messages.h"

#include <string>

namespace camwright {

/// The CBOR of one frame's body (docs/protocol.md): an array of message number, request number and a map of fields.
Bytes encode(const Envelope& envelope);

/// Reads what encode() wrote. Everything else is refused with the reason in English: another shape or type, a number out
/// of range, a field missing or given twice, nesting deeper than 16, bytes left over. Fields it does not know are skipped.
/// It allocates no more than a small multiple of the bytes given.
Result<Envelope, std::string> decode(ByteSpan body);

} // namespace camwright
