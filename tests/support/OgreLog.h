#pragma once

#include <OgreLog.h>
#include <OgreLogManager.h>

#include <string>
#include <vector>

namespace lodsmith::test {

/// Everything that OGRE's log gets while this object lives.
class OgreLog : private Ogre::LogListener {
public:
    OgreLog() { Ogre::LogManager::getSingleton().getDefaultLog()->addListener(this); }
    ~OgreLog() override { Ogre::LogManager::getSingleton().getDefaultLog()->removeListener(this); }
    OgreLog(const OgreLog&) = delete;
    OgreLog& operator=(const OgreLog&) = delete;

    const std::vector<std::string>& lines() const { return mLines; }

private:
    void messageLogged(const Ogre::String& message, Ogre::LogMessageLevel, bool, const Ogre::String&, bool&) override
    {
        mLines.push_back(message);
    }

    std::vector<std::string> mLines;
};

} // namespace lodsmith::test
