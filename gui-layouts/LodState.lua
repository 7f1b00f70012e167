-- What the panel works on: a mesh, its definition, what was done to it, and what was found out about it. No CEGUI in
-- here: tests and scripts use it without a window. Every function that takes input returns true, or nil and the
-- reason, and has then changed nothing. Listeners hear of "mesh", "definition", "figures", "curve", "progress",
-- "message" and "question".

local Scheduler = require("lodsmith.gui.Scheduler")

local LodState = {}
LodState.__index = LodState
for _, part in ipairs({"LevelEdits", "LevelFigures"}) do
    for name, method in pairs(require("lodsmith.gui." .. part)) do
        LodState[name] = method
    end
end

local UNDO_STEPS = 200

-- api: the table lodsmith, whole or a stand-in
-- checkFile: function(path) -> true | nil, message: whether a mesh file may be loaded; nil: all may
function LodState.new(api, checkFile)
    local self = setmetatable({api = api, checkFile = checkFile, listeners = {}, undoSteps = {}, redoSteps = {}}, LodState)
    self.scheduler = Scheduler.new({
        apply = function(mesh, definition)
            return api.manager:apply(mesh, definition)
        end,
        isQueued = function(mesh)
            return api.queue:isQueued(mesh) == true
        end,
        cancel = function(mesh)
            return api.queue:cancel(mesh)
        end,
    }, api.Decision.Queued, function(mesh, message)
        self:afterApply(mesh, message)
    end)
    self:listenToQueue()
    return self
end

function LodState:listenToQueue()
    local queue = self.api.queue
    local function ofThis(handler)
        return function(mesh, ...)
            self.scheduler:finished(mesh)
            if self.mesh and self.mesh:equals(mesh) then
                handler(...)
            end
        end
    end
    self.connections = {
        queue:onInjected(ofThis(function(report)
            self:takeReport(report)
        end)),
        queue:onFailed(ofThis(function(message)
            self:setProgress(nil)
            self:say("error", message)
        end)),
        queue:onProgress(function(mesh, fraction)
            if self.mesh and self.mesh:equals(mesh) then
                self:setProgress(fraction)
            end
        end),
    }
end

-- Levels that are not saved go with it.
function LodState:close()
    self:dropMesh()
    for _, connection in ipairs(self.connections) do
        connection:disconnect()
    end
    self.connections, self.listeners = {}, {}
end

-- Listeners -----------------------------------------------------------------------------------------------------------

function LodState:on(event, listener)
    self.listeners[event] = self.listeners[event] or {}
    table.insert(self.listeners[event], listener)
end

function LodState:emit(event, ...)
    for _, listener in ipairs(self.listeners[event] or {}) do
        listener(...)
    end
end

-- kind: "info" or "error"
function LodState:say(kind, text)
    self.message = {kind = kind, text = text}
    self:emit("message", kind, text)
end

-- Says why something was refused, and hands it on.
function LodState:told(result, message)
    if not result then
        self:say("error", message)
    end
    return result, message
end

function LodState:setProgress(fraction)
    self.progress = fraction
    self:emit("progress", fraction)
end

-- Meshes --------------------------------------------------------------------------------------------------------------

-- Those whose names hold the filter's text, whatever its case.
function LodState:meshes(filter)
    local found = {}
    for _, mesh in ipairs(self.api.meshes()) do
        if LodState.passes(mesh:name(), filter) then
            table.insert(found, mesh)
        end
    end
    return found
end

function LodState.passes(name, filter)
    return not filter or filter == "" or name:lower():find(filter:lower(), 1, true) ~= nil
end

-- true, "asked" when there are unsaved changes and answer() decides, or nil and the reason.
-- chosen: function(mesh) or nil, called once the mesh is the one that is edited
function LodState:chooseMesh(mesh, chosen)
    chosen = chosen or function() end
    if self.mesh and self.mesh:equals(mesh) then
        chosen(mesh)
        return true
    end
    return self:afterSaving("Another mesh is to be edited.", function()
        local set, message = self:setMesh(mesh)
        if set then
            chosen(mesh)
        end
        return set, message
    end)
end

-- chosen: as for chooseMesh()
function LodState:openMesh(path, chosen)
    local mesh, message = self:passesCheck(path)
    if mesh then
        mesh, message = self.api.openMesh(path)
    end
    if not mesh then
        return nil, message
    end
    return self:chooseMesh(mesh, chosen)
end

