local Expect = require("Expect")
local Hand = require("Hand")

local function open(sample)
    return require("ProgramSession").open():openSample(sample or "cottage")
end

local function readFile(path)
    local file = io.open(path)
    local text = file and file:read("*a")
    if file then
        file:close()
    end
    return text
end

local function writeFile(path, text)
    local file = assert(io.open(path, "w"))
    file:write(text)
    file:close()
end

local function loddef(session)
    return (session.path:gsub("mesh$", "loddef"))
end

local Tests = {}

function Tests.levelsAreMadeShownSavedAndReadAgain()
    local session = open()
    Expect.yes(session.state:levelCount() > 0)
    Hand.click(session.parts.Automatic, 0.05)
    session:settle()
    Expect.equal(session.state:levelCount(), 0)
    for _, value in ipairs({"20", "40", "80"}) do
        Hand.click(session.parts.Add)
        Hand.enter(session.parts.PromptValue, value)
        session:settle()
    end
    local before = session.state.info.triangles
    for index = 1, 3 do
        local row = session.state:row(index)
        Expect.yes(row.triangles > 0 and row.triangles < before, row.triangles)
        before = row.triangles
    end
    CEGUI.toScrollbar(session.parts.AmountSlider):setScrollPosition(950)
    session:frame()
    session:settle()
    Expect.near(session.state:row(3).amount, 0.95, 1e-6)
    local triangles = session.state:row(3).triangles
    Hand.click(session.parts.Save)
    session:frame()
    Expect.equal(session:message(), "Saved " .. loddef(session))
    Expect.no(session.state:isDirty())
    Expect.yes(readFile(loddef(session)):find("0.95", 1, true))
    Hand.click(session.parts.Reload)
    session:frame()
    session:settle()
    Expect.equal(session.state:levelCount(), 3)
    Expect.equal(session.state:row(3).triangles, triangles)
    Expect.no(session.state:isDirty())
end

