local Expect = require("Expect")
local Hand = require("Hand")

local function open()
    local session = require("PanelSession").open():withLevels(20, 50)
    session.state:setAmount("0.6")
    session:finish()
    return session
end

local Tests = {}

function Tests.textureIsAsLargeAsTheWidget()
    local session = open()
    local size = session.parts.PreviewImage:getPixelSize()
    Expect.equal(session.preview.width, math.floor(size.width))
    Expect.equal(session.preview.height, math.floor(size.height))
    Expect.yes(size.width > 400 and size.height > 300)
end

function Tests.mouseTurnsMovesAndZooms()
    local session = open()
    local image = session.parts.PreviewImage
    Hand.drag(image, 0.5, 0.5, 0.6, 0.5)
    Expect.equal(#session.preview.orbits, 1)
    Expect.near(session.preview.orbits[1][1], image:getPixelSize().width * 0.1, 1)
    Hand.drag(image, 0.5, 0.5, 0.5, 0.7, 1)
    Hand.drag(image, 0.5, 0.5, 0.5, 0.7, 2)
    Expect.equal(#session.preview.pans, 2)
    Hand.point(image, 0.1, 0.1)
    Expect.equal(#session.preview.orbits, 1)
    Hand.wheel(2)
    Expect.equal(session.preview.zooms, 2)
end

function Tests.viewModes()
    local session = open()
    Hand.chooseIn(session.parts.ViewMode, "Wireframe")
    session:frame()
    Expect.equal(session.preview.viewMode, session.api.ViewMode.Wireframe)
    session.preview.refusal = "no texture coordinates"
    Hand.chooseIn(session.parts.ViewMode, "UV checker")
    session:frame()
    Expect.equal(session:message(), "no texture coordinates")
    Expect.equal(session.parts.ViewMode:getText(), "Wireframe")
end

function Tests.heatMapSaysWhatRedIs()
    local session = open()
    Hand.chooseIn(session.parts.ViewMode, "Deviation")
    session:frame()
    Expect.equal(session.parts.LegendText:getText(), "Measuring ...")
    session.preview.scale = 0.25
    session:frame()
    Expect.equal(session.parts.LegendText:getText(), "0 to 0.25 and more")
    Hand.chooseIn(session.parts.ViewMode, "Shaded")
    session:frame()
    Expect.no(session.parts.Legend:isVisible())
end

function Tests.whatAModeCannotShowIsSaid()
    local session = open()
    session.preview.remark = "the mesh has no texture coordinates"
    session:frame()
    Expect.equal(session.parts.PreviewNote:getText(), "the mesh has no texture coordinates")
end

function Tests.levelIsForced()
    local session = open()
    Expect.equal(session.preview.level, nil)
    Hand.chooseIn(session.parts.ShownLevel, "Selected")
    session:frame()
    Expect.equal(session.preview.level, 1)
    session.state:select(2)
    session:frame()
    Expect.equal(session.preview.level, 2)
    Hand.chooseIn(session.parts.ShownLevel, "The mesh")
    session:frame()
    Expect.equal(session.preview.level, 0)
    Expect.yes(session.parts.PreviewFigures:getText():find("321 triangles", 1, true))
    Hand.chooseIn(session.parts.ShownLevel, "By camera")
    session:frame()
    Expect.equal(session.preview.level, nil)
end

function Tests.comparisonAndItsSplit()
    local session = open()
    Hand.chooseIn(session.parts.CompareMode, "Wipe")
    session:frame()
    Expect.yes(session.parts.Split:isVisible())
    Expect.equal(session.preview.compared.mode, session.api.CompareMode.Wipe)
    Expect.equal(session.preview.compared.a, 0)
    Expect.equal(session.preview.compared.b, 1)
    Expect.yes(session.parts.ShownLevel:isDisabled())
    Hand.chooseIn(session.parts.CompareB, "Level 2")
    Hand.drag(session.parts.PreviewImage, 0.5, 0.5, 0.25, 0.5)
    session:frame()
    Expect.equal(session.preview.compared.b, 2)
    Expect.near(session.preview.compared.share, 0.25, 0.01)
    Expect.equal(#session.preview.orbits, 0)
    Hand.drag(session.parts.PreviewImage, 0.5, 0.5, 0.6, 0.5)
    Expect.equal(#session.preview.orbits, 1)
    Hand.chooseIn(session.parts.CompareMode, "Single view")
    session:frame()
    Expect.equal(session.preview.compared.mode, session.api.CompareMode.Off)
    Expect.no(session.parts.Split:isVisible())
end

function Tests.scriptsChooseWhatIsShown()
    local session = open()
    local pane, Mode = session.panel.previewPane, session.api.CompareMode
    for level, forced in pairs({[0] = 0, [2] = 2, selected = 1}) do
        pane:showLevel(level)
        session:frame()
        Expect.equal(session.preview.level, forced)
    end
    pane:showLevel(nil)
    pane:compareLevels(Mode.SideBySide, 1, 2)
    session:frame()
    Expect.equal(session.preview.compared.mode, Mode.SideBySide)
    Expect.equal(session.preview.compared.a, 1)
    Expect.equal(session.preview.compared.b, 2)
    Expect.equal(session.parts.CompareB:getText(), "Level 2")
    pane:compareLevels(Mode.Off)
    session:frame()
    Expect.equal(session.preview.level, nil)
end

function Tests.viewAtSwitchDistance()
    local session = open()
    session.state:select(2)
    session:frame()
    Hand.click(session.parts.SwitchDistance)
    Expect.equal(session.preview.viewedAt[1], session.api.Strategy.DistanceSphere)
    Expect.equal(session.preview.viewedAt[2], 50)
end

function Tests.animationsPlay()
    local session = open()
    Hand.chooseIn(session.parts.Animation, "run")
    session:frame()
    Expect.equal(session.preview.played, "run")
    Hand.chooseIn(session.parts.Animation, "At rest")
    session:frame()
    Expect.equal(session.preview.played, nil)
end

function Tests.keysTurnThePreview()
    local session = open()
    session.panel.keyboard:focus(session.parts.PreviewImage)
    Hand.key(CEGUI.Key.ArrowLeft)
    Hand.key(CEGUI.Key.PageUp)
    Hand.key(CEGUI.Key.Home)
    Expect.equal(#session.preview.orbits, 1)
    Expect.equal(session.preview.zooms, 1)
    Expect.equal(session.preview.resets, 2)
end

function Tests.graphHasTheLevelsAsMarks()
    local session = open()
    session:frame(0.5)
    session.api.finishJobs()
    session:frame()
    Expect.equal(#session.graph.curve, 31)
    Expect.equal(#session.graph.markers, 2)
    Expect.equal(#session.graph.upright, 4)
    for _, point in ipairs(session.graph.curve) do
        Expect.yes(point[1] >= 0 and point[1] <= 1 and point[2] >= 0 and point[2] <= 1)
    end
    local mark = session.panel.graphPane.marks[2]
    local size = session.parts.Graph:getPixelSize()
    Hand.click(session.parts.Graph, (7 + mark.x * (size.width - 14)) / size.width,
        1 - (7 + mark.y * (size.height - 14)) / size.height)
    session:frame()
    Expect.equal(session.state.selected, 2)
end

function Tests.panelWorksWithoutAPreview()
    local session = require("PanelSession").open({noPreview = true}):withLevels(20)
    Expect.yes(session.parts.ViewMode:isDisabled())
    Expect.yes(session.parts.PreviewNote:getText():find("no preview", 1, true))
    Hand.key(CEGUI.Key.D, "control")
    Hand.drag(session.parts.PreviewImage, 0.5, 0.5, 0.6, 0.5)
    Hand.wheel(1)
    session:frame()
    Expect.equal(session.parts.Value:getText(), "20")
end

function Tests.dragEndsWhenTheMouseIsTakenAway()
    local session = open()
    local image = session.parts.PreviewImage
    for _, takeAway in ipairs({
        function() image:releaseInput() end,
        function() session.parts.LevelList:activate() end,
    }) do
        Hand.point(image, 0.5, 0.5)
        Hand.down()
        takeAway()
        Hand.point(image, 0.7, 0.5)
        Hand.up()
        Expect.equal(#session.preview.orbits, 0)
    end
    Hand.drag(image, 0.5, 0.5, 0.6, 0.5)
    Expect.equal(#session.preview.orbits, 1)
end

function Tests.graphsOfTwoPanelsHaveTwoNames()
    local session = open()
    local name = session.graphName
    session.panel:close()
    Expect.yes(open().graphName ~= name)
end

function Tests.panelWorksWithoutAGraphAndSaysWhy()
    local session = require("PanelSession").open({graphError = "no memory"})
    Expect.equal(session:message(), "There is no graph: no memory")
    session:withLevels(20)
    Hand.click(session.parts.Graph)
    Expect.equal(session.state:levelCount(), 1)
end

return Tests
