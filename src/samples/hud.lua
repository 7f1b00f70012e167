-- The game's own script: a line in the corner of its window.

local hud = CEGUI.WindowManager:getSingleton():createWindow("TaharezLook/StaticText", "Hud")
hud:setProperty("Area", "{{0,8},{0.96,0},{1,-8},{1,0}}")
hud:setProperty("FrameEnabled", "false")
hud:setProperty("BackgroundEnabled", "false")
hud:setProperty("MousePassThroughEnabled", "true")
CEGUI.System:getSingleton():getDefaultGUIContext():getRootWindow():addChild(hud)

-- The game calls it now and then.
function showFigures(framesPerSecond, triangles)
    hud:setText(("F1: levels of detail   F2: halt   %.0f frames/s   %d triangles"):format(framesPerSecond, triangles))
end
