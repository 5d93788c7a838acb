<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="en" sourcelanguage="en">
<context>
    <name>Commands</name>
    <message numerus="yes">
        <source>Delete %n objects</source>
        <translation>
            <numerusform>Delete %n object</numerusform>
            <numerusform>Delete %n objects</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>camwright::ConnectionStrip</name>
    <message numerus="yes">
        <source>F %n forced</source>
        <translation>
            <numerusform>F %n forced</numerusform>
            <numerusform>F %n forced</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>camwright::FindBar</name>
    <message numerus="yes">
        <source>%n hit(s)</source>
        <translation>
            <numerusform>%n hit</numerusform>
            <numerusform>%n hits</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>camwright::MainWindow</name>
    <message numerus="yes">
        <source>The edits are kept: %n steps.</source>
        <translation>
            <numerusform>The edits are kept: %n step.</numerusform>
            <numerusform>The edits are kept: %n steps.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>camwright::NewProjectDialog</name>
    <message numerus="yes">
        <source>%n CAN ports</source>
        <translation>
            <numerusform>%n CAN port</numerusform>
            <numerusform>%n CAN ports</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n Ethernet ports</source>
        <translation>
            <numerusform>%n Ethernet port</numerusform>
            <numerusform>%n Ethernet ports</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>up to %n axes</source>
        <translation>
            <numerusform>up to %n axis</numerusform>
            <numerusform>up to %n axes</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>camwright::ProgramEditor</name>
    <message numerus="yes">
        <source>%n place(s) replaced. Ctrl+Z takes them back.</source>
        <translation>
            <numerusform>%n place replaced. Ctrl+Z takes it back.</numerusform>
            <numerusform>%n places replaced. Ctrl+Z takes them back.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>The pasted text has marks of a document, not of a program: %n place(s). It can be cleaned.</source>
        <translation>
            <numerusform>The pasted text has marks of a document, not of a program: %n place. It can be cleaned.</numerusform>
            <numerusform>The pasted text has marks of a document, not of a program: %n places. It can be cleaned.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>camwright::RecentList</name>
    <message numerus="yes">
        <source>%n errors</source>
        <translation>
            <numerusform>%n error</numerusform>
            <numerusform>%n errors</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n warnings</source>
        <translation>
            <numerusform>%n warning</numerusform>
            <numerusform>%n warnings</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>camwright::StatusLine</name>
    <message numerus="yes">
        <source>%n errors</source>
        <translation>
            <numerusform>%n error</numerusform>
            <numerusform>%n errors</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n warnings</source>
        <translation>
            <numerusform>%n warning</numerusform>
            <numerusform>%n warnings</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>camwright::VariablesEditor</name>
    <message numerus="yes">
        <source>%n variable(s)</source>
        <translation>
            <numerusform>%n variable</numerusform>
            <numerusform>%n variables</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>camwright::VariablesModel</name>
    <message numerus="yes">
        <source>Add %n variable(s)</source>
        <translation>
            <numerusform>Add %n variable</numerusform>
            <numerusform>Add %n variables</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Delete %n variable(s)</source>
        <translation>
            <numerusform>Delete %n variable</numerusform>
            <numerusform>Delete %n variables</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>camwright::WatchModel</name>
    <message numerus="yes">
        <source>Add %n watched value(s)</source>
        <translation>
            <numerusform>Add %n watched value</numerusform>
            <numerusform>Add %n watched values</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Remove %n watched value(s)</source>
        <translation>
            <numerusform>Remove %n watched value</numerusform>
            <numerusform>Remove %n watched values</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>camwright::Workbench</name>
    <message numerus="yes">
        <source>%n errors</source>
        <translation>
            <numerusform>%n error</numerusform>
            <numerusform>%n errors</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n warnings</source>
        <translation>
            <numerusform>%n warning</numerusform>
            <numerusform>%n warnings</numerusform>
        </translation>
    </message>
</context>
</TS>
