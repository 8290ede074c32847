package rigibo.backend.force;

import rigibo.backend.effect.Wind;

/**
 * The acceleration k·w(t) that a varying wind w(t) adds to linear drag. The drag itself is part of
 * the path.
 */
final class GustForce implements ChangingForce {

    private final Wind wind;

    GustForce(Wind wind) {
        this.wind = wind;
    }

    @Override
    public void add(Instant at) {
        double blown = at.drag * wind.gusts().at(at.time);
        at.accelerationX += blown * wind.x();
        at.accelerationY += blown * wind.y();
    }
}
