-- The definition's settings and those of the selected level.

local Field = require("lodsmith.gui.Field")
local Numbers = require("lodsmith.gui.Numbers")
local SliderScale = require("lodsmith.gui.SliderScale")
local Words = require("lodsmith.gui.Words")

local DefinitionPane = {}
DefinitionPane.__index = DefinitionPane

local SLIDER_STEPS = 1000
-- Steps of the slider that follow each other faster than this are one edit.
local GESTURE_SECONDS = 0.5
local GESTURE = "slider"

function DefinitionPane.new(panel, dock)
    local self = setmetatable({panel = panel, kit = panel.kit, state = panel.state, isStale = true}, DefinitionPane)
    self.words = Words.of(panel.api)
    local window, parts = self.kit:load("DefinitionPane")
    dock:addChild(window)
    self.parts = parts
    self.type, self.strategy = CEGUI.toCombobox(parts.Type), CEGUI.toCombobox(parts.Strategy)
    self.method = CEGUI.toCombobox(parts.Method)
    self.slider = CEGUI.toScrollbar(parts.AmountSlider)
    self.handMade = CEGUI.toListbox(parts.HandMadeList)
    self.kit:setItems(self.type, Words.names(self.words.types))
    self.kit:setItems(self.strategy, Words.names(self.words.strategies))
    self.kit:setItems(self.method, Words.names(self.words.methods))
    self:connectDefinition()
    self:connectLevel()
    for _, event in ipairs({"mesh", "definition", "figures"}) do
        self.state:on(event, function()
            self.isStale = true
        end)
    end
    return self
end

