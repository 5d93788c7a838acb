#pragma once

#include "core/base/codes.h"

#include <QObject>

#include <functional>
#include <optional>

class QAbstractItemView;
class QMenu;

namespace camwright {

class Context;

/// Lets a list of messages explain its current row: F1 and an entry of its context menu open the page of the row's code.
/// F1 is taken from the window only while the list has the focus and a message is current. Owned by the list.
class Explain : public QObject {
    Q_OBJECT
public:
    /// The code in a row; nothing where the row has none.
    using CodeOfRow = std::function<std::optional<Code>(int row)>;

    Explain(Context& context, QAbstractItemView* list, CodeOfRow codeOfRow);

    bool can() const { return current().has_value(); }
    void explain();
    /// What else stands in the context menu, above the explanation.
    void setMenu(std::function<void(QMenu&)> fill) { m_fillMenu = std::move(fill); }

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    std::optional<Code> current() const;
    void showMenu(const QPoint& point);

    Context& m_context;
    QAbstractItemView* m_list;
    CodeOfRow m_codeOfRow;
    std::function<void(QMenu&)> m_fillMenu;
};

} // namespace camwright
