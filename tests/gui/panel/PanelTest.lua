local Expect = require("Expect")
local Hand = require("Hand")

local function open(options)
    return require("PanelSession").open(options)
end

local Tests = {}

function Tests.tabGoesThroughEveryControlAndRound()
    local session = open():withLevels(20, 50)
    local keyboard = session.panel.keyboard
    session.state:copyLevel()
    session.state:setAmount("0.9")
    session.state:undo()
    session.state:setAmount("0.8")
    session:frame()
    local first = keyboard:focused().window:getName()
    local seen, order = {}, {}
    repeat
        local name = keyboard:focused().window:getName()
        Expect.no(seen[name] and name)
        seen[name] = true
        table.insert(order, name)
        Hand.key(CEGUI.Key.Tab)
    until keyboard:focused().window:getName() == first or #order > 60
    for _, name in ipairs({"Open", "MeshFilter", "MeshList", "ViewMode", "PreviewImage", "LevelList", "Add", "Delete",
        "Copy", "Paste", "Save", "Undo", "Automatic", "Type", "Strategy", "Value", "Method", "Amount", "AmountSlider",
        "HandMadeFilter", "HandMadeList", "Cancel"}) do
        Expect.yes(seen[name], name)
    end
    Expect.no(seen.Redo)
    Expect.no(seen.MakeManual)
    for _ = 1, #order do
        Hand.key(CEGUI.Key.Tab, "shift")
    end
    Expect.equal(keyboard:focused().window:getName(), first)
end

function Tests.focusIsSeenAndGoesWithTheMouse()
    local session = open():withLevels(20)
    Hand.key(CEGUI.Key.Tab)
    session:frame()
    Expect.yes(session.panel.keyboard.mark:isVisible())
    Hand.click(session.parts.LevelList)
    session:frame()
    Expect.no(session.panel.keyboard.mark:isVisible())
end

function Tests.shortcuts()
    local session = open():withLevels(20, 50)
    session.panel.keyboard:focus(session.parts.LevelList)
    Hand.key(CEGUI.Key.ArrowDown)
    session:frame()
    Expect.equal(session.state.selected, 2)
    Hand.key(CEGUI.Key.Delete)
    session:frame()
    Expect.equal(session.state:levelCount(), 1)
    Hand.key(CEGUI.Key.Z, "control")
    session:frame()
    Expect.equal(session.state:levelCount(), 2)
    Hand.key(CEGUI.Key.Y, "control")
    Expect.equal(session.state:levelCount(), 1)
    Hand.key(CEGUI.Key.Z, "control")
    Hand.key(CEGUI.Key.Z, "control", "shift")
    Expect.equal(session.state:levelCount(), 1)
    Hand.key(CEGUI.Key.S, "control")
    Expect.no(session.state:isDirty())
    Hand.key(CEGUI.Key.Insert)
    Expect.yes(session.parts.Prompt:isVisible())
    Hand.key(CEGUI.Key.Escape)
    Expect.no(session.parts.Prompt:isVisible())
end

function Tests.keysWorkOnAfterADialogAndAfterAControlIsDisabled()
    local session = open():withLevels(20)
    session.panel.keyboard:focus(session.parts.Delete)
    Hand.key(CEGUI.Key.Return)
    session:frame()
    Expect.yes(session.parts.Delete:isDisabled())
    Hand.key(CEGUI.Key.Z, "control")
    session:frame()
    Expect.equal(session.state:levelCount(), 1)
    Hand.key(CEGUI.Key.Insert)
    Hand.key(CEGUI.Key.Return)
    session:frame()
    Expect.equal(session.state:levelCount(), 2)
    Hand.key(CEGUI.Key.Z, "control")
    Expect.equal(session.state:levelCount(), 1)
    Hand.key(CEGUI.Key.Tab)
    Expect.yes(session.panel.keyboard:focused())
end

function Tests.textKeepsItsKeys()
    local session = open():withLevels(20, 50)
    Hand.replace(session.parts.Amount, "0.75")
    Hand.key(CEGUI.Key.Home)
    Hand.key(CEGUI.Key.Delete)
    Expect.equal(session.parts.Amount:getText(), ".75")
    Expect.equal(session.state:levelCount(), 2)
    Hand.key(CEGUI.Key.Return)
    Expect.yes(session.state:isDirty())
    Hand.key(CEGUI.Key.Z, "control")
    Expect.no(session.state:isDirty())
end

function Tests.keysWorkTheControls()
    local session = open():withLevels(20)
    local keyboard = session.panel.keyboard
    keyboard:focus(session.parts.AmountSlider)
    Hand.key(CEGUI.Key.ArrowRight)
    session:frame()
    Expect.near(session.state:level(1):amount(), 0.505, 1e-6)
    Hand.key(CEGUI.Key.End)
    session:frame()
    Expect.equal(session.state:level(1):amount(), 1)
    keyboard:focus(session.parts.Strategy)
    Hand.key(CEGUI.Key.ArrowDown)
    session:frame()
    Expect.equal(session.state.definition:strategy(), session.api.Strategy.DistanceBox)
    keyboard:focus(session.parts.Automatic)
    Hand.key(CEGUI.Key.Space)
    session:frame()
    Expect.yes(session.state.definition:isAutomatic())
    keyboard:focus(session.parts.MakeManual)
    Hand.key(CEGUI.Key.Return)
    session:frame()
    Expect.equal(session.state.definition:levelCount(), 3)
    keyboard:focus(session.parts.MeshList)
    Hand.key(CEGUI.Key.End)
    Expect.yes(session.parts.Question:isVisible())
    Hand.key(CEGUI.Key.Tab)
    Hand.key(CEGUI.Key.Tab)
    Hand.key(CEGUI.Key.Return)
    session:frame()
    Expect.no(session.parts.Question:isVisible())
    Expect.equal(session.state.mesh:name(), "tree.mesh")
