<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="zh_CN" sourcelanguage="en">
<context>
    <name>Actions</name>
    <message>
        <source>&amp;About Camwright</source>
        <translation>关于 Camwright(&amp;A)</translation>
    </message>
    <message>
        <source>&amp;All Tabs in One Group</source>
        <translation>所有标签页归为一组(&amp;A)</translation>
    </message>
    <message>
        <source>&amp;Back</source>
        <translation>后退(&amp;B)</translation>
    </message>
    <message>
        <source>&amp;Bottom Dock</source>
        <translation>底栏(&amp;B)</translation>
    </message>
    <message>
        <source>&amp;Build</source>
        <translation>编译(&amp;B)</translation>
    </message>
    <message>
        <source>&amp;Check</source>
        <translation>检查(&amp;C)</translation>
    </message>
    <message>
        <source>&amp;Close Project</source>
        <translation>关闭工程(&amp;C)</translation>
    </message>
    <message>
        <source>&amp;Close Tab</source>
        <translation>关闭标签页(&amp;C)</translation>
    </message>
    <message>
        <source>&amp;Copy</source>
        <translation>复制(&amp;C)</translation>
    </message>
    <message>
        <source>&amp;Dark Theme</source>
        <translation>深色主题(&amp;D)</translation>
    </message>
    <message>
        <source>&amp;Definition</source>
        <translation>定义(&amp;D)</translation>
    </message>
    <message>
        <source>&amp;Delete</source>
        <translation>删除(&amp;D)</translation>
    </message>
    <message>
        <source>&amp;Documentation</source>
        <translation>文档(&amp;D)</translation>
    </message>
    <message>
        <source>&amp;Download...</source>
        <translation>下载(&amp;D)...</translation>
    </message>
    <message>
        <source>&amp;Explain This Message</source>
        <translation>解释此消息(&amp;E)</translation>
    </message>
    <message>
        <source>&amp;Find Anything...</source>
        <translation>查找任意内容(&amp;F)...</translation>
    </message>
    <message>
        <source>&amp;Find...</source>
        <translation>查找(&amp;F)...</translation>
    </message>
    <message>
        <source>&amp;Force Selected Value</source>
        <translation>强制所选值(&amp;F)</translation>
    </message>
    <message>
        <source>&amp;Import Kinco Program Text...</source>
        <translation>导入 Kinco 程序文本(&amp;I)...</translation>
    </message>
    <message>
        <source>&amp;Move Tab to Next Group</source>
        <translation>将标签页移到下一组(&amp;M)</translation>
    </message>
    <message>
        <source>&amp;New Project...</source>
        <translation>新建工程(&amp;N)...</translation>
    </message>
    <message>
        <source>&amp;Next Problem</source>
        <translation>下一个问题(&amp;N)</translation>
    </message>
    <message>
        <source>&amp;Open Project...</source>
        <translation>打开工程(&amp;O)...</translation>
    </message>
    <message>
        <source>&amp;Paste</source>
        <translation>粘贴(&amp;P)</translation>
    </message>
    <message>
        <source>&amp;Previous Problem</source>
        <translation>上一个问题(&amp;P)</translation>
    </message>
    <message>
        <source>&amp;Quick Fix</source>
        <translation>快速修复(&amp;Q)</translation>
    </message>
    <message>
        <source>&amp;Quit</source>
        <translation>退出(&amp;Q)</translation>
    </message>
    <message>
        <source>&amp;Redo</source>
        <translation>重做(&amp;R)</translation>
    </message>
    <message>
        <source>&amp;References</source>
        <translation>引用(&amp;R)</translation>
    </message>
    <message>
        <source>&amp;Reload From Disk</source>
        <translation>从磁盘重新加载(&amp;R)</translation>
    </message>
    <message>
        <source>&amp;Reset Layout</source>
        <translation>重置布局(&amp;R)</translation>
    </message>
    <message>
        <source>&amp;Run</source>
        <translation>运行(&amp;R)</translation>
    </message>
    <message>
        <source>&amp;Save</source>
        <translation>保存(&amp;S)</translation>
    </message>
    <message>
        <source>&amp;Side Dock</source>
        <translation>侧栏(&amp;S)</translation>
    </message>
    <message>
        <source>&amp;Stop</source>
        <translation>停止(&amp;S)</translation>
    </message>
    <message>
        <source>&amp;Undo</source>
        <translation>撤销(&amp;U)</translation>
    </message>
    <message>
        <source>Axis panel with the log below.</source>
        <translation>轴面板，下方为日志。</translation>
    </message>
    <message>
        <source>Checks the project and makes the controller&apos;s program.</source>
        <translation>检查工程并生成控制器程序。</translation>
    </message>
    <message>
        <source>Checks the whole project and lists its problems.</source>
        <translation>检查整个工程并列出问题。</translation>
    </message>
    <message>
        <source>Closes the current editor; its edits stay in the project.</source>
        <translation>关闭当前编辑器；其编辑保留在工程中。</translation>
    </message>
    <message>
        <source>Closes the project and shows the start page.</source>
        <translation>关闭工程并显示起始页。</translation>
    </message>
    <message>
        <source>Co&amp;mment Lines</source>
        <translation>注释行(&amp;M)</translation>
    </message>
    <message>
        <source>Complete &amp;Word</source>
        <translation>补全单词(&amp;W)</translation>
    </message>
    <message>
        <source>Connects to the controller at the address.</source>
        <translation>连接到该地址的控制器。</translation>
    </message>
    <message>
        <source>Copies the selection to the clipboard.</source>
        <translation>将所选内容复制到剪贴板。</translation>
    </message>
    <message>
        <source>Copies the selection with the next free name.</source>
        <translation>以下一个可用名称复制所选内容。</translation>
    </message>
    <message>
        <source>Cu&amp;t</source>
        <translation>剪切(&amp;T)</translation>
    </message>
    <message>
        <source>D&amp;uplicate</source>
        <translation>创建副本(&amp;U)</translation>
    </message>
    <message>
        <source>Deletes the selection.</source>
        <translation>删除所选内容。</translation>
    </message>
    <message>
        <source>Does the step again that was taken back.</source>
        <translation>重做被撤销的步骤。</translation>
    </message>
    <message>
        <source>Ends Camwright; the virtual controller goes on for a while.</source>
        <translation>结束 Camwright；虚拟控制器继续运行一段时间。</translation>
    </message>
    <message>
        <source>Ends every split and brings the tabs of other windows back.</source>
        <translation>取消所有拆分，并收回其他窗口中的标签页。</translation>
    </message>
    <message>
        <source>Ends the connection; the controller goes on as it is.</source>
        <translation>结束连接；控制器保持原样运行。</translation>
    </message>
    <message>
        <source>F&amp;orward</source>
        <translation>前进(&amp;O)</translation>
    </message>
    <message>
        <source>Find &amp;Next</source>
        <translation>查找下一个(&amp;N)</translation>
    </message>
    <message>
        <source>Find A&amp;ction...</source>
        <translation>查找操作(&amp;C)...</translation>
    </message>
    <message>
        <source>Find Pre&amp;vious</source>
        <translation>查找上一个(&amp;V)</translation>
    </message>
    <message>
        <source>Finds any action by a part of its name.</source>
        <translation>按名称的一部分查找任意操作。</translation>
    </message>
    <message>
        <source>Finds any object, variable or axis value by a part of its name.</source>
        <translation>按名称的一部分查找任意对象、变量或轴值。</translation>
    </message>
    <message>
        <source>Finds text and replaces it.</source>
        <translation>查找文本并替换。</translation>
    </message>
    <message>
        <source>Finds text in the current view.</source>
        <translation>在当前视图中查找文本。</translation>
    </message>
    <message>
        <source>Gives every forced value back to the program.</source>
        <translation>将所有强制值交还给程序。</translation>
    </message>
    <message>
        <source>Go &amp;Online</source>
        <translation>转到在线(&amp;O)</translation>
    </message>
    <message>
        <source>Go O&amp;ffline</source>
        <translation>转到离线(&amp;F)</translation>
    </message>
    <message>
        <source>Goes to the hit before.</source>
        <translation>转到上一处匹配。</translation>
    </message>
    <message>
        <source>Goes to the next group of tabs, in whichever window it is.</source>
        <translation>转到下一组标签页，无论它在哪个窗口。</translation>
    </message>
    <message>
        <source>Goes to the next hit.</source>
        <translation>转到下一处匹配。</translation>
    </message>
    <message>
        <source>Goes to the place after.</source>
        <translation>转到后一个位置。</translation>
    </message>
    <message>
        <source>Goes to the place before.</source>
        <translation>回到前一个位置。</translation>
    </message>
    <message>
        <source>Goes to the previous group of tabs.</source>
        <translation>转到上一组标签页。</translation>
    </message>
    <message>
        <source>Goes to where the symbol is declared.</source>
        <translation>转到符号的声明处。</translation>
    </message>
    <message>
        <source>Holds the selected watched value, as typed or as it is, until it is released.</source>
        <translation>将所选监视值按输入或按当前值保持，直到释放。</translation>
    </message>
    <message>
        <source>Inserts what the clipboard holds.</source>
        <translation>插入剪贴板中的内容。</translation>
    </message>
    <message>
        <source>Layout &amp;Analyse</source>
        <translation>布局：分析(&amp;A)</translation>
    </message>
    <message>
        <source>Layout &amp;Configure</source>
        <translation>布局：组态(&amp;C)</translation>
    </message>
    <message>
        <source>Layout &amp;Program</source>
        <translation>布局：编程(&amp;P)</translation>
    </message>
    <message>
        <source>Layout C&amp;ommission</source>
        <translation>布局：调试(&amp;O)</translation>
    </message>
    <message>
        <source>Lists what may be typed here.</source>
        <translation>列出此处可输入的内容。</translation>
    </message>
    <message>
        <source>Lists where the symbol is used.</source>
        <translation>列出使用该符号的位置。</translation>
    </message>
    <message>
        <source>Makes a project for a controller family and model.</source>
        <translation>为某一控制器系列和型号建立工程。</translation>
    </message>
    <message>
        <source>Move Tab &amp;Left</source>
        <translation>标签页左移(&amp;L)</translation>
    </message>
    <message>
        <source>Move Tab Ri&amp;ght</source>
        <translation>标签页右移(&amp;G)</translation>
    </message>
    <message>
        <source>Moves the current tab into a window of its own, or back into the main window.</source>
        <translation>将当前标签页移到独立窗口，或移回主窗口。</translation>
    </message>
    <message>
        <source>Moves the current tab one place to the left.</source>
        <translation>将当前标签页向左移动一位。</translation>
    </message>
    <message>
        <source>Moves the current tab one place to the right.</source>
        <translation>将当前标签页向右移动一位。</translation>
    </message>
    <message>
        <source>Moves the current tab to the next group of tabs, in whichever window it is.</source>
        <translation>将当前标签页移到下一组，无论它在哪个窗口。</translation>
    </message>
    <message>
        <source>Moves the selection to the clipboard.</source>
        <translation>将所选内容移到剪贴板。</translation>
    </message>
    <message>
        <source>Next &amp;Group</source>
        <translation>下一组(&amp;G)</translation>
    </message>
    <message>
        <source>Next &amp;Tab</source>
        <translation>下一个标签页(&amp;T)</translation>
    </message>
    <message>
        <source>Offers ways out of the problem under the cursor.</source>
        <translation>提供光标处问题的解决办法。</translation>
    </message>
    <message>
        <source>Open the &amp;Demo Machine</source>
        <translation>打开演示机器(&amp;D)</translation>
    </message>
    <message>
        <source>Opens a machine with two simulated axes and connects to its virtual controller.</source>
        <translation>打开一台带两个仿真轴的机器，并连接其虚拟控制器。</translation>
    </message>
    <message>
        <source>Opens a project folder.</source>
        <translation>打开一个工程文件夹。</translation>
    </message>
    <message>
        <source>Previous Gro&amp;up</source>
        <translation>上一组(&amp;U)</translation>
    </message>
    <message>
        <source>Previous Ta&amp;b</source>
        <translation>上一个标签页(&amp;B)</translation>
    </message>
    <message>
        <source>Project &amp;Tree</source>
        <translation>工程树(&amp;T)</translation>
    </message>
    <message>
        <source>Puts every dock back to where it was at first.</source>
        <translation>将所有停靠栏放回最初的位置。</translation>
    </message>
    <message>
        <source>Puts the current tab into a group of its own at the right.</source>
        <translation>将当前标签页放入右侧的新组。</translation>
    </message>
    <message>
        <source>Puts the current tab into a group of its own below.</source>
        <translation>将当前标签页放入下方的新组。</translation>
    </message>
    <message>
        <source>Puts the selected lines into comments, or takes them out.</source>
        <translation>将所选行变为注释，或取消注释。</translation>
    </message>
    <message>
        <source>R&amp;eplace...</source>
        <translation>替换(&amp;E)...</translation>
    </message>
    <message>
        <source>Re&amp;name</source>
        <translation>重命名(&amp;N)</translation>
    </message>
    <message>
        <source>Reads the project&apos;s files again; can be undone.</source>
        <translation>重新读取工程文件；可以撤销。</translation>
    </message>
    <message>
        <source>Release &amp;All Forces</source>
        <translation>释放所有强制(&amp;A)</translation>
    </message>
    <message>
        <source>Renames the object or symbol.</source>
        <translation>重命名对象或符号。</translation>
    </message>
    <message>
        <source>Replaces this program by the text of a KincoBuilder .ilp file.</source>
        <translation>用 KincoBuilder .ilp 文件的文本替换此程序。</translation>
    </message>
    <message>
        <source>Save &amp;As...</source>
        <translation>另存为(&amp;A)...</translation>
    </message>
    <message>
        <source>Se&amp;ttings...</source>
        <translation>设置(&amp;T)...</translation>
    </message>
    <message>
        <source>Select &amp;All</source>
        <translation>全选(&amp;A)</translation>
    </message>
    <message>
        <source>Selects everything in the view.</source>
        <translation>选中视图中的全部内容。</translation>
    </message>
    <message>
        <source>Shows or hides the dock at the bottom.</source>
        <translation>显示或隐藏底部停靠栏。</translation>
    </message>
    <message>
        <source>Shows or hides the dock at the right.</source>
        <translation>显示或隐藏右侧停靠栏。</translation>
    </message>
    <message>
        <source>Shows or hides the project tree.</source>
        <translation>显示或隐藏工程树。</translation>
    </message>
    <message>
        <source>Shows the next problem at its place.</source>
        <translation>在其位置显示下一个问题。</translation>
    </message>
    <message>
        <source>Shows the next tab of the group.</source>
        <translation>显示本组的下一个标签页。</translation>
    </message>
    <message>
        <source>Shows the page about the selected message: an example and the way out. F1 in the list does the same.</source>
        <translation>显示所选消息的说明页面：示例和解决办法。在列表中按 F1 效果相同。</translation>
    </message>
    <message>
        <source>Shows the pages that come with Camwright.</source>
        <translation>显示 Camwright 自带的页面。</translation>
    </message>
    <message>
        <source>Shows the previous problem at its place.</source>
        <translation>在其位置显示上一个问题。</translation>
    </message>
    <message>
        <source>Shows the previous tab of the group.</source>
        <translation>显示本组的上一个标签页。</translation>
    </message>
    <message>
        <source>Shows what changes, then replaces the controller&apos;s program.</source>
        <translation>显示将改变的内容，然后替换控制器的程序。</translation>
    </message>
    <message>
        <source>Split Do&amp;wn</source>
        <translation>向下拆分(&amp;W)</translation>
    </message>
    <message>
        <source>Split R&amp;ight</source>
        <translation>向右拆分(&amp;I)</translation>
    </message>
    <message>
        <source>Starts the controller&apos;s program.</source>
        <translation>启动控制器的程序。</translation>
    </message>
    <message>
        <source>Stop All A&amp;xes</source>
        <translation>停止所有轴(&amp;X)</translation>
    </message>
    <message>
        <source>Stops all axes, then the program.</source>
        <translation>先停止所有轴，再停止程序。</translation>
    </message>
    <message>
        <source>Stops every axis at once; needs no control.</source>
        <translation>立即停止每个轴；不需要控制权。</translation>
    </message>
    <message>
        <source>Switches between light and dark.</source>
        <translation>在浅色与深色之间切换。</translation>
    </message>
    <message>
        <source>Tab in Its &amp;Own Window</source>
        <translation>标签页在独立窗口中(&amp;O)</translation>
    </message>
    <message>
        <source>Takes back the project&apos;s last step, in whichever editor it was.</source>
        <translation>撤销工程的上一步，无论它在哪个编辑器中。</translation>
    </message>
    <message>
        <source>The oscilloscope, large.</source>
        <translation>大示波器。</translation>
    </message>
    <message>
        <source>Theme, language and keys.</source>
        <translation>主题、语言和按键。</translation>
    </message>
    <message>
        <source>Tree, editor and properties.</source>
        <translation>工程树、编辑器和属性。</translation>
    </message>
    <message>
        <source>Tree, program, instructions and watch.</source>
        <translation>工程树、程序、指令和监视。</translation>
    </message>
    <message>
        <source>Version and licence.</source>
        <translation>版本和许可证。</translation>
    </message>
    <message>
        <source>Writes all edits to the project&apos;s folder.</source>
        <translation>将所有编辑写入工程文件夹。</translation>
    </message>
    <message>
        <source>Writes the project into another folder and goes on there.</source>
        <translation>将工程写入另一个文件夹，并在那里继续。</translation>
    </message>
</context>
<context>
    <name>Arguments</name>
    <message>
        <source>SDO protocol timed out</source>
        <translation>SDO 协议超时</translation>
    </message>
    <message>
        <source>a broken list</source>
        <translation>列表损坏</translation>
    </message>
    <message>
        <source>a broken number</source>
        <translation>数损坏</translation>
    </message>
    <message>
        <source>a broken text</source>
        <translation>文本损坏</translation>
    </message>
    <message>
        <source>a broken value</source>
        <translation>值损坏</translation>
    </message>
    <message>
        <source>a client</source>
        <translation>某客户端</translation>
    </message>
    <message>
        <source>a constant</source>
        <translation>常量</translation>
    </message>
    <message>
        <source>a digest that has neither 0 nor 32 bytes</source>
        <translation>摘要既不是 0 字节也不是 32 字节</translation>
    </message>
    <message>
        <source>a function block that can be extended</source>
        <translation>可扩展的功能块</translation>
    </message>
    <message>
        <source>a global variable</source>
        <translation>全局变量</translation>
    </message>
    <message>
        <source>a label of the CASE</source>
        <translation>CASE 的标号</translation>
    </message>
    <message>
        <source>a message before the handshake was done</source>
        <translation>握手完成之前的报文</translation>
    </message>
    <message>
        <source>a name</source>
        <translation>名称</translation>
    </message>
    <message>
        <source>a negative scan period or watchdog time</source>
        <translation>扫描周期或看门狗时间为负</translation>
    </message>
    <message>
        <source>a program</source>
        <translation>程序</translation>
    </message>
    <message>
        <source>a real number</source>
        <translation>实数</translation>
    </message>
    <message>
        <source>a reference</source>
        <translation>引用</translation>
    </message>
    <message>
        <source>a routine has no name, or two have the same</source>
        <translation>有例程没有名称，或两个同名</translation>
    </message>
    <message>
        <source>a second hello</source>
        <translation>第二个 hello 报文</translation>
    </message>
    <message>
        <source>a statement</source>
        <translation>语句</translation>
    </message>
    <message>
        <source>a string</source>
        <translation>字符串</translation>
    </message>
    <message>
        <source>a text that is longer than the message</source>
        <translation>文本比报文还长</translation>
    </message>
    <message>
        <source>a text that is no UTF-8</source>
        <translation>文本不是 UTF-8</translation>
    </message>
    <message>
        <source>a type</source>
        <translation>类型</translation>
    </message>
    <message>
        <source>a value nobody asked for</source>
        <translation>无人请求的值</translation>
    </message>
    <message>
        <source>a value wider than its type</source>
        <translation>值超出其类型的宽度</translation>
    </message>
    <message>
        <source>a variable without an address</source>
        <translation>没有地址的变量</translation>
    </message>
    <message>
        <source>a whole number</source>
        <translation>整数</translation>
    </message>
    <message>
        <source>a whole-number type</source>
        <translation>整数类型</translation>
    </message>
    <message>
        <source>a wrong answer to piece</source>
        <translation>对片段的错误应答</translation>
    </message>
    <message>
        <source>access failed due to a hardware error</source>
        <translation>因硬件错误访问失败</translation>
    </message>
    <message>
        <source>an address</source>
        <translation>地址</translation>
    </message>
    <message>
        <source>an array</source>
        <translation>数组</translation>
    </message>
    <message>
        <source>an expression</source>
        <translation>表达式</translation>
    </message>
    <message>
        <source>an initial value lies outside its area</source>
        <translation>某初始值超出其存储区</translation>
    </message>
    <message>
        <source>an input</source>
        <translation>输入</translation>
    </message>
    <message>
        <source>an interface</source>
        <translation>接口</translation>
    </message>
    <message>
        <source>an output</source>
        <translation>输出</translation>
    </message>
    <message>
        <source>another number of types than was asked for</source>
        <translation>类型数与请求的不同</translation>
    </message>
    <message>
        <source>any finite number</source>
        <translation>任意有限数</translation>
    </message>
    <message>
        <source>attempt to read a write-only object</source>
        <translation>试图读取只写对象</translation>
    </message>
    <message>
        <source>attempt to write a read-only object</source>
        <translation>试图写入只读对象</translation>
    </message>
    <message>
        <source>both stored sets are damaged</source>
        <translation>两份存储数据均已损坏</translation>
    </message>
    <message>
        <source>broken bytes</source>
        <translation>字节串损坏</translation>
    </message>
    <message>
        <source>bytes that are longer than the message</source>
        <translation>字节串比报文还长</translation>
    </message>
    <message>
        <source>command specifier not valid or unknown</source>
        <translation>命令字无效或未知</translation>
    </message>
    <message>
        <source>commanded velocity</source>
        <translation>指令速度</translation>
    </message>
    <message>
        <source>data cannot be stored because of local control</source>
        <translation>因本地控制，数据无法存储</translation>
    </message>
    <message>
        <source>data cannot be stored in the present device state</source>
        <translation>设备当前状态下数据无法存储</translation>
    </message>
    <message>
        <source>data cannot be transferred or stored</source>
        <translation>数据无法传输或存储</translation>
    </message>
    <message>
        <source>fewer values than were asked for</source>
        <translation>值少于所请求的数量</translation>
    </message>
    <message>
        <source>general error</source>
        <translation>一般错误</translation>
    </message>
    <message>
        <source>general parameter incompatibility</source>
        <translation>参数一般性不兼容</translation>
    </message>
    <message>
        <source>it left no message</source>
        <translation>它没有留下消息</translation>
    </message>
    <message>
        <source>its digest does not fit</source>
        <translation>摘要不符</translation>
    </message>
    <message>
        <source>length of the parameter does not match</source>
        <translation>参数长度不符</translation>
    </message>
    <message>
        <source>maximum is less than minimum</source>
        <translation>最大值小于最小值</translation>
    </message>
    <message>
        <source>more parts</source>
        <translation>更多的部分</translation>
    </message>
    <message>
        <source>more than a message</source>
        <translation>超过一个报文的内容</translation>
    </message>
    <message>
        <source>no abort</source>
        <translation>无中止</translation>
    </message>
    <message>
        <source>no answer within 5 s</source>
        <translation>5 s 内没有应答</translation>
    </message>
    <message>
        <source>no authentication</source>
        <translation>没有身份验证</translation>
    </message>
    <message>
        <source>no bytes of known length where they are due</source>
        <translation>应有字节串处没有长度已知的字节串</translation>
    </message>
    <message>
        <source>no list of the right length where one is due</source>
        <translation>应有列表处没有正确长度的列表</translation>
    </message>
    <message>
        <source>no program</source>
        <translation>无程序</translation>
    </message>
    <message>
        <source>no text of known length where one is due</source>
        <translation>应有文本处没有长度已知的文本</translation>
    </message>
    <message>
        <source>no true or false where one is due</source>
        <translation>应为布尔值处没有布尔值</translation>
    </message>
    <message>
        <source>no welcome</source>
        <translation>没有 welcome 报文</translation>
    </message>
    <message>
        <source>nothing</source>
        <translation>无</translation>
    </message>
    <message>
        <source>nothing came for %1 s</source>
        <translation>已有 %1 s 没有收到任何数据</translation>
    </message>
    <message>
        <source>number and length of the mapped objects exceed the PDO</source>
        <translation>映射对象的数量和长度超出 PDO</translation>
    </message>
    <message>
        <source>object cannot be mapped to the PDO</source>
        <translation>该对象不能映射到 PDO</translation>
    </message>
    <message>
        <source>object does not exist in the object dictionary</source>
        <translation>对象字典中没有该对象</translation>
    </message>
    <message>
        <source>out of memory</source>
        <translation>内存不足</translation>
    </message>
    <message>
        <source>parameter is too long</source>
        <translation>参数过长</translation>
    </message>
    <message>
        <source>parameter is too short</source>
        <translation>参数过短</translation>
    </message>
    <message>
        <source>samples that are no multiple of 8 bytes</source>
        <translation>采样数据不是 8 字节的倍数</translation>
    </message>
    <message>
        <source>sub-index does not exist</source>
        <translation>子索引不存在</translation>
    </message>
    <message>
        <source>target position</source>
        <translation>目标位置</translation>
    </message>
    <message>
        <source>the axes are not in order</source>
        <translation>轴顺序不对</translation>
    </message>
    <message>
        <source>the counter of a loop around it</source>
        <translation>外层循环的计数变量</translation>
    </message>
    <message>
        <source>the end of the text</source>
        <translation>文本末尾</translation>
    </message>
    <message>
        <source>the flag of failed instructions lies outside its area</source>
        <translation>指令失败标志超出其存储区</translation>
    </message>
    <message>
        <source>the folder cannot be made</source>
        <translation>无法建立文件夹</translation>
    </message>
    <message>
        <source>the memory areas are not in order</source>
        <translation>存储区顺序不对</translation>
    </message>
    <message>
        <source>the memory areas are too large</source>
        <translation>存储区过大</translation>
    </message>
    <message>
        <source>the other side closed it</source>
        <translation>对方已关闭</translation>
    </message>
    <message>
        <source>the program before it</source>
        <translation>之前的程序</translation>
    </message>
    <message>
        <source>the record is damaged</source>
        <translation>记录已损坏</translation>
    </message>
    <message>
        <source>the record of the stored program is damaged</source>
        <translation>所存程序的记录已损坏</translation>
    </message>
    <message>
        <source>the retained range of an area lies outside it</source>
        <translation>某存储区的保持范围超出该区</translation>
    </message>
    <message>
        <source>the stored program is damaged</source>
        <translation>所存程序已损坏</translation>
    </message>
    <message>
        <source>the variables are not in order</source>
        <translation>变量顺序不对</translation>
    </message>
    <message>
        <source>there is no private folder for its socket</source>
        <translation>没有放置其套接字的私有文件夹</translation>
    </message>
    <message>
        <source>toggle bit not alternated</source>
        <translation>切换位未交替</translation>
    </message>
    <message>
        <source>unknown reason</source>
        <translation>原因未知</translation>
    </message>
    <message>
        <source>unsupported access to an object</source>
        <translation>不支持对该对象的访问</translation>
    </message>
    <message>
        <source>value outside the permitted range</source>
        <translation>值超出允许范围</translation>
    </message>
    <message>
        <source>value too high</source>
        <translation>值过大</translation>
    </message>
    <message>
        <source>value too low</source>
        <translation>值过小</translation>
    </message>
