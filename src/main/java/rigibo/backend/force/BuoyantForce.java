package rigibo.backend.force;

import rigibo.backend.effect.Buoyancy;
import rigibo.backend.effect.Gravity;

/**
 * Buoyancy −ρ·A·g at the centroid c of the submerged area A, and the drag −d·ρ·∫v dA on it: the
 * force −d·ρ·A·(v + ω × c) and the torque −d·ρ·(A·(c × v) + ω·J) about the centre of mass, with J =
 * ∫r² dA.
 */
final class BuoyantForce implements ChangingForce {

    private final Buoyancy water;
    private final Gravity gravity;
    private final Submerged under = new Submerged();

    BuoyantForce(Buoyancy water, Gravity gravity) {
        this.water = water;
        this.gravity = gravity;
    }

    @Override
    public void add(Instant at) {
        under.measure(at, water.level() - at.y);
        if (!(under.area > 0)) {
            return;
        }
        double cx = under.centroidX;
        double cy = under.centroidY;
        double displaced = water.density() * under.area;
        double braking = water.drag() * displaced;
        double forceX = -displaced * gravity.x() - braking * (at.velocityX - at.spin * cy);
        double forceY = -displaced * gravity.y() - braking * (at.velocityY + at.spin * cx);
        at.push(forceX, forceY);
        // The drag at the centroid adds to the torque of the lift; the rest of its torque is about
        // the centroid.
        double own = under.secondMoment - under.area * (cx * cx + cy * cy);
        double slowing = water.drag() * water.density() * own * at.spin;
        at.turn(cx * forceY - cy * forceX - slowing);
    }
}
