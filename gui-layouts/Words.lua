-- What the constants of lodsmith are called on screen. No CEGUI in here.

local Words = {}

-- Lists of {constant, name}; short: for narrow columns; unit: of a level's value; hint: of its amount.
function Words.of(api)
    local Type, Strategy, Method, ViewMode, CompareMode =
        api.Type, api.Strategy, api.Method, api.ViewMode, api.CompareMode
    return {
        types = {
            {Type.Automatic, "Automatic reduction"},
            {Type.User, "Hand-made meshes"},
        },
        strategies = {
            {Strategy.DistanceSphere, "Distance to the sphere", label = "From distance"},
            {Strategy.DistanceBox, "Distance to the box", label = "From distance"},
            {Strategy.PixelCount, "Pixel count", label = "Below pixels"},
            {Strategy.ScreenRatioPixelCount, "Share of the screen", label = "Below share"},
        },
        methods = {
            {Method.Proportional, "Share removed", short = "share", hint = "0 to 1, of the vertices"},
            {Method.Constant, "Vertices removed", short = "vertices", hint = "of %d vertices", of = "uniqueVertices"},
            {Method.Triangles, "Triangles left", short = "triangles", hint = "of %d triangles", of = "triangles"},
            {Method.Deviation, "Largest deviation", short = "deviation", hint = "in world units"},
            {Method.CollapseCost, "Largest collapse cost", short = "cost", hint = "in world units"},
        },
        viewModes = ViewMode and {
            {ViewMode.Shaded, "Shaded"},
            {ViewMode.Flat, "Flat"},
            {ViewMode.Wireframe, "Wireframe"},
            {ViewMode.Checker, "UV checker"},
            {ViewMode.Deviation, "Deviation"},
        } or {},
        compareModes = CompareMode and {
            {CompareMode.Off, "Single view"},
            {CompareMode.SideBySide, "Side by side"},
            {CompareMode.Wipe, "Wipe"},
        } or {},
    }
end

function Words.find(list, constant)
    for index, entry in ipairs(list) do
        if entry[1] == constant then
            return entry, index
        end
    end
    return nil
end

function Words.names(list)
    local names = {}
    for index, entry in ipairs(list) do
        names[index] = entry[2]
    end
    return names
end

return Words
