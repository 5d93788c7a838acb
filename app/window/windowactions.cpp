#include "app/window/windowactions.h"

#include "editors/shell/actions.h"

namespace camwright {

void addWindowActions(ActionCatalogue& actions)
{
    using enum Availability;
#define TEXT(text) QT_TRANSLATE_NOOP("Actions", text)
    actions.add({
        {"file.new", TEXT("&New Project..."), TEXT("Makes a project for a controller family and model."), "new", "Ctrl+N"},
        {"file.open", TEXT("&Open Project..."), TEXT("Opens a project folder."), "open", "Ctrl+O"},
        {"file.demo", TEXT("Open the &Demo Machine"), TEXT("Opens a machine with two simulated axes and connects to its virtual controller."), "run", ""},
        {"file.save", TEXT("&Save"), TEXT("Writes all edits to the project's folder."), "save", "Ctrl+S", ProjectOpen | Modified},
        {"file.saveAs", TEXT("Save &As..."), TEXT("Writes the project into another folder and goes on there."), "", "Ctrl+Shift+S", ProjectOpen},
        {"file.reload", TEXT("&Reload From Disk"), TEXT("Reads the project's files again; can be undone."), "reset", "", ProjectOpen},
        {"file.close", TEXT("&Close Project"), TEXT("Closes the project and shows the start page."), "", "", ProjectOpen},
        {"file.settings", TEXT("Se&ttings..."), TEXT("Theme and language."), "settings", "Ctrl+,"},
        {"file.quit", TEXT("&Quit"), TEXT("Ends Camwright; the virtual controller goes on for a while."), "", "Ctrl+Q"},

        {"edit.undo", TEXT("&Undo"), TEXT("Takes back the project's last step, in whichever editor it was."), "undo", "Ctrl+Z", ProjectOpen | CanUndo},
        {"edit.redo", TEXT("&Redo"), TEXT("Does the step again that was taken back."), "redo", "Ctrl+Shift+Z, Ctrl+Y", ProjectOpen | CanRedo},
        {"edit.cut", TEXT("Cu&t"), TEXT("Moves the selection to the clipboard."), "cut", "Ctrl+X", Editor},
        {"edit.copy", TEXT("&Copy"), TEXT("Copies the selection to the clipboard."), "copy", "Ctrl+C", Editor},
        {"edit.paste", TEXT("&Paste"), TEXT("Inserts what the clipboard holds."), "paste", "Ctrl+V", Editor},
        {"edit.delete", TEXT("&Delete"), TEXT("Deletes the selection."), "trash", "", Editor},
        {"edit.duplicate", TEXT("D&uplicate"), TEXT("Copies the selection with the next free name."), "", "", Editor},
        {"edit.rename", TEXT("Re&name"), TEXT("Renames the object or symbol."), "rename", "F2", Editor},
        {"edit.selectAll", TEXT("Select &All"), TEXT("Selects everything in the view."), "", "Ctrl+A", Editor},
        {"edit.find", TEXT("&Find..."), TEXT("Finds text in the current view."), "search", "Ctrl+F", Editor},
        {"edit.replace", TEXT("R&eplace..."), TEXT("Finds text and replaces it."), "replace", "Ctrl+H", Editor},
        {"edit.quickFix", TEXT("&Quick Fix"), TEXT("Offers ways out of the problem under the cursor."), "", "Alt+Return", Editor},

        {"go.anything", TEXT("&Find Anything..."), TEXT("Finds any object, variable or axis value by a part of its name."), "search", "Ctrl+P"},
        {"go.action", TEXT("Find A&ction..."), TEXT("Finds any action by a part of its name."), "keyboard", "Ctrl+Shift+P"},
        {"go.back", TEXT("&Back"), TEXT("Goes to the place before."), "arrow-left", "Alt+Left", ProjectOpen},
        {"go.forward", TEXT("F&orward"), TEXT("Goes to the place after."), "arrow-right", "Alt+Right", ProjectOpen},
        {"go.definition", TEXT("&Definition"), TEXT("Goes to where the symbol is declared."), "link", "F12", Editor},
        {"go.references", TEXT("&References"), TEXT("Lists where the symbol is used."), "", "Shift+F12", Editor},
        {"go.nextProblem", TEXT("&Next Problem"), TEXT("Shows the next problem at its place."), "problems", "F4", ProjectOpen | Problems},
        {"go.previousProblem", TEXT("&Previous Problem"), TEXT("Shows the previous problem at its place."), "", "Shift+F4", ProjectOpen | Problems},

        {"view.configure", TEXT("Layout &Configure"), TEXT("Tree, editor and properties."), "layout", "Ctrl+1", ProjectOpen},
        {"view.program", TEXT("Layout &Program"), TEXT("Tree, program, instructions and watch."), "layout", "Ctrl+2", ProjectOpen},
        {"view.commission", TEXT("Layout C&ommission"), TEXT("Axis panel with the log below."), "layout", "Ctrl+3", ProjectOpen},
        {"view.analyse", TEXT("Layout &Analyse"), TEXT("The oscilloscope, large."), "layout", "Ctrl+4", ProjectOpen},
        {"view.resetLayout", TEXT("&Reset Layout"), TEXT("Puts every dock back to where it was at first."), "", "", ProjectOpen},
        {"view.left", TEXT("Project &Tree"), TEXT("Shows or hides the project tree."), "", "Ctrl+B", ProjectOpen, true},
        {"view.right", TEXT("&Side Dock"), TEXT("Shows or hides the dock at the right."), "", "Ctrl+Shift+B", ProjectOpen, true},
        {"view.bottom", TEXT("&Bottom Dock"), TEXT("Shows or hides the dock at the bottom."), "", "Ctrl+J", ProjectOpen, true},
        {"view.closeTab", TEXT("&Close Tab"), TEXT("Closes the current editor; its edits stay in the project."), "close", "Ctrl+W", ProjectOpen},
        {"view.dark", TEXT("&Dark Theme"), TEXT("Switches between light and dark."), "theme", "", Always, true},

        {"project.check", TEXT("&Check"), TEXT("Checks the whole project and lists its problems."), "check", "Ctrl+Shift+C", ProjectOpen},
        {"project.build", TEXT("&Build"), TEXT("Checks the project and makes the controller's program."), "build", "Ctrl+Shift+F8", ProjectOpen | Idle},

        {"online.connect", TEXT("Go &Online"), TEXT("Connects to the controller at the address."), "plug", "Alt+F8", ProjectOpen | Offline},
        {"online.disconnect", TEXT("Go O&ffline"), TEXT("Ends the connection; the controller goes on as it is."), "unplug", "Ctrl+F8", Online},
        {"online.download", TEXT("&Download..."), TEXT("Shows what changes, then replaces the controller's program."), "download", "F8", ProjectOpen | Online | Idle},
        {"online.run", TEXT("&Run"), TEXT("Starts the controller's program."), "run", "F5", Online | Stopped},
        {"online.stop", TEXT("&Stop"), TEXT("Stops all axes, then the program."), "stop", "Shift+F5", Online | Running},
        {"online.releaseForces", TEXT("Release &All Forces"), TEXT("Gives every forced value back to the program."), "force", "Alt+F7", Online},
        {"online.stopAxes", TEXT("Stop All A&xes"), TEXT("Stops every axis at once; needs no control."), "stop", "Ctrl+Shift+Space", Online},

        {"help.docs", TEXT("&Documentation"), TEXT("Shows the pages that come with Camwright."), "help", "F1"},
        {"help.about", TEXT("&About Camwright"), TEXT("Version and licence."), "info", ""},
    });
#undef TEXT
}

} // namespace camwright
