<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="ru" sourcelanguage="en">
<context>
    <name>Actions</name>
    <message>
        <source>&amp;About Camwright</source>
        <translation>&amp;О программе Camwright</translation>
    </message>
    <message>
        <source>&amp;All Tabs in One Group</source>
        <translation>Все вкладки в &amp;одну группу</translation>
    </message>
    <message>
        <source>&amp;Back</source>
        <translation>На&amp;зад</translation>
    </message>
    <message>
        <source>&amp;Bottom Dock</source>
        <translation>Ни&amp;жняя панель</translation>
    </message>
    <message>
        <source>&amp;Build</source>
        <translation>&amp;Собрать</translation>
    </message>
    <message>
        <source>&amp;Check</source>
        <translation>&amp;Проверить</translation>
    </message>
    <message>
        <source>&amp;Close Project</source>
        <translation>&amp;Закрыть проект</translation>
    </message>
    <message>
        <source>&amp;Close Tab</source>
        <translation>&amp;Закрыть вкладку</translation>
    </message>
    <message>
        <source>&amp;Copy</source>
        <translation>&amp;Копировать</translation>
    </message>
    <message>
        <source>&amp;Dark Theme</source>
        <translation>&amp;Тёмная тема</translation>
    </message>
    <message>
        <source>&amp;Definition</source>
        <translation>&amp;Определение</translation>
    </message>
    <message>
        <source>&amp;Delete</source>
        <translation>&amp;Удалить</translation>
    </message>
    <message>
        <source>&amp;Documentation</source>
        <translation>&amp;Документация</translation>
    </message>
    <message>
        <source>&amp;Download...</source>
        <translation>&amp;Загрузить...</translation>
    </message>
    <message>
        <source>&amp;Explain This Message</source>
        <translation>&amp;Пояснить это сообщение</translation>
    </message>
    <message>
        <source>&amp;Find Anything...</source>
        <translation>&amp;Найти что угодно...</translation>
    </message>
    <message>
        <source>&amp;Find...</source>
        <translation>&amp;Найти...</translation>
    </message>
    <message>
        <source>&amp;Force Selected Value</source>
        <translation>&amp;Форсировать выбранное значение</translation>
    </message>
    <message>
        <source>&amp;Import Kinco Program Text...</source>
        <translation>&amp;Импортировать текст программы Kinco...</translation>
    </message>
    <message>
        <source>&amp;Move Tab to Next Group</source>
        <translation>Вкладку в &amp;следующую группу</translation>
    </message>
    <message>
        <source>&amp;New Project...</source>
        <translation>&amp;Новый проект...</translation>
    </message>
    <message>
        <source>&amp;Next Problem</source>
        <translation>С&amp;ледующая проблема</translation>
    </message>
    <message>
        <source>&amp;Open Project...</source>
        <translation>&amp;Открыть проект...</translation>
    </message>
    <message>
        <source>&amp;Paste</source>
        <translation>Вст&amp;авить</translation>
    </message>
    <message>
        <source>&amp;Previous Problem</source>
        <translation>&amp;Предыдущая проблема</translation>
    </message>
    <message>
        <source>&amp;Quick Fix</source>
        <translation>&amp;Быстрое исправление</translation>
    </message>
    <message>
        <source>&amp;Quit</source>
        <translation>В&amp;ыход</translation>
    </message>
    <message>
        <source>&amp;Redo</source>
        <translation>&amp;Повторить</translation>
    </message>
    <message>
        <source>&amp;References</source>
        <translation>Места &amp;использования</translation>
    </message>
    <message>
        <source>&amp;Reload From Disk</source>
        <translation>&amp;Перечитать с диска</translation>
    </message>
    <message>
        <source>&amp;Reset Layout</source>
        <translation>&amp;Сбросить раскладку</translation>
    </message>
    <message>
        <source>&amp;Run</source>
        <translation>Пу&amp;ск</translation>
    </message>
    <message>
        <source>&amp;Save</source>
        <translation>&amp;Сохранить</translation>
    </message>
    <message>
        <source>&amp;Side Dock</source>
        <translation>&amp;Боковая панель</translation>
    </message>
    <message>
        <source>&amp;Stop</source>
        <translation>Ос&amp;танов</translation>
    </message>
    <message>
        <source>&amp;Undo</source>
        <translation>&amp;Отменить</translation>
    </message>
    <message>
        <source>Axis panel with the log below.</source>
        <translation>Панель оси, под ней журнал.</translation>
    </message>
    <message>
        <source>Checks the project and makes the controller&apos;s program.</source>
        <translation>Проверяет проект и создаёт программу контроллера.</translation>
    </message>
    <message>
        <source>Checks the whole project and lists its problems.</source>
        <translation>Проверяет весь проект и перечисляет проблемы.</translation>
    </message>
    <message>
        <source>Closes the current editor; its edits stay in the project.</source>
        <translation>Закрывает текущий редактор; правки остаются в проекте.</translation>
    </message>
    <message>
        <source>Closes the project and shows the start page.</source>
        <translation>Закрывает проект и показывает начальную страницу.</translation>
    </message>
    <message>
        <source>Co&amp;mment Lines</source>
        <translation>За&amp;комментировать строки</translation>
    </message>
    <message>
        <source>Complete &amp;Word</source>
        <translation>Дополнить сло&amp;во</translation>
    </message>
    <message>
        <source>Connects to the controller at the address.</source>
        <translation>Подключается к контроллеру по этому адресу.</translation>
    </message>
    <message>
        <source>Copies the selection to the clipboard.</source>
        <translation>Копирует выделенное в буфер обмена.</translation>
    </message>
    <message>
        <source>Copies the selection with the next free name.</source>
        <translation>Копирует выделенное под следующим свободным именем.</translation>
    </message>
    <message>
        <source>Cu&amp;t</source>
        <translation>&amp;Вырезать</translation>
    </message>
    <message>
        <source>D&amp;uplicate</source>
        <translation>&amp;Дублировать</translation>
    </message>
    <message>
        <source>Deletes the selection.</source>
        <translation>Удаляет выделенное.</translation>
    </message>
    <message>
        <source>Does the step again that was taken back.</source>
        <translation>Выполняет отменённый шаг снова.</translation>
    </message>
    <message>
        <source>Ends Camwright; the virtual controller goes on for a while.</source>
        <translation>Завершает Camwright; виртуальный контроллер ещё некоторое время работает.</translation>
    </message>
    <message>
        <source>Ends every split and brings the tabs of other windows back.</source>
        <translation>Убирает все разделения и возвращает вкладки из других окон.</translation>
    </message>
    <message>
        <source>Ends the connection; the controller goes on as it is.</source>
        <translation>Завершает соединение; контроллер продолжает работать как есть.</translation>
    </message>
    <message>
        <source>F&amp;orward</source>
        <translation>&amp;Вперёд</translation>
    </message>
    <message>
        <source>Find &amp;Next</source>
        <translation>Найти &amp;следующее</translation>
    </message>
    <message>
        <source>Find A&amp;ction...</source>
        <translation>Найти &amp;действие...</translation>
    </message>
    <message>
        <source>Find Pre&amp;vious</source>
        <translation>Найти &amp;предыдущее</translation>
    </message>
    <message>
        <source>Finds any action by a part of its name.</source>
        <translation>Ищет любое действие по части названия.</translation>
    </message>
    <message>
        <source>Finds any object, variable or axis value by a part of its name.</source>
        <translation>Ищет любой объект, переменную или значение оси по части имени.</translation>
    </message>
    <message>
        <source>Finds text and replaces it.</source>
        <translation>Ищет текст и заменяет его.</translation>
    </message>
    <message>
        <source>Finds text in the current view.</source>
        <translation>Ищет текст в текущем виде.</translation>
    </message>
    <message>
        <source>Gives every forced value back to the program.</source>
        <translation>Возвращает программе все форсированные значения.</translation>
    </message>
    <message>
        <source>Go &amp;Online</source>
        <translation>&amp;Подключиться</translation>
    </message>
    <message>
        <source>Go O&amp;ffline</source>
        <translation>&amp;Отключиться</translation>
    </message>
    <message>
        <source>Goes to the hit before.</source>
        <translation>Переходит к предыдущему совпадению.</translation>
    </message>
    <message>
        <source>Goes to the next group of tabs, in whichever window it is.</source>
        <translation>Переходит к следующей группе вкладок, в каком бы окне она ни была.</translation>
    </message>
    <message>
        <source>Goes to the next hit.</source>
        <translation>Переходит к следующему совпадению.</translation>
    </message>
    <message>
        <source>Goes to the place after.</source>
        <translation>Переходит к следующему месту.</translation>
    </message>
    <message>
        <source>Goes to the place before.</source>
        <translation>Переходит к предыдущему месту.</translation>
    </message>
    <message>
        <source>Goes to the previous group of tabs.</source>
        <translation>Переходит к предыдущей группе вкладок.</translation>
    </message>
    <message>
        <source>Goes to where the symbol is declared.</source>
        <translation>Переходит туда, где объявлен символ.</translation>
    </message>
    <message>
        <source>Holds the selected watched value, as typed or as it is, until it is released.</source>
        <translation>Удерживает выбранное значение списка, введённое или текущее, пока форсирование не снято.</translation>
    </message>
    <message>
        <source>Inserts what the clipboard holds.</source>
        <translation>Вставляет содержимое буфера обмена.</translation>
    </message>
    <message>
        <source>Layout &amp;Analyse</source>
        <translation>Раскладка «&amp;Анализ»</translation>
    </message>
    <message>
        <source>Layout &amp;Configure</source>
        <translation>Раскладка «&amp;Настройка»</translation>
    </message>
    <message>
        <source>Layout &amp;Program</source>
        <translation>Раскладка «&amp;Программа»</translation>
    </message>
    <message>
        <source>Layout C&amp;ommission</source>
        <translation>Раскладка «На&amp;ладка»</translation>
    </message>
    <message>
        <source>Lists what may be typed here.</source>
        <translation>Показывает, что можно здесь написать.</translation>
    </message>
    <message>
        <source>Lists where the symbol is used.</source>
        <translation>Перечисляет места, где используется символ.</translation>
    </message>
    <message>
        <source>Makes a project for a controller family and model.</source>
        <translation>Создаёт проект для семейства и модели контроллера.</translation>
    </message>
    <message>
        <source>Move Tab &amp;Left</source>
        <translation>Вкладку в&amp;лево</translation>
    </message>
    <message>
        <source>Move Tab Ri&amp;ght</source>
        <translation>Вкладку в&amp;право</translation>
    </message>
    <message>
        <source>Moves the current tab into a window of its own, or back into the main window.</source>
        <translation>Переносит текущую вкладку в отдельное окно или обратно в главное.</translation>
    </message>
    <message>
        <source>Moves the current tab one place to the left.</source>
        <translation>Сдвигает текущую вкладку на одно место влево.</translation>
    </message>
    <message>
        <source>Moves the current tab one place to the right.</source>
        <translation>Сдвигает текущую вкладку на одно место вправо.</translation>
    </message>
    <message>
        <source>Moves the current tab to the next group of tabs, in whichever window it is.</source>
        <translation>Переносит текущую вкладку в следующую группу, в каком бы окне она ни была.</translation>
    </message>
    <message>
        <source>Moves the selection to the clipboard.</source>
        <translation>Переносит выделенное в буфер обмена.</translation>
    </message>
    <message>
        <source>Next &amp;Group</source>
        <translation>Следующая &amp;группа</translation>
    </message>
    <message>
        <source>Next &amp;Tab</source>
        <translation>Следующая &amp;вкладка</translation>
    </message>
    <message>
        <source>Offers ways out of the problem under the cursor.</source>
        <translation>Предлагает способы решить проблему под курсором.</translation>
    </message>
    <message>
        <source>Open the &amp;Demo Machine</source>
        <translation>Открыть &amp;демомашину</translation>
    </message>
    <message>
        <source>Opens a machine with two simulated axes and connects to its virtual controller.</source>
        <translation>Открывает машину с двумя моделируемыми осями и подключается к её виртуальному контроллеру.</translation>
    </message>
    <message>
        <source>Opens a project folder.</source>
        <translation>Открывает папку проекта.</translation>
    </message>
    <message>
        <source>Previous Gro&amp;up</source>
        <translation>Предыдущая г&amp;руппа</translation>
    </message>
    <message>
        <source>Previous Ta&amp;b</source>
        <translation>Предыдущая в&amp;кладка</translation>
    </message>
    <message>
        <source>Project &amp;Tree</source>
        <translation>&amp;Дерево проекта</translation>
    </message>
    <message>
        <source>Puts every dock back to where it was at first.</source>
        <translation>Возвращает все панели на исходные места.</translation>
    </message>
    <message>
        <source>Puts the current tab into a group of its own at the right.</source>
        <translation>Помещает текущую вкладку в отдельную группу справа.</translation>
    </message>
    <message>
        <source>Puts the current tab into a group of its own below.</source>
        <translation>Помещает текущую вкладку в отдельную группу снизу.</translation>
    </message>
    <message>
        <source>Puts the selected lines into comments, or takes them out.</source>
        <translation>Превращает выделенные строки в комментарии или обратно.</translation>
    </message>
    <message>
        <source>R&amp;eplace...</source>
        <translation>&amp;Заменить...</translation>
    </message>
    <message>
        <source>Re&amp;name</source>
        <translation>Пере&amp;именовать</translation>
    </message>
    <message>
        <source>Reads the project&apos;s files again; can be undone.</source>
        <translation>Читает файлы проекта заново; это можно отменить.</translation>
    </message>
    <message>
        <source>Release &amp;All Forces</source>
        <translation>Снять всё &amp;форсирование</translation>
    </message>
    <message>
        <source>Renames the object or symbol.</source>
        <translation>Переименовывает объект или символ.</translation>
    </message>
    <message>
        <source>Replaces this program by the text of a KincoBuilder .ilp file.</source>
        <translation>Заменяет эту программу текстом файла .ilp из KincoBuilder.</translation>
    </message>
    <message>
        <source>Save &amp;As...</source>
        <translation>Сохранить &amp;как...</translation>
    </message>
    <message>
        <source>Se&amp;ttings...</source>
        <translation>Настро&amp;йки...</translation>
    </message>
    <message>
        <source>Select &amp;All</source>
        <translation>Выделить в&amp;сё</translation>
    </message>
    <message>
        <source>Selects everything in the view.</source>
        <translation>Выделяет всё в этом виде.</translation>
    </message>
    <message>
        <source>Shows or hides the dock at the bottom.</source>
        <translation>Показывает или скрывает нижнюю панель.</translation>
    </message>
    <message>
        <source>Shows or hides the dock at the right.</source>
        <translation>Показывает или скрывает правую панель.</translation>
    </message>
    <message>
        <source>Shows or hides the project tree.</source>
        <translation>Показывает или скрывает дерево проекта.</translation>
    </message>
    <message>
        <source>Shows the next problem at its place.</source>
        <translation>Показывает следующую проблему на её месте.</translation>
    </message>
    <message>
        <source>Shows the next tab of the group.</source>
        <translation>Показывает следующую вкладку группы.</translation>
    </message>
    <message>
        <source>Shows the page about the selected message: an example and the way out. F1 in the list does the same.</source>
        <translation>Показывает страницу о выбранном сообщении: пример и как исправить. В списке то же делает F1.</translation>
    </message>
    <message>
        <source>Shows the pages that come with Camwright.</source>
        <translation>Показывает страницы, которые поставляются с Camwright.</translation>
    </message>
    <message>
        <source>Shows the previous problem at its place.</source>
        <translation>Показывает предыдущую проблему на её месте.</translation>
    </message>
    <message>
        <source>Shows the previous tab of the group.</source>
        <translation>Показывает предыдущую вкладку группы.</translation>
    </message>
    <message>
        <source>Shows what changes, then replaces the controller&apos;s program.</source>
        <translation>Показывает, что изменится, затем заменяет программу контроллера.</translation>
    </message>
    <message>
        <source>Split Do&amp;wn</source>
        <translation>Разделить в&amp;низ</translation>
    </message>
    <message>
        <source>Split R&amp;ight</source>
        <translation>Разделить впр&amp;аво</translation>
    </message>
    <message>
        <source>Starts the controller&apos;s program.</source>
        <translation>Запускает программу контроллера.</translation>
    </message>
    <message>
        <source>Stop All A&amp;xes</source>
        <translation>Остановить все ос&amp;и</translation>
    </message>
    <message>
        <source>Stops all axes, then the program.</source>
        <translation>Останавливает все оси, затем программу.</translation>
    </message>
    <message>
        <source>Stops every axis at once; needs no control.</source>
        <translation>Останавливает сразу все оси; управление для этого не нужно.</translation>
    </message>
    <message>
        <source>Switches between light and dark.</source>
        <translation>Переключает светлую и тёмную тему.</translation>
    </message>
    <message>
        <source>Tab in Its &amp;Own Window</source>
        <translation>Вкладка в отдельном &amp;окне</translation>
    </message>
    <message>
        <source>Takes back the project&apos;s last step, in whichever editor it was.</source>
        <translation>Отменяет последний шаг проекта, в каком бы редакторе он ни был сделан.</translation>
    </message>
    <message>
        <source>The oscilloscope, large.</source>
        <translation>Осциллограф во весь размер.</translation>
    </message>
    <message>
        <source>Theme, language and keys.</source>
        <translation>Тема, язык и клавиши.</translation>
    </message>
    <message>
        <source>Tree, editor and properties.</source>
        <translation>Дерево, редактор и свойства.</translation>
    </message>
    <message>
        <source>Tree, program, instructions and watch.</source>
        <translation>Дерево, программа, инструкции и наблюдение.</translation>
    </message>
    <message>
        <source>Version and licence.</source>
        <translation>Версия и лицензия.</translation>
    </message>
    <message>
        <source>Writes all edits to the project&apos;s folder.</source>
        <translation>Записывает все правки в папку проекта.</translation>
    </message>
    <message>
        <source>Writes the project into another folder and goes on there.</source>
        <translation>Записывает проект в другую папку и продолжает работу в ней.</translation>
    </message>
</context>
<context>
    <name>Arguments</name>
    <message>
        <source>SDO protocol timed out</source>
        <translation>истёк тайм-аут протокола SDO</translation>
    </message>
    <message>
        <source>a broken list</source>
        <translation>список испорчен</translation>
    </message>
    <message>
        <source>a broken number</source>
        <translation>число испорчено</translation>
    </message>
    <message>
        <source>a broken text</source>
        <translation>текст испорчен</translation>
    </message>
    <message>
        <source>a broken value</source>
        <translation>значение испорчено</translation>
    </message>
    <message>
        <source>a client</source>
        <translation>клиент</translation>
    </message>
    <message>
        <source>a constant</source>
        <translation>константа</translation>
    </message>
    <message>
        <source>a digest that has neither 0 nor 32 bytes</source>
        <translation>хеш длиной не 0 и не 32 байта</translation>
    </message>
    <message>
        <source>a function block that can be extended</source>
        <translation>функциональный блок, который можно расширить</translation>
    </message>
    <message>
        <source>a global variable</source>
        <translation>глобальная переменная</translation>
    </message>
    <message>
        <source>a label of the CASE</source>
        <translation>метка CASE</translation>
    </message>
    <message>
        <source>a message before the handshake was done</source>
        <translation>сообщение до окончания приветствия</translation>
    </message>
    <message>
        <source>a name</source>
        <translation>имя</translation>
    </message>
    <message>
        <source>a negative scan period or watchdog time</source>
        <translation>период сканирования или время сторожевого таймера отрицательны</translation>
    </message>
    <message>
        <source>a program</source>
        <translation>программа</translation>
    </message>
    <message>
        <source>a real number</source>
        <translation>действительное число</translation>
    </message>
    <message>
        <source>a reference</source>
        <translation>ссылка</translation>
    </message>
    <message>
        <source>a routine has no name, or two have the same</source>
        <translation>у подпрограммы нет имени, или имя занято дважды</translation>
    </message>
    <message>
        <source>a second hello</source>
        <translation>второе приветствие</translation>
    </message>
    <message>
        <source>a statement</source>
        <translation>оператор</translation>
    </message>
    <message>
        <source>a string</source>
        <translation>строка</translation>
    </message>
    <message>
        <source>a text that is longer than the message</source>
        <translation>текст длиннее сообщения</translation>
    </message>
    <message>
        <source>a text that is no UTF-8</source>
        <translation>текст не в UTF-8</translation>
    </message>
    <message>
        <source>a type</source>
        <translation>тип</translation>
    </message>
    <message>
        <source>a value nobody asked for</source>
        <translation>значение, которого никто не запрашивал</translation>
    </message>
    <message>
        <source>a value wider than its type</source>
        <translation>значение шире своего типа</translation>
    </message>
    <message>
        <source>a variable without an address</source>
        <translation>переменная без адреса</translation>
    </message>
    <message>
        <source>a whole number</source>
        <translation>целое число</translation>
    </message>
    <message>
        <source>a whole-number type</source>
        <translation>целый тип</translation>
    </message>
    <message>
        <source>a wrong answer to piece</source>
        <translation>неверный ответ на часть загрузки</translation>
    </message>
    <message>
        <source>access failed due to a hardware error</source>
        <translation>не удалось обратиться из-за аппаратной ошибки</translation>
    </message>
    <message>
        <source>an address</source>
        <translation>адрес</translation>
    </message>
    <message>
        <source>an array</source>
        <translation>массив</translation>
    </message>
    <message>
        <source>an expression</source>
        <translation>выражение</translation>
    </message>
    <message>
        <source>an initial value lies outside its area</source>
        <translation>начальное значение лежит вне своей области</translation>
    </message>
    <message>
        <source>an input</source>
        <translation>вход</translation>
    </message>
    <message>
        <source>an interface</source>
        <translation>интерфейс</translation>
    </message>
    <message>
        <source>an output</source>
        <translation>выход</translation>
    </message>
    <message>
        <source>another number of types than was asked for</source>
        <translation>типов не столько, сколько запрошено</translation>
    </message>
    <message>
        <source>any finite number</source>
        <translation>любое конечное число</translation>
    </message>
    <message>
        <source>attempt to read a write-only object</source>
        <translation>попытка прочитать объект, доступный только для записи</translation>
    </message>
    <message>
        <source>attempt to write a read-only object</source>
        <translation>попытка записать в объект, доступный только для чтения</translation>
    </message>
    <message>
        <source>both stored sets are damaged</source>
        <translation>оба сохранённых набора повреждены</translation>
    </message>
    <message>
        <source>broken bytes</source>
        <translation>байты испорчены</translation>
    </message>
    <message>
        <source>bytes that are longer than the message</source>
        <translation>байтов больше, чем в сообщении</translation>
    </message>
    <message>
        <source>command specifier not valid or unknown</source>
        <translation>код команды неверен или неизвестен</translation>
    </message>
    <message>
        <source>commanded velocity</source>
        <translation>заданная скорость</translation>
    </message>
    <message>
        <source>data cannot be stored because of local control</source>
        <translation>данные нельзя сохранить из-за местного управления</translation>
    </message>
    <message>
        <source>data cannot be stored in the present device state</source>
        <translation>данные нельзя сохранить в нынешнем состоянии устройства</translation>
    </message>
    <message>
        <source>data cannot be transferred or stored</source>
        <translation>данные нельзя передать или сохранить</translation>
    </message>
    <message>
        <source>fewer values than were asked for</source>
        <translation>значений меньше, чем запрошено</translation>
    </message>
    <message>
        <source>general error</source>
        <translation>общая ошибка</translation>
    </message>
    <message>
        <source>general parameter incompatibility</source>
        <translation>общая несовместимость параметров</translation>
    </message>
    <message>
        <source>it left no message</source>
        <translation>сообщения не осталось</translation>
    </message>
    <message>
        <source>its digest does not fit</source>
        <translation>хеш не сходится</translation>
    </message>
    <message>
        <source>length of the parameter does not match</source>
        <translation>длина параметра не подходит</translation>
    </message>
    <message>
        <source>maximum is less than minimum</source>
        <translation>максимум меньше минимума</translation>
    </message>
    <message>
        <source>more parts</source>
        <translation>больше частей</translation>
    </message>
    <message>
        <source>more than a message</source>
        <translation>больше одного сообщения</translation>
    </message>
    <message>
        <source>no abort</source>
        <translation>отказа нет</translation>
    </message>
    <message>
        <source>no answer within 5 s</source>
        <translation>нет ответа за 5 с</translation>
    </message>
    <message>
        <source>no authentication</source>
        <translation>нет проверки подлинности</translation>
    </message>
    <message>
        <source>no bytes of known length where they are due</source>
        <translation>нет байтов известной длины там, где они должны быть</translation>
    </message>
    <message>
        <source>no list of the right length where one is due</source>
        <translation>нет списка нужной длины там, где он должен быть</translation>
    </message>
    <message>
        <source>no program</source>
        <translation>пустой памятью программ</translation>
    </message>
    <message>
        <source>no text of known length where one is due</source>
        <translation>нет текста известной длины там, где он должен быть</translation>
    </message>
    <message>
        <source>no true or false where one is due</source>
        <translation>нет логического значения там, где оно должно быть</translation>
    </message>
    <message>
        <source>no welcome</source>
        <translation>нет ответного приветствия</translation>
    </message>
    <message>
        <source>nothing</source>
        <translation>ничего</translation>
    </message>
    <message>
        <source>nothing came for %1 s</source>
        <translation>ничего не приходило %1 с</translation>
    </message>
    <message>
        <source>number and length of the mapped objects exceed the PDO</source>
        <translation>число и длина отображённых объектов превышают размер PDO</translation>
    </message>
    <message>
        <source>object cannot be mapped to the PDO</source>
        <translation>объект нельзя отобразить в PDO</translation>
    </message>
    <message>
        <source>object does not exist in the object dictionary</source>
        <translation>такого объекта нет в словаре объектов</translation>
    </message>
    <message>
        <source>out of memory</source>
        <translation>не хватает памяти</translation>
    </message>
    <message>
        <source>parameter is too long</source>
        <translation>параметр слишком длинный</translation>
    </message>
    <message>
        <source>parameter is too short</source>
        <translation>параметр слишком короткий</translation>
    </message>
    <message>
        <source>samples that are no multiple of 8 bytes</source>
        <translation>отсчёты не кратны 8 байтам</translation>
    </message>
    <message>
        <source>sub-index does not exist</source>
        <translation>такого подындекса нет</translation>
    </message>
    <message>
        <source>target position</source>
        <translation>заданное положение</translation>
    </message>
    <message>
        <source>the axes are not in order</source>
        <translation>оси идут не по порядку</translation>
    </message>
    <message>
        <source>the counter of a loop around it</source>
        <translation>счётчик внешнего цикла</translation>
    </message>
    <message>
        <source>the end of the text</source>
        <translation>конец текста</translation>
    </message>
    <message>
        <source>the flag of failed instructions lies outside its area</source>
        <translation>признак неудачной инструкции лежит вне своей области</translation>
    </message>
    <message>
        <source>the folder cannot be made</source>
        <translation>папку не удаётся создать</translation>
    </message>
    <message>
        <source>the memory areas are not in order</source>
        <translation>области памяти идут не по порядку</translation>
    </message>
    <message>
        <source>the memory areas are too large</source>
        <translation>области памяти слишком велики</translation>
    </message>
    <message>
        <source>the other side closed it</source>
        <translation>другая сторона закрыла соединение</translation>
    </message>
    <message>
        <source>the program before it</source>
        <translation>прежней программой</translation>
    </message>
    <message>
        <source>the record is damaged</source>
        <translation>запись повреждена</translation>
    </message>
    <message>
        <source>the record of the stored program is damaged</source>
        <translation>запись о сохранённой программе повреждена</translation>
    </message>
    <message>
        <source>the retained range of an area lies outside it</source>
        <translation>сохраняемая часть области выходит за её пределы</translation>
    </message>
    <message>
        <source>the stored program is damaged</source>
        <translation>сохранённая программа повреждена</translation>
    </message>
    <message>
        <source>the variables are not in order</source>
        <translation>переменные идут не по порядку</translation>
    </message>
    <message>
        <source>there is no private folder for its socket</source>
        <translation>нет личной папки для его сокета</translation>
    </message>
    <message>
        <source>toggle bit not alternated</source>
        <translation>бит чередования не сменился</translation>
    </message>
    <message>
        <source>unknown reason</source>
        <translation>причина неизвестна</translation>
    </message>
    <message>
        <source>unsupported access to an object</source>
        <translation>обращение к объекту не поддерживается</translation>
    </message>
    <message>
        <source>value outside the permitted range</source>
        <translation>значение вне допустимого диапазона</translation>
    </message>
    <message>
        <source>value too high</source>
        <translation>значение слишком велико</translation>
    </message>
    <message>
        <source>value too low</source>
        <translation>значение слишком мало</translation>
    </message>
