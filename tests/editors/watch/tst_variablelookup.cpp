#include "editors/watch/variablelookup.h"

#include <QtTest>

using namespace camwright;

namespace {

Project machine()
{
    Project out = Project().withContent({ObjectKind::VariableTable, "Globals"},
        VariableTable::of({{"Start", DataType::Bool, "%I0.0", "", false, "Start button"}, {"Speed", DataType::Real, "%VR100", "", false, ""},
            {"Counter", DataType::Int, "", "", false, "Parts made"}}));
    out = out.withContent({ObjectKind::Axis, "Feed"}, Axis{});
    return out.withContent({ObjectKind::Axis, "Axis 2 name"}, Axis{});
}

} // namespace

class VariableLookupTest : public QObject {
    Q_OBJECT

private slots:
    void commentIsFoundByNameAndByAddress()
    {
        QCOMPARE(commentOf(machine(), "Start"), QString("Start button"));
        QCOMPARE(commentOf(machine(), "%I0.0"), QString("Start button"));
    }

    void addressWithoutACommentTellsItsVariable()
    {
        QCOMPARE(commentOf(machine(), "%VR100"), QString("Speed"));
        QCOMPARE(commentOf(machine(), "Speed"), QString());
    }

    void axisValuesSayWhatTheyAre_data()
    {
        QTest::addColumn<QString>("expression");
        QTest::addColumn<QString>("comment");
        QTest::newRow("position") << "axis.Feed.position" << "Actual position, from the drive";
        QTest::newRow("setPosition is not position") << "axis.Feed.setPosition" << "Position the drive is commanded to";
        QTest::newRow("quoted axis") << "axis.\"Axis 2 name\".velocity" << "Actual velocity, units per second";
        QTest::newRow("following error is not error") << "axis.1.followingError" << "Commanded less actual position";
        QTest::newRow("error") << "axis.1.error" << "Error code of the axis, 0 for none";
        QTest::newRow("no such axis value") << "axis.1.colour" << "";
        QTest::newRow("unknown variable") << "Nothing" << "";
    }

    void axisValuesSayWhatTheyAre()
    {
        QFETCH(QString, expression);
        QTEST(commentOf(machine(), expression.toStdString()), "comment");
    }

    void aVariableOfTheNameGoesBeforeTheAxisValue()
    {
        const Project project = machine().withContent({ObjectKind::VariableTable, "Odd"},
            VariableTable::of({{"axis.Feed.position", DataType::Real, "", "", false, "Mine"}}));
        QCOMPARE(commentOf(project, "axis.Feed.position"), QString("Mine"));
    }

    void offersVariablesAddressesAndAxisValues()
    {
        const QStringList names = watchableNames(machine());
        QCOMPARE(names.mid(0, 5), QStringList({"Start", "%I0.0", "Speed", "%VR100", "Counter"}));
        QVERIFY(names.contains("axis.Feed.followingError"));
        QVERIFY(names.contains("axis.\"Axis 2 name\".state"));
        QCOMPARE(names.size(), 5 + 2 * 7);
    }

    void offersANameOnce()
    {
        const Project project = machine().withContent({ObjectKind::VariableTable, "More"},
            VariableTable::of({{"Start", DataType::Bool, "%I0.0", "", false, ""}}));
        QCOMPARE(watchableNames(project).count("Start"), 1);
    }
};

QTEST_GUILESS_MAIN(VariableLookupTest)
#include "tst_variablelookup.moc"
