-- A stand-in for the table lodsmith: the same functions over plain tables, and a queue that ends generations when
-- told to.

local FakeLodsmith = {}

local function constants(...)
    local group = {}
    for index, name in ipairs({...}) do
        group[name] = index
    end
    return group
end

local Level = {}
Level.__index = Level
local Definition = {}
Definition.__index = Definition
local Mesh = {}
Mesh.__index = Mesh

local strategies = constants("DistanceSphere", "DistanceBox", "PixelCount", "ScreenRatioPixelCount")
local types = constants("Automatic", "User")
local methods = constants("Proportional", "Constant", "Triangles", "Deviation", "CollapseCost")

local function checkAmount(method, amount)
    if amount < 0 then
        return nil, "the amount is below 0"
    elseif method == methods.Proportional and amount > 1 then
        return nil, "a share of vertices is at most 1"
    elseif method == methods.Triangles and amount % 1 ~= 0 then
        return nil, "a number of triangles is whole"
    end
    return true
end

function Level:value() return self.data.value end
function Level:method() return self.data.method end
function Level:amount() return self.data.amount end
function Level:meshName() return self.data.meshName end
function Level:isHandMade() return self.data.meshName ~= "" end

function Level:setValue(value)
    local valid, message = self.definition:checkValue(value, self.data)
    if not valid then
        return nil, message
    end
    self.data.value = value
    return true
end

function Level:setTarget(method, amount)
    local valid, message = checkAmount(method, amount)
    if not valid then
        return nil, message
    end
    self.data.method, self.data.amount = method, amount
    return true
end

function Level:setAmount(amount)
    return self:setTarget(self.data.method, amount)
end

function Level:setMethod(method)
    local amount = checkAmount(method, self.data.amount) and self.data.amount or 0
    return self:setTarget(method, amount)
end

function Level:setMeshName(name)
    if name:find("%c") then
        return nil, "the mesh name has control characters"
    end
    self.data.meshName = name
    return true
end

function Definition.new()
    local definition = {automatic = true, kind = types.Automatic, how = strategies.DistanceSphere, levels = {}}
    return setmetatable(definition, Definition)
end

function Definition:isAutomatic() return self.automatic end
function Definition:setAutomatic(automatic) self.automatic = automatic return true end
function Definition:type() return self.kind end
function Definition:setType(kind) self.kind = kind return true end
function Definition:strategy() return self.how end
function Definition:setStrategy(how) self.how = how return true end
function Definition:metric() return self.cost end
function Definition:setMetric(cost) self.cost = cost return true end
function Definition:lockBorders() return false end
function Definition:weight() return nil end
function Definition:levelCount() return #self.levels end

function Definition:checkValue(value, except)
    if value <= 0 or value > 1e18 then
        return nil, "a level's value is above 0 and at most 1e18"
    end
    for _, data in ipairs(self.levels) do
        if data ~= except and data.value == value then
            return nil, ("there is a level of value %g"):format(value)
        end
    end
    return true
end

function Definition:level(index)
    if not self.levels[index] then
        return nil, "there is no such level"
    end
    return setmetatable({definition = self, data = self.levels[index]}, Level)
end

