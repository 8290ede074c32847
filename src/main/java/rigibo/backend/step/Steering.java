package rigibo.backend.step;

import rigibo.backend.geometry.Angle;
import rigibo.backend.storage.Bodies;
import rigibo.backend.storage.DataStorage;
import rigibo.backend.storage.Found;
import rigibo.backend.storage.Roster;

/**
 * Gives driven bodies the velocity that brings them towards their target pose. Any change of pose
 * is a rotation about one point (Chasles), so the centre of mass moves on an arc. With the
 * displacement left d, the turn left θ and the turn of this step φ, it moves by
 * d·sin(φ/2)/sin(θ/2), rotated by (φ − θ)/2. Beyond half a turn the arc would be longer than
 * intended, and the path is straight.
 */
final class Steering {

    /** Share of a step below which the time left is round-off. */
    private static final double LEAST_SHARE = 1e-9;

    /** Turn in rad below which an arc equals its chord to all digits. */
    private static final double STRAIGHT = 1e-8;

    private final Bodies bodies;
    private final Found steered;
    private final Roster roster;

    Steering(DataStorage data) {
        bodies = data.bodies;
        steered = data.steered;
        roster = data.roster;
    }

    void steer(double dt) {
        int left = 0;
        for (int i = 0; i < steered.count; i++) {
            int slot = steered.numbers[i];
            if (slot < bodies.slots.high && bodies.isSteered(slot) && !bodies.isDisabled(slot)) {
                aim(slot, dt);
                steered.numbers[left++] = slot;
            }
        }
        steered.count = left;
        roster.isStale = true;
    }

    private void aim(int slot, double dt) {
        double time = bodies.driveTime[slot];
        if (time <= LEAST_SHARE * dt) {
            bodies.driveTime[slot] = 0;
            bodies.halt(slot);
            return;
        }
        double share = Math.min(1, dt / time);
        double dx = bodies.driveX[slot] - bodies.x[slot];
        double dy = bodies.driveY[slot] - bodies.y[slot];
        double turn = bodies.turns() ? bodies.driveAngle[slot] - bodies.angle[slot] : 0;
        double size = share;
        double aside = 0;
        if (Math.abs(turn) > STRAIGHT && Math.abs(turn) <= Math.PI) {
            size = Angle.sin(share * turn / 2) / Angle.sin(turn / 2);
            aside = (share * turn - turn) / 2;
        }
        double cos = size * Angle.cos(aside);
        double sin = size * Angle.sin(aside);
        bodies.velocityX[slot] = (cos * dx - sin * dy) / dt;
        bodies.velocityY[slot] = (sin * dx + cos * dy) / dt;
        if (bodies.turns()) {
            bodies.spin[slot] = share * turn / dt;
        }
        // A tiny time is left after the last step, so that the body is stopped at the start of the
        // next one.
        bodies.driveTime[slot] = Math.max(LEAST_SHARE * LEAST_SHARE * dt, time - dt);
    }
}
