-- LodState's figures: what the levels are now, how far they are from the mesh, and the curve of deviation against
-- triangles. Measuring waits until nothing is generated and nothing was edited for a while. No CEGUI in here.

local Numbers = require("lodsmith.gui.Numbers")

local LevelFigures = {}

local IDLE_SECONDS = 0.3
local CURVE_POINTS = 32

function LevelFigures:forgetFigures(info)
    self:dropJobs()
    self.info, self.report, self.measured = info, nil, {}
    self.curve, self.curveKey = nil, nil
    self.measureDue, self.curveDue, self.idle = true, true, 0
    self:emit("figures")
    self:emit("curve")
end

-- What was asked for about levels or a mesh that are no longer there.
function LevelFigures:dropJobs()
    self:dropMeasuring()
    self:dropCurveJob()
end

function LevelFigures:dropCurveJob()
    if self.curveJob then
        self.curveJob:cancel()
        self.curveJob = nil
    end
end

function LevelFigures:dropMeasuring()
    self.toMeasure = {}
    if self.measureJob then
        self.measureJob:cancel()
        self.measureJob = nil
    end
end

-- New levels are on the mesh; report: what generation tells of them, or nil.
function LevelFigures:takeReport(report)
    self:setProgress(nil)
    self:dropMeasuring()
    local info, message = self.mesh:info()
    if not info then
        self:say("error", message)
        return
    end
    self.info, self.report, self.measured = info, report, {}
    self.measureDue, self.idle = true, 0
    if self.definition:isAutomatic() then
        self.automatic = nil
    end
    self:select(self.selected or 1)
    self:tellMissing()
    self:emit("figures")
end

-- A hand-made level whose mesh cannot be had is left out, the others are there.
function LevelFigures:tellMissing()
    for index, row in ipairs(self:rows()) do
        if row.isHandMade and not row.triangles then
            self:say("error", ("Level %d: the mesh '%s' is not there, or cannot be used; OGRE's log has the reason")
                :format(index, row.meshName))
        end
    end
end

local function findByValue(levels, value)
    for index, level in ipairs(levels or {}) do
        if Numbers.isSame(level.value, value) then
            return level, index
        end
    end
    return nil
end

-- What is known of the index-th level, nearest first: value, method, amount, meshName; and where the mesh has that
-- level, triangles, vertices, indices, bytes, ogreLevel; bound and measured where they are known.
function LevelFigures:row(index)
    local level = self:level(index)
    if not level then
        return nil
    end
    local row = {
        index = index,
        value = level:value(),
        method = level:method(),
        amount = level:amount(),
        meshName = level:meshName(),
        isHandMade = level:isHandMade(),
    }
    local reported = findByValue(self.report and self.report.levels, row.value)
    if reported then
        row.bound, row.isSkipped = reported.deviation, reported.skipped
    end
    local present, ogreLevel = findByValue(self.info and self.info.levels, row.value)
    if present then
        row.ogreLevel = ogreLevel
        row.triangles, row.vertices = present.triangles, present.vertices
        row.indices, row.bytes = present.indices, present.bytes
        row.measured = self.measured[ogreLevel]
    end
    return row
end

function LevelFigures:rows()
    local rows = {}
    for index = 1, self:levelCount() do
        rows[index] = self:row(index)
    end
    return rows
end

-- The deviation for the graph: the bound, as the curve is one, and where nothing was generated what was measured.
function LevelFigures.deviationOf(row)
    return row.bound or row.measured and row.measured.maximum
end

function LevelFigures:updateFigures(seconds)
    if not self.mesh or not self.api.analysis then
        return
    end
    self.idle = self:isGenerating() and 0 or self.idle + seconds
    if self.idle < IDLE_SECONDS then
        return
    end
    if self.measureDue then
        self.measureDue = false
        self:measureLevels()
    end
    if self.curveDue then
        self.curveDue = false
        self:computeCurve()
    end
end

-- One after the other, the selected level first: what else is to be measured need not wait for all of them.
function LevelFigures:measureLevels()
    self:dropMeasuring()
    local selected = self.selected and self:row(self.selected)
    local first = selected and selected.ogreLevel
    self.toMeasure = {first}
    for ogreLevel = 1, #self.info.levels do
        if ogreLevel ~= first then
            table.insert(self.toMeasure, ogreLevel)
        end
    end
    self:measureNext()
end

function LevelFigures:measureNext()
    local ogreLevel = table.remove(self.toMeasure, 1)
    if not ogreLevel then
        return
    end
    local job, message = self.api.analysis:measure(self.mesh, ogreLevel, function(result, reason)
        self.measureJob = nil
        if result then
            self.measured[ogreLevel] = result
            self:emit("figures")
        else
            self:say("error", ("Level %d was not measured: %s"):format(ogreLevel, reason))
        end
        self:measureNext()
    end)
    if job then
        self.measureJob = job
    else
        self:say("error", message)
    end
end

-- The curve depends on how is reduced, not on the levels.
local function curveKey(definition)
    local key = {tostring(definition:metric()), tostring(definition:lockBorders())}
    for _, name in ipairs({"normal", "uv", "colour", "bone"}) do
        table.insert(key, tostring(definition:weight(name)))
    end
    return table.concat(key, " ")
end

-- curveKey is that of the curve that is there, or that is being computed.
function LevelFigures:computeCurve()
    local definition = self:shownDefinition()
    if not definition or curveKey(definition) == self.curveKey then
        return
    end
    self:dropCurveJob()
    self.curveKey = curveKey(definition)
    local job, message = self.api.analysis:curve(self.mesh, definition, CURVE_POINTS, function(points, reason)
        self.curveJob = nil
        self:takeCurve(points, reason)
    end)
    self.curveJob = job
    if job then
        self:emit("curve")
    else
        self:takeCurve(nil, message)
    end
end

-- Without its points the curve is asked for again at the next change.
function LevelFigures:takeCurve(points, reason)
    self.curve = points
    if not points then
        self.curveKey = nil
        self:say("error", "No curve: " .. reason)
    end
    self:emit("curve")
end

return LevelFigures
