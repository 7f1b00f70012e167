-- What lodsmith's packages want of tolua++ beyond what it does by itself. include/lodsmith/lua/Binding.h is the other half.

-- Types of arguments and results that are no classes: tolua_isNAME(), tolua_toNAME() and tolua_pushNAME() convert them.
local function addBasicType(type, name, passedAs)
    _basic[type] = name
    _basic_ctype[name] = passedAs or type
end
addBasicType("Text", "text")
addBasicType("Function", "function")
addBasicType("OptionalNumber", "optionalnumber")
addBasicType("OptionalText", "optionaltext")
addBasicType("Items", "items")
addBasicType("Returned", "returned", "Returned&&")

-- Arguments that are handles are looked at more closely than tolua++ does.
function get_is_function()
    return "lodsmith::lua::isHandle"
end

-- Handles are made by factories. Without constructor or destructor tolua++ would think that malloc() made them.
function classClass:requirecollection(collected)
    collected[self.type] = "tolua_collect_" .. clean_template(self.type)
    return true
end

-- All bound functions go through one template, which knows what becomes of exceptions and results.
function pre_call_hook()
    output("  return lodsmith::lua::call(tolua_S, [&] {\n")
end

function post_call_hook()
    output("  });\n")
end