-- All meshes of a directory go into the list, and the first one is chosen; chosen: as for chooseMesh().
function LodState:openDirectory(path, chosen)
    local meshes, message = self.api.openDirectory(path)
    if not meshes then
        return nil, message
    end
    if #meshes == 0 then
        return nil, path .. ": there are no meshes"
    end
    self:emit("figures")
    return self:chooseMesh(meshes[1], chosen)
end

function LodState:passesCheck(path)
    if not path or not self.checkFile then
        return true
    end
    return self.checkFile(path)
end

function LodState:setMesh(mesh)
    if mesh:isGone() then
        return nil, "the mesh is gone"
    end
    local loaded, message = self:passesCheck(not mesh:isLoaded() and mesh:path() or nil)
    if loaded then
        loaded, message = mesh:load()
    end
    if not loaded then
        return nil, message
    end
    local definition, path = self:readDefinition(mesh)
    if not definition then
        return nil, path
    end
    local info, reason = mesh:info()
    if not info then
        return nil, reason
    end
    self:dropMesh()
    if self.message and self.message.kind == "error" then
        self:say("info", "")
    end
    self.mesh = mesh
    self:setBaseline(definition, path)
    self:forgetFigures(info)
    self:select(1)
    self:emit("mesh")
    self:emit("definition")
    return true
end

-- The definition and its path; without one where there is no file yet. A mesh that comes from no file, and so has no
-- place for one, is edited all the same: save() says why it is not kept.
function LodState:readDefinition(mesh)
    local definition, path = self.api.definitions:read(mesh)
    if not definition and not self.api.definitions:path(mesh) then
        return self.api.newDefinition()
    end
    return definition, path
end

-- Levels that were tried out and not saved give way to those of the file. So do those of a generation that is cut off,
-- for it leaves the levels of an edit before it.
function LodState:dropMesh()
    local mesh = self.mesh
    if not mesh then
        return
    end
    local wasBusy = self.scheduler:isBusy()
    self.scheduler:cancel()
    self:setProgress(nil)
    if self.hasApplied and (wasBusy or self:isDirty()) and not mesh:isGone() then
        self.api.manager:apply(mesh)
    end
    self:dropJobs()
    self.mesh, self.definition, self.saved, self.path, self.info, self.selected = nil, nil, nil, nil, nil, nil
    self.automatic = nil
end

function LodState:setBaseline(definition, path)
    definition:sortLevels()
    self.definition, self.path = definition, path
    self.saved = definition:copy()
    self.undoSteps, self.redoSteps, self.gesture = {}, {}, nil
    self.hasApplied = false
    self.automatic = nil
    self.isWarned = false
end

function LodState:isDirty()
    return self.definition ~= nil and not self.definition:equals(self.saved)
end

-- Files ---------------------------------------------------------------------------------------------------------------

function LodState:save()
    if not self.mesh then
        return nil, "no mesh is chosen"
    end
    local errors = self.definition:errors()
    if #errors > 0 then
        return nil, "not saved: " .. table.concat(errors, "; ")
    end
    if self:isOvertaken() and not self.isWarned then
        self.isWarned = true
        return nil, "not saved: the file was changed by another program; read it again, or save once more to replace it"
    end
    local path, message = self.api.definitions:save(self.mesh, self.definition)
    if not path then
        return nil, "not saved: " .. message
    end
    self.saved, self.path, self.isWarned = self.definition:copy(), path, false
    self:endGesture()
    self:say("info", "Saved " .. path)
    self:emit("definition")
    return true
end

-- Whether the file says something else than when it was read or saved here.
function LodState:isOvertaken()
    if not self.api.definitions:path(self.mesh) then
        return false
    end
    local present = self.api.definitions:read(self.mesh)
    if present then
        present:sortLevels()
    end
    return not present or not present:equals(self.saved)
end

-- Reads the definition again; "asked" when changes would be lost.
function LodState:reload()
    if not self.mesh then
        return nil, "no mesh is chosen"
    end
    return self:afterAsking({
        title = "Reload",
        text = "The definition has unsaved changes. Reading it again loses them.",
        answers = {"discard", "cancel"},
    }, function()
        local definition, path = self:readDefinition(self.mesh)
        if not definition then
            return nil, path
        end
        self:setBaseline(definition, path)
        self:select(self.selected)
        self:say("info", path and "Read " .. path or "There is no definition yet: levels are automatic")
        self:apply()
        self:emit("definition")
        return true
    end)
end

-- Questions -----------------------------------------------------------------------------------------------------------

