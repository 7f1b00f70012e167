-- What lists, marks and messages need to know of the skin that the host has chosen.

local Skin = {}

-- CEGUI draws a selection with an image of the skin. Colours are ARGB.
local DARK = {text = "FFFFFFFF", dim = "FFA0A8B0", error = "FFFF7068", selection = "FF3A5A9A", focus = "FFFFC840"}
local LIGHT = {text = "FF000000", dim = "FF505050", error = "FFB00000", selection = "FFA8C4F4", focus = "FFD06000"}
local SKINS = {
    TaharezLook = {DARK, brush = "TaharezLook/MultiListSelectionBrush"},
    WindowsLook = {LIGHT, brush = "WindowsLook/Background"},
    OgreTray = {LIGHT, brush = "OgreTrayImages/GenericBrush"},
}

-- The skin of a window that was made for one of the panel's layouts.
function Skin.of(window)
    local name = window:getLookNFeel():match("^([^/]*)/") or ""
    local known = SKINS[name] or {DARK}
    local skin = {name = name}
    for key, colour in pairs(known[1]) do
        skin[key] = colour
    end
    if known.brush and CEGUI.ImageManager:getSingleton():isDefined(known.brush) then
        skin.brush = known.brush
    end
    return skin
end

return Skin
