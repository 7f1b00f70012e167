-- The assets manager panel: opens the parts, joins them, and hands the frames on.

local DefinitionPane = require("lodsmith.gui.DefinitionPane")
local FileDialog = require("lodsmith.gui.FileDialog")
local GraphPane = require("lodsmith.gui.GraphPane")
local Guard = require("lodsmith.gui.Guard")
local Keyboard = require("lodsmith.gui.Keyboard")
local Kit = require("lodsmith.gui.Kit")
local LevelsPane = require("lodsmith.gui.LevelsPane")
local LodState = require("lodsmith.gui.LodState")
local MeshPane = require("lodsmith.gui.MeshPane")
local PreviewPane = require("lodsmith.gui.PreviewPane")
local Prompt = require("lodsmith.gui.Prompt")
local Question = require("lodsmith.gui.Question")

local Panel = {}
Panel.__index = Panel

local FONT = "DejaVuSans-10-NoScale"

-- The panel's sizes are made for a font that does not grow with the window. A host without its file gives its default
-- font.
local function panelFont()
    local fonts = CEGUI.FontManager:getSingleton()
    if not fonts:isDefined(FONT) then
        pcall(fonts.createFromFile, fonts, FONT .. ".font")
    end
    return fonts:isDefined(FONT) and FONT or nil
end

-- Opens the panel and returns it; lodsmith.panel is the open one. An error when there is one, or a layout is missing.
-- options: {parent = window or nil for the root window; fill = true: it fills the parent, else it is a window in it;
--           preview = lodsmith.preview or nil;
--           host = {canOpen = true: files may be opened; recentFiles = function() -> paths; opened = function(path);
--           check = function(path) -> true | nil, message, before a file is loaded} or nil}
-- opened() hears of the mesh that was opened once it is the one that is edited.
local function open(options)
    if lodsmith.panel then
        error("the panel is open", 0)
    end
    local panel = setmetatable({api = lodsmith, preview = options.preview, host = options.host or {}}, Panel)
    panel.guard = Guard.new(function(message)
        panel:tellError(message)
    end)
    panel.kit = Kit.new(panel.guard, panelFont())
    panel.state = LodState.new(lodsmith, panel.host.check)
    panel.panes, panel.dialogs = {}, {}
    panel.errorsWentTo = lodsmith.onError
    local built, message = pcall(panel.build, panel, options)
    if not built then
        panel:close()
        error(message, 0)
    end
    lodsmith.onError = function(text)
        panel:tellError(text)
    end
    lodsmith.panel = panel
    return panel
end

function Panel:build(options)
    local kit = self.kit
    local parent = options.parent or CEGUI.System:getSingleton():getDefaultGUIContext():getRootWindow()
    self.root, self.parts = kit:load("AssetsManager")
    kit:skinOf(self.parts.MessageBar)
    self.window = self.root
    if not options.fill then
        self.window = self:makeFrame(parent)
        self.window:addChild(self.root)
    end
    parent:addChild(self.window)
    self.keyboard = Keyboard.new(kit, self.root)
    -- In this order Tab goes through them.
    self.meshPane = MeshPane.new(self, self.parts.LeftDock)
    self.previewPane = PreviewPane.new(self, self.parts.PreviewDock)
    self.levelsPane = LevelsPane.new(self, self.parts.LevelsDock)
    self.definitionPane = DefinitionPane.new(self, self.parts.RightDock)
    self.graphPane = GraphPane.new(self, self.definitionPane.parts)
    self.panes = {self.meshPane, self.previewPane, self.levelsPane, self.definitionPane, self.graphPane}
    self:connectMessages()
    self:makeDialogs(parent)
    self.meshPane.list:activate()
end

-- As large as the layout says: less leaves no room for all. A parent that is smaller has to do.
function Panel:makeFrame(parent)
    local window = CEGUI.toFrameWindow(self.kit:load("AssetsManagerFrame"))
    local room, size = parent:getPixelSize(), window:getSize()
    local least = CEGUI.USize(CEGUI.UDim(0, math.min(size.width.offset, room.width)),
        CEGUI.UDim(0, math.min(size.height.offset, room.height)))
    window:setMinSize(least)
    window:setSize(least)
    self.kit:on(window, "CloseClicked", function()
        self:askToLeave(function()
            self:close()
        end)
    end)
    return window
end

function Panel:makeDialogs(parent)
    local kit, state, host = self.kit, self.state, self.host
    self.question = Question.new(kit, parent, self.root, function(answer)
        state:told(state:answer(answer))
    end)
    self.valuePrompt = Prompt.new(kit, parent, self.root)
    self.fileDialog = FileDialog.new(kit, parent, self.root, {
        list = self.api.listDirectory,
        recent = host.recentFiles or function()
            return {}
        end,
        open = function(path)
            return self:openMesh(path)
        end,
    })
    self.dialogs = {self.question.dialog, self.valuePrompt.dialog, self.fileDialog.dialog}
    state:on("question", function(question)
        self.question:ask(question)
    end)
    if host.canOpen then
        self.keyboard:shortcut(CEGUI.Key.O, true, function()
            self:askForFile()
        end, true)
    end
