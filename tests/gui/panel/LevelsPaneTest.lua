local Expect = require("Expect")
local Hand = require("Hand")

local function open(...)
    return require("PanelSession").open():withLevels(...)
end

local function cell(session, row, column)
    local list = CEGUI.toMultiColumnList(session.parts.LevelList)
    return list:getItemAtGridReference(CEGUI.MCLGridRef(row - 1, column - 1)):getText()
end

local Tests = {}

function Tests.listShowsLevelsNearestFirst()
    local session = open(50, 20)
    Expect.equal(cell(session, 1, 1), "20")
    Expect.equal(cell(session, 2, 1), "50")
    Expect.equal(cell(session, 1, 4), "-")
    session.state:setAmount("0.7")
    session:finish()
    Expect.equal(cell(session, 1, 3), "0.7")
    Expect.equal(cell(session, 1, 4), "500")
    Expect.equal(cell(session, 2, 4), "250")
    Expect.equal(cell(session, 1, 6), "<= 0.01")
end

function Tests.measuredDeviationTakesTheBoundsPlace()
    local session = open(20)
    session.state:setAmount("0.7")
    session:finish()
    session:frame(0.4)
    session.api.finishJobs()
    session:frame()
    Expect.equal(cell(session, 1, 6), "0.008")
end

function Tests.clickOnARowSelects()
    local session = open(20, 50, 90)
    Hand.clickRow(CEGUI.toMultiColumnList(session.parts.LevelList), 3)
    session:frame()
    Expect.equal(session.state.selected, 3)
    Expect.equal(session.parts.Value:getText(), "90")
end

function Tests.addAsksAndAddsWhatWasTyped()
    local session = open(20)
    Hand.click(session.parts.Add)
    Expect.yes(session.parts.Prompt:isVisible())
    Expect.equal(session.parts.PromptValue:getText(), "40")
    Hand.enter(session.parts.PromptValue, "33")
    session:frame()
    Expect.no(session.parts.Prompt:isVisible())
    Expect.equal(cell(session, 2, 1), "33")
    Expect.equal(session.state.selected, 2)
end

function Tests.addSaysWhatIsWrongBesideTheBox()
    local session = open(20)
    Hand.click(session.parts.Add)
    for text, reason in pairs({
        ["far"] = "'far' is not a number", [""] = "a number is needed", ["20"] = "there is a level of value 20",
        ["-1"] = "above 0", ["0x10"] = "'0x10' is not a number", ["nan"] = "not a number", ["1e999"] = "not a number",
    }) do
        Hand.enter(session.parts.PromptValue, text)
        Expect.yes(session.parts.Prompt:isVisible(), text)
        Expect.yes(session.parts.PromptError:getText():find(reason, 1, true), session.parts.PromptError:getText())
    end
    Expect.equal(session.state:levelCount(), 1)
    Hand.click(session.parts.Dismiss)
    Expect.no(session.parts.Prompt:isVisible())
    Expect.no(session.state:isDirty())
end

function Tests.pasteBeforeCopySaysSo()
    local session = open(20)
    Expect.yes(session.parts.Paste:isDisabled())
    session.panel.keyboard:focus(session.parts.LevelList)
    Hand.key(CEGUI.Key.V, "control")
    Expect.equal(session:message(), "no level was copied")
    Expect.no(session.parts.Prompt:isVisible())
    Expect.equal(session.state:levelCount(), 1)
end

function Tests.copyAndPaste()
    local session = open(20, 50)
    session.state:setAmount("0.25")
    session:frame()
    Hand.click(session.parts.Copy)
    session:frame()
    Hand.click(session.parts.Paste)
    Hand.enter(session.parts.PromptValue, "80")
    session:frame()
    Expect.equal(cell(session, 3, 1), "80")
    Expect.equal(cell(session, 3, 3), "0.25")
end

function Tests.deleteTakesTheSelectedLevel()
    local session = open(20, 50)
    Hand.clickRow(CEGUI.toMultiColumnList(session.parts.LevelList), 2)
    session:frame()
    Hand.click(session.parts.Delete)
    session:frame()
    Expect.equal(session.state:levelCount(), 1)
    Expect.equal(cell(session, 1, 1), "20")
    Hand.click(session.parts.Delete)
    session:frame()
    Expect.equal(CEGUI.toMultiColumnList(session.parts.LevelList):getRowCount(), 0)
    Expect.yes(session.parts.Delete:isDisabled())
end

function Tests.automaticLevelsAreShownAndNotEdited()
    local session = require("PanelSession").open()
    session.panel:chooseMesh(session.api.known[2])
    session:frame()
    Expect.equal(cell(session, 1, 1), "200000")
    Expect.yes(session.parts.Add:isDisabled())
    Expect.yes(session.parts.Delete:isDisabled())
    Expect.yes(session.parts.Value:isDisabled())
    Expect.yes(session.parts.LevelTitle:getText():find("automatic", 1, true))
end

function Tests.addIsPossibleWhereTheSuggestedValueIsNot()
    local session = open(1e18)
    Hand.click(session.parts.Add)
    Expect.yes(session.parts.Prompt:isVisible())
    Expect.yes(session.parts.PromptError:getText() ~= "")
    Hand.enter(session.parts.PromptValue, "30")
    session:frame()
    Expect.no(session.parts.Prompt:isVisible())
    Expect.equal(session.state:levelCount(), 2)
end

function Tests.addSaysWhyAutomaticLevelsHaveNoPlace()
    local session = open(20)
    session.state:setAutomatic(true)
    session.panel.keyboard:focus(session.parts.LevelList)
    Hand.key(CEGUI.Key.Insert)
    Expect.no(session.parts.Prompt:isVisible())
    Expect.yes(session:message():find("make them manual first", 1, true))
end

return Tests
