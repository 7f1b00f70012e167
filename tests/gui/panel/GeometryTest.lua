local Expect = require("Expect")

-- What the skins' edit boxes have around the text, at the most.
local EDITBOX_MARGIN = 5
-- CEGUI rounds places and sizes one by one.
local ROUNDING = 1
local SIZES = {{1024, 768}, {1280, 1024}, {1920, 1080}, {2560, 1440}}

local function resize(width, height)
    CEGUI.System:getSingleton():notifyDisplaySizeChanged(CEGUI.Sizef(width, height))
end

-- Left, top, right and bottom; a combobox without its list.
local function areaOf(window)
    local area = window:getUnclippedOuterRect():get()
    local bottom = area:bottom()
    if window:getType():find("Combobox", 1, true) then
        bottom = area:top() + CEGUI.toCombobox(window):getEditbox():getPixelSize().height
    end
    return area:left(), area:top(), area:right(), bottom
end

local function overlap(a, b)
    local left, top, right, bottom = areaOf(a)
    local otherLeft, otherTop, otherRight, otherBottom = areaOf(b)
    return left < otherRight - ROUNDING and otherLeft < right - ROUNDING and top < otherBottom - ROUNDING
        and otherTop < bottom - ROUNDING
end

local function childrenOf(window)
    local children = {}
    for index = 0, window:getChildCount() - 1 do
        local child = window:getChildAtIdx(index)
        -- What lies over the preview lets the mouse through, and so does the mark of the keyboard.
        if child:getName():sub(1, 2) ~= "__" and child:isVisible() and not child:isMousePassThroughEnabled() then
            table.insert(children, child)
        end
    end
    return children
end

local function checkChildren(window, what)
    local children = childrenOf(window)
    local left, top, right, bottom = areaOf(window)
    for index, child in ipairs(children) do
        local childLeft, childTop, childRight, childBottom = areaOf(child)
        Expect.yes(childLeft >= left - 1 and childTop >= top - 1 and childRight <= right + 1 and childBottom <= bottom + 1,
            what .. ": " .. child:getName() .. " sticks out of " .. window:getName())
        Expect.yes(childRight - childLeft > 4 and childBottom - childTop > 4, what .. ": no room for " .. child:getName())
        for other = index + 1, #children do
            Expect.no(overlap(child, children[other])
                and what .. ": " .. child:getName() .. " and " .. children[other]:getName())
        end
        checkChildren(child, what)
    end
end

-- Texts of buttons and of labels that are one line.
local function checkTexts(parts, what)
    local font = CEGUI.FontManager:getSingleton():get("DejaVuSans-10-NoScale")
    for name, window in pairs(parts) do
        local isLabel = window:getType():find("StaticText", 1, true)
            and window:getProperty("HorzFormatting") == "LeftAligned" and name ~= "Message"
        if window:isEffectiveVisible() and (isLabel or window:getType():find("Button", 1, true)) then
            local needed = font:getTextExtent(window:getText(), 1)
            Expect.yes(needed <= window:getPixelSize().width, what .. ": " .. name .. " is cut: " .. window:getText())
        end
    end
end

-- Whatever is chosen in a combobox.
local function checkChoices(parts, what)
    local font = CEGUI.FontManager:getSingleton():get("DejaVuSans-10-NoScale")
    for name, window in pairs(parts) do
        if window:getType():find("Combobox", 1, true) then
            local combobox = CEGUI.toCombobox(window)
            local room = combobox:getEditbox():getPixelSize().width - 2 * EDITBOX_MARGIN
            for index = 0, combobox:getItemCount() - 1 do
                local text = combobox:getListboxItemFromIndex(index):getText()
                Expect.yes(font:getTextExtent(text, 1) <= room, what .. ": " .. name .. " is cut: " .. text)
            end
        end
    end
end

-- What the list of levels says, and what its columns are called.
local function checkCells(list, what)
    local font = CEGUI.FontManager:getSingleton():get("DejaVuSans-10-NoScale")
    for column = 0, list:getColumnCount() - 1 do
        local room = list:getHeaderSegmentForColumn(column):getPixelSize().width
        local texts = {list:getHeaderSegmentForColumn(column):getText()}
        for row = 0, list:getRowCount() - 1 do
            table.insert(texts, list:getItemAtGridReference(CEGUI.MCLGridRef(row, column)):getText())
        end
        for _, text in ipairs(texts) do
            Expect.yes(font:getTextExtent(text, 1) <= room - 4, what .. ": cut in the list: " .. text)
        end
    end
end

local function open(options)
    local session = require("PanelSession").open(options):withLevels(20, 50)
    session.state:setAmount("0.6")
    session:finish()
    session:frame(1)
    session.api.finishJobs()
    session:frame()
    return session
end

local Tests = {}

function Tests.nothingOverlapsAndNothingIsCut()
    local session = open()
    for _, size in ipairs(SIZES) do
        resize(size[1], size[2])
        session:frame()
        local what = ("%d x %d"):format(size[1], size[2])
        checkChildren(session.panel.root, what)
        checkTexts(session.parts, what)
        checkChoices(session.parts, what)
        checkCells(CEGUI.toMultiColumnList(session.parts.LevelList), what)
    end
end

function Tests.dialogsFit()
    local session = open()
    resize(1024, 768)
    session.panel:askForFile()
    for _, dialog in ipairs(session.panel.dialogs) do
        dialog.window:setVisible(true)
        checkChildren(dialog.window, dialog.window:getName())
        checkTexts(dialog.parts, dialog.window:getName())
        dialog.window:setVisible(false)
    end
end

function Tests.smallestWindowHasRoomForAll()
    local session = open({fill = false})
    local window = session.panel.window
    Expect.equal(window:getPixelSize().width, 940)
    Expect.equal(window:getPixelSize().height, 700)
    window:setSize(CEGUI.USize(CEGUI.UDim(0, 10), CEGUI.UDim(0, 10)))
    session.state:setMethod(session.api.Method.Deviation)
    session.state:setAmount("0.000720397")
    session.state:setValue("20.12345")
    session:finish()
    session:frame()
    Expect.equal(window:getPixelSize().width, 940)
    checkChildren(session.panel.root, "smallest window")
    checkTexts(session.parts, "smallest window")
    checkChoices(session.parts, "smallest window")
    checkCells(CEGUI.toMultiColumnList(session.parts.LevelList), "smallest window")
    Expect.equal(session.parts.Amount:getText(), "0.000720397")
end

function Tests.windowIsNoLargerThanWhatItIsIn()
    resize(800, 600)
    local session = open({fill = false})
    local size = session.panel.window:getPixelSize()
    Expect.equal(size.width, 800)
    Expect.equal(size.height, 600)
end

function Tests.titlesHaveThePanelsFont()
    local fonts = CEGUI.FontManager:getSingleton()
    fonts:createFromFile("DejaVuSans-12-NoScale.font")
    CEGUI.System:getSingleton():getDefaultGUIContext():setDefaultFont("DejaVuSans-12-NoScale")
    local session = open({fill = false})
    for _, window in ipairs({session.panel.window, session.parts.Prompt}) do
        Expect.equal(window:getChild("__auto_titlebar__"):getProperty("Font"), "DejaVuSans-10-NoScale")
    end
end

return Tests
