local Expect = require("Expect")
local FakeLodsmith = require("FakeLodsmith")
local LodState = require("lodsmith.gui.LodState")

local function make(...)
    local api = FakeLodsmith.new()
    local definition = api.newDefinition()
    definition:setAutomatic(false)
    for _, value in ipairs({...}) do
        definition:addLevel(value)
    end
    api.files["castle.mesh"] = definition
    local state = LodState.new(api)
    state:chooseMesh(api.known[1])
    return state, api
end

-- Whatever is refused has changed nothing.
local function expectRefused(state, text, result, message)
    Expect.refused(text, result, message)
    Expect.no(state:isDirty())
    Expect.no(state:canUndo())
end

local Tests = {}

function Tests.addRefusesWhatCannotBe()
    local state = make(20)
    expectRefused(state, "not a number", state:addLevel("near"))
    expectRefused(state, "a number is needed", state:addLevel(""))
    expectRefused(state, "there is a level of value 20", state:addLevel("20"))
    expectRefused(state, "above 0", state:addLevel("0"))
    expectRefused(state, "above 0", state:addLevel("1e19"))
end

function Tests.addedLevelsHalve()
    local state = make()
    for index, value in ipairs({"10", "20", "40"}) do
        state:addLevel(value)
        Expect.equal(state.selected, index)
        Expect.equal(state:level(index):amount(), 1 - 0.5 ^ index)
    end
    state:addLevel("5")
    Expect.equal(state.selected, 1)
    Expect.equal(state:level(1):amount(), 0.5)
end

function Tests.suggestionGoesBeyondTheLast()
    local state, api = make(30)
    Expect.equal(state:suggestValue(), 60)
    state:setStrategy(api.Strategy.PixelCount)
    Expect.yes(state:suggestValue() < state:level(1):value())
end

function Tests.valueRefusesAndMoves()
    local state = make(20, 50, 90)
    state:select(1)
    expectRefused(state, "there is a level of value 50", state:setValue("50"))
    expectRefused(state, "not a number", state:setValue("x"))
    Expect.refused("there is a level of value 90", state:checkValue("90"))
    Expect.yes(state:setValue("60"))
    Expect.equal(state:level(2):value(), 60)
    Expect.equal(state.selected, 2)
end

function Tests.amountRefusesWhatTheMethodDoes()
    local state, api = make(20)
    expectRefused(state, "at most 1", state:setAmount("1.5"))
    expectRefused(state, "below 0", state:setAmount("-1"))
    expectRefused(state, "not a number", state:setAmount("half"))
    state:setMethod(api.Method.Triangles)
    Expect.refused("whole", state:setAmount("10.5"))
    Expect.refused("whole", state:checkAmount("10.5"))
    Expect.yes(state:checkAmount("10"))
end

