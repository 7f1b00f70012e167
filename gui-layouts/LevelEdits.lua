-- LodState's input functions: what an artist does to the definition and its levels. No CEGUI in here.

local Numbers = require("lodsmith.gui.Numbers")
local SwitchValues = require("lodsmith.gui.SwitchValues")

local LevelEdits = {}

local AUTOMATIC = "levels are automatic: make them manual first"

-- What is shown: the definition, or what automatic levels are.
function LevelEdits:shownDefinition()
    if self.definition and self.definition:isAutomatic() then
        if not self.automatic then
            self.automatic = self.api.manager:automaticDefinition(self.mesh)
            if self.automatic then
                self.automatic:sortLevels()
            end
        end
        return self.automatic
    end
    return self.definition
end

function LevelEdits:isEditable()
    return self.definition ~= nil and not self.definition:isAutomatic()
end

-- true, or nil and why levels cannot be changed.
function LevelEdits:canEdit()
    if not self:isEditable() then
        return nil, self.definition and AUTOMATIC or "no mesh is chosen"
    end
    return true
end

function LevelEdits:levelCount()
    local definition = self:shownDefinition()
    return definition and definition:levelCount() or 0
end

-- The level that is shown as the index-th, nearest first.
function LevelEdits:level(index)
    local definition = self:shownDefinition()
    if not definition or not index or index < 1 or index > definition:levelCount() then
        return nil, "no level is selected"
    end
    return definition:level(index)
end

function LevelEdits:findLevel(value)
    for index = 1, self:levelCount() do
        if Numbers.isSame(self:level(index):value(), value) then
            return index
        end
    end
    return nil
end

-- Selects the nearest there is; the last one when there are not as many.
function LevelEdits:select(index)
    local count = self:levelCount()
    if index and count > 0 then
        index = math.max(1, math.min(index, count))
    else
        index = nil
    end
    if index ~= self.selected then
        self:endGesture()
        self.selected = index
        self:emit("definition")
    end
    return true
end

-- Settings of the definition ------------------------------------------------------------------------------------------

function LevelEdits:setAutomatic(isAutomatic)
    return self:edit(nil, function(definition)
        definition:setAutomatic(isAutomatic)
        return true
    end)
end

function LevelEdits:setType(type)
    return self:edit(nil, function(definition)
        return definition:setType(type)
    end)
end

-- Turns automatic levels into levels that can be edited, in the place of those that waited.
function LevelEdits:makeManual()
    if not self.definition or not self.definition:isAutomatic() then
        return nil, "levels are manual"
    end
    local levels, message = self.api.manager:automaticDefinition(self.mesh)
    if not levels then
        return nil, message
    end
    return self:edit(nil, function(definition)
        definition:setAutomatic(false)
        definition:setType(levels:type())
        definition:setStrategy(levels:strategy())
        definition:setMetric(levels:metric())
        while definition:levelCount() > 0 do
            definition:removeLevel(1)
        end
        for index = 1, levels:levelCount() do
            local from = levels:level(index)
            local to, reason = definition:addLevel(from:value())
            if not to then
                return nil, reason
            end
            to:setTarget(from:method(), from:amount())
        end
        return true
    end)
end

-- Levels keep their order: their values become what they are under the other strategy (SwitchValues).
function LevelEdits:setStrategy(strategy)
    if not self.definition then
        return nil, "no mesh is chosen"
    end
    local strategies, from = self.api.Strategy, self.definition:strategy()
    local values = {}
    for index = 1, self.definition:levelCount() do
        local value = self.definition:level(index):value()
        local converted = SwitchValues.convert(strategies, from, strategy, value, self.info.radius)
        values[index] = Numbers.rounded(converted, 4)
    end
    local selected = self.selected
    local done, message = self:edit(nil, function(definition)
        local changed, reason = definition:setStrategy(strategy)
        if not changed then
            return nil, reason
        end
        return LevelEdits.replaceValues(definition, values, SwitchValues.isDistance(strategies, strategy))
    end)
    if done then
        self:select(selected)
    end
    return done, message
end

-- Values that rounding made alike move apart. All values pass through a range that none is in, for no two may ever be
-- alike.
function LevelEdits.replaceValues(definition, values, isRising)
    for index = 2, #values do
        local before = values[index - 1]
        if isRising and values[index] <= before * 1.0001 then
            values[index] = before * 1.001
        elseif not isRising and values[index] >= before * 0.9999 then
            values[index] = before * 0.999
        end
    end
    for index = 1, #values do
        definition:level(index):setValue(1e17 * (1 + index / 1000))
    end
    for index, value in ipairs(values) do
        local set, message = definition:level(index):setValue(value)
        if not set then
            return nil, message
        end
    end
    return true
end

-- Levels --------------------------------------------------------------------------------------------------------------

-- A value to begin with in a question for one.
function LevelEdits:suggestValue()
    if not self.definition then
        return nil
    end
    local count = self.definition:levelCount()
    local last = count > 0 and self.definition:level(count):value() or nil
    local strategy = self.definition:strategy()
    return Numbers.rounded(SwitchValues.beyond(self.api.Strategy, strategy, last, self.info.radius), 3)
end

-- Whether a new level may have this value: the number, or nil and the reason.
function LevelEdits:checkNewValue(text)
    local value, message = Numbers.parse(text)
    if not value then
        return nil, message
    end
    local can, why = self:canEdit()
    if not can then
        return nil, why
    end
    local added, reason = self.definition:copy():addLevel(value)
    if not added then
        return nil, reason
    end
    return value
end

