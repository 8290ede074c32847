package rigibo.lab.hardcase;

import rigibo.backend.RigidBody;
import rigibo.backend.effect.Gravity;
import rigibo.backend.setup.BodyType;

import java.util.List;

/**
 * The balance of energy and momentum over one step, from the state of the bodies.
 *
 * <p>Gains are shares of E0: the largest of the energy at the start, the kinetic energy since, and
 * the energy that lifts every body by its own radius. The last serves scenes at rest at the height
 * 0.
 */
final class Balance {

    private final Gravity gravity;
    private double kinetic;
    private double potential;
    private double momentumX;
    private double momentumY;
    private double mass;
    private double allMomentum;
    private double lift;
    private double scale;
    private double gain;
    private double lost;

    Balance(Gravity gravity) {
        this.gravity = gravity;
    }

    void restart() {
        scale = 0;
    }

    /**
     * Begins a step.
     *
     * @param springs energy in springs, J, which counts as that of height
     */
    void begin(List<RigidBody> bodies, double springs) {
        sum(bodies);
        potential += springs;
        double start = scale == 0 ? Math.abs(kinetic + potential) : 0;
        scale = Math.max(Math.max(scale, start), Math.max(kinetic, lift));
    }

    /**
     * Ends a step.
     *
     * @param springs energy in springs, J
     * @return how many bodies are not finite
     */
    int end(List<RigidBody> bodies, double springs, double dt) {
        double energyBefore = kinetic + potential;
        double expectedX = momentumX + mass * gravity.x() * dt;
        double expectedY = momentumY + mass * gravity.y() * dt;
        double before = allMomentum;
        int broken = sum(bodies);
        potential += springs;
        gain = kinetic + potential - energyBefore;
        lost = Math.hypot(momentumX - expectedX, momentumY - expectedY);
        allMomentum = Math.max(before, allMomentum);
        return broken;
    }

    double energyGainShare() {
        return scale > 0 ? Math.max(gain, 0) / scale : 0;
    }

    double momentumErrorShare() {
        return allMomentum > 0 ? lost / allMomentum : lost;
    }

    private int sum(List<RigidBody> bodies) {
        kinetic = potential = momentumX = momentumY = mass = allMomentum = lift = 0;
        int broken = 0;
        for (RigidBody body : bodies) {
            broken += isFinite(body) ? 0 : 1;
            if (body.type() == BodyType.DYNAMIC) {
                addDynamic(body);
            }
        }
        return broken;
    }

    private void addDynamic(RigidBody body) {
        double m = body.mass();
        double vx = body.velocityX();
        double vy = body.velocityY();
        double w = body.angularVelocity();
        mass += m;
        kinetic += (m * (vx * vx + vy * vy) + body.inertia() * w * w) / 2;
        potential -= m * (gravity.x() * body.x() + gravity.y() * body.y());
        momentumX += m * vx;
        momentumY += m * vy;
        allMomentum += m * Math.hypot(vx, vy);
        lift += m * Math.hypot(gravity.x(), gravity.y()) * body.shape().boundingRadius();
    }

    private static boolean isFinite(RigidBody body) {
        double sum = body.x() + body.y() + body.angle();
        return Double.isFinite(sum + body.velocityX() + body.velocityY() + body.angularVelocity());
    }
}