function Tests.automaticLevelsBecomeManualOnes()
    local session = open()
    local values, triangles = {}, {}
    for index, row in ipairs(session.state:rows()) do
        values[index], triangles[index] = row.value, row.triangles
    end
    Expect.yes(#values > 1)
    Hand.click(session.parts.MakeManual)
    session:settle()
    Expect.equal(session.state.definition:levelCount(), #values)
    for index, row in ipairs(session.state:rows()) do
        Expect.near(row.value, values[index], values[index] * 1e-5)
        Expect.near(row.triangles, triangles[index], triangles[index] * 0.1) -- fewer stops on the way
    end
    Hand.click(session.parts.Undo)
    session:settle()
    Expect.no(session.state:isDirty())
end

function Tests.everyReasonIsThere()
    local session = open()
    Expect.refused("automatic", session.state:addLevel("10"))
    session.state:makeManual()
    session.state:setStrategy(session.api.Strategy.DistanceSphere)
    session:settle()
    local state = session.state
    local count, text = state:levelCount(), state.definition:text()
    state:select(1)
    local value = tostring(state:level(2):value())
    for _, refused in ipairs({
        {state:addLevel(value)}, {state:addLevel("0")}, {state:addLevel("-5")}, {state:addLevel("2e18")},
        {state:addLevel("ten")}, {state:setValue(value)}, {state:setValue("0")}, {state:setAmount("-1")},
        {state:setStrategy(99)}, {state:setMethod(99)}, {state:setType(99)}, {state:setMeshName(("x"):rep(2000))},
        {state:pasteLevel("5")},
    }) do
        Expect.equal(refused[1], nil)
        Expect.yes(#refused[2] > 5 and not refused[2]:find("\n"), refused[2])
    end
    Expect.equal(state:levelCount(), count)
    Expect.equal(state.definition:text(), text)
end

function Tests.methodsHaveTheirRanges()
    local session = open()
    local state, Method = session.state, session.api.Method
    state:setAutomatic(false)
    state:addLevel("30")
    session:settle()
    Expect.yes(state:setMethod(Method.Constant))
    Expect.near(state:level(1):amount(), 0.5 * state.info.uniqueVertices, 1)
    session:settle()
    Expect.yes(state:setMethod(Method.Triangles))
    Expect.equal(state:level(1):amount(), state:row(1).triangles)
    Expect.equal(state:setAmount("10.5"), nil)
    Expect.yes(state:setMethod(Method.Deviation))
    Expect.yes(state:setAmount("0.05"))
    session:settle()
    Expect.yes(state:row(1).bound <= 0.05 + 1e-6)
    Expect.yes(state:setMethod(Method.Proportional))
    Expect.equal(state:setAmount("1.01"), nil)
end

function Tests.missingHandMadeMeshIsSaid()
    local session = open()
    session.state:setAutomatic(false)
    session.state:addLevel("30")
    session:settle()
    Expect.yes(session.state:setMeshName("absent.mesh"))
    session:settle()
    Expect.equal(session.state.message.kind, "error")
    Expect.yes(session:message():find("absent.mesh", 1, true), session:message())
    Expect.yes(session.state:undo())
    session:settle()
    Expect.yes(session.state:row(1).triangles > 0)
end

function Tests.brokenDefinitionIsSaid()
    local session = open()
    local other = takeSample("lantern")
    writeFile((other:gsub("mesh$", "loddef")), "<lod><automatic enabled=\"perhaps\"/></lod>")
    local opened, message = session.panel:openMesh(other)
    Expect.refused("perhaps", opened, message)
    Expect.equal(session.state.mesh:name(), "cottage.mesh")
end

function Tests.brokenMeshIsSaid()
    local session = open()
    writeFile(directory .. "/broken.mesh", "this is no mesh")
    Expect.equal(session.panel:openMesh(directory .. "/broken.mesh"), nil)
    Expect.equal(session.panel:openMesh(directory .. "/absent.mesh"), nil)
    Expect.equal(session.state.message.kind, "error")
    Expect.equal(session.state.mesh:name(), "cottage.mesh")
end

function Tests.discardedLevelsGiveWayToTheFiles()
    local session = open()
    session.state:setAutomatic(false)
    session.state:addLevel("30")
    session:settle()
    session.state:save()
    local triangles = session.state:row(1).triangles
    session.state:setAmount("0.95")
    session:settle()
    local cottage = session.state.mesh
    Expect.yes(session.state:row(1).triangles < triangles)
    Expect.equal(session.panel:openMesh(takeSample("lantern")), "asked")
    session.state:answer("discard")
    session:settle()
    session:wait("the cottage's levels", function()
        return not session.api.queue:isQueued(cottage)
    end)
    Expect.equal(cottage:triangles(1), triangles)
end

function Tests.aStreamOfEditsEndsWithItsLast()
    local session = open("drake")
    session.state:setAutomatic(false)
    session.state:addLevel("30")
    for position = 300, 900, 20 do
        CEGUI.toScrollbar(session.parts.AmountSlider):setScrollPosition(position)
        ogreFrame()
        session:frame()
    end
    session:settle()
    Expect.near(session.state:row(1).amount, 0.9, 1e-6)
    local share = session.state:row(1).triangles / session.state.info.triangles
    Expect.yes(share < 0.15, share)
end

function Tests.levelsAreMeasuredAndTheCurveIsThere()
    local session = open("lantern")
    Expect.yes(session.api.analysis)
    session:wait("the measurement of the levels", function()
        local row = session.state:row(1)
        return row and row.measured and session.state.curve
    end)
    local row = session.state:row(1)
    Expect.yes(row.measured.maximum >= row.measured.mean)
    Expect.yes(#session.state.curve > 3)
    Expect.yes(session.parts.LevelFigures:getText():find("Off: mean", 1, true))
end

function Tests.directoriesAreListed()
    local session = open()
    Hand.click(session.parts.Open)
    Expect.equal(session.parts.Path:getText(), directory)
    Expect.equal(CEGUI.toListbox(session.parts.Files):getListboxItemFromIndex(0):getText(), "cottage.mesh")
    Hand.enter(session.parts.Path, directory .. "/absent")
    Expect.yes(session.parts.FileError:getText() ~= "")
    Hand.key(CEGUI.Key.Escape)
    Expect.no(session.parts.FileDialog:isVisible())
end

function Tests.levelsThatAreNotSavedGoWithThePanel()
    local session = open()
    session.state:setAutomatic(false)
    session.state:addLevel("30")
    session:settle()
    session.state:save()
    local triangles = session.state:row(1).triangles
    session.state:setAmount("0.95")
    session:settle()
    local cottage = session.state.mesh
    Expect.yes(cottage:triangles(1) < triangles)
    session.panel:close()
    session:wait("the file's levels", function()
        return not session.api.queue:isQueued(cottage)
    end)
    Expect.equal(cottage:triangles(1), triangles)
end

return Tests
