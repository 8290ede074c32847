package rigibo.backend;

import rigibo.backend.setup.BodyDefinition;
import rigibo.backend.step.StepPlan;
import rigibo.backend.storage.Bodies;
import rigibo.backend.storage.DataStorage;
import rigibo.backend.storage.Need;
import rigibo.backend.storage.Waking;

/** Changes the locks of bodies between steps: of rotation, and of motion along x or y. */
final class LockEditor {

    private final DataStorage data;
    private final Bodies bodies;
    private final StepPlan plan;
    private final Waking waking;
    private final MotionEditor motion;

    LockEditor(DataStorage data, StepPlan plan, Waking waking, MotionEditor motion) {
        this.data = data;
        this.plan = plan;
        this.waking = waking;
        this.motion = motion;
        bodies = data.bodies;
    }

    /** Sets the locks of a new body from its definition, and writes its mass and inertia. */
    void begin(int slot, BodyDefinition definition) {
        lockRotation(slot, definition.rotationLocked());
        lockAxes(slot, definition.xLocked(), definition.yLocked());
    }

    void rotation(int slot, boolean isLocked) {
        waking.wakeNeighbours(slot);
        lockRotation(slot, isLocked);
        data.roster.isStale = true;
        waking.wake(slot);
    }

    /** Sets the lock of rotation; its column is made for the first body that needs it. */
    private void lockRotation(int slot, boolean isLocked) {
        if (isLocked) {
            bodies.hold(Need.LOCKS);
            bodies.haltTurning(slot);
        }
        if (bodies.rotationLocked != null) {
            bodies.rotationLocked[slot] = isLocked;
        }
        Weight.write(bodies, slot);
    }

    void axes(int slot, boolean inX, boolean inY) {
        waking.wakeNeighbours(slot);
        motion.endDrive(slot);
        lockAxes(slot, inX, inY);
        data.roster.isStale = true;
        waking.wake(slot);
    }

    /**
     * Sets the locked axes; their columns and stages are made for the first body that needs them.
     */
    private void lockAxes(int slot, boolean inX, boolean inY) {
        if ((inX || inY) && bodies.lockedX == null) {
            data.hold(Need.AXES);
            plan.compile(plan.effects(), plan.accuracy());
        }
        if (bodies.lockedX != null) {
            bodies.lockedX[slot] = inX;
            bodies.lockedY[slot] = inY;
            motion.hold(slot);
        }
    }
}
