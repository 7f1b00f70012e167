-- The panel's way to CEGUI: layouts by name, guarded handlers, and widgets that are set without their events being
-- taken for the artist's.

local Skin = require("lodsmith.gui.Skin")

local Kit = {}
Kit.__index = Kit

local AUTO_PREFIX = "__auto_"
local MOST_CHARACTERS = 1024 -- of a path; CEGUI takes seconds over what is far longer
local TITLE_BAR = "__auto_titlebar__"

function Kit.new(guard, font)
    return setmetatable({guard = guard, font = font, isSilent = false, items = {}}, Kit)
end

-- The window of a layout, and a table of it and all windows in it by name.
function Kit:load(layout)
    local window = CEGUI.WindowManager:getSingleton():loadLayoutFromFile(layout .. ".layout")
    local parts = {}
    self:collect(window, parts)
    return window, parts
end

function Kit:collect(window, parts)
    parts[window:getName()] = window
    self:dress(window)
    for index = 0, window:getChildCount() - 1 do
        local child = window:getChildAtIdx(index)
        if child:getName():sub(1, #AUTO_PREFIX) ~= AUTO_PREFIX then
            self:collect(child, parts)
        elseif child:getName() == TITLE_BAR then
            self:dress(child)
        end
    end
end

-- Names of files are no markup, two quick clicks are two clicks, and the panel's sizes are made for its font.
function Kit:dress(window)
    window:setWantsMultiClickEvents(false)
    window:setTextParsingEnabled(false)
    if window:getType():find("Editbox") then
        CEGUI.toEditbox(window):setMaxTextLength(MOST_CHARACTERS)
    end
    if self.font then
        window:setFont(self.font)
    end
end

function Kit:skinOf(window)
    if not self.skin then
        self.skin = Skin.of(window)
    end
    return self.skin
end

-- handler: function(arguments); false lets CEGUI go on with the event. Silent while the panel itself sets widgets.
function Kit:on(window, event, handler)
    local guarded = self.guard:wrap(window:getName() .. " " .. event, handler)
    window:subscribeEvent(event, function(arguments)
        if self.isSilent then
            return false
        end
        return guarded(arguments) ~= false
    end)
end

-- Sets widgets; their events are not the artist's.
function Kit:silently(action)
    local before = self.isSilent
    self.isSilent = true
    local passed, message = pcall(action)
    self.isSilent = before
    if not passed then
        error(message, 0)
    end
end

function Kit:setText(window, text)
    if window:getText() ~= text then
        self:silently(function()
            window:setText(text)
        end)
    end
end

function Kit:setColour(window, property, colour)
    if window:isPropertyPresent(property) then
        window:setProperty(property, ("tl:%s tr:%s bl:%s br:%s"):format(colour, colour, colour, colour))
    end
end

-- A text in the messages' colours: kind "error" or "info".
function Kit:setMessage(window, kind, text)
    local skin = self:skinOf(window)
    self:setColour(window, "TextColours", kind == "error" and skin.error or skin.text)
    self:setText(window, text)
end

function Kit:setEnabled(window, isEnabled)
    if window:isDisabled() == isEnabled then
        window:setEnabled(isEnabled)
    end
end

function Kit:setChecked(checkbox, isChecked)
    local toggle = CEGUI.toToggleButton(checkbox)
    if toggle:isSelected() ~= isChecked then
        self:silently(function()
            toggle:setSelected(isChecked)
        end)
    end
end

-- Lists ---------------------------------------------------------------------------------------------------------------

function Kit:newItem(owner, text, id)
    local skin = self:skinOf(owner)
    local item = CEGUI.createListboxTextItem(text, id, nil, false, true)
    item:setTextParsingEnabled(false)
    item:setTextColours(CEGUI.PropertyHelper:stringToColour(skin.text))
    if skin.brush then
        item:setSelectionBrushImage(skin.brush)
        item:setSelectionColours(CEGUI.PropertyHelper:stringToColour(skin.selection))
    end
    return item
end

-- Fills a Listbox or Combobox, when it does not hold these texts by now.
function Kit:setItems(list, texts)
    local key = table.concat(texts, "\n")
    local path = list:getNamePath()
    if self.items[path] == key then
        return
    end
    self.items[path] = key
    self:silently(function()
        list:resetList()
        for index, text in ipairs(texts) do
            list:addItem(self:newItem(list, text, index))
        end
    end)
end

-- Selects by number, from 1; nil for none.
function Kit:choose(list, index)
    local item = index and list:getItemCount() >= index and list:getListboxItemFromIndex(index - 1) or nil
    if item and item:isSelected() then
        return
    end
    self:silently(function()
        list:clearAllSelections()
        if item then
            list:setItemSelectState(item, true)
        end
    end)
    if item and list.ensureItemIsVisible then
        list:ensureItemIsVisible(item)
    end
end

-- As choose(), and shows the text of what is selected.
function Kit:chooseInCombobox(combobox, index)
    self:choose(combobox, index)
    local item = combobox:getSelectedItem()
    self:setText(combobox, item and item:getText() or "")
end

-- The number of what is selected in a Listbox, Combobox or MultiColumnList, or nil.
function Kit.chosen(list)
    local item
    if list.getSelectedItem then
        item = list:getSelectedItem()
    else
        item = list:getFirstSelectedItem()
    end
    return item and item:getID() or nil
end

return Kit
