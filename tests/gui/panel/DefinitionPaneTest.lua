local Expect = require("Expect")
local Hand = require("Hand")

local function open(...)
    return require("PanelSession").open():withLevels(...)
end

local Tests = {}

function Tests.checkboxTurnsAutomaticLevelsOffAndOn()
    local session = require("PanelSession").open()
    session.panel:chooseMesh(session.api.known[1])
    session:frame()
    Expect.yes(CEGUI.toToggleButton(session.parts.Automatic):isSelected())
    Hand.click(session.parts.Automatic, 0.05)
    session:frame()
    Expect.no(session.state.definition:isAutomatic())
    Expect.no(session.parts.Add:isDisabled())
    Hand.click(session.parts.Automatic, 0.05)
    session:frame()
    Expect.yes(session.state.definition:isAutomatic())
    Expect.no(session.state:isDirty())
end

function Tests.makeManualTakesTheAutomaticLevelsOver()
    local session = require("PanelSession").open()
    session.panel:chooseMesh(session.api.known[1])
    session:frame()
    Hand.click(session.parts.MakeManual)
    session:frame()
    Expect.equal(session.state.definition:levelCount(), 3)
    Expect.equal(session.parts.Value:getText(), "200000")
    Expect.equal(session.parts.Save:getText(), "Save *")
end

function Tests.amountBoxChangesTheLevelAndTheSlider()
    local session = open(20)
    Hand.enter(session.parts.Amount, "0.75")
    session:frame()
    Expect.near(session.state:level(1):amount(), 0.75, 1e-6)
    Expect.near(CEGUI.toScrollbar(session.parts.AmountSlider):getScrollPosition(), 750, 1)
end