function DefinitionPane:connectDefinition()
    local kit, keyboard, state, Key = self.kit, self.panel.keyboard, self.state, CEGUI.Key
    local actions = {
        {"Save", function() self:save() end, Key.S},
        {"Reload", function() state:told(state:reload()) end, Key.R},
        {"Undo", function() state:told(state:undo()) end, Key.Z},
        {"Redo", function() state:told(state:redo()) end, Key.Y},
        {"MakeManual", function() state:told(state:makeManual()) end},
    }
    for index, action in ipairs(actions) do
        kit:on(self.parts[action[1]], "Clicked", action[2])
        if action[3] then
            keyboard:shortcut(action[3], true, function(isShift)
                if action[3] == Key.Z and isShift then
                    return actions[index + 1][2]()
                end
                return action[2]()
            end, true)
        end
        if action[1] ~= "MakeManual" then
            keyboard:addButton(self.parts[action[1]], action[2])
        end
    end
    local function toggle(isAutomatic)
        state:told(state:setAutomatic(isAutomatic))
        self.isStale = true
    end
    kit:on(self.parts.Automatic, "SelectStateChanged", function()
        toggle(CEGUI.toToggleButton(self.parts.Automatic):isSelected())
    end)
    local function byKey()
        toggle(not state.definition:isAutomatic())
    end
    keyboard:add(self.parts.Automatic, {[Key.Space] = byKey, [Key.Return] = byKey, [Key.NumpadEnter] = byKey})
    keyboard:addButton(self.parts.MakeManual, actions[#actions][2])
    self:connectCombobox(self.type, self.words.types, function(type)
        return state:setType(type)
    end)
    self:connectCombobox(self.strategy, self.words.strategies, function(strategy)
        return state:setStrategy(strategy)
    end)
end

-- Takes over what is typed; nil and the reason when that cannot be.
function DefinitionPane:commit()
    for _, field in ipairs({self.value, self.amount}) do
        field:commit()
        if field.message then
            return nil, field.message
        end
    end
    return true
end

function DefinitionPane:save()
    local committed, message = self:commit()
    if not committed then
        self.state:say("error", "not saved: " .. message)
        return
    end
    self.state:told(self.state:save())
end

-- set: function(constant) -> true | nil, message
function DefinitionPane:connectCombobox(combobox, words, set)
    self.panel:connectCombobox(combobox, function(index)
        self.state:told(set(words[index][1]))
        self.isStale = true
    end)
end

function DefinitionPane:connectLevel()
    local kit, keyboard, state, parts = self.kit, self.panel.keyboard, self.state, self.parts
    local function tell()
        self:showErrors()
    end
    self.value = Field.new(kit, keyboard, parts.Value, {
        check = function(text) return state:checkValue(text) end,
        commit = function(text) return state:setValue(text) end,
        tell = tell,
    })
    self:connectCombobox(self.method, self.words.methods, function(method)
        return state:setMethod(method)
    end)
    self.amount = Field.new(kit, keyboard, parts.Amount, {
        check = function(text) return state:checkAmount(text) end,
        commit = function(text) return state:setAmount(text) end,
        tell = tell,
    })
    self:connectSlider()
    local function listAgain()
        self.handMadeFound, self.isStale = nil, true
    end
    kit:on(parts.HandMadeFilter, "TextChanged", listAgain)
    state:on("mesh", listAgain)
    keyboard:addText(parts.HandMadeFilter)
    kit:on(self.handMade, "SelectionChanged", function()
        local index = kit.chosen(self.handMade)
        if index then
            self:chooseHandMade(index)
        end
    end)
    keyboard:addList(self.handMade, function(step)
        local count = #self.handMadeNames
        local index = math.max(1, math.min(count, (kit.chosen(self.handMade) or 1) + step))
        self:chooseHandMade(index)
    end)
end

-- The slider is a scrollbar: those lie flat in every skin, and have buttons for small steps.
function DefinitionPane:connectSlider()
    local kit, state, slider, Key = self.kit, self.state, self.slider, CEGUI.Key
    kit:on(slider, "ScrollPositionChanged", function()
        self:slide(slider:getScrollPosition())
    end)
    kit:on(slider, "ThumbTrackStarted", function()
        self.isTracking = true
    end)
    kit:on(slider, "ThumbTrackEnded", function()
        self.isTracking = false
        state:endGesture()
    end)
    local function by(steps)
        return function()
            local position = math.max(0, math.min(SLIDER_STEPS, slider:getScrollPosition() + steps))
            kit:silently(function()
                slider:setScrollPosition(position)
            end)
            self:slide(position)
        end
    end
    self.panel.keyboard:add(slider, {
        [Key.ArrowLeft] = by(-5), [Key.ArrowRight] = by(5), [Key.ArrowDown] = by(-5), [Key.ArrowUp] = by(5),
        [Key.PageDown] = by(-50), [Key.PageUp] = by(50), [Key.Home] = by(-SLIDER_STEPS), [Key.End] = by(SLIDER_STEPS),
    })
end

function DefinitionPane:scale()
    local level = self.state:level(self.state.selected)
    return level and self.state.info and SliderScale.of(level:method(), self.panel.api.Method, self.state.info)
end

function DefinitionPane:slide(position)
    local scale = self:scale()
    if scale then
        self.state:told(self.state:setAmount(scale.toAmount(position / SLIDER_STEPS), GESTURE))
        self.sinceSlide = 0
        self.isStale = true
    end
end

function DefinitionPane:chooseHandMade(index)
    local name = self.handMadeNames[index]
    self.state:told(self.state:setMeshName(name or ""))
    self.isStale = true
end

function DefinitionPane:update(seconds)
    if self.sinceSlide then
        self.sinceSlide = self.sinceSlide + seconds
        if self.sinceSlide > GESTURE_SECONDS and not self.isTracking then
            self.sinceSlide = nil
            self.state:endGesture()
        end
    end
    if self.isStale then
        self.isStale = false
        self:refresh()
    end
end

function DefinitionPane:showErrors()
    local message = self.value and self.value.message or self.amount and self.amount.message
    self.kit:setMessage(self.parts.LevelError, message and "error" or "info", message or self.hint or "")
end

-- What the state has --------------------------------------------------------------------------------------------------

function DefinitionPane:refresh()
    local state, kit, parts = self.state, self.kit, self.parts
    local definition = state.definition
    local hasMesh, isEditable = definition ~= nil, state:isEditable()
    kit:setEnabled(parts.Save, hasMesh)
    kit:setEnabled(parts.Reload, hasMesh)
    kit:setEnabled(parts.Undo, state:canUndo())
    kit:setEnabled(parts.Redo, state:canRedo())
    kit:setEnabled(parts.Automatic, hasMesh)
    kit:setEnabled(parts.MakeManual, hasMesh and not isEditable)
    kit:setEnabled(parts.Type, isEditable)
    kit:setEnabled(parts.Strategy, isEditable)
    kit:setText(parts.Save, state:isDirty() and "Save *" or "Save")
    kit:setChecked(parts.Automatic, hasMesh and definition:isAutomatic())
    local shown = state:shownDefinition()
    local _, type = Words.find(self.words.types, shown and shown:type())
    local strategy, strategyIndex = Words.find(self.words.strategies, shown and shown:strategy())
    kit:chooseInCombobox(self.type, type)
    kit:chooseInCombobox(self.strategy, strategyIndex)
    kit:setText(parts.ValueLabel, strategy and strategy.label or "From")
    self:refreshLevel()
end

function DefinitionPane:refreshLevel()
    local state, kit, parts = self.state, self.kit, self.parts
    local row = state.selected and state:row(state.selected)
    local isEditable = row ~= nil and state:isEditable()
    local isReduced = isEditable and not row.isHandMade
    for _, name in ipairs({"Value", "HandMadeFilter", "HandMadeList"}) do
        kit:setEnabled(parts[name], isEditable)
    end
    for _, name in ipairs({"Method", "Amount", "AmountSlider"}) do
        kit:setEnabled(parts[name], isReduced)
    end
    local title = row and ("Level %d of %d"):format(row.index, state:levelCount()) or "No level is selected"
    kit:setText(parts.LevelTitle, title .. (row and not isEditable and " (automatic)" or ""))
    local method, methodIndex = Words.find(self.words.methods, row and row.method)
    self.hint = method and isReduced and method.hint:format(method.of and state.info[method.of] or 0) or nil
    local key = state.mesh and state.mesh:group() .. "/" .. state.mesh:name() .. " " .. tostring(state.selected) or ""
    self.value:refresh(key, row and Numbers.format(row.value) or "")
    self.amount:refresh(key .. " " .. tostring(methodIndex), row and Numbers.format(row.amount) or "")
    kit:chooseInCombobox(self.method, methodIndex)
    self:refreshSlider(row)
    self:refreshHandMade(row)
    kit:setText(parts.LevelFigures, row and DefinitionPane.describe(row, state.info.radius) or "")
    self:showErrors()
end

-- A slider that stands for the amount is left where it is, so that a drag is never pulled back.
function DefinitionPane:refreshSlider(row)
    local scale, slider = self:scale(), self.slider
    local position = 0
    if scale and row then
        local present = slider:getScrollPosition()
        if Numbers.isSame(scale.toAmount(present / SLIDER_STEPS), row.amount) then
            return
        end
        position = scale.toPosition(row.amount) * SLIDER_STEPS
    end
    self.kit:silently(function()
        slider:setScrollPosition(position)
    end)
end

function DefinitionPane:refreshHandMade(row)
    -- Not at each step of a slider: a directory is read.
    if not self.handMadeFound then
        self.handMadeFound = self.state:handMadeMeshes(self.parts.HandMadeFilter:getText())
    end
    local texts = {"(none: reduced by the generator)"}
    self.handMadeNames = {""}
    local chosen = row and row.meshName == "" and 1 or nil
    for _, name in ipairs(self.handMadeFound) do
        table.insert(texts, name)
        table.insert(self.handMadeNames, name)
        if row and row.meshName == name then
            chosen = #texts
        end
    end
    if row and not chosen then
        table.insert(texts, 2, row.meshName)
        table.insert(self.handMadeNames, 2, row.meshName)
        chosen = 2
    end
    self.kit:setItems(self.handMade, texts)
    self.kit:choose(self.handMade, chosen)
end

function DefinitionPane.describe(row, radius)
    local lines = {}
    if row.isSkipped then
        table.insert(lines, "Left out: no fewer vertices than the level before.")
    elseif not row.ogreLevel then
        table.insert(lines, "Not on the mesh yet.")
    elseif not row.triangles then
        table.insert(lines, "The mesh '" .. row.meshName .. "' is not there.")
    else
        table.insert(lines, ("%s, %s"):format(Numbers.count(row.triangles, "triangle"),
            Numbers.count(row.vertices, "vertex", "vertices")))
    end
    if row.measured then
        local m = row.measured
        table.insert(lines, ("Off: mean %s, rms %s, most %s"):format(Numbers.length(m.mean, radius),
            Numbers.length(m.rms, radius), Numbers.length(m.maximum, radius)))
        table.insert(lines, ("Normals off by %s degrees, %s"):format(Numbers.short(math.deg(m.normalMean)),
            Numbers.count(m.flipped, "triangle") .. " flipped"))
    elseif row.bound then
        table.insert(lines, "Deviation at most " .. Numbers.length(row.bound, radius))
    end
    return table.concat(lines, "\n")
end

return DefinitionPane
