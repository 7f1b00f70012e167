-- An artist's hand: mouse and keys, through the doors by which a program hands them to CEGUI.

local Hand = {}

local LEFT = 0

local function context()
    return CEGUI.System:getSingleton():getDefaultGUIContext()
end

local function areaOf(window)
    return window:getUnclippedOuterRect():get()
end

-- A place in a window: shares of its width and height, 0.5 for the middle.
function Hand.point(window, x, y)
    local area = areaOf(window)
    local right, down = area:getWidth() * (x or 0.5), area:getHeight() * (y or 0.5)
    context():injectMousePosition(area:left() + right, area:top() + down)
end

function Hand.down(button)
    context():injectMouseButtonDown(button or LEFT)
end

function Hand.up(button)
    context():injectMouseButtonUp(button or LEFT)
end

function Hand.click(window, x, y)
    Hand.point(window, x, y)
    Hand.down()
    Hand.up()
end

function Hand.drag(window, fromX, fromY, toX, toY, button)
    Hand.point(window, fromX, fromY)
    Hand.down(button)
    Hand.point(window, toX, toY)
    Hand.up(button)
end

function Hand.wheel(change)
    context():injectMouseWheelChange(change)
end

-- modifiers: "control", "shift"
function Hand.key(key, ...)
    local held = {}
    for _, modifier in ipairs({...}) do
        table.insert(held, modifier == "control" and CEGUI.Key.LeftControl or CEGUI.Key.LeftShift)
    end
    for _, modifier in ipairs(held) do
        context():injectKeyDown(modifier)
    end
    context():injectKeyDown(key)
    context():injectKeyUp(key)
    for _, modifier in ipairs(held) do
        context():injectKeyUp(modifier)
    end
end

function Hand.type(text)
    for index = 1, #text do
        context():injectChar(text:byte(index))
    end
end

-- Types into a box in the place of what is in it, without Enter.
function Hand.replace(window, text)
    Hand.click(window)
    Hand.key(CEGUI.Key.A, "control")
    CEGUI.toEditbox(window):setSelection(0, #window:getText())
    Hand.key(CEGUI.Key.Delete)
    Hand.type(text)
end

function Hand.enter(window, text)
    Hand.replace(window, text)
    Hand.key(CEGUI.Key.Return)
end

-- Chooses an entry of a combobox by its text, with the mouse.
function Hand.chooseIn(window, text)
    local combobox = CEGUI.toCombobox(window)
    Hand.click(combobox:getPushButton())
    local list = combobox:getDropList()
    local item = combobox:findItemWithText(text, nil)
    if not item then
        error("no entry " .. text, 2)
    end
    CEGUI.toListbox(list):ensureItemIsVisible(item)
    local index, area = combobox:getItemIndex(item), areaOf(list)
    local rowHeight = item:getPixelSize().height
    local inner = CEGUI.toListbox(list):getListRenderArea()
    local scrolled = CEGUI.toListbox(list):getVertScrollbar():getScrollPosition()
    context():injectMousePosition(area:left() + inner:left() + 10,
        area:top() + inner:top() + rowHeight * (index + 0.5) - scrolled)
    Hand.down()
    Hand.up()
end

-- Clicks the index-th row of a Listbox or MultiColumnList.
function Hand.clickRow(list, index)
    local area, inner = areaOf(list), list:getListRenderArea()
    local item = list.getItemAtGridReference and list:getItemAtGridReference(CEGUI.MCLGridRef(0, 0))
        or list:getListboxItemFromIndex(0)
    local height = list.getHighestRowItemHeight and list:getHighestRowItemHeight(0) or item:getPixelSize().height
    context():injectMousePosition(area:left() + inner:left() + 10, area:top() + inner:top() + height * (index - 0.5))
    Hand.down()
    Hand.up()
end

return Hand
