#include "app/window/windowactions.h"

#include "editors/shell/actions.h"

namespace camwright {

void addWindowActions(ActionCatalogue& actions)
{
    using enum Availability;
    actions.add({
        {"file.new", QT_TRANSLATE_NOOP("Actions", "&New Project..."), QT_TRANSLATE_NOOP("Actions", "Makes a project for a controller family and model."), "new", "Ctrl+N"},
        {"file.open", QT_TRANSLATE_NOOP("Actions", "&Open Project..."), QT_TRANSLATE_NOOP("Actions", "Opens a project folder."), "open", "Ctrl+O"},
        {"file.demo", QT_TRANSLATE_NOOP("Actions", "Open the &Demo Machine"), QT_TRANSLATE_NOOP("Actions", "Opens a machine with two simulated axes and connects to its virtual controller."), "run", ""},
        {"file.save", QT_TRANSLATE_NOOP("Actions", "&Save"), QT_TRANSLATE_NOOP("Actions", "Writes all edits to the project's folder."), "save", "Ctrl+S", ProjectOpen | Modified},
        {"file.saveAs", QT_TRANSLATE_NOOP("Actions", "Save &As..."), QT_TRANSLATE_NOOP("Actions", "Writes the project into another folder and goes on there."), "", "Ctrl+Shift+S", ProjectOpen},
        {"file.reload", QT_TRANSLATE_NOOP("Actions", "&Reload From Disk"), QT_TRANSLATE_NOOP("Actions", "Reads the project's files again; can be undone."), "reset", "", ProjectOpen},
        {"file.close", QT_TRANSLATE_NOOP("Actions", "&Close Project"), QT_TRANSLATE_NOOP("Actions", "Closes the project and shows the start page."), "", "", ProjectOpen},
        {"file.settings", QT_TRANSLATE_NOOP("Actions", "Se&ttings..."), QT_TRANSLATE_NOOP("Actions", "Theme, language and keys."), "settings", "Ctrl+,"},
        {"file.quit", QT_TRANSLATE_NOOP("Actions", "&Quit"), QT_TRANSLATE_NOOP("Actions", "Ends Camwright; the virtual controller goes on for a while."), "", "Ctrl+Q"},

        {"edit.undo", QT_TRANSLATE_NOOP("Actions", "&Undo"), QT_TRANSLATE_NOOP("Actions", "Takes back the project's last step, in whichever editor it was."), "undo", "Ctrl+Z", ProjectOpen | CanUndo},
        {"edit.redo", QT_TRANSLATE_NOOP("Actions", "&Redo"), QT_TRANSLATE_NOOP("Actions", "Does the step again that was taken back."), "redo", "Ctrl+Shift+Z, Ctrl+Y", ProjectOpen | CanRedo},
        {"edit.cut", QT_TRANSLATE_NOOP("Actions", "Cu&t"), QT_TRANSLATE_NOOP("Actions", "Moves the selection to the clipboard."), "cut", "Ctrl+X", Editor},
        {"edit.copy", QT_TRANSLATE_NOOP("Actions", "&Copy"), QT_TRANSLATE_NOOP("Actions", "Copies the selection to the clipboard."), "copy", "Ctrl+C", Editor},
        {"edit.paste", QT_TRANSLATE_NOOP("Actions", "&Paste"), QT_TRANSLATE_NOOP("Actions", "Inserts what the clipboard holds."), "paste", "Ctrl+V", Editor},
        {"edit.delete", QT_TRANSLATE_NOOP("Actions", "&Delete"), QT_TRANSLATE_NOOP("Actions", "Deletes the selection."), "trash", "", Editor},
        {"edit.duplicate", QT_TRANSLATE_NOOP("Actions", "D&uplicate"), QT_TRANSLATE_NOOP("Actions", "Copies the selection with the next free name."), "", "", Editor},
        {"edit.rename", QT_TRANSLATE_NOOP("Actions", "Re&name"), QT_TRANSLATE_NOOP("Actions", "Renames the object or symbol."), "rename", "F2", Editor},
        {"edit.selectAll", QT_TRANSLATE_NOOP("Actions", "Select &All"), QT_TRANSLATE_NOOP("Actions", "Selects everything in the view."), "", "Ctrl+A", Editor},
        {"edit.find", QT_TRANSLATE_NOOP("Actions", "&Find..."), QT_TRANSLATE_NOOP("Actions", "Finds text in the current view."), "search", "Ctrl+F", Editor},
        {"edit.replace", QT_TRANSLATE_NOOP("Actions", "R&eplace..."), QT_TRANSLATE_NOOP("Actions", "Finds text and replaces it."), "replace", "Ctrl+H", Editor},
        {"edit.quickFix", QT_TRANSLATE_NOOP("Actions", "&Quick Fix"), QT_TRANSLATE_NOOP("Actions", "Offers ways out of the problem under the cursor."), "", "Alt+Return, Ctrl+.", Editor},

        {"go.anything", QT_TRANSLATE_NOOP("Actions", "&Find Anything..."), QT_TRANSLATE_NOOP("Actions", "Finds any object, variable or axis value by a part of its name."), "search", "Ctrl+P"},
        {"go.action", QT_TRANSLATE_NOOP("Actions", "Find A&ction..."), QT_TRANSLATE_NOOP("Actions", "Finds any action by a part of its name."), "keyboard", "Ctrl+Shift+P"},
        {"go.back", QT_TRANSLATE_NOOP("Actions", "&Back"), QT_TRANSLATE_NOOP("Actions", "Goes to the place before."), "arrow-left", "Alt+Left", ProjectOpen},
        {"go.forward", QT_TRANSLATE_NOOP("Actions", "F&orward"), QT_TRANSLATE_NOOP("Actions", "Goes to the place after."), "arrow-right", "Alt+Right", ProjectOpen},
        {"go.nextTab", QT_TRANSLATE_NOOP("Actions", "Next &Tab"), QT_TRANSLATE_NOOP("Actions", "Shows the next tab of the group."), "", "Ctrl+Tab", ProjectOpen | TabOpen},
        {"go.previousTab", QT_TRANSLATE_NOOP("Actions", "Previous Ta&b"), QT_TRANSLATE_NOOP("Actions", "Shows the previous tab of the group."), "", "Ctrl+Shift+Tab", ProjectOpen | TabOpen},
        {"go.nextGroup", QT_TRANSLATE_NOOP("Actions", "Next &Group"), QT_TRANSLATE_NOOP("Actions", "Goes to the next group of tabs, in whichever window it is."), "", "F6", ProjectOpen | SeveralGroups},
        {"go.previousGroup", QT_TRANSLATE_NOOP("Actions", "Previous Gro&up"), QT_TRANSLATE_NOOP("Actions", "Goes to the previous group of tabs."), "", "Shift+F6", ProjectOpen | SeveralGroups},
        {"go.definition", QT_TRANSLATE_NOOP("Actions", "&Definition"), QT_TRANSLATE_NOOP("Actions", "Goes to where the symbol is declared."), "link", "F12", Editor},
        {"go.references", QT_TRANSLATE_NOOP("Actions", "&References"), QT_TRANSLATE_NOOP("Actions", "Lists where the symbol is used."), "", "Shift+F12", Editor},
        {"go.nextProblem", QT_TRANSLATE_NOOP("Actions", "&Next Problem"), QT_TRANSLATE_NOOP("Actions", "Shows the next problem at its place."), "problems", "F4", ProjectOpen | Problems},
        {"go.previousProblem", QT_TRANSLATE_NOOP("Actions", "&Previous Problem"), QT_TRANSLATE_NOOP("Actions", "Shows the previous problem at its place."), "", "Shift+F4", ProjectOpen | Problems},

        {"view.configure", QT_TRANSLATE_NOOP("Actions", "Layout &Configure"), QT_TRANSLATE_NOOP("Actions", "Tree, editor and properties."), "layout", "Ctrl+1", ProjectOpen},
        {"view.program", QT_TRANSLATE_NOOP("Actions", "Layout &Program"), QT_TRANSLATE_NOOP("Actions", "Tree, program, instructions and watch."), "layout", "Ctrl+2", ProjectOpen},
        {"view.commission", QT_TRANSLATE_NOOP("Actions", "Layout C&ommission"), QT_TRANSLATE_NOOP("Actions", "Axis panel with the log below."), "layout", "Ctrl+3", ProjectOpen},
        {"view.analyse", QT_TRANSLATE_NOOP("Actions", "Layout &Analyse"), QT_TRANSLATE_NOOP("Actions", "The oscilloscope, large."), "layout", "Ctrl+4", ProjectOpen},
        {"view.resetLayout", QT_TRANSLATE_NOOP("Actions", "&Reset Layout"), QT_TRANSLATE_NOOP("Actions", "Puts every dock back to where it was at first."), "", "", ProjectOpen},
        {"view.left", QT_TRANSLATE_NOOP("Actions", "Project &Tree"), QT_TRANSLATE_NOOP("Actions", "Shows or hides the project tree."), "", "Ctrl+B", ProjectOpen, true},
        {"view.right", QT_TRANSLATE_NOOP("Actions", "&Side Dock"), QT_TRANSLATE_NOOP("Actions", "Shows or hides the dock at the right."), "", "Ctrl+Shift+B", ProjectOpen, true},
        {"view.bottom", QT_TRANSLATE_NOOP("Actions", "&Bottom Dock"), QT_TRANSLATE_NOOP("Actions", "Shows or hides the dock at the bottom."), "", "Ctrl+J", ProjectOpen, true},
        {"view.closeTab", QT_TRANSLATE_NOOP("Actions", "&Close Tab"), QT_TRANSLATE_NOOP("Actions", "Closes the current editor; its edits stay in the project."), "close", "Ctrl+W", ProjectOpen},
        {"view.splitRight", QT_TRANSLATE_NOOP("Actions", "Split R&ight"), QT_TRANSLATE_NOOP("Actions", "Puts the current tab into a group of its own at the right."), "split-right", "Ctrl+Shift+R", ProjectOpen | TabOpen},
        {"view.splitDown", QT_TRANSLATE_NOOP("Actions", "Split Do&wn"), QT_TRANSLATE_NOOP("Actions", "Puts the current tab into a group of its own below."), "split-down", "Ctrl+Shift+D", ProjectOpen | TabOpen},
        {"view.moveTab", QT_TRANSLATE_NOOP("Actions", "&Move Tab to Next Group"), QT_TRANSLATE_NOOP("Actions", "Moves the current tab to the next group of tabs, in whichever window it is."), "", "Ctrl+F6", ProjectOpen | TabOpen | TabMovable},
        {"view.ownWindow", QT_TRANSLATE_NOOP("Actions", "Tab in Its &Own Window"), QT_TRANSLATE_NOOP("Actions", "Moves the current tab into a window of its own, or back into the main window."), "", "Ctrl+Shift+O", ProjectOpen | TabOpen, true},
        {"view.unite", QT_TRANSLATE_NOOP("Actions", "&All Tabs in One Group"), QT_TRANSLATE_NOOP("Actions", "Ends every split and brings the tabs of other windows back."), "", "", ProjectOpen | SeveralGroups},
        {"view.tabLeft", QT_TRANSLATE_NOOP("Actions", "Move Tab &Left"), QT_TRANSLATE_NOOP("Actions", "Moves the current tab one place to the left."), "", "Ctrl+Shift+PgUp", ProjectOpen | TabOpen},
        {"view.tabRight", QT_TRANSLATE_NOOP("Actions", "Move Tab Ri&ght"), QT_TRANSLATE_NOOP("Actions", "Moves the current tab one place to the right."), "", "Ctrl+Shift+PgDown", ProjectOpen | TabOpen},
        {"view.dark", QT_TRANSLATE_NOOP("Actions", "&Dark Theme"), QT_TRANSLATE_NOOP("Actions", "Switches between light and dark."), "theme", "", Always, true},

        {"project.check", QT_TRANSLATE_NOOP("Actions", "&Check"), QT_TRANSLATE_NOOP("Actions", "Checks the whole project and lists its problems."), "check", "Ctrl+Shift+C", ProjectOpen},
        {"project.build", QT_TRANSLATE_NOOP("Actions", "&Build"), QT_TRANSLATE_NOOP("Actions", "Checks the project and makes the controller's program."), "build", "Ctrl+Shift+F8", ProjectOpen | Idle},

        {"online.connect", QT_TRANSLATE_NOOP("Actions", "Go &Online"), QT_TRANSLATE_NOOP("Actions", "Connects to the controller at the address."), "plug", "Alt+F8", ProjectOpen | Offline},
        {"online.disconnect", QT_TRANSLATE_NOOP("Actions", "Go O&ffline"), QT_TRANSLATE_NOOP("Actions", "Ends the connection; the controller goes on as it is."), "unplug", "Ctrl+F8", Online},
        {"online.download", QT_TRANSLATE_NOOP("Actions", "&Download..."), QT_TRANSLATE_NOOP("Actions", "Shows what changes, then replaces the controller's program."), "download", "F8", ProjectOpen | Online | Idle},
        {"online.run", QT_TRANSLATE_NOOP("Actions", "&Run"), QT_TRANSLATE_NOOP("Actions", "Starts the controller's program."), "run", "F5", Online | Stopped},
        {"online.stop", QT_TRANSLATE_NOOP("Actions", "&Stop"), QT_TRANSLATE_NOOP("Actions", "Stops all axes, then the program."), "stop", "Shift+F5", Online | Running},
        {"online.releaseForces", QT_TRANSLATE_NOOP("Actions", "Release &All Forces"), QT_TRANSLATE_NOOP("Actions", "Gives every forced value back to the program."), "force", "Alt+F7", Online},
        {"online.stopAxes", QT_TRANSLATE_NOOP("Actions", "Stop All A&xes"), QT_TRANSLATE_NOOP("Actions", "Stops every axis at once; needs no control."), "stop", "Ctrl+Shift+Space", Online},

        {"help.docs", QT_TRANSLATE_NOOP("Actions", "&Documentation"), QT_TRANSLATE_NOOP("Actions", "Shows the pages that come with Camwright."), "help", "F1"},
        {"help.explain", QT_TRANSLATE_NOOP("Actions", "&Explain This Message"), QT_TRANSLATE_NOOP("Actions", "Shows the page about the selected message: an example and the way out. F1 in the list does the same."), "", "", Editor},
        {"help.about", QT_TRANSLATE_NOOP("Actions", "&About Camwright"), QT_TRANSLATE_NOOP("Actions", "Version and licence."), "info", ""},
    });
}

} // namespace camwright