function Tests.methodWithoutFiguresTakesItsDefault()
    local state, api = make(20)
    Expect.yes(state:setMethod(api.Method.Triangles))
    Expect.equal(state:level(1):method(), api.Method.Triangles)
    Expect.yes(state:setMethod(api.Method.Triangles))
    Expect.equal(#state.undoSteps, 1)
end

function Tests.methodKeepsTheLevelWhereItIsKnown()
    local state, api = make(20)
    state:setAmount("0.6")
    api.queue:finish(state.mesh)
    state:setMethod(api.Method.Constant)
    Expect.equal(state:level(1):amount(), 300)
    state:setMethod(api.Method.Proportional)
    Expect.near(state:level(1):amount(), 0.6, 1e-6)
    state:setMethod(api.Method.Deviation)
    Expect.equal(state:level(1):amount(), 0.01)
end

function Tests.pasteNeedsACopyAndLeavesNoLevelBehind()
    local state = make(20)
    expectRefused(state, "no level was copied", state:pasteLevel("30"))
    Expect.equal(state:levelCount(), 1)
    state:setAmount("0.9")
    state:setMeshName("low.mesh")
    Expect.yes(state:copyLevel())
    Expect.refused("there is a level of value 20", state:pasteLevel("20"))
    Expect.yes(state:pasteLevel("30"))
    Expect.near(state:level(2):amount(), 0.9, 1e-6)
    Expect.equal(state:level(2):meshName(), "low.mesh")
end

function Tests.copyOutlivesItsLevelAndItsMesh()
    local state, api = make(20)
    state:copyLevel()
    state:deleteLevel()
    Expect.equal(state.selected, nil)
    Expect.refused("no level is selected", state:deleteLevel())
    Expect.refused("no level is selected", state:copyLevel())
    Expect.refused("no level is selected", state:setAmount("1"))
    state:chooseMesh(api.known[2])
    state:answer("discard")
    state:makeManual()
    Expect.yes(state:pasteLevel("5"))
end

function Tests.automaticLevelsCanBeCopied()
    local state, api = make()
    state:chooseMesh(api.known[2])
    Expect.yes(state:copyLevel())
    Expect.refused("make them manual", state:pasteLevel("5"))
end

function Tests.deleteSelectsTheNext()
    local state = make(10, 20, 30)
    state:select(2)
    state:deleteLevel()
    Expect.equal(state:level(state.selected):value(), 30)
    state:deleteLevel()
    Expect.equal(state:level(state.selected):value(), 10)
end

function Tests.makeManualIsOneStep()
    local state, api = make(5)
    Expect.refused("levels are manual", state:makeManual())
    state:setAutomatic(true)
    Expect.yes(state:makeManual())
    Expect.equal(state:levelCount(), 3)
    Expect.equal(state.definition:strategy(), api.Strategy.PixelCount)
    Expect.equal(state:level(1):method(), api.Method.CollapseCost)
    state:undo()
    Expect.yes(state.definition:isAutomatic())
    state:setAutomatic(false)
    Expect.equal(state:level(1):value(), 5)
end

function Tests.strategyTurnsValuesRoundAndBack()
    local state, api = make(20, 40, 400)
    state:select(2)
    local amounts = {}
    for index = 1, 3 do
        state:select(index)
        state:setAmount(index / 10)
        amounts[index] = state:level(index):amount()
    end
    Expect.yes(state:setStrategy(api.Strategy.PixelCount))
    for index = 1, 3 do
        Expect.equal(state:level(index):amount(), amounts[index])
    end
    Expect.yes(state:level(1):value() > state:level(2):value())
    Expect.equal(state.selected, 3)
    Expect.yes(state:setStrategy(api.Strategy.DistanceSphere))
    Expect.near(state:level(1):value(), 20, 0.1)
    Expect.near(state:level(3):value(), 400, 1)
end

function Tests.strategyKeepsCloseValuesApart()
    local values = {}
    for index = 1, 20 do
        values[index] = 50 + index * 1e-4
    end
    local state, api = make(unpack(values))
    Expect.yes(state:setStrategy(api.Strategy.PixelCount))
    Expect.equal(state:levelCount(), 20)
    for index = 2, 20 do
        Expect.yes(state:level(index):value() < state:level(index - 1):value())
    end
end

function Tests.distancesStayUnderTheOtherDistance()
    local state, api = make(20, 40)
    state:setStrategy(api.Strategy.DistanceBox)
    Expect.equal(state:level(2):value(), 40)
end

function Tests.handMadeMeshesAreThoseKnownAndThoseBeside()
    local state = make(20)
    Expect.equal(table.concat(state:handMadeMeshes(), " "), "cottage.mesh lowpoly.mesh tree.mesh")
    Expect.equal(table.concat(state:handMadeMeshes("o"), " "), "cottage.mesh lowpoly.mesh")
    Expect.refused("control characters", state:setMeshName("a\nb"))
    Expect.yes(state:setMeshName("lowpoly.mesh"))
    Expect.yes(state:setMeshName(""))
    Expect.no(state:isDirty())
end

return Tests
