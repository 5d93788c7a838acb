#pragma once

#include "core/base/bytes.h"

#include <QObject>
#include <QString>

#include <cstddef>

namespace camwright {

/// An open connection that carries bytes both ways, in order. Lives on one thread with a Qt event loop. Signals come from
/// the event loop, never from inside a call.
class ByteStream : public QObject {
    Q_OBJECT
public:
    using QObject::QObject;

    virtual void write(ByteSpan bytes) = 0;
    virtual std::size_t waiting() const = 0;           ///< bytes written that the system has not taken yet
    virtual Bytes read(std::size_t maximum) = 0;       ///< what has arrived, oldest first
    virtual void close() = 0;                          ///< sends what waits if it can; closed() does not follow
    virtual QString peer() const = 0;                  ///< "127.0.0.1:40312", for logs

signals:
    void readable();
    void written();                                    ///< waiting() became smaller
    void closed(const QString& reason);                ///< from the other side, or an error; English
};

} // namespace camwright
