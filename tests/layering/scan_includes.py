"""Checks every #include of the tree against the layer table: which folders and which foreign headers a folder may name.

usage: scan_includes.py SOURCE_DIR     prints one line a violation, exits 1 if there is any
"""
import pathlib
import re
import sys

QT_HEADER = re.compile(r"^(Q[A-Za-z0-9]+|Qt[A-Za-z]+/.*|Qsci/.*|qcustomplot\.h)$")
WIDGET_HEADER = re.compile(
    r"^(QWidget|QtWidgets|QMainWindow|QDialog|QMessageBox|QFileDialog|QPushButton|QToolButton|QLabel|QLineEdit|QComboBox"
    r"|Q\w*Layout|Q\w*View|Q\w*Widget|QApplication|QDockWidget|QMenu|QMenuBar|QToolBar|QStatusBar|QTab\w+|QSplitter|QStyle\w*"
    r"|QHeaderView|QStyledItemDelegate|QCompleter|QScroll\w+|QCheckBox|QRadioButton|QSlider|QSpinBox|QFrame|QToolTip)$")
GUI_HEADER = re.compile(r"^(QtGui.*|QColor|QFont\w*|QIcon|QImage|QPainter\w*|QPixmap|QPen|QBrush|QKey\w+|QMouse\w+|QWindow|QScreen"
                        r"|QClipboard|QCursor|QPalette|QSvg\w+|QPolygon\w*|QTransform)$")
DBUS_HEADER = re.compile(r"^(QDBus\w+|QtDBus.*)$") # the window's alone
CORE_FORBIDDEN = {"thread", "mutex", "condition_variable", "future", "locale", "filesystem"}

# folder prefix -> the folders of ours it may include, whether it may use Qt Core, Gui, Widgets
RULES = [
    ("core/", ["core/"], False, False, False),
    ("devices/controller/", ["core/", "devices/controller/"], False, False, False),
    ("devices/", ["core/", "devices/"], True, False, False),
    ("editors/words/", ["core/", "editors/words/"], True, False, False),
    ("editors/document/", ["core/", "editors/words/", "editors/document/"], True, True, False),
    ("editors/shell/", ["core/", "editors/words/", "editors/document/", "editors/shell/"], True, True, True),
    ("editors/", ["core/", "editors/words/", "editors/document/", "editors/shell/"], True, True, True),
    ("app/runtime/", ["core/", "devices/", "app/runtime/"], True, False, False),
    ("app/cli/", ["core/", "devices/", "editors/words/", "app/cli/"], True, False, False),
    ("app/", ["core/", "devices/", "editors/", "app/"], True, True, True),
]
# Files of core that may touch the file system: the one implementation behind core/storage/filesystem.h.
FILESYSTEM_ALLOWED = re.compile(r"^core/storage/")
OWN = ("core/", "devices/", "editors/", "app/", "tests/")


def rule_for(path):
    return next((r for r in RULES if path.startswith(r[0])), None)


def violations_of(path, text):
    rule = rule_for(path)
    if rule is None:
        return
    prefix, allowed, qt, gui, widgets = rule
    own_folder = "/".join(path.split("/")[:2]) + "/"
    for number, line in enumerate(text.splitlines(), 1):
        match = re.match(r'\s*#\s*include\s*[<"]([^>"]+)[>"]', line)
        if not match:
            continue
        name = match.group(1)
        if name.startswith(OWN):
            if not any(name.startswith(a) for a in allowed + [own_folder]):
                yield number, f"{name}: {prefix} may not include it"
        elif QT_HEADER.match(name):
            if DBUS_HEADER.match(name) and not path.startswith("app/window/"):
                yield number, f"{name}: only app/window speaks D-Bus"
            elif not qt:
                yield number, f"{name}: {prefix} knows no Qt"
            elif WIDGET_HEADER.match(name) and not widgets:
                yield number, f"{name}: {prefix} knows no widgets"
            elif GUI_HEADER.match(name) and not gui:
                yield number, f"{name}: {prefix} knows no Qt Gui"
        elif path.startswith("core/") and name in CORE_FORBIDDEN and not FILESYSTEM_ALLOWED.match(path):
            yield number, f"{name}: core has no threads, locale or file system of its own"


def main(root):
    bad = 0
    for folder in ("core", "devices", "editors", "app"):
        for file in sorted((root / folder).rglob("*")):
            if file.suffix not in (".h", ".cpp"):
                continue
            path = file.relative_to(root).as_posix()
            for number, why in violations_of(path, file.read_text(encoding="utf-8")):
                print(f"{path}:{number}: {why}")
                bad += 1
    print(f"{bad} violations")
    return 1 if bad else 0


if __name__ == "__main__":
    sys.exit(main(pathlib.Path(sys.argv[1])))
