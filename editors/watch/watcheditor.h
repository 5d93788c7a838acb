#pragma once

#include "editors/shell/editor.h"

namespace camwright {

class WatchView;

/// A watch list in a tab of its own.
class WatchEditor : public Editor {
    Q_OBJECT
public:
    WatchEditor(Context& context, ObjectKey key, QWidget* parent = nullptr);

    QString iconName() const override { return QStringLiteral("watch"); }
    void setKey(const ObjectKey& key) override;
    void reveal(const Place& place) override;
    bool can(const QString& actionId) const override;
    void perform(const QString& actionId) override;

private:
    WatchView* m_view;
};

} // namespace camwright
