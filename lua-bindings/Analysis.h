#pragma once

#include "Services.h"

#include <lodsmith/ogre/LevelAnalyser.h>

namespace lodsmith::lua {

/// Figures from the background.
class Analysis final : public ServiceHandle {
public:
    explicit Analysis(const std::shared_ptr<Services>& services);

    Returned measure(const Mesh& mesh, double level, const Function& function) const;
    Returned curve(const Mesh& mesh, const Definition& definition, double points, const Function& function) const;
};

/// A request to Analysis; it is cancelled when this is collected.
class Job final : public Handle {
public:
    explicit Job(LevelAnalyser::JobPtr job);

    Returned fraction() const { return mJob->fraction(); }
    Returned isRunning() const { return mJob->isRunning(); }
    Returned cancel();

private:
    LevelAnalyser::JobPtr mJob;
};

} // namespace lodsmith::lua
