#pragma once

#include "core/base/place.h"

#include <QByteArray>
#include <QList>
#include <QString>

#include <optional>
#include <vector>

namespace camwright {

/// How the editors stand: groups of tabs side by side or below one another, and windows beside the main one. A value, kept
/// in the user's settings per project and layout.
struct Arrangement {
    struct Tab {
        ObjectKey key;                 ///< of an editor; default for a panel
        QString viewId;                ///< or the panel's id
        bool preview = false;
        bool operator==(const Tab&) const = default;
    };
    /// A group of tabs, or parts beside one another (then it has no tabs).
    struct Node {
        std::vector<Node> parts;
        bool horizontal = true;        ///< the parts stand side by side, else below one another
        QList<int> sizes;              ///< of the parts, in pixels; as many as parts
        std::vector<Tab> tabs;
        int current = 0;               ///< of the tabs
        bool operator==(const Node&) const = default;
    };
    struct Window {
        QByteArray geometry;           ///< QWidget::saveGeometry()
        Node root;
        bool operator==(const Window&) const = default;
    };

    Node main;
    std::vector<Window> windows;
    bool operator==(const Arrangement&) const = default;

    bool isEmpty() const;              ///< no tab anywhere
    QByteArray toBytes() const;
    /// Nothing for bytes that are not an arrangement, are nested deeper than 8 or hold more than 16 windows.
    static std::optional<Arrangement> fromBytes(const QByteArray& bytes);
};

} // namespace camwright
