local Expect = require("Expect")
local FakeLodsmith = require("FakeLodsmith")
local LodState = require("lodsmith.gui.LodState")

local function make()
    local api = FakeLodsmith.new()
    local state = LodState.new(api)
    state:chooseMesh(api.known[1])
    state:makeManual()
    return state, api
end

local Tests = {}

function Tests.rowsKnowWhatIsOnTheMesh()
    local state, api = make()
    Expect.equal(state:row(1).ogreLevel, nil)
    api.queue:finish(state.mesh)
    local row = state:row(2)
    Expect.equal(row.ogreLevel, 2)
    Expect.equal(row.triangles, 250)
    Expect.equal(row.bytes, 1500)
    Expect.equal(row.bound, 0.02)
    Expect.equal(row.measured, nil)
    Expect.equal(state:row(9), nil)
end

function Tests.skippedLevelIsSaid()
    local state, api = make()
    api.queue:finish(state.mesh)
    table.remove(state.mesh.levels, 2)
    state:takeReport({levels = {{value = 200000, deviation = 0.1}, {value = 40000, deviation = 0.1, skipped = true},
        {value = 10000, deviation = 0.2}}})
    Expect.yes(state:row(2).isSkipped)
    Expect.equal(state:row(2).ogreLevel, nil)
    Expect.equal(state:row(3).ogreLevel, 2)
end

function Tests.measuringWaitsUntilNothingGoesOn()
    local state, api = make()
    state:update(1)
    Expect.equal(#api.jobs, 0)
    api.queue:finish(state.mesh)
    state:update(0.2)
    Expect.equal(#api.jobs, 0)
    state:update(0.2)
    Expect.equal(#api.jobs, 2)
    api.finishJobs()
    Expect.near(state:row(3).measured.maximum, 0.024, 1e-9)
    Expect.equal(#state.curve, 32)
end

function Tests.selectedLevelIsMeasuredFirst()
    local state, api = make()
    state:select(3)
    api.queue:finish(state.mesh)
    state:update(1)
    api.jobs[1].running = false
    api.jobs[1].finish()
    Expect.yes(state:row(3).measured)
    Expect.equal(state:row(1).measured, nil)
    api.finishJobs()
    Expect.yes(state:row(1).measured)
    Expect.yes(state:row(2).measured)
end

function Tests.failedMeasurementIsSaidAndTheOthersGoOn()
    local state, api = make()
    api.queue:finish(state.mesh)
    local measure = api.analysis.measure
    api.analysis.measure = function(self, mesh, level, done)
        return measure(self, mesh, level, function(result)
            if level == 1 then
                done(nil, "no memory")
            else
                done(result)
            end
        end)
    end
    state:update(1)
    api.finishJobs()
    Expect.equal(state.message.text, "Level 1 was not measured: no memory")
    Expect.yes(state:row(2).measured)
end

function Tests.newLevelsDropOldMeasurements()
    local state, api = make()
    api.queue:finish(state.mesh)
    state:update(1)
    local first = api.jobs[1]
    state:setAmount("0.02")
    api.queue:finish(state.mesh)
    Expect.no(first:isRunning())
    Expect.equal(state:row(1).measured, nil)
    state:update(1)
    api.finishJobs()
    Expect.yes(state:row(1).measured)
end

function Tests.curveIsComputedOnceForOneWayOfReducing()
    local state, api = make()
    api.queue:finish(state.mesh)
    state:update(1)
    api.finishJobs()
    state:setAmount("0.02")
    api.queue:finish(state.mesh)
    state:update(1)
    Expect.equal(#api.jobs, 1)
    api.finishJobs()
    state:edit(nil, function(definition) return definition:setMetric(api.Metric.Quadric) end)
    api.queue:finish(state.mesh)
    state:update(1)
    Expect.equal(#api.jobs, 2)
end

function Tests.anotherMeshDropsTheJobs()
    local state, api = make()
    api.queue:finish(state.mesh)
    state:update(1)
    local measurement, curve = api.jobs[1], api.jobs[2]
    state:chooseMesh(api.known[2])
    state:answer("discard")
    Expect.no(measurement:isRunning())
    Expect.no(curve:isRunning())
    Expect.equal(state.curve, nil)
end

function Tests.automaticLevelsHaveFiguresToo()
    local api = FakeLodsmith.new()
    local state = LodState.new(api)
    state:chooseMesh(api.known[1])
    api.queue.waiting[state.mesh] = api.newDefinition()
    api.queue:finish(state.mesh)
    Expect.equal(state:row(3).triangles, 125)
end

function Tests.worksWithoutAnalysis()
    local api = FakeLodsmith.new()
    api.analysis = nil
    local state = LodState.new(api)
    state:chooseMesh(api.known[1])
    state:update(1)
    Expect.equal(state.message, nil)
end

function Tests.anotherCurveTakesThePlaceOfTheOneThatIsComputed()
    local state, api = make()
    api.queue:finish(state.mesh)
    state:update(1)
    local first = api.jobs[2]
    Expect.equal(state.curveJob, first)
    state:edit(nil, function(definition) return definition:setMetric(api.Metric.Curvature) end)
    api.queue:finish(state.mesh)
    state:update(1)
    Expect.no(first:isRunning())
    Expect.equal(state.curveJob, api.jobs[4])
    Expect.yes(state.curveJob:isRunning())
    api.finishJobs()
    Expect.equal(state.curveJob, nil)
    Expect.equal(#state.curve, 32)
end

function Tests.curveThatIsComputedIsNotBegunAgain()
    local state, api = make()
    api.queue:finish(state.mesh)
    state:update(1)
    local first = state.curveJob
    state:setAmount("0.02")
    api.queue:finish(state.mesh)
    state:update(1)
    Expect.equal(state.curveJob, first)
    Expect.yes(first:isRunning())
end

function Tests.failedCurveIsTriedAgainAtTheNextChange()
    local state, api = make()
    api.queue:finish(state.mesh)
    local curve = api.analysis.curve
    local function change()
        state:setAmount((state:level(1):amount() + 0.01) .. "")
        api.queue:finish(state.mesh)
        state:update(1)
        api.finishJobs()
    end
    api.analysis.curve = function(self, mesh, definition, count, done)
        return curve(self, mesh, definition, count, function()
            done(nil, "no memory")
        end)
    end
    change()
    Expect.equal(state.message.text, "No curve: no memory")
    Expect.equal(state.curveJob, nil)
    api.analysis.curve = function()
        return nil, "the analyser is closed"
    end
    change()
    Expect.equal(state.message.text, "No curve: the analyser is closed")
    Expect.equal(state.curve, nil)
    api.analysis.curve = curve
    change()
    Expect.equal(#state.curve, 32)
end

return Tests
