#pragma once

#include <QTabBar>

namespace camwright {

/// Tabs of a dock: words, an accent line under the current one, a badge where tabData() is a number above 0.
class BadgeTabBar : public QTabBar {
    Q_OBJECT
public:
    explicit BadgeTabBar(QWidget* parent = nullptr);

protected:
    void paintEvent(QPaintEvent* event) override;
    QSize tabSizeHint(int index) const override;
    QSize minimumTabSizeHint(int index) const override { return tabSizeHint(index); }

private:
    QSize badgeSize(int index) const;
};

} // namespace camwright
