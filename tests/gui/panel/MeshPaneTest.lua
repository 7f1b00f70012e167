local Expect = require("Expect")
local Hand = require("Hand")

local function open(options)
    return require("PanelSession").open(options)
end

local Tests = {}

function Tests.listAndFilter()
    local session = open()
    local list = CEGUI.toListbox(session.parts.MeshList)
    Expect.equal(list:getItemCount(), 3)
    Hand.replace(session.parts.MeshFilter, "co")
    session:frame()
    Expect.equal(list:getItemCount(), 1)
    Expect.equal(list:getListboxItemFromIndex(0):getText(), "cottage.mesh")
end

function Tests.clickChooses()
    local session = open()
    Hand.clickRow(CEGUI.toListbox(session.parts.MeshList), 3)
    session:frame()
    Expect.equal(session.state.mesh:name(), "tree.mesh")
    Expect.equal(session.preview.shownMesh:name(), "tree.mesh")
    Expect.yes(session.parts.Info:getText():find("500 unique vertices", 1, true))
    Expect.yes(session.parts.Info:getText():find("Stone", 1, true))
end

function Tests.newMeshesAppear()
    local session = open()
    table.insert(session.api.known, require("FakeLodsmith").mesh("zeppelin.mesh"))
    session:frame(1.1)
    Expect.equal(CEGUI.toListbox(session.parts.MeshList):getItemCount(), 4)
end

function Tests.brokenMeshIsSaidAndTheListShowsWhatIsEdited()
    local session = open():withLevels(20)
    session.api.known[2].broken = true
    Hand.clickRow(CEGUI.toListbox(session.parts.MeshList), 2)
    session:frame()
    Expect.equal(session:message(), "cottage.mesh is broken")
    Expect.equal(session.state.mesh:name(), "castle.mesh")
    Expect.yes(CEGUI.toListbox(session.parts.MeshList):getListboxItemFromIndex(0):isSelected())
end

function Tests.unsavedChangesAsk()
    local session = open():withLevels(20)
    session.state:setAmount("0.9")
    session:frame()
    Hand.clickRow(CEGUI.toListbox(session.parts.MeshList), 2)
    Expect.yes(session.parts.Question:isVisible())
    Expect.yes(session.parts.QuestionText:getText():find("castle.mesh", 1, true))
    Hand.key(CEGUI.Key.Escape)
    session:frame()
    Expect.no(session.parts.Question:isVisible())
    Expect.equal(session.state.mesh:name(), "castle.mesh")
    Expect.yes(session.state:isDirty())
    Hand.clickRow(CEGUI.toListbox(session.parts.MeshList), 2)
    Hand.click(session.parts.First)
    session:frame()
    Expect.equal(session.state.mesh:name(), "cottage.mesh")
    Expect.near(session.api.files["castle.mesh"]:level(1):amount(), 0.9, 1e-6)
end

function Tests.meshThatGoesLeavesAnEmptyPanel()
    local session = open():withLevels(20)
    session.api.known[1].gone = true
    table.remove(session.api.known, 1)
    session:frame()
    Expect.equal(session:message(), "The mesh is gone")
    Expect.equal(session.preview.shownMesh, nil)
    Expect.yes(session.parts.Save:isDisabled())
    Expect.equal(CEGUI.toMultiColumnList(session.parts.LevelList):getRowCount(), 0)
end

function Tests.fileDialogWalksAndOpens()
    local opened
    local session = open({host = {
        canOpen = true,
        recentFiles = function() return {"/old/tree.mesh"} end,
        opened = function(path) opened = path end,
    }})
    Hand.click(session.parts.Open)
    Expect.yes(session.parts.FileDialog:isVisible())
    local files = CEGUI.toListbox(session.parts.Files)
    Expect.equal(files:getListboxItemFromIndex(0):getText(), "models/")
    Hand.key(CEGUI.Key.Return)
    Expect.equal(session.parts.Path:getText(), "/fake/models")
    Hand.click(session.parts.Up)
    Expect.equal(session.parts.Path:getText(), "/fake")
    Hand.enter(session.parts.Path, "/nowhere")
    Expect.equal(session.parts.FileError:getText(), "/nowhere: no such directory")
    Hand.enter(session.parts.Path, "/fake/absent.mesh")
    Expect.yes(session.parts.FileError:getText():find("no such file", 1, true))
    Expect.yes(session.parts.FileDialog:isVisible())
    Hand.enter(session.parts.Path, "/fake")
    Hand.clickRow(files, 3)
    Hand.click(session.parts.OpenFile)
    session:frame()
    Expect.no(session.parts.FileDialog:isVisible())
    Expect.equal(session.state.mesh:name(), "cottage.mesh")
    Expect.equal(opened, "/fake/cottage.mesh")
end

function Tests.openingAsksForUnsavedChangesAndKeysWorkOn()
    local session = open():withLevels(20)
    session.state:setAmount("0.9")
    Hand.click(session.parts.Open)
    Hand.clickRow(CEGUI.toListbox(session.parts.Files), 3)
    Hand.key(CEGUI.Key.Return)
    Expect.no(session.parts.FileDialog:isVisible())
    Expect.yes(session.parts.Question:isVisible())
    Hand.key(CEGUI.Key.Escape)
    Expect.no(session.parts.Question:isVisible())
    Expect.equal(session.state.mesh:name(), "castle.mesh")
    Hand.key(CEGUI.Key.Z, "control")
    Expect.no(session.state:isDirty())
    Hand.key(CEGUI.Key.Tab)
    Expect.yes(session.panel.keyboard:focused())
end

function Tests.recentFilesOpen()
    local session = open({host = {canOpen = true, recentFiles = function() return {"/old/tree.mesh"} end}})
    Hand.key(CEGUI.Key.O, "control")
    Expect.yes(session.parts.FileDialog:isVisible())
    Hand.clickRow(CEGUI.toListbox(session.parts.Recent), 1)
    Hand.click(session.parts.OpenFile)
    session:frame()
    Expect.equal(session.state.mesh:name(), "tree.mesh")
end

function Tests.hostWithoutFilesHasNoOpen()
    local session = open({host = {}})
    Expect.no(session.parts.Open:isVisible())
    Hand.key(CEGUI.Key.O, "control")
    Expect.no(session.parts.FileDialog:isVisible())
end

function Tests.openedFilesAreToldWhenTheyAreEdited()
    local opened = {}
    local session = open({host = {canOpen = true, opened = function(path) table.insert(opened, path) end}})
    session:withLevels(20)
    session.state:setAmount("0.9")
    Expect.equal(session.panel:openMesh("tree.mesh"), "asked")
    Hand.key(CEGUI.Key.Escape)
    Expect.equal(#opened, 0)
    session.panel:openMesh("tree.mesh")
    Hand.click(session.parts.First)
    session.panel:open("/fake")
    session.api.known[3].isMade = true
    session.panel:openMesh("tree.mesh")
    Expect.equal(table.concat(opened, " "), "/fake/tree.mesh /fake/cottage.mesh")
end

return Tests
