"""Plants violations of the include rules and sees each one caught, and clean includes left alone."""
import sys

from scan_includes import violations_of

PLANTED = [
    ("core/model/a.h", '#include <QString>'),
    ("core/model/a.h", '#include "devices/session/onlinesession.h"'),
    ("core/runtime/a.cpp", '#include <thread>'),
    ("core/runtime/a.cpp", '  #  include <mutex>'),
    ("devices/controller/a.cpp", '#include <QTimer>'),
    ("devices/session/a.cpp", '#include <QWidget>'),
    ("devices/session/a.cpp", '#include "editors/words/words.h"'),
    ("editors/words/a.cpp", '#include <QColor>'),
    ("editors/document/a.cpp", '#include <QMessageBox>'),
    ("editors/trace/a.cpp", '#include "devices/session/onlinesession.h"'),
    ("editors/trace/a.cpp", '#include "editors/watch/watchpanel.h"'),
    ("editors/shell/a.cpp", '#include <QDBusConnection>'),
    ("app/cli/a.cpp", '#include "editors/shell/theme.h"'),
]
CLEAN = [
    ("core/model/a.cpp", '#include "core/base/result.h"\n#include <vector>'),
    ("devices/session/a.cpp", '#include <QTcpSocket>\n#include "core/online/controllerlink.h"'),
    ("editors/trace/a.cpp", '#include "editors/trace/b.h"\n#include <QWidget>'),
    ("app/window/a.cpp", '#include "devices/session/onlinesession.h"\n#include "editors/watch/watchpanel.h"'),
    ("app/window/a.cpp", '#include <QDBusConnection>'),
]

failed = [p for p in PLANTED if not list(violations_of(*p))] + [c for c in CLEAN if list(violations_of(*c))]
for path, text in failed:
    print(f"wrong answer for {path}: {text}")
print(f"{len(PLANTED) + len(CLEAN) - len(failed)} passed, {len(failed)} failed")
sys.exit(1 if failed else 0)
