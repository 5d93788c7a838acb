#pragma once

#include "core/model/project.h"

#include <QDialog>

class QComboBox;
class QLabel;
class QLineEdit;
class QPushButton;

namespace camwright {

/// A new project: family, model, name, folder.
class NewProjectDialog : public QDialog {
    Q_OBJECT
public:
    NewProjectDialog(const QString& familyId, const QString& parentFolder, QWidget* parent);

    Project project() const;
    QString path() const;         ///< folder to be made
    QString parentFolder() const;

private:
    void fillModels();
    void refresh();

    QComboBox* m_family;
    QComboBox* m_model;
    QLabel* m_facts;
    QLineEdit* m_name;
    QLineEdit* m_folder;
    QLabel* m_problem;
    QPushButton* m_create;
};

/// What a new project of a model begins with: an empty main program, a table of variables, a watch list, and a motion network
/// where the model has one.
Project emptyProject(const std::string& family, const std::string& model, const std::string& name);

} // namespace camwright
