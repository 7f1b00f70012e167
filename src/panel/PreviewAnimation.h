#pragma once

#include <string>
#include <vector>

namespace Ogre {
class AnimationState;
class Entity;
} // namespace Ogre

namespace lodsmith {

/// Plays one animation of an entity. Keeps nothing of the entity, whose states OGRE may make anew at any time.
class PreviewAnimation {
public:
    static std::vector<std::string> namesOf(const Ogre::Entity* entity);

    /// From the start; empty for none.
    void play(const std::string& name);
    const std::string& name() const { return mName; }
    void setSpeed(float speed);
    bool isMoving() const { return !mName.empty() && mSpeed != 0; }

    /// Moves on, and gives the entity its pose. Returns whether there is something to see of it.
    bool advance(Ogre::Entity& entity, float seconds);

private:
    std::string mName;
    double mTime = 0; ///< seconds
    float mSpeed = 1;
};

} // namespace lodsmith