function Tests.sliderChangesTheLevelAndTheBoxOnce()
    local session = open(20)
    local before = #session.api.applied
    CEGUI.toScrollbar(session.parts.AmountSlider):setScrollPosition(300)
    session:frame()
    Expect.near(session.state:level(1):amount(), 0.3, 1e-6)
    Expect.equal(session.parts.Amount:getText(), "0.3")
    session:frame()
    session:frame()
    Expect.equal(#session.api.applied, before + 1)
    Expect.equal(CEGUI.toScrollbar(session.parts.AmountSlider):getScrollPosition(), 300)
end

function Tests.sliderDragIsOneStepOfUndo()
    local session = open(20)
    for position = 510, 900, 10 do
        CEGUI.toScrollbar(session.parts.AmountSlider):setScrollPosition(position)
        session:frame()
    end
    session:frame(1)
    CEGUI.toScrollbar(session.parts.AmountSlider):setScrollPosition(100)
    session:frame()
    Expect.equal(#session.state.undoSteps, 2)
    Hand.click(session.parts.Undo)
    session:frame()
    Expect.near(session.state:level(1):amount(), 0.9, 1e-6)
    Hand.click(session.parts.Undo)
    session:frame()
    Expect.near(session.state:level(1):amount(), 0.5, 1e-6)
    Expect.yes(session.parts.Undo:isDisabled())
    Hand.click(session.parts.Redo)
    session:frame()
    Expect.near(session.state:level(1):amount(), 0.9, 1e-6)
end

function Tests.mouseDragsTheThumb()
    local session = open(20)
    local thumb = session.parts.AmountSlider:getChild("__auto_thumb__")
    local context = CEGUI.System:getSingleton():getDefaultGUIContext()
    Hand.point(thumb)
    Hand.down()
    local generated = 0
    for _ = 1, 10 do
        context:injectMouseMove(6, 0)
        session:frame(0.6)
        if session.api.queue:isQueued(session.state.mesh) then
            session:finish()
            generated = generated + 1
        end
    end
    Hand.up()
    Expect.yes(session.state:level(1):amount() > 0.6, session.state:level(1):amount())
    Expect.yes(generated > 5, generated)
    Expect.equal(#session.state.undoSteps, 1)
end

function Tests.badAmountIsMarkedWhileItIsTyped()
    local session = open(20)
    Hand.replace(session.parts.Amount, "most")
    Expect.equal(session.parts.LevelError:getText(), "'most' is not a number")
    Hand.replace(session.parts.Amount, "1.5")
    Expect.equal(session.parts.LevelError:getText(), "a share of vertices is at most 1")
    Hand.key(CEGUI.Key.Return)
    session:frame()
    Expect.equal(session.parts.Amount:getText(), "1.5")
    Expect.no(session.state:isDirty())
    Hand.key(CEGUI.Key.Escape)
    session:frame()
    Expect.equal(session.parts.Amount:getText(), "0.5")
    Expect.equal(session.parts.LevelError:getText(), "0 to 1, of the vertices")
end

function Tests.badValueIsMarkedAndNothingIsLost()
    local session = open(20, 50)
    Hand.enter(session.parts.Value, "50")
    Expect.equal(session.parts.LevelError:getText(), "there is a level of value 50")
    Expect.equal(session.state:level(1):value(), 20)
    Hand.enter(session.parts.Value, "70")
    session:frame()
    Expect.equal(session.state:level(2):value(), 70)
    Expect.equal(session.state.selected, 2)
end

function Tests.leavingABoxTakesWhatWasTyped()
    local session = open(20)
    Hand.replace(session.parts.Amount, "0.125")
    Hand.click(session.parts.Value)
    session:frame()
    Expect.near(session.state:level(1):amount(), 0.125, 1e-6)
end

function Tests.halfTypedTextOutlivesNewFigures()
    local session = open(20)
    session.state:setAmount("0.6")
    session:frame()
    Hand.replace(session.parts.Amount, "0.")
    session:finish()
    Expect.equal(session.parts.Amount:getText(), "0.")
end

function Tests.methodKeepsWhatTheLevelIs()
    local session = open(20)
    session.state:setAmount("0.6")
    session:finish()
    Hand.chooseIn(session.parts.Method, "Vertices removed")
    session:frame()
    Expect.equal(session.state:level(1):method(), session.api.Method.Constant)
    Expect.equal(session.parts.Amount:getText(), "300")
    Hand.chooseIn(session.parts.Method, "Triangles left")
    session:frame()
    Expect.equal(session.parts.Amount:getText(), "500")
    Expect.equal(session.parts.LevelError:getText(), "of 1000 triangles")
end

function Tests.strategyConvertsValues()
    local session = open(20, 50)
    Hand.chooseIn(session.parts.Strategy, "Pixel count")
    session:frame()
    Expect.equal(session.state.definition:strategy(), session.api.Strategy.PixelCount)
    Expect.yes(session.state:level(1):value() > session.state:level(2):value())
    Expect.equal(session.parts.ValueLabel:getText(), "Below pixels")
end

function Tests.typeForHandMadeMeshesAsksForThem()
    local session = open(20)
    Hand.chooseIn(session.parts.Type, "Hand-made meshes")
    session:frame()
    Expect.equal(session:message(), "level 1: a user-made level needs a mesh")
    Hand.click(session.parts.Save)
    session:frame()
    Expect.yes(session:message():find("not saved: level 1", 1, true), session:message())
    Hand.clickRow(CEGUI.toListbox(session.parts.HandMadeList), 2)
    session:frame()
    Expect.equal(session.state:level(1):meshName(), "cottage.mesh")
    Hand.click(session.parts.Save)
    session:frame()
    Expect.yes(session:message():find("Saved", 1, true), session:message())
end

function Tests.handMadeListIsFiltered()
    local session = open(20)
    Hand.replace(session.parts.HandMadeFilter, "LOW")
    session:frame()
    local list = CEGUI.toListbox(session.parts.HandMadeList)
    Expect.equal(list:getItemCount(), 2)
    Expect.equal(list:getListboxItemFromIndex(1):getText(), "lowpoly.mesh")
end

function Tests.missingHandMadeMeshIsSaidAndKept()
    local session = open(20)
    session.api.refusal = "there is no mesh 'gone.mesh'"
    session.state:setMeshName("gone.mesh")
    session:frame()
    Expect.equal(session:message(), "there is no mesh 'gone.mesh'")
    Expect.equal(session.state:level(1):meshName(), "gone.mesh")
    Expect.equal(CEGUI.toListbox(session.parts.HandMadeList):getListboxItemFromIndex(1):getText(), "gone.mesh")
    Hand.click(session.parts.Undo)
    session:frame()
    Expect.equal(session.state:level(1):meshName(), "")
end

function Tests.saveAndReload()
    local session = open(20)
    Hand.enter(session.parts.Amount, "0.9")
    session:frame()
    Expect.equal(session.parts.Save:getText(), "Save *")
    Hand.click(session.parts.Save)
    session:frame()
    Expect.equal(session.parts.Save:getText(), "Save")
    Expect.near(session.api.files["castle.mesh"]:level(1):amount(), 0.9, 1e-6)
    session.api.files["castle.mesh"]:level(1):setAmount(0.1)
    Hand.click(session.parts.Reload)
    session:frame()
    Expect.equal(session.parts.Amount:getText(), "0.1")
end

function Tests.savingTakesWhatIsTypedFirst()
    local session = open(20)
    Hand.replace(session.parts.Amount, "0.7")
    Hand.key(CEGUI.Key.S, "control")
    Expect.near(session.api.files["castle.mesh"]:level(1):amount(), 0.7, 1e-6)
    Hand.replace(session.parts.Amount, "much")
    Hand.key(CEGUI.Key.S, "control")
    Expect.equal(session:message(), "not saved: 'much' is not a number")
end

function Tests.fullDiskIsSaidAndTheChangesStay()
    local session = open(20)
    session.api.diskIsFull = true
    Hand.enter(session.parts.Amount, "0.9")
    Hand.click(session.parts.Save)
    session:frame()
    Expect.equal(session:message(), "not saved: no space is left")
    Expect.yes(session.state:isDirty())
end

function Tests.reloadAsksWhenChangesWouldBeLost()
    local session = open(20)
    Hand.enter(session.parts.Amount, "0.9")
    session:frame()
    Hand.click(session.parts.Reload)
    Expect.yes(session.parts.Question:isVisible())
    Expect.equal(session.parts.First:getText(), "Discard")
    Expect.no(session.parts.Third:isVisible())
    Hand.click(session.parts.Second)
    session:frame()
    Expect.near(session.state:level(1):amount(), 0.9, 1e-6)
    Hand.click(session.parts.Reload)
    Hand.click(session.parts.First)
    session:frame()
    Expect.near(session.state:level(1):amount(), 0.5, 1e-6)
end

function Tests.nothingIsToBeDoneWithoutAMesh()
    local session = require("PanelSession").open()
    for _, name in ipairs({"Save", "Reload", "Undo", "Redo", "Automatic", "MakeManual", "Type", "Strategy", "Value",
        "Method", "Amount", "AmountSlider", "HandMadeList", "Add", "Delete", "Copy", "Paste", "LevelList"}) do
        Expect.yes(session.parts[name]:isDisabled(), name)
    end
    Expect.equal(session.parts.LevelTitle:getText(), "No level is selected")
end

function Tests.sliderReadsNoDirectory()
    local session = require("PanelSession").open():withLevels(20)
    local reads, list = 0, session.api.listDirectory
    session.api.listDirectory = function(...)
        reads = reads + 1
        return list(...)
    end
    for position = 100, 900, 100 do
        CEGUI.toScrollbar(session.parts.AmountSlider):setScrollPosition(position)
        session:frame()
    end
    Expect.equal(reads, 0)
    Hand.replace(session.parts.HandMadeFilter, "l")
    session:frame()
    Expect.equal(reads, 1)
    session.state:answer(session.panel:chooseMesh(session.api.known[2]) == "asked" and "discard")
    session:frame()
    Expect.equal(reads, 2)
end

return Tests