end

function Tests.progressAndCancel()
    local session = open():withLevels(20)
    Expect.yes(session.parts.Cancel:isDisabled())
    session.state:setAmount("0.9")
    session.api.queue:progress(session.state.mesh, 0.25)
    session:frame()
    Expect.near(CEGUI.toProgressBar(session.parts.Progress):getProgress(), 0.25, 1e-6)
    Hand.click(session.parts.Cancel)
    session:frame()
    Expect.yes(session.parts.Cancel:isDisabled())
    Expect.equal(CEGUI.toProgressBar(session.parts.Progress):getProgress(), 0)
    Expect.yes(session:message():find("cancelled", 1, true))
end

function Tests.errorInAHandlerIsShownAndNothingElseHappens()
    local session = open():withLevels(20)
    session.state.deleteLevel = function()
        error("boom")
    end
    Hand.click(session.parts.Delete)
    session:frame()
    Expect.yes(session:message():find("Delete Clicked", 1, true), session:message())
    Expect.yes(session:message():find("boom", 1, true))
    session.state.rows = function()
        error("bang")
    end
    session.panel.levelsPane.isStale = true
    session:frame()
    Expect.yes(session:message():find("bang", 1, true))
    session.state.deleteLevel, session.state.rows = nil, nil
    Hand.click(session.parts.Delete)
    session:frame()
    Expect.equal(session.state:levelCount(), 0)
end

function Tests.errorInACallbackIsShown()
    local session = open()
    session.api.onError("callback: broken")
    Expect.equal(session:message(), "callback: broken")
end

function Tests.panelIsInAWindowOrFills()
    local session = open({fill = false})
    Expect.equal(session.panel.window:getName(), "AssetsManagerFrame")
    Expect.yes(CEGUI.toFrameWindow(session.panel.window):isDragMovingEnabled())
    Expect.yes(CEGUI.toFrameWindow(session.panel.window):isSizingEnabled())
    session.panel:close()
    session = open({fill = true})
    Expect.equal(session.panel.window:getPixelSize().width, 1024)
    session.panel:close()
end

function Tests.thereIsOnePanelAtMost()
    local session = open()
    Expect.equal(session.api.panel, session.panel)
    local opened, message = pcall(require("lodsmith.gui.AssetsManager").open, {fill = true})
    Expect.refused("the panel is open", opened, message)
end

function Tests.closedPanelIsGone()
    local session = open():withLevels(20)
    local panel = session.panel
    panel:close()
    panel:close()
    panel:update(0.1)
    Expect.equal(session.api.panel, nil)
    session.api.queue.waiting[session.api.known[1]] = session.api.newDefinition()
    session.api.queue:finish(session.api.known[1])
    CEGUI.System:getSingleton():injectTimePulse(0.1)
    local root = CEGUI.System:getSingleton():getDefaultGUIContext():getRootWindow()
    for index = 0, root:getChildCount() - 1 do
        Expect.yes(root:getChildAtIdx(index):getType():find("Tooltip", 1, true))
    end
end

function Tests.closingTheWindowAsks()
    local session = open({fill = false}):withLevels(20)
    session.state:setAmount("0.9")
    session:frame()
    local function closeWindow()
        local window = session.panel.window
        window:fireEvent("CloseClicked", CEGUI.WindowEventArgs(window))
    end
    closeWindow()
    Expect.yes(session.parts.Question:isVisible())
    Hand.click(session.parts.Third)
    session:frame()
    Expect.yes(session.panel.window)
    closeWindow()
    Hand.click(session.parts.Second)
    Expect.equal(session.api.panel, nil)
end

function Tests.everyControlHasATooltip()
    local session = open()
    local function check(keyboard)
        for _, control in ipairs(keyboard.controls) do
            local name = control.window:getName()
            local isPlain = name == "PreviewImage" or name == "Second"
            Expect.yes(isPlain or control.window:getTooltipText() ~= "", name)
        end
    end
    check(session.panel.keyboard)
    for _, dialog in ipairs(session.panel.dialogs) do
        check(dialog.keyboard)
    end
end

function Tests.namesAreNoMarkup()
    local session = open()
    session.state:say("info", "[colour='FF000000']x \\ [")
    Expect.equal(session:message(), "[colour='FF000000']x \\ [")
    table.insert(session.api.known, require("FakeLodsmith").mesh("[a].mesh"))
    session:frame(1.1)
    Expect.equal(CEGUI.toListbox(session.parts.MeshList):getItemCount(), 4)
end

-- Another font is the default, and the panel's is not there.
local function forgetFont()
    local fonts = CEGUI.FontManager:getSingleton()
    fonts:createFromFile("DejaVuSans-12-NoScale.font")
    CEGUI.System:getSingleton():getDefaultGUIContext():setDefaultFont("DejaVuSans-12-NoScale")
    fonts:destroy("DejaVuSans-10-NoScale")
    return fonts
end

function Tests.panelLoadsItsFont()
    local fonts = forgetFont()
    local session = open()
    Expect.yes(fonts:isDefined("DejaVuSans-10-NoScale"))
    Expect.equal(session.parts.Save:getProperty("Font"), "DejaVuSans-10-NoScale")
end

function Tests.panelOpensWithoutItsFont()
    forgetFont()
    local stub = {isDefined = function() return false end, createFromFile = function() error("no such file") end}
    local manager = CEGUI.FontManager
    CEGUI.FontManager = {getSingleton = function() return stub end}
    local session = open()
    CEGUI.FontManager = manager
    Expect.equal(session.parts.Save:getProperty("Font"), "")
end

return Tests
