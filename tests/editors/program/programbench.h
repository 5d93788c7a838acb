#pragma once

#include "core/language/compile.h"
#include "editors/document/projectdocument.h"
#include "editors/program/ilcodeview.h"
#include "editors/program/programeditor.h"
#include "editors/program/referencesmodel.h"
#include "editors/program/referencespanel.h"
#include "editors/program/register.h"
#include "editors/shell/actions.h"
#include "editors/shell/context.h"
#include "editors/shell/registry.h"

#include <QMenu>
#include <QThreadPool>
#include <QUndoStack>
#include <QtTest>

namespace camwright {

inline const ObjectKey MainProgram{ObjectKind::Program, "Main"};

/// A Kinco project with a main program, the variables Start, Run and Speed, and the axis Feed.
inline Project programProject(const std::string& source, bool strict = false)
{
    ControllerSettings controller;
    controller.family = "kinco";
    controller.model = "KS101M-04DX";
    controller.strictKinco = strict;
    Project out = Project().withContent(controllerKey(), controller);
    out = out.withContent({ObjectKind::Axis, "Feed"}, Axis());
    out = out.withContent(MainProgram, Program{ProgramRole::Main, ProgramLanguage::InstructionList, source});
    return out.withContent({ObjectKind::VariableTable, "Globals"},
        VariableTable::of({{"Start", DataType::Bool, "%M0.0", "", false, ""}, {"Run", DataType::Bool, "%M0.1", "", false, ""},
            {"Speed", DataType::Real, "%VR100", "", false, ""}}));
}

/// The program editor with all it registers, in a window of its own.
class ProgramBench : public QObject {
protected:
    void open(const std::string& source, bool strict = false)
    {
        m_document = std::make_unique<ProjectDocument>();
        m_document->adopt(programProject(source, strict));
        m_actions = std::make_unique<ActionCatalogue>();
        m_registry = std::make_unique<Registry>();
        registerProgramEditor(*m_registry, *m_actions);
        m_context = std::make_unique<Context>(*m_document, *m_actions, *m_registry, m_pool);
        check();
        m_editor = std::make_unique<ProgramEditor>(*m_context, MainProgram);
        m_editor->resize(1000, 500);
        m_editor->show();
        m_view = m_editor->findChild<IlCodeView*>("programText");
        QVERIFY(QTest::qWaitForWindowExposed(m_editor.get()));
    }

    void close()
    {
        m_editor.reset();
        m_context.reset();
        m_pool.waitForDone();
        m_document.reset();
    }

    /// What the live check of the window does.
    void check() { m_document->setDiagnostics(checkProgramText(m_document->project(), MainProgram, text())); }
    std::string text() const { return m_document->content<Program>(MainProgram)->source; }
    void putCursor(int line, int column) { m_view->setCursorPosition(line - 1, column - 1); }

    QThreadPool m_pool;
    std::unique_ptr<ActionCatalogue> m_actions;
    std::unique_ptr<Registry> m_registry;
    std::unique_ptr<ProjectDocument> m_document;
    std::unique_ptr<Context> m_context;
    std::unique_ptr<ProgramEditor> m_editor;
    IlCodeView* m_view = nullptr;
};

} // namespace camwright