</context>
<context>
    <name>AxisCause</name>
    <message>
        <source>alarm of the drive</source>
        <translation>авария привода</translation>
    </message>
    <message>
        <source>enabled by a panel</source>
        <translation>включена панелью</translation>
    </message>
    <message>
        <source>motion ended</source>
        <translation>движение закончено</translation>
    </message>
    <message>
        <source>motion of a panel</source>
        <translation>движение с панели</translation>
    </message>
    <message>
        <source>motion of the program</source>
        <translation>движение от программы</translation>
    </message>
    <message>
        <source>no longer on the bus</source>
        <translation>больше не на шине</translation>
    </message>
    <message>
        <source>node restarted</source>
        <translation>узел перезапущен</translation>
    </message>
    <message>
        <source>powered by the program</source>
        <translation>включена программой</translation>
    </message>
    <message>
        <source>released by a panel</source>
        <translation>отпущена панелью</translation>
    </message>
    <message>
        <source>released by the program</source>
        <translation>отпущена программой</translation>
    </message>
    <message>
        <source>reset</source>
        <translation>сброс</translation>
    </message>
    <message>
        <source>stopped and released</source>
        <translation>остановлена и отпущена</translation>
    </message>
    <message>
        <source>stopped by command</source>
        <translation>остановлена по команде</translation>
    </message>
    <message>
        <source>stopped: no heartbeat from the panel</source>
        <translation>остановлена: нет сигнала присутствия от панели</translation>
    </message>
</context>
<context>
    <name>AxisError</name>
    <message>
        <source>alarm of the drive; its manual explains the code</source>
        <translation>авария привода; код объяснён в его руководстве</translation>
    </message>
    <message>
        <source>brake, motor or another module of the drive</source>
        <translation>тормоз, двигатель или другой модуль привода</translation>
    </message>
    <message>
        <source>communication</source>
        <translation>связь</translation>
    </message>
    <message>
        <source>current</source>
        <translation>ток</translation>
    </message>
    <message>
        <source>current too high at the output of the drive</source>
        <translation>слишком большой ток на выходе привода</translation>
    </message>
    <message>
        <source>encoder</source>
        <translation>энкодер</translation>
    </message>
    <message>
        <source>following error too large</source>
        <translation>слишком большая ошибка слежения</translation>
    </message>
    <message>
        <source>general error of the drive</source>
        <translation>общая ошибка привода</translation>
    </message>
    <message>
        <source>hardware of the drive</source>
        <translation>аппаратная часть привода</translation>
    </message>
    <message>
        <source>position control</source>
        <translation>регулирование положения</translation>
    </message>
    <message>
        <source>software of the drive</source>
        <translation>программное обеспечение привода</translation>
    </message>
    <message>
        <source>supervision</source>
        <translation>контроль</translation>
    </message>
    <message>
        <source>temperature</source>
        <translation>температура</translation>
    </message>
    <message>
        <source>the drive no longer answers on the bus</source>
        <translation>привод больше не отвечает на шине</translation>
    </message>
    <message>
        <source>voltage</source>
        <translation>напряжение</translation>
    </message>
</context>
<context>
    <name>Commands</name>
    <message>
        <source>Add &quot;%1&quot;</source>
        <translation>Добавить «%1»</translation>
    </message>
    <message>
        <source>Delete &quot;%1&quot;</source>
        <translation>Удалить «%1»</translation>
    </message>
    <message numerus="yes">
        <source>Delete %n objects</source>
        <translation>
            <numerusform>Удалить %n объект</numerusform>
            <numerusform>Удалить %n объекта</numerusform>
            <numerusform>Удалить %n объектов</numerusform>
        </translation>
    </message>
    <message>
        <source>Edit program &quot;%1&quot;</source>
        <translation>Правка программы «%1»</translation>
    </message>
    <message>
        <source>Rename &quot;%1&quot; to &quot;%2&quot;</source>
        <translation>Переименовать «%1» в «%2»</translation>
    </message>
</context>
<context>
    <name>Commissioning</name>
    <message>
        <source>mm</source>
        <translation>мм</translation>
    </message>
    <message>
        <source>°</source>
        <translation>°</translation>
    </message>