end

-- A combobox of words: chosen(index) by mouse, Up and Down step without opening it.
function Panel:connectCombobox(combobox, chosen)
    local kit, Key = self.kit, CEGUI.Key
    kit:on(combobox, "ListSelectionAccepted", function()
        local index = kit.chosen(combobox)
        if index then
            chosen(index)
        end
    end)
    local function step(by)
        return function()
            local index = (kit.chosen(combobox) or 0) + by
            if index >= 1 and index <= combobox:getItemCount() then
                kit:chooseInCombobox(combobox, index)
                chosen(index)
            end
        end
    end
    self.keyboard:add(combobox, {[Key.ArrowUp] = step(-1), [Key.ArrowDown] = step(1)})
end

-- Messages ------------------------------------------------------------------------------------------------------------

function Panel:connectMessages()
    local state, kit, parts = self.state, self.kit, self.parts
    local function show(kind, text)
        kit:setMessage(parts.Message, kind, (text:gsub("\n", "; ")))
        -- Tooltips take markup, and names of files may look like it.
        parts.Message:setTooltipText((text:gsub("[\\%[]", "\\%0")))
        if kind == "error" and not self.isTelling then
            CEGUI.Logger:getSingleton():logEvent("Lodsmith: " .. text, CEGUI.Warnings)
        end
    end
    state:on("message", show)
    -- What went wrong while the parts were made.
    if state.message then
        show(state.message.kind, state.message.text)
    end
    local function cancel()
        state:told(state:cancelGeneration())
    end
    kit:on(parts.Cancel, "Clicked", cancel)
    self.keyboard:addButton(parts.Cancel, cancel)
    self.progress = CEGUI.toProgressBar(parts.Progress)
end

function Panel:refreshProgress()
    local isGenerating = self.state:isGenerating()
    self.kit:setEnabled(self.parts.Cancel, isGenerating)
    self.progress:setProgress(isGenerating and self.state.progress or 0)
end

-- An error in a handler, with its place.
function Panel:tellError(message)
    CEGUI.Logger:getSingleton():logEvent("Lodsmith: " .. message, CEGUI.Errors)
    self.isTelling = true
    self.state:say("error", (message:match("^[^\n]*")))
    self.isTelling = false
end

-- What hosts and scripts call -----------------------------------------------------------------------------------------

-- Once a frame; seconds since the last.
function Panel:update(seconds)
    self.guard:call("state", self.state.update, self.state, seconds)
    for _, pane in ipairs(self.panes) do
        self.guard:call("pane", pane.update, pane, seconds)
    end
    self.guard:call("progress", self.refreshProgress, self)
    self.keyboard:update()
    for _, dialog in ipairs(self.dialogs) do
        dialog.keyboard:update()
    end
end

function Panel:chooseMesh(mesh)
    return self.state:told(self.state:chooseMesh(mesh))
end

function Panel:openMesh(path)
    return self.state:told(self.state:openMesh(path, function(mesh)
        self:tellOpened(mesh)
    end))
end

-- Only meshes that come from files can be opened again.
function Panel:tellOpened(mesh)
    local path = mesh:path()
    if path and self.host.opened then
        self.host.opened(path)
    end
end

-- path: a mesh, or a directory of meshes
function Panel:open(path)
    if self.api.listDirectory(path) then
        return self.state:told(self.state:openDirectory(path, function(mesh)
            self:tellOpened(mesh)
        end))
    end
    return self:openMesh(path)
end

function Panel:askForFile()
    local path = self.state.mesh and self.state.mesh:path()
    self.fileDialog:ask(path and path:match("^(.*)/[^/]*$"))
end

function Panel:prompt(options)
    self.valuePrompt:ask(options)
end

-- Calls `leave` when there is nothing to lose, or when the artist has said what becomes of it.
-- What is typed counts, and other dialogs are dismissed.
function Panel:askToLeave(leave)
    for _, dialog in ipairs(self.dialogs) do
        dialog:close()
    end
    local committed, message = self.definitionPane:commit()
    if not committed then
        return self.state:told(nil, message)
    end
    return self.state:told(self.state:afterSaving("The panel is to be closed.", function()
        leave()
        return true
    end))
end

-- Unsaved changes are lost: askToLeave() asks.
function Panel:close()
    if not self.window then
        return
    end
    self.state:close()
    for _, dialog in ipairs(self.dialogs) do
        dialog:close()
        CEGUI.WindowManager:getSingleton():destroyWindow(dialog.window)
    end
    CEGUI.WindowManager:getSingleton():destroyWindow(self.window)
    self.window, self.panes, self.dialogs = nil, {}, {}
    self.update = function() end
    lodsmith.onError = self.errorsWentTo
    if lodsmith.panel == self then
        lodsmith.panel = nil
    end
end

return {open = open}