function Definition:addLevel(value)
    local valid, message = self:checkValue(value)
    if not valid then
        return nil, message
    end
    table.insert(self.levels, {value = value, method = methods.Proportional, amount = 0.5, meshName = ""})
    return self:level(#self.levels)
end

function Definition:removeLevel(index)
    if not self.levels[index] then
        return nil, "there is no such level"
    end
    table.remove(self.levels, index)
    return true
end

function Definition:sortLevels()
    local isRising = self.how == strategies.DistanceSphere or self.how == strategies.DistanceBox
    table.sort(self.levels, function(a, b)
        if isRising then
            return a.value < b.value
        end
        return a.value > b.value
    end)
end

function Definition:errors()
    local errors = {}
    for index, data in ipairs(self.levels) do
        if not self.automatic and self.kind == types.User and data.meshName == "" then
            table.insert(errors, ("level %d: a user-made level needs a mesh"):format(index))
        end
    end
    return errors
end

function Definition:copy()
    local copy = Definition.new()
    copy.automatic, copy.kind, copy.how, copy.cost = self.automatic, self.kind, self.how, self.cost
    for index, data in ipairs(self.levels) do
        copy.levels[index] = {value = data.value, method = data.method, amount = data.amount, meshName = data.meshName}
    end
    return copy
end

function Definition:text()
    local parts = {tostring(self.automatic), self.kind, self.how, tostring(self.cost)}
    for _, data in ipairs(self.levels) do
        table.insert(parts, table.concat({data.value, data.method, data.amount, data.meshName}, ","))
    end
    return table.concat(parts, " ")
end

function Definition:equals(other) return self:text() == other:text() end

function Mesh:name() return self.meshName end
function Mesh:group() return "fake" end
function Mesh:isLoaded() return true end
function Mesh:isGone() return self.gone == true end
function Mesh:equals(other) return self == other end
function Mesh:path()
    if self.isMade then
        return nil, self.meshName .. " comes from no file"
    end
    return "/fake/" .. self.meshName
end

function Mesh:load()
    if self.broken then
        return nil, self.meshName .. " is broken"
    end
    return true
end

function Mesh:info()
    return {
        triangles = 1000, vertices = 800, uniqueVertices = 500, indices = 3000, bytes = 40000, radius = 10,
        size = {x = 10, y = 20, z = 30}, edgeLists = false, animations = 0, poses = 0, notes = {},
        submeshes = {{name = "", material = "Stone", triangles = 1000, vertices = 800, indices = 3000, shared = false,
            indexBytes = 2}},
        levels = self.levels,
    }
end

-- What a definition would make of the mesh.
local function levelsOf(definition)
    local levels, reported = {}, {}
    for index, data in ipairs(definition.levels) do
        local triangles = math.max(2, math.floor(1000 * 0.5 ^ index))
        levels[index] = {value = data.value, triangles = triangles, vertices = triangles, indices = 3 * triangles,
            bytes = 6 * triangles, handMade = data.meshName ~= ""}
        reported[index] = {value = data.value, triangles = triangles, vertices = triangles, deviation = 0.01 * index,
            skipped = false}
    end
    return levels, reported
end

local function automaticDefinition()
    local definition = Definition.new()
    definition.automatic, definition.how = false, strategies.PixelCount
    for index, value in ipairs({200000, 40000, 10000}) do
        definition:addLevel(value):setTarget(methods.CollapseCost, 0.01 * index)
    end
    return definition
end

local Queue = {}
Queue.__index = Queue

local function connect(list, callback)
    local connection = {callback = callback}
    function connection:disconnect() self.callback = nil end
    function connection:isConnected() return self.callback ~= nil end
    table.insert(list, connection)
    return connection
end

local function emit(list, ...)
    for _, connection in ipairs(list) do
        if connection.callback then
            connection.callback(...)
        end
    end
end

function Queue:onInjected(callback) return connect(self.injected, callback) end
function Queue:onFailed(callback) return connect(self.failed, callback) end
function Queue:onProgress(callback) return connect(self.progressed, callback) end
function Queue:isQueued(mesh) return self.waiting[mesh] ~= nil end
function Queue:cancel(mesh) self.waiting[mesh] = nil return true end

-- Ends a generation, as the next frame would.
function Queue:finish(mesh)
    local definition = self.waiting[mesh]
    self.waiting[mesh] = nil
    local reported
    mesh.levels, reported = levelsOf(definition.automatic and automaticDefinition() or definition)
    emit(self.injected, mesh,
        {vertices = 500, triangles = 1000, radius = 10, fromCache = false, notes = {}, levels = reported})
end

function Queue:fail(mesh, message)
    self.waiting[mesh] = nil
    emit(self.failed, mesh, message)
end

function Queue:progress(mesh, fraction) emit(self.progressed, mesh, fraction) end

function FakeLodsmith.mesh(name)
    return setmetatable({meshName = name, levels = {}}, Mesh)
end

-- A table lodsmith with the meshes "castle.mesh", "cottage.mesh" and "tree.mesh", whose definitions are kept in
-- `files` by name.
function FakeLodsmith.new()
    local api = {
        Strategy = strategies, Type = types, Method = methods,
        Metric = constants("Quadric", "Curvature"),
        Decision = constants("LeftAlone", "Queued", "Attached", "Removed"),
        StopReason = constants("TargetReached", "Locked", "Seam", "Topology"),
        ViewMode = constants("Shaded", "Flat", "Wireframe", "Checker", "Deviation"),
        CompareMode = constants("Off", "SideBySide", "Wipe"),
        limits = {maxLevels = 256, maxValue = 1e18, maxMeshNameBytes = 1024},
        newDefinition = Definition.new,
    }
    local known = {FakeLodsmith.mesh("castle.mesh"), FakeLodsmith.mesh("cottage.mesh"), FakeLodsmith.mesh("tree.mesh")}
    api.files, api.known, api.applied, api.jobs = {}, known, {}, {}
    function api.meshes() return known end
    function api.openMesh(path)
        local name = path:match("[^/]+$")
        for _, mesh in ipairs(known) do
            if mesh.meshName == name then
                return mesh
            end
        end
        return nil, path .. ": no such file"
    end
    function api.openDirectory() return {known[2], known[3]} end
    function api.listDirectory(path)
        if path:find("nowhere") then
            return nil, path .. ": no such directory"
        end
        local parent = path ~= "/" and (path:match("^(.+)/[^/]*$") or "/") or nil
        return {path = path == "." and "/fake" or path, parent = parent,
            directories = {"models"}, meshes = {"castle.mesh", "cottage.mesh", "lowpoly.mesh"}}
    end
    api.queue = setmetatable({waiting = {}, injected = {}, failed = {}, progressed = {}}, Queue)
    api.manager = {
        apply = function(_, mesh, definition)
            definition = definition or Definition.new()
            if api.refusal then
                return nil, api.refusal
            end
            table.insert(api.applied, {mesh = mesh, definition = definition})
            if not definition.automatic and #definition.levels == 0 then
                mesh.levels = {}
                return api.Decision.Removed
            end
            api.queue.waiting[mesh] = definition
            return api.Decision.Queued
        end,
        automaticDefinition = automaticDefinition,
        automatic = function() return true end,
    }
    api.definitions = {
        read = function(_, mesh)
            local kept = api.files[mesh.meshName]
            if mesh.isMade then
                return mesh:path()
            elseif type(kept) == "string" then
                return nil, kept
            elseif not kept then
                return Definition.new(), nil
            end
            return kept:copy(), "/fake/" .. mesh.meshName:gsub("mesh$", "loddef")
        end,
        save = function(_, mesh, definition)
            if mesh.isMade then
                return mesh:path()
            elseif api.diskIsFull then
                return nil, "no space is left"
            end
            api.files[mesh.meshName] = definition:copy()
            return "/fake/" .. mesh.meshName:gsub("mesh$", "loddef")
        end,
        path = function(_, mesh)
            local path, message = mesh:path()
            return path and path:gsub("mesh$", "loddef"), message
        end,
    }
    local function job(finish)
        local handle = {running = true, finish = finish}
        function handle:fraction() return self.running and 0.5 or 1 end
        function handle:isRunning() return self.running end
        function handle:cancel() self.running = false end
        table.insert(api.jobs, handle)
        return handle
    end
    api.analysis = {
        measure = function(_, _, level, done)
            return job(function()
                done({mean = 0.001 * level, rms = 0.002 * level, maximum = 0.008 * level,
                    normalMean = 0.1, uvMean = 0.01, flipped = 0, newBorderEdges = 0})
            end)
        end,
        curve = function(_, _, _, count, done)
            return job(function()
                local points = {}
                for index = 1, count do
                    points[index] = {triangles = math.floor(1000 * 0.8 ^ (index - 1)), vertices = 1,
                        deviation = index == 1 and 0 or 0.001 * index ^ 2}
                end
                done(points)
            end)
        end,
    }
    -- Ends all jobs that were not cancelled, and those that they lead to.
    function api.finishJobs()
        while #api.jobs > 0 do
            local handle = table.remove(api.jobs, 1)
            if handle.running then
                handle.running = false
                handle.finish()
            end
        end
    end
    return api
end

return FakeLodsmith