-- Calls `action` at once when there is nothing to lose, else when the question is answered so.
function LodState:afterAsking(question, action)
    if not self:isDirty() then
        return action()
    end
    question.action = action
    self.question = question
    self:emit("question", question)
    return "asked"
end

-- Before something that loses unsaved changes: leaving, for example.
function LodState:afterSaving(reason, action)
    return self:afterAsking({
        title = "Unsaved changes",
        text = ("The definition of '%s' has unsaved changes. %s"):format(self.mesh and self.mesh:name() or "", reason),
        answers = {"save", "discard", "cancel"},
    }, action)
end

-- answer: "save", "discard" or "cancel"
function LodState:answer(answer)
    local question = self.question
    if not question then
        return nil, "nothing was asked"
    end
    self.question = nil
    if answer == "save" then
        local saved, message = self:save()
        if not saved then
            return nil, message
        end
    elseif answer ~= "discard" then
        return true
    end
    return question.action()
end

-- Undo ----------------------------------------------------------------------------------------------------------------

-- Changes a copy of the definition and takes it over when `change` returns something true; a number is the value of the
-- level that is to be selected. Edits of one gesture (a slider's drag) are one step of undo.
function LodState:edit(gesture, change)
    if not self.definition then
        return nil, "no mesh is chosen"
    end
    local after = self.definition:copy()
    local done, message = change(after)
    if not done then
        return nil, message
    end
    local level = self.selected and after:level(math.min(self.selected, after:levelCount())) or nil
    local value = type(done) == "number" and done or level and level:value()
    after:sortLevels()
    if not after:equals(self.definition) then
        self:remember(gesture)
        self.definition = after
        self.automatic = nil
        self:apply()
    end
    self:select(value and self:findLevel(value) or 1)
    self:emit("definition")
    return true
end

function LodState:remember(gesture)
    if gesture == nil or gesture ~= self.gesture then
        table.insert(self.undoSteps, {definition = self.definition, selected = self.selected})
        if #self.undoSteps > UNDO_STEPS then
            table.remove(self.undoSteps, 1)
        end
    end
    self.gesture = gesture
    self.redoSteps = {}
end

-- A gesture that came back to where it began was none.
function LodState:endGesture()
    local last = self.undoSteps[#self.undoSteps]
    if self.gesture and last and last.definition:equals(self.definition) then
        table.remove(self.undoSteps)
    end
    self.gesture = nil
end

function LodState:canUndo()
    return #self.undoSteps > 0
end

function LodState:canRedo()
    return #self.redoSteps > 0
end

function LodState:undo()
    return self:step(self.undoSteps, self.redoSteps, "nothing to undo")
end

function LodState:redo()
    return self:step(self.redoSteps, self.undoSteps, "nothing to redo")
end

function LodState:step(from, to, message)
    local step = table.remove(from)
    if not step then
        return nil, message
    end
    table.insert(to, {definition = self.definition, selected = self.selected})
    self.definition = step.definition
    self.automatic = nil
    self:endGesture()
    self:select(step.selected)
    self:apply()
    self:emit("definition")
    return true
end

-- Generation ----------------------------------------------------------------------------------------------------------

function LodState:apply()
    local errors = self.definition:errors()
    if #errors > 0 then
        self:say("error", table.concat(errors, "; "))
        return
    end
    self.hasApplied = true
    self.curveDue = true
    self.scheduler:request(self.mesh, self.definition:copy())
end

-- What needed no generation has ended, or was refused.
function LodState:afterApply(mesh, message)
    if not self.mesh or not self.mesh:equals(mesh) then
        return
    end
    if message then
        self:say("error", message)
    else
        self:takeReport(nil)
    end
end

function LodState:cancelGeneration()
    if not self.mesh then
        return nil, "no mesh is chosen"
    end
    self.scheduler:cancel()
    if self.api.queue:isQueued(self.mesh) then
        self.api.queue:cancel(self.mesh)
    end
    self:setProgress(nil)
    self:say("info", "Generation was cancelled; the mesh keeps the levels that it has")
    return true
end

function LodState:isGenerating()
    return self.mesh ~= nil and (self.scheduler:isBusy() or self.api.queue:isQueued(self.mesh) == true)
end

-- Once a frame; seconds since the last time.
function LodState:update(seconds)
    if self.mesh and self.mesh:isGone() then
        self:dropMesh()
        self:say("error", "The mesh is gone")
        self:emit("mesh")
        self:emit("definition")
    end
    self.scheduler:update()
    if self.progress and not self:isGenerating() then
        self:setProgress(nil)
    end
    self:updateFigures(seconds)
end

return LodState
