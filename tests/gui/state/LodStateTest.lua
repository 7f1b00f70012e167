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
    Expect.yes(state:chooseMesh(api.known[1]))
    return state, api
end

local Tests = {}

function Tests.meshWithoutADefinitionIsAutomatic()
    local state, api = make()
    Expect.yes(state:chooseMesh(api.known[2]))
    Expect.yes(state.definition:isAutomatic())
    Expect.equal(state:levelCount(), 3)
    Expect.equal(state.selected, 1)
    Expect.no(state:isDirty())
    Expect.refused("make them manual first", state:addLevel("5"))
    Expect.refused("make them manual first", state:deleteLevel())
    Expect.refused("make them manual first", state:setAmount("0.5"))
end

function Tests.levelsAreNearestFirstWhateverTheFilesOrder()
    local state = make(90, 20, 50)
    Expect.equal(state:level(1):value(), 20)
    Expect.equal(state:level(3):value(), 90)
    Expect.no(state:isDirty())
end

function Tests.meshesAreFilteredWithoutCase()
    local state = make()
    Expect.equal(#state:meshes(), 3)
    Expect.equal(#state:meshes("CAST"), 1)
    Expect.equal(#state:meshes("[a"), 0)
end

function Tests.undoBackToTheSavedIsClean()
    local state = make(20, 50)
    Expect.yes(state:setAmount("0.8"))
    Expect.yes(state:addLevel("70"))
    Expect.yes(state:isDirty())
    Expect.yes(state:undo())
    Expect.yes(state:undo())
    Expect.no(state:isDirty())
    Expect.refused("nothing to undo", state:undo())
    Expect.yes(state:redo())
    Expect.yes(state:redo())
    Expect.equal(state:levelCount(), 3)
    Expect.refused("nothing to redo", state:redo())
end

function Tests.savingMovesWhatIsClean()
    local state = make(20)
    state:setAmount("0.8")
    Expect.yes(state:save())
    Expect.no(state:isDirty())
    state:undo()
    Expect.yes(state:isDirty())
    state:redo()
    Expect.no(state:isDirty())
end

function Tests.newEditForgetsRedo()
    local state = make(20)
    state:setAmount("0.8")
    state:undo()
    state:setAmount("0.7")
    Expect.refused("nothing to redo", state:redo())
end

function Tests.editThatChangesNothingIsNoStep()
    local state = make(20)
    Expect.yes(state:setAmount("0.5"))
    Expect.no(state:canUndo())
end

function Tests.gestureIsOneStep()
    local state = make(20)
    for step = 1, 20 do
        state:setAmount(step / 20, "slider")
    end
    state:endGesture()
    state:setAmount(0.3, "slider")
    state:undo()
    Expect.equal(state:level(1):amount(), 1)
    state:undo()
    Expect.equal(state:level(1):amount(), 0.5)
end

function Tests.gestureBackToItsBeginningIsNoStep()
    local state = make(20)
    state:setAmount(0.9, "slider")
    state:setAmount(0.5, "slider")
    state:endGesture()
    Expect.no(state:canUndo())
end

function Tests.undoHasALimit()
    local state = make(20)
    for step = 1, 300 do
        state:setAmount(step / 1000)
    end
    local steps = 0
    while state:undo() do
        steps = steps + 1
    end
    Expect.equal(steps, 200)
end

function Tests.unsavedChangesAskBeforeAnotherMesh()
    local state, api = make(20)
    local asked
    state:on("question", function(question) asked = question end)
    state:setAmount("0.8")
    Expect.equal(state:chooseMesh(api.known[2]), "asked")
    Expect.equal(table.concat(asked.answers, " "), "save discard cancel")
    Expect.yes(asked.text:find("castle.mesh", 1, true))
    Expect.yes(state:answer("cancel"))
    Expect.yes(state.mesh:equals(api.known[1]))
    Expect.yes(state:isDirty())
    state:chooseMesh(api.known[2])
    Expect.yes(state:answer("save"))
    Expect.yes(state.mesh:equals(api.known[2]))
    Expect.equal(api.files["castle.mesh"]:level(1):amount(), 0.8)
end

function Tests.discardedLevelsGiveWayToTheFiles()
    local state, api = make(20)
    state:setAmount("0.8")
    state:chooseMesh(api.known[2])
    Expect.yes(state:answer("discard"))
    Expect.equal(api.files["castle.mesh"]:level(1):amount(), 0.5)
    Expect.yes(api.applied[#api.applied].mesh:equals(api.known[1]))
    Expect.no(state:isDirty())
end

function Tests.failedSaveKeepsTheMeshThatIsEdited()
    local state, api = make(20)
    state:setAmount("0.8")
    api.diskIsFull = true
    state:chooseMesh(api.known[2])
    Expect.refused("no space is left", state:answer("save"))
    Expect.yes(state.mesh:equals(api.known[1]))
    Expect.yes(state:isDirty())
    Expect.refused("nothing was asked", state:answer("save"))
end

function Tests.leavingAsksToo()
    local state = make(20)
    local left = 0
    local function leave()
        left = left + 1
        return true
    end
    state:afterSaving("", leave)
    Expect.equal(left, 1)
    state:setAmount("0.8")
    state:afterSaving("", leave)
    Expect.equal(left, 1)
    state:answer("discard")
    Expect.equal(left, 2)
end

function Tests.brokenFileLeavesWhatIsEdited()
    local state, api = make(20)
    api.files["tree.mesh"] = "line 3: unknown word 'nearly'"
    Expect.refused("line 3", state:chooseMesh(api.known[3]))
    Expect.yes(state.mesh:equals(api.known[1]))
    api.known[2].broken = true
    Expect.refused("broken", state:chooseMesh(api.known[2]))
    api.known[2].gone = true
    Expect.refused("gone", state:chooseMesh(api.known[2]))
    Expect.refused("no such file", state:openMesh("/nowhere/x.mesh"))
    Expect.yes(state.mesh:equals(api.known[1]))
end

function Tests.brokenFileIsNoReload()
    local state, api = make(20)
    api.files["castle.mesh"] = "line 1: no root"
    Expect.refused("line 1", state:reload())
    Expect.equal(state:levelCount(), 1)
end

function Tests.reloadReadsAgainAndGeneratesAgain()
    local state, api = make(20)
    api.files["castle.mesh"]:addLevel(40)
    Expect.yes(state:reload())
    Expect.equal(state:levelCount(), 2)
    Expect.equal(#api.applied, 1)
    state:setAmount("0.9")
    Expect.equal(state:reload(), "asked")
    state:answer("cancel")
    Expect.yes(state:isDirty())
    state:reload()
    state:answer("discard")
    Expect.no(state:isDirty())
end

function Tests.meshThatGoesIsLetGo()
    local state, api = make(20)
    api.known[1].gone = true
    state:update(0.1)
    Expect.equal(state.mesh, nil)
    Expect.equal(state.message.text, "The mesh is gone")
    Expect.refused("no mesh is chosen", state:save())
    Expect.refused("no mesh is chosen", state:addLevel("1"))
    Expect.refused("no mesh is chosen", state:setStrategy(1))
    Expect.refused("no mesh is chosen", state:reload())
    Expect.refused("no mesh is chosen", state:cancelGeneration())
end

function Tests.editsAreGeneratedNewestFirst()
    local state, api = make(20)
    for step = 1, 9 do
        state:setAmount(step / 10)
    end
    Expect.equal(#api.applied, 1)
    api.queue:finish(state.mesh)
    state:update(0.01)
    Expect.equal(#api.applied, 2)
    Expect.near(api.applied[2].definition:level(1):amount(), 0.9, 1e-6)
end

function Tests.laterEditsDoNotReachWhatIsQueued()
    local state, api = make(20)
    state:setAmount("0.1")
    state:setAmount("0.2")
    Expect.near(api.applied[1].definition:level(1):amount(), 0.1, 1e-6)
end

function Tests.failedGenerationIsSaid()
    local state, api = make(20)
    state:setAmount("0.1")
    api.queue:progress(state.mesh, 0.5)
    Expect.equal(state.progress, 0.5)
    api.queue:fail(state.mesh, "no memory")
    Expect.equal(state.message.text, "no memory")
    Expect.equal(state.progress, nil)
    Expect.no(state:isGenerating())
end

function Tests.cancelKeepsTheDefinition()
    local state = make(20)
    state:setAmount("0.1")
    Expect.yes(state:isGenerating())
    Expect.yes(state:cancelGeneration())
    Expect.no(state:isGenerating())
    Expect.near(state:level(1):amount(), 0.1, 1e-6)
end

function Tests.refusedDefinitionIsSaidAndCanBeUndone()
    local state, api = make(20)
    api.refusal = "entities are alive"
    state:setMeshName("low.mesh")
    Expect.equal(state.message.text, "entities are alive")
    Expect.equal(state.message.kind, "error")
    api.refusal = nil
    Expect.yes(state:undo())
    Expect.no(state:isDirty())
end

function Tests.signalsOfOtherMeshesChangeNothing()
    local state, api = make(20)
    local figures = 0
    state:on("figures", function() figures = figures + 1 end)
    api.queue.waiting[api.known[2]] = api.newDefinition()
    api.queue:progress(api.known[2], 0.7)
    api.queue:finish(api.known[2])
    Expect.equal(figures, 0)
    Expect.equal(state.progress, nil)
end

function Tests.closedStateHearsNothing()
    local state, api = make(20)
    state:setAmount("0.4")
    state:close()
    local message = state.message
    api.queue:finish(api.known[1])
    Expect.equal(state.message, message)
end

function Tests.closingTakesUnsavedLevelsBack()
    local state, api = make(20)
    state:setAmount("0.4")
    api.queue:finish(state.mesh)
    state:close()
    Expect.equal(#api.applied, 2)
    Expect.yes(api.applied[2].mesh:equals(api.known[1]))
    Expect.yes(api.applied[2].definition:isAutomatic())
end

function Tests.closingCutsGenerationOff()
    local state, api = make(20)
    state:setAmount("0.4")
    state:setAmount("0.5001")
    local cancelled = 0
    local cancel = api.queue.cancel
    api.queue.cancel = function(...)
        cancelled = cancelled + 1
        return cancel(...)
    end
    state:close()
    Expect.equal(cancelled, 1)
    Expect.equal(#api.applied, 2)
    Expect.yes(api.applied[2].definition:isAutomatic())
end

function Tests.closingLeavesSavedLevels()
    local state, api = make(20)
    state:setAmount("0.4")
    api.queue:finish(state.mesh)
    state:save()
    state:close()
    Expect.equal(#api.applied, 1)
end

function Tests.cutOffUndoDoesNotLeaveWhatWasUndone()
    local state, api = make(20)
    state:setAmount("0.4")
    api.queue:finish(state.mesh)
    state:undo()
    Expect.yes(state:chooseMesh(api.known[2]))
    Expect.equal(#api.applied, 3)
    Expect.yes(api.applied[3].mesh:equals(api.known[1]))
end

function Tests.chosenIsToldOnceTheMeshIsEdited()
    local state, api = make(20)
    local told = {}
    local function chosen(mesh)
        Expect.yes(state.mesh:equals(mesh))
        table.insert(told, mesh:name())
    end
    state:setAmount("0.8")
    Expect.equal(state:openMesh("/fake/tree.mesh", chosen), "asked")
    state:answer("cancel")
    Expect.equal(#told, 0)
    api.known[3].broken = true
    state:openMesh("/fake/tree.mesh", chosen)
    Expect.refused("broken", state:answer("discard"))
    Expect.equal(#told, 0)
    api.known[3].broken = nil
    state:openMesh("/fake/tree.mesh", chosen)
    state:answer("discard")
    state:openMesh("/fake/tree.mesh", chosen)
    state:openDirectory("/fake", chosen)
    Expect.equal(table.concat(told, " "), "tree.mesh tree.mesh cottage.mesh")
end

function Tests.meshThatComesFromNoFileIsEditedAndNotSaved()
    local state, api = make(20)
    api.known[2].isMade = true
    Expect.yes(state:chooseMesh(api.known[2]))
    Expect.yes(state.definition:isAutomatic())
    Expect.yes(state:makeManual())
    Expect.yes(state:setAmount("0.02"))
    Expect.yes(api.applied[1].mesh:equals(api.known[2]))
    Expect.refused("not saved: cottage.mesh comes from no file", state:save())
    Expect.yes(state:isDirty())
    state:reload()
    Expect.yes(state:answer("discard"))
    Expect.no(state:isDirty())
end

function Tests.whatAnotherProgramHasSavedIsNotReplacedUnasked()
    local state, api = make(20)
    Expect.yes(state:setAmount("0.7"))
    local others = state.definition:copy()
    others:addLevel(90)
    api.files["castle.mesh"] = others
    Expect.refused("changed by another program", state:save())
    Expect.yes(state:isDirty())
    Expect.equal(api.files["castle.mesh"]:levelCount(), 2)
    Expect.yes(state:save())
    Expect.equal(api.files["castle.mesh"]:levelCount(), 1)
    Expect.yes(state:setAmount("0.8"))
    Expect.yes(state:save())
end

return Tests