</context>
<context>
    <name>AxisCause</name>
    <message>
        <source>alarm of the drive</source>
        <translation>驱动器报警</translation>
    </message>
    <message>
        <source>enabled by a panel</source>
        <translation>由面板使能</translation>
    </message>
    <message>
        <source>motion ended</source>
        <translation>运动结束</translation>
    </message>
    <message>
        <source>motion of a panel</source>
        <translation>面板的运动</translation>
    </message>
    <message>
        <source>motion of the program</source>
        <translation>程序的运动</translation>
    </message>
    <message>
        <source>no longer on the bus</source>
        <translation>不再在总线上</translation>
    </message>
    <message>
        <source>node restarted</source>
        <translation>节点重启</translation>
    </message>
    <message>
        <source>powered by the program</source>
        <translation>由程序上电</translation>
    </message>
    <message>
        <source>released by a panel</source>
        <translation>由面板释放</translation>
    </message>
    <message>
        <source>released by the program</source>
        <translation>由程序释放</translation>
    </message>
    <message>
        <source>reset</source>
        <translation>复位</translation>
    </message>
    <message>
        <source>stopped and released</source>
        <translation>已停止并释放</translation>
    </message>
    <message>
        <source>stopped by command</source>
        <translation>按命令停止</translation>
    </message>
    <message>
        <source>stopped: no heartbeat from the panel</source>
        <translation>已停止：面板没有心跳</translation>
    </message>
</context>
<context>
    <name>AxisError</name>
    <message>
        <source>alarm of the drive; its manual explains the code</source>
        <translation>驱动器报警；代码含义见其手册</translation>
    </message>
    <message>
        <source>brake, motor or another module of the drive</source>
        <translation>制动器、电机或驱动器的其他模块</translation>
    </message>
    <message>
        <source>communication</source>
        <translation>通信</translation>
    </message>
    <message>
        <source>current</source>
        <translation>电流</translation>
    </message>
    <message>
        <source>current too high at the output of the drive</source>
        <translation>驱动器输出电流过大</translation>
    </message>
    <message>
        <source>encoder</source>
        <translation>编码器</translation>
    </message>
    <message>
        <source>following error too large</source>
        <translation>跟随误差过大</translation>
    </message>
    <message>
        <source>general error of the drive</source>
        <translation>驱动器一般错误</translation>
    </message>
    <message>
        <source>hardware of the drive</source>
        <translation>驱动器硬件</translation>
    </message>
    <message>
        <source>position control</source>
        <translation>位置控制</translation>
    </message>
    <message>
        <source>software of the drive</source>
        <translation>驱动器软件</translation>
    </message>
    <message>
        <source>supervision</source>
        <translation>监控</translation>
    </message>
    <message>
        <source>temperature</source>
        <translation>温度</translation>
    </message>
    <message>
        <source>the drive no longer answers on the bus</source>
        <translation>驱动器在总线上不再应答</translation>
    </message>
    <message>
        <source>voltage</source>
        <translation>电压</translation>
    </message>
</context>
<context>
    <name>Commands</name>
    <message>
        <source>Add &quot;%1&quot;</source>
        <translation>添加“%1”</translation>
    </message>
    <message>
        <source>Delete &quot;%1&quot;</source>
        <translation>删除“%1”</translation>
    </message>
    <message numerus="yes">
        <source>Delete %n objects</source>
        <translation>
            <numerusform>删除 %n 个对象</numerusform>
        </translation>
    </message>
    <message>
        <source>Edit program &quot;%1&quot;</source>
        <translation>编辑程序“%1”</translation>
    </message>
    <message>
        <source>Rename &quot;%1&quot; to &quot;%2&quot;</source>
        <translation>将“%1”重命名为“%2”</translation>
    </message>
