-- Chooses a mesh file: directories to walk through, and the files that were opened last.

local Dialog = require("lodsmith.gui.Dialog")

local FileDialog = {}
FileDialog.__index = FileDialog

-- options: {list = function(path) -> listing | nil, message; recent = function() -> paths;
--           open = function(path) -> true | nil, message}
function FileDialog.new(kit, parent, behind, options)
    local self = setmetatable({kit = kit, options = options, entries = {}, recentFiles = {}}, FileDialog)
    local function cancel()
        self.dialog:close()
    end
    self.dialog = Dialog.new(kit, parent, behind, "FileDialog", cancel)
    local parts = self.dialog.parts
    self.files, self.recent = CEGUI.toListbox(parts.Files), CEGUI.toListbox(parts.Recent)
    local function go()
        self:go(parts.Path:getText())
    end
    kit:on(parts.Path, "TextAccepted", go)
    self.dialog.keyboard:addText(parts.Path)
    self.dialog:addButtons({{"Up", function() self:up() end}})
    self:connectList(self.files, function(index)
        self:enter(self.entries[index])
    end)
    self:connectList(self.recent, function(index)
        self:open(self.recentFiles[index])
    end)
    self.dialog.keyboard:shortcut(CEGUI.Key.Backspace, false, function()
        self:up()
    end)
    self.dialog:addButtons({{"OpenFile", function() self:openChosen() end}, {"CloseFiles", cancel}})
    return self
end

function FileDialog:connectList(list, enter)
    local kit = self.kit
    local function enterChosen()
        local index = kit.chosen(list)
        if index then
            enter(index)
        end
    end
    list:setWantsMultiClickEvents(true)
    kit:on(list, "MouseDoubleClick", enterChosen)
    kit:on(list, "SelectionChanged", function()
        self:takeFrom(list)
    end)
    self.dialog.keyboard:addList(list, function(step)
        local count = list:getItemCount()
        if count > 0 then
            kit:choose(list, math.max(1, math.min(count, (kit.chosen(list) or 0) + step)))
            self:takeFrom(list)
        end
    end, enterChosen)
end

-- One of the lists has what the button opens.
function FileDialog:takeFrom(list)
    self.kit:choose(list == self.files and self.recent or self.files, nil)
end

function FileDialog:ask(path)
    local kit, names = self.kit, {}
    self.recentFiles = self.options.recent()
    for index, file in ipairs(self.recentFiles) do
        names[index] = file:match("[^/]+$") or file
    end
    kit:setItems(self.recent, names)
    self:go(path or self.path or ".")
    self.dialog:open(self.files)
end

function FileDialog:say(message)
    self.kit:setMessage(self.dialog.parts.FileError, "error", message or "")
end

-- A directory is shown, a mesh opened.
function FileDialog:go(path)
    if path:lower():match("%.mesh$") then
        self:open(path)
        return
    end
    local listing, message = self.options.list(path)
    if not listing then
        self:say(message)
        return
    end
    self:say(nil)
    self.path, self.parent, self.entries = listing.path, listing.parent, {}
    local texts = {}
    local function add(name, text)
        table.insert(self.entries, (listing.path:gsub("/$", "")) .. "/" .. name)
        table.insert(texts, text)
    end
    for _, name in ipairs(listing.directories) do
        add(name, name .. "/")
    end
    for _, name in ipairs(listing.meshes) do
        add(name, name)
    end
    self.kit:setText(self.dialog.parts.Path, listing.path)
    self.kit:setItems(self.files, texts)
    self.kit:choose(self.files, #texts > 0 and 1 or nil)
    self:takeFrom(self.files)
end

function FileDialog:up()
    if self.parent then
        self:go(self.parent)
    end
end

function FileDialog:enter(path)
    if path then
        self:go(path)
    end
end

function FileDialog:openChosen()
    local recent = self.kit.chosen(self.recent)
    if recent then
        self:open(self.recentFiles[recent])
    else
        self:enter(self.entries[self.kit.chosen(self.files) or 0])
    end
end

function FileDialog:open(path)
    local opened, message = self.options.open(path)
    if opened then
        self.dialog:close()
    else
        self:say(message)
    end
end

return FileDialog
