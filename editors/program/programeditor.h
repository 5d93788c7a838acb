#pragma once

#include "core/base/diagnostic.h"
#include "editors/program/textsearch.h"
#include "editors/document/projectchange.h"
#include "editors/shell/editor.h"

namespace camwright {

class FindBar;
class IlCodeView;
class Banner;
class LiveText;

/// The editor of a program in instruction list: text with colours, completion and tool tips from the catalogue, errors
/// underlined as one types with quick fixes, find and replace, references, and the controller's values while online. The text lives in the document; this is a view of it.
class ProgramEditor : public Editor {
    Q_OBJECT
public:
    ProgramEditor(Context& context, ObjectKey key, QWidget* parent = nullptr);

    QString iconName() const override { return QStringLiteral("program"); }
    void setKey(const ObjectKey& key) override;
    void reveal(const Place& place) override;
    Place place() const override;
    QString positionText() const override;
    bool can(const QString& actionId) const override;
    void perform(const QString& actionId) override;

protected:
    void showEvent(QShowEvent* event) override;
    void hideEvent(QHideEvent* event) override;

private:
    void buildView();
    void connectView();
    void documentChanged(const ProjectChange& change);
    void loadSource();
    void textEdited(std::size_t offset, std::size_t removed, const QByteArray& inserted);
    void showProblems();
    void showHover(int position, const QPoint& globalPoint);
    void cursorMoved();

    void complete(bool asked);
    void acceptCompletion(const QByteArray& text);
    void pasteText();
    void importFile();
    void importText(const std::string& text, const std::string& name);
    void toggleComment();
    void moveToDefinition();
    void findReferences();
    Diagnostics problemsHere() const;
    void showQuickFixes();
    void showLiveNotice();
    void showMenu(const QPoint& globalPoint);

    void updateSearch();
    void findNext(bool forward);
    void replaceOne();
    void replaceAll();
    void closeFind();

    IlCodeView* m_view = nullptr;
    FindBar* m_find = nullptr;
    Banner* m_notice = nullptr;
    LiveText* m_live = nullptr;
    Banner* m_liveNotice = nullptr;
    std::vector<SearchHit> m_hits;
    bool m_applying = false;
};

} // namespace camwright