</context>
<context>
    <name>Diagnostics</name>
    <message>
        <source>&quot;%1&quot; already holds a project. Choose another folder.</source>
        <translation>В «%1» уже есть проект. Выберите другую папку.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; and &quot;%2&quot; are both main programs. Only one may be; make the other a subroutine.</source>
        <translation>«%1» и «%2» — обе главные программы. Допустима только одна; сделайте другую подпрограммой.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; and &quot;%2&quot; both hold the object &quot;%3&quot;. Remove or rename one of them.</source>
        <translation>И «%1», и «%2» содержат объект «%3». Удалите или переименуйте один из них.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; and &quot;%2&quot; lie on the same memory at %3.</source>
        <translation>«%1» и «%2» лежат в одной и той же памяти по адресу %3.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; asks for %2 at once; the limit is %3.</source>
        <translation>«%1» запрашивает сразу %2; предел — %3.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; becomes a retained value.</source>
        <translation>«%1» становится сохраняемым значением.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; cannot be a subscript. A subscript is a number, an INT or DINT variable, or an element of an array with a number.</source>
        <translation>«%1» не может быть индексом. Индекс — число, переменная INT или DINT или элемент массива с числом.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; cannot be used as %2. It can be %3.</source>
        <translation>«%1» нельзя использовать как %2. Можно как %3.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; cannot be used as a name. A name begins with a letter, goes on with letters, digits or _, and is not an address, a type or an instruction.</source>
        <translation>«%1» нельзя использовать как имя. Имя начинается с буквы, далее буквы, цифры или _, и оно не совпадает с адресом, типом или инструкцией.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; cannot be written: %2. The old program is untouched.</source>
        <translation>«%1» не удаётся записать: %2. Старая программа не тронута.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; does not declare a parameter. Write it like %2.</source>
        <translation>«%1» не объявляет параметр. Запишите так: %2.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; has a foreign word inside an address. Write %2.</source>
        <translation>В «%1» внутри адреса постороннее слово. Пишите %2.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; has a letter that only looks Latin (%2). Write %3.</source>
        <translation>В «%1» есть буква, лишь похожая на латинскую (%2). Пишите %3.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; has blanks inside. Write %2.</source>
        <translation>В «%1» есть пробелы. Пишите %2.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; has the backslashes of a Markdown document. Write %2.</source>
        <translation>В «%1» обратные косые черты из документа Markdown. Пишите %2.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; has the digit %2, but these numbers are octal: use the digits 0 to 7.</source>
        <translation>В «%1» есть цифра %2, но эти номера восьмеричные: используйте цифры от 0 до 7.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; holds the character &quot;%2&quot;, which no address has. Type Latin letters and digits without blanks.</source>
        <translation>В «%1» есть символ «%2», которого в адресах не бывает. Пишите латинские буквы и цифры без пробелов.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is larger than %2 bytes. No file of a project may be that large.</source>
        <translation>«%1» больше %2 байт. Файл проекта не может быть таким большим.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is marked as retained, but its address %2 is not kept at power-off. Whether a value is kept depends on its address.</source>
        <translation>«%1» помечена как сохраняемая, но её адрес %2 не сохраняется при отключении питания. Сохранение зависит от адреса.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is neither an address, a constant, nor the name of a variable.</source>
        <translation>«%1» — не адрес, не константа и не имя переменной.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is neither the number nor the name of an axis.</source>
        <translation>«%1» — не номер и не имя оси.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is no role of a program. The roles are %2.</source>
        <translation>«%1» не является ролью программы. Роли: %2.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is not a Camwright project: it holds no file project.toml.</source>
        <translation>«%1» не является проектом Camwright: в нём нет файла project.toml.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is not a character of a string. Write $$, $&apos;, $L, $N, $P, $R, $T, or $ and two hexadecimal digits.</source>
        <translation>«%1» не знак строки. Пишите $$, $&apos;, $L, $N, $P, $R, $T или $ и две шестнадцатеричные цифры.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is not a complete address. Write it like &quot;%2&quot;.</source>
        <translation>«%1» — неполный адрес. Пишите так: «%2».</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is not a constant of type %2. Write it like %3.</source>
        <translation>«%1» не является константой типа %2. Пишите так: %3.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is not a date or a time of day. Write it like %2, with a year from 1970 to 2261.</source>
        <translation>«%1» не дата и не время суток. Пишите, например, %2, год от 1970 до 2261.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is not a duration. Write it like %2: from days to nanoseconds (d, h, m, s, ms, us, ns).</source>
        <translation>«%1» не длительность. Пишите, например, %2: от дней до наносекунд (d, h, m, s, ms, us, ns).</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is not a form of area %2. Its forms are %3.</source>
        <translation>«%1» не является формой области %2. Её формы: %3.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is not a name. A name has letters A to Z, digits and single underscores between them, at most %2.</source>
        <translation>«%1» не имя. В имени буквы A–Z, цифры и одиночные подчёркивания между ними, не более %2.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is not a number, as %2 has to be.</source>
        <translation>«%1» не число, а %2 должно быть числом.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is not a number. Write it like %2.</source>
        <translation>«%1» не число. Пишите, например, %2.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is not a value of type %2. Write it like %3.</source>
        <translation>«%1» не является значением типа %2. Пишите так: %3.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is not a whole number, as %2 has to be.</source>
        <translation>«%1» не целое число, а %2 должно быть целым.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is not an address.</source>
        <translation>«%1» не адрес.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is not an event that starts an interrupt routine. Write it like %2.</source>
        <translation>«%1» — не событие, запускающее подпрограмму прерывания. Запишите так: %2.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is not an instruction and not a comment. Remove it, or write it as (* %1 *).</source>
        <translation>«%1» не инструкция и не комментарий. Удалите это или напишите как (* %1 *).</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is not an instruction of %2.</source>
        <translation>«%1» не является инструкцией %2.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is not an instruction of %2. Did you mean %3?</source>
        <translation>«%1» не является инструкцией %2. Возможно, имелась в виду %3?</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is not an operand. An operand is an address such as %2, a constant, or a name.</source>
        <translation>«%1» не операнд. Операнд — это адрес, например %2, константа или имя.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is not legal in column &quot;%2&quot;. Legal is: %3.</source>
        <translation>«%1» недопустимо в столбце «%2». Допустимо: %3.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is not one of the values of %2, which are %3.</source>
        <translation>«%1» не входит в значения %2. Допустимы: %3.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is not the address of a controller. Write local or tcp://HOST[:PORT].</source>
        <translation>«%1» — не адрес контроллера. Пишите local или tcp://HOST[:PORT].</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is not the name of a file of a project. Give it a name without %, or remove it from the project&apos;s folder.</source>
        <translation>«%1» не является именем файла проекта. Дайте ему имя без % или уберите его из папки проекта.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is not there.</source>
        <translation>«%1» не найден.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is to be a list in square brackets.</source>
        <translation>«%1» должно быть списком в квадратных скобках.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is to be a single value, not a list or a table.</source>
        <translation>«%1» должно быть одиночным значением, а не списком или таблицей.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is to be a table of keys and values.</source>
        <translation>«%1» должно быть таблицей ключей и значений.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is to be a text in quotation marks.</source>
        <translation>«%1» должно быть текстом в кавычках.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is to be a whole number.</source>
        <translation>«%1» должно быть целым числом.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; lies outside its memory area. On %2 the legal range is %3 to %4.</source>
        <translation>«%1» вне своей области памяти. Для %2 допустимо от %3 до %4.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; looks like several operands. Separate them by commas: %2.</source>
        <translation>«%1» похоже на несколько операндов. Разделите их запятыми: %2.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; mixes Latin letters with letters of another alphabet that look alike. Whoever types the name may not find it.</source>
        <translation>В «%1» латинские буквы смешаны с похожими буквами другого алфавита. Кто наберёт это имя, может его не найти.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; names bit %2. The bits are 0 to %3.</source>
        <translation>«%1» называет бит %2. Биты имеют номера от 0 до %3.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; names no memory area of %2. The areas are %3.</source>
        <translation>«%1» не называет области памяти %2. Области: %3.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; needs control. Take control first.</source>
        <translation>Для «%1» нужно управление. Сначала возьмите управление.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; needs more rights than this connection has.</source>
        <translation>Для «%1» нужно больше прав, чем у этого соединения.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; stands twice in column &quot;%2&quot;.</source>
        <translation>«%1» стоит в столбце «%2» дважды.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; starts at an odd byte. Words, double words and reals start at an even one: use &quot;%2&quot; or &quot;%3&quot;.</source>
        <translation>«%1» начинается с нечётного байта. Слова, двойные слова и вещественные начинаются с чётного: используйте «%2» или «%3».</translation>
    </message>
    <message>
        <source>%1 belongs to nothing that is open here. Remove it, or write what it ends.</source>
        <translation>%1 здесь ничего не закрывает. Удалите слово или напишите то, что им заканчивается.</translation>
    </message>
    <message>
        <source>%1 bit/s is not a baud rate of the network. Choose one of %2.</source>
        <translation>%1 бит/с не является скоростью этой сети. Выберите одну из: %2.</translation>
    </message>
    <message>
        <source>%1 calls itself, directly or through others. Write a loop instead.</source>
        <translation>%1 вызывает себя, прямо или через других. Напишите цикл.</translation>
    </message>
    <message>
        <source>%1 cannot be called.</source>
        <translation>%1 нельзя вызвать.</translation>
    </message>
    <message>
        <source>%1 cannot be compiled by this version of Camwright. See the page of Structured Text for what can be.</source>
        <translation>Эта версия Camwright не компилирует %1. Что компилируется, сказано на странице о структурированном тексте.</translation>
    </message>
    <message>
        <source>%1 cannot be the operand %2 of %3. The memory areas allowed are %4.</source>
        <translation>%1 не может быть операндом %2 инструкции %3. Допустимые области памяти: %4.</translation>
    </message>
    <message>
        <source>%1 cannot be the place of a variable of type %2 on this controller.</source>
        <translation>%1 не может быть местом переменной типа %2 на этом контроллере.</translation>
    </message>
    <message>
        <source>%1 cannot be written here, it is %2.</source>
        <translation>%1 здесь нельзя записать, это %2.</translation>
    </message>
    <message>
        <source>%1 cannot stand here.</source>
        <translation>%1 не может здесь стоять.</translation>
    </message>
    <message>
        <source>%1 clients are connected already; no more are taken.</source>
        <translation>Клиентов уже подключено: %1; больше не принимается.</translation>
    </message>
    <message>
        <source>%1 connected.</source>
        <translation>%1: подключение установлено.</translation>
    </message>
    <message>
        <source>%1 contains itself. Break the circle, for instance with REF_TO.</source>
        <translation>%1 содержит само себя. Разорвите круг, например с помощью REF_TO.</translation>
    </message>
    <message>
        <source>%1 disconnected.</source>
        <translation>%1: подключение закончено.</translation>
    </message>
    <message>
        <source>%1 does not belong here. SBR is the first instruction of a program of the role subroutine, RT and RTC stand in one.</source>
        <translation>%1 здесь не на месте. SBR — первая команда программы с ролью подпрограммы, RT и RTC стоят в такой программе.</translation>
    </message>
    <message>
        <source>%1 does not exist for %2 and %3.</source>
        <translation>%1 не существует для %2 и %3.</translation>
    </message>
    <message>
        <source>%1 does not exist for %2.</source>
        <translation>%1 не существует для %2.</translation>
    </message>
    <message>
        <source>%1 has control. It is free as soon as they release it or their connection ends.</source>
        <translation>Управление у %1. Оно освободится, как только его отпустят или соединение закончится.</translation>
    </message>
    <message>
        <source>%1 has no effect on the virtual controller, which does not imitate it yet. On the real controller it runs.</source>
        <translation>%1 не действует на виртуальном контроллере, который её пока не воспроизводит. На настоящем контроллере она работает.</translation>
    </message>
    <message>
        <source>%1 has no effect on the virtual controller: pulse outputs are not simulated yet. On the real controller it runs.</source>
        <translation>%1 не действует на виртуальном контроллере: импульсные выходы пока не моделируются. На настоящем контроллере она работает.</translation>
    </message>
    <message>
        <source>%1 has no letter in front. Write K%1 for a number, or O%1 for an octal address.</source>
        <translation>Перед %1 нет буквы. Напишите K%1 для числа или O%1 для восьмеричного адреса.</translation>
    </message>
    <message>
        <source>%1 has no member %2.</source>
        <translation>У %1 нет элемента %2.</translation>
    </message>
    <message>
        <source>%1 has no operand named %2. Its operands are %3.</source>
        <translation>У %1 нет операнда с именем %2. Её операнды: %3.</translation>
    </message>
    <message>
        <source>%1 has no parameter %2.</source>
        <translation>У %1 нет параметра %2.</translation>
    </message>
    <message>
        <source>%1 has no parameters. Write the call without further operands.</source>
        <translation>У %1 нет параметров. Запишите вызов без других операндов.</translation>
    </message>
    <message>
        <source>%1 has no power flow in front of it. A rung begins with %2.</source>
        <translation>Перед %1 нет логического потока. Цепь начинается с %2.</translation>
    </message>
    <message>
        <source>%1 implements %2 and has no method %3. Write it with the same parameters.</source>
        <translation>%1 реализует %2, но не имеет метода %3. Напишите его с теми же параметрами.</translation>
    </message>
    <message>
        <source>%1 is %2 and %3 is %4. The operands of %5 have one common type.</source>
        <translation>%1 имеет тип %2, а %3 — %4. Тип операндов %5 общий.</translation>
    </message>
    <message>
        <source>%1 is %2. The operand %3 of %4 is %5.</source>
        <translation>%1 имеет тип %2. Тип операнда %3 инструкции %4 — %5.</translation>
    </message>
    <message>
        <source>%1 is a constant, and %3 writes its result into the operand %2. Write an address.</source>
        <translation>%1 — константа, а %3 записывает результат в операнд %2. Напишите адрес.</translation>
    </message>
    <message>
        <source>%1 is a word of the language and cannot be a name. Choose another name.</source>
        <translation>%1 — слово языка и не может быть именем. Выберите другое имя.</translation>
    </message>
    <message>
        <source>%1 is an array. Write which element is meant, like %1[0].</source>
        <translation>%1 — массив. Напишите, какой элемент нужен, например %1[0].</translation>
    </message>
    <message>
        <source>%1 is an extension of Camwright and strict Kinco is set. Write the group to a marker bit in a network of its own, and use the bit here.</source>
        <translation>%1 — расширение Camwright, а включён строгий режим Kinco. Запишите группу в бит-маркер в отдельной сети и используйте здесь этот бит.</translation>
    </message>
    <message>
        <source>%1 is declared already. Choose another name.</source>
        <translation>%1 уже объявлено. Выберите другое имя.</translation>
    </message>
    <message>
        <source>%1 is given twice.</source>
        <translation>%1 дано дважды.</translation>
    </message>
    <message>
        <source>%1 is missing here.</source>
        <translation>Здесь не хватает %1.</translation>
    </message>
    <message>
        <source>%1 is needed here, and this is %2.</source>
        <translation>Здесь нужен %1, а это %2.</translation>
    </message>
    <message>
        <source>%1 is needed here, and this is %2. Convert it with %3.</source>
        <translation>Здесь нужен %1, а это %2. Преобразуйте с помощью %3.</translation>
    </message>
    <message>
        <source>%1 is no usable %2 for axis &quot;%3&quot;.</source>
        <translation>%1 не годится как %2 для оси «%3».</translation>
    </message>
    <message>
        <source>%1 is not %2.</source>
        <translation>%1 — это не %2.</translation>
    </message>
    <message>
        <source>%1 is not a communication cycle. It is 1000 to 8000 microseconds, in BCD.</source>
        <translation>%1 — не цикл связи. Он от 1000 до 8000 микросекунд, в коде BCD.</translation>
    </message>
    <message>
        <source>%1 is not a decimal number, and the operand %2 counts in BCD. Write decimal digits behind the K.</source>
        <translation>%1 — не десятичное число, а операнд %2 считает в коде BCD. Напишите после K десятичные цифры.</translation>
    </message>
    <message>
        <source>%1 is not a number of stations. A module takes 1 to 15, in BCD.</source>
        <translation>%1 — не число станций. Модуль берёт от 1 до 15, в коде BCD.</translation>
    </message>
    <message>
        <source>%1 is not a subroutine and cannot be called. Change its role to subroutine.</source>
        <translation>%1 не подпрограмма, её нельзя вызвать. Смените её роль на подпрограмму.</translation>
    </message>
    <message>
        <source>%1 is not an address of this machine itself. Until users and encryption exist the runtime listens on 127.0.0.1 or ::1 only.</source>
        <translation>%1 — не адрес самой этой машины. Пока нет пользователей и шифрования, среда выполнения слушает только 127.0.0.1 или ::1.</translation>
    </message>
    <message>
        <source>%1 is not an interrupt routine. Change its role to interrupt, or correct the name.</source>
        <translation>%1 — не подпрограмма прерывания. Измените её роль на «прерывание» или исправьте имя.</translation>
    </message>
    <message>
        <source>%1 is not closed. Write %2 where it ends.</source>
        <translation>%1 не закрыто. Напишите %2 там, где оно кончается.</translation>
    </message>
    <message>
        <source>%1 is out of range for %2, which goes from %3 to %4.</source>
        <translation>%1 вне диапазона для %2: от %3 до %4.</translation>
    </message>
    <message>
        <source>%1 is outside the range of %2, which is %3 to %4.</source>
        <translation>%1 вне диапазона типа %2: от %3 до %4.</translation>
    </message>
    <message>
        <source>%1 is outside the range of the operand %2 of %3, which is %4 to %5.</source>
        <translation>%1 вне диапазона операнда %2 инструкции %3: от %4 до %5.</translation>
    </message>
    <message>
        <source>%1 is recording a trace. There is one recorder; it is free when they stop.</source>
        <translation>%1 ведёт запись. Регистратор один; он освободится, когда запись остановят.</translation>
    </message>
    <message>
        <source>%1 is set to %2, and the operand %3 of %4 takes %5 to %6.</source>
        <translation>В %1 записывается %2, а операнд %3 команды %4 принимает от %5 до %6.</translation>
    </message>
    <message>
        <source>%1 is the coil of two rungs. Only the last one counts in each scan.</source>
        <translation>%1 — катушка двух цепей. В каждом цикле действует только последняя.</translation>
    </message>
    <message>
        <source>%1 is timed or counted at two places. Both change the same value.</source>
        <translation>%1 отсчитывается в двух местах. Оба меняют одно и то же значение.</translation>
    </message>
    <message>
        <source>%1 joins two flows, and only one is open here. Begin the second one with LD.</source>
        <translation>%1 соединяет два потока, а здесь открыт только один. Начните второй с LD.</translation>
    </message>
    <message>
        <source>%1 lacks the operand %2. It is written %3.</source>
        <translation>У %1 нет операнда %2. Пишется так: %3.</translation>
    </message>
    <message>
        <source>%1 lies in the registers %2 to %3 that the module in slot %4 uses. Take other registers.</source>
        <translation>%1 лежит в регистрах с %2 по %3, которые использует модуль в слоте %4. Возьмите другие регистры.</translation>
    </message>
    <message>
        <source>%1 lies in the work area of %2, which begins at %3. Nothing else may use it.</source>
        <translation>%1 лежит в рабочей области команды %2, которая начинается с %3. Ничто другое не может её использовать.</translation>
    </message>
    <message>
        <source>%1 may occur %2 times in a project. This one is too many.</source>
        <translation>%1 может встречаться в проекте столько раз: %2. Эта — лишняя.</translation>
    </message>
    <message>
        <source>%1 may occur once for each axis. Axis %2 has one already.</source>
        <translation>%1 может встречаться по одному разу на ось. У оси %2 она уже есть.</translation>
    </message>
    <message>
        <source>%1 motion cycles came late. Controller time slipped; nothing was made up for.</source>
        <translation>Опоздало циклов движения: %1. Время контроллера сдвинулось; ничего не навёрстывалось.</translation>
    </message>
    <message>
        <source>%1 needs an MPS before it.</source>
        <translation>Перед %1 нужна инструкция MPS.</translation>
    </message>
    <message>
        <source>%1 needs axes on a CAN port, and a %2 has none. Choose another model, or remove the instruction.</source>
        <translation>Для %1 нужны оси на порту CAN, а у %2 их нет. Выберите другую модель или удалите инструкцию.</translation>
    </message>
    <message>
        <source>%1 needs pulse outputs, and a %2 has none. Choose another model, or remove the instruction.</source>
        <translation>Для %1 нужны импульсные выходы, а у %2 их нет. Выберите другую модель или удалите инструкцию.</translation>
    </message>
    <message>
        <source>%1 sent something that is no message of the online protocol: %2. The connection was closed.</source>
        <translation>%1 прислал не сообщение протокола связи: %2. Соединение закрыто.</translation>
    </message>
    <message>
        <source>%1 stands outside of every loop.</source>
        <translation>%1 стоит вне всех циклов.</translation>
    </message>
    <message>
        <source>%1 stands outside of everything that is declared. A text holds TYPE, FUNCTION, FUNCTION_BLOCK, INTERFACE, PROGRAM, VAR_GLOBAL and CONFIGURATION.</source>
        <translation>%1 стоит вне всех объявлений. В тексте бывают TYPE, FUNCTION, FUNCTION_BLOCK, INTERFACE, PROGRAM, VAR_GLOBAL и CONFIGURATION.</translation>
    </message>
    <message>
        <source>%1 takes %2 arguments, here are %3.</source>
        <translation>%1 принимает аргументов: %2, здесь их %3.</translation>
    </message>
    <message>
        <source>%1 takes %2 arguments, here are %3. They are %4.</source>
        <translation>%1 принимает аргументов: %2, здесь их %3. Это: %4.</translation>
    </message>
    <message>
        <source>%1 takes %2 flows, and fewer are open here. Begin each of them with STR.</source>
        <translation>%1 берёт потоков: %2, здесь открыто меньше. Начните каждый из них с STR.</translation>
    </message>
    <message>
        <source>%1 takes %2 operands, here are %3. It is written %4.</source>
        <translation>Число операндов %1 — %2, здесь их %3. Пишется так: %4.</translation>
    </message>
    <message>
        <source>%1 takes %2 parameter numbers from %3, and the programs write only the first %4. The others will be parameter 0.</source>
        <translation>%1 берёт номера параметров (%2) начиная с %3, а программы записывают только первые (%4). Остальные будут параметром 0.</translation>
    </message>
    <message>
        <source>%2 has no variables of type %1. The types are %3.</source>
        <translation>В %2 нет переменных типа %1. Типы: %3.</translation>
    </message>
    <message>
        <source>= compares two values. Write := to assign one.</source>
        <translation>= сравнивает два значения. Для присваивания напишите :=.</translation>
    </message>
    <message>
        <source>A FOR cannot step by 0.</source>
        <translation>Шаг FOR не может быть 0.</translation>
    </message>
    <message>
        <source>A Kinco axis moves with its drive&apos;s own acceleration. Leave the acceleration at 0, or set drive parameters 0 and 1 with MC_WPARAS.</source>
        <translation>Ось Kinco движется с ускорением своего привода. Оставьте ускорение равным 0 или задайте параметры привода 0 и 1 через MC_WPARAS.</translation>
    </message>
    <message>
        <source>A constant is needed here: its value must be known before the program runs.</source>
        <translation>Здесь нужна константа: её значение должно быть известно до запуска программы.</translation>
    </message>
    <message>
        <source>A download is already being taken over. Wait until it has ended.</source>
        <translation>Загрузка уже принимается. Дождитесь её конца.</translation>
    </message>
    <message>
        <source>A line of ``` belongs to a document, not to a program. Remove it.</source>
        <translation>Строка ``` относится к документу, а не к программе. Удалите её.</translation>
    </message>
    <message>
        <source>A network has one %1. Begin a new network here, or use AND and OR.</source>
        <translation>В сети может быть только одна инструкция %1. Начните здесь новую сеть или используйте AND и OR.</translation>
    </message>
    <message>
        <source>A piece of the download came for byte %1, but byte %2 is next. The download was dropped; the old program is untouched.</source>
        <translation>Часть загрузки пришла для байта %1, а ожидался байт %2. Загрузка отброшена; старая программа не тронута.</translation>
    </message>
    <message>
        <source>A program cannot send the command %1h: the module generates INTERPOLATE (34h) itself, and does not support 1Bh, 38h, 3Eh and 3Fh.</source>
        <translation>Программа не может послать команду %1h: INTERPOLATE (34h) модуль создаёт сам, а 1Bh, 38h, 3Eh и 3Fh не поддерживает.</translation>
    </message>
    <message>
        <source>A program is taken only in STOP. Stop the controller first.</source>
        <translation>Программа принимается только в STOP. Сначала остановите контроллер.</translation>
    </message>
    <message>
        <source>A program of %1 bytes is too large; the controller takes up to %2 bytes.</source>
        <translation>Программа слишком велика (байт: %1); контроллер принимает не более %2.</translation>
    </message>
    <message>
        <source>A quoted cell does not end. Close it with a quotation mark followed by a comma or the end of the line.</source>
        <translation>Ячейка в кавычках не закрыта. Закройте её кавычкой, за которой идёт запятая или конец строки.</translation>
    </message>
    <message>
        <source>A real %1 has no Structured Text. This program runs on the virtual controller only.</source>
        <translation>У настоящего %1 нет структурированного текста. Программа работает только на виртуальном контроллере.</translation>
    </message>
    <message>
        <source>A subroutine has at most %1 parameters and local variables of this kind; %2 is one too many.</source>
        <translation>У подпрограммы не больше %1 параметров и местных переменных этого вида; %2 уже лишняя.</translation>
    </message>
    <message>
        <source>A trace needs at least one channel and at most %1.</source>
        <translation>Для записи нужен хотя бы один канал, самое большее: %1.</translation>
    </message>
    <message>
        <source>A variable is needed here.</source>
        <translation>Здесь нужна переменная.</translation>
    </message>
    <message>
        <source>All axes were stopped by command.</source>
        <translation>Все оси остановлены по команде.</translation>
    </message>
    <message>
        <source>An axis has no value &quot;%1&quot;. It has position, setPosition, velocity, followingError, torque, state and error.</source>
        <translation>У оси нет значения «%1». Есть position, setPosition, velocity, followingError, torque, state и error.</translation>
    </message>
    <message>
        <source>An interrupt routine of a %1 cannot call %2. Write its instructions here.</source>
        <translation>Подпрограмма прерывания %1 не может вызвать %2. Запишите её команды здесь.</translation>
    </message>
    <message>
        <source>An operand is missing beside the comma. Write it, or ??? to fill it in later.</source>
        <translation>Возле запятой нет операнда. Напишите его или ???, чтобы заполнить позже.</translation>
    </message>
    <message>
        <source>Another Camwright is working on this project (&quot;%1&quot; is locked). Close the project there to edit it here.</source>
        <translation>С этим проектом работает другой Camwright («%1» заблокирован). Закройте проект там, чтобы править его здесь.</translation>
    </message>
    <message>
        <source>Another program changed &quot;%1&quot; since it was read here. Nothing was written. Reload the project, or save over the change.</source>
        <translation>Другая программа изменила «%1» после чтения. Ничего не записано. Перечитайте проект с диска или сохраните поверх изменения.</translation>
    </message>
    <message>
        <source>Another program changed &quot;%1&quot; while a save was interrupted. Its version is kept as &quot;%2&quot;.</source>
        <translation>Другая программа изменила «%1», пока сохранение было прервано. Её версия сохранена как «%2».</translation>
    </message>
    <message>
        <source>Axis &quot;%1&quot; changes.</source>
        <translation>Ось «%1» меняется.</translation>
    </message>
    <message>
        <source>Axis &quot;%1&quot; could not be started on the bus. Check the drive&apos;s supply, node number and baud rate, then restart the node or the controller.</source>
        <translation>Ось «%1» не удалось запустить на шине. Проверьте питание привода, номер узла и скорость, затем перезапустите узел или контроллер.</translation>
    </message>
    <message>
        <source>Axis &quot;%1&quot; is in Errorstop. Remove the cause and reset it first.</source>
        <translation>Ось «%1» в состоянии Errorstop. Сначала устраните причину и сбросьте её.</translation>
    </message>
    <message>
        <source>Axis &quot;%1&quot; is new.</source>
        <translation>Ось «%1» новая.</translation>
    </message>
    <message>
        <source>Axis &quot;%1&quot; is not armed. Arm it first, and keep the heartbeats coming while it moves.</source>
        <translation>Ось «%1» не взведена. Сначала взведите её и подавайте сигнал присутствия всё время движения.</translation>
    </message>
    <message>
        <source>Axis &quot;%1&quot; is not enabled. Enable it first.</source>
        <translation>Ось «%1» не включена. Сначала включите её.</translation>
    </message>
    <message>
        <source>Axis &quot;%1&quot; is not on the bus.</source>
        <translation>Оси «%1» нет на шине.</translation>
    </message>
    <message>
        <source>Axis &quot;%1&quot; is removed.</source>
        <translation>Ось «%1» удаляется.</translation>
    </message>
    <message>
        <source>Axis &quot;%1&quot; is still moving. Stop it, or wait until it stands.</source>
        <translation>Ось «%1» ещё движется. Остановите её или дождитесь остановки.</translation>
    </message>
    <message>
        <source>Axis &quot;%1&quot; is stopped, then released: its power goes off.</source>
        <translation>Ось «%1» остановится и отпустится: её питание выключится.</translation>
    </message>
    <message>
        <source>Axis &quot;%1&quot; loses its home position; home it again before absolute moves.</source>
        <translation>Ось «%1» теряет нулевую точку; перед абсолютными перемещениями выполните выход в ноль снова.</translation>
    </message>
    <message>
        <source>Axis &quot;%1&quot; no longer answers on the bus. Mend the connection, then restart the node or the controller.</source>
        <translation>Ось «%1» больше не отвечает на шине. Исправьте соединение и перезапустите узел или контроллер.</translation>
    </message>
    <message>
        <source>Axis &quot;%1&quot; was stopped: no heartbeat came from the panel. Last heartbeat in cycle %2, stop command at the bus in cycle %3.</source>
        <translation>Ось «%1» остановлена: от панели не пришёл сигнал присутствия. Последний сигнал — в цикле %2, команда останова на шине — в цикле %3.</translation>
    </message>
    <message>
        <source>Axis &quot;%1&quot;: the drive reports alarm %2. Remove its cause, then reset the axis.</source>
        <translation>Ось «%1»: привод сообщает об аварии %2. Устраните причину и сбросьте ось.</translation>
    </message>
    <message>
        <source>Axis 1 and axis 2 of %1 are taken from the same register %2. Two axes are needed.</source>
        <translation>Ось 1 и ось 2 команды %1 берутся из одного регистра %2. Нужны две оси.</translation>
    </message>
    <message>
        <source>Axis node %1 does not answer (object %2). Check its supply, the cable, its node number and the baud rate.</source>
        <translation>Узел оси %1 не отвечает (объект %2). Проверьте его питание, кабель, номер узла и скорость.</translation>
    </message>
    <message>
        <source>Axis node %1 gave an answer about object %2 that does not fit the request. Check that no two nodes have the same number.</source>
        <translation>Узел оси %1 дал об объекте %2 ответ, не подходящий к запросу. Проверьте, нет ли двух узлов с одним номером.</translation>
    </message>
    <message>
        <source>Axis node %1 is configured and operational.</source>
        <translation>Узел оси %1 настроен и работает.</translation>
    </message>
    <message>
        <source>Axis node %1 is offline. Mend the cause, then restart the axis with MC_RESTART or stop and start the controller.</source>
        <translation>Узел оси %1 не на связи. Устраните причину, затем перезапустите ось через MC_RESTART или остановите и запустите контроллер.</translation>
    </message>
    <message>
        <source>Axis node %1 refuses object %2 with abort code %3: %4. Check whether the drive has this object and the value is in its range.</source>
        <translation>Узел оси %1 отклоняет объект %2 с кодом отказа %3: %4. Проверьте, есть ли этот объект у привода и лежит ли значение в его диапазоне.</translation>
    </message>
    <message>
        <source>Axis node %1 reports error %2 (error register %3). Look the number up in the drive&apos;s manual.</source>
        <translation>Узел оси %1 сообщает ошибку %2 (регистр ошибок %3). Найдите этот номер в руководстве привода.</translation>
    </message>
    <message>
        <source>Axis node %1 reports that its error is gone.</source>
        <translation>Узел оси %1 сообщает, что его ошибка снята.</translation>
    </message>
    <message>
        <source>Axis node %1 still works on the previous request. Wait for its answer before sending the next one.</source>
        <translation>Узел оси %1 ещё занят предыдущим запросом. Дождитесь ответа, прежде чем посылать следующий.</translation>
    </message>
    <message>
        <source>Axis number %1 is used by &quot;%2&quot; and by &quot;%3&quot;. Give one of them another number.</source>
        <translation>Номер оси %1 занят и осью «%2», и осью «%3». Дайте одной из них другой номер.</translation>
    </message>
    <message>
        <source>Axis values are read-only. Use an axis command to move an axis.</source>
        <translation>Значения оси только для чтения. Для перемещения используйте команду оси.</translation>
    </message>
    <message>
        <source>Branches are nested more than %1 deep here. Split the rung with a marker bit.</source>
        <translation>Вложенность ветвей здесь больше %1. Разделите цепь битом-маркером.</translation>
    </message>
    <message>
        <source>Calls nest %1 deep here: %2. A %3 takes %4.</source>
        <translation>Глубина вызовов здесь %1: %2. %3 допускает %4.</translation>
    </message>
    <message>
        <source>Camwright made a mistake: %1. Save your work under another name and report this text.</source>
        <translation>В Camwright произошла внутренняя ошибка: %1. Сохраните работу под другим именем и сообщите этот текст.</translation>
    </message>
    <message>
        <source>Cancelled. Nothing was changed.</source>
        <translation>Отменено. Ничего не изменено.</translation>
    </message>
    <message>
        <source>Column &quot;%1&quot; is missing from the header.</source>
        <translation>В заголовке нет столбца «%1».</translation>
    </message>
    <message>
        <source>Control of %1 lapsed because it was not renewed. What a panel moved was stopped; power stays on.</source>
        <translation>Срок управления у %1 истёк, так как его не продлили. Движения с панели остановлены; питание приводов включено.</translation>
    </message>
    <message>
        <source>Expected %1, found &quot;%2&quot;.</source>
        <translation>Ожидалось %1, найдено «%2».</translation>
    </message>
    <message>
        <source>Forced values are released: %1.</source>
        <translation>Форсирование снимается, значений: %1.</translation>
    </message>
    <message>
        <source>Here stands %1, and %2 is expected.</source>
        <translation>Здесь стоит %1, а ожидается %2.</translation>
    </message>
    <message>
        <source>Listening on %1 failed: %2.</source>
        <translation>Не удалось начать приём соединений по адресу %1: %2.</translation>
    </message>
    <message>
        <source>No axis has the number %1, though a higher one is in use. Axis numbers go from 1 without a gap.</source>
        <translation>Ни у одной оси нет номера %1, хотя больший номер занят. Номера осей идут с 1 без пропусков.</translation>
    </message>
    <message>
        <source>Nobody answers at %1: %2.</source>
        <translation>По адресу %1 никто не отвечает: %2.</translation>
    </message>
    <message>
        <source>Nothing starts the interrupt routine %1. Give it an event, or remove it.</source>
        <translation>Подпрограмму прерывания %1 ничто не запускает. Задайте ей событие или удалите её.</translation>
    </message>
    <message>
        <source>Operands of %1 are separated by blanks. Remove the comma.</source>
        <translation>Операнды %1 разделяются пробелами. Уберите запятую.</translation>
    </message>
    <message>
        <source>Program &quot;%1&quot; (%2) was loaded. The controller stands in STOP until it is started.</source>
        <translation>Загружена программа «%1» (%2). Контроллер в состоянии STOP до запуска.</translation>
    </message>
    <message>
        <source>Program &quot;%1&quot; changes.</source>
        <translation>Программа «%1» меняется.</translation>
    </message>
    <message>
        <source>Program &quot;%1&quot; is new.</source>
        <translation>Программа «%1» новая.</translation>
    </message>
    <message>
        <source>Program &quot;%1&quot; is removed.</source>
        <translation>Программа «%1» удаляется.</translation>
    </message>
    <message>
        <source>Program %1 was taken over from %2.</source>
        <translation>Программа %1 принята от %2.</translation>
    </message>
    <message>
        <source>Statements, parentheses or types are nested more than %1 deep here. Split them up.</source>
        <translation>Операторы, скобки или типы вложены здесь глубже %1. Разделите их.</translation>
    </message>
    <message>
        <source>Subroutine calls nest deeper than %1 levels. Call &quot;%2&quot; from a routine nearer to the main program.</source>
        <translation>Вложенность вызовов подпрограмм больше %1. Вызывайте «%2» из подпрограммы ближе к главной программе.</translation>
    </message>
    <message>
        <source>The %1 elements that begin at %2 do not fit into the memory area. They need %3 bytes, and %4 are left.</source>
        <translation>Элементы (%1), начинающиеся с %2, не помещаются в область памяти. Нужно байт: %3, осталось: %4.</translation>
    </message>
    <message>
        <source>The CAN send buffer is full, and nothing was sent to axis node %1. Check the cable, the terminators and the load of the bus.</source>
        <translation>Буфер отправки CAN полон, узлу оси %1 ничего не отправлено. Проверьте кабель, терминаторы и нагрузку шины.</translation>
    </message>
    <message>
        <source>The RUN/STOP switch is at STOP, so the program does not start. Set the switch to RUN.</source>
        <translation>Переключатель RUN/STOP стоит в STOP, поэтому программа не запускается. Переведите его в RUN.</translation>
    </message>
    <message>
        <source>The address &quot;%1&quot; lacks its percent sign. Write &quot;%2&quot;.</source>
        <translation>В адресе «%1» нет знака процента. Пишите «%2».</translation>
    </message>
    <message>
        <source>The branch opened by this MPS is not ended. Write MPP before its last branch.</source>
        <translation>Ветвление, открытое этой MPS, не закончено. Напишите MPP перед последней ветвью.</translation>
    </message>
    <message>
        <source>The byte 16#%1 is not UTF-8 text. Save the file as UTF-8.</source>
        <translation>Байт 16#%1 не относится к тексту UTF-8. Сохраните файл в UTF-8.</translation>
    </message>
    <message>
        <source>The character %1 has no meaning here. Remove it.</source>
        <translation>Знак %1 здесь ничего не значит. Удалите его.</translation>
    </message>
    <message>
        <source>The comment that begins here is not closed before network %1. End it with *).</source>
        <translation>Комментарий, начатый здесь, не закрыт до сети %1. Закончите его знаками *).</translation>
    </message>
    <message>
        <source>The comment that begins here is not closed before the end of the program. End it with *).</source>
        <translation>Комментарий, начатый здесь, не закрыт до конца программы. Закончите его знаками *).</translation>
    </message>
    <message>
        <source>The communication cycle of %1 microseconds is too short for %2 stations. It must be longer than %3.</source>
        <translation>Цикл связи %1 мкс слишком короток для станций: %2. Он должен быть больше %3.</translation>
    </message>
    <message>
        <source>The connection of %1 was closed: %2.</source>
        <translation>Соединение %1 закрыто: %2.</translation>
    </message>
    <message>
        <source>The connection to %1 was lost: %2. A jog or move from a panel stops by itself; the program goes on.</source>
        <translation>Связь с %1 потеряна: %2. Толчок или перемещение с панели останавливается само; программа продолжается.</translation>
    </message>
    <message>
        <source>The controller did not answer &quot;%1&quot; within %2 s. It may still carry it out; look at its state before you repeat it.</source>
        <translation>Контроллер не ответил на «%1» за %2 с. Он ещё может выполнить это; прежде чем повторять, посмотрите его состояние.</translation>
    </message>
    <message>
        <source>The controller has no axis &quot;%1&quot;.</source>
        <translation>В контроллере нет оси «%1».</translation>
    </message>
    <message>
        <source>The controller has no program. Download one first.</source>
        <translation>В контроллере нет программы. Сначала загрузите её.</translation>
    </message>
    <message>
        <source>The controller reports %1: %2</source>
        <translation>Контроллер сообщает %1: %2</translation>
    </message>
    <message>
        <source>The controller runs another program (%1) than the one this was made for (%2). Nothing was read or written.</source>
        <translation>Контроллер выполняет другую программу (%1), а не ту, для которой это сделано (%2). Ничего не прочитано и не записано.</translation>
    </message>
    <message>
        <source>The controller&apos;s settings change: model, scan period, watchdog or memory.</source>
        <translation>Меняются настройки контроллера: модель, период сканирования, сторожевой таймер или память.</translation>
    </message>
    <message>
        <source>The counter of a FOR is a variable of a whole-number type. This is %1.</source>
        <translation>Счётчик FOR — переменная целого типа. Это %1.</translation>
    </message>
    <message>
        <source>The data folder &quot;%1&quot; is in use by another runtime.</source>
        <translation>Папка данных «%1» занята другой средой выполнения.</translation>
    </message>
    <message>
        <source>The download from %1 ended before all of it had arrived. The old program is untouched.</source>
        <translation>Загрузка от %1 прервалась до полного получения. Старая программа не тронута.</translation>
    </message>
    <message>
        <source>The family %2 has no model &quot;%1&quot;. Known are %3.</source>
        <translation>В семействе %2 нет модели «%1». Известны: %3.</translation>
    </message>
    <message>
        <source>The file ends where %1 is expected.</source>
        <translation>Файл заканчивается там, где ожидается %1.</translation>
    </message>
    <message>
        <source>The file has no END line. Check that it is complete.</source>
        <translation>В файле нет строки END. Проверьте, полон ли он.</translation>
    </message>
    <message>
        <source>The file is to begin with a line that tells its settings: %1</source>
        <translation>Файл должен начинаться со строки с настройками: %1</translation>
    </message>
    <message>
        <source>The first line of the file is not the number of networks, like (*5*). The whole text was taken.</source>
        <translation>Первая строка файла — не число сетей вида (*5*). Взят весь текст.</translation>
    </message>
    <message>
        <source>The first line says %1 networks, and %2 are in the file. Check that the file is complete.</source>
        <translation>В первой строке указано сетей: %1, а в файле их %2. Проверьте, полон ли файл.</translation>
    </message>
    <message>
        <source>The flow that begins here is never used. Join it with ANB or ORB, or give it an output.</source>
        <translation>Поток, начатый здесь, нигде не используется. Соедините его через ANB или ORB или дайте ему выход.</translation>
    </message>
    <message>
        <source>The function %1 never sets its result. Assign to %1.</source>
        <translation>Функция %1 не задаёт результат. Присвойте значение %1.</translation>
    </message>
    <message>
        <source>The group opened by %1 is not closed. Write ) on a line of its own.</source>
        <translation>Группа, открытая %1, не закрыта. Напишите ) на отдельной строке.</translation>
    </message>
    <message>
        <source>The image has format version %1; this program reads version %2. Build the project again with this version.</source>
        <translation>Версия формата образа — %1; эта программа читает версию %2. Соберите проект заново этой версией.</translation>
    </message>
    <message>
        <source>The image is damaged: the check sum of its part &quot;%1&quot; is wrong. Build or download it again.</source>
        <translation>Образ повреждён: неверна контрольная сумма части «%1». Соберите или загрузите его снова.</translation>
    </message>
    <message>
        <source>The image is incomplete: %1 bytes are there, %2 are needed. Build or download it again.</source>
        <translation>Образ неполный: есть байт %1, нужно %2. Соберите или загрузите его снова.</translation>
    </message>
    <message>
        <source>The image would not be safe to run (%1) and is refused. Build the project again with this version.</source>
        <translation>Выполнять этот образ небезопасно (%1), он отклонён. Соберите проект заново этой версией.</translation>
    </message>
    <message>
        <source>The image&apos;s part &quot;%1&quot; is malformed. Build the project again with this version.</source>
        <translation>Часть «%1» образа построена неверно. Соберите проект заново этой версией.</translation>
    </message>
    <message>
        <source>The label %1 stands at two places. Give one of them another name.</source>
        <translation>Метка %1 стоит в двух местах. Дайте одной из них другое имя.</translation>
    </message>
    <message>
        <source>The last save was interrupted; it has now been finished.</source>
        <translation>Последнее сохранение было прервано; теперь оно завершено.</translation>
    </message>
    <message>
        <source>The loop that begins with this FOR has no NEXT.</source>
        <translation>У цикла, который начинается с этой FOR, нет NEXT.</translation>
    </message>
    <message>
        <source>The lower limit switch at %1 is not below the upper one at %2.</source>
        <translation>Нижний концевой выключатель %1 не ниже верхнего %2.</translation>
    </message>
    <message>
        <source>The main program is written in Structured Text, and its text has no PROGRAM.</source>
        <translation>Главная программа написана на структурированном тексте, но в тексте нет PROGRAM.</translation>
    </message>
    <message>
        <source>The module in slot %1 uses 496 words from %2 on, and they do not fit into the memory there.</source>
        <translation>Модуль в слоте %1 использует 496 слов начиная с %2, и они там не помещаются в память.</translation>
    </message>
    <message>
        <source>The name &quot;%1&quot; is already in use; upper and lower case count as equal.</source>
        <translation>Имя «%1» уже занято; прописные и строчные буквы считаются одинаковыми.</translation>
    </message>
    <message>
        <source>The name is empty. Give a name.</source>
        <translation>Имя пустое. Задайте имя.</translation>
    </message>
    <message>
        <source>The number %1 is too large for any type.</source>
        <translation>Число %1 слишком велико для любого типа.</translation>
    </message>
    <message>
        <source>The operand %1 of %2 cannot be left empty.</source>
        <translation>Операнд %1 инструкции %2 нельзя оставить пустым.</translation>
    </message>
    <message>
        <source>The operand %1 of %2 is given twice.</source>
        <translation>Операнд %1 инструкции %2 задан дважды.</translation>
    </message>
    <message>
        <source>The operand %1 of %2 is still to be filled in.</source>
        <translation>Операнд %1 инструкции %2 ещё не заполнен.</translation>
    </message>
    <message>
        <source>The operand %2 of %3 cannot be the constant %1. The memory areas allowed are %4.</source>
        <translation>Операнд %2 инструкции %3 не может быть константой %1. Допустимые области памяти: %4.</translation>
    </message>
    <message>
        <source>The operand %2 of %3 is a constant, %1 is not.</source>
        <translation>Операнд %2 инструкции %3 — константа, а %1 — нет.</translation>
    </message>
    <message>
        <source>The operand %2 of %3 is a counter, %1 is not. Write it like C0.</source>
        <translation>Операнд %2 инструкции %3 — счётчик, а %1 — нет. Пишите так: C0.</translation>
    </message>
    <message>
        <source>The operand %2 of %3 is a timer, %1 is not. Write it like T0.</source>
        <translation>Операнд %2 инструкции %3 — таймер, а %1 — нет. Пишите так: T0.</translation>
    </message>
    <message>
        <source>The operand %2 of %3 takes no variable subscript: %1. Copy the element to a variable first, or write its number.</source>
        <translation>Операнд %2 команды %3 не допускает переменный индекс: %1. Сначала скопируйте элемент в переменную или напишите его номер.</translation>
    </message>
    <message>
        <source>The operands %1 and %2 of %3 share %4. Give each of them registers of its own.</source>
        <translation>Операнды %1 и %2 команды %3 делят %4. Дайте каждому собственные регистры.</translation>
    </message>
    <message>
        <source>The operands %1 of %2 are all constants or all memory. Here they are mixed.</source>
        <translation>Операнды %1 инструкции %2 — либо все константы, либо все память. Здесь они смешаны.</translation>
    </message>
    <message>
        <source>The operating system refused work on &quot;%1&quot;: %2.</source>
        <translation>Операционная система отказала в работе с «%1»: %2.</translation>
    </message>
    <message>
        <source>The other side speaks version %1 of the online protocol, this one speaks version %2. Use programs of the same release.</source>
        <translation>Другая сторона использует версию %1 протокола связи, эта — версию %2. Используйте программы одного выпуска.</translation>
    </message>
    <message>
        <source>The parameter %1 of %2 is not given. It is VAR_IN_OUT and needs a variable.</source>
        <translation>Параметр %1 у %2 не дан. Это VAR_IN_OUT, ему нужна переменная.</translation>
    </message>
    <message>
        <source>The pragma that begins here is not closed before the end of the text. End it with }.</source>
        <translation>Прагма, которая здесь начинается, не закрыта до конца текста. Закройте её знаком }.</translation>
    </message>
    <message>
        <source>The process data of %1 axes would load the bus with %2 % at %3 bit/s. Raise the PDO inhibit times or the baud rate.</source>
        <translation>Данные процесса осей (%1) загрузят шину на %2 % при %3 бит/с. Увеличьте время запрета PDO или скорость.</translation>
    </message>
    <message>
        <source>The program arrived damaged: its digest is %1, not %2. The old program is untouched.</source>
        <translation>Программа пришла повреждённой: её хеш %1, а не %2. Старая программа не тронута.</translation>
    </message>
    <message>
        <source>The program is executing a motion instruction on axis &quot;%1&quot;. Wait until it has ended, or stop the axis.</source>
        <translation>Программа выполняет инструкцию движения на оси «%1». Дождитесь её конца или остановите ось.</translation>
    </message>
    <message>
        <source>The program runs.</source>
        <translation>Программа выполняется.</translation>
    </message>
    <message>
        <source>The program stopped because the RUN/STOP switch was set to STOP.</source>
        <translation>Программа остановлена, потому что переключатель RUN/STOP переведён в STOP.</translation>
    </message>
    <message>
        <source>The program stops, outputs take their STOP values, and the controller stays in STOP until it is started.</source>
        <translation>Программа остановится, выходы примут значения для STOP, и контроллер будет в STOP до запуска.</translation>
    </message>
    <message>
        <source>The program was stopped by command.</source>
        <translation>Программа остановлена по команде.</translation>
    </message>
    <message>
        <source>The programs have %1 instructions, a %2 holds %3.</source>
        <translation>Инструкций в программах: %1, а %2 вмещает %3.</translation>
    </message>
    <message>
        <source>The programs have %1 motion instructions, a %2 takes %3. This is the first too many.</source>
        <translation>Инструкций движения в программах: %1, а %2 допускает %3. Эта — первая лишняя.</translation>
    </message>
    <message>
        <source>The project does not tell its controller: controller.toml is missing.</source>
        <translation>В проекте не указан контроллер: нет файла controller.toml.</translation>
    </message>
    <message>
        <source>The project has %1 axes, but a %2 drives at most %3. Remove axes or choose a larger model.</source>
        <translation>Осей в проекте: %1, а %2 управляет не более чем %3. Удалите оси или выберите модель мощнее.</translation>
    </message>
    <message>
        <source>The project has a second network, &quot;%1&quot;. The controller has one CANopen motion network.</source>
        <translation>В проекте есть вторая сеть «%1». У контроллера одна сеть движения CANopen.</translation>
    </message>
    <message>
        <source>The project has axes but no network. Add the CANopen motion network.</source>
        <translation>В проекте есть оси, но нет сети. Добавьте сеть движения CANopen.</translation>
    </message>
    <message>
        <source>The project has no main program. Add a program with the role main.</source>
        <translation>В проекте нет главной программы. Добавьте программу с ролью main.</translation>
    </message>
    <message>
        <source>The project is saved, but not all files could be put in their places: %1. This happens at the next save or opening; until then other programs see a mixture.</source>
        <translation>Проект сохранён, но не все файлы удалось поставить на место: %1. Это будет сделано при следующем сохранении или открытии; до тех пор другие программы видят смесь старых и новых файлов.</translation>
    </message>
    <message>
        <source>The range %1..%2 is empty or too large.</source>
        <translation>Диапазон %1..%2 пуст или слишком велик.</translation>
    </message>
    <message>
        <source>The record of unsaved edits in &quot;%1&quot; is damaged and cannot be read.</source>
        <translation>Запись несохранённых правок в «%1» повреждена и не читается.</translation>
    </message>
    <message>
        <source>The request to axis node %1 (object %2) was given up before its answer came.</source>
        <translation>Запрос к узлу оси %1 (объект %2) снят до получения ответа.</translation>
    </message>
    <message>
        <source>The retained data are damaged and were not taken. Memory starts with its initial values.</source>
        <translation>Сохраняемые данные повреждены и не приняты. Память получает начальные значения.</translation>
    </message>
    <message>
        <source>The retained value of &quot;%1&quot; is lost.</source>
        <translation>Сохраняемое значение «%1» будет потеряно.</translation>
    </message>
    <message>
        <source>The running program has changed since this name was looked up. Look it up again.</source>
        <translation>Выполняемая программа изменилась после поиска этого имени. Найдите его снова.</translation>
    </message>
    <message>
        <source>The running program knows no &quot;%1&quot;: no address, variable or axis value has this name.</source>
        <translation>Выполняемая программа не знает «%1»: нет ни адреса, ни переменной, ни значения оси с таким именем.</translation>
    </message>
    <message>
        <source>The saved state is damaged and was not taken.</source>
        <translation>Сохранённое состояние повреждено и не принято.</translation>
    </message>
    <message>
        <source>The scan did not end within its watchdog time of %1 ms, so the program was stopped. Look for a loop without end near %2.</source>
        <translation>Цикл не закончился за время сторожевого таймера %1 мс, и программа остановлена. Ищите бесконечный цикл возле %2.</translation>
    </message>
    <message>
        <source>The settings of the motion network change.</source>
        <translation>Меняются настройки сети движения.</translation>
    </message>
    <message>
        <source>The stored program cannot be used: %1. The controller started with %2.</source>
        <translation>Сохранённую программу использовать нельзя: %1. Контроллер запущен с %2.</translation>
    </message>
    <message>
        <source>The stored retained values cannot be used: %1. They start with their initial values.</source>
        <translation>Записанные сохраняемые значения использовать нельзя: %1. Они получают начальные значения.</translation>
    </message>
    <message>
        <source>The string that begins here is not closed on its line. End it with the same quotation mark.</source>
        <translation>Строка, которая здесь начинается, не закрыта до конца строки текста. Закройте её той же кавычкой.</translation>
    </message>
    <message>
        <source>The subroutine number %1 is already that of %2. Give each subroutine a number of its own.</source>
        <translation>Номер подпрограммы %1 уже занят программой %2. Дайте каждой подпрограмме собственный номер.</translation>
    </message>
    <message>
        <source>The subscript %1 is outside the array, which goes from %2 to %3.</source>
        <translation>Индекс %1 вне массива, который идёт от %2 до %3.</translation>
    </message>
    <message>
        <source>The supply was switched off and on.</source>
        <translation>Питание было отключено и включено.</translation>
    </message>
    <message>
        <source>The text is not UTF-8 from here on. Store the file as UTF-8.</source>
        <translation>Начиная с этого места текст не в UTF-8. Сохраните файл в UTF-8.</translation>
    </message>
    <message>
        <source>The trace setting &quot;%1&quot; is outside its range, which is %2.</source>
        <translation>Настройка записи «%1» вне диапазона: %2.</translation>
    </message>
    <message>
        <source>The value %1 has a branch in this CASE already.</source>
        <translation>У значения %1 уже есть ветвь в этом CASE.</translation>
    </message>
    <message>
        <source>The variable &quot;%1&quot; has no address. Variables of this controller need one.</source>
        <translation>У переменной «%1» нет адреса. Переменным этого контроллера он нужен.</translation>
    </message>
    <message>
        <source>The variable %1 has no usable address. Give it one in its variable table.</source>
        <translation>У переменной %1 нет пригодного адреса. Задайте его в таблице переменных.</translation>
    </message>
    <message>
        <source>The variable %1 is never used.</source>
        <translation>Переменная %1 не используется.</translation>
    </message>
    <message>
        <source>The variable table makes %1 the %2 variable %3; here it is used as %4. Use it as %2, or change the variable.</source>
        <translation>По таблице переменных %1 — это переменная %3 типа %2; здесь она используется как %4. Используйте её как %2 или измените переменную.</translation>
    </message>
    <message>
        <source>The variables need more than %1 bytes. Make arrays smaller.</source>
        <translation>Переменным нужно больше %1 байт. Уменьшите массивы.</translation>
    </message>
    <message>
        <source>The virtual controller could not be started: &quot;%1&quot; is missing or cannot be run. Reinstall Camwright.</source>
        <translation>Виртуальный контроллер не запускается: «%1» отсутствует или не выполняется. Переустановите Camwright.</translation>
    </message>
    <message>
        <source>The virtual controller was started but did not answer within %1 s: %2.</source>
        <translation>Виртуальный контроллер запущен, но не ответил за %1 с: %2.</translation>
    </message>
    <message>
        <source>The watchdog of %1 ms is not longer than the scan period of %2 ms, so every scan would trip it.</source>
        <translation>Сторожевой таймер %1 мс не больше периода сканирования %2 мс, и он сработает в каждом цикле.</translation>
    </message>
    <message>
        <source>There are %1 subroutines, a %2 takes %3.</source>
        <translation>Подпрограмм %1, %2 допускает %3.</translation>
    </message>
    <message>
        <source>There are more subscripts here than the array has.</source>
        <translation>Индексов здесь больше, чем у массива.</translation>
    </message>
    <message>
        <source>There are more than %1 problems in this program; the others are not listed. Mend the first ones and check again.</source>
        <translation>Проблем в этой программе больше %1; остальные не показаны. Исправьте первые и проверьте снова.</translation>
    </message>
    <message>
        <source>There are more than %1 warnings in this program; the others are not listed.</source>
        <translation>Предупреждений в этой программе больше %1; остальные не показаны.</translation>
    </message>
    <message>
        <source>There are more values here than %1 has elements.</source>
        <translation>Значений здесь больше, чем элементов у %1.</translation>
    </message>
    <message>
        <source>There is a character that cannot be seen here: %1. Remove it.</source>
        <translation>Здесь невидимый символ: %1. Удалите его.</translation>
    </message>
    <message>
        <source>There is no FOR that this NEXT could end.</source>
        <translation>Нет FOR, которую могла бы закончить эта NEXT.</translation>
    </message>
    <message>
        <source>There is no axis %1 in the motion network. The instruction will end with ERRID 1.</source>
        <translation>В сети движения нет оси %1. Инструкция завершится с ERRID 1.</translation>
    </message>
    <message>
        <source>There is no axis %1; the running program has %2.</source>
        <translation>Оси %1 нет; осей в выполняемой программе: %2.</translation>
    </message>
    <message>
        <source>There is no axis node %1 in the motion network, or the network has not been started. Add the axis in the motion network editor.</source>
        <translation>В сети движения нет узла оси %1, или сеть не запущена. Добавьте ось в редакторе сети движения.</translation>
    </message>
    <message>
        <source>There is no connection to a controller. Connect first.</source>
        <translation>Нет связи с контроллером. Сначала подключитесь.</translation>
    </message>
    <message>
        <source>There is no controller family &quot;%1&quot;. Known are %2.</source>
        <translation>Нет семейства контроллеров «%1». Известны: %2.</translation>
    </message>
    <message>
        <source>There is no download with the number %1, or it has ended.</source>
        <translation>Загрузки с номером %1 нет, или она закончилась.</translation>
    </message>
    <message>
        <source>There is no element %1 in %2. Its elements are 0 to %3.</source>
        <translation>В %2 нет элемента %1. Его элементы: от 0 до %3.</translation>
    </message>
    <message>
        <source>There is no group that this ) could close. Remove it, or open one with AND( or OR(.</source>
        <translation>Эта ) ничего не закрывает. Удалите её или откройте группу с AND( или OR(.</translation>
    </message>
    <message>
        <source>There is no label %1 in this program. Write LBL %1 where the jump goes to.</source>
        <translation>В этой программе нет метки %1. Напишите LBL %1 там, куда ведёт переход.</translation>
    </message>
    <message>
        <source>There is no motion network for the controller %1. Choose another model, or remove axes and network.</source>
        <translation>У контроллера %1 нет сети движения. Выберите другую модель или удалите оси и сеть.</translation>
    </message>
    <message>
        <source>There is no subroutine &quot;%1&quot;. Add one, or correct the name.</source>
        <translation>Подпрограммы «%1» нет. Добавьте её или исправьте имя.</translation>
    </message>
    <message>
        <source>There is no subroutine &quot;%1&quot;. Did you mean %2?</source>
        <translation>Подпрограммы «%1» нет. Возможно, имелась в виду %2?</translation>
    </message>
    <message>
        <source>There is no variable &quot;%1&quot;. Did you mean %2?</source>
        <translation>Переменной «%1» нет. Возможно, имелась в виду %2?</translation>
    </message>
    <message>
        <source>There is nothing named &quot;%1&quot; here. Declare it, or correct the name.</source>
        <translation>Здесь нет ничего с именем «%1». Объявите его или исправьте имя.</translation>
    </message>
    <message>
        <source>There is nothing named &quot;%1&quot; here. Did you mean %2?</source>
        <translation>Здесь нет ничего с именем «%1». Имеется в виду %2?</translation>
    </message>
    <message>
        <source>This call leads back to %1: %2. A controller of this family cannot do that.</source>
        <translation>Этот вызов возвращается к %1: %2. Контроллеры этого семейства так не умеют.</translation>
    </message>
    <message>
        <source>This controller cannot be ended from here. Only a local virtual controller can.</source>
        <translation>Этот контроллер нельзя завершить отсюда. Можно только локальный виртуальный контроллер.</translation>
    </message>
    <message>
        <source>This controller does not know the family &quot;%1&quot; or its model &quot;%2&quot;.</source>
        <translation>Этот контроллер не знает семейства «%1» или его модели «%2».</translation>
    </message>
    <message>
        <source>This divides by zero.</source>
        <translation>Здесь деление на ноль.</translation>
    </message>
    <message>
        <source>This expression has more than %1 operators in a row. Split it up with a variable.</source>
        <translation>В этом выражении больше %1 операторов подряд. Разделите его с помощью переменной.</translation>
    </message>
    <message>
        <source>This instruction stands before the first network. Write a line (* Network 0 *) above it.</source>
        <translation>Эта инструкция стоит до первой сети. Напишите над ней строку (* Network 0 *).</translation>
    </message>
    <message>
        <source>This is never reached.</source>
        <translation>Это никогда не выполняется.</translation>
    </message>
    <message>
        <source>This is not a controller image: it does not begin like one.</source>
        <translation>Это не образ контроллера: начало не то.</translation>
    </message>
    <message>
        <source>This is not readable as TOML: %1.</source>
        <translation>Это не читается как TOML: %1.</translation>
    </message>
    <message>
        <source>This line has more than %1 operands. No instruction takes so many.</source>
        <translation>В этой строке операндов больше %1. Столько не принимает ни одна инструкция.</translation>
    </message>
    <message>
        <source>This network is numbered %1, the next number is %2.</source>
        <translation>У этой сети номер %1, а следующий номер — %2.</translation>
    </message>
    <message>
        <source>This project has format %1, written by a newer Camwright. This one reads formats up to %2. Open the project with the newer one.</source>
        <translation>Формат этого проекта %1, он записан более новым Camwright. Эта версия читает форматы до %2. Откройте проект новой версией.</translation>
    </message>
    <message>
        <source>This row has %1 cells, but the header has %2.</source>
        <translation>Ячеек в этой строке: %1, а в заголовке: %2.</translation>
    </message>
    <message>
        <source>This rung has no output and no instruction: it does nothing.</source>
        <translation>В этой цепи нет ни выхода, ни инструкции: она ничего не делает.</translation>
    </message>
    <message>
        <source>This saved state has version %1; this program reads version %2.</source>
        <translation>Версия этого сохранённого состояния — %1; программа читает версию %2.</translation>
    </message>
    <message>
        <source>This version has no %1 link. Use local or tcp://HOST[:PORT].</source>
        <translation>В этой версии нет связи вида %1. Используйте local или tcp://HOST[:PORT].</translation>
    </message>
    <message>
        <source>Unsaved edits of an earlier session belong to another state of this project: its files were changed since. They cannot be taken over.</source>
        <translation>Несохранённые правки прошлого сеанса относятся к другому состоянию проекта: его файлы с тех пор изменены. Принять эти правки нельзя.</translation>
    </message>
    <message>
        <source>Variables or their initial values change.</source>
        <translation>Меняются переменные или их начальные значения.</translation>
    </message>
    <message>
        <source>What follows END is not part of the program. Move it above END, or remove it.</source>
        <translation>Всё, что после END, не входит в программу. Перенесите это выше END или удалите.</translation>
    </message>
    <message>
        <source>nothing came from it for %1 s</source>
        <translation>от него ничего не приходило %1 с</translation>
    </message>
    <message>
        <source>project.toml does not tell its format. Its first line is to be: format = %1</source>
        <translation>В project.toml не указан формат. Первая строка должна быть: format = %1</translation>
    </message>
</context>
<context>
    <name>Fixes</name>
    <message>
        <source>Quick fixes</source>
        <translation>Быстрые исправления</translation>
    </message>
    <message>
        <source>There is no problem here.</source>
        <translation>Здесь нет ошибок.</translation>
    </message>
    <message>
        <source>There is no quick fix for this problem.</source>
        <translation>Для этой ошибки нет быстрого исправления.</translation>
    </message>
</context>
<context>
    <name>KeyMaps</name>
    <message>
        <source>Camwright</source>
        <translation>Camwright</translation>
    </message>
    <message>
        <source>F11 builds, Alt+F8 goes online, Shift+F8 stops.</source>
        <translation>F11 — сборка, Alt+F8 — подключение, Shift+F8 — стоп.</translation>
    </message>
    <message>
        <source>F11 goes online, Ctrl+Shift+B builds, F8 goes to the next problem.</source>
        <translation>F11 — подключение, Ctrl+Shift+B — сборка, F8 — следующая проблема.</translation>
    </message>
    <message>
        <source>F4 builds, F3 goes online; F5 to F10 start nothing.</source>
        <translation>F4 — сборка, F3 — подключение; F5–F10 ничего не запускают.</translation>
    </message>
    <message>
        <source>Like CODESYS</source>
        <translation>Как в CODESYS</translation>
    </message>
    <message>
        <source>Like GX Works</source>
        <translation>Как в GX Works</translation>
    </message>
    <message>
        <source>Like TwinCAT</source>
        <translation>Как в TwinCAT</translation>
    </message>
    <message>
        <source>The keys of the manual.</source>
        <translation>Клавиши из руководства.</translation>
    </message>
</context>
<context>
    <name>Program</name>
    <message>
        <source>The texts of this language are not installed.</source>
        <translation>Тексты этого языка не установлены.</translation>
    </message>
</context>
<context>
    <name>QuickFix</name>
    <message>
        <source>Add %1 as ???, to be filled in later</source>
        <translation>Добавить %1 как ???, чтобы заполнить позже</translation>
    </message>
    <message>
        <source>Add the subroutine %1</source>
        <translation>Добавить подпрограмму %1</translation>
    </message>
    <message>
        <source>Begin network %1 here</source>
        <translation>Начать здесь сеть %1</translation>
    </message>
    <message>
        <source>Begin the rung with %1, which is always on</source>
        <translation>Начать цепь с %1: этот бит всегда включён</translation>
    </message>
    <message>
        <source>Close the group before its output</source>
        <translation>Закрыть группу перед её выходом</translation>
    </message>
    <message>
        <source>Declare %1 as %2 at %4 in the table &quot;%3&quot;</source>
        <translation>Объявить %1 как %2 по адресу %4 в таблице «%3»</translation>
    </message>
    <message>
        <source>Declare %1 as %2 in the table &quot;%3&quot;</source>
        <translation>Объявить %1 как %2 в таблице «%3»</translation>
    </message>
    <message>
        <source>End the comment at the end of its line</source>
        <translation>Закончить комментарий в конце его строки</translation>
    </message>
    <message>
        <source>Join the two flows with %1</source>
        <translation>Соединить два потока командой %1</translation>
    </message>
    <message>
        <source>Make %1 a subroutine</source>
        <translation>Сделать %1 подпрограммой</translation>
    </message>
    <message>
        <source>Make a comment of &quot;%1&quot;</source>
        <translation>Превратить «%1» в комментарий</translation>
    </message>
    <message>
        <source>Number all networks in their order</source>
        <translation>Пронумеровать все сети по порядку</translation>
    </message>
    <message>
        <source>Put %1 at %2, which nothing uses</source>
        <translation>Разместить %1 по адресу %2, который ничем не занят</translation>
    </message>
    <message>
        <source>Remove &quot;%1&quot;</source>
        <translation>Удалить «%1»</translation>
    </message>
    <message>
        <source>Remove END, so that what follows belongs to the program</source>
        <translation>Удалить END, чтобы следующее за ним вошло в программу</translation>
    </message>
    <message>
        <source>Remove the character %1</source>
        <translation>Удалить символ %1</translation>
    </message>
    <message>
        <source>Remove the line &quot;%1&quot;</source>
        <translation>Удалить строку «%1»</translation>
    </message>
    <message>
        <source>Write %2 in place of %1</source>
        <translation>Написать %2 вместо %1</translation>
    </message>
    <message>
        <source>Write %2 in place of the last %1</source>
        <translation>Написать %2 вместо последнего %1</translation>
    </message>
    <message>
        <source>Write ??? for the operand, to be filled in later</source>
        <translation>Написать ??? вместо операнда, чтобы заполнить позже</translation>
    </message>
    <message>
        <source>Write a blank in place of the comma</source>
        <translation>Написать пробел вместо запятой</translation>
    </message>
    <message>
        <source>Write a plain blank in place of the character %1</source>
        <translation>Написать обычный пробел вместо символа %1</translation>
    </message>
    <message>
        <source>Write the groups of this network to marker bits (%1) in networks of their own</source>
        <translation>Записать группы этой сети в биты-маркеры (%1) в отдельных сетях</translation>
    </message>
</context>
<context>
    <name>Units</name>
    <message>
        <source>mm</source>
        <translation>мм</translation>
    </message>
    <message>
        <source>mm/s</source>
        <translation>мм/с</translation>
    </message>
    <message>
        <source>ms</source>
        <translation>мс</translation>
    </message>
    <message>
        <source>s</source>
        <translation>с</translation>
    </message>
    <message>
        <source>°/s</source>
        <translation>°/с</translation>
    </message>
</context>
<context>
    <name>Watch</name>
    <message>
        <source>Actual position, from the drive</source>
        <translation>Фактическое положение от привода</translation>
    </message>
    <message>
        <source>Actual velocity, units per second</source>
        <translation>Фактическая скорость, единиц в секунду</translation>
    </message>
    <message>
        <source>Commanded less actual position</source>
        <translation>Заданное минус фактическое положение</translation>
    </message>
    <message>
        <source>Error code of the axis, 0 for none</source>
        <translation>Код ошибки оси, 0 — ошибки нет</translation>
    </message>
    <message>
        <source>Number of the axis state</source>
        <translation>Номер состояния оси</translation>
    </message>
    <message>
        <source>Position the drive is commanded to</source>
        <translation>Заданное приводу положение</translation>
    </message>
    <message>
        <source>Torque in per cent of rated</source>
        <translation>Момент в процентах от номинального</translation>
    </message>
</context>
<context>
    <name>Words</name>
    <message>
        <source>axis</source>
        <translation>ось</translation>
    </message>
    <message>
        <source>controller</source>
        <translation>контроллер</translation>
    </message>
    <message>
        <source>error</source>
        <translation>ошибка</translation>
    </message>
    <message>
        <source>line %1, column %2</source>
        <translation>строка %1, столбец %2</translation>
    </message>
    <message>
        <source>network</source>
        <translation>сеть</translation>
    </message>
    <message>
        <source>note</source>
        <translation>замечание</translation>
    </message>
    <message>
        <source>program</source>
        <translation>программа</translation>
    </message>
    <message>
        <source>project</source>
        <translation>проект</translation>
    </message>
    <message>
        <source>variable table</source>
        <translation>таблица переменных</translation>
    </message>
    <message>
        <source>warning</source>
        <translation>предупреждение</translation>
    </message>
    <message>
        <source>watch list</source>
        <translation>список наблюдения</translation>
    </message>
</context>
<context>
    <name>camwright::ActionCatalogue</name>
    <message>
        <source>A build or download is running.</source>
        <translation>Идёт сборка или загрузка.</translation>
    </message>
    <message>
        <source>A controller is connected already.</source>
        <translation>Контроллер уже подключён.</translation>
    </message>
    <message>
        <source>Everything is saved.</source>
        <translation>Всё сохранено.</translation>
    </message>
    <message>
        <source>No controller is connected.</source>
        <translation>Контроллер не подключён.</translation>
    </message>
    <message>
        <source>No project is open.</source>
        <translation>Проект не открыт.</translation>
    </message>
    <message>
        <source>No tab is open.</source>
        <translation>Ни одна вкладка не открыта.</translation>
    </message>
    <message>
        <source>The controller does not run.</source>
        <translation>Контроллер не работает.</translation>
    </message>
    <message>
        <source>The controller runs already.</source>
        <translation>Контроллер уже работает.</translation>
    </message>
    <message>
        <source>The current view does not offer it.</source>
        <translation>В текущем виде это недоступно.</translation>
    </message>
    <message>
        <source>There is no other place for the tab. Split the editors first.</source>
        <translation>Другого места для вкладки нет. Сначала разделите область редакторов.</translation>
    </message>
    <message>
        <source>There is no problem.</source>
        <translation>Проблем нет.</translation>
    </message>
    <message>
        <source>There is no step to redo.</source>
        <translation>Нет шага для повтора.</translation>
    </message>
    <message>
        <source>There is no step to undo.</source>
        <translation>Нет шага для отмены.</translation>
    </message>
    <message>
        <source>There is one group of tabs only.</source>
        <translation>Группа вкладок только одна.</translation>
    </message>
</context>
<context>
    <name>camwright::ArmBar</name>
    <message>
        <source>%1 has control</source>
        <translation>управление у %1</translation>
    </message>
    <message>
        <source>Arm panel control first.</source>
        <translation>Сначала взведите управление с панели.</translation>
    </message>
    <message>
        <source>Clears the error once its cause is gone.</source>
        <translation>Сбрасывает ошибку, когда её причина устранена.</translation>
    </message>
    <message>
        <source>Click to let the program have the axis again. What this panel moves stops first.</source>
        <translation>Щелчок возвращает ось программе. Сначала остановится то, что движет эта панель.</translation>
    </message>
    <message>
        <source>Click to move this axis by hand. The program&apos;s motion of it is refused meanwhile.</source>
        <translation>Щелчок позволяет двигать ось вручную. Движения от программы в это время отклоняются.</translation>
    </message>
    <message>
        <source>Enable</source>
        <translation>Включить</translation>
    </message>
    <message>
        <source>Enabled</source>
        <translation>Включена</translation>
    </message>
    <message>
        <source>Home</source>
        <translation>Выход в ноль</translation>
    </message>
    <message>
        <source>Panel Control</source>
        <translation>Управление с панели</translation>
    </message>
    <message>
        <source>Panel control</source>
        <translation>Управление с панели</translation>
    </message>
    <message>
        <source>Puts the axis under power. It does not move.</source>
        <translation>Подаёт питание на ось. Она не движется.</translation>
    </message>
    <message>
        <source>Reset</source>
        <translation>Сброс</translation>
    </message>
    <message>
        <source>Searches the home position with the method set in the drive. The axis moves.</source>
        <translation>Ищет нулевую точку методом, заданным в приводе. Ось движется.</translation>
    </message>
    <message>
        <source>The axis is enabled. Click to stop it and take the power off.</source>
        <translation>Ось включена. Щелчок остановит её и снимет питание.</translation>
    </message>
    <message>
        <source>There is no error to reset.</source>
        <translation>Ошибки для сброса нет.</translation>
    </message>
    <message>
        <source>arm it to move the axis</source>
        <translation>взведите, чтобы двигать ось</translation>
    </message>
    <message>
        <source>armed</source>
        <translation>взведено</translation>
    </message>
    <message>
        <source>arming</source>
        <translation>взводится</translation>
    </message>
    <message>
        <source>off</source>
        <translation>выкл.</translation>
    </message>
    <message>
        <source>program motion is refused</source>
        <translation>движения от программы отклоняются</translation>
    </message>
    <message>
        <source>taking control</source>
        <translation>берётся управление</translation>
    </message>
</context>
<context>
    <name>camwright::AxisEditor</name>
    <message>
        <source>%1 %2 per pulse</source>
        <translation>%1 %2 на импульс</translation>
    </message>
    <message>
        <source>%1 %2/min</source>
        <translation>%1 %2/мин</translation>
    </message>
    <message>
        <source>%1 %2/s</source>
        <translation>%1 %2/с</translation>
    </message>
    <message>
        <source>%1 pulses/s</source>
        <translation>%1 имп./с</translation>
    </message>
    <message>
        <source>32-bit position range</source>
        <translation>Диапазон положения, 32 бита</translation>
    </message>
    <message>
        <source>At motor speed</source>
        <translation>При скорости двигателя</translation>
    </message>
    <message>
        <source>Axis</source>
        <translation>Ось</translation>
    </message>
    <message>
        <source>Change axis %1</source>
        <translation>Изменить ось %1</translation>
    </message>
    <message>
        <source>Home switch</source>
        <translation>Датчик нуля</translation>
    </message>
    <message>
        <source>Inertia of the load over that of the motor; a larger one lags more.</source>
        <translation>Отношение инерции нагрузки к инерции двигателя; чем оно больше, тем больше отставание.</translation>
    </message>
    <message>
        <source>Inertia ratio</source>
        <translation>Отношение инерций</translation>
    </message>
    <message>
        <source>Linear axis, CANopen address %1</source>
        <translation>Линейная ось, адрес CANopen %1</translation>
    </message>
    <message>
        <source>Lower limit switch</source>
        <translation>Нижний концевой выключатель</translation>
    </message>
    <message>
        <source>Motor speed</source>
        <translation>Скорость двигателя</translation>
    </message>
    <message>
        <source>Motor speed the results below are shown for.</source>
        <translation>Скорость двигателя, для которой показаны результаты ниже.</translation>
    </message>
    <message>
        <source>Position at which the home switch acts.</source>
        <translation>Положение, в котором срабатывает датчик нуля.</translation>
    </message>
    <message>
        <source>Position of the limit switch on the negative side.</source>
        <translation>Положение концевого выключателя с отрицательной стороны.</translation>
    </message>
    <message>
        <source>Position of the limit switch on the positive side.</source>
        <translation>Положение концевого выключателя с положительной стороны.</translation>
    </message>
    <message>
        <source>Resolution</source>
        <translation>Разрешение</translation>
    </message>
    <message>
        <source>Results</source>
        <translation>Результаты</translation>
    </message>
    <message>
        <source>Rotary axis, CANopen address %1</source>
        <translation>Поворотная ось, адрес CANopen %1</translation>
    </message>
    <message>
        <source>Simulated Machine</source>
        <translation>Моделируемая машина</translation>
    </message>
    <message>
        <source>Speed for the drive</source>
        <translation>Скорость для привода</translation>
    </message>
    <message>
        <source>Speed of the load</source>
        <translation>Скорость нагрузки</translation>
    </message>
    <message>
        <source>Start position</source>
        <translation>Начальное положение</translation>
    </message>
    <message>
        <source>The same a minute</source>
        <translation>То же в минуту</translation>
    </message>
    <message>
        <source>Upper limit switch</source>
        <translation>Верхний концевой выключатель</translation>
    </message>
    <message>
        <source>Used by the virtual controller only; nothing of it reaches a real machine</source>
        <translation>Только для виртуального контроллера; на настоящую машину ничего не передаётся</translation>
    </message>
    <message>
        <source>What these values mean at the machine</source>
        <translation>Что эти значения значат на машине</translation>
    </message>
    <message>
        <source>Where the load stands when the controller is switched on.</source>
        <translation>Где стоит нагрузка при включении контроллера.</translation>
    </message>
    <message>
        <source>mm</source>
        <translation>мм</translation>
    </message>
    <message>
        <source>rpm</source>
        <translation>об/мин</translation>
    </message>
    <message>
        <source>°</source>
        <translation>°</translation>
    </message>
    <message>
        <source>±%1 %2</source>
        <translation>±%1 %2</translation>
    </message>
</context>
<context>
    <name>camwright::AxisForm</name>
    <message>
        <source>Address of the drive on the CANopen bus. Numbers go from 1 without a gap.</source>
        <translation>Адрес привода на шине CANopen. Номера идут с 1 без пропусков.</translation>
    </message>
    <message>
        <source>Advanced</source>
        <translation>Расширенный</translation>
    </message>
    <message>
        <source>Axis number</source>
        <translation>Номер оси</translation>
    </message>
    <message>
        <source>Axis type</source>
        <translation>Тип оси</translation>
    </message>
    <message>
        <source>Default</source>
        <translation>По умолчанию</translation>
    </message>
    <message>
        <source>Encoder resolution</source>
        <translation>Разрешение энкодера</translation>
    </message>
    <message>
        <source>Guard time</source>
        <translation>Время контроля</translation>
    </message>
    <message>
        <source>Guard time 1000 ms, life factor 3</source>
        <translation>Время контроля 1000 мс, коэффициент жизни 3</translation>
    </message>
    <message>
        <source>How far the load moves while the motor makes one turn.</source>
        <translation>На сколько сдвигается нагрузка за один оборот двигателя.</translation>
    </message>
    <message>
        <source>How many answers may be missing before the axis counts as lost.</source>
        <translation>Сколько ответов может не прийти, прежде чем ось считается потерянной.</translation>
    </message>
    <message>
        <source>How often the master asks the drive whether it is alive. 0 switches guarding off.</source>
        <translation>Как часто ведущий спрашивает привод, на связи ли он. 0 отключает контроль.</translation>
    </message>
    <message>
        <source>Life factor</source>
        <translation>Коэффициент жизни</translation>
    </message>
    <message>
        <source>Linear</source>
        <translation>Линейная</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Имя</translation>
    </message>
    <message>
        <source>Name of the axis, as programs, traces and this window call it (KS-MCN-08)</source>
        <translation>Имя оси, как её называют программы, записи и это окно (KS-MCN-08)</translation>
    </message>
    <message>
        <source>Node guarding</source>
        <translation>Контроль узла</translation>
    </message>
    <message>
        <source>Own guard time and life factor</source>
        <translation>Свои время контроля и коэффициент жизни</translation>
    </message>
    <message>
        <source>PDO event timer</source>
        <translation>Таймер событий PDO</translation>
    </message>
    <message>
        <source>PDO inhibit time</source>
        <translation>Время запрета PDO</translation>
    </message>
    <message>
        <source>Positions in degrees</source>
        <translation>Положения в градусах</translation>
    </message>
    <message>
        <source>Positions in millimetres</source>
        <translation>Положения в миллиметрах</translation>
    </message>
    <message>
        <source>Pulses of the encoder per turn of the motor.</source>
        <translation>Импульсов энкодера на оборот двигателя.</translation>
    </message>
    <message>
        <source>Rotary</source>
        <translation>Поворотная</translation>
    </message>
    <message>
        <source>Sends process data at least this often, also when nothing changed. 0: only on change.</source>
        <translation>Данные процесса передаются не реже этого, даже без изменений. 0: только при изменении.</translation>
    </message>
    <message>
        <source>Shortest distance between two process data frames of the drive. Position and speed change quickly; without it they would fill the bus.</source>
        <translation>Наименьший промежуток между двумя кадрами данных процесса привода. Положение и скорость меняются быстро; без него они заняли бы всю шину.</translation>
    </message>
    <message>
        <source>Travel per motor turn</source>
        <translation>Ход на оборот двигателя</translation>
    </message>
    <message>
        <source>Type</source>
        <translation>Тип</translation>
    </message>
    <message>
        <source>mm</source>
        <translation>мм</translation>
    </message>
    <message>
        <source>ms</source>
        <translation>мс</translation>
    </message>
    <message>
        <source>pulses</source>
        <translation>имп.</translation>
    </message>
    <message>
        <source>°</source>
        <translation>°</translation>
    </message>
</context>
<context>
    <name>camwright::AxisListModel</name>
    <message>
        <source> mm</source>
        <translation> мм</translation>
    </message>
    <message>
        <source> ms</source>
        <translation> мс</translation>
    </message>
    <message>
        <source>Axis</source>
        <translation>Ось</translation>
    </message>
    <message>
        <source>Encoder resolution</source>
        <translation>Разрешение энкодера</translation>
    </message>
    <message>
        <source>Guard time</source>
        <translation>Время контроля</translation>
    </message>
    <message>
        <source>Life factor</source>
        <translation>Коэффициент жизни</translation>
    </message>
    <message>
        <source>Linear</source>
        <translation>Линейная</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Имя</translation>
    </message>
    <message>
        <source>PDO event timer</source>
        <translation>Таймер событий PDO</translation>
    </message>
    <message>
        <source>PDO inhibit time</source>
        <translation>Время запрета PDO</translation>
    </message>
    <message>
        <source>Rotary</source>
        <translation>Поворотная</translation>
    </message>
    <message>
        <source>Travel per turn</source>
        <translation>Ход на оборот</translation>
    </message>
    <message>
        <source>Type</source>
        <translation>Тип</translation>
    </message>
    <message>
        <source>off</source>
        <translation>выкл.</translation>
    </message>
    <message>
        <source>°</source>
        <translation>°</translation>
    </message>
</context>
<context>
    <name>camwright::ChannelListModel</name>
    <message>
        <source>Channel</source>
        <translation>Канал</translation>
    </message>
    <message>
        <source>Part of the next recording.</source>
        <translation>Входит в следующую запись.</translation>
    </message>
    <message>
        <source>at A</source>
        <translation>у A</translation>
    </message>
    <message>
        <source>at B</source>
        <translation>у B</translation>
    </message>
</context>
<context>
    <name>camwright::CommissioningEditor</name>
    <message>
        <source>%1 · Commissioning</source>
        <translation>%1 · Наладка</translation>
    </message>
    <message>
        <source>Commissioning</source>
        <translation>Наладка</translation>
    </message>
    <message>
        <source>Go online to move this axis.</source>
        <translation>Подключитесь, чтобы двигать эту ось.</translation>
    </message>
    <message>
        <source>The controller&apos;s program has no axis &quot;%1&quot;. Download this project to move it.</source>
        <translation>В программе контроллера нет оси «%1». Загрузите этот проект, чтобы двигать её.</translation>
    </message>
    <message>
        <source>This is a convenience, not a safety function: the machine needs its own emergency stop.</source>
        <translation>Это удобство, а не функция безопасности: машине нужен собственный аварийный останов.</translation>
    </message>
    <message>
        <source>This link cannot move axes.</source>
        <translation>По этой связи двигать оси нельзя.</translation>
    </message>
    <message>
        <source>This link cannot move axes: %1</source>
        <translation>По этой связи двигать оси нельзя: %1</translation>
    </message>
</context>
<context>
    <name>camwright::ConnectionStrip</name>
    <message>
        <source>A panel is armed</source>
        <translation>Панель взведена</translation>
    </message>
    <message>
        <source>Connecting to %1</source>
        <translation>Подключение к %1</translation>
    </message>
    <message>
        <source>Connection to %1 lost, trying again</source>
        <translation>Связь с %1 потеряна, повтор попытки</translation>
    </message>
    <message numerus="yes">
        <source>F %n forced</source>
        <translation>
            <numerusform>F %n форсировано</numerusform>
            <numerusform>F %n форсировано</numerusform>
            <numerusform>F %n форсировано</numerusform>
        </translation>
    </message>
    <message>
        <source>REAL MACHINE · %1 · %2</source>
        <translation>НАСТОЯЩАЯ МАШИНА · %1 · %2</translation>
    </message>
    <message>
        <source>Release all</source>
        <translation>Снять всё</translation>
    </message>
    <message>
        <source>Show What Differs</source>
        <translation>Показать различия</translation>
    </message>
    <message>
        <source>Shows what a download would change; nothing is sent before you agree.</source>
        <translation>Показывает, что изменит загрузка; до вашего согласия ничего не отправляется.</translation>
    </message>
    <message>
        <source>The controller has no program yet.</source>
        <translation>В контроллере пока нет программы.</translation>
    </message>
    <message>
        <source>The controller runs another program: live values are off.</source>
        <translation>Контроллер выполняет другую программу: текущие значения отключены.</translation>
    </message>
    <message>
        <source>Virtual controller · %1</source>
        <translation>Виртуальный контроллер · %1</translation>
    </message>
</context>
<context>
    <name>camwright::ControllerEditor</name>
    <message>
        <source>%1 bytes</source>
        <translation>%1 Б</translation>
    </message>
    <message>
        <source>%1 elements</source>
        <translation>%1 эл.</translation>
    </message>
    <message>
        <source>0: the program runs as fast as it can. Else every scan begins this long after the one before.</source>
        <translation>0: программа работает с наибольшей скоростью. Иначе каждый цикл начинается через это время после начала предыдущего.</translation>
    </message>
    <message>
        <source>A scan that takes longer stops the axes and the program.</source>
        <translation>Более долгий цикл останавливает оси и программу.</translation>
    </message>
    <message>
        <source>Allow nested branches</source>
        <translation>Разрешить вложенные ветви</translation>
    </message>
    <message>
        <source>Axes on the motion network</source>
        <translation>Оси в сети движения</translation>
    </message>
    <message>
        <source>CAN ports</source>
        <translation>Порты CAN</translation>
    </message>
    <message>
        <source>Change the controller&apos;s model</source>
        <translation>Сменить модель контроллера</translation>
    </message>
    <message>
        <source>Change the scan period</source>
        <translation>Сменить период сканирования</translation>
    </message>
    <message>
        <source>Change the watchdog</source>
        <translation>Изменить сторожевой таймер</translation>
    </message>
    <message>
        <source>Controller</source>
        <translation>Контроллер</translation>
    </message>
    <message>
        <source>Digital inputs on the unit</source>
        <translation>Дискретные входы на блоке</translation>
    </message>
    <message>
        <source>Digital outputs on the unit</source>
        <translation>Дискретные выходы на блоке</translation>
    </message>
    <message>
        <source>Ethernet ports</source>
        <translation>Порты Ethernet</translation>
    </message>
    <message>
        <source>Expansion modules</source>
        <translation>Модули расширения</translation>
    </message>
    <message>
        <source>Family</source>
        <translation>Семейство</translation>
    </message>
    <message>
        <source>Limits that checks and builds apply</source>
        <translation>Ограничения для проверки и сборки</translation>
    </message>
    <message>
        <source>Make programs strict Kinco</source>
        <translation>Включить строгий режим Kinco</translation>
    </message>
    <message>
        <source>Memory %1</source>
        <translation>Память %1</translation>
    </message>
    <message>
        <source>Model</source>
        <translation>Модель</translation>
    </message>
    <message>
        <source>Motion instructions</source>
        <translation>Инструкции движения</translation>
    </message>
    <message>
        <source>Program size, instructions</source>
        <translation>Объём программы, инструкций</translation>
    </message>
    <message>
        <source>Programs may hold only what KincoBuilder is known to take: nested branches, AND( and OR(, are refused, and a quick fix writes them to marker bits.</source>
        <translation>В программах допускается только то, что заведомо принимает KincoBuilder: вложенные ветви AND( и OR( отвергаются, а быстрое исправление записывает их в биты-маркеры.</translation>
    </message>
    <message>
        <source>Pulse outputs (not simulated yet)</source>
        <translation>Импульсные выходы (без модели)</translation>
    </message>
    <message>
        <source>Scan period</source>
        <translation>Период сканирования</translation>
    </message>
    <message>
        <source>Strict Kinco</source>
        <translation>Строгий режим Kinco</translation>
    </message>
    <message>
        <source>Strict Kinco: no nested branches, AND( and OR(</source>
        <translation>Строгий режим Kinco: без вложенных ветвей AND( и OR(</translation>
    </message>
    <message>
        <source>The controller this project is for; its limits apply at once</source>
        <translation>Контроллер этого проекта; его ограничения действуют сразу</translation>
    </message>
    <message>
        <source>Watchdog</source>
        <translation>Сторожевой таймер</translation>
    </message>
    <message>
        <source>What the Model Offers</source>
        <translation>Возможности модели</translation>
    </message>
    <message>
        <source>What the model offers</source>
        <translation>Возможности модели</translation>
    </message>
    <message>
        <source>ms</source>
        <translation>мс</translation>
    </message>
    <message>
        <source>none</source>
        <translation>нет</translation>
    </message>
    <message>
        <source>µs</source>
        <translation>мкс</translation>
    </message>
</context>
<context>
    <name>camwright::DemoDrawing</name>
    <message>
        <source>Drawing of the demo machine: a feed slide on a screw and an indexing table</source>
        <translation>Рисунок демонстрационной машины: салазки подачи на винте и поворотный стол</translation>
    </message>
    <message>
        <source>linear, 100 mm a turn</source>
        <translation>линейная, 100 мм на оборот</translation>
    </message>
    <message>
        <source>rotary, 45° a turn</source>
        <translation>поворотная, 45° на оборот</translation>
    </message>
</context>
<context>
    <name>camwright::DocViewer</name>
    <message>
        <source>Documentation</source>
        <translation>Документация</translation>
    </message>
    <message>
        <source>Page</source>
        <translation>Страница</translation>
    </message>
    <message>
        <source>Pages</source>
        <translation>Страницы</translation>
    </message>
</context>
<context>
    <name>camwright::DownloadDialog</name>
    <message>
        <source>Asking the controller what would change.</source>
        <translation>Запрашивается у контроллера, что изменится.</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Отмена</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Закрыть</translation>
    </message>
    <message>
        <source>Download</source>
        <translation>Загрузка</translation>
    </message>
    <message>
        <source>Download cancelled. The controller keeps its program.</source>
        <translation>Загрузка отменена. Контроллер сохранил свою программу.</translation>
    </message>
    <message>
        <source>Download plan</source>
        <translation>План загрузки</translation>
    </message>
    <message>
        <source>Downloaded. The controller stands in STOP.</source>
        <translation>Загружено. Контроллер в состоянии STOP.</translation>
    </message>
    <message>
        <source>Effect</source>
        <translation>Последствие</translation>
    </message>
    <message>
        <source>Ends the transfer; the old program stays as it is.</source>
        <translation>Прерывает передачу; старая программа остаётся как есть.</translation>
    </message>
    <message>
        <source>Keep It</source>
        <translation>Оставить как есть</translation>
    </message>
    <message>
        <source>Keep it</source>
        <translation>Оставить как есть</translation>
    </message>
    <message>
        <source>Leaves the controller&apos;s program as it is.</source>
        <translation>Оставляет программу контроллера как есть.</translation>
    </message>
    <message>
        <source>Nothing was changed.</source>
        <translation>Ничего не изменено.</translation>
    </message>
    <message>
        <source>Overwrite the Controller</source>
        <translation>Перезаписать контроллер</translation>
    </message>
    <message>
        <source>Overwrite the controller</source>
        <translation>Перезаписать контроллер</translation>
    </message>
    <message>
        <source>Progress of the download</source>
        <translation>Ход загрузки</translation>
    </message>
    <message>
        <source>Sending. The old program stays until the last byte is verified.</source>
        <translation>Идёт отправка. Старая программа остаётся, пока не проверен последний байт.</translation>
    </message>
    <message>
        <source>Sends the program. The controller stands in STOP afterwards.</source>
        <translation>Отправляет программу. После этого контроллер в состоянии STOP.</translation>
    </message>
    <message>
        <source>The controller already has this program. Sending it again changes only what is listed.</source>
        <translation>В контроллере уже эта программа. Повторная отправка изменит только перечисленное.</translation>
    </message>
    <message>
        <source>The controller&apos;s program is replaced. It stands in STOP afterwards.</source>
        <translation>Программа контроллера будет заменена. Затем он будет в STOP.</translation>
    </message>
    <message>
        <source>The controller&apos;s program is replaced. It stops first, and stands in STOP afterwards.</source>
        <translation>Программа контроллера будет заменена. Сначала он остановится и затем будет в STOP.</translation>
    </message>
    <message>
        <source>What</source>
        <translation>Что</translation>
    </message>
    <message>
        <source>What the download changes, stops and loses.</source>
        <translation>Что загрузка изменит, остановит и потеряет.</translation>
    </message>
    <message>
        <source>nothing</source>
        <translation>ничего</translation>
    </message>
    <message>
        <source>nothing changes</source>
        <translation>ничего не меняется</translation>
    </message>
</context>
<context>
    <name>camwright::EditorArea</name>
    <message>
        <source>Open an object from the project tree, or press %1 to find one.</source>
        <translation>Откройте объект в дереве проекта или нажмите %1, чтобы найти его.</translation>
    </message>
    <message>
        <source>Open an object from the project tree.</source>
        <translation>Откройте объект в дереве проекта.</translation>
    </message>
</context>
<context>
    <name>camwright::EditorTabBar</name>
    <message>
        <source>Editors</source>
        <translation>Редакторы</translation>
    </message>
</context>
<context>
    <name>camwright::Explain</name>
    <message>
        <source>Explain This Message</source>
        <translation>Пояснить это сообщение</translation>
    </message>
</context>
<context>
    <name>camwright::FamilyCard</name>
    <message>
        <source>New project for %1</source>
        <translation>Новый проект для %1</translation>
    </message>
</context>
<context>
    <name>camwright::FindBar</name>
    <message>
        <source>%1 of %2</source>
        <translation>%1 из %2</translation>
    </message>
    <message numerus="yes">
        <source>%n hit(s)</source>
        <translation>
            <numerusform>%n совпадение</numerusform>
            <numerusform>%n совпадения</numerusform>
            <numerusform>%n совпадений</numerusform>
        </translation>
    </message>
    <message>
        <source>Close (Esc)</source>
        <translation>Закрыть (Esc)</translation>
    </message>
    <message>
        <source>Find</source>
        <translation>Найти</translation>
    </message>
    <message>
        <source>Next hit (Enter)</source>
        <translation>Следующее совпадение (Enter)</translation>
    </message>
    <message>
        <source>Previous hit</source>
        <translation>Предыдущее совпадение</translation>
    </message>
    <message>
        <source>Regular expression; \1 in the replacement stands for the first group</source>
        <translation>Регулярное выражение; \1 в замене означает первую группу</translation>
    </message>
    <message>
        <source>Replace</source>
        <translation>Заменить</translation>
    </message>
    <message>
        <source>Replace All</source>
        <translation>Заменить все</translation>
    </message>
    <message>
        <source>Replace every hit; one step to undo</source>
        <translation>Заменить все совпадения; отменяется одним шагом</translation>
    </message>
    <message>
        <source>Replace this hit and go to the next</source>
        <translation>Заменить это совпадение и перейти к следующему</translation>
    </message>
    <message>
        <source>Replace with</source>
        <translation>Заменить на</translation>
    </message>
    <message>
        <source>Tell upper from lower case</source>
        <translation>Различать прописные и строчные</translation>
    </message>
    <message>
        <source>Whole words only; %M0.1 is one word</source>
        <translation>Только слова целиком; %M0.1 — одно слово</translation>
    </message>
    <message>
        <source>not found</source>
        <translation>не найдено</translation>
    </message>
</context>
<context>
    <name>camwright::HoldButton</name>
    <message>
        <source>%1 while held (%2 while armed)</source>
        <translation>%1, пока удерживается (%2 при взведённой панели)</translation>
    </message>
</context>
<context>
    <name>camwright::JogPad</name>
    <message>
        <source>%1/s</source>
        <translation>%1/с</translation>
    </message>
    <message>
        <source>Each press moves the axis by the step size.</source>
        <translation>Каждое нажатие сдвигает ось на величину шага.</translation>
    </message>
    <message>
        <source>Hold</source>
        <translation>Удержание</translation>
    </message>
    <message>
        <source>How far one press moves the axis.</source>
        <translation>На сколько одно нажатие сдвигает ось.</translation>
    </message>
    <message>
        <source>Jog</source>
        <translation>Толчковый режим</translation>
    </message>
    <message>
        <source>Jog fast backwards</source>
        <translation>Толчок назад быстро</translation>
    </message>
    <message>
        <source>Jog fast forwards</source>
        <translation>Толчок вперёд быстро</translation>
    </message>
    <message>
        <source>Jog slowly backwards</source>
        <translation>Толчок назад медленно</translation>
    </message>
    <message>
        <source>Jog slowly forwards</source>
        <translation>Толчок вперёд медленно</translation>
    </message>
    <message>
        <source>Maximum</source>
        <translation>Наибольшая</translation>
    </message>
    <message>
        <source>Maximum speed</source>
        <translation>Наибольшая скорость</translation>
    </message>
    <message>
        <source>No speed of this panel is higher. It starts at 5 %; raise it when the axis behaves.</source>
        <translation>Скорость с этой панели не бывает выше. Вначале 5 %; поднимите, когда ось ведёт себя как надо.</translation>
    </message>
    <message>
        <source>Speed cap</source>
        <translation>Предел скорости</translation>
    </message>
    <message>
        <source>Speed cap in per cent of the maximum speed</source>
        <translation>Предел скорости в процентах от наибольшей</translation>
    </message>
    <message>
        <source>Step</source>
        <translation>Шаг</translation>
    </message>
    <message>
        <source>Step size</source>
        <translation>Величина шага</translation>
    </message>
    <message>
        <source>The axis moves while the button or key is held, and stops on release.</source>
        <translation>Ось движется, пока удерживается кнопка или клавиша, и останавливается при отпускании.</translation>
    </message>
    <message>
        <source>Way of jogging</source>
        <translation>Способ толчкового движения</translation>
    </message>
    <message>
        <source>What the speed cap is a share of. A larger one leaves the cap where it is.</source>
        <translation>От чего считается предел скорости. Если её увеличить, предел останется на месте.</translation>
    </message>
    <message>
        <source>each press moves one step</source>
        <translation>каждое нажатие — один шаг</translation>
    </message>
    <message>
        <source>hold to run, release to stop</source>
        <translation>удерживать — ход, отпустить — стоп</translation>
    </message>
</context>
<context>
    <name>camwright::KeyTableModel</name>
    <message>
        <source>Action</source>
        <translation>Действие</translation>
    </message>
    <message>
        <source>Keys</source>
        <translation>Клавиши</translation>
    </message>
    <message>
        <source>yours</source>
        <translation>изменено</translation>
    </message>
</context>
<context>
    <name>camwright::KeysPage</name>
    <message>
        <source>%1 alone is for typing. Hold Ctrl or Alt with it, or choose a function key.</source>
        <translation>%1 без Ctrl или Alt нужна для ввода текста. Нажмите её с Ctrl или Alt или выберите функциональную клавишу.</translation>
    </message>
    <message>
        <source>%1 is the key of &quot;%2&quot;.</source>
        <translation>%1 — клавиша действия «%2».</translation>
    </message>
    <message>
        <source>Actions and their keys</source>
        <translation>Действия и их клавиши</translation>
    </message>
    <message>
        <source>Back to the keys of the map.</source>
        <translation>Вернуть клавиши раскладки.</translation>
    </message>
    <message>
        <source>Every action back to the keys of the map.</source>
        <translation>Вернуть всем действиям клавиши раскладки.</translation>
    </message>
    <message>
        <source>Find an action or a key</source>
        <translation>Найти действие или клавишу</translation>
    </message>
    <message>
        <source>Key</source>
        <translation>Клавиша</translation>
    </message>
    <message>
        <source>Key map</source>
        <translation>Раскладка клавиш</translation>
    </message>
    <message>
        <source>Keys you know from another tool. Each map remembers what you change in it.</source>
        <translation>Клавиши, знакомые по другой программе. Каждая раскладка помнит ваши изменения.</translation>
    </message>
    <message>
        <source>Press the key here. A function key, or one with Ctrl or Alt; Escape gives up.</source>
        <translation>Нажмите клавишу здесь: функциональную или с Ctrl либо Alt; Esc — отказ.</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Убрать</translation>
    </message>
    <message>
        <source>Reset</source>
        <translation>Сбросить</translation>
    </message>
    <message>
        <source>Reset All</source>
        <translation>Сбросить все</translation>
    </message>
    <message>
        <source>Second key</source>
        <translation>Вторая клавиша</translation>
    </message>
    <message>
        <source>Shows the actions whose name or key has these letters.</source>
        <translation>Показывает действия, в имени или клавише которых есть эти буквы.</translation>
    </message>
    <message>
        <source>Take the Key</source>
        <translation>Забрать клавишу</translation>
    </message>
    <message>
        <source>The action has no key then.</source>
        <translation>Действие останется без клавиши.</translation>
    </message>
    <message>
        <source>The other action loses it.</source>
        <translation>Другое действие её лишится.</translation>
    </message>
</context>
<context>
    <name>camwright::LampStrip</name>
    <message>
        <source>%1, %2</source>
        <translation>%1, %2</translation>
    </message>
    <message>
        <source>Drive</source>
        <translation>Привод</translation>
    </message>
    <message>
        <source>Error</source>
        <translation>Ошибка</translation>
    </message>
    <message>
        <source>Home switch</source>
        <translation>Датчик нуля</translation>
    </message>
    <message>
        <source>Limit +</source>
        <translation>Предел +</translation>
    </message>
    <message>
        <source>Limit −</source>
        <translation>Предел −</translation>
    </message>
    <message>
        <source>axis</source>
        <translation>ось</translation>
    </message>
    <message>
        <source>free</source>
        <translation>свободен</translation>
    </message>
    <message>
        <source>none</source>
        <translation>нет</translation>
    </message>
    <message>
        <source>not on the bus</source>
        <translation>не на шине</translation>
    </message>
    <message>
        <source>off</source>
        <translation>выкл.</translation>
    </message>
    <message>
        <source>on</source>
        <translation>вкл.</translation>
    </message>
    <message>
        <source>operational</source>
        <translation>работает</translation>
    </message>
    <message>
        <source>reached</source>
        <translation>достигнут</translation>
    </message>
</context>
<context>
    <name>camwright::LiveText</name>
    <message>
        <source>%1, at %2</source>
        <translation>%1, в %2</translation>
    </message>
    <message>
        <source>The connection to the controller is lost. The values shown are those of %1.</source>
        <translation>Связь с контроллером потеряна. Показаны значения на %1.</translation>
    </message>
    <message>
        <source>The project was changed since the download. The values shown are those of %1, before the change.</source>
        <translation>После загрузки проект был изменён. Показаны значения на %1, до изменения.</translation>
    </message>
</context>
<context>
    <name>camwright::LogModel</name>
    <message>
        <source>%1 s</source>
        <translation>%1 с</translation>
    </message>
    <message>
        <source>Code</source>
        <translation>Код</translation>
    </message>
    <message>
        <source>Controller time</source>
        <translation>Время контроллера</translation>
    </message>
    <message>
        <source>Cycle</source>
        <translation>Цикл</translation>
    </message>
    <message>
        <source>Message</source>
        <translation>Сообщение</translation>
    </message>
</context>
<context>
    <name>camwright::LogPanel</name>
    <message>
        <source>Controller log</source>
        <translation>Журнал контроллера</translation>
    </message>
    <message>
        <source>Copy</source>
        <translation>Копировать</translation>
    </message>
    <message>
        <source>Go online to see what the controller reports.</source>
        <translation>Подключитесь, чтобы видеть сообщения контроллера.</translation>
    </message>
    <message>
        <source>Log</source>
        <translation>Журнал</translation>
    </message>
    <message>
        <source>What the controller reported, newest first. F1 explains an entry.</source>
        <translation>Что сообщал контроллер, новое сверху. F1 поясняет запись.</translation>
    </message>
</context>
<context>
    <name>camwright::MainWindow</name>
    <message>
        <source>&quot;%1&quot; has edits that are not saved.</source>
        <translation>В «%1» есть несохранённые правки.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; was not opened.</source>
        <translation>«%1» не открыт.</translation>
    </message>
    <message>
        <source>&amp;Controller</source>
        <translation>&amp;Контроллер</translation>
    </message>
    <message>
        <source>&amp;Edit</source>
        <translation>&amp;Правка</translation>
    </message>
    <message>
        <source>&amp;File</source>
        <translation>&amp;Файл</translation>
    </message>
    <message>
        <source>&amp;Go</source>
        <translation>П&amp;ереход</translation>
    </message>
    <message>
        <source>&amp;Help</source>
        <translation>&amp;Справка</translation>
    </message>
    <message>
        <source>&amp;Project</source>
        <translation>П&amp;роект</translation>
    </message>
    <message>
        <source>&amp;Redo</source>
        <translation>&amp;Повторить</translation>
    </message>
    <message>
        <source>&amp;Redo %1</source>
        <translation>&amp;Повторить: %1</translation>
    </message>
    <message>
        <source>&amp;Undo</source>
        <translation>&amp;Отменить</translation>
    </message>
    <message>
        <source>&amp;Undo %1</source>
        <translation>&amp;Отменить: %1</translation>
    </message>
    <message>
        <source>&amp;View</source>
        <translation>&amp;Вид</translation>
    </message>
    <message>
        <source>&lt;b&gt;Camwright %1&lt;/b&gt;&lt;br&gt;Engineering tool for small motion controllers.&lt;br&gt;&lt;br&gt;Free software under the GNU General Public License, version 3 or later. It comes without any warranty.</source>
        <translation>&lt;b&gt;Camwright %1&lt;/b&gt;&lt;br&gt;Инженерная среда для небольших контроллеров движения.&lt;br&gt;&lt;br&gt;Свободная программа на условиях GNU General Public License версии 3 или новее. Поставляется без каких-либо гарантий.</translation>
    </message>
    <message>
        <source>About Camwright</source>
        <translation>О программе Camwright</translation>
    </message>
    <message>
        <source>Analyse</source>
        <translation>Анализ</translation>
    </message>
    <message>
        <source>Another Camwright works on this project. Edits here can be saved only under another name.</source>
        <translation>С этим проектом работает другой Camwright. Правки отсюда можно сохранить только под другим именем.</translation>
    </message>
    <message>
        <source>Another program changed files of this project.</source>
        <translation>Другая программа изменила файлы этого проекта.</translation>
    </message>
    <message>
        <source>Bottom dock</source>
        <translation>Нижняя панель</translation>
    </message>
    <message>
        <source>Camwright ended without saving this project.</source>
        <translation>Camwright завершился, не сохранив этот проект.</translation>
    </message>
    <message>
        <source>Changed Outside</source>
        <translation>Изменено извне</translation>
    </message>
    <message>
        <source>Commission</source>
        <translation>Наладка</translation>
    </message>
    <message>
        <source>Configure</source>
        <translation>Настройка</translation>
    </message>
    <message>
        <source>Discard Them</source>
        <translation>Отбросить их</translation>
    </message>
    <message>
        <source>Discard the Edits</source>
        <translation>Отбросить правки</translation>
    </message>
    <message>
        <source>Discarding them cannot be undone.</source>
        <translation>Отброшенное вернуть нельзя.</translation>
    </message>
    <message>
        <source>Edits are kept in memory only until you save. %1</source>
        <translation>Пока вы не сохраните, правки хранятся только в памяти. %1</translation>
    </message>
    <message>
        <source>Find Action</source>
        <translation>Найти действие</translation>
    </message>
    <message>
        <source>Find Anything</source>
        <translation>Найти что угодно</translation>
    </message>
    <message>
        <source>Go On Working</source>
        <translation>Продолжить работу</translation>
    </message>
    <message>
        <source>Keep It</source>
        <translation>Оставить как есть</translation>
    </message>
    <message>
        <source>Keep Mine</source>
        <translation>Оставить мои</translation>
    </message>
    <message>
        <source>Layouts</source>
        <translation>Раскладки</translation>
    </message>
    <message>
        <source>Name of an action</source>
        <translation>Название действия</translation>
    </message>
    <message>
        <source>Name of an object or variable</source>
        <translation>Имя объекта или переменной</translation>
    </message>
    <message>
        <source>Open Project Folder</source>
        <translation>Открыть папку проекта</translation>
    </message>
    <message>
        <source>Overwrite the File</source>
        <translation>Перезаписать файл</translation>
    </message>
    <message>
        <source>Program</source>
        <translation>Программа</translation>
    </message>
    <message>
        <source>Project folder (*)</source>
        <translation>Папка проекта (*)</translation>
    </message>
    <message>
        <source>Properties</source>
        <translation>Свойства</translation>
    </message>
    <message>
        <source>Reload</source>
        <translation>Перечитать</translation>
    </message>
    <message>
        <source>Reloading replaces your unsaved edits; Ctrl+Z brings them back.</source>
        <translation>Перечитывание заменит несохранённые правки; Ctrl+Z вернёт их.</translation>
    </message>
    <message>
        <source>Restore the Edits</source>
        <translation>Восстановить правки</translation>
    </message>
    <message>
        <source>Restoring them is one step that can be undone; the files stay as they are until you save.</source>
        <translation>Их восстановление — один шаг, который можно отменить; файлы не меняются, пока вы не сохраните.</translation>
    </message>
    <message>
        <source>Save</source>
        <translation>Сохранить</translation>
    </message>
    <message>
        <source>Save Project As</source>
        <translation>Сохранить проект как</translation>
    </message>
    <message>
        <source>Saving now replaces what the other program wrote.</source>
        <translation>Сохранение сейчас заменит то, что записала другая программа.</translation>
    </message>
    <message>
        <source>Side dock</source>
        <translation>Боковая панель</translation>
    </message>
    <message>
        <source>The demo machine could not be copied to &quot;%1&quot;.</source>
        <translation>Не удалось скопировать демонстрационную машину в «%1».</translation>
    </message>
    <message numerus="yes">
        <source>The edits are kept: %n steps.</source>
        <translation>
            <numerusform>Правки целы: %n шаг.</numerusform>
            <numerusform>Правки целы: %n шага.</numerusform>
            <numerusform>Правки целы: %n шагов.</numerusform>
        </translation>
    </message>
    <message>
        <source>The project was not created.</source>
        <translation>Проект не создан.</translation>
    </message>
    <message>
        <source>The project was not reloaded.</source>
        <translation>Проект не перечитан.</translation>
    </message>
    <message>
        <source>The project was not saved.</source>
        <translation>Проект не сохранён.</translation>
    </message>
    <message>
        <source>Unsaved Edits</source>
        <translation>Несохранённые правки</translation>
    </message>
</context>
<context>
    <name>camwright::MotionColumn</name>
    <message>
        <source>Stop all axes</source>
        <translation>Остановить все оси</translation>
    </message>
    <message>
        <source>Stops every axis at once. Esc and Space do the same while this panel is armed or moves the axis.</source>
        <translation>Останавливает сразу все оси. Esc и пробел делают то же, пока эта панель взведена или движет ось.</translation>
    </message>
    <message>
        <source>The axis is still moving.</source>
        <translation>Ось ещё движется.</translation>
    </message>
</context>
<context>
    <name>camwright::MovePad</name>
    <message>
        <source>%1/s</source>
        <translation>%1/с</translation>
    </message>
    <message>
        <source>%1/s²</source>
        <translation>%1/с²</translation>
    </message>
    <message>
        <source>Absolute</source>
        <translation>Абсолютное</translation>
    </message>
    <message>
        <source>Acceleration</source>
        <translation>Ускорение</translation>
    </message>
    <message>
        <source>Acceleration and deceleration of the move.</source>
        <translation>Ускорение и замедление перемещения.</translation>
    </message>
    <message>
        <source>Distance</source>
        <translation>Расстояние</translation>
    </message>
    <message>
        <source>Kind of move</source>
        <translation>Вид перемещения</translation>
    </message>
    <message>
        <source>Move</source>
        <translation>Переместить</translation>
    </message>
    <message>
        <source>Moves by the distance.</source>
        <translation>Перемещает на расстояние.</translation>
    </message>
    <message>
        <source>Moves to the target.</source>
        <translation>Перемещает к цели.</translation>
    </message>
    <message>
        <source>Only for the duration shown here: a Kinco axis moves with its drive&apos;s own acceleration, drive parameters 0 and 1.</source>
        <translation>Только для показанной здесь длительности: ось Kinco движется с ускорением своего привода, параметры 0 и 1.</translation>
    </message>
    <message>
        <source>Position to move to, or distance to move by.</source>
        <translation>Положение, к которому двигаться, или расстояние.</translation>
    </message>
    <message>
        <source>Profile</source>
        <translation>Профиль</translation>
    </message>
    <message>
        <source>Relative</source>
        <translation>Относительное</translation>
    </message>
    <message>
        <source>Target</source>
        <translation>Цель</translation>
    </message>
    <message>
        <source>The speed cap limits it.</source>
        <translation>Ограничена пределом скорости.</translation>
    </message>
    <message>
        <source>The target is a distance from where the axis stands.</source>
        <translation>Цель — расстояние от места, где стоит ось.</translation>
    </message>
    <message>
        <source>The target is a position.</source>
        <translation>Цель — положение.</translation>
    </message>
    <message>
        <source>Velocity</source>
        <translation>Скорость</translation>
    </message>
    <message>
        <source>Velocity profile of the move</source>
        <translation>Профиль скорости перемещения</translation>
    </message>
    <message>
        <source>already there</source>
        <translation>уже на месте</translation>
    </message>
    <message>
        <source>at cap</source>
        <translation>по пределу</translation>
    </message>
    <message>
        <source>takes %1 s</source>
        <translation>займёт %1 с</translation>
    </message>
</context>
<context>
    <name>camwright::NameDelegate</name>
    <message>
        <source>Name or address</source>
        <translation>Имя или адрес</translation>
    </message>
</context>
<context>
    <name>camwright::NetworkEditor</name>
    <message>
        <source>%1 Mbit/s</source>
        <translation>%1 Мбит/с</translation>
    </message>
    <message>
        <source>%1 kbit/s</source>
        <translation>%1 кбит/с</translation>
    </message>
    <message>
        <source>A drive on the bus and the mechanics behind it</source>
        <translation>Привод на шине и механика за ним</translation>
    </message>
    <message>
        <source>Add</source>
        <translation>Добавить</translation>
    </message>
    <message>
        <source>Add Axis</source>
        <translation>Добавить ось</translation>
    </message>
    <message>
        <source>Add an axis equal to the copied one, with the next number (Ctrl+V)</source>
        <translation>Добавить такую же ось, как скопированная, со следующим номером (Ctrl+V)</translation>
    </message>
    <message>
        <source>Add an axis with default values (Alt+N)</source>
        <translation>Добавить ось со значениями по умолчанию (Alt+N)</translation>
    </message>
    <message>
        <source>All axes</source>
        <translation>Все оси</translation>
    </message>
    <message>
        <source>Apply</source>
        <translation>Применить</translation>
    </message>
    <message>
        <source>Apply and close</source>
        <translation>Применить и закрыть</translation>
    </message>
    <message>
        <source>Axis</source>
        <translation>Ось</translation>
    </message>
    <message>
        <source>Axis List</source>
        <translation>Список осей</translation>
    </message>
    <message>
        <source>Baud rate</source>
        <translation>Скорость передачи</translation>
    </message>
    <message>
        <source>CANopen Master</source>
        <translation>Ведущий CANopen</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Отмена</translation>
    </message>
    <message>
        <source>Change the motion network</source>
        <translation>Изменить сеть движения</translation>
    </message>
    <message>
        <source>Copy</source>
        <translation>Копировать</translation>
    </message>
    <message>
        <source>Copy the selected axis (Ctrl+C)</source>
        <translation>Копировать выбранную ось (Ctrl+C)</translation>
    </message>
    <message>
        <source>Delete</source>
        <translation>Удалить</translation>
    </message>
    <message>
        <source>Delete the selected axis (Del)</source>
        <translation>Удалить выбранную ось (Del)</translation>
    </message>
    <message>
        <source>Drop the Changes</source>
        <translation>Отбросить изменения</translation>
    </message>
    <message>
        <source>Drop what was changed since the last Apply</source>
        <translation>Отбросить изменения после последнего применения</translation>
    </message>
    <message>
        <source>Every axis with its parameters; double-click to edit one</source>
        <translation>Все оси с параметрами; двойной щелчок — правка</translation>
    </message>
    <message>
        <source>Give the axes the numbers 1, 2, 3 … in this order</source>
        <translation>Дать осям номера 1, 2, 3 … в этом порядке</translation>
    </message>
    <message>
        <source>How long the master waits for the answer to a parameter request. A value is proposed on each change of the baud rate.</source>
        <translation>Сколько ведущий ждёт ответа на запрос параметра. При каждой смене скорости предлагается значение.</translation>
    </message>
    <message>
        <source>Motion Network</source>
        <translation>Сеть движения</translation>
    </message>
    <message>
        <source>Must be the same in every node of the bus (KS-MCN)</source>
        <translation>Должна быть одинаковой во всех узлах шины (KS-MCN)</translation>
    </message>
    <message>
        <source>Network</source>
        <translation>Сеть</translation>
    </message>
    <message>
        <source>Not applied yet.</source>
        <translation>Ещё не применено.</translation>
    </message>
    <message>
        <source>Number from 1</source>
        <translation>Нумеровать с 1</translation>
    </message>
    <message>
        <source>OK</source>
        <translation>ОК</translation>
    </message>
    <message>
        <source>Paste</source>
        <translation>Вставить</translation>
    </message>
    <message>
        <source>Put the changes into the project</source>
        <translation>Внести изменения в проект</translation>
    </message>
    <message>
        <source>SDO time-out</source>
        <translation>Тайм-аут SDO</translation>
    </message>
    <message>
        <source>Stay Here</source>
        <translation>Остаться здесь</translation>
    </message>
    <message>
        <source>The controller on the bus of its drives</source>
        <translation>Контроллер на шине своих приводов</translation>
    </message>
    <message>
        <source>The master and its axes</source>
        <translation>Ведущий и его оси</translation>
    </message>
    <message>
        <source>The motion network has changes that were not applied to the project.</source>
        <translation>В сети движения есть изменения, не внесённые в проект.</translation>
    </message>
    <message>
        <source>Unapplied Changes</source>
        <translation>Неприменённые изменения</translation>
    </message>
    <message>
        <source>ms</source>
        <translation>мс</translation>
    </message>
</context>
<context>
    <name>camwright::NewProjectDialog</name>
    <message>
        <source>&quot;%1&quot; is already there. Choose another name or folder.</source>
        <translation>«%1» уже существует. Выберите другое имя или папку.</translation>
    </message>
    <message>
        <source>%1 inputs, %2 outputs</source>
        <translation>входов: %1, выходов: %2</translation>
    </message>
    <message numerus="yes">
        <source>%n CAN ports</source>
        <translation>
            <numerusform>%n порт CAN</numerusform>
            <numerusform>%n порта CAN</numerusform>
            <numerusform>%n портов CAN</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n Ethernet ports</source>
        <translation>
            <numerusform>%n порт Ethernet</numerusform>
            <numerusform>%n порта Ethernet</numerusform>
            <numerusform>%n портов Ethernet</numerusform>
        </translation>
    </message>
    <message>
        <source>Also the name of its folder.</source>
        <translation>Оно же имя его папки.</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Отмена</translation>
    </message>
    <message>
        <source>Choose a folder</source>
        <translation>Выбрать папку</translation>
    </message>
    <message>
        <source>Controller family</source>
        <translation>Семейство контроллеров</translation>
    </message>
    <message>
        <source>Create Project</source>
        <translation>Создать проект</translation>
    </message>
    <message>
        <source>Create project</source>
        <translation>Создать проект</translation>
    </message>
    <message>
        <source>Family</source>
        <translation>Семейство</translation>
    </message>
    <message>
        <source>Folder</source>
        <translation>Папка</translation>
    </message>
    <message>
        <source>Folder for the New Project</source>
        <translation>Папка для нового проекта</translation>
    </message>
    <message>
        <source>In folder</source>
        <translation>В папке</translation>
    </message>
    <message>
        <source>Model</source>
        <translation>Модель</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Имя</translation>
    </message>
    <message>
        <source>New Project</source>
        <translation>Новый проект</translation>
    </message>
    <message>
        <source>Project name</source>
        <translation>Имя проекта</translation>
    </message>
    <message>
        <source>The name becomes a folder&apos;s: it cannot hold &quot;/&quot; or begin with a dot.</source>
        <translation>Имя станет именем папки: в нём не может быть «/», и оно не начинается с точки.</translation>
    </message>
    <message>
        <source>The project needs a name.</source>
        <translation>Проекту нужно имя.</translation>
    </message>
    <message>
        <source>The project&apos;s own folder is made inside it.</source>
        <translation>Папка проекта создаётся внутри неё.</translation>
    </message>
    <message>
        <source>machine</source>
        <translation>машина</translation>
    </message>
    <message numerus="yes">
        <source>up to %n axes</source>
        <translation>
            <numerusform>до %n оси</numerusform>
            <numerusform>до %n осей</numerusform>
            <numerusform>до %n осей</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>camwright::NoticeBar</name>
    <message>
        <source>Close the message</source>
        <translation>Закрыть сообщение</translation>
    </message>
    <message>
        <source>Message</source>
        <translation>Сообщение</translation>
    </message>
</context>
<context>
    <name>camwright::OutputPanel</name>
    <message>
        <source>Nothing was built or downloaded yet.</source>
        <translation>Ничего ещё не собиралось и не загружалось.</translation>
    </message>
    <message>
        <source>Output</source>
        <translation>Вывод</translation>
    </message>
    <message>
        <source>What checks, builds and downloads said.</source>
        <translation>Что сообщили проверки, сборки и загрузки.</translation>
    </message>
</context>
<context>
    <name>camwright::Palette</name>
    <message>
        <source>Found</source>
        <translation>Найденное</translation>
    </message>
</context>
<context>
    <name>camwright::PanelControl</name>
    <message>
        <source>%1 has taken control. Panel control is off.</source>
        <translation>Управление перешло к %1. Управление с панели отключено.</translation>
    </message>
    <message>
        <source>Arm panel control first.</source>
        <translation>Сначала взведите управление с панели.</translation>
    </message>
    <message>
        <source>Control was lost. Panel control is off.</source>
        <translation>Управление потеряно. Управление с панели отключено.</translation>
    </message>
    <message>
        <source>Enable the axis first.</source>
        <translation>Сначала включите ось.</translation>
    </message>
    <message>
        <source>Go online to move this axis.</source>
        <translation>Подключитесь, чтобы двигать эту ось.</translation>
    </message>
    <message>
        <source>The axis has an error. Remove its cause, then reset it.</source>
        <translation>У оси ошибка. Устраните причину, затем сбросьте её.</translation>
    </message>
    <message>
        <source>The controller has ended panel control of this axis. Arm it again to go on.</source>
        <translation>Контроллер прекратил управление этой осью с панели. Взведите снова, чтобы продолжить.</translation>
    </message>
    <message>
        <source>The drive is not on the bus.</source>
        <translation>Привода нет на шине.</translation>
    </message>
</context>
<context>
    <name>camwright::ProblemsModel</name>
    <message>
        <source>Code</source>
        <translation>Код</translation>
    </message>
    <message>
        <source>Place</source>
        <translation>Место</translation>
    </message>
    <message>
        <source>Problem</source>
        <translation>Проблема</translation>
    </message>
</context>
<context>
    <name>camwright::ProblemsView</name>
    <message>
        <source>Copy</source>
        <translation>Копировать</translation>
    </message>
    <message>
        <source>Go to Its Place</source>
        <translation>Перейти к месту</translation>
    </message>
    <message>
        <source>No problems. Checks run as you type.</source>
        <translation>Проблем нет. Проверка идёт по мере ввода.</translation>
    </message>
    <message>
        <source>Problems</source>
        <translation>Проблемы</translation>
    </message>
    <message>
        <source>What is wrong with the project. Enter goes to the place, F1 explains the message, and a lamp tells that there is a quick fix.</source>
        <translation>Что не так в проекте. Enter переходит к месту, F1 объясняет сообщение, а лампочка означает, что есть быстрое исправление.</translation>
    </message>
</context>
<context>
    <name>camwright::ProgramEditor</name>
    <message>
        <source>&quot;%1&quot; cannot be read: %2.</source>
        <translation>«%1» не удаётся прочитать: %2.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; has no definition in this project.</source>
        <translation>У «%1» нет определения в этом проекте.</translation>
    </message>
    <message numerus="yes">
        <source>%n place(s) replaced. Ctrl+Z takes them back.</source>
        <translation>
            <numerusform>Заменено: %n место. Ctrl+Z вернёт как было.</numerusform>
            <numerusform>Заменено: %n места. Ctrl+Z вернёт как было.</numerusform>
            <numerusform>Заменено: %n мест. Ctrl+Z вернёт как было.</numerusform>
        </translation>
    </message>
    <message>
        <source>Clean the Pasted Text</source>
        <translation>Очистить вставленный текст</translation>
    </message>
    <message>
        <source>Import Kinco Program Text</source>
        <translation>Импорт текста программы Kinco</translation>
    </message>
    <message>
        <source>Keep It</source>
        <translation>Оставить как есть</translation>
    </message>
    <message>
        <source>KincoBuilder programs (*.ilp *.il *.txt);;All files (*)</source>
        <translation>Программы KincoBuilder (*.ilp *.il *.txt);;Все файлы (*)</translation>
    </message>
    <message>
        <source>Program</source>
        <translation>Программа</translation>
    </message>
    <message>
        <source>Program text</source>
        <translation>Текст программы</translation>
    </message>
    <message numerus="yes">
        <source>The pasted text has marks of a document, not of a program: %n place(s). It can be cleaned.</source>
        <translation>
            <numerusform>Во вставленном тексте есть знаки документа, а не программы: %n место. Его можно очистить.</numerusform>
            <numerusform>Во вставленном тексте есть знаки документа, а не программы: %n места. Его можно очистить.</numerusform>
            <numerusform>Во вставленном тексте есть знаки документа, а не программы: %n мест. Его можно очистить.</numerusform>
        </translation>
    </message>
    <message>
        <source>The program was replaced by the text of &quot;%1&quot;. Ctrl+Z takes it back.</source>
        <translation>Программа заменена текстом из «%1». Ctrl+Z вернёт прежнюю.</translation>
    </message>
    <message>
        <source>line %1, column %2</source>
        <translation>строка %1, столбец %2</translation>
    </message>
</context>
<context>
    <name>camwright::ProjectDocument</name>
    <message>
        <source>Reload from disk</source>
        <translation>Перечитать с диска</translation>
    </message>
    <message>
        <source>Restore unsaved edits</source>
        <translation>Восстановить несохранённые правки</translation>
    </message>
</context>
<context>
    <name>camwright::ProjectPanel</name>
    <message>
        <source>Add Axis</source>
        <translation>Добавить ось</translation>
    </message>
    <message>
        <source>Add Network</source>
        <translation>Добавить сеть</translation>
    </message>
    <message>
        <source>Add Program</source>
        <translation>Добавить программу</translation>
    </message>
    <message>
        <source>Add Variable Table</source>
        <translation>Добавить таблицу переменных</translation>
    </message>
    <message>
        <source>Add Watch List</source>
        <translation>Добавить список наблюдения</translation>
    </message>
    <message>
        <source>Closes all sections of the tree.</source>
        <translation>Сворачивает все разделы дерева.</translation>
    </message>
    <message>
        <source>Collapse all</source>
        <translation>Свернуть всё</translation>
    </message>
    <message>
        <source>Delete</source>
        <translation>Удалить</translation>
    </message>
    <message>
        <source>Duplicate</source>
        <translation>Дублировать</translation>
    </message>
    <message>
        <source>ERROR</source>
        <translation>ОШИБКА</translation>
    </message>
    <message>
        <source>Filter</source>
        <translation>Фильтр</translation>
    </message>
    <message>
        <source>Filter the project</source>
        <translation>Фильтр проекта</translation>
    </message>
    <message>
        <source>Name contains</source>
        <translation>Имя содержит</translation>
    </message>
    <message>
        <source>Open %1</source>
        <translation>Открыть %1</translation>
    </message>
    <message>
        <source>Project</source>
        <translation>Проект</translation>
    </message>
    <message>
        <source>Rename</source>
        <translation>Переименовать</translation>
    </message>
    <message>
        <source>Shows only objects whose name contains a word.</source>
        <translation>Показывает только объекты, в имени которых есть слово.</translation>
    </message>
</context>
<context>
    <name>camwright::ProjectTreeModel</name>
    <message>
        <source>Axes</source>
        <translation>Оси</translation>
    </message>
    <message>
        <source>Controller</source>
        <translation>Контроллер</translation>
    </message>
    <message>
        <source>Networks</source>
        <translation>Сети</translation>
    </message>
    <message>
        <source>Programs</source>
        <translation>Программы</translation>
    </message>
    <message>
        <source>Project</source>
        <translation>Проект</translation>
    </message>
    <message>
        <source>Variables</source>
        <translation>Переменные</translation>
    </message>
    <message>
        <source>Watch lists</source>
        <translation>Списки наблюдения</translation>
    </message>
    <message>
        <source>none</source>
        <translation>нет</translation>
    </message>
</context>
<context>
    <name>camwright::QuantityField</name>
    <message>
        <source> of %1</source>
        <translation> (единица — %1)</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is not a number%2.</source>
        <translation>«%1» не число%2.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is not a whole number%2.</source>
        <translation>«%1» не целое число%2.</translation>
    </message>
    <message>
        <source>%1 in %2</source>
        <translation>%1, %2</translation>
    </message>
    <message>
        <source>%1: return to the default</source>
        <translation>%1: вернуть значение по умолчанию</translation>
    </message>
    <message>
        <source>Above the range %1 to %2%3.</source>
        <translation>Выше диапазона от %1 до %2%3.</translation>
    </message>
    <message>
        <source>At least %1%2.</source>
        <translation>Не меньше %1%2.</translation>
    </message>
    <message>
        <source>At most %1%2.</source>
        <translation>Не больше %1%2.</translation>
    </message>
    <message>
        <source>Below the range %1 to %2%3.</source>
        <translation>Ниже диапазона от %1 до %2%3.</translation>
    </message>
    <message>
        <source>Default: %1 %2</source>
        <translation>По умолчанию: %1 %2</translation>
    </message>
    <message>
        <source>Differs from the default %1 %2. Click to return to it.</source>
        <translation>Отличается от значения по умолчанию %1 %2. Щелчок вернёт его.</translation>
    </message>
    <message>
        <source>Range: %1 to %2 %3</source>
        <translation>Диапазон: от %1 до %2 %3</translation>
    </message>
</context>
<context>
    <name>camwright::Readings</name>
    <message>
        <source>%1/s</source>
        <translation>%1/с</translation>
    </message>
    <message>
        <source>Actual Position</source>
        <translation>Фактическое положение</translation>
    </message>
    <message>
        <source>Actual position</source>
        <translation>Фактическое положение</translation>
    </message>
    <message>
        <source>Following error</source>
        <translation>Ошибка слежения</translation>
    </message>
    <message>
        <source>Largest values since the last reset. Click to begin again.</source>
        <translation>Наибольшие значения с последнего сброса. Щелчок начинает заново.</translation>
    </message>
    <message>
        <source>Position of the load as the drive measures it</source>
        <translation>Положение нагрузки по измерению привода</translation>
    </message>
    <message>
        <source>Position, stopping distance and target between the limits</source>
        <translation>Положение, тормозной путь и цель между пределами</translation>
    </message>
    <message>
        <source>Reset the peaks</source>
        <translation>Сбросить пики</translation>
    </message>
    <message>
        <source>Set position</source>
        <translation>Заданное положение</translation>
    </message>
    <message>
        <source>To target</source>
        <translation>До цели</translation>
    </message>
    <message>
        <source>Torque</source>
        <translation>Момент</translation>
    </message>
    <message>
        <source>Travel</source>
        <translation>Ход</translation>
    </message>
    <message>
        <source>Velocity</source>
        <translation>Скорость</translation>
    </message>
    <message>
        <source>disabled</source>
        <translation>выключена</translation>
    </message>
    <message>
        <source>error</source>
        <translation>ошибка</translation>
    </message>
    <message>
        <source>homed</source>
        <translation>ноль найден</translation>
    </message>
    <message>
        <source>moving +</source>
        <translation>движется +</translation>
    </message>
    <message>
        <source>moving −</source>
        <translation>движется −</translation>
    </message>
    <message>
        <source>not homed</source>
        <translation>ноль не найден</translation>
    </message>
    <message>
        <source>now</source>
        <translation>сейчас</translation>
    </message>
    <message>
        <source>peak</source>
        <translation>пик</translation>
    </message>
    <message>
        <source>standing</source>
        <translation>стоит</translation>
    </message>
    <message>
        <source>stops within %1 %2</source>
        <translation>остановится за %1 %2</translation>
    </message>
</context>
<context>
    <name>camwright::RecentList</name>
    <message numerus="yes">
        <source>%n errors</source>
        <translation>
            <numerusform>%n ошибка</numerusform>
            <numerusform>%n ошибки</numerusform>
            <numerusform>%n ошибок</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n warnings</source>
        <translation>
            <numerusform>%n предупреждение</numerusform>
            <numerusform>%n предупреждения</numerusform>
            <numerusform>%n предупреждений</numerusform>
        </translation>
    </message>
    <message>
        <source>Controller</source>
        <translation>Контроллер</translation>
    </message>
    <message>
        <source>Last state</source>
        <translation>Последнее состояние</translation>
    </message>
    <message>
        <source>Open</source>
        <translation>Открыть</translation>
    </message>
    <message>
        <source>Opened</source>
        <translation>Открыт</translation>
    </message>
    <message>
        <source>Project</source>
        <translation>Проект</translation>
    </message>
    <message>
        <source>Ran on the virtual controller</source>
        <translation>Работал на виртуальном контроллере</translation>
    </message>
    <message>
        <source>Recent projects</source>
        <translation>Недавние проекты</translation>
    </message>
    <message>
        <source>Remove From This List</source>
        <translation>Убрать из этого списка</translation>
    </message>
    <message>
        <source>Same program on %1</source>
        <translation>Та же программа на %1</translation>
    </message>
    <message>
        <source>Saved, no problems</source>
        <translation>Сохранён, проблем нет</translation>
    </message>
    <message>
        <source>Today %1</source>
        <translation>Сегодня %1</translation>
    </message>
    <message>
        <source>Unsaved edits kept, opening restores them</source>
        <translation>Несохранённые правки целы, при открытии восстановятся</translation>
    </message>
    <message>
        <source>Yesterday</source>
        <translation>Вчера</translation>
    </message>
</context>
<context>
    <name>camwright::ReferencesModel</name>
    <message>
        <source>%1, network %2, line %3</source>
        <translation>%1, сеть %2, строка %3</translation>
    </message>
    <message>
        <source>%1, overlaps as %2</source>
        <translation>%1, пересекается как %2</translation>
    </message>
    <message>
        <source>%1, row %2</source>
        <translation>%1, строка %2</translation>
    </message>
    <message>
        <source>Text</source>
        <translation>Текст</translation>
    </message>
    <message>
        <source>Use</source>
        <translation>Использование</translation>
    </message>
    <message>
        <source>Where</source>
        <translation>Где</translation>
    </message>
    <message>
        <source>calls</source>
        <translation>вызывает</translation>
    </message>
    <message>
        <source>commands</source>
        <translation>управляет</translation>
    </message>
    <message>
        <source>declares</source>
        <translation>объявляет</translation>
    </message>
    <message>
        <source>reads</source>
        <translation>читает</translation>
    </message>
    <message>
        <source>reads and writes</source>
        <translation>читает и пишет</translation>
    </message>
    <message>
        <source>watches</source>
        <translation>наблюдает</translation>
    </message>
    <message>
        <source>writes</source>
        <translation>пишет</translation>
    </message>
</context>
<context>
    <name>camwright::ReferencesPanel</name>
    <message>
        <source>&quot;%1&quot; is no variable, address, axis or subroutine.</source>
        <translation>«%1» — не переменная, не адрес, не ось и не подпрограмма.</translation>
    </message>
    <message>
        <source>%1: read %2, written %3, overlaps %4</source>
        <translation>%1: чтений %2, записей %3, пересечений %4</translation>
    </message>
    <message>
        <source>Nothing uses %1.</source>
        <translation>%1 нигде не используется.</translation>
    </message>
    <message>
        <source>References</source>
        <translation>Использования</translation>
    </message>
    <message>
        <source>Shift+F12 at a name or an address lists where it is used.</source>
        <translation>Shift+F12 на имени или адресе показывает, где они используются.</translation>
    </message>
    <message>
        <source>Where the thing is used. Enter goes to the place, Esc back to where you asked.</source>
        <translation>Где это используется. Enter переходит к месту, Esc возвращает туда, откуда был запрос.</translation>
    </message>
</context>
<context>
    <name>camwright::ScopePlot</name>
    <message>
        <source>Curves of the recording</source>
        <translation>Кривые записи</translation>
    </message>
    <message>
        <source>Drag to zoom, wheel to zoom time, Shift and drag to move, double-click to fit; drag a cursor to measure.</source>
        <translation>Перетаскивание — увеличение, колесо — масштаб времени, Shift и перетаскивание — сдвиг, двойной щелчок — вся запись; для измерения перетащите курсор.</translation>
    </message>
</context>
<context>
    <name>camwright::ScreenWatch</name>
    <message>
        <source>The computer goes to sleep. Panel control is off.</source>
        <translation>Компьютер переходит в сон. Управление с панели отключено.</translation>
    </message>
    <message>
        <source>The computer was asleep. Panel control is off.</source>
        <translation>Компьютер был в режиме сна. Управление с панели отключено.</translation>
    </message>
    <message>
        <source>The screen was locked. Panel control is off.</source>
        <translation>Экран заблокирован. Управление с панели отключено.</translation>
    </message>
</context>
<context>
    <name>camwright::SettingsDialog</name>
    <message>
        <source>Close</source>
        <translation>Закрыть</translation>
    </message>
    <message>
        <source>Dark</source>
        <translation>Тёмная</translation>
    </message>
    <message>
        <source>Follows the desktop.</source>
        <translation>Как на рабочем столе.</translation>
    </message>
    <message>
        <source>General</source>
        <translation>Общие</translation>
    </message>
    <message>
        <source>Keys</source>
        <translation>Клавиши</translation>
    </message>
    <message>
        <source>Language</source>
        <translation>Язык</translation>
    </message>
    <message>
        <source>Light</source>
        <translation>Светлая</translation>
    </message>
    <message>
        <source>Of the window, the messages and the help of instructions. Switches at once.</source>
        <translation>Язык окна, сообщений и справки по инструкциям. Переключается сразу.</translation>
    </message>
    <message>
        <source>Pages of the settings</source>
        <translation>Страницы настроек</translation>
    </message>
    <message>
        <source>Settings</source>
        <translation>Настройки</translation>
    </message>
    <message>
        <source>System</source>
        <translation>Системная</translation>
    </message>
    <message>
        <source>Theme</source>
        <translation>Тема</translation>
    </message>
</context>
<context>
    <name>camwright::StartPage</name>
    <message>
        <source>Add a CANopen drive</source>
        <translation>Добавить привод CANopen</translation>
    </message>
    <message>
        <source>Addresses, the download plan, who has control. 8 minutes</source>
        <translation>Адреса, план загрузки, у кого управление. 8 минут</translation>
    </message>
    <message>
        <source>An axis of the motion network and its fields. 10 minutes</source>
        <translation>Ось сети движения и её поля. 10 минут</translation>
    </message>
    <message>
        <source>Camwright&apos;s own controller on this or another PC.</source>
        <translation>Собственный контроллер Camwright на этом или другом компьютере.</translation>
    </message>
    <message>
        <source>Compact controller with up to 32 CANopen axes.</source>
        <translation>Компактный контроллер, до 32 осей CANopen.</translation>
    </message>
    <message>
        <source>Enable, home and jog a simulated drive. 5 minutes</source>
        <translation>Включение, выход в ноль и толчковый режим моделируемого привода. 5 минут</translation>
    </message>
    <message>
        <source>Enter</source>
        <translation>Enter</translation>
    </message>
    <message>
        <source>Go online</source>
        <translation>Подключение к контроллеру</translation>
    </message>
    <message>
        <source>Hold jog: the axis moves</source>
        <translation>Толчок: ось движется</translation>
    </message>
    <message>
        <source>Instructions, variables, watch and force. 10 minutes</source>
        <translation>Инструкции, переменные, наблюдение и форсирование. 10 минут</translation>
    </message>
    <message>
        <source>Learn</source>
        <translation>Обучение</translation>
    </message>
    <message>
        <source>Logic of the DL205 in instruction list; I-boxes are checked only.</source>
        <translation>Логика DL205 на списке команд; блоки I-box только проверяются.</translation>
    </message>
    <message>
        <source>Logic of the TS600 in instruction list, with its timers and counters.</source>
        <translation>Логика TS600 в списке инструкций, с таймерами и счётчиками.</translation>
    </message>
    <message>
        <source>Move an axis for the first time</source>
        <translation>Первое движение оси</translation>
    </message>
    <message>
        <source>New project</source>
        <translation>Новый проект</translation>
    </message>
    <message>
        <source>Not in this version.</source>
        <translation>В этой версии нет.</translation>
    </message>
    <message>
        <source>Open</source>
        <translation>Открыть</translation>
    </message>
    <message>
        <source>Open a folder</source>
        <translation>Открыть папку</translation>
    </message>
    <message>
        <source>Open the demo machine</source>
        <translation>Открыть демомашину</translation>
    </message>
    <message>
        <source>Opens a machine with two simulated axes and connects to its virtual controller.</source>
        <translation>Открывает машину с двумя моделируемыми осями и подключается к её виртуальному контроллеру.</translation>
    </message>
    <message>
        <source>Opens a project folder (Ctrl+O).</source>
        <translation>Открывает папку проекта (Ctrl+O).</translation>
    </message>
    <message>
        <source>Projects you open are listed here with the state they were left in.</source>
        <translation>Здесь перечислены открывавшиеся проекты и состояние, в котором они оставлены.</translation>
    </message>
    <message>
        <source>Recent projects</source>
        <translation>Недавние проекты</translation>
    </message>
    <message>
        <source>Run</source>
        <translation>Пуск</translation>
    </message>
    <message>
        <source>Soft controller</source>
        <translation>Программный контроллер</translation>
    </message>
    <message>
        <source>Two simulated drives on a Kinco KS101M: Feed pushes the strip, Turn indexes it. Nothing real moves.</source>
        <translation>Два моделируемых привода на Kinco KS101M: Feed подаёт полосу, Turn её поворачивает. Ничего настоящего не движется.</translation>
    </message>
    <message>
        <source>Virtual terminals</source>
        <translation>Виртуальные клеммы</translation>
    </message>
    <message>
        <source>Write and run a program</source>
        <translation>Написать и запустить программу</translation>
    </message>
</context>
<context>
    <name>camwright::StateDiagram</name>
    <message>
        <source>Moving</source>
        <translation>Движение</translation>
    </message>
    <message>
        <source>Stop, done</source>
        <translation>стоп, конец</translation>
    </message>
    <message>
        <source>any fault</source>
        <translation>любой отказ</translation>
    </message>
    <message>
        <source>power</source>
        <translation>питание</translation>
    </message>
    <message>
        <source>reset, off</source>
        <translation>сброс, выкл.</translation>
    </message>
    <message>
        <source>reset, on</source>
        <translation>сброс, вкл.</translation>
    </message>
</context>
<context>
    <name>camwright::StateView</name>
    <message>
        <source>%1 h ago</source>
        <translation>%1 ч назад</translation>
    </message>
    <message>
        <source>%1 min ago</source>
        <translation>%1 мин назад</translation>
    </message>
    <message>
        <source>%1 s ago</source>
        <translation>%1 с назад</translation>
    </message>
    <message>
        <source>%1, %2</source>
        <translation>%1, %2</translation>
    </message>
    <message>
        <source>Axis State</source>
        <translation>Состояние оси</translation>
    </message>
    <message>
        <source>Axis state</source>
        <translation>Состояние оси</translation>
    </message>
    <message>
        <source>States of the axis; the lit one is the current one</source>
        <translation>Состояния оси; светится текущее</translation>
    </message>
    <message>
        <source>no change since the controller started</source>
        <translation>без изменений с запуска контроллера</translation>
    </message>
    <message>
        <source>state %1</source>
        <translation>состояние %1</translation>
    </message>
</context>
<context>
    <name>camwright::StatusLine</name>
    <message>
        <source>%1 (read only)</source>
        <translation>%1 (только чтение)</translation>
    </message>
    <message>
        <source>%1, not saved</source>
        <translation>%1, не сохранён</translation>
    </message>
    <message numerus="yes">
        <source>%n errors</source>
        <translation>
            <numerusform>%n ошибка</numerusform>
            <numerusform>%n ошибки</numerusform>
            <numerusform>%n ошибок</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n warnings</source>
        <translation>
            <numerusform>%n предупреждение</numerusform>
            <numerusform>%n предупреждения</numerusform>
            <numerusform>%n предупреждений</numerusform>
        </translation>
    </message>
    <message>
        <source>CONNECTING</source>
        <translation>СОЕДИНЕНИЕ</translation>
    </message>
    <message>
        <source>Camwright %1</source>
        <translation>Camwright %1</translation>
    </message>
    <message>
        <source>ERROR</source>
        <translation>ОШИБКА</translation>
    </message>
    <message>
        <source>LOST</source>
        <translation>СВЯЗЬ ПОТЕРЯНА</translation>
    </message>
    <message>
        <source>Longest scan %1 ms</source>
        <translation>Самый долгий цикл %1 мс</translation>
    </message>
    <message>
        <source>No project open</source>
        <translation>Проект не открыт</translation>
    </message>
    <message>
        <source>OFFLINE</source>
        <translation>НЕ В СЕТИ</translation>
    </message>
    <message>
        <source>building</source>
        <translation>сборка</translation>
    </message>
    <message>
        <source>built</source>
        <translation>собрано</translation>
    </message>
    <message>
        <source>bus %1 %</source>
        <translation>шина %1 %</translation>
    </message>
    <message>
        <source>control: %1</source>
        <translation>управление: %1</translation>
    </message>
    <message>
        <source>control: nobody</source>
        <translation>управление: никто</translation>
    </message>
    <message>
        <source>control: you</source>
        <translation>управление: вы</translation>
    </message>
    <message>
        <source>forces %1</source>
        <translation>форсировано %1</translation>
    </message>
    <message>
        <source>not built since the last edit</source>
        <translation>не собрано после последней правки</translation>
    </message>
    <message>
        <source>program differs ≠</source>
        <translation>программа отличается ≠</translation>
    </message>
    <message>
        <source>program same ✓</source>
        <translation>программа та же ✓</translation>
    </message>
    <message>
        <source>scan %1 ms</source>
        <translation>цикл %1 мс</translation>
    </message>
</context>
<context>
    <name>camwright::StopButton</name>
    <message>
        <source>STOP</source>
        <translation>СТОП</translation>
    </message>
    <message>
        <source>all axes</source>
        <translation>все оси</translation>
    </message>
</context>
<context>
    <name>camwright::TerminalLamp</name>
    <message>
        <source>%1, off</source>
        <translation>%1, выкл.</translation>
    </message>
    <message>
        <source>%1, on</source>
        <translation>%1, вкл.</translation>
    </message>
    <message>
        <source>Input %1. Click to switch it on or off; it stays until clicked again.</source>
        <translation>Вход %1. Щелчок включает или выключает его; так остаётся до следующего щелчка.</translation>
    </message>
    <message>
        <source>Output %1.</source>
        <translation>Выход %1.</translation>
    </message>
</context>
<context>
    <name>camwright::TerminalsPanel</name>
    <message>
        <source>A real controller&apos;s inputs are wired. Force a value in the watch table instead.</source>
        <translation>Входы настоящего контроллера подключены проводами. Форсируйте значение в списке наблюдения.</translation>
    </message>
    <message>
        <source>Go online with the virtual controller to switch its inputs and see its outputs.</source>
        <translation>Подключитесь к виртуальному контроллеру, чтобы переключать его входы и видеть выходы.</translation>
    </message>
    <message>
        <source>Inputs</source>
        <translation>Входы</translation>
    </message>
    <message>
        <source>Inputs and Outputs</source>
        <translation>Входы и выходы</translation>
    </message>
    <message>
        <source>Outputs</source>
        <translation>Выходы</translation>
    </message>
    <message>
        <source>The controller has no program yet. Download one to see its terminals.</source>
        <translation>В контроллере пока нет программы. Загрузите её, чтобы увидеть клеммы.</translation>
    </message>
    <message>
        <source>click to switch</source>
        <translation>щелчок переключает</translation>
    </message>
</context>
<context>
    <name>camwright::ToolRow</name>
    <message>
        <source>&lt;b&gt;Controller&apos;s address&lt;/b&gt;&lt;br&gt;local: the virtual controller of this project. tcp://HOST[:PORT]: a controller on the network.</source>
        <translation>&lt;b&gt;Адрес контроллера&lt;/b&gt;&lt;br&gt;local: виртуальный контроллер этого проекта. tcp://HOST[:PORT]: контроллер в сети.</translation>
    </message>
    <message>
        <source>Controller&apos;s address</source>
        <translation>Адрес контроллера</translation>
    </message>
    <message>
        <source>Find anything</source>
        <translation>Найти что угодно</translation>
    </message>
    <message>
        <source>Online</source>
        <translation>Связь</translation>
    </message>
    <message>
        <source>local · virtual controller</source>
        <translation>local · виртуальный</translation>
    </message>
    <message>
        <source>no controller</source>
        <translation>нет контроллера</translation>
    </message>
</context>
<context>
    <name>camwright::TracePanel</name>
    <message>
        <source>   RMS %1   slope %2 %3/s</source>
        <translation>   СКЗ %1   наклон %2 %3/с</translation>
    </message>
    <message>
        <source>&quot;%1&quot; cannot be written: %2. Choose another folder.</source>
        <translation>«%1» не удаётся записать: %2. Выберите другую папку.</translation>
    </message>
    <message>
        <source>%1   A %2   B %3   Δt %4 s</source>
        <translation>%1   A %2   B %3   Δt %4 с</translation>
    </message>
    <message>
        <source>%1   A %2   B %3   Δt %4 s   Δy %5 %6   min %7   max %8   mean %9</source>
        <translation>%1   A %2   B %3   Δt %4 с   Δy %5 %6   мин %7   макс %8   сред %9</translation>
    </message>
    <message>
        <source>%1 samples</source>
        <translation>отсчётов: %1</translation>
    </message>
    <message>
        <source>A lane for each channel</source>
        <translation>Каждому каналу своя полоса</translation>
    </message>
    <message>
        <source>Add a channel</source>
        <translation>Добавить канал</translation>
    </message>
    <message>
        <source>Add a channel or choose a preset, then press Record to see it in every motion cycle.</source>
        <translation>Добавьте канал или выберите набор, затем нажмите «Запись», чтобы видеть значения в каждом цикле движения.</translation>
    </message>
    <message>
        <source>Address, variable or axis value like axis.Feed.position; Enter adds it</source>
        <translation>Адрес, переменная или значение оси, например axis.Feed.position; Enter добавляет</translation>
    </message>
    <message>
        <source>All channels in one lane</source>
        <translation>Все каналы в одной полосе</translation>
    </message>
    <message>
        <source>Arrangement</source>
        <translation>Расположение</translation>
    </message>
    <message>
        <source>CSV files (*.csv)</source>
        <translation>Файлы CSV (*.csv)</translation>
    </message>
    <message>
        <source>CSV...</source>
        <translation>CSV...</translation>
    </message>
    <message>
        <source>Channels</source>
        <translation>Каналы</translation>
    </message>
    <message>
        <source>End</source>
        <translation>Закончить</translation>
    </message>
    <message>
        <source>Export as CSV</source>
        <translation>Экспорт в CSV</translation>
    </message>
    <message>
        <source>Export the Recording</source>
        <translation>Экспорт записи</translation>
    </message>
    <message>
        <source>Fills in the channels that belong together</source>
        <translation>Добавляет каналы, которые относятся друг к другу</translation>
    </message>
    <message>
        <source>Fit</source>
        <translation>Вся запись</translation>
    </message>
    <message>
        <source>Go online, then press Record to see the channels in every motion cycle.</source>
        <translation>Подключитесь и нажмите «Запись», чтобы видеть каналы в каждом цикле движения.</translation>
    </message>
    <message>
        <source>Live</source>
        <translation>Слежение</translation>
    </message>
    <message>
        <source>Move of %1</source>
        <translation>Движение %1</translation>
    </message>
    <message>
        <source>Oscilloscope</source>
        <translation>Осциллограф</translation>
    </message>
    <message>
        <source>Overlaid</source>
        <translation>Вместе</translation>
    </message>
    <message>
        <source>Pause</source>
        <translation>Пауза</translation>
    </message>
    <message>
        <source>Preset</source>
        <translation>Набор</translation>
    </message>
    <message>
        <source>Press Record to see the channels in every motion cycle.</source>
        <translation>Нажмите «Запись», чтобы видеть каналы в каждом цикле движения.</translation>
    </message>
    <message>
        <source>Record</source>
        <translation>Запись</translation>
    </message>
    <message>
        <source>Record, then drag the two cursors to measure.</source>
        <translation>Сделайте запись, затем перетащите два курсора для измерения.</translation>
    </message>
    <message>
        <source>Show the whole recording (double-click in the curves)</source>
        <translation>Показать запись целиком (двойной щелчок на кривых)</translation>
    </message>
    <message>
        <source>Stacked</source>
        <translation>Друг под другом</translation>
    </message>
    <message>
        <source>Start or end a recording of the channels</source>
        <translation>Начать или закончить запись каналов</translation>
    </message>
    <message>
        <source>The curves appear as soon as the recording has samples.</source>
        <translation>Кривые появятся, как только в записи будут отсчёты.</translation>
    </message>
    <message>
        <source>The newest samples stay in view</source>
        <translation>Новейшие отсчёты остаются на виду</translation>
    </message>
    <message>
        <source>The recording is in &quot;%1&quot;.</source>
        <translation>Запись сохранена в «%1».</translation>
    </message>
    <message>
        <source>The view stays; the recording goes on</source>
        <translation>Вид стоит на месте; запись продолжается</translation>
    </message>
    <message>
        <source>What is recorded; the mark shows or hides a curve</source>
        <translation>Что записывается; отметка показывает или скрывает кривую</translation>
    </message>
    <message>
        <source>Write the recording to a CSV file</source>
        <translation>Записать в файл CSV</translation>
    </message>
    <message>
        <source>offline</source>
        <translation>не в сети</translation>
    </message>
    <message>
        <source>ready</source>
        <translation>готово</translation>
    </message>
    <message>
        <source>recording, %1 samples</source>
        <translation>запись, отсчётов: %1</translation>
    </message>
    <message>
        <source>waiting</source>
        <translation>ожидание</translation>
    </message>
</context>
<context>
    <name>camwright::TransmissionView</name>
    <message>
        <source>%1 mm per motor turn</source>
        <translation>%1 мм на оборот двигателя</translation>
    </message>
    <message>
        <source>%1 pulses per turn</source>
        <translation>%1 имп. на оборот</translation>
    </message>
    <message>
        <source>%1 pulses ÷ %2 %4 = %3 pulses/%4</source>
        <translation>%1 имп. ÷ %2 %4 = %3 имп./%4</translation>
    </message>
    <message>
        <source>%1° per motor turn</source>
        <translation>%1° на оборот двигателя</translation>
    </message>
    <message>
        <source>Drawing of motor and load</source>
        <translation>Рисунок двигателя и нагрузки</translation>
    </message>
    <message>
        <source>mm</source>
        <translation>мм</translation>
    </message>
    <message>
        <source>mm per motor turn ?</source>
        <translation>мм на оборот двигателя ?</translation>
    </message>
    <message>
        <source>pulses per turn ?</source>
        <translation>имп. на оборот ?</translation>
    </message>
    <message>
        <source>°</source>
        <translation>°</translation>
    </message>
    <message>
        <source>° per motor turn ?</source>
        <translation>° на оборот двигателя ?</translation>
    </message>
</context>
<context>
    <name>camwright::TravelBar</name>
    <message>
        <source>target %1</source>
        <translation>цель %1</translation>
    </message>
</context>
<context>
    <name>camwright::TriggerBar</name>
    <message>
        <source>%</source>
        <translation>%</translation>
    </message>
    <message>
        <source>Above level</source>
        <translation>Выше уровня</translation>
    </message>
    <message>
        <source>At once, live</source>
        <translation>Непрерывно</translation>
    </message>
    <message>
        <source>Below level</source>
        <translation>Ниже уровня</translation>
    </message>
    <message>
        <source>Falling edge of</source>
        <translation>Спад сигнала</translation>
    </message>
    <message>
        <source>How much of the recording lies before the trigger.</source>
        <translation>Какая доля записи лежит до запуска.</translation>
    </message>
    <message>
        <source>Length</source>
        <translation>Длина</translation>
    </message>
    <message>
        <source>Length of a triggered recording.</source>
        <translation>Длина записи по запуску.</translation>
    </message>
    <message>
        <source>Part before the trigger</source>
        <translation>Часть до запуска</translation>
    </message>
    <message>
        <source>Rising edge of</source>
        <translation>Фронт сигнала</translation>
    </message>
    <message>
        <source>Trigger</source>
        <translation>Запуск</translation>
    </message>
    <message>
        <source>Trigger channel</source>
        <translation>Канал запуска</translation>
    </message>
    <message>
        <source>Trigger level</source>
        <translation>Уровень запуска</translation>
    </message>
    <message>
        <source>Value at which the recording is triggered.</source>
        <translation>Значение, при котором запускается запись.</translation>
    </message>
    <message>
        <source>Value that is watched for the trigger</source>
        <translation>Значение, за которым следит запуск</translation>
    </message>
    <message>
        <source>What starts the recording</source>
        <translation>Что запускает запись</translation>
    </message>
    <message>
        <source>s</source>
        <translation>с</translation>
    </message>
</context>
<context>
    <name>camwright::TypeDelegate</name>
    <message>
        <source>Type</source>
        <translation>Тип</translation>
    </message>
</context>
<context>
    <name>camwright::VariablesEditor</name>
    <message numerus="yes">
        <source>%n variable(s)</source>
        <translation>
            <numerusform>%n переменная</numerusform>
            <numerusform>%n переменные</numerusform>
            <numerusform>%n переменных</numerusform>
        </translation>
    </message>
    <message>
        <source>Filter</source>
        <translation>Фильтр</translation>
    </message>
    <message>
        <source>Global variables; the last row adds one</source>
        <translation>Глобальные переменные; последняя строка добавляет новую</translation>
    </message>
    <message>
        <source>Show only rows that contain this text in any column</source>
        <translation>Показывать только строки с этим текстом в любом столбце</translation>
    </message>
    <message>
        <source>Variables</source>
        <translation>Переменные</translation>
    </message>
</context>
<context>
    <name>camwright::VariablesModel</name>
    <message numerus="yes">
        <source>Add %n variable(s)</source>
        <translation>
            <numerusform>Добавить %n переменную</numerusform>
            <numerusform>Добавить %n переменные</numerusform>
            <numerusform>Добавить %n переменных</numerusform>
        </translation>
    </message>
    <message>
        <source>Add variable</source>
        <translation>Добавить переменную</translation>
    </message>
    <message>
        <source>Address</source>
        <translation>Адрес</translation>
    </message>
    <message>
        <source>Change variable %1</source>
        <translation>Изменить переменную %1</translation>
    </message>
    <message>
        <source>Comment</source>
        <translation>Комментарий</translation>
    </message>
    <message numerus="yes">
        <source>Delete %n variable(s)</source>
        <translation>
            <numerusform>Удалить %n переменную</numerusform>
            <numerusform>Удалить %n переменные</numerusform>
            <numerusform>Удалить %n переменных</numerusform>
        </translation>
    </message>
    <message>
        <source>Initial value</source>
        <translation>Начальное значение</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Имя</translation>
    </message>
    <message>
        <source>Retain</source>
        <translation>Сохранять</translation>
    </message>
    <message>
        <source>Type</source>
        <translation>Тип</translation>
    </message>
    <message>
        <source>new variable</source>
        <translation>новая переменная</translation>
    </message>
</context>
<context>
    <name>camwright::WatchModel</name>
    <message numerus="yes">
        <source>Add %n watched value(s)</source>
        <translation>
            <numerusform>Добавить %n значение</numerusform>
            <numerusform>Добавить %n значения</numerusform>
            <numerusform>Добавить %n значений</numerusform>
        </translation>
    </message>
    <message>
        <source>Change a watched value</source>
        <translation>Изменить наблюдаемое значение</translation>
    </message>
    <message>
        <source>Change the display format</source>
        <translation>Сменить формат показа</translation>
    </message>
    <message>
        <source>Comment</source>
        <translation>Комментарий</translation>
    </message>
    <message>
        <source>Last 10 s</source>
        <translation>Последние 10 с</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Имя</translation>
    </message>
    <message>
        <source>New value</source>
        <translation>Новое значение</translation>
    </message>
    <message numerus="yes">
        <source>Remove %n watched value(s)</source>
        <translation>
            <numerusform>Убрать %n значение</numerusform>
            <numerusform>Убрать %n значения</numerusform>
            <numerusform>Убрать %n значений</numerusform>
        </translation>
    </message>
    <message>
        <source>Type</source>
        <translation>Тип</translation>
    </message>
    <message>
        <source>Value</source>
        <translation>Значение</translation>
    </message>
    <message>
        <source>name or address</source>
        <translation>имя или адрес</translation>
    </message>
    <message>
        <source>not known</source>
        <translation>неизвестно</translation>
    </message>
</context>
<context>
    <name>camwright::WatchPanel</name>
    <message>
        <source>A watch list keeps the values you look at together.</source>
        <translation>Список наблюдения держит вместе значения, за которыми вы следите.</translation>
    </message>
    <message>
        <source>Make a Watch List</source>
        <translation>Создать список наблюдения</translation>
    </message>
    <message>
        <source>Make another watch list</source>
        <translation>Создать ещё один список наблюдения</translation>
    </message>
    <message>
        <source>New watch list</source>
        <translation>Новый список наблюдения</translation>
    </message>
    <message>
        <source>The list shown here</source>
        <translation>Показанный здесь список</translation>
    </message>
    <message>
        <source>Watch</source>
        <translation>Наблюдение</translation>
    </message>
    <message>
        <source>Watch List</source>
        <translation>Список наблюдения</translation>
    </message>
    <message>
        <source>Watch list</source>
        <translation>Список наблюдения</translation>
    </message>
</context>
<context>
    <name>camwright::WatchView</name>
    <message>
        <source>Binary (2#)</source>
        <translation>Двоичное (2#)</translation>
    </message>
    <message>
        <source>Decimal</source>
        <translation>Десятичное</translation>
    </message>
    <message>
        <source>Force</source>
        <translation>Форсировать</translation>
    </message>
    <message>
        <source>Hexadecimal (16#)</source>
        <translation>Шестнадцатеричное (16#)</translation>
    </message>
    <message>
        <source>Octal (8#)</source>
        <translation>Восьмеричное (8#)</translation>
    </message>
    <message>
        <source>Release</source>
        <translation>Снять форсирование</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Убрать</translation>
    </message>
    <message>
        <source>Show As</source>
        <translation>Показывать как</translation>
    </message>
    <message>
        <source>The controller runs another program than this project; its values are not shown. Download the project to see them.</source>
        <translation>Контроллер выполняет не программу этого проекта; её значения не показаны. Загрузите проект, чтобы видеть их.</translation>
    </message>
    <message>
        <source>Values of the controller; type a new value to write it, F7 forces it</source>
        <translation>Значения контроллера; введите новое, чтобы записать его, F7 форсирует</translation>
    </message>
    <message>
        <source>Watched values</source>
        <translation>Наблюдаемые значения</translation>
    </message>
</context>
<context>
    <name>camwright::Workbench</name>
    <message numerus="yes">
        <source>%n errors</source>
        <translation>
            <numerusform>%n ошибка</numerusform>
            <numerusform>%n ошибки</numerusform>
            <numerusform>%n ошибок</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n warnings</source>
        <translation>
            <numerusform>%n предупреждение</numerusform>
            <numerusform>%n предупреждения</numerusform>
            <numerusform>%n предупреждений</numerusform>
        </translation>
    </message>
    <message>
        <source>Built &quot;%1&quot;: %2 bytes.</source>
        <translation>Собрано «%1», байт: %2.</translation>
    </message>
    <message>
        <source>Built without errors.</source>
        <translation>Собрано без ошибок.</translation>
    </message>
    <message>
        <source>Checked: %1, %2.</source>
        <translation>Проверено: %1, %2.</translation>
    </message>
    <message>
        <source>Checked: no problems.</source>
        <translation>Проверено: проблем нет.</translation>
    </message>
    <message>
        <source>Not built: the project has errors. The Problems list names them.</source>
        <translation>Не собрано: в проекте есть ошибки. Они в списке проблем.</translation>
    </message>
</context>
</TS>
