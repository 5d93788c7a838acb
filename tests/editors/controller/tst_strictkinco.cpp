#include "editors/controller/controllereditor.h"
#include "editors/document/projectdocument.h"
#include "editors/shell/actions.h"
#include "editors/shell/context.h"
#include "editors/shell/registry.h"
#include "editors/shell/widgets.h"

#include <QThreadPool>
#include <QUndoStack>
#include <QtTest>

using namespace camwright;

class StrictKincoTest : public QObject {
    Q_OBJECT
private slots:
    void strictKincoIsOneStep() // C32
    {
        open("kinco", "KS101M-04DX");
        auto* strict = m_editor->findChild<Switch*>("strict_kinco");
        QVERIFY(strict->isVisible());
        QVERIFY(!strict->isChecked());
        QVERIFY(!strict->toolTip().isEmpty());
        QTest::mouseClick(strict, Qt::LeftButton);
        QVERIFY(m_document->project().controller().strictKinco.value());
        QCOMPARE(m_document->undoStack().count(), 1);
        m_document->undo();
        QVERIFY(!m_document->project().controller().strictKinco.value());
        QVERIFY(!strict->isChecked());
    }

    void strictKincoIsAbsentForOthers()
    {
        open("invt", "TS635");
        QVERIFY(!m_editor->findChild<Switch*>("strict_kinco")->isVisible());
    }

    void problemOfTheSwitchStandsBelowIt()
    {
        open("kinco", "KS101M-04DX");
        m_document->setDiagnostics({diagnostic(Code::FieldNotOneOf, {"perhaps", "strict_kinco", "false, true"}, Place{controllerKey(), "strict_kinco", {}, {}})});
        const auto labels = m_editor->findChildren<QLabel*>();
        QVERIFY(std::any_of(labels.begin(), labels.end(), [](const QLabel* label) { return label->isVisible() && label->text().contains("perhaps"); }));
        m_editor->reveal(Place{controllerKey(), "strict_kinco", {}, {}});
        QVERIFY(m_editor->findChild<Switch*>("strict_kinco")->hasFocus() || !m_editor->isActiveWindow());
    }

    void cleanup()
    {
        m_editor.reset();
        m_context.reset();
        m_document.reset();
    }

private:
    void open(const std::string& family, const std::string& model)
    {
        ControllerSettings controller;
        controller.family = family;
        controller.model = model;
        m_document = std::make_unique<ProjectDocument>();
        m_document->adopt(Project().withContent(controllerKey(), controller));
        m_context = std::make_unique<Context>(*m_document, m_actions, m_registry, m_pool);
        m_editor = std::make_unique<ControllerEditor>(*m_context, controllerKey());
        m_editor->show();
        QVERIFY(QTest::qWaitForWindowExposed(m_editor.get()));
    }

    QThreadPool m_pool;
    ActionCatalogue m_actions;
    Registry m_registry;
    std::unique_ptr<ProjectDocument> m_document;
    std::unique_ptr<Context> m_context;
    std::unique_ptr<ControllerEditor> m_editor;
};

QTEST_MAIN(StrictKincoTest)
#include "tst_strictkinco.moc"
