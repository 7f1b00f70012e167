-- The list of levels, and add, delete, copy and paste.

local Numbers = require("lodsmith.gui.Numbers")
local Words = require("lodsmith.gui.Words")

local LevelsPane = {}
LevelsPane.__index = LevelsPane

local COLUMNS = {
    {"From", 0.145}, {"Method", 0.17}, {"Amount", 0.15}, {"Triangles", 0.165}, {"Memory", 0.155}, {"Deviation", 0.19},
}

function LevelsPane.new(panel, dock)
    local self = setmetatable({panel = panel, kit = panel.kit, state = panel.state, isStale = true}, LevelsPane)
    self.words = Words.of(panel.api)
    local window, parts = self.kit:load("LevelsPane")
    dock:addChild(window)
    self.parts, self.list = parts, CEGUI.toMultiColumnList(parts.LevelList)
    for index, column in ipairs(COLUMNS) do
        self.list:addColumn(column[1], index, CEGUI.UDim(column[2], 0))
        self.kit:dress(self.list:getHeaderSegmentForColumn(index - 1))
    end
    self:connect()
    return self
end

function LevelsPane:connect()
    local kit, parts, state = self.kit, self.parts, self.state
    local keyboard = self.panel.keyboard
    kit:on(self.list, "SelectionChanged", function()
        local index = kit.chosen(self.list)
        if index then
            state:select(index)
        end
        self.isStale = true
    end)
    keyboard:addList(self.list, function(step)
        state:select((state.selected or 0) + step)
    end)
    local actions = {
        {"Add", function() self:add() end},
        {"Delete", function() state:told(state:deleteLevel()) end},
        {"Copy", function() state:told(state:copyLevel()) end},
        {"Paste", function() self:paste() end},
    }
    for _, action in ipairs(actions) do
        kit:on(parts[action[1]], "Clicked", action[2])
        keyboard:addButton(parts[action[1]], action[2])
    end
    local Key = CEGUI.Key
    keyboard:shortcut(Key.Insert, false, actions[1][2])
    keyboard:shortcut(Key.Delete, false, actions[2][2])
    keyboard:shortcut(Key.C, true, actions[3][2])
    keyboard:shortcut(Key.V, true, actions[4][2])
    for _, event in ipairs({"mesh", "definition", "figures"}) do
        state:on(event, function()
            self.isStale = true
        end)
    end
end

-- Asks for the value of a new level; says beside the box what is wrong with it.
function LevelsPane:ask(title, accept)
    local state = self.state
    local strategy = Words.find(self.words.strategies, state.definition:strategy())
    self.panel:prompt({
        title = title,
        text = ("%s (%s):"):format(strategy.label, strategy[2]:lower()),
        value = Numbers.format(state:suggestValue()),
        check = function(text)
            return state:checkNewValue(text)
        end,
        accept = accept,
    })
end

function LevelsPane:add()
    local state = self.state
    if state:told(state:canEdit()) then
        self:ask("Add a level", function(text)
            return state:addLevel(text)
        end)
    end
end

function LevelsPane:paste()
    local state = self.state
    if state:told(state:canPaste()) then
        self:ask("Paste a level", function(text)
            return state:pasteLevel(text)
        end)
    end
end

function LevelsPane:update()
    if self.isStale then
        self.isStale = false
        self:refresh()
    end
end

local function deviationText(row, radius)
    if row.measured then
        return Numbers.length(row.measured.maximum, radius)
    end
    return row.bound and "<= " .. Numbers.length(row.bound, radius) or "-"
end

local function cells(row, words, radius)
    return {
        Numbers.cell(row.value),
        row.isHandMade and "hand-made" or Words.find(words.methods, row.method).short,
        row.isHandMade and row.meshName or Numbers.cell(row.amount),
        row.triangles and tostring(row.triangles) or row.isSkipped and "as before" or "-",
        row.bytes and Numbers.bytes(row.bytes) or "-",
        deviationText(row, radius),
    }
end

function LevelsPane:refresh()
    local state, list = self.state, self.list
    local rows = state:rows()
    self.kit:silently(function()
        if list:getRowCount() ~= #rows then
            self:setRowCount(#rows)
        end
        for index, row in ipairs(rows) do
            for column, text in ipairs(cells(row, self.words, state.info.radius)) do
                local item = list:getItemAtGridReference(CEGUI.MCLGridRef(index - 1, column - 1))
                if item:getText() ~= text then
                    item:setText(text)
                end
            end
        end
        self:showSelection()
        list:handleUpdatedItemData()
    end)
    local isEditable, hasLevel = state:isEditable(), state.selected ~= nil
    self.kit:setEnabled(self.parts.Add, isEditable)
    self.kit:setEnabled(self.parts.Delete, isEditable and hasLevel)
    self.kit:setEnabled(self.parts.Copy, hasLevel)
    self.kit:setEnabled(self.parts.Paste, isEditable and state.clipboard ~= nil)
    self.kit:setEnabled(self.list, state.mesh ~= nil)
end

function LevelsPane:setRowCount(count)
    local list = self.list
    list:resetList()
    for index = 1, count do
        list:addRow()
        for column = 1, #COLUMNS do
            list:setItem(self.kit:newItem(list, "", index), column, index - 1)
        end
    end
end

function LevelsPane:showSelection()
    local list, selected = self.list, self.state.selected
    if self.kit.chosen(list) == selected then
        return
    end
    list:clearAllSelections()
    if selected and selected <= list:getRowCount() then
        list:setItemSelectState(CEGUI.MCLGridRef(selected - 1, 0), true)
        list:ensureRowIsVisible(selected - 1)
    end
end

return LevelsPane