</context>
<context>
    <name>Commissioning</name>
    <message>
        <source>mm</source>
        <translation>mm</translation>
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
        <translation>“%1”中已有工程。选择另一个文件夹。</translation>
    </message>
    <message>
        <source>&quot;%1&quot; and &quot;%2&quot; are both main programs. Only one may be; make the other a subroutine.</source>
        <translation>“%1”和“%2”都是主程序。只能有一个；将另一个改为子程序。</translation>
    </message>
    <message>
        <source>&quot;%1&quot; and &quot;%2&quot; both hold the object &quot;%3&quot;. Remove or rename one of them.</source>
        <translation>“%1”和“%2”都包含对象“%3”。删除或重命名其中一个。</translation>
    </message>
    <message>
        <source>&quot;%1&quot; and &quot;%2&quot; lie on the same memory at %3.</source>
        <translation>“%1”和“%2”在 %3 处占用同一内存。</translation>
    </message>
    <message>
        <source>&quot;%1&quot; asks for %2 at once; the limit is %3.</source>
        <translation>“%1”一次请求 %2 个；上限为 %3。</translation>
    </message>
    <message>
        <source>&quot;%1&quot; becomes a retained value.</source>
        <translation>“%1”变为断电保持值。</translation>
    </message>
    <message>
        <source>&quot;%1&quot; cannot be a subscript. A subscript is a number, an INT or DINT variable, or an element of an array with a number.</source>
        <translation>“%1”不能作下标。下标是数字、INT 或 DINT 变量，或带数字下标的数组元素。</translation>
    </message>
    <message>
        <source>&quot;%1&quot; cannot be used as %2. It can be %3.</source>
        <translation>“%1”不能用作 %2。可用作：%3。</translation>
    </message>
    <message>
        <source>&quot;%1&quot; cannot be used as a name. A name begins with a letter, goes on with letters, digits or _, and is not an address, a type or an instruction.</source>
        <translation>“%1”不能用作名称。名称以字母开头，其后为字母、数字或 _，且不得是地址、类型或指令。</translation>
    </message>
    <message>
        <source>&quot;%1&quot; cannot be written: %2. The old program is untouched.</source>
        <translation>无法写入“%1”：%2。旧程序未受影响。</translation>
    </message>
    <message>
        <source>&quot;%1&quot; does not declare a parameter. Write it like %2.</source>
        <translation>“%1”不是参数声明。请写成 %2 的形式。</translation>
    </message>
    <message>
        <source>&quot;%1&quot; has a foreign word inside an address. Write %2.</source>
        <translation>“%1”的地址中夹有外来文字。写作 %2。</translation>
    </message>
    <message>
        <source>&quot;%1&quot; has a letter that only looks Latin (%2). Write %3.</source>
        <translation>“%1”中有形似拉丁字母的字符（%2）。写作 %3。</translation>
    </message>
    <message>
        <source>&quot;%1&quot; has blanks inside. Write %2.</source>
        <translation>“%1”内有空格。写作 %2。</translation>
    </message>
    <message>
        <source>&quot;%1&quot; has the backslashes of a Markdown document. Write %2.</source>
        <translation>“%1”带有 Markdown 文档的反斜杠。写作 %2。</translation>
    </message>
    <message>
        <source>&quot;%1&quot; has the digit %2, but these numbers are octal: use the digits 0 to 7.</source>
        <translation>“%1”含有数字 %2，但这些编号是八进制：只用 0 至 7。</translation>
    </message>
    <message>
        <source>&quot;%1&quot; holds the character &quot;%2&quot;, which no address has. Type Latin letters and digits without blanks.</source>
        <translation>“%1”含有字符“%2”，地址中没有这种字符。用拉丁字母和数字，不带空格。</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is larger than %2 bytes. No file of a project may be that large.</source>
        <translation>“%1”大于 %2 字节。工程中的文件不得超过此大小。</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is marked as retained, but its address %2 is not kept at power-off. Whether a value is kept depends on its address.</source>
        <translation>“%1”标记为断电保持，但其地址 %2 断电后不保持。是否保持由地址决定。</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is neither an address, a constant, nor the name of a variable.</source>
        <translation>“%1”既不是地址、常数，也不是变量名。</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is neither the number nor the name of an axis.</source>
        <translation>“%1”既不是轴号也不是轴名。</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is no role of a program. The roles are %2.</source>
        <translation>“%1”不是程序的角色。可用角色：%2。</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is not a Camwright project: it holds no file project.toml.</source>
        <translation>“%1”不是 Camwright 工程：其中没有 project.toml 文件。</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is not a character of a string. Write $$, $&apos;, $L, $N, $P, $R, $T, or $ and two hexadecimal digits.</source>
        <translation>“%1”不是字符串的字符。请写 $$、$&apos;、$L、$N、$P、$R、$T，或 $ 加两位十六进制数。</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is not a complete address. Write it like &quot;%2&quot;.</source>
        <translation>“%1”不是完整的地址。写法示例：“%2”。</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is not a constant of type %2. Write it like %3.</source>
        <translation>“%1”不是 %2 类型的常数。写法示例：%3。</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is not a date or a time of day. Write it like %2, with a year from 1970 to 2261.</source>
        <translation>“%1”不是日期或时刻。请写成 %2 的形式，年份为 1970 至 2261。</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is not a duration. Write it like %2: from days to nanoseconds (d, h, m, s, ms, us, ns).</source>
        <translation>“%1”不是时间长度。请写成 %2 的形式：从天到纳秒 (d, h, m, s, ms, us, ns)。</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is not a form of area %2. Its forms are %3.</source>
        <translation>“%1”不是存储区 %2 的写法。可用写法：%3。</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is not a name. A name has letters A to Z, digits and single underscores between them, at most %2.</source>
        <translation>“%1”不是名称。名称由字母 A 到 Z、数字和其间的单个下划线组成，最多 %2 个字符。</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is not a number, as %2 has to be.</source>
        <translation>“%1”不是数，而 %2 必须是数。</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is not a number. Write it like %2.</source>
        <translation>“%1”不是数。请写成 %2 的形式。</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is not a value of type %2. Write it like %3.</source>
        <translation>“%1”不是 %2 类型的值。写法示例：%3。</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is not a whole number, as %2 has to be.</source>
        <translation>“%1”不是整数，而 %2 必须是整数。</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is not an address.</source>
        <translation>“%1”不是地址。</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is not an event that starts an interrupt routine. Write it like %2.</source>
        <translation>“%1”不是可以启动中断程序的事件。请写成 %2 的形式。</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is not an instruction and not a comment. Remove it, or write it as (* %1 *).</source>
        <translation>“%1”既不是指令也不是注释。删除它，或写作 (* %1 *)。</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is not an instruction of %2.</source>
        <translation>“%1”不是 %2 的指令。</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is not an instruction of %2. Did you mean %3?</source>
        <translation>“%1”不是 %2 的指令。是否指 %3？</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is not an operand. An operand is an address such as %2, a constant, or a name.</source>
        <translation>“%1”不是操作数。操作数是地址（如 %2）、常数或名称。</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is not legal in column &quot;%2&quot;. Legal is: %3.</source>
        <translation>“%1”在列“%2”中不合法。合法值：%3。</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is not one of the values of %2, which are %3.</source>
        <translation>“%1”不是 %2 的可用值。可用值：%3。</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is not the address of a controller. Write local or tcp://HOST[:PORT].</source>
        <translation>“%1”不是控制器的地址。写 local 或 tcp://HOST[:PORT]。</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is not the name of a file of a project. Give it a name without %, or remove it from the project&apos;s folder.</source>
        <translation>“%1”不是工程文件的名称。改为不含 % 的名称，或将其移出工程文件夹。</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is not there.</source>
        <translation>“%1”不存在。</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is to be a list in square brackets.</source>
        <translation>“%1”应为方括号内的列表。</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is to be a single value, not a list or a table.</source>
        <translation>“%1”应为单个值，而不是列表或表。</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is to be a table of keys and values.</source>
        <translation>“%1”应为键和值组成的表。</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is to be a text in quotation marks.</source>
        <translation>“%1”应为引号内的文本。</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is to be a whole number.</source>
        <translation>“%1”应为整数。</translation>
    </message>
    <message>
        <source>&quot;%1&quot; lies outside its memory area. On %2 the legal range is %3 to %4.</source>
        <translation>“%1”超出其存储区。在 %2 上合法范围为 %3 至 %4。</translation>
    </message>
    <message>
        <source>&quot;%1&quot; looks like several operands. Separate them by commas: %2.</source>
        <translation>“%1”看起来是多个操作数。用逗号分开：%2。</translation>
    </message>
    <message>
        <source>&quot;%1&quot; mixes Latin letters with letters of another alphabet that look alike. Whoever types the name may not find it.</source>
        <translation>“%1”混有拉丁字母和形状相似的其他字母。输入此名称的人可能找不到它。</translation>
    </message>
    <message>
        <source>&quot;%1&quot; names bit %2. The bits are 0 to %3.</source>
        <translation>“%1”指定了位 %2。位号为 0 至 %3。</translation>
    </message>
    <message>
        <source>&quot;%1&quot; names no memory area of %2. The areas are %3.</source>
        <translation>“%1”不对应 %2 的任何存储区。存储区：%3。</translation>
    </message>
    <message>
        <source>&quot;%1&quot; needs control. Take control first.</source>
        <translation>“%1”需要控制权。先取得控制权。</translation>
    </message>
    <message>
        <source>&quot;%1&quot; needs more rights than this connection has.</source>
        <translation>“%1”需要比此连接更高的权限。</translation>
    </message>
    <message>
        <source>&quot;%1&quot; stands twice in column &quot;%2&quot;.</source>
        <translation>“%1”在列“%2”中出现两次。</translation>
    </message>
    <message>
        <source>&quot;%1&quot; starts at an odd byte. Words, double words and reals start at an even one: use &quot;%2&quot; or &quot;%3&quot;.</source>
        <translation>“%1”从奇数字节开始。字、双字和实数须从偶数字节开始：使用“%2”或“%3”。</translation>
    </message>
    <message>
        <source>%1 belongs to nothing that is open here. Remove it, or write what it ends.</source>
        <translation>这里没有未结束的结构与 %1 对应。请删除它，或写上由它结束的内容。</translation>
    </message>
    <message>
        <source>%1 bit/s is not a baud rate of the network. Choose one of %2.</source>
        <translation>%1 bit/s 不是该网络的波特率。可选：%2。</translation>
    </message>
    <message>
        <source>%1 calls itself, directly or through others. Write a loop instead.</source>
        <translation>%1 直接或间接调用自身。请改写成循环。</translation>
    </message>
    <message>
        <source>%1 cannot be called.</source>
        <translation>%1 不能调用。</translation>
    </message>
    <message>
        <source>%1 cannot be compiled by this version of Camwright. See the page of Structured Text for what can be.</source>
        <translation>此版本的 Camwright 不能编译 %1。可编译的内容见结构化文本的说明。</translation>
    </message>
    <message>
        <source>%1 cannot be the operand %2 of %3. The memory areas allowed are %4.</source>
        <translation>%1 不能作为 %3 的操作数 %2。允许的存储区：%4。</translation>
    </message>
    <message>
        <source>%1 cannot be the place of a variable of type %2 on this controller.</source>
        <translation>在此控制器上，%1 不能作为 %2 类型变量的位置。</translation>
    </message>
    <message>
        <source>%1 cannot be written here, it is %2.</source>
        <translation>这里不能写入 %1，它是%2。</translation>
    </message>
    <message>
        <source>%1 cannot stand here.</source>
        <translation>%1 不能位于此处。</translation>
    </message>
    <message>
        <source>%1 clients are connected already; no more are taken.</source>
        <translation>已连接 %1 个客户端，不再接受更多。</translation>
    </message>
    <message>
        <source>%1 connected.</source>
        <translation>%1 已连接。</translation>
    </message>
    <message>
        <source>%1 contains itself. Break the circle, for instance with REF_TO.</source>
        <translation>%1 包含自身。请打破循环，例如用 REF_TO。</translation>
    </message>
    <message>
        <source>%1 disconnected.</source>
        <translation>%1 已断开。</translation>
    </message>
    <message>
        <source>%1 does not belong here. SBR is the first instruction of a program of the role subroutine, RT and RTC stand in one.</source>
        <translation>%1 不应在此处。SBR 是子程序角色的程序的第一条指令，RT 和 RTC 只能用在子程序中。</translation>
    </message>
    <message>
        <source>%1 does not exist for %2 and %3.</source>
        <translation>%1 不适用于 %2 和 %3。</translation>
    </message>
    <message>
        <source>%1 does not exist for %2.</source>
        <translation>%1 不适用于 %2。</translation>
    </message>
    <message>
        <source>%1 has control. It is free as soon as they release it or their connection ends.</source>
        <translation>控制权在 %1 手中。对方释放控制权或其连接结束后即可取得。</translation>
    </message>
    <message>
        <source>%1 has no effect on the virtual controller, which does not imitate it yet. On the real controller it runs.</source>
        <translation>%1 在虚拟控制器上不起作用：尚未仿真该指令。在真实控制器上可以运行。</translation>
    </message>
    <message>
        <source>%1 has no effect on the virtual controller: pulse outputs are not simulated yet. On the real controller it runs.</source>
        <translation>%1 在虚拟控制器上不起作用：尚未仿真脉冲输出。在真实控制器上可以运行。</translation>
    </message>
    <message>
        <source>%1 has no letter in front. Write K%1 for a number, or O%1 for an octal address.</source>
        <translation>%1 前面没有字母。数值写作 K%1，八进制地址写作 O%1。</translation>
    </message>
    <message>
        <source>%1 has no member %2.</source>
        <translation>%1 没有成员 %2。</translation>
    </message>
    <message>
        <source>%1 has no operand named %2. Its operands are %3.</source>
        <translation>%1 没有名为 %2 的操作数。其操作数：%3。</translation>
    </message>
    <message>
        <source>%1 has no parameter %2.</source>
        <translation>%1 没有参数 %2。</translation>
    </message>
    <message>
        <source>%1 has no parameters. Write the call without further operands.</source>
        <translation>%1 没有参数。调用时不要写其他操作数。</translation>
    </message>
    <message>
        <source>%1 has no power flow in front of it. A rung begins with %2.</source>
        <translation>%1 之前没有能流。梯级以 %2 开始。</translation>
    </message>
    <message>
        <source>%1 implements %2 and has no method %3. Write it with the same parameters.</source>
        <translation>%1 实现 %2，但没有方法 %3。请写出参数相同的该方法。</translation>
    </message>
    <message>
        <source>%1 is %2 and %3 is %4. The operands of %5 have one common type.</source>
        <translation>%1 是 %2，%3 是 %4。%5 的操作数须为同一类型。</translation>
    </message>
    <message>
        <source>%1 is %2. The operand %3 of %4 is %5.</source>
        <translation>%1 是 %2，而 %4 的操作数 %3 须为 %5。</translation>
    </message>
    <message>
        <source>%1 is a constant, and %3 writes its result into the operand %2. Write an address.</source>
        <translation>%1 是常数，而 %3 要将结果写入操作数 %2。写一个地址。</translation>
    </message>
    <message>
        <source>%1 is a word of the language and cannot be a name. Choose another name.</source>
        <translation>%1 是语言的保留字，不能作名称。请换一个名称。</translation>
    </message>
    <message>
        <source>%1 is an array. Write which element is meant, like %1[0].</source>
        <translation>%1 是数组。请写明是哪个元素，如 %1[0]。</translation>
    </message>
    <message>
        <source>%1 is an extension of Camwright and strict Kinco is set. Write the group to a marker bit in a network of its own, and use the bit here.</source>
        <translation>%1 是 Camwright 的扩展，而已设为严格 Kinco。在单独的网络中将该组写入标志位，并在此使用该位。</translation>
    </message>
    <message>
        <source>%1 is declared already. Choose another name.</source>
        <translation>%1 已经声明过。请换一个名称。</translation>
    </message>
    <message>
        <source>%1 is given twice.</source>
        <translation>%1 给出了两次。</translation>
    </message>
    <message>
        <source>%1 is missing here.</source>
        <translation>这里缺少 %1。</translation>
    </message>
    <message>
        <source>%1 is needed here, and this is %2.</source>
        <translation>这里需要 %1，而这是 %2。</translation>
    </message>
    <message>
        <source>%1 is needed here, and this is %2. Convert it with %3.</source>
        <translation>这里需要 %1，而这是 %2。请用 %3 转换。</translation>
    </message>
    <message>
        <source>%1 is no usable %2 for axis &quot;%3&quot;.</source>
        <translation>%1 不能用作轴“%3”的 %2。</translation>
    </message>
    <message>
        <source>%1 is not %2.</source>
        <translation>%1 不是%2。</translation>
    </message>
    <message>
        <source>%1 is not a communication cycle. It is 1000 to 8000 microseconds, in BCD.</source>
        <translation>%1 不是有效的通讯周期。范围为 1000～8000 微秒，以 BCD 表示。</translation>
    </message>
    <message>
        <source>%1 is not a decimal number, and the operand %2 counts in BCD. Write decimal digits behind the K.</source>
        <translation>%1 不是十进制数，而操作数 %2 以 BCD 计数。K 之后请写十进制数字。</translation>
    </message>
    <message>
        <source>%1 is not a number of stations. A module takes 1 to 15, in BCD.</source>
        <translation>%1 不是有效的局数。一个模块可接 1～15 局，以 BCD 表示。</translation>
    </message>
    <message>
        <source>%1 is not a subroutine and cannot be called. Change its role to subroutine.</source>
        <translation>%1 不是子程序，不能调用。将其角色改为子程序。</translation>
    </message>
    <message>
        <source>%1 is not an address of this machine itself. Until users and encryption exist the runtime listens on 127.0.0.1 or ::1 only.</source>
        <translation>%1 不是本机自身的地址。在具备用户和加密功能之前，运行时只在 127.0.0.1 或 ::1 上侦听。</translation>
    </message>
    <message>
        <source>%1 is not an interrupt routine. Change its role to interrupt, or correct the name.</source>
        <translation>%1 不是中断程序。请将其角色改为中断，或更正名称。</translation>
    </message>
    <message>
        <source>%1 is not closed. Write %2 where it ends.</source>
        <translation>%1 没有结束。请在其末尾写上 %2。</translation>
    </message>
    <message>
        <source>%1 is out of range for %2, which goes from %3 to %4.</source>
        <translation>%1 超出 %2 的范围（%3 至 %4）。</translation>
    </message>
    <message>
        <source>%1 is outside the range of %2, which is %3 to %4.</source>
        <translation>%1 超出 %2 的范围（%3 至 %4）。</translation>
    </message>
    <message>
        <source>%1 is outside the range of the operand %2 of %3, which is %4 to %5.</source>
        <translation>%1 超出 %3 的操作数 %2 的范围（%4 至 %5）。</translation>
    </message>
    <message>
        <source>%1 is recording a trace. There is one recorder; it is free when they stop.</source>
        <translation>%1 正在记录跟踪。记录器只有一个；对方停止后即可使用。</translation>
    </message>
    <message>
        <source>%1 is set to %2, and the operand %3 of %4 takes %5 to %6.</source>
        <translation>%1 被设为 %2，而 %4 的操作数 %3 范围为 %5～%6。</translation>
    </message>
    <message>
        <source>%1 is the coil of two rungs. Only the last one counts in each scan.</source>
        <translation>%1 是两个梯级的线圈。每次扫描中只有最后一个有效。</translation>
    </message>
    <message>
        <source>%1 is timed or counted at two places. Both change the same value.</source>
        <translation>%1 在两处计时或计数。两处都改变同一个值。</translation>
    </message>
    <message>
        <source>%1 joins two flows, and only one is open here. Begin the second one with LD.</source>
        <translation>%1 连接两路能流，而此处只有一路。用 LD 开始第二路。</translation>
    </message>
    <message>
        <source>%1 lacks the operand %2. It is written %3.</source>
        <translation>%1 缺少操作数 %2。写法：%3。</translation>
    </message>
    <message>
        <source>%1 lies in the registers %2 to %3 that the module in slot %4 uses. Take other registers.</source>
        <translation>%1 位于槽位 %4 的模块所用的寄存器 %2～%3 内。请使用其他寄存器。</translation>
    </message>
    <message>
        <source>%1 lies in the work area of %2, which begins at %3. Nothing else may use it.</source>
        <translation>%1 位于 %2 的缓存区内（起始于 %3），该区域不得用于其他用途。</translation>
    </message>
    <message>
        <source>%1 may occur %2 times in a project. This one is too many.</source>
        <translation>%1 在一个工程中可出现 %2 次。这一次已超出。</translation>
    </message>
    <message>
        <source>%1 may occur once for each axis. Axis %2 has one already.</source>
        <translation>%1 每个轴只能出现一次。轴 %2 已有一个。</translation>
    </message>
    <message>
        <source>%1 motion cycles came late. Controller time slipped; nothing was made up for.</source>
        <translation>%1 个运动周期延迟。控制器时间随之推迟，未作补偿。</translation>
    </message>
    <message>
        <source>%1 needs an MPS before it.</source>
        <translation>%1 之前需要 MPS。</translation>
    </message>
    <message>
        <source>%1 needs axes on a CAN port, and a %2 has none. Choose another model, or remove the instruction.</source>
        <translation>%1 需要 CAN 口上的轴，而 %2 没有。选择另一型号，或删除该指令。</translation>
    </message>
    <message>
        <source>%1 needs pulse outputs, and a %2 has none. Choose another model, or remove the instruction.</source>
        <translation>%1 需要脉冲输出，而 %2 没有。选择另一型号，或删除该指令。</translation>
    </message>
    <message>
        <source>%1 sent something that is no message of the online protocol: %2. The connection was closed.</source>
        <translation>%1 发来的内容不是在线协议的报文：%2。连接已关闭。</translation>
    </message>
    <message>
        <source>%1 stands outside of every loop.</source>
        <translation>%1 位于所有循环之外。</translation>
    </message>
    <message>
        <source>%1 stands outside of everything that is declared. A text holds TYPE, FUNCTION, FUNCTION_BLOCK, INTERFACE, PROGRAM, VAR_GLOBAL and CONFIGURATION.</source>
        <translation>%1 位于所有声明之外。文本由 TYPE、FUNCTION、FUNCTION_BLOCK、INTERFACE、PROGRAM、VAR_GLOBAL 和 CONFIGURATION 组成。</translation>
    </message>
    <message>
        <source>%1 takes %2 arguments, here are %3.</source>
        <translation>%1 需要 %2 个参数，这里有 %3 个。</translation>
    </message>
    <message>
        <source>%1 takes %2 arguments, here are %3. They are %4.</source>
        <translation>%1 需要 %2 个参数，此处为 %3 个。参数为：%4。</translation>
    </message>
    <message>
        <source>%1 takes %2 flows, and fewer are open here. Begin each of them with STR.</source>
        <translation>%1 需要 %2 个能流，此处不足。每个能流都以 STR 开始。</translation>
    </message>
    <message>
        <source>%1 takes %2 operands, here are %3. It is written %4.</source>
        <translation>%1 需要 %2 个操作数，此处为 %3 个。写法：%4。</translation>
    </message>
    <message>
        <source>%1 takes %2 parameter numbers from %3, and the programs write only the first %4. The others will be parameter 0.</source>
        <translation>%1 从 %3 起取 %2 个参数号，而程序只写了前 %4 个。其余将是参数 0。</translation>
    </message>
    <message>
        <source>%2 has no variables of type %1. The types are %3.</source>
        <translation>%2 没有 %1 类型的变量。可用类型：%3。</translation>
    </message>
    <message>
        <source>= compares two values. Write := to assign one.</source>
        <translation>= 用于比较两个值。赋值请写 :=。</translation>
    </message>
    <message>
        <source>A FOR cannot step by 0.</source>
        <translation>FOR 的步长不能为 0。</translation>
    </message>
    <message>
        <source>A Kinco axis moves with its drive&apos;s own acceleration. Leave the acceleration at 0, or set drive parameters 0 and 1 with MC_WPARAS.</source>
        <translation>Kinco 轴按其驱动器自身的加速度运动。将加速度保持为 0，或用 MC_WPARAS 设置驱动器参数 0 和 1。</translation>
    </message>
    <message>
        <source>A constant is needed here: its value must be known before the program runs.</source>
        <translation>这里需要常量：其值必须在程序运行前已知。</translation>
    </message>
    <message>
        <source>A download is already being taken over. Wait until it has ended.</source>
        <translation>正在接管一个下载。等待其结束。</translation>
    </message>
    <message>
        <source>A line of ``` belongs to a document, not to a program. Remove it.</source>
        <translation>``` 行属于文档，不属于程序。删除它。</translation>
    </message>
    <message>
        <source>A network has one %1. Begin a new network here, or use AND and OR.</source>
        <translation>一个网络只有一个 %1。在此开始新网络，或用 AND 和 OR。</translation>
    </message>
    <message>
        <source>A piece of the download came for byte %1, but byte %2 is next. The download was dropped; the old program is untouched.</source>
        <translation>收到的下载片段属于字节 %1，而应为字节 %2。下载已放弃；旧程序未受影响。</translation>
    </message>
    <message>
        <source>A program cannot send the command %1h: the module generates INTERPOLATE (34h) itself, and does not support 1Bh, 38h, 3Eh and 3Fh.</source>
        <translation>程序不能发送命令 %1h：INTERPOLATE（34h）由模块自行生成，1Bh、38h、3Eh 和 3Fh 不受支持。</translation>
    </message>
    <message>
        <source>A program is taken only in STOP. Stop the controller first.</source>
        <translation>只有在 STOP 时才接收程序。先停止控制器。</translation>
    </message>
    <message>
        <source>A program of %1 bytes is too large; the controller takes up to %2 bytes.</source>
        <translation>%1 字节的程序太大；控制器最多接收 %2 字节。</translation>
    </message>
    <message>
        <source>A quoted cell does not end. Close it with a quotation mark followed by a comma or the end of the line.</source>
        <translation>带引号的单元格没有结束。用引号结束，其后接逗号或行尾。</translation>
    </message>
    <message>
        <source>A real %1 has no Structured Text. This program runs on the virtual controller only.</source>
        <translation>真实的 %1 没有结构化文本。此程序只在虚拟控制器上运行。</translation>
    </message>
    <message>
        <source>A subroutine has at most %1 parameters and local variables of this kind; %2 is one too many.</source>
        <translation>一个子程序最多有 %1 个此类参数和局部变量；%2 已超出。</translation>
    </message>
    <message>
        <source>A trace needs at least one channel and at most %1.</source>
        <translation>跟踪至少需要一个通道，最多 %1 个。</translation>
    </message>
    <message>
        <source>A variable is needed here.</source>
        <translation>这里需要变量。</translation>
    </message>
    <message>
        <source>All axes were stopped by command.</source>
        <translation>所有轴已按命令停止。</translation>
    </message>
    <message>
        <source>An axis has no value &quot;%1&quot;. It has position, setPosition, velocity, followingError, torque, state and error.</source>
        <translation>轴没有值“%1”。可用：position、setPosition、velocity、followingError、torque、state 和 error。</translation>
    </message>
    <message>
        <source>An interrupt routine of a %1 cannot call %2. Write its instructions here.</source>
        <translation>%1 的中断程序不能调用 %2。请将其指令写在此处。</translation>
    </message>
    <message>
        <source>An operand is missing beside the comma. Write it, or ??? to fill it in later.</source>
        <translation>逗号旁缺少操作数。补上它，或写 ??? 留待以后填写。</translation>
    </message>
    <message>
        <source>Another Camwright is working on this project (&quot;%1&quot; is locked). Close the project there to edit it here.</source>
        <translation>另一个 Camwright 正在编辑此工程（“%1”已锁定）。在那里关闭工程后才能在此编辑。</translation>
    </message>
    <message>
        <source>Another program changed &quot;%1&quot; since it was read here. Nothing was written. Reload the project, or save over the change.</source>
        <translation>“%1”在此处读取之后被另一个程序修改。未写入任何内容。请重新加载工程，或覆盖该修改。</translation>
    </message>
    <message>
        <source>Another program changed &quot;%1&quot; while a save was interrupted. Its version is kept as &quot;%2&quot;.</source>
        <translation>保存中断期间另一个程序修改了“%1”。其版本保留为“%2”。</translation>
    </message>
    <message>
        <source>Axis &quot;%1&quot; changes.</source>
        <translation>轴“%1”有改变。</translation>
    </message>
    <message>
        <source>Axis &quot;%1&quot; could not be started on the bus. Check the drive&apos;s supply, node number and baud rate, then restart the node or the controller.</source>
        <translation>轴“%1”无法在总线上启动。检查驱动器电源、节点号和波特率，然后重启节点或控制器。</translation>
    </message>
    <message>
        <source>Axis &quot;%1&quot; is in Errorstop. Remove the cause and reset it first.</source>
        <translation>轴“%1”处于 Errorstop。排除原因并先复位。</translation>
    </message>
    <message>
        <source>Axis &quot;%1&quot; is new.</source>
        <translation>轴“%1”是新的。</translation>
    </message>
    <message>
        <source>Axis &quot;%1&quot; is not armed. Arm it first, and keep the heartbeats coming while it moves.</source>
        <translation>轴“%1”的面板控制未激活。先激活，并在该轴移动期间保持心跳。</translation>
    </message>
    <message>
        <source>Axis &quot;%1&quot; is not enabled. Enable it first.</source>
        <translation>轴“%1”未使能。先使能它。</translation>
    </message>
    <message>
        <source>Axis &quot;%1&quot; is not on the bus.</source>
        <translation>轴“%1”不在总线上。</translation>
    </message>
    <message>
        <source>Axis &quot;%1&quot; is removed.</source>
        <translation>轴“%1”被删除。</translation>
    </message>
    <message>
        <source>Axis &quot;%1&quot; is still moving. Stop it, or wait until it stands.</source>
        <translation>轴“%1”仍在运动。停止它，或等待其静止。</translation>
    </message>
    <message>
        <source>Axis &quot;%1&quot; is stopped, then released: its power goes off.</source>
        <translation>轴“%1”停止后释放：其动力断开。</translation>
    </message>
    <message>
        <source>Axis &quot;%1&quot; loses its home position; home it again before absolute moves.</source>
        <translation>轴“%1”丢失原点；绝对移动之前须重新回原点。</translation>
    </message>
    <message>
        <source>Axis &quot;%1&quot; no longer answers on the bus. Mend the connection, then restart the node or the controller.</source>
        <translation>轴“%1”在总线上不再应答。修复连接，然后重启节点或控制器。</translation>
    </message>
    <message>
        <source>Axis &quot;%1&quot; was stopped: no heartbeat came from the panel. Last heartbeat in cycle %2, stop command at the bus in cycle %3.</source>
        <translation>轴“%1”已停止：面板没有心跳。最后一次心跳在周期 %2，总线上的停止命令在周期 %3。</translation>
    </message>
    <message>
        <source>Axis &quot;%1&quot;: the drive reports alarm %2. Remove its cause, then reset the axis.</source>
        <translation>轴“%1”：驱动器报警 %2。排除原因后复位该轴。</translation>
    </message>
    <message>
        <source>Axis 1 and axis 2 of %1 are taken from the same register %2. Two axes are needed.</source>
        <translation>%1 的轴 1 和轴 2 取自同一寄存器 %2。需要两个不同的轴。</translation>
    </message>
    <message>
        <source>Axis node %1 does not answer (object %2). Check its supply, the cable, its node number and the baud rate.</source>
        <translation>轴节点 %1 不应答（对象 %2）。检查其电源、电缆、节点号和波特率。</translation>
    </message>
    <message>
        <source>Axis node %1 gave an answer about object %2 that does not fit the request. Check that no two nodes have the same number.</source>
        <translation>轴节点 %1 对对象 %2 的应答与请求不符。检查是否有两个节点编号相同。</translation>
    </message>
    <message>
        <source>Axis node %1 is configured and operational.</source>
        <translation>轴节点 %1 已配置并处于运行状态。</translation>
    </message>
    <message>
        <source>Axis node %1 is offline. Mend the cause, then restart the axis with MC_RESTART or stop and start the controller.</source>
        <translation>轴节点 %1 离线。排除原因，然后用 MC_RESTART 重启该轴，或停止并启动控制器。</translation>
    </message>
    <message>
        <source>Axis node %1 refuses object %2 with abort code %3: %4. Check whether the drive has this object and the value is in its range.</source>
        <translation>轴节点 %1 拒绝对象 %2，中止码 %3：%4。检查驱动器是否有此对象，以及值是否在其范围内。</translation>
    </message>
    <message>
        <source>Axis node %1 reports error %2 (error register %3). Look the number up in the drive&apos;s manual.</source>
        <translation>轴节点 %1 报告错误 %2（错误寄存器 %3）。在驱动器手册中查找该编号。</translation>
    </message>
    <message>
        <source>Axis node %1 reports that its error is gone.</source>
        <translation>轴节点 %1 报告其错误已消失。</translation>
    </message>
    <message>
        <source>Axis node %1 still works on the previous request. Wait for its answer before sending the next one.</source>
        <translation>轴节点 %1 仍在处理上一个请求。等到其应答后再发送下一个。</translation>
    </message>
    <message>
        <source>Axis number %1 is used by &quot;%2&quot; and by &quot;%3&quot;. Give one of them another number.</source>
        <translation>轴号 %1 被“%2”和“%3”同时使用。给其中一个换号。</translation>
    </message>
    <message>
        <source>Axis values are read-only. Use an axis command to move an axis.</source>
        <translation>轴值为只读。用轴命令移动轴。</translation>
    </message>
    <message>
        <source>Branches are nested more than %1 deep here. Split the rung with a marker bit.</source>
        <translation>此处分支嵌套超过 %1 层。用标志位拆分梯级。</translation>
    </message>
    <message>
        <source>Calls nest %1 deep here: %2. A %3 takes %4.</source>
        <translation>此处调用嵌套 %1 层：%2。%3 最多允许 %4 层。</translation>
    </message>
    <message>
        <source>Camwright made a mistake: %1. Save your work under another name and report this text.</source>
        <translation>Camwright 出现内部错误：%1。请用另一个名称保存工作，并报告这段文字。</translation>
    </message>
    <message>
        <source>Cancelled. Nothing was changed.</source>
        <translation>已取消，未作任何更改。</translation>
    </message>
    <message>
        <source>Column &quot;%1&quot; is missing from the header.</source>
        <translation>表头缺少列“%1”。</translation>
    </message>
    <message>
        <source>Control of %1 lapsed because it was not renewed. What a panel moved was stopped; power stays on.</source>
        <translation>%1 的控制权未续期，已失效。面板所移动的轴已停止；动力保持接通。</translation>
    </message>
    <message>
        <source>Expected %1, found &quot;%2&quot;.</source>
        <translation>此处应为 %1，却是“%2”。</translation>
    </message>
    <message>
        <source>Forced values are released: %1.</source>
        <translation>强制值将被释放：%1。</translation>
    </message>
    <message>
        <source>Here stands %1, and %2 is expected.</source>
        <translation>这里是 %1，应为 %2。</translation>
    </message>
    <message>
        <source>Listening on %1 failed: %2.</source>
        <translation>在 %1 上侦听失败：%2。</translation>
    </message>
    <message>
        <source>No axis has the number %1, though a higher one is in use. Axis numbers go from 1 without a gap.</source>
        <translation>没有编号为 %1 的轴，却使用了更大的编号。轴号须从 1 起连续。</translation>
    </message>
    <message>
        <source>Nobody answers at %1: %2.</source>
        <translation>%1 无人应答：%2。</translation>
    </message>
    <message>
        <source>Nothing starts the interrupt routine %1. Give it an event, or remove it.</source>
        <translation>没有任何事件启动中断程序 %1。请为其指定事件，或将其删除。</translation>
    </message>
    <message>
        <source>Operands of %1 are separated by blanks. Remove the comma.</source>
        <translation>%1 的操作数用空格分开。删除逗号。</translation>
    </message>
    <message>
        <source>Program &quot;%1&quot; (%2) was loaded. The controller stands in STOP until it is started.</source>
        <translation>已载入程序“%1”(%2)。控制器处于 STOP，直到被启动。</translation>
    </message>
    <message>
        <source>Program &quot;%1&quot; changes.</source>
        <translation>程序“%1”有改变。</translation>
    </message>
    <message>
        <source>Program &quot;%1&quot; is new.</source>
        <translation>程序“%1”是新的。</translation>
    </message>
    <message>
        <source>Program &quot;%1&quot; is removed.</source>
        <translation>程序“%1”被删除。</translation>
    </message>
    <message>
        <source>Program %1 was taken over from %2.</source>
        <translation>已从 %2 接管程序 %1。</translation>
    </message>
    <message>
        <source>Statements, parentheses or types are nested more than %1 deep here. Split them up.</source>
        <translation>这里的语句、括号或类型嵌套超过 %1 层。请拆开。</translation>
    </message>
    <message>
        <source>Subroutine calls nest deeper than %1 levels. Call &quot;%2&quot; from a routine nearer to the main program.</source>
        <translation>子程序调用嵌套超过 %1 层。从更接近主程序的子程序中调用“%2”。</translation>
    </message>
    <message>
        <source>The %1 elements that begin at %2 do not fit into the memory area. They need %3 bytes, and %4 are left.</source>
        <translation>从 %2 开始的 %1 个元素超出存储区。需要 %3 字节，只剩 %4 字节。</translation>
    </message>
    <message>
        <source>The CAN send buffer is full, and nothing was sent to axis node %1. Check the cable, the terminators and the load of the bus.</source>
        <translation>CAN 发送缓冲区已满，未向轴节点 %1 发送任何内容。检查电缆、终端电阻和总线负载。</translation>
    </message>
    <message>
        <source>The RUN/STOP switch is at STOP, so the program does not start. Set the switch to RUN.</source>
        <translation>RUN/STOP 开关处于 STOP，程序不启动。将开关拨到 RUN。</translation>
    </message>
    <message>
        <source>The address &quot;%1&quot; lacks its percent sign. Write &quot;%2&quot;.</source>
        <translation>地址“%1”缺少百分号。写作“%2”。</translation>
    </message>
    <message>
        <source>The branch opened by this MPS is not ended. Write MPP before its last branch.</source>
        <translation>此 MPS 打开的分支没有结束。在最后一个分支前写 MPP。</translation>
    </message>
    <message>
        <source>The byte 16#%1 is not UTF-8 text. Save the file as UTF-8.</source>
        <translation>字节 16#%1 不是 UTF-8 文本。将文件保存为 UTF-8。</translation>
    </message>
    <message>
        <source>The character %1 has no meaning here. Remove it.</source>
        <translation>字符 %1 在这里没有意义。请删除。</translation>
    </message>
    <message>
        <source>The comment that begins here is not closed before network %1. End it with *).</source>
        <translation>此处开始的注释在网络 %1 之前没有结束。用 *) 结束它。</translation>
    </message>
    <message>
        <source>The comment that begins here is not closed before the end of the program. End it with *).</source>
        <translation>此处开始的注释到程序结束仍未结束。用 *) 结束它。</translation>
    </message>
    <message>
        <source>The communication cycle of %1 microseconds is too short for %2 stations. It must be longer than %3.</source>
        <translation>通讯周期 %1 微秒对 %2 局来说过短，必须大于 %3。</translation>
    </message>
    <message>
        <source>The connection of %1 was closed: %2.</source>
        <translation>%1 的连接已关闭：%2。</translation>
    </message>
    <message>
        <source>The connection to %1 was lost: %2. A jog or move from a panel stops by itself; the program goes on.</source>
        <translation>与 %1 的连接已断开：%2。面板发出的点动或移动自行停止；程序继续运行。</translation>
    </message>
    <message>
        <source>The controller did not answer &quot;%1&quot; within %2 s. It may still carry it out; look at its state before you repeat it.</source>
        <translation>控制器在 %2 s 内未应答“%1”。它可能仍会执行；重复之前先查看其状态。</translation>
    </message>
    <message>
        <source>The controller has no axis &quot;%1&quot;.</source>
        <translation>控制器没有轴“%1”。</translation>
    </message>
    <message>
        <source>The controller has no program. Download one first.</source>
        <translation>控制器没有程序。先下载一个。</translation>
    </message>
    <message>
        <source>The controller reports %1: %2</source>
        <translation>控制器报告 %1：%2</translation>
    </message>
    <message>
        <source>The controller runs another program (%1) than the one this was made for (%2). Nothing was read or written.</source>
        <translation>控制器运行的是另一个程序（%1），而此请求针对的是 %2。未读取或写入任何内容。</translation>
    </message>
    <message>
        <source>The controller&apos;s settings change: model, scan period, watchdog or memory.</source>
        <translation>控制器的设置有改变：型号、扫描周期、看门狗或内存。</translation>
    </message>
    <message>
        <source>The counter of a FOR is a variable of a whole-number type. This is %1.</source>
        <translation>FOR 的计数变量须为整数类型的变量。这是 %1。</translation>
    </message>
    <message>
        <source>The data folder &quot;%1&quot; is in use by another runtime.</source>
        <translation>数据文件夹“%1”正被另一个运行时使用。</translation>
    </message>
    <message>
        <source>The download from %1 ended before all of it had arrived. The old program is untouched.</source>
        <translation>来自 %1 的下载在全部到达之前结束。旧程序未受影响。</translation>
    </message>
    <message>
        <source>The family %2 has no model &quot;%1&quot;. Known are %3.</source>
        <translation>系列 %2 没有型号“%1”。已知型号：%3。</translation>
    </message>
    <message>
        <source>The file ends where %1 is expected.</source>
        <translation>文件在应有 %1 的地方结束。</translation>
    </message>
    <message>
        <source>The file has no END line. Check that it is complete.</source>
        <translation>文件没有 END 行。检查文件是否完整。</translation>
    </message>
    <message>
        <source>The file is to begin with a line that tells its settings: %1</source>
        <translation>文件应以说明其设置的一行开头：%1</translation>
    </message>
    <message>
        <source>The first line of the file is not the number of networks, like (*5*). The whole text was taken.</source>
        <translation>文件第一行不是网络数（例如 (*5*)）。已采用全部文本。</translation>
    </message>
    <message>
        <source>The first line says %1 networks, and %2 are in the file. Check that the file is complete.</source>
        <translation>第一行写明有 %1 个网络，而文件中有 %2 个。检查文件是否完整。</translation>
    </message>
    <message>
        <source>The flow that begins here is never used. Join it with ANB or ORB, or give it an output.</source>
        <translation>此处开始的能流未被使用。用 ANB 或 ORB 连接它，或给它一个输出。</translation>
    </message>
    <message>
        <source>The function %1 never sets its result. Assign to %1.</source>
        <translation>函数 %1 从未设置结果。请给 %1 赋值。</translation>
    </message>
    <message>
        <source>The group opened by %1 is not closed. Write ) on a line of its own.</source>
        <translation>%1 打开的组没有关闭。单独一行写 )。</translation>
    </message>
    <message>
        <source>The image has format version %1; this program reads version %2. Build the project again with this version.</source>
        <translation>映像的格式版本为 %1；本程序读取版本 %2。用本版本重新编译工程。</translation>
    </message>
    <message>
        <source>The image is damaged: the check sum of its part &quot;%1&quot; is wrong. Build or download it again.</source>
        <translation>映像已损坏：其“%1”部分的校验和错误。重新编译或下载。</translation>
    </message>
    <message>
        <source>The image is incomplete: %1 bytes are there, %2 are needed. Build or download it again.</source>
        <translation>映像不完整：现有 %1 字节，需要 %2 字节。重新编译或下载。</translation>
    </message>
    <message>
        <source>The image would not be safe to run (%1) and is refused. Build the project again with this version.</source>
        <translation>运行该映像不安全（%1），已拒绝。用本版本重新编译工程。</translation>
    </message>
    <message>
        <source>The image&apos;s part &quot;%1&quot; is malformed. Build the project again with this version.</source>
        <translation>映像的“%1”部分格式错误。用本版本重新编译工程。</translation>
    </message>
    <message>
        <source>The label %1 stands at two places. Give one of them another name.</source>
        <translation>标号 %1 出现在两处。请将其中一个改名。</translation>
    </message>
    <message>
        <source>The last save was interrupted; it has now been finished.</source>
        <translation>上次保存曾被中断，现已完成。</translation>
    </message>
    <message>
        <source>The loop that begins with this FOR has no NEXT.</source>
        <translation>以此 FOR 开始的循环没有 NEXT。</translation>
    </message>
    <message>
        <source>The lower limit switch at %1 is not below the upper one at %2.</source>
        <translation>下限位开关 %1 不低于上限位开关 %2。</translation>
    </message>
    <message>
        <source>The main program is written in Structured Text, and its text has no PROGRAM.</source>
        <translation>主程序用结构化文本编写，但其文本中没有 PROGRAM。</translation>
    </message>
    <message>
        <source>The module in slot %1 uses 496 words from %2 on, and they do not fit into the memory there.</source>
        <translation>槽位 %1 的模块从 %2 起占用 496 个字，此处存储器放不下。</translation>
    </message>
    <message>
        <source>The name &quot;%1&quot; is already in use; upper and lower case count as equal.</source>
        <translation>名称“%1”已被使用；大小写视为相同。</translation>
    </message>
    <message>
        <source>The name is empty. Give a name.</source>
        <translation>名称为空。输入一个名称。</translation>
    </message>
    <message>
        <source>The number %1 is too large for any type.</source>
        <translation>数 %1 超出所有类型的范围。</translation>
    </message>
    <message>
        <source>The operand %1 of %2 cannot be left empty.</source>
        <translation>%2 的操作数 %1 不能为空。</translation>
    </message>
    <message>
        <source>The operand %1 of %2 is given twice.</source>
        <translation>%2 的操作数 %1 给出了两次。</translation>
    </message>
    <message>
        <source>The operand %1 of %2 is still to be filled in.</source>
        <translation>%2 的操作数 %1 尚待填写。</translation>
    </message>
    <message>
        <source>The operand %2 of %3 cannot be the constant %1. The memory areas allowed are %4.</source>
        <translation>%3 的操作数 %2 不能是常数 %1。允许的存储区：%4。</translation>
    </message>
    <message>
        <source>The operand %2 of %3 is a constant, %1 is not.</source>
        <translation>%3 的操作数 %2 须为常数，而 %1 不是。</translation>
    </message>
    <message>
        <source>The operand %2 of %3 is a counter, %1 is not. Write it like C0.</source>
        <translation>%3 的操作数 %2 须为计数器，而 %1 不是。写法示例：C0。</translation>
    </message>
    <message>
        <source>The operand %2 of %3 is a timer, %1 is not. Write it like T0.</source>
        <translation>%3 的操作数 %2 须为定时器，而 %1 不是。写法示例：T0。</translation>
    </message>
    <message>
        <source>The operand %2 of %3 takes no variable subscript: %1. Copy the element to a variable first, or write its number.</source>
        <translation>%3 的操作数 %2 不允许变量下标：%1。请先将该元素复制到变量，或写明其编号。</translation>
    </message>
    <message>
        <source>The operands %1 and %2 of %3 share %4. Give each of them registers of its own.</source>
        <translation>%3 的操作数 %1 与 %2 共用 %4。请为它们分别指定寄存器。</translation>
    </message>
    <message>
        <source>The operands %1 of %2 are all constants or all memory. Here they are mixed.</source>
        <translation>%2 的操作数 %1 须全为常数或全为内存。此处混用。</translation>
    </message>
    <message>
        <source>The operating system refused work on &quot;%1&quot;: %2.</source>
        <translation>操作系统拒绝对“%1”的操作：%2。</translation>
    </message>
    <message>
        <source>The other side speaks version %1 of the online protocol, this one speaks version %2. Use programs of the same release.</source>
        <translation>对方使用在线协议版本 %1，本方使用版本 %2。使用同一发行版的程序。</translation>
    </message>
    <message>
        <source>The parameter %1 of %2 is not given. It is VAR_IN_OUT and needs a variable.</source>
        <translation>没有给出 %2 的参数 %1。它是 VAR_IN_OUT，需要变量。</translation>
    </message>
    <message>
        <source>The pragma that begins here is not closed before the end of the text. End it with }.</source>
        <translation>从这里开始的编译指示到文本末尾都没有结束。请用 } 结束它。</translation>
    </message>
    <message>
        <source>The process data of %1 axes would load the bus with %2 % at %3 bit/s. Raise the PDO inhibit times or the baud rate.</source>
        <translation>%1 个轴的过程数据在 %3 bit/s 下使总线负载达 %2 %。增大 PDO 禁止时间或提高波特率。</translation>
    </message>
    <message>
        <source>The program arrived damaged: its digest is %1, not %2. The old program is untouched.</source>
        <translation>收到的程序已损坏：其摘要为 %1，而不是 %2。旧程序未受影响。</translation>
    </message>
    <message>
        <source>The program is executing a motion instruction on axis &quot;%1&quot;. Wait until it has ended, or stop the axis.</source>
        <translation>程序正在轴“%1”上执行运动指令。等待其结束，或停止该轴。</translation>
    </message>
    <message>
        <source>The program runs.</source>
        <translation>程序正在运行。</translation>
    </message>
    <message>
        <source>The program stopped because the RUN/STOP switch was set to STOP.</source>
        <translation>RUN/STOP 开关拨到 STOP，程序已停止。</translation>
    </message>
    <message>
        <source>The program stops, outputs take their STOP values, and the controller stays in STOP until it is started.</source>
        <translation>程序停止，输出取其 STOP 值，控制器保持在 STOP，直到被启动。</translation>
    </message>
    <message>
        <source>The program was stopped by command.</source>
        <translation>程序已按命令停止。</translation>
    </message>
    <message>
        <source>The programs have %1 instructions, a %2 holds %3.</source>
        <translation>程序共有 %1 条指令，而 %2 可容纳 %3 条。</translation>
    </message>
    <message>
        <source>The programs have %1 motion instructions, a %2 takes %3. This is the first too many.</source>
        <translation>程序共有 %1 条运动指令，而 %2 允许 %3 条。这是超出的第一条。</translation>
    </message>
    <message>
        <source>The project does not tell its controller: controller.toml is missing.</source>
        <translation>工程没有说明控制器：缺少 controller.toml。</translation>
    </message>
    <message>
        <source>The project has %1 axes, but a %2 drives at most %3. Remove axes or choose a larger model.</source>
        <translation>工程有 %1 个轴，而 %2 最多驱动 %3 个。删除轴或选择更大的型号。</translation>
    </message>
    <message>
        <source>The project has a second network, &quot;%1&quot;. The controller has one CANopen motion network.</source>
        <translation>工程有第二个网络“%1”。控制器只有一个 CANopen 运动网络。</translation>
    </message>
    <message>
        <source>The project has axes but no network. Add the CANopen motion network.</source>
        <translation>工程有轴但没有网络。添加 CANopen 运动网络。</translation>
    </message>
    <message>
        <source>The project has no main program. Add a program with the role main.</source>
        <translation>工程没有主程序。添加一个角色为 main 的程序。</translation>
    </message>
    <message>
        <source>The project is saved, but not all files could be put in their places: %1. This happens at the next save or opening; until then other programs see a mixture.</source>
        <translation>工程已保存，但并非所有文件都能放到位：%1。下次保存或打开时会完成；在此之前其他程序看到的是新旧混合的文件。</translation>
    </message>
    <message>
        <source>The range %1..%2 is empty or too large.</source>
        <translation>范围 %1..%2 为空或过大。</translation>
    </message>
    <message>
        <source>The record of unsaved edits in &quot;%1&quot; is damaged and cannot be read.</source>
        <translation>“%1”中未保存编辑的记录已损坏，无法读取。</translation>
    </message>
    <message>
        <source>The request to axis node %1 (object %2) was given up before its answer came.</source>
        <translation>对轴节点 %1 的请求（对象 %2）在应答之前已放弃。</translation>
    </message>
    <message>
        <source>The retained data are damaged and were not taken. Memory starts with its initial values.</source>
        <translation>断电保持数据已损坏，未采用。内存以初始值开始。</translation>
    </message>
    <message>
        <source>The retained value of &quot;%1&quot; is lost.</source>
        <translation>“%1”的断电保持值将丢失。</translation>
    </message>
    <message>
        <source>The running program has changed since this name was looked up. Look it up again.</source>
        <translation>查找此名称之后，运行的程序已改变。请重新查找。</translation>
    </message>
    <message>
        <source>The running program knows no &quot;%1&quot;: no address, variable or axis value has this name.</source>
        <translation>运行的程序不认识“%1”：没有此名称的地址、变量或轴值。</translation>
    </message>
    <message>
        <source>The saved state is damaged and was not taken.</source>
        <translation>保存的状态已损坏，未采用。</translation>
    </message>
    <message>
        <source>The scan did not end within its watchdog time of %1 ms, so the program was stopped. Look for a loop without end near %2.</source>
        <translation>扫描未在看门狗时间 %1 ms 内结束，因此程序已停止。在 %2 附近查找死循环。</translation>
    </message>
    <message>
        <source>The settings of the motion network change.</source>
        <translation>运动网络的设置有改变。</translation>
    </message>
    <message>
        <source>The stored program cannot be used: %1. The controller started with %2.</source>
        <translation>存储的程序无法使用：%1。控制器以 %2 启动。</translation>
    </message>
    <message>
        <source>The stored retained values cannot be used: %1. They start with their initial values.</source>
        <translation>存储的断电保持值无法使用：%1。以初始值开始。</translation>
    </message>
    <message>
        <source>The string that begins here is not closed on its line. End it with the same quotation mark.</source>
        <translation>从这里开始的字符串在本行没有结束。请用同样的引号结束它。</translation>
    </message>
    <message>
        <source>The subroutine number %1 is already that of %2. Give each subroutine a number of its own.</source>
        <translation>子程序编号 %1 已被 %2 使用。请为每个子程序指定不同的编号。</translation>
    </message>
    <message>
        <source>The subscript %1 is outside the array, which goes from %2 to %3.</source>
        <translation>下标 %1 超出数组的范围 %2 至 %3。</translation>
    </message>
    <message>
        <source>The supply was switched off and on.</source>
        <translation>电源曾断开后重新接通。</translation>
    </message>
    <message>
        <source>The text is not UTF-8 from here on. Store the file as UTF-8.</source>
        <translation>从此处起文本不是 UTF-8。请将文件保存为 UTF-8。</translation>
    </message>
    <message>
        <source>The trace setting &quot;%1&quot; is outside its range, which is %2.</source>
        <translation>跟踪设置“%1”超出范围（%2）。</translation>
    </message>
    <message>
        <source>The value %1 has a branch in this CASE already.</source>
        <translation>值 %1 在此 CASE 中已有分支。</translation>
    </message>
    <message>
        <source>The variable &quot;%1&quot; has no address. Variables of this controller need one.</source>
        <translation>变量“%1”没有地址。此控制器的变量需要地址。</translation>
    </message>
    <message>
        <source>The variable %1 has no usable address. Give it one in its variable table.</source>
        <translation>变量 %1 没有可用的地址。在其变量表中给出地址。</translation>
    </message>
    <message>
        <source>The variable %1 is never used.</source>
        <translation>变量 %1 从未使用。</translation>
    </message>
    <message>
        <source>The variable table makes %1 the %2 variable %3; here it is used as %4. Use it as %2, or change the variable.</source>
        <translation>变量表将 %1 定为 %2 类型的变量 %3；此处却作为 %4 使用。按 %2 使用，或修改变量。</translation>
    </message>
    <message>
        <source>The variables need more than %1 bytes. Make arrays smaller.</source>
        <translation>变量需要的字节数超过 %1。请缩小数组。</translation>
    </message>
    <message>
        <source>The virtual controller could not be started: &quot;%1&quot; is missing or cannot be run. Reinstall Camwright.</source>
        <translation>虚拟控制器无法启动：“%1”缺失或无法运行。重新安装 Camwright。</translation>
    </message>
    <message>
        <source>The virtual controller was started but did not answer within %1 s: %2.</source>
        <translation>虚拟控制器已启动，但 %1 s 内未应答：%2。</translation>
    </message>
    <message>
        <source>The watchdog of %1 ms is not longer than the scan period of %2 ms, so every scan would trip it.</source>
        <translation>看门狗 %1 ms 不大于扫描周期 %2 ms，因此每次扫描都会触发它。</translation>
    </message>
    <message>
        <source>There are %1 subroutines, a %2 takes %3.</source>
        <translation>有 %1 个子程序，%2 最多允许 %3 个。</translation>
    </message>
    <message>
        <source>There are more subscripts here than the array has.</source>
        <translation>这里的下标比数组的维数多。</translation>
    </message>
    <message>
        <source>There are more than %1 problems in this program; the others are not listed. Mend the first ones and check again.</source>
        <translation>此程序中的问题超过 %1 个，其余未列出。先改正前面的，再检查一次。</translation>
    </message>
    <message>
        <source>There are more than %1 warnings in this program; the others are not listed.</source>
        <translation>此程序中的警告超过 %1 个，其余未列出。</translation>
    </message>
    <message>
        <source>There are more values here than %1 has elements.</source>
        <translation>这里的值比 %1 的元素多。</translation>
    </message>
    <message>
        <source>There is a character that cannot be seen here: %1. Remove it.</source>
        <translation>此处有一个不可见字符：%1。删除它。</translation>
    </message>
    <message>
        <source>There is no FOR that this NEXT could end.</source>
        <translation>没有与此 NEXT 对应的 FOR。</translation>
    </message>
    <message>
        <source>There is no axis %1 in the motion network. The instruction will end with ERRID 1.</source>
        <translation>运动网络中没有轴 %1。该指令将以 ERRID 1 结束。</translation>
    </message>
    <message>
        <source>There is no axis %1; the running program has %2.</source>
        <translation>没有轴 %1；运行的程序有：%2。</translation>
    </message>
    <message>
        <source>There is no axis node %1 in the motion network, or the network has not been started. Add the axis in the motion network editor.</source>
        <translation>运动网络中没有轴节点 %1，或网络尚未启动。在运动网络编辑器中添加该轴。</translation>
    </message>
    <message>
        <source>There is no connection to a controller. Connect first.</source>
        <translation>没有与控制器的连接。先连接。</translation>
    </message>
    <message>
        <source>There is no controller family &quot;%1&quot;. Known are %2.</source>
        <translation>没有名为“%1”的控制器系列。已知系列：%2。</translation>
    </message>
    <message>
        <source>There is no download with the number %1, or it has ended.</source>
        <translation>没有编号为 %1 的下载，或它已结束。</translation>
    </message>
    <message>
        <source>There is no element %1 in %2. Its elements are 0 to %3.</source>
        <translation>%2 中没有元素 %1。其元素为 0～%3。</translation>
    </message>
    <message>
        <source>There is no group that this ) could close. Remove it, or open one with AND( or OR(.</source>
        <translation>这个 ) 没有可关闭的组。删除它，或用 AND( 或 OR( 打开一个组。</translation>
    </message>
    <message>
        <source>There is no label %1 in this program. Write LBL %1 where the jump goes to.</source>
        <translation>此程序中没有标号 %1。请在跳转目标处写 LBL %1。</translation>
    </message>
    <message>
        <source>There is no motion network for the controller %1. Choose another model, or remove axes and network.</source>
        <translation>控制器 %1 没有运动网络。选择另一型号，或删除轴和网络。</translation>
    </message>
    <message>
        <source>There is no subroutine &quot;%1&quot;. Add one, or correct the name.</source>
        <translation>没有子程序“%1”。添加一个，或改正名称。</translation>
    </message>
    <message>
        <source>There is no subroutine &quot;%1&quot;. Did you mean %2?</source>
        <translation>没有子程序“%1”。是否指 %2？</translation>
    </message>
    <message>
        <source>There is no variable &quot;%1&quot;. Did you mean %2?</source>
        <translation>没有变量“%1”。是否指 %2？</translation>
    </message>
    <message>
        <source>There is nothing named &quot;%1&quot; here. Declare it, or correct the name.</source>
        <translation>这里没有名为“%1”的内容。请声明它，或改正名称。</translation>
    </message>
    <message>
        <source>There is nothing named &quot;%1&quot; here. Did you mean %2?</source>
        <translation>这里没有名为“%1”的内容。是否指 %2？</translation>
    </message>
    <message>
        <source>This call leads back to %1: %2. A controller of this family cannot do that.</source>
        <translation>此调用又回到 %1：%2。该系列控制器不支持这样做。</translation>
    </message>
    <message>
        <source>This controller cannot be ended from here. Only a local virtual controller can.</source>
        <translation>不能从这里结束此控制器。只有本机虚拟控制器可以。</translation>
    </message>
    <message>
        <source>This controller does not know the family &quot;%1&quot; or its model &quot;%2&quot;.</source>
        <translation>此控制器不认识系列“%1”或其型号“%2”。</translation>
    </message>
    <message>
        <source>This divides by zero.</source>
        <translation>这里除以零。</translation>
    </message>
    <message>
        <source>This expression has more than %1 operators in a row. Split it up with a variable.</source>
        <translation>此表达式连续的运算符超过 %1 个。请用变量把它拆开。</translation>
    </message>
    <message>
        <source>This instruction stands before the first network. Write a line (* Network 0 *) above it.</source>
        <translation>此指令位于第一个网络之前。在其上方写一行 (* Network 0 *)。</translation>
    </message>
    <message>
        <source>This is never reached.</source>
        <translation>这里永远不会执行。</translation>
    </message>
    <message>
        <source>This is not a controller image: it does not begin like one.</source>
        <translation>这不是控制器映像：开头不符。</translation>
    </message>
    <message>
        <source>This is not readable as TOML: %1.</source>
        <translation>无法按 TOML 读取：%1。</translation>
    </message>
    <message>
        <source>This line has more than %1 operands. No instruction takes so many.</source>
        <translation>此行的操作数超过 %1 个。没有指令需要这么多。</translation>
    </message>
    <message>
        <source>This network is numbered %1, the next number is %2.</source>
        <translation>此网络编号为 %1，而下一个编号应为 %2。</translation>
    </message>
    <message>
        <source>This project has format %1, written by a newer Camwright. This one reads formats up to %2. Open the project with the newer one.</source>
        <translation>此工程的格式为 %1，由更新版本的 Camwright 写入。本版本最高可读格式 %2。请用新版本打开。</translation>
    </message>
    <message>
        <source>This row has %1 cells, but the header has %2.</source>
        <translation>此行有 %1 个单元格，而表头有 %2 个。</translation>
    </message>
    <message>
        <source>This rung has no output and no instruction: it does nothing.</source>
        <translation>此梯级没有输出也没有指令：不起任何作用。</translation>
    </message>
    <message>
        <source>This saved state has version %1; this program reads version %2.</source>
        <translation>此保存的状态版本为 %1；本程序读取版本 %2。</translation>
    </message>
    <message>
        <source>This version has no %1 link. Use local or tcp://HOST[:PORT].</source>
        <translation>本版本没有 %1 连接。用 local 或 tcp://HOST[:PORT]。</translation>
    </message>
    <message>
        <source>Unsaved edits of an earlier session belong to another state of this project: its files were changed since. They cannot be taken over.</source>
        <translation>上次会话未保存的编辑属于此工程的另一状态：此后工程文件已被修改。这些编辑无法采用。</translation>
    </message>
    <message>
        <source>Variables or their initial values change.</source>
        <translation>变量或其初始值有改变。</translation>
    </message>
    <message>
        <source>What follows END is not part of the program. Move it above END, or remove it.</source>
        <translation>END 之后的内容不属于程序。移到 END 之前，或删除。</translation>
    </message>
    <message>
        <source>nothing came from it for %1 s</source>
        <translation>已有 %1 s 没有收到任何数据</translation>
    </message>
    <message>
        <source>project.toml does not tell its format. Its first line is to be: format = %1</source>
        <translation>project.toml 没有说明格式。第一行应为：format = %1</translation>
    </message>
</context>
<context>
    <name>Fixes</name>
    <message>
        <source>Quick fixes</source>
        <translation>快速修复</translation>
    </message>
    <message>
        <source>There is no problem here.</source>
        <translation>此处没有问题。</translation>
    </message>
    <message>
        <source>There is no quick fix for this problem.</source>
        <translation>此问题没有快速修复。</translation>
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
        <translation>F11 编译，Alt+F8 转到在线，Shift+F8 停止。</translation>
    </message>
    <message>
        <source>F11 goes online, Ctrl+Shift+B builds, F8 goes to the next problem.</source>
        <translation>F11 转到在线，Ctrl+Shift+B 编译，F8 转到下一个问题。</translation>
    </message>
    <message>
        <source>F4 builds, F3 goes online; F5 to F10 start nothing.</source>
        <translation>F4 编译，F3 转到在线；F5 至 F10 不启动任何操作。</translation>
    </message>
    <message>
        <source>Like CODESYS</source>
        <translation>类似 CODESYS</translation>
    </message>
    <message>
        <source>Like GX Works</source>
        <translation>类似 GX Works</translation>
    </message>
    <message>
        <source>Like TwinCAT</source>
        <translation>类似 TwinCAT</translation>
    </message>
    <message>
        <source>The keys of the manual.</source>
        <translation>手册中的按键。</translation>
    </message>
</context>
<context>
    <name>Program</name>
    <message>
        <source>The texts of this language are not installed.</source>
        <translation>该语言的文本未安装。</translation>
    </message>
</context>
<context>
    <name>QuickFix</name>
    <message>
        <source>Add %1 as ???, to be filled in later</source>
        <translation>将 %1 补为 ???，以后再填写</translation>
    </message>
    <message>
        <source>Add the subroutine %1</source>
        <translation>添加子程序 %1</translation>
    </message>
    <message>
        <source>Begin network %1 here</source>
        <translation>从这里开始网络 %1</translation>
    </message>
    <message>
        <source>Begin the rung with %1, which is always on</source>
        <translation>以常 1 的 %1 作为梯级的开头</translation>
    </message>
    <message>
        <source>Close the group before its output</source>
        <translation>在输出之前结束该组</translation>
    </message>
    <message>
        <source>Declare %1 as %2 at %4 in the table &quot;%3&quot;</source>
        <translation>在表“%3”中将 %1 声明为 %2，地址 %4</translation>
    </message>
    <message>
        <source>Declare %1 as %2 in the table &quot;%3&quot;</source>
        <translation>在表“%3”中将 %1 声明为 %2</translation>
    </message>
    <message>
        <source>End the comment at the end of its line</source>
        <translation>在本行末尾结束注释</translation>
    </message>
    <message>
        <source>Join the two flows with %1</source>
        <translation>用 %1 连接两个能流</translation>
    </message>
    <message>
        <source>Make %1 a subroutine</source>
        <translation>将 %1 改为子程序</translation>
    </message>
    <message>
        <source>Make a comment of &quot;%1&quot;</source>
        <translation>将“%1”改为注释</translation>
    </message>
    <message>
        <source>Number all networks in their order</source>
        <translation>按顺序为所有网络重新编号</translation>
    </message>
    <message>
        <source>Put %1 at %2, which nothing uses</source>
        <translation>将 %1 放到未被使用的 %2</translation>
    </message>
    <message>
        <source>Remove &quot;%1&quot;</source>
        <translation>删除“%1”</translation>
    </message>
    <message>
        <source>Remove END, so that what follows belongs to the program</source>
        <translation>删除 END，使其后的内容属于程序</translation>
    </message>
    <message>
        <source>Remove the character %1</source>
        <translation>删除字符 %1</translation>
    </message>
    <message>
        <source>Remove the line &quot;%1&quot;</source>
        <translation>删除行“%1”</translation>
    </message>
    <message>
        <source>Write %2 in place of %1</source>
        <translation>将 %1 改为 %2</translation>
    </message>
    <message>
        <source>Write %2 in place of the last %1</source>
        <translation>将最后一个 %1 改为 %2</translation>
    </message>
    <message>
        <source>Write ??? for the operand, to be filled in later</source>
        <translation>将操作数写为 ???，以后再填写</translation>
    </message>
    <message>
        <source>Write a blank in place of the comma</source>
        <translation>将逗号改为空格</translation>
    </message>
    <message>
        <source>Write a plain blank in place of the character %1</source>
        <translation>将字符 %1 改为普通空格</translation>
    </message>
    <message>
        <source>Write the groups of this network to marker bits (%1) in networks of their own</source>
        <translation>在单独的网络中将本网络的各组写入标志位（%1）</translation>
    </message>
</context>
<context>
    <name>Units</name>
    <message>
        <source>mm</source>
        <translation>mm</translation>
    </message>
    <message>
        <source>mm/s</source>
        <translation>mm/s</translation>
    </message>
    <message>
        <source>ms</source>
        <translation>ms</translation>
    </message>
    <message>
        <source>s</source>
        <translation>s</translation>
    </message>
    <message>
        <source>°/s</source>
        <translation>°/s</translation>
    </message>
</context>
<context>
    <name>Watch</name>
    <message>
        <source>Actual position, from the drive</source>
        <translation>实际位置，来自驱动器</translation>
    </message>
    <message>
        <source>Actual velocity, units per second</source>
        <translation>实际速度，单位/秒</translation>
    </message>
    <message>
        <source>Commanded less actual position</source>
        <translation>指令位置减实际位置</translation>
    </message>
    <message>
        <source>Error code of the axis, 0 for none</source>
        <translation>轴的错误代码，0 表示无错误</translation>
    </message>
    <message>
        <source>Number of the axis state</source>
        <translation>轴状态编号</translation>
    </message>
    <message>
        <source>Position the drive is commanded to</source>
        <translation>驱动器的指令位置</translation>
    </message>
    <message>
        <source>Torque in per cent of rated</source>
        <translation>转矩，额定值的百分比</translation>
    </message>
</context>
<context>
    <name>Words</name>
    <message>
        <source>axis</source>
        <translation>轴</translation>
    </message>
    <message>
        <source>controller</source>
        <translation>控制器</translation>
    </message>
    <message>
        <source>error</source>
        <translation>错误</translation>
    </message>
    <message>
        <source>line %1, column %2</source>
        <translation>第 %1 行，第 %2 列</translation>
    </message>
    <message>
        <source>network</source>
        <translation>网络</translation>
    </message>
    <message>
        <source>note</source>
        <translation>提示</translation>
    </message>
    <message>
        <source>program</source>
        <translation>程序</translation>
    </message>
    <message>
        <source>project</source>
        <translation>工程</translation>
    </message>
    <message>
        <source>variable table</source>
        <translation>变量表</translation>
    </message>
    <message>
        <source>warning</source>
        <translation>警告</translation>
    </message>
    <message>
        <source>watch list</source>
        <translation>监视表</translation>
    </message>
</context>
<context>
    <name>camwright::ActionCatalogue</name>
    <message>
        <source>A build or download is running.</source>
        <translation>正在编译或下载。</translation>
    </message>
    <message>
        <source>A controller is connected already.</source>
        <translation>已连接控制器。</translation>
    </message>
    <message>
        <source>Everything is saved.</source>
        <translation>全部已保存。</translation>
    </message>
    <message>
        <source>No controller is connected.</source>
        <translation>未连接控制器。</translation>
    </message>
    <message>
        <source>No project is open.</source>
        <translation>没有打开工程。</translation>
    </message>
    <message>
        <source>No tab is open.</source>
        <translation>没有打开的标签页。</translation>
    </message>
    <message>
        <source>The controller does not run.</source>
        <translation>控制器没有运行。</translation>
    </message>
    <message>
        <source>The controller runs already.</source>
        <translation>控制器已在运行。</translation>
    </message>
    <message>
        <source>The current view does not offer it.</source>
        <translation>当前视图不提供此操作。</translation>
    </message>
    <message>
        <source>There is no other place for the tab. Split the editors first.</source>
        <translation>标签页没有其他位置可去。请先拆分编辑器。</translation>
    </message>
    <message>
        <source>There is no problem.</source>
        <translation>没有问题。</translation>
    </message>
    <message>
        <source>There is no step to redo.</source>
        <translation>没有可重做的步骤。</translation>
    </message>
    <message>
        <source>There is no step to undo.</source>
        <translation>没有可撤销的步骤。</translation>
    </message>
    <message>
        <source>There is one group of tabs only.</source>
        <translation>只有一组标签页。</translation>
    </message>
</context>
<context>
    <name>camwright::ArmBar</name>
    <message>
        <source>%1 has control</source>
        <translation>控制权在 %1</translation>
    </message>
    <message>
        <source>Arm panel control first.</source>
        <translation>先激活面板控制。</translation>
    </message>
    <message>
        <source>Clears the error once its cause is gone.</source>
        <translation>原因消除后清除错误。</translation>
    </message>
    <message>
        <source>Click to let the program have the axis again. What this panel moves stops first.</source>
        <translation>单击将轴交还给程序。由此面板引起的运动先停止。</translation>
    </message>
    <message>
        <source>Click to move this axis by hand. The program&apos;s motion of it is refused meanwhile.</source>
        <translation>单击以手动移动此轴。期间程序对它的运动被拒绝。</translation>
    </message>
    <message>
        <source>Enable</source>
        <translation>使能</translation>
    </message>
    <message>
        <source>Enabled</source>
        <translation>已使能</translation>
    </message>
    <message>
        <source>Home</source>
        <translation>回原点</translation>
    </message>
    <message>
        <source>Panel Control</source>
        <translation>面板控制</translation>
    </message>
    <message>
        <source>Panel control</source>
        <translation>面板控制</translation>
    </message>
    <message>
        <source>Puts the axis under power. It does not move.</source>
        <translation>给轴上电。轴不移动。</translation>
    </message>
    <message>
        <source>Reset</source>
        <translation>复位</translation>
    </message>
    <message>
        <source>Searches the home position with the method set in the drive. The axis moves.</source>
        <translation>按驱动器中设定的方式寻找原点。轴会移动。</translation>
    </message>
    <message>
        <source>The axis is enabled. Click to stop it and take the power off.</source>
        <translation>轴已使能。单击以停止并断开动力。</translation>
    </message>
    <message>
        <source>There is no error to reset.</source>
        <translation>没有需要复位的错误。</translation>
    </message>
    <message>
        <source>arm it to move the axis</source>
        <translation>激活后可移动轴</translation>
    </message>
    <message>
        <source>armed</source>
        <translation>已激活</translation>
    </message>
    <message>
        <source>arming</source>
        <translation>正在激活</translation>
    </message>
    <message>
        <source>off</source>
        <translation>关</translation>
    </message>
    <message>
        <source>program motion is refused</source>
        <translation>程序的运动被拒绝</translation>
    </message>
    <message>
        <source>taking control</source>
        <translation>正在取得控制权</translation>
    </message>
</context>
<context>
    <name>camwright::AxisEditor</name>
    <message>
        <source>%1 %2 per pulse</source>
        <translation>%1 %2/脉冲</translation>
    </message>
    <message>
        <source>%1 %2/min</source>
        <translation>%1 %2/min</translation>
    </message>
    <message>
        <source>%1 %2/s</source>
        <translation>%1 %2/s</translation>
    </message>
    <message>
        <source>%1 pulses/s</source>
        <translation>%1 脉冲/s</translation>
    </message>
    <message>
        <source>32-bit position range</source>
        <translation>32 位位置范围</translation>
    </message>
    <message>
        <source>At motor speed</source>
        <translation>在该电机转速下</translation>
    </message>
    <message>
        <source>Axis</source>
        <translation>轴</translation>
    </message>
    <message>
        <source>Change axis %1</source>
        <translation>修改轴 %1</translation>
    </message>
    <message>
        <source>Home switch</source>
        <translation>原点开关</translation>
    </message>
    <message>
        <source>Inertia of the load over that of the motor; a larger one lags more.</source>
        <translation>负载惯量与电机惯量之比；越大滞后越多。</translation>
    </message>
    <message>
        <source>Inertia ratio</source>
        <translation>惯量比</translation>
    </message>
    <message>
        <source>Linear axis, CANopen address %1</source>
        <translation>直线轴，CANopen 地址 %1</translation>
    </message>
    <message>
        <source>Lower limit switch</source>
        <translation>下限位开关</translation>
    </message>
    <message>
        <source>Motor speed</source>
        <translation>电机转速</translation>
    </message>
    <message>
        <source>Motor speed the results below are shown for.</source>
        <translation>下列结果所对应的电机转速。</translation>
    </message>
    <message>
        <source>Position at which the home switch acts.</source>
        <translation>原点开关动作的位置。</translation>
    </message>
    <message>
        <source>Position of the limit switch on the negative side.</source>
        <translation>负方向限位开关的位置。</translation>
    </message>
    <message>
        <source>Position of the limit switch on the positive side.</source>
        <translation>正方向限位开关的位置。</translation>
    </message>
    <message>
        <source>Resolution</source>
        <translation>分辨率</translation>
    </message>
    <message>
        <source>Results</source>
        <translation>结果</translation>
    </message>
    <message>
        <source>Rotary axis, CANopen address %1</source>
        <translation>旋转轴，CANopen 地址 %1</translation>
    </message>
    <message>
        <source>Simulated Machine</source>
        <translation>仿真机器</translation>
    </message>
    <message>
        <source>Speed for the drive</source>
        <translation>驱动器速度</translation>
    </message>
    <message>
        <source>Speed of the load</source>
        <translation>负载速度</translation>
    </message>
    <message>
        <source>Start position</source>
        <translation>起始位置</translation>
    </message>
    <message>
        <source>The same a minute</source>
        <translation>折合每分钟</translation>
    </message>
    <message>
        <source>Upper limit switch</source>
        <translation>上限位开关</translation>
    </message>
    <message>
        <source>Used by the virtual controller only; nothing of it reaches a real machine</source>
        <translation>仅供虚拟控制器使用；不会传到真实机器</translation>
    </message>
    <message>
        <source>What these values mean at the machine</source>
        <translation>这些值在机器上的含义</translation>
    </message>
    <message>
        <source>Where the load stands when the controller is switched on.</source>
        <translation>控制器上电时负载所在的位置。</translation>
    </message>
    <message>
        <source>mm</source>
        <translation>mm</translation>
    </message>
    <message>
        <source>rpm</source>
        <translation>rpm</translation>
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
        <translation>驱动器在 CANopen 总线上的地址。编号从 1 起连续。</translation>
    </message>
    <message>
        <source>Advanced</source>
        <translation>高级</translation>
    </message>
    <message>
        <source>Axis number</source>
        <translation>轴号</translation>
    </message>
    <message>
        <source>Axis type</source>
        <translation>轴类型</translation>
    </message>
    <message>
        <source>Default</source>
        <translation>默认</translation>
    </message>
    <message>
        <source>Encoder resolution</source>
        <translation>编码器分辨率</translation>
    </message>
    <message>
        <source>Guard time</source>
        <translation>保护时间</translation>
    </message>
    <message>
        <source>Guard time 1000 ms, life factor 3</source>
        <translation>保护时间 1000 ms，寿命因子 3</translation>
    </message>
    <message>
        <source>How far the load moves while the motor makes one turn.</source>
        <translation>电机转一圈时负载移动的距离。</translation>
    </message>
    <message>
        <source>How many answers may be missing before the axis counts as lost.</source>
        <translation>可缺少多少次应答，之后即认为轴已丢失。</translation>
    </message>
    <message>
        <source>How often the master asks the drive whether it is alive. 0 switches guarding off.</source>
        <translation>主站询问驱动器是否在线的间隔。0 表示关闭保护。</translation>
    </message>
    <message>
        <source>Life factor</source>
        <translation>寿命因子</translation>
    </message>
    <message>
        <source>Linear</source>
        <translation>直线</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>名称</translation>
    </message>
    <message>
        <source>Name of the axis, as programs, traces and this window call it (KS-MCN-08)</source>
        <translation>轴的名称，程序、跟踪和本窗口都用此名称 (KS-MCN-08)</translation>
    </message>
    <message>
        <source>Node guarding</source>
        <translation>节点保护</translation>
    </message>
    <message>
        <source>Own guard time and life factor</source>
        <translation>自定义保护时间和寿命因子</translation>
    </message>
    <message>
        <source>PDO event timer</source>
        <translation>PDO 事件定时器</translation>
    </message>
    <message>
        <source>PDO inhibit time</source>
        <translation>PDO 禁止时间</translation>
    </message>
    <message>
        <source>Positions in degrees</source>
        <translation>位置以度计</translation>
    </message>
    <message>
        <source>Positions in millimetres</source>
        <translation>位置以毫米计</translation>
    </message>
    <message>
        <source>Pulses of the encoder per turn of the motor.</source>
        <translation>电机每转的编码器脉冲数。</translation>
    </message>
    <message>
        <source>Rotary</source>
        <translation>旋转</translation>
    </message>
    <message>
        <source>Sends process data at least this often, also when nothing changed. 0: only on change.</source>
        <translation>至少按此间隔发送过程数据，即使没有变化。0：仅在变化时发送。</translation>
    </message>
    <message>
        <source>Shortest distance between two process data frames of the drive. Position and speed change quickly; without it they would fill the bus.</source>
        <translation>驱动器两个过程数据帧之间的最短间隔。位置和速度变化很快；没有它会占满总线。</translation>
    </message>
    <message>
        <source>Travel per motor turn</source>
        <translation>电机每转行程</translation>
    </message>
    <message>
        <source>Type</source>
        <translation>类型</translation>
    </message>
    <message>
        <source>mm</source>
        <translation>mm</translation>
    </message>
    <message>
        <source>ms</source>
        <translation>ms</translation>
    </message>
    <message>
        <source>pulses</source>
        <translation>脉冲</translation>
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
        <translation> mm</translation>
    </message>
    <message>
        <source> ms</source>
        <translation> ms</translation>
    </message>
    <message>
        <source>Axis</source>
        <translation>轴</translation>
    </message>
    <message>
        <source>Encoder resolution</source>
        <translation>编码器分辨率</translation>
    </message>
    <message>
        <source>Guard time</source>
        <translation>保护时间</translation>
    </message>
    <message>
        <source>Life factor</source>
        <translation>寿命因子</translation>
    </message>
    <message>
        <source>Linear</source>
        <translation>直线</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>名称</translation>
    </message>
    <message>
        <source>PDO event timer</source>
        <translation>PDO 事件定时器</translation>
    </message>
    <message>
        <source>PDO inhibit time</source>
        <translation>PDO 禁止时间</translation>
    </message>
    <message>
        <source>Rotary</source>
        <translation>旋转</translation>
    </message>
    <message>
        <source>Travel per turn</source>
        <translation>每转行程</translation>
    </message>
    <message>
        <source>Type</source>
        <translation>类型</translation>
    </message>
    <message>
        <source>off</source>
        <translation>关</translation>
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
        <translation>通道</translation>
    </message>
    <message>
        <source>Part of the next recording.</source>
        <translation>包含在下一次记录中。</translation>
    </message>
    <message>
        <source>at A</source>
        <translation>在 A 处</translation>
    </message>
    <message>
        <source>at B</source>
        <translation>在 B 处</translation>
    </message>
</context>
<context>
    <name>camwright::CommissioningEditor</name>
    <message>
        <source>%1 · Commissioning</source>
        <translation>%1 · 调试</translation>
    </message>
    <message>
        <source>Commissioning</source>
        <translation>调试</translation>
    </message>
    <message>
        <source>Go online to move this axis.</source>
        <translation>转到在线以移动此轴。</translation>
    </message>
    <message>
        <source>The controller&apos;s program has no axis &quot;%1&quot;. Download this project to move it.</source>
        <translation>控制器的程序中没有轴“%1”。下载本工程后才能移动它。</translation>
    </message>
    <message>
        <source>This is a convenience, not a safety function: the machine needs its own emergency stop.</source>
        <translation>这只是便利功能，不是安全功能：机器需要自己的急停。</translation>
    </message>
    <message>
        <source>This link cannot move axes.</source>
        <translation>此连接不能移动轴。</translation>
    </message>
    <message>
        <source>This link cannot move axes: %1</source>
        <translation>此连接不能移动轴：%1</translation>
    </message>
</context>
<context>
    <name>camwright::ConnectionStrip</name>
    <message>
        <source>A panel is armed</source>
        <translation>有面板已激活</translation>
    </message>
    <message>
        <source>Connecting to %1</source>
        <translation>正在连接 %1</translation>
    </message>
    <message>
        <source>Connection to %1 lost, trying again</source>
        <translation>与 %1 的连接已断开，正在重试</translation>
    </message>
    <message numerus="yes">
        <source>F %n forced</source>
        <translation>
            <numerusform>F %n 个强制</numerusform>
        </translation>
    </message>
    <message>
        <source>REAL MACHINE · %1 · %2</source>
        <translation>真实机器 · %1 · %2</translation>
    </message>
    <message>
        <source>Release all</source>
        <translation>全部释放</translation>
    </message>
    <message>
        <source>Show What Differs</source>
        <translation>显示差异</translation>
    </message>
    <message>
        <source>Shows what a download would change; nothing is sent before you agree.</source>
        <translation>显示下载将改变的内容；在您同意之前不发送任何数据。</translation>
    </message>
    <message>
        <source>The controller has no program yet.</source>
        <translation>控制器还没有程序。</translation>
    </message>
    <message>
        <source>The controller runs another program: live values are off.</source>
        <translation>控制器运行的是另一个程序：实时值已关闭。</translation>
    </message>
    <message>
        <source>Virtual controller · %1</source>
        <translation>虚拟控制器 · %1</translation>
    </message>
</context>
<context>
    <name>camwright::ControllerEditor</name>
    <message>
        <source>%1 bytes</source>
        <translation>%1 字节</translation>
    </message>
    <message>
        <source>%1 elements</source>
        <translation>%1 个元件</translation>
    </message>
    <message>
        <source>0: the program runs as fast as it can. Else every scan begins this long after the one before.</source>
        <translation>0：程序尽可能快地运行。否则每次扫描在前一次开始后经过此时间再开始。</translation>
    </message>
    <message>
        <source>A scan that takes longer stops the axes and the program.</source>
        <translation>扫描超过此时间将停止各轴和程序。</translation>
    </message>
    <message>
        <source>Allow nested branches</source>
        <translation>允许嵌套分支</translation>
    </message>
    <message>
        <source>Axes on the motion network</source>
        <translation>运动网络上的轴</translation>
    </message>
    <message>
        <source>CAN ports</source>
        <translation>CAN 口</translation>
    </message>
    <message>
        <source>Change the controller&apos;s model</source>
        <translation>更改控制器型号</translation>
    </message>
    <message>
        <source>Change the scan period</source>
        <translation>更改扫描周期</translation>
    </message>
    <message>
        <source>Change the watchdog</source>
        <translation>更改看门狗时间</translation>
    </message>
    <message>
        <source>Controller</source>
        <translation>控制器</translation>
    </message>
    <message>
        <source>Digital inputs on the unit</source>
        <translation>本体数字输入</translation>
    </message>
    <message>
        <source>Digital outputs on the unit</source>
        <translation>本体数字输出</translation>
    </message>
    <message>
        <source>Ethernet ports</source>
        <translation>以太网口</translation>
    </message>
    <message>
        <source>Expansion modules</source>
        <translation>扩展模块</translation>
    </message>
    <message>
        <source>Family</source>
        <translation>系列</translation>
    </message>
    <message>
        <source>Limits that checks and builds apply</source>
        <translation>检查和编译所用的限制</translation>
    </message>
    <message>
        <source>Make programs strict Kinco</source>
        <translation>将程序设为严格 Kinco</translation>
    </message>
    <message>
        <source>Memory %1</source>
        <translation>存储区 %1</translation>
    </message>
    <message>
        <source>Model</source>
        <translation>型号</translation>
    </message>
    <message>
        <source>Motion instructions</source>
        <translation>运动指令</translation>
    </message>
    <message>
        <source>Program size, instructions</source>
        <translation>程序容量（指令数）</translation>
    </message>
    <message>
        <source>Programs may hold only what KincoBuilder is known to take: nested branches, AND( and OR(, are refused, and a quick fix writes them to marker bits.</source>
        <translation>程序只能使用已知 KincoBuilder 接受的内容：嵌套分支 AND( 和 OR( 会被拒绝，快速修复可将其写入标志位。</translation>
    </message>
    <message>
        <source>Pulse outputs (not simulated yet)</source>
        <translation>脉冲输出（尚未仿真）</translation>
    </message>
    <message>
        <source>Scan period</source>
        <translation>扫描周期</translation>
    </message>
    <message>
        <source>Strict Kinco</source>
        <translation>严格 Kinco</translation>
    </message>
    <message>
        <source>Strict Kinco: no nested branches, AND( and OR(</source>
        <translation>严格 Kinco：不允许嵌套分支 AND( 和 OR(</translation>
    </message>
    <message>
        <source>The controller this project is for; its limits apply at once</source>
        <translation>本工程所用的控制器；其限制立即生效</translation>
    </message>
    <message>
        <source>Watchdog</source>
        <translation>看门狗</translation>
    </message>
    <message>
        <source>What the Model Offers</source>
        <translation>型号规格</translation>
    </message>
    <message>
        <source>What the model offers</source>
        <translation>型号规格</translation>
    </message>
    <message>
        <source>ms</source>
        <translation>ms</translation>
    </message>
    <message>
        <source>none</source>
        <translation>无</translation>
    </message>
    <message>
        <source>µs</source>
        <translation>µs</translation>
    </message>
</context>
<context>
    <name>camwright::DemoDrawing</name>
    <message>
        <source>Drawing of the demo machine: a feed slide on a screw and an indexing table</source>
        <translation>演示机器图：丝杠进给滑台和分度台</translation>
    </message>
    <message>
        <source>linear, 100 mm a turn</source>
        <translation>直线轴，每转 100 mm</translation>
    </message>
    <message>
        <source>rotary, 45° a turn</source>
        <translation>旋转轴，每转 45°</translation>
    </message>
</context>
<context>
    <name>camwright::DocViewer</name>
    <message>
        <source>Documentation</source>
        <translation>文档</translation>
    </message>
    <message>
        <source>Page</source>
        <translation>页面</translation>
    </message>
    <message>
        <source>Pages</source>
        <translation>页面列表</translation>
    </message>
</context>
<context>
    <name>camwright::DownloadDialog</name>
    <message>
        <source>Asking the controller what would change.</source>
        <translation>正在询问控制器将有何改变。</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>取消</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>关闭</translation>
    </message>
    <message>
        <source>Download</source>
        <translation>下载</translation>
    </message>
    <message>
        <source>Download cancelled. The controller keeps its program.</source>
        <translation>下载已取消。控制器保留其程序。</translation>
    </message>
    <message>
        <source>Download plan</source>
        <translation>下载计划</translation>
    </message>
    <message>
        <source>Downloaded. The controller stands in STOP.</source>
        <translation>已下载。控制器处于 STOP。</translation>
    </message>
    <message>
        <source>Effect</source>
        <translation>影响</translation>
    </message>
    <message>
        <source>Ends the transfer; the old program stays as it is.</source>
        <translation>结束传输；旧程序保持不变。</translation>
    </message>
    <message>
        <source>Keep It</source>
        <translation>保留原程序</translation>
    </message>
    <message>
        <source>Keep it</source>
        <translation>保留原程序</translation>
    </message>
    <message>
        <source>Leaves the controller&apos;s program as it is.</source>
        <translation>控制器的程序保持不变。</translation>
    </message>
    <message>
        <source>Nothing was changed.</source>
        <translation>未作任何更改。</translation>
    </message>
    <message>
        <source>Overwrite the Controller</source>
        <translation>覆盖控制器</translation>
    </message>
    <message>
        <source>Overwrite the controller</source>
        <translation>覆盖控制器</translation>
    </message>
    <message>
        <source>Progress of the download</source>
        <translation>下载进度</translation>
    </message>
    <message>
        <source>Sending. The old program stays until the last byte is verified.</source>
        <translation>正在发送。在最后一个字节校验完之前，旧程序保持不变。</translation>
    </message>
    <message>
        <source>Sends the program. The controller stands in STOP afterwards.</source>
        <translation>发送程序。之后控制器处于 STOP。</translation>
    </message>
    <message>
        <source>The controller already has this program. Sending it again changes only what is listed.</source>
        <translation>控制器已有此程序。再次发送只改变列出的内容。</translation>
    </message>
    <message>
        <source>The controller&apos;s program is replaced. It stands in STOP afterwards.</source>
        <translation>控制器的程序将被替换。之后处于 STOP。</translation>
    </message>
    <message>
        <source>The controller&apos;s program is replaced. It stops first, and stands in STOP afterwards.</source>
        <translation>控制器的程序将被替换。它先停止，之后处于 STOP。</translation>
    </message>
    <message>
        <source>What</source>
        <translation>对象</translation>
    </message>
    <message>
        <source>What the download changes, stops and loses.</source>
        <translation>下载将改变、停止和丢失的内容。</translation>
    </message>
    <message>
        <source>nothing</source>
        <translation>无</translation>
    </message>
    <message>
        <source>nothing changes</source>
        <translation>没有改变</translation>
    </message>
</context>
<context>
    <name>camwright::EditorArea</name>
    <message>
        <source>Open an object from the project tree, or press %1 to find one.</source>
        <translation>从工程树打开一个对象，或按 %1 查找。</translation>
    </message>
    <message>
        <source>Open an object from the project tree.</source>
        <translation>从工程树打开一个对象。</translation>
    </message>
</context>
<context>
    <name>camwright::EditorTabBar</name>
    <message>
        <source>Editors</source>
        <translation>编辑器</translation>
    </message>
</context>
<context>
    <name>camwright::Explain</name>
    <message>
        <source>Explain This Message</source>
        <translation>解释此消息</translation>
    </message>
</context>
<context>
    <name>camwright::FamilyCard</name>
    <message>
        <source>New project for %1</source>
        <translation>为 %1 新建工程</translation>
    </message>
</context>
<context>
    <name>camwright::FindBar</name>
    <message>
        <source>%1 of %2</source>
        <translation>第 %1 个，共 %2 个</translation>
    </message>
    <message numerus="yes">
        <source>%n hit(s)</source>
        <translation>
            <numerusform>%n 处匹配</numerusform>
        </translation>
    </message>
    <message>
        <source>Close (Esc)</source>
        <translation>关闭 (Esc)</translation>
    </message>
    <message>
        <source>Find</source>
        <translation>查找</translation>
    </message>
    <message>
        <source>Next hit (Enter)</source>
        <translation>下一处匹配 (Enter)</translation>
    </message>
    <message>
        <source>Previous hit</source>
        <translation>上一处匹配</translation>
    </message>
    <message>
        <source>Regular expression; \1 in the replacement stands for the first group</source>
        <translation>正则表达式；替换文本中的 \1 表示第一组</translation>
    </message>
    <message>
        <source>Replace</source>
        <translation>替换</translation>
    </message>
    <message>
        <source>Replace All</source>
        <translation>全部替换</translation>
    </message>
    <message>
        <source>Replace every hit; one step to undo</source>
        <translation>替换每一处；一步即可撤销</translation>
    </message>
    <message>
        <source>Replace this hit and go to the next</source>
        <translation>替换此处并转到下一处</translation>
    </message>
    <message>
        <source>Replace with</source>
        <translation>替换为</translation>
    </message>
    <message>
        <source>Tell upper from lower case</source>
        <translation>区分大小写</translation>
    </message>
    <message>
        <source>Whole words only; %M0.1 is one word</source>
        <translation>仅整词；%M0.1 为一个词</translation>
    </message>
    <message>
        <source>not found</source>
        <translation>未找到</translation>
    </message>
</context>
<context>
    <name>camwright::HoldButton</name>
    <message>
        <source>%1 while held (%2 while armed)</source>
        <translation>按住时%1（激活后可用 %2）</translation>
    </message>
</context>
<context>
    <name>camwright::JogPad</name>
    <message>
        <source>%1/s</source>
        <translation>%1/s</translation>
    </message>
    <message>
        <source>Each press moves the axis by the step size.</source>
        <translation>每按一次，轴移动一个步长。</translation>
    </message>
    <message>
        <source>Hold</source>
        <translation>按住</translation>
    </message>
    <message>
        <source>How far one press moves the axis.</source>
        <translation>按一次轴移动的距离。</translation>
    </message>
    <message>
        <source>Jog</source>
        <translation>点动</translation>
    </message>
    <message>
        <source>Jog fast backwards</source>
        <translation>快速反向点动</translation>
    </message>
    <message>
        <source>Jog fast forwards</source>
        <translation>快速正向点动</translation>
    </message>
    <message>
        <source>Jog slowly backwards</source>
        <translation>慢速反向点动</translation>
    </message>
    <message>
        <source>Jog slowly forwards</source>
        <translation>慢速正向点动</translation>
    </message>
    <message>
        <source>Maximum</source>
        <translation>最大</translation>
    </message>
    <message>
        <source>Maximum speed</source>
        <translation>最大速度</translation>
    </message>
    <message>
        <source>No speed of this panel is higher. It starts at 5 %; raise it when the axis behaves.</source>
        <translation>此面板的任何速度都不会更高。初始为 5 %；轴表现正常后再提高。</translation>
    </message>
    <message>
        <source>Speed cap</source>
        <translation>速度上限</translation>
    </message>
    <message>
        <source>Speed cap in per cent of the maximum speed</source>
        <translation>速度上限，最大速度的百分比</translation>
    </message>
    <message>
        <source>Step</source>
        <translation>步进</translation>
    </message>
    <message>
        <source>Step size</source>
        <translation>步长</translation>
    </message>
    <message>
        <source>The axis moves while the button or key is held, and stops on release.</source>
        <translation>按住按钮或按键时轴移动，松开即停。</translation>
    </message>
    <message>
        <source>Way of jogging</source>
        <translation>点动方式</translation>
    </message>
    <message>
        <source>What the speed cap is a share of. A larger one leaves the cap where it is.</source>
        <translation>速度上限所依据的值。增大它时上限保持不变。</translation>
    </message>
    <message>
        <source>each press moves one step</source>
        <translation>每按一次移动一步</translation>
    </message>
    <message>
        <source>hold to run, release to stop</source>
        <translation>按住运行，松开停止</translation>
    </message>
</context>
<context>
    <name>camwright::KeyTableModel</name>
    <message>
        <source>Action</source>
        <translation>操作</translation>
    </message>
    <message>
        <source>Keys</source>
        <translation>按键</translation>
    </message>
    <message>
        <source>yours</source>
        <translation>自定义</translation>
    </message>
</context>
<context>
    <name>camwright::KeysPage</name>
    <message>
        <source>%1 alone is for typing. Hold Ctrl or Alt with it, or choose a function key.</source>
        <translation>单独的 %1 用于输入文字。请同时按住 Ctrl 或 Alt，或选用功能键。</translation>
    </message>
    <message>
        <source>%1 is the key of &quot;%2&quot;.</source>
        <translation>%1 已是“%2”的按键。</translation>
    </message>
    <message>
        <source>Actions and their keys</source>
        <translation>操作及其按键</translation>
    </message>
    <message>
        <source>Back to the keys of the map.</source>
        <translation>恢复为按键方案中的按键。</translation>
    </message>
    <message>
        <source>Every action back to the keys of the map.</source>
        <translation>所有操作恢复为按键方案中的按键。</translation>
    </message>
    <message>
        <source>Find an action or a key</source>
        <translation>查找操作或按键</translation>
    </message>
    <message>
        <source>Key</source>
        <translation>按键</translation>
    </message>
    <message>
        <source>Key map</source>
        <translation>按键方案</translation>
    </message>
    <message>
        <source>Keys you know from another tool. Each map remembers what you change in it.</source>
        <translation>您在其他软件中熟悉的按键。每个方案各自记住您的更改。</translation>
    </message>
    <message>
        <source>Press the key here. A function key, or one with Ctrl or Alt; Escape gives up.</source>
        <translation>在此按下按键：功能键，或与 Ctrl、Alt 的组合；按 Esc 放弃。</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>移除</translation>
    </message>
    <message>
        <source>Reset</source>
        <translation>重置</translation>
    </message>
    <message>
        <source>Reset All</source>
        <translation>全部重置</translation>
    </message>
    <message>
        <source>Second key</source>
        <translation>第二按键</translation>
    </message>
    <message>
        <source>Shows the actions whose name or key has these letters.</source>
        <translation>显示名称或按键包含这些字符的操作。</translation>
    </message>
    <message>
        <source>Take the Key</source>
        <translation>占用此按键</translation>
    </message>
    <message>
        <source>The action has no key then.</source>
        <translation>之后该操作没有按键。</translation>
    </message>
    <message>
        <source>The other action loses it.</source>
        <translation>另一个操作将失去它。</translation>
    </message>
</context>
<context>
    <name>camwright::LampStrip</name>
    <message>
        <source>%1, %2</source>
        <translation>%1，%2</translation>
    </message>
    <message>
        <source>Drive</source>
        <translation>驱动器</translation>
    </message>
    <message>
        <source>Error</source>
        <translation>错误</translation>
    </message>
    <message>
        <source>Home switch</source>
        <translation>原点开关</translation>
    </message>
    <message>
        <source>Limit +</source>
        <translation>正限位</translation>
    </message>
    <message>
        <source>Limit −</source>
        <translation>负限位</translation>
    </message>
    <message>
        <source>axis</source>
        <translation>轴</translation>
    </message>
    <message>
        <source>free</source>
        <translation>未触发</translation>
    </message>
    <message>
        <source>none</source>
        <translation>无</translation>
    </message>
    <message>
        <source>not on the bus</source>
        <translation>不在总线上</translation>
    </message>
    <message>
        <source>off</source>
        <translation>断开</translation>
    </message>
    <message>
        <source>on</source>
        <translation>接通</translation>
    </message>
    <message>
        <source>operational</source>
        <translation>运行</translation>
    </message>
    <message>
        <source>reached</source>
        <translation>已触发</translation>
    </message>
</context>
<context>
    <name>camwright::LiveText</name>
    <message>
        <source>%1, at %2</source>
        <translation>%1，时间 %2</translation>
    </message>
    <message>
        <source>The connection to the controller is lost. The values shown are those of %1.</source>
        <translation>与控制器的连接已断开。显示的是 %1 的值。</translation>
    </message>
    <message>
        <source>The project was changed since the download. The values shown are those of %1, before the change.</source>
        <translation>下载后工程已更改。显示的是更改前 %1 的值。</translation>
    </message>
</context>
<context>
    <name>camwright::LogModel</name>
    <message>
        <source>%1 s</source>
        <translation>%1 s</translation>
    </message>
    <message>
        <source>Code</source>
        <translation>代码</translation>
    </message>
    <message>
        <source>Controller time</source>
        <translation>控制器时间</translation>
    </message>
    <message>
        <source>Cycle</source>
        <translation>周期</translation>
    </message>
    <message>
        <source>Message</source>
        <translation>消息</translation>
    </message>
</context>
<context>
    <name>camwright::LogPanel</name>
    <message>
        <source>Controller log</source>
        <translation>控制器日志</translation>
    </message>
    <message>
        <source>Copy</source>
        <translation>复制</translation>
    </message>
    <message>
        <source>Go online to see what the controller reports.</source>
        <translation>转到在线以查看控制器的报告。</translation>
    </message>
    <message>
        <source>Log</source>
        <translation>日志</translation>
    </message>
    <message>
        <source>What the controller reported, newest first. F1 explains an entry.</source>
        <translation>控制器的报告，最新的在前。按 F1 解释条目。</translation>
    </message>
</context>
<context>
    <name>camwright::MainWindow</name>
    <message>
        <source>&quot;%1&quot; has edits that are not saved.</source>
        <translation>“%1”有未保存的编辑。</translation>
    </message>
    <message>
        <source>&quot;%1&quot; was not opened.</source>
        <translation>“%1”未打开。</translation>
    </message>
    <message>
        <source>&amp;Controller</source>
        <translation>控制器(&amp;C)</translation>
    </message>
    <message>
        <source>&amp;Edit</source>
        <translation>编辑(&amp;E)</translation>
    </message>
    <message>
        <source>&amp;File</source>
        <translation>文件(&amp;F)</translation>
    </message>
    <message>
        <source>&amp;Go</source>
        <translation>转到(&amp;G)</translation>
    </message>
    <message>
        <source>&amp;Help</source>
        <translation>帮助(&amp;H)</translation>
    </message>
    <message>
        <source>&amp;Project</source>
        <translation>工程(&amp;P)</translation>
    </message>
    <message>
        <source>&amp;Redo</source>
        <translation>重做(&amp;R)</translation>
    </message>
    <message>
        <source>&amp;Redo %1</source>
        <translation>重做(&amp;R) %1</translation>
    </message>
    <message>
        <source>&amp;Undo</source>
        <translation>撤销(&amp;U)</translation>
    </message>
    <message>
        <source>&amp;Undo %1</source>
        <translation>撤销(&amp;U) %1</translation>
    </message>
    <message>
        <source>&amp;View</source>
        <translation>视图(&amp;V)</translation>
    </message>
    <message>
        <source>&lt;b&gt;Camwright %1&lt;/b&gt;&lt;br&gt;Engineering tool for small motion controllers.&lt;br&gt;&lt;br&gt;Free software under the GNU General Public License, version 3 or later. It comes without any warranty.</source>
        <translation>&lt;b&gt;Camwright %1&lt;/b&gt;&lt;br&gt;小型运动控制器的工程工具。&lt;br&gt;&lt;br&gt;自由软件，遵循 GNU 通用公共许可证第 3 版或更高版本。不附带任何担保。</translation>
    </message>
    <message>
        <source>About Camwright</source>
        <translation>关于 Camwright</translation>
    </message>
    <message>
        <source>Analyse</source>
        <translation>分析</translation>
    </message>
    <message>
        <source>Another Camwright works on this project. Edits here can be saved only under another name.</source>
        <translation>另一个 Camwright 正在编辑此工程。此处的编辑只能以另一名称保存。</translation>
    </message>
    <message>
        <source>Another program changed files of this project.</source>
        <translation>另一个程序修改了此工程的文件。</translation>
    </message>
    <message>
        <source>Bottom dock</source>
        <translation>底栏</translation>
    </message>
    <message>
        <source>Camwright ended without saving this project.</source>
        <translation>Camwright 结束时没有保存此工程。</translation>
    </message>
    <message>
        <source>Changed Outside</source>
        <translation>外部已更改</translation>
    </message>
    <message>
        <source>Commission</source>
        <translation>调试</translation>
    </message>
    <message>
        <source>Configure</source>
        <translation>组态</translation>
    </message>
    <message>
        <source>Discard Them</source>
        <translation>放弃编辑</translation>
    </message>
    <message>
        <source>Discard the Edits</source>
        <translation>放弃编辑</translation>
    </message>
    <message>
        <source>Discarding them cannot be undone.</source>
        <translation>放弃后无法恢复。</translation>
    </message>
    <message>
        <source>Edits are kept in memory only until you save. %1</source>
        <translation>在保存之前，编辑只保留在内存中。%1</translation>
    </message>
    <message>
        <source>Find Action</source>
        <translation>查找操作</translation>
    </message>
    <message>
        <source>Find Anything</source>
        <translation>查找任意内容</translation>
    </message>
    <message>
        <source>Go On Working</source>
        <translation>继续工作</translation>
    </message>
    <message>
        <source>Keep It</source>
        <translation>保留该文件</translation>
    </message>
    <message>
        <source>Keep Mine</source>
        <translation>保留我的</translation>
    </message>
    <message>
        <source>Layouts</source>
        <translation>布局</translation>
    </message>
    <message>
        <source>Name of an action</source>
        <translation>操作的名称</translation>
    </message>
    <message>
        <source>Name of an object or variable</source>
        <translation>对象或变量的名称</translation>
    </message>
    <message>
        <source>Open Project Folder</source>
        <translation>打开工程文件夹</translation>
    </message>
    <message>
        <source>Overwrite the File</source>
        <translation>覆盖文件</translation>
    </message>
    <message>
        <source>Program</source>
        <translation>编程</translation>
    </message>
    <message>
        <source>Project folder (*)</source>
        <translation>工程文件夹 (*)</translation>
    </message>
    <message>
        <source>Properties</source>
        <translation>属性</translation>
    </message>
    <message>
        <source>Reload</source>
        <translation>重新加载</translation>
    </message>
    <message>
        <source>Reloading replaces your unsaved edits; Ctrl+Z brings them back.</source>
        <translation>重新加载会替换您未保存的编辑；Ctrl+Z 可恢复它们。</translation>
    </message>
    <message>
        <source>Restore the Edits</source>
        <translation>恢复编辑</translation>
    </message>
    <message>
        <source>Restoring them is one step that can be undone; the files stay as they are until you save.</source>
        <translation>恢复它们是一个可撤销的步骤；在您保存之前文件保持不变。</translation>
    </message>
    <message>
        <source>Save</source>
        <translation>保存</translation>
    </message>
    <message>
        <source>Save Project As</source>
        <translation>工程另存为</translation>
    </message>
    <message>
        <source>Saving now replaces what the other program wrote.</source>
        <translation>现在保存将替换另一个程序写入的内容。</translation>
    </message>
    <message>
        <source>Side dock</source>
        <translation>侧栏</translation>
    </message>
    <message>
        <source>The demo machine could not be copied to &quot;%1&quot;.</source>
        <translation>演示机器无法复制到“%1”。</translation>
    </message>
    <message numerus="yes">
        <source>The edits are kept: %n steps.</source>
        <translation>
            <numerusform>编辑已保留：%n 步。</numerusform>
        </translation>
    </message>
    <message>
        <source>The project was not created.</source>
        <translation>工程未创建。</translation>
    </message>
    <message>
        <source>The project was not reloaded.</source>
        <translation>工程未重新加载。</translation>
    </message>
    <message>
        <source>The project was not saved.</source>
        <translation>工程未保存。</translation>
    </message>
    <message>
        <source>Unsaved Edits</source>
        <translation>未保存的编辑</translation>
    </message>
</context>
<context>
    <name>camwright::MotionColumn</name>
    <message>
        <source>Stop all axes</source>
        <translation>停止所有轴</translation>
    </message>
    <message>
        <source>Stops every axis at once. Esc and Space do the same while this panel is armed or moves the axis.</source>
        <translation>立即停止每个轴。此面板已激活或正在移动轴时，Esc 和空格键作用相同。</translation>
    </message>
    <message>
        <source>The axis is still moving.</source>
        <translation>轴仍在运动。</translation>
    </message>
</context>
<context>
    <name>camwright::MovePad</name>
    <message>
        <source>%1/s</source>
        <translation>%1/s</translation>
    </message>
    <message>
        <source>%1/s²</source>
        <translation>%1/s²</translation>
    </message>
    <message>
        <source>Absolute</source>
        <translation>绝对</translation>
    </message>
    <message>
        <source>Acceleration</source>
        <translation>加速度</translation>
    </message>
    <message>
        <source>Acceleration and deceleration of the move.</source>
        <translation>移动的加速度和减速度。</translation>
    </message>
    <message>
        <source>Distance</source>
        <translation>距离</translation>
    </message>
    <message>
        <source>Kind of move</source>
        <translation>移动方式</translation>
    </message>
    <message>
        <source>Move</source>
        <translation>移动</translation>
    </message>
    <message>
        <source>Moves by the distance.</source>
        <translation>按距离移动。</translation>
    </message>
    <message>
        <source>Moves to the target.</source>
        <translation>移动到目标。</translation>
    </message>
    <message>
        <source>Only for the duration shown here: a Kinco axis moves with its drive&apos;s own acceleration, drive parameters 0 and 1.</source>
        <translation>仅用于此处显示的时长：Kinco 轴按其驱动器自身的加速度（驱动器参数 0 和 1）运动。</translation>
    </message>
    <message>
        <source>Position to move to, or distance to move by.</source>
        <translation>要移动到的位置，或要移动的距离。</translation>
    </message>
    <message>
        <source>Profile</source>
        <translation>速度曲线</translation>
    </message>
    <message>
        <source>Relative</source>
        <translation>相对</translation>
    </message>
    <message>
        <source>Target</source>
        <translation>目标</translation>
    </message>
    <message>
        <source>The speed cap limits it.</source>
        <translation>受速度上限限制。</translation>
    </message>
    <message>
        <source>The target is a distance from where the axis stands.</source>
        <translation>目标是距轴当前位置的距离。</translation>
    </message>
    <message>
        <source>The target is a position.</source>
        <translation>目标是一个位置。</translation>
    </message>
    <message>
        <source>Velocity</source>
        <translation>速度</translation>
    </message>
    <message>
        <source>Velocity profile of the move</source>
        <translation>移动的速度曲线</translation>
    </message>
    <message>
        <source>already there</source>
        <translation>已在该处</translation>
    </message>
    <message>
        <source>at cap</source>
        <translation>按上限</translation>
    </message>
    <message>
        <source>takes %1 s</source>
        <translation>用时 %1 s</translation>
    </message>
</context>
<context>
    <name>camwright::NameDelegate</name>
    <message>
        <source>Name or address</source>
        <translation>名称或地址</translation>
    </message>
</context>
<context>
    <name>camwright::NetworkEditor</name>
    <message>
        <source>%1 Mbit/s</source>
        <translation>%1 Mbit/s</translation>
    </message>
    <message>
        <source>%1 kbit/s</source>
        <translation>%1 kbit/s</translation>
    </message>
    <message>
        <source>A drive on the bus and the mechanics behind it</source>
        <translation>总线上的驱动器及其后的机械</translation>
    </message>
    <message>
        <source>Add</source>
        <translation>添加</translation>
    </message>
    <message>
        <source>Add Axis</source>
        <translation>添加轴</translation>
    </message>
    <message>
        <source>Add an axis equal to the copied one, with the next number (Ctrl+V)</source>
        <translation>添加与所复制轴相同的轴，编号为下一个 (Ctrl+V)</translation>
    </message>
    <message>
        <source>Add an axis with default values (Alt+N)</source>
        <translation>添加一个默认值的轴 (Alt+N)</translation>
    </message>
    <message>
        <source>All axes</source>
        <translation>所有轴</translation>
    </message>
    <message>
        <source>Apply</source>
        <translation>应用</translation>
    </message>
    <message>
        <source>Apply and close</source>
        <translation>应用并关闭</translation>
    </message>
    <message>
        <source>Axis</source>
        <translation>轴</translation>
    </message>
    <message>
        <source>Axis List</source>
        <translation>轴列表</translation>
    </message>
    <message>
        <source>Baud rate</source>
        <translation>波特率</translation>
    </message>
    <message>
        <source>CANopen Master</source>
        <translation>CANopen 主站</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>取消</translation>
    </message>
    <message>
        <source>Change the motion network</source>
        <translation>更改运动网络</translation>
    </message>
    <message>
        <source>Copy</source>
        <translation>复制</translation>
    </message>
    <message>
        <source>Copy the selected axis (Ctrl+C)</source>
        <translation>复制所选轴 (Ctrl+C)</translation>
    </message>
    <message>
        <source>Delete</source>
        <translation>删除</translation>
    </message>
    <message>
        <source>Delete the selected axis (Del)</source>
        <translation>删除所选轴 (Del)</translation>
    </message>
    <message>
        <source>Drop the Changes</source>
        <translation>放弃更改</translation>
    </message>
    <message>
        <source>Drop what was changed since the last Apply</source>
        <translation>放弃上次应用之后的更改</translation>
    </message>
    <message>
        <source>Every axis with its parameters; double-click to edit one</source>
        <translation>每个轴及其参数；双击进行编辑</translation>
    </message>
    <message>
        <source>Give the axes the numbers 1, 2, 3 … in this order</source>
        <translation>按此顺序给各轴编号 1、2、3…</translation>
    </message>
    <message>
        <source>How long the master waits for the answer to a parameter request. A value is proposed on each change of the baud rate.</source>
        <translation>主站等待参数请求应答的时间。每次更改波特率都会建议一个值。</translation>
    </message>
    <message>
        <source>Motion Network</source>
        <translation>运动网络</translation>
    </message>
    <message>
        <source>Must be the same in every node of the bus (KS-MCN)</source>
        <translation>总线上每个节点须相同 (KS-MCN)</translation>
    </message>
    <message>
        <source>Network</source>
        <translation>网络</translation>
    </message>
    <message>
        <source>Not applied yet.</source>
        <translation>尚未应用。</translation>
    </message>
    <message>
        <source>Number from 1</source>
        <translation>从 1 起编号</translation>
    </message>
    <message>
        <source>OK</source>
        <translation>确定</translation>
    </message>
    <message>
        <source>Paste</source>
        <translation>粘贴</translation>
    </message>
    <message>
        <source>Put the changes into the project</source>
        <translation>将更改写入工程</translation>
    </message>
    <message>
        <source>SDO time-out</source>
        <translation>SDO 超时</translation>
    </message>
    <message>
        <source>Stay Here</source>
        <translation>留在此处</translation>
    </message>
    <message>
        <source>The controller on the bus of its drives</source>
        <translation>驱动器总线上的控制器</translation>
    </message>
    <message>
        <source>The master and its axes</source>
        <translation>主站及其各轴</translation>
    </message>
    <message>
        <source>The motion network has changes that were not applied to the project.</source>
        <translation>运动网络有尚未应用到工程的更改。</translation>
    </message>
    <message>
        <source>Unapplied Changes</source>
        <translation>未应用的更改</translation>
    </message>
    <message>
        <source>ms</source>
        <translation>ms</translation>
    </message>
</context>
<context>
    <name>camwright::NewProjectDialog</name>
    <message>
        <source>&quot;%1&quot; is already there. Choose another name or folder.</source>
        <translation>“%1”已存在。选择另一名称或文件夹。</translation>
    </message>
    <message>
        <source>%1 inputs, %2 outputs</source>
        <translation>%1 个输入，%2 个输出</translation>
    </message>
    <message numerus="yes">
        <source>%n CAN ports</source>
        <translation>
            <numerusform>%n 个 CAN 口</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n Ethernet ports</source>
        <translation>
            <numerusform>%n 个以太网口</numerusform>
        </translation>
    </message>
    <message>
        <source>Also the name of its folder.</source>
        <translation>也是其文件夹的名称。</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>取消</translation>
    </message>
    <message>
        <source>Choose a folder</source>
        <translation>选择文件夹</translation>
    </message>
    <message>
        <source>Controller family</source>
        <translation>控制器系列</translation>
    </message>
    <message>
        <source>Create Project</source>
        <translation>创建工程</translation>
    </message>
    <message>
        <source>Create project</source>
        <translation>创建工程</translation>
    </message>
    <message>
        <source>Family</source>
        <translation>系列</translation>
    </message>
    <message>
        <source>Folder</source>
        <translation>文件夹</translation>
    </message>
    <message>
        <source>Folder for the New Project</source>
        <translation>新工程的文件夹</translation>
    </message>
    <message>
        <source>In folder</source>
        <translation>所在文件夹</translation>
    </message>
    <message>
        <source>Model</source>
        <translation>型号</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>名称</translation>
    </message>
    <message>
        <source>New Project</source>
        <translation>新建工程</translation>
    </message>
    <message>
        <source>Project name</source>
        <translation>工程名称</translation>
    </message>
    <message>
        <source>The name becomes a folder&apos;s: it cannot hold &quot;/&quot; or begin with a dot.</source>
        <translation>名称将成为文件夹名：不能含有“/”，也不能以点开头。</translation>
    </message>
    <message>
        <source>The project needs a name.</source>
        <translation>工程需要名称。</translation>
    </message>
    <message>
        <source>The project&apos;s own folder is made inside it.</source>
        <translation>工程自己的文件夹建在其中。</translation>
    </message>
    <message>
        <source>machine</source>
        <translation>机器</translation>
    </message>
    <message numerus="yes">
        <source>up to %n axes</source>
        <translation>
            <numerusform>最多 %n 个轴</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>camwright::NoticeBar</name>
    <message>
        <source>Close the message</source>
        <translation>关闭消息</translation>
    </message>
    <message>
        <source>Message</source>
        <translation>消息</translation>
    </message>
</context>
<context>
    <name>camwright::OutputPanel</name>
    <message>
        <source>Nothing was built or downloaded yet.</source>
        <translation>尚未编译或下载。</translation>
    </message>
    <message>
        <source>Output</source>
        <translation>输出</translation>
    </message>
    <message>
        <source>What checks, builds and downloads said.</source>
        <translation>检查、编译和下载的报告。</translation>
    </message>
</context>
<context>
    <name>camwright::Palette</name>
    <message>
        <source>Found</source>
        <translation>找到的项</translation>
    </message>
</context>
<context>
    <name>camwright::PanelControl</name>
    <message>
        <source>%1 has taken control. Panel control is off.</source>
        <translation>%1 已取得控制权。面板控制已关闭。</translation>
    </message>
    <message>
        <source>Arm panel control first.</source>
        <translation>先激活面板控制。</translation>
    </message>
    <message>
        <source>Control was lost. Panel control is off.</source>
        <translation>已失去控制权。面板控制已关闭。</translation>
    </message>
    <message>
        <source>Enable the axis first.</source>
        <translation>先使能轴。</translation>
    </message>
    <message>
        <source>Go online to move this axis.</source>
        <translation>转到在线以移动此轴。</translation>
    </message>
    <message>
        <source>The axis has an error. Remove its cause, then reset it.</source>
        <translation>轴有错误。排除原因后复位。</translation>
    </message>
    <message>
        <source>The controller has ended panel control of this axis. Arm it again to go on.</source>
        <translation>控制器已结束对此轴的面板控制。重新激活后继续。</translation>
    </message>
    <message>
        <source>The drive is not on the bus.</source>
        <translation>驱动器不在总线上。</translation>
    </message>
</context>
<context>
    <name>camwright::ProblemsModel</name>
    <message>
        <source>Code</source>
        <translation>代码</translation>
    </message>
    <message>
        <source>Place</source>
        <translation>位置</translation>
    </message>
    <message>
        <source>Problem</source>
        <translation>问题</translation>
    </message>
</context>
<context>
    <name>camwright::ProblemsView</name>
    <message>
        <source>Copy</source>
        <translation>复制</translation>
    </message>
    <message>
        <source>Go to Its Place</source>
        <translation>转到其位置</translation>
    </message>
    <message>
        <source>No problems. Checks run as you type.</source>
        <translation>没有问题。输入时即进行检查。</translation>
    </message>
    <message>
        <source>Problems</source>
        <translation>问题</translation>
    </message>
    <message>
        <source>What is wrong with the project. Enter goes to the place, F1 explains the message, and a lamp tells that there is a quick fix.</source>
        <translation>工程中的问题。按 Enter 转到该处，按 F1 查看消息说明；灯泡表示有快速修复。</translation>
    </message>
</context>
<context>
    <name>camwright::ProgramEditor</name>
    <message>
        <source>&quot;%1&quot; cannot be read: %2.</source>
        <translation>无法读取“%1”：%2。</translation>
    </message>
    <message>
        <source>&quot;%1&quot; has no definition in this project.</source>
        <translation>“%1”在此工程中没有定义。</translation>
    </message>
    <message numerus="yes">
        <source>%n place(s) replaced. Ctrl+Z takes them back.</source>
        <translation>
            <numerusform>已替换 %n 处。Ctrl+Z 可恢复。</numerusform>
        </translation>
    </message>
    <message>
        <source>Clean the Pasted Text</source>
        <translation>清理粘贴的文本</translation>
    </message>
    <message>
        <source>Import Kinco Program Text</source>
        <translation>导入 Kinco 程序文本</translation>
    </message>
    <message>
        <source>Keep It</source>
        <translation>保留原样</translation>
    </message>
    <message>
        <source>KincoBuilder programs (*.ilp *.il *.txt);;All files (*)</source>
        <translation>KincoBuilder 程序 (*.ilp *.il *.txt);;所有文件 (*)</translation>
    </message>
    <message>
        <source>Program</source>
        <translation>程序</translation>
    </message>
    <message>
        <source>Program text</source>
        <translation>程序文本</translation>
    </message>
    <message numerus="yes">
        <source>The pasted text has marks of a document, not of a program: %n place(s). It can be cleaned.</source>
        <translation>
            <numerusform>粘贴的文本含有文档标记，而非程序内容：%n 处。可以清除。</numerusform>
        </translation>
    </message>
    <message>
        <source>The program was replaced by the text of &quot;%1&quot;. Ctrl+Z takes it back.</source>
        <translation>程序已替换为“%1”的文本。Ctrl+Z 可恢复。</translation>
    </message>
    <message>
        <source>line %1, column %2</source>
        <translation>第 %1 行，第 %2 列</translation>
    </message>
</context>
<context>
    <name>camwright::ProjectDocument</name>
    <message>
        <source>Reload from disk</source>
        <translation>从磁盘重新加载</translation>
    </message>
    <message>
        <source>Restore unsaved edits</source>
        <translation>恢复未保存的编辑</translation>
    </message>
</context>
<context>
    <name>camwright::ProjectPanel</name>
    <message>
        <source>Add Axis</source>
        <translation>添加轴</translation>
    </message>
    <message>
        <source>Add Network</source>
        <translation>添加网络</translation>
    </message>
    <message>
        <source>Add Program</source>
        <translation>添加程序</translation>
    </message>
    <message>
        <source>Add Variable Table</source>
        <translation>添加变量表</translation>
    </message>
    <message>
        <source>Add Watch List</source>
        <translation>添加监视表</translation>
    </message>
    <message>
        <source>Closes all sections of the tree.</source>
        <translation>折叠树的所有部分。</translation>
    </message>
    <message>
        <source>Collapse all</source>
        <translation>全部折叠</translation>
    </message>
    <message>
        <source>Delete</source>
        <translation>删除</translation>
    </message>
    <message>
        <source>Duplicate</source>
        <translation>创建副本</translation>
    </message>
    <message>
        <source>ERROR</source>
        <translation>错误</translation>
    </message>
    <message>
        <source>Filter</source>
        <translation>筛选</translation>
    </message>
    <message>
        <source>Filter the project</source>
        <translation>筛选工程</translation>
    </message>
    <message>
        <source>Name contains</source>
        <translation>名称包含</translation>
    </message>
    <message>
        <source>Open %1</source>
        <translation>打开 %1</translation>
    </message>
    <message>
        <source>Project</source>
        <translation>工程</translation>
    </message>
    <message>
        <source>Rename</source>
        <translation>重命名</translation>
    </message>
    <message>
        <source>Shows only objects whose name contains a word.</source>
        <translation>只显示名称含有该词的对象。</translation>
    </message>
</context>
<context>
    <name>camwright::ProjectTreeModel</name>
    <message>
        <source>Axes</source>
        <translation>轴</translation>
    </message>
    <message>
        <source>Controller</source>
        <translation>控制器</translation>
    </message>
    <message>
        <source>Networks</source>
        <translation>网络</translation>
    </message>
    <message>
        <source>Programs</source>
        <translation>程序</translation>
    </message>
    <message>
        <source>Project</source>
        <translation>工程</translation>
    </message>
    <message>
        <source>Variables</source>
        <translation>变量</translation>
    </message>
    <message>
        <source>Watch lists</source>
        <translation>监视表</translation>
    </message>
    <message>
        <source>none</source>
        <translation>无</translation>
    </message>
</context>
<context>
    <name>camwright::QuantityField</name>
    <message>
        <source> of %1</source>
        <translation>（单位 %1）</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is not a number%2.</source>
        <translation>“%1”不是数%2。</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is not a whole number%2.</source>
        <translation>“%1”不是整数%2。</translation>
    </message>
    <message>
        <source>%1 in %2</source>
        <translation>%1（%2）</translation>
    </message>
    <message>
        <source>%1: return to the default</source>
        <translation>%1：恢复默认值</translation>
    </message>
    <message>
        <source>Above the range %1 to %2%3.</source>
        <translation>高于范围 %1 至 %2%3。</translation>
    </message>
    <message>
        <source>At least %1%2.</source>
        <translation>至少 %1%2。</translation>
    </message>
    <message>
        <source>At most %1%2.</source>
        <translation>最多 %1%2。</translation>
    </message>
    <message>
        <source>Below the range %1 to %2%3.</source>
        <translation>低于范围 %1 至 %2%3。</translation>
    </message>
    <message>
        <source>Default: %1 %2</source>
        <translation>默认：%1 %2</translation>
    </message>
    <message>
        <source>Differs from the default %1 %2. Click to return to it.</source>
        <translation>与默认值 %1 %2 不同。单击恢复默认值。</translation>
    </message>
    <message>
        <source>Range: %1 to %2 %3</source>
        <translation>范围：%1 至 %2 %3</translation>
    </message>
</context>
<context>
    <name>camwright::Readings</name>
    <message>
        <source>%1/s</source>
        <translation>%1/s</translation>
    </message>
    <message>
        <source>Actual Position</source>
        <translation>实际位置</translation>
    </message>
    <message>
        <source>Actual position</source>
        <translation>实际位置</translation>
    </message>
    <message>
        <source>Following error</source>
        <translation>跟随误差</translation>
    </message>
    <message>
        <source>Largest values since the last reset. Click to begin again.</source>
        <translation>上次复位以来的最大值。单击重新开始。</translation>
    </message>
    <message>
        <source>Position of the load as the drive measures it</source>
        <translation>驱动器测得的负载位置</translation>
    </message>
    <message>
        <source>Position, stopping distance and target between the limits</source>
        <translation>位置、停止距离和目标，位于限位之间</translation>
    </message>
    <message>
        <source>Reset the peaks</source>
        <translation>复位峰值</translation>
    </message>
    <message>
        <source>Set position</source>
        <translation>指令位置</translation>
    </message>
    <message>
        <source>To target</source>
        <translation>距目标</translation>
    </message>
    <message>
        <source>Torque</source>
        <translation>转矩</translation>
    </message>
    <message>
        <source>Travel</source>
        <translation>行程</translation>
    </message>
    <message>
        <source>Velocity</source>
        <translation>速度</translation>
    </message>
    <message>
        <source>disabled</source>
        <translation>未使能</translation>
    </message>
    <message>
        <source>error</source>
        <translation>错误</translation>
    </message>
    <message>
        <source>homed</source>
        <translation>已回原点</translation>
    </message>
    <message>
        <source>moving +</source>
        <translation>正向运动</translation>
    </message>
    <message>
        <source>moving −</source>
        <translation>负向运动</translation>
    </message>
    <message>
        <source>not homed</source>
        <translation>未回原点</translation>
    </message>
    <message>
        <source>now</source>
        <translation>当前</translation>
    </message>
    <message>
        <source>peak</source>
        <translation>峰值</translation>
    </message>
    <message>
        <source>standing</source>
        <translation>静止</translation>
    </message>
    <message>
        <source>stops within %1 %2</source>
        <translation>在 %1 %2 内停止</translation>
    </message>
</context>
<context>
    <name>camwright::RecentList</name>
    <message numerus="yes">
        <source>%n errors</source>
        <translation>
            <numerusform>%n 个错误</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n warnings</source>
        <translation>
            <numerusform>%n 个警告</numerusform>
        </translation>
    </message>
    <message>
        <source>Controller</source>
        <translation>控制器</translation>
    </message>
    <message>
        <source>Last state</source>
        <translation>上次状态</translation>
    </message>
    <message>
        <source>Open</source>
        <translation>打开</translation>
    </message>
    <message>
        <source>Opened</source>
        <translation>打开时间</translation>
    </message>
    <message>
        <source>Project</source>
        <translation>工程</translation>
    </message>
    <message>
        <source>Ran on the virtual controller</source>
        <translation>曾在虚拟控制器上运行</translation>
    </message>
    <message>
        <source>Recent projects</source>
        <translation>最近的工程</translation>
    </message>
    <message>
        <source>Remove From This List</source>
        <translation>从此列表中移除</translation>
    </message>
    <message>
        <source>Same program on %1</source>
        <translation>与 %1 上的程序相同</translation>
    </message>
    <message>
        <source>Saved, no problems</source>
        <translation>已保存，没有问题</translation>
    </message>
    <message>
        <source>Today %1</source>
        <translation>今天 %1</translation>
    </message>
    <message>
        <source>Unsaved edits kept, opening restores them</source>
        <translation>未保存的编辑已保留，打开时恢复</translation>
    </message>
    <message>
        <source>Yesterday</source>
        <translation>昨天</translation>
    </message>
</context>
<context>
    <name>camwright::ReferencesModel</name>
    <message>
        <source>%1, network %2, line %3</source>
        <translation>%1，网络 %2，第 %3 行</translation>
    </message>
    <message>
        <source>%1, overlaps as %2</source>
        <translation>%1，以 %2 重叠</translation>
    </message>
    <message>
        <source>%1, row %2</source>
        <translation>%1，第 %2 行</translation>
    </message>
    <message>
        <source>Text</source>
        <translation>文本</translation>
    </message>
    <message>
        <source>Use</source>
        <translation>使用方式</translation>
    </message>
    <message>
        <source>Where</source>
        <translation>位置</translation>
    </message>
    <message>
        <source>calls</source>
        <translation>调用</translation>
    </message>
    <message>
        <source>commands</source>
        <translation>控制</translation>
    </message>
    <message>
        <source>declares</source>
        <translation>声明</translation>
    </message>
    <message>
        <source>reads</source>
        <translation>读取</translation>
    </message>
    <message>
        <source>reads and writes</source>
        <translation>读取并写入</translation>
    </message>
    <message>
        <source>watches</source>
        <translation>监视</translation>
    </message>
    <message>
        <source>writes</source>
        <translation>写入</translation>
    </message>
</context>
<context>
    <name>camwright::ReferencesPanel</name>
    <message>
        <source>&quot;%1&quot; is no variable, address, axis or subroutine.</source>
        <translation>“%1”不是变量、地址、轴或子程序。</translation>
    </message>
    <message>
        <source>%1: read %2, written %3, overlaps %4</source>
        <translation>%1：读取 %2，写入 %3，重叠 %4</translation>
    </message>
    <message>
        <source>Nothing uses %1.</source>
        <translation>没有任何地方使用 %1。</translation>
    </message>
    <message>
        <source>References</source>
        <translation>引用</translation>
    </message>
    <message>
        <source>Shift+F12 at a name or an address lists where it is used.</source>
        <translation>在名称或地址上按 Shift+F12 可列出其使用之处。</translation>
    </message>
    <message>
        <source>Where the thing is used. Enter goes to the place, Esc back to where you asked.</source>
        <translation>该对象的使用之处。按 Enter 转到该处，按 Esc 返回查询的位置。</translation>
    </message>
</context>
<context>
    <name>camwright::ScopePlot</name>
    <message>
        <source>Curves of the recording</source>
        <translation>记录的曲线</translation>
    </message>
    <message>
        <source>Drag to zoom, wheel to zoom time, Shift and drag to move, double-click to fit; drag a cursor to measure.</source>
        <translation>拖动缩放，滚轮缩放时间，Shift 加拖动平移，双击适应；拖动游标进行测量。</translation>
    </message>
</context>
<context>
    <name>camwright::ScreenWatch</name>
    <message>
        <source>The computer goes to sleep. Panel control is off.</source>
        <translation>计算机即将休眠。面板控制已关闭。</translation>
    </message>
    <message>
        <source>The computer was asleep. Panel control is off.</source>
        <translation>计算机曾进入休眠。面板控制已关闭。</translation>
    </message>
    <message>
        <source>The screen was locked. Panel control is off.</source>
        <translation>屏幕已锁定。面板控制已关闭。</translation>
    </message>
</context>
<context>
    <name>camwright::SettingsDialog</name>
    <message>
        <source>Close</source>
        <translation>关闭</translation>
    </message>
    <message>
        <source>Dark</source>
        <translation>深色</translation>
    </message>
    <message>
        <source>Follows the desktop.</source>
        <translation>跟随桌面。</translation>
    </message>
    <message>
        <source>General</source>
        <translation>常规</translation>
    </message>
    <message>
        <source>Keys</source>
        <translation>按键</translation>
    </message>
    <message>
        <source>Language</source>
        <translation>语言</translation>
    </message>
    <message>
        <source>Light</source>
        <translation>浅色</translation>
    </message>
    <message>
        <source>Of the window, the messages and the help of instructions. Switches at once.</source>
        <translation>窗口、消息和指令帮助的语言。立即切换。</translation>
    </message>
    <message>
        <source>Pages of the settings</source>
        <translation>设置页面</translation>
    </message>
    <message>
        <source>Settings</source>
        <translation>设置</translation>
    </message>
    <message>
        <source>System</source>
        <translation>跟随系统</translation>
    </message>
    <message>
        <source>Theme</source>
        <translation>主题</translation>
    </message>
</context>
<context>
    <name>camwright::StartPage</name>
    <message>
        <source>Add a CANopen drive</source>
        <translation>添加 CANopen 驱动器</translation>
    </message>
    <message>
        <source>Addresses, the download plan, who has control. 8 minutes</source>
        <translation>地址、下载计划、控制权归属。8 分钟</translation>
    </message>
    <message>
        <source>An axis of the motion network and its fields. 10 minutes</source>
        <translation>运动网络中的轴及其字段。10 分钟</translation>
    </message>
    <message>
        <source>Camwright&apos;s own controller on this or another PC.</source>
        <translation>Camwright 自己的控制器，运行在本机或另一台电脑上。</translation>
    </message>
    <message>
        <source>Compact controller with up to 32 CANopen axes.</source>
        <translation>紧凑型控制器，最多 32 个 CANopen 轴。</translation>
    </message>
    <message>
        <source>Enable, home and jog a simulated drive. 5 minutes</source>
        <translation>使能、回原点并点动仿真驱动器。5 分钟</translation>
    </message>
    <message>
        <source>Enter</source>
        <translation>Enter</translation>
    </message>
    <message>
        <source>Go online</source>
        <translation>转到在线</translation>
    </message>
    <message>
        <source>Hold jog: the axis moves</source>
        <translation>按住点动：轴移动</translation>
    </message>
    <message>
        <source>Instructions, variables, watch and force. 10 minutes</source>
        <translation>指令、变量、监视和强制。10 分钟</translation>
    </message>
    <message>
        <source>Learn</source>
        <translation>学习</translation>
    </message>
    <message>
        <source>Logic of the DL205 in instruction list; I-boxes are checked only.</source>
        <translation>用指令表编写 DL205 逻辑；I-box 仅做检查。</translation>
    </message>
    <message>
        <source>Logic of the TS600 in instruction list, with its timers and counters.</source>
        <translation>TS600 的指令表逻辑，带定时器和计数器。</translation>
    </message>
    <message>
        <source>Move an axis for the first time</source>
        <translation>第一次移动轴</translation>
    </message>
    <message>
        <source>New project</source>
        <translation>新建工程</translation>
    </message>
    <message>
        <source>Not in this version.</source>
        <translation>本版本未提供。</translation>
    </message>
    <message>
        <source>Open</source>
        <translation>打开</translation>
    </message>
    <message>
        <source>Open a folder</source>
        <translation>打开文件夹</translation>
    </message>
    <message>
        <source>Open the demo machine</source>
        <translation>打开演示机器</translation>
    </message>
    <message>
        <source>Opens a machine with two simulated axes and connects to its virtual controller.</source>
        <translation>打开一台带两个仿真轴的机器，并连接其虚拟控制器。</translation>
    </message>
    <message>
        <source>Opens a project folder (Ctrl+O).</source>
        <translation>打开一个工程文件夹 (Ctrl+O)。</translation>
    </message>
    <message>
        <source>Projects you open are listed here with the state they were left in.</source>
        <translation>您打开的工程列在此处，并显示离开时的状态。</translation>
    </message>
    <message>
        <source>Recent projects</source>
        <translation>最近的工程</translation>
    </message>
    <message>
        <source>Run</source>
        <translation>运行</translation>
    </message>
    <message>
        <source>Soft controller</source>
        <translation>软控制器</translation>
    </message>
    <message>
        <source>Two simulated drives on a Kinco KS101M: Feed pushes the strip, Turn indexes it. Nothing real moves.</source>
        <translation>一台 Kinco KS101M 带两个仿真驱动器：Feed 送料，Turn 分度。不会有真实运动。</translation>
    </message>
    <message>
        <source>Virtual terminals</source>
        <translation>虚拟端子</translation>
    </message>
    <message>
        <source>Write and run a program</source>
        <translation>编写并运行程序</translation>
    </message>
</context>
<context>
    <name>camwright::StateDiagram</name>
    <message>
        <source>Moving</source>
        <translation>运动</translation>
    </message>
    <message>
        <source>Stop, done</source>
        <translation>停止完成</translation>
    </message>
    <message>
        <source>any fault</source>
        <translation>任何故障</translation>
    </message>
    <message>
        <source>power</source>
        <translation>上电</translation>
    </message>
    <message>
        <source>reset, off</source>
        <translation>复位，断电</translation>
    </message>
    <message>
        <source>reset, on</source>
        <translation>复位，上电</translation>
    </message>
</context>
<context>
    <name>camwright::StateView</name>
    <message>
        <source>%1 h ago</source>
        <translation>%1 h 前</translation>
    </message>
    <message>
        <source>%1 min ago</source>
        <translation>%1 min 前</translation>
    </message>
    <message>
        <source>%1 s ago</source>
        <translation>%1 s 前</translation>
    </message>
    <message>
        <source>%1, %2</source>
        <translation>%1，%2</translation>
    </message>
    <message>
        <source>Axis State</source>
        <translation>轴状态</translation>
    </message>
    <message>
        <source>Axis state</source>
        <translation>轴状态</translation>
    </message>
    <message>
        <source>States of the axis; the lit one is the current one</source>
        <translation>轴的各状态；点亮的是当前状态</translation>
    </message>
    <message>
        <source>no change since the controller started</source>
        <translation>控制器启动以来没有变化</translation>
    </message>
    <message>
        <source>state %1</source>
        <translation>状态 %1</translation>
    </message>
</context>
<context>
    <name>camwright::StatusLine</name>
    <message>
        <source>%1 (read only)</source>
        <translation>%1（只读）</translation>
    </message>
    <message>
        <source>%1, not saved</source>
        <translation>%1，未保存</translation>
    </message>
    <message numerus="yes">
        <source>%n errors</source>
        <translation>
            <numerusform>%n 个错误</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n warnings</source>
        <translation>
            <numerusform>%n 个警告</numerusform>
        </translation>
    </message>
    <message>
        <source>CONNECTING</source>
        <translation>正在连接</translation>
    </message>
    <message>
        <source>Camwright %1</source>
        <translation>Camwright %1</translation>
    </message>
    <message>
        <source>ERROR</source>
        <translation>错误</translation>
    </message>
    <message>
        <source>LOST</source>
        <translation>连接断开</translation>
    </message>
    <message>
        <source>Longest scan %1 ms</source>
        <translation>最长扫描 %1 ms</translation>
    </message>
    <message>
        <source>No project open</source>
        <translation>没有打开工程</translation>
    </message>
    <message>
        <source>OFFLINE</source>
        <translation>离线</translation>
    </message>
    <message>
        <source>building</source>
        <translation>正在编译</translation>
    </message>
    <message>
        <source>built</source>
        <translation>已编译</translation>
    </message>
    <message>
        <source>bus %1 %</source>
        <translation>总线 %1 %</translation>
    </message>
    <message>
        <source>control: %1</source>
        <translation>控制权：%1</translation>
    </message>
    <message>
        <source>control: nobody</source>
        <translation>控制权：无</translation>
    </message>
    <message>
        <source>control: you</source>
        <translation>控制权：您</translation>
    </message>
    <message>
        <source>forces %1</source>
        <translation>强制 %1</translation>
    </message>
    <message>
        <source>not built since the last edit</source>
        <translation>上次编辑后未编译</translation>
    </message>
    <message>
        <source>program differs ≠</source>
        <translation>程序不一致 ≠</translation>
    </message>
    <message>
        <source>program same ✓</source>
        <translation>程序一致 ✓</translation>
    </message>
    <message>
        <source>scan %1 ms</source>
        <translation>扫描 %1 ms</translation>
    </message>
</context>
<context>
    <name>camwright::StopButton</name>
    <message>
        <source>STOP</source>
        <translation>停止</translation>
    </message>
    <message>
        <source>all axes</source>
        <translation>所有轴</translation>
    </message>
</context>
<context>
    <name>camwright::TerminalLamp</name>
    <message>
        <source>%1, off</source>
        <translation>%1，断开</translation>
    </message>
    <message>
        <source>%1, on</source>
        <translation>%1，接通</translation>
    </message>
    <message>
        <source>Input %1. Click to switch it on or off; it stays until clicked again.</source>
        <translation>输入 %1。单击接通或断开；保持到再次单击。</translation>
    </message>
    <message>
        <source>Output %1.</source>
        <translation>输出 %1。</translation>
    </message>
</context>
<context>
    <name>camwright::TerminalsPanel</name>
    <message>
        <source>A real controller&apos;s inputs are wired. Force a value in the watch table instead.</source>
        <translation>真实控制器的输入是接线的。请改为在监视表中强制值。</translation>
    </message>
    <message>
        <source>Go online with the virtual controller to switch its inputs and see its outputs.</source>
        <translation>连接虚拟控制器后，可切换其输入并查看其输出。</translation>
    </message>
    <message>
        <source>Inputs</source>
        <translation>输入</translation>
    </message>
    <message>
        <source>Inputs and Outputs</source>
        <translation>输入和输出</translation>
    </message>
    <message>
        <source>Outputs</source>
        <translation>输出</translation>
    </message>
    <message>
        <source>The controller has no program yet. Download one to see its terminals.</source>
        <translation>控制器还没有程序。下载一个以查看其端子。</translation>
    </message>
    <message>
        <source>click to switch</source>
        <translation>单击切换</translation>
    </message>
</context>
<context>
    <name>camwright::ToolRow</name>
    <message>
        <source>&lt;b&gt;Controller&apos;s address&lt;/b&gt;&lt;br&gt;local: the virtual controller of this project. tcp://HOST[:PORT]: a controller on the network.</source>
        <translation>&lt;b&gt;控制器地址&lt;/b&gt;&lt;br&gt;local：本工程的虚拟控制器。tcp://HOST[:PORT]：网络上的控制器。</translation>
    </message>
    <message>
        <source>Controller&apos;s address</source>
        <translation>控制器地址</translation>
    </message>
    <message>
        <source>Find anything</source>
        <translation>查找任意内容</translation>
    </message>
    <message>
        <source>Online</source>
        <translation>在线</translation>
    </message>
    <message>
        <source>local · virtual controller</source>
        <translation>local · 虚拟控制器</translation>
    </message>
    <message>
        <source>no controller</source>
        <translation>没有控制器</translation>
    </message>
</context>
<context>
    <name>camwright::TracePanel</name>
    <message>
        <source>   RMS %1   slope %2 %3/s</source>
        <translation>   RMS %1   斜率 %2 %3/s</translation>
    </message>
    <message>
        <source>&quot;%1&quot; cannot be written: %2. Choose another folder.</source>
        <translation>无法写入“%1”：%2。选择另一个文件夹。</translation>
    </message>
    <message>
        <source>%1   A %2   B %3   Δt %4 s</source>
        <translation>%1   A %2   B %3   Δt %4 s</translation>
    </message>
    <message>
        <source>%1   A %2   B %3   Δt %4 s   Δy %5 %6   min %7   max %8   mean %9</source>
        <translation>%1   A %2   B %3   Δt %4 s   Δy %5 %6   最小 %7   最大 %8   平均 %9</translation>
    </message>
    <message>
        <source>%1 samples</source>
        <translation>%1 个采样</translation>
    </message>
    <message>
        <source>A lane for each channel</source>
        <translation>每个通道一栏</translation>
    </message>
    <message>
        <source>Add a channel</source>
        <translation>添加通道</translation>
    </message>
    <message>
        <source>Add a channel or choose a preset, then press Record to see it in every motion cycle.</source>
        <translation>添加通道或选择预设，然后按“记录”，即可查看每个运动周期的数值。</translation>
    </message>
    <message>
        <source>Address, variable or axis value like axis.Feed.position; Enter adds it</source>
        <translation>地址、变量或轴值，如 axis.Feed.position；按 Enter 添加</translation>
    </message>
    <message>
        <source>All channels in one lane</source>
        <translation>所有通道在同一栏</translation>
    </message>
    <message>
        <source>Arrangement</source>
        <translation>排列</translation>
    </message>
    <message>
        <source>CSV files (*.csv)</source>
        <translation>CSV 文件 (*.csv)</translation>
    </message>
    <message>
        <source>CSV...</source>
        <translation>CSV...</translation>
    </message>
    <message>
        <source>Channels</source>
        <translation>通道</translation>
    </message>
    <message>
        <source>End</source>
        <translation>结束</translation>
    </message>
    <message>
        <source>Export as CSV</source>
        <translation>导出为 CSV</translation>
    </message>
    <message>
        <source>Export the Recording</source>
        <translation>导出记录</translation>
    </message>
    <message>
        <source>Fills in the channels that belong together</source>
        <translation>填入相关的一组通道</translation>
    </message>
    <message>
        <source>Fit</source>
        <translation>适应</translation>
    </message>
    <message>
        <source>Go online, then press Record to see the channels in every motion cycle.</source>
        <translation>转到在线后按“记录”，即可查看各通道在每个运动周期的数值。</translation>
    </message>
    <message>
        <source>Live</source>
        <translation>实时</translation>
    </message>
    <message>
        <source>Move of %1</source>
        <translation>%1 的运动</translation>
    </message>
    <message>
        <source>Oscilloscope</source>
        <translation>示波器</translation>
    </message>
    <message>
        <source>Overlaid</source>
        <translation>叠加</translation>
    </message>
    <message>
        <source>Pause</source>
        <translation>暂停</translation>
    </message>
    <message>
        <source>Preset</source>
        <translation>预设</translation>
    </message>
    <message>
        <source>Press Record to see the channels in every motion cycle.</source>
        <translation>按“记录”即可查看各通道在每个运动周期的数值。</translation>
    </message>
    <message>
        <source>Record</source>
        <translation>记录</translation>
    </message>
    <message>
        <source>Record, then drag the two cursors to measure.</source>
        <translation>先记录，再拖动两个游标进行测量。</translation>
    </message>
    <message>
        <source>Show the whole recording (double-click in the curves)</source>
        <translation>显示全部记录（在曲线中双击）</translation>
    </message>
    <message>
        <source>Stacked</source>
        <translation>分栏</translation>
    </message>
    <message>
        <source>Start or end a recording of the channels</source>
        <translation>开始或结束通道的记录</translation>
    </message>
    <message>
        <source>The curves appear as soon as the recording has samples.</source>
        <translation>记录中一有采样，就会显示曲线。</translation>
    </message>
    <message>
        <source>The newest samples stay in view</source>
        <translation>最新的采样保持在视图中</translation>
    </message>
    <message>
        <source>The recording is in &quot;%1&quot;.</source>
        <translation>记录已保存到“%1”。</translation>
    </message>
    <message>
        <source>The view stays; the recording goes on</source>
        <translation>视图停住；记录继续</translation>
    </message>
    <message>
        <source>What is recorded; the mark shows or hides a curve</source>
        <translation>要记录的内容；勾选可显示或隐藏曲线</translation>
    </message>
    <message>
        <source>Write the recording to a CSV file</source>
        <translation>将记录写入 CSV 文件</translation>
    </message>
    <message>
        <source>offline</source>
        <translation>离线</translation>
    </message>
    <message>
        <source>ready</source>
        <translation>就绪</translation>
    </message>
    <message>
        <source>recording, %1 samples</source>
        <translation>正在记录，%1 个采样</translation>
    </message>
    <message>
        <source>waiting</source>
        <translation>等待中</translation>
    </message>
</context>
<context>
    <name>camwright::TransmissionView</name>
    <message>
        <source>%1 mm per motor turn</source>
        <translation>电机每转 %1 mm</translation>
    </message>
    <message>
        <source>%1 pulses per turn</source>
        <translation>每转 %1 脉冲</translation>
    </message>
    <message>
        <source>%1 pulses ÷ %2 %4 = %3 pulses/%4</source>
        <translation>%1 脉冲 ÷ %2 %4 = %3 脉冲/%4</translation>
    </message>
    <message>
        <source>%1° per motor turn</source>
        <translation>电机每转 %1°</translation>
    </message>
    <message>
        <source>Drawing of motor and load</source>
        <translation>电机和负载示意图</translation>
    </message>
    <message>
        <source>mm</source>
        <translation>mm</translation>
    </message>
    <message>
        <source>mm per motor turn ?</source>
        <translation>电机每转 mm？</translation>
    </message>
    <message>
        <source>pulses per turn ?</source>
        <translation>每转脉冲数？</translation>
    </message>
    <message>
        <source>°</source>
        <translation>°</translation>
    </message>
    <message>
        <source>° per motor turn ?</source>
        <translation>电机每转角度？</translation>
    </message>
</context>
<context>
    <name>camwright::TravelBar</name>
    <message>
        <source>target %1</source>
        <translation>目标 %1</translation>
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
        <translation>高于电平</translation>
    </message>
    <message>
        <source>At once, live</source>
        <translation>立即，实时</translation>
    </message>
    <message>
        <source>Below level</source>
        <translation>低于电平</translation>
    </message>
    <message>
        <source>Falling edge of</source>
        <translation>下降沿</translation>
    </message>
    <message>
        <source>How much of the recording lies before the trigger.</source>
        <translation>记录中有多少位于触发之前。</translation>
    </message>
    <message>
        <source>Length</source>
        <translation>长度</translation>
    </message>
    <message>
        <source>Length of a triggered recording.</source>
        <translation>触发记录的长度。</translation>
    </message>
    <message>
        <source>Part before the trigger</source>
        <translation>触发前部分</translation>
    </message>
    <message>
        <source>Rising edge of</source>
        <translation>上升沿</translation>
    </message>
    <message>
        <source>Trigger</source>
        <translation>触发</translation>
    </message>
    <message>
        <source>Trigger channel</source>
        <translation>触发通道</translation>
    </message>
    <message>
        <source>Trigger level</source>
        <translation>触发电平</translation>
    </message>
    <message>
        <source>Value at which the recording is triggered.</source>
        <translation>达到此值时触发记录。</translation>
    </message>
    <message>
        <source>Value that is watched for the trigger</source>
        <translation>为触发而监视的值</translation>
    </message>
    <message>
        <source>What starts the recording</source>
        <translation>启动记录的条件</translation>
    </message>
    <message>
        <source>s</source>
        <translation>s</translation>
    </message>
</context>
<context>
    <name>camwright::TypeDelegate</name>
    <message>
        <source>Type</source>
        <translation>类型</translation>
    </message>
</context>
<context>
    <name>camwright::VariablesEditor</name>
    <message numerus="yes">
        <source>%n variable(s)</source>
        <translation>
            <numerusform>%n 个变量</numerusform>
        </translation>
    </message>
    <message>
        <source>Filter</source>
        <translation>筛选</translation>
    </message>
    <message>
        <source>Global variables; the last row adds one</source>
        <translation>全局变量；最后一行用于添加</translation>
    </message>
    <message>
        <source>Show only rows that contain this text in any column</source>
        <translation>只显示任意列中含有此文本的行</translation>
    </message>
    <message>
        <source>Variables</source>
        <translation>变量</translation>
    </message>
</context>
<context>
    <name>camwright::VariablesModel</name>
    <message numerus="yes">
        <source>Add %n variable(s)</source>
        <translation>
            <numerusform>添加 %n 个变量</numerusform>
        </translation>
    </message>
    <message>
        <source>Add variable</source>
        <translation>添加变量</translation>
    </message>
    <message>
        <source>Address</source>
        <translation>地址</translation>
    </message>
    <message>
        <source>Change variable %1</source>
        <translation>修改变量 %1</translation>
    </message>
    <message>
        <source>Comment</source>
        <translation>注释</translation>
    </message>
    <message numerus="yes">
        <source>Delete %n variable(s)</source>
        <translation>
            <numerusform>删除 %n 个变量</numerusform>
        </translation>
    </message>
    <message>
        <source>Initial value</source>
        <translation>初始值</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>名称</translation>
    </message>
    <message>
        <source>Retain</source>
        <translation>断电保持</translation>
    </message>
    <message>
        <source>Type</source>
        <translation>类型</translation>
    </message>
    <message>
        <source>new variable</source>
        <translation>新变量</translation>
    </message>
</context>
<context>
    <name>camwright::WatchModel</name>
    <message numerus="yes">
        <source>Add %n watched value(s)</source>
        <translation>
            <numerusform>添加 %n 个监视值</numerusform>
        </translation>
    </message>
    <message>
        <source>Change a watched value</source>
        <translation>更改监视值</translation>
    </message>
    <message>
        <source>Change the display format</source>
        <translation>更改显示格式</translation>
    </message>
    <message>
        <source>Comment</source>
        <translation>注释</translation>
    </message>
    <message>
        <source>Last 10 s</source>
        <translation>最近 10 s</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>名称</translation>
    </message>
    <message>
        <source>New value</source>
        <translation>新值</translation>
    </message>
    <message numerus="yes">
        <source>Remove %n watched value(s)</source>
        <translation>
            <numerusform>移除 %n 个监视值</numerusform>
        </translation>
    </message>
    <message>
        <source>Type</source>
        <translation>类型</translation>
    </message>
    <message>
        <source>Value</source>
        <translation>值</translation>
    </message>
    <message>
        <source>name or address</source>
        <translation>名称或地址</translation>
    </message>
    <message>
        <source>not known</source>
        <translation>未知</translation>
    </message>
</context>
<context>
    <name>camwright::WatchPanel</name>
    <message>
        <source>A watch list keeps the values you look at together.</source>
        <translation>监视表把您关注的值放在一起。</translation>
    </message>
    <message>
        <source>Make a Watch List</source>
        <translation>建立监视表</translation>
    </message>
    <message>
        <source>Make another watch list</source>
        <translation>再建立一个监视表</translation>
    </message>
    <message>
        <source>New watch list</source>
        <translation>新建监视表</translation>
    </message>
    <message>
        <source>The list shown here</source>
        <translation>此处显示的监视表</translation>
    </message>
    <message>
        <source>Watch</source>
        <translation>监视</translation>
    </message>
    <message>
        <source>Watch List</source>
        <translation>监视表</translation>
    </message>
    <message>
        <source>Watch list</source>
        <translation>监视表</translation>
    </message>
</context>
<context>
    <name>camwright::WatchView</name>
    <message>
        <source>Binary (2#)</source>
        <translation>二进制 (2#)</translation>
    </message>
    <message>
        <source>Decimal</source>
        <translation>十进制</translation>
    </message>
    <message>
        <source>Force</source>
        <translation>强制</translation>
    </message>
    <message>
        <source>Hexadecimal (16#)</source>
        <translation>十六进制 (16#)</translation>
    </message>
    <message>
        <source>Octal (8#)</source>
        <translation>八进制 (8#)</translation>
    </message>
    <message>
        <source>Release</source>
        <translation>释放</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>移除</translation>
    </message>
    <message>
        <source>Show As</source>
        <translation>显示为</translation>
    </message>
    <message>
        <source>The controller runs another program than this project; its values are not shown. Download the project to see them.</source>
        <translation>控制器运行的程序与本工程不同；不显示其值。下载工程后即可查看。</translation>
    </message>
    <message>
        <source>Values of the controller; type a new value to write it, F7 forces it</source>
        <translation>控制器的值；输入新值即写入，F7 强制</translation>
    </message>
    <message>
        <source>Watched values</source>
        <translation>监视的值</translation>
    </message>
</context>
<context>
    <name>camwright::Workbench</name>
    <message numerus="yes">
        <source>%n errors</source>
        <translation>
            <numerusform>%n 个错误</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n warnings</source>
        <translation>
            <numerusform>%n 个警告</numerusform>
        </translation>
    </message>
    <message>
        <source>Built &quot;%1&quot;: %2 bytes.</source>
        <translation>已编译“%1”：%2 字节。</translation>
    </message>
    <message>
        <source>Built without errors.</source>
        <translation>编译无错误。</translation>
    </message>
    <message>
        <source>Checked: %1, %2.</source>
        <translation>已检查：%1，%2。</translation>
    </message>
    <message>
        <source>Checked: no problems.</source>
        <translation>已检查：没有问题。</translation>
    </message>
    <message>
        <source>Not built: the project has errors. The Problems list names them.</source>
        <translation>未编译：工程有错误，见问题列表。</translation>
    </message>
</context>
</TS>