function LevelEdits:addWith(text, fill)
    local value, message = self:checkNewValue(text)
    if not value then
        return nil, message
    end
    return self:edit(nil, function(definition)
        local level, reason = definition:addLevel(value)
        if not level then
            return nil, reason
        end
        local filled, why = fill(level, definition)
        if not filled then
            return nil, why
        end
        return level:value()
    end)
end

-- A new level leaves half of what the one before it leaves.
function LevelEdits:addLevel(text)
    return self:addWith(text, function(level, definition)
        local value, place = level:value(), 1
        local isRising = SwitchValues.isDistance(self.api.Strategy, definition:strategy())
        for index = 1, definition:levelCount() do
            local other = definition:level(index):value()
            if (isRising and other < value) or (not isRising and other > value) then
                place = place + 1
            end
        end
        return level:setTarget(self.api.Method.Proportional, Numbers.rounded(1 - 0.5 ^ place, 4))
    end)
end

function LevelEdits:deleteLevel()
    local can, why = self:canEdit()
    if not can then
        return nil, why
    end
    local index = self.selected
    if not index then
        return nil, "no level is selected"
    end
    return self:edit(nil, function(definition)
        return definition:removeLevel(index)
    end)
end

function LevelEdits:copyLevel()
    local level, message = self:level(self.selected)
    if not level then
        return nil, message
    end
    self.clipboard = {method = level:method(), amount = level:amount(), meshName = level:meshName()}
    self:say("info", "Level " .. self.selected .. " was copied")
    self:emit("definition")
    return true
end

-- Whether there is something to paste and a place for it.
function LevelEdits:canPaste()
    if not self.clipboard then
        return nil, "no level was copied"
    end
    return self:canEdit()
end

function LevelEdits:pasteLevel(text)
    local can, message = self:canPaste()
    if not can then
        return nil, message
    end
    local copied = self.clipboard
    return self:addWith(text, function(level)
        local set, reason = level:setTarget(copied.method, copied.amount)
        if not set then
            return nil, reason
        end
        return level:setMeshName(copied.meshName)
    end)
end

-- The selected level --------------------------------------------------------------------------------------------------

function LevelEdits:editLevel(gesture, change)
    local can, why = self:canEdit()
    if not can then
        return nil, why
    end
    local index = self.selected
    if not index then
        return nil, "no level is selected"
    end
    return self:edit(gesture, function(definition)
        local level, message = definition:level(index)
        if not level then
            return nil, message
        end
        return change(level)
    end)
end

-- Tries a change of the selected level on a copy: true, or nil and the reason.
function LevelEdits:tryLevel(change)
    if not self:isEditable() then
        return nil, AUTOMATIC
    end
    local level, message = self.definition:copy():level(self.selected or 0)
    if not level then
        return nil, message
    end
    return change(level)
end

-- text or number
local function toNumber(input)
    if type(input) == "number" then
        return input
    end
    return Numbers.parse(input)
end

function LevelEdits:setValue(input)
    local value, message = toNumber(input)
    if not value then
        return nil, message
    end
    return self:editLevel(nil, function(level)
        local set, reason = level:setValue(value)
        if not set then
            return nil, reason
        end
        return level:value()
    end)
end

function LevelEdits:checkValue(text)
    local value, message = Numbers.parse(text)
    if not value then
        return nil, message
    end
    return self:tryLevel(function(level)
        return level:setValue(value)
    end)
end

-- The level stays about what it is, where that is known; else the method's default.
function LevelEdits:setMethod(method)
    local row = self.selected and self:row(self.selected)
    return self:editLevel(nil, function(level)
        if level:method() == method then
            return true
        end
        local amount = row and self:equivalentAmount(row, method)
        if amount and level:setTarget(method, amount) then
            return true
        end
        return level:setMethod(method)
    end)
end

function LevelEdits:equivalentAmount(row, method)
    local methods, unique = self.api.Method, self.info.uniqueVertices
    if method == methods.Triangles then
        return row.triangles
    elseif method == methods.Constant and row.method == methods.Proportional then
        return math.floor(row.amount * unique + 0.5)
    elseif method == methods.Proportional and row.method == methods.Constant and unique > 0 then
        return Numbers.rounded(math.min(row.amount / unique, 1), 4)
    elseif method == methods.Deviation and row.bound then
        return Numbers.rounded(row.bound, 3)
    end
    return nil
end

-- gesture: edits of the same one are one step of undo; nil for a step of its own
function LevelEdits:setAmount(input, gesture)
    local amount, message = toNumber(input)
    if not amount then
        return nil, message
    end
    return self:editLevel(gesture, function(level)
        return level:setAmount(amount)
    end)
end

function LevelEdits:checkAmount(text)
    local amount, message = Numbers.parse(text)
    if not amount then
        return nil, message
    end
    return self:tryLevel(function(level)
        return level:setAmount(amount)
    end)
end

-- A hand-made mesh for the selected level; "" for a reduced one.
function LevelEdits:setMeshName(name)
    return self:editLevel(nil, function(level)
        return level:setMeshName(name)
    end)
end

-- Names that a hand-made level may have: meshes of the program, and the files beside this one.
function LevelEdits:handMadeMeshes(filter)
    if not self.mesh then
        return {}
    end
    local names, known = {}, {[self.mesh:name()] = true}
    local function add(name)
        if not known[name] then
            known[name] = true
            if self.passes(name, filter) then
                table.insert(names, name)
            end
        end
    end
    for _, mesh in ipairs(self.api.meshes()) do
        add(mesh:name())
    end
    local path = self.mesh:path()
    local listing = path and self.api.listDirectory(path:match("^(.*)/[^/]*$") or ".")
    for _, name in ipairs(listing and listing.meshes or {}) do
        add(name)
    end
    table.sort(names)
    return names
end

return LevelEdits
