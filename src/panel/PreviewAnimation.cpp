#include "PreviewAnimation.h"

#include <OgreAnimationState.h>
#include <OgreEntity.h>

#include <cmath>

namespace lodsmith {

std::vector<std::string> PreviewAnimation::namesOf(const Ogre::Entity* entity)
{
    std::vector<std::string> names;
    if (entity && entity->getAllAnimationStates())
        for (const auto& [name, state] : entity->getAllAnimationStates()->getAnimationStates())
            names.push_back(name);
    return names;
}

void PreviewAnimation::play(const std::string& name)
{
    mName = name;
    mTime = 0;
}

void PreviewAnimation::setSpeed(float speed)
{
    mSpeed = std::isfinite(speed) ? speed : 1.0f;
}

bool PreviewAnimation::advance(Ogre::Entity& entity, float seconds)
{
    if (!entity.getAllAnimationStates())
        return false;
    const double step = static_cast<double>(seconds) * static_cast<double>(mSpeed);
    bool isMoving = false;
    for (const auto& [name, state] : entity.getAllAnimationStates()->getAnimationStates()) {
        const bool plays = name == mName;
        isMoving = isMoving || plays != state->getEnabled() || (plays && step != 0);
        state->setEnabled(plays);
        if (!plays)
            continue;
        const auto length = static_cast<double>(state->getLength());
        mTime = length > 0 ? std::fmod(mTime + step, length) : 0.0;
        state->setLoop(true);
        state->setTimePosition(static_cast<float>(mTime < 0 ? mTime + length : mTime));
    }
    return isMoving;
}

} // namespace lodsmith
