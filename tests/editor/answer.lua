-- Answers what a test asks: runs each question (a file that the test writes) and writes its value beside it.
local directory = os.getenv("LODSMITH_TEST_DIRECTORY")
local question = 0

local function value(text)
    local chunk, message = loadstring("return " .. text)
    if not chunk then
        return "error: " .. message
    end
    local ok, result = pcall(chunk)
    return (ok and "" or "error: ") .. tostring(result)
end

--- The place of a window that can be seen: "left top right bottom", in pixels.
function screenAreaOf(name)
    local function find(window)
        if not window:isVisible() then
            return nil
        end
        if window:getName() == name then
            return window
        end
        for i = window:getChildCount() - 1, 0, -1 do
            local found = find(window:getChildAtIdx(i))
            if found then
                return found
            end
        end
        return nil
    end
    local window = find(CEGUI.System:getSingleton():getDefaultGUIContext():getRootWindow())
    return window and areaOf(window) or "none"
end

--- As screenAreaOf(), for a CEGUI window.
function areaOf(window)
    local area = window:getUnclippedOuterRect():get()
    return string.format("%d %d %d %d", area:left(), area:top(), area:right(), area:bottom())
end

while true do
    local path = directory .. "/question" .. question
    local file = io.open(path)
    if file then
        local text = file:read("*a")
        file:close()
        local answer = io.open(path .. ".part", "w")
        answer:write(value(text))
        answer:close()
        os.rename(path .. ".part", path .. ".answer")
        question = question + 1
    end
    coroutine.yield()
end
