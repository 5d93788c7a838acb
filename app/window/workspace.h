#pragma once

#include "app/window/connection.h"
#include "app/window/keybook.h"
#include "app/window/services.h"
#include "app/window/settings.h"
#include "app/window/workbench.h"
#include "editors/document/livechecks.h"
#include "editors/document/projectdocument.h"
#include "editors/shell/actions.h"
#include "editors/shell/context.h"
#include "editors/shell/registry.h"

#include <QThreadPool>

namespace camwright {

/// All that outlives a window: the open project, the controller, the workers, the catalogue of actions. A change of language
/// makes the window anew on the same workspace.
class Workspace : public QObject {
    Q_OBJECT
public:
    using Registrar = std::function<void(Registry&, ActionCatalogue&)>;

    Workspace(Services services, Registrar registrar);
    ~Workspace() override;

    QThreadPool pool; ///< checks, builds; first so that it dies last
    Settings settings;
    ProjectDocument document;
    ActionCatalogue actions;
    KeyBook keys;
    Registry registry;
    Context context;
    Services services;
    LiveChecks checks;
    Connection connection;
    Workbench workbench;

    /// Texts of the registry and the actions in the current language.
    void retranslate();
    /// Notes for the start page how the project stands.
    void rememberProject();

private:
    Registrar m_registrar;
};

} // namespace camwright
