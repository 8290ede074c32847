package rigibo.fuzz.judge;

import rigibo.backend.Pool;
import rigibo.backend.RayHit;
import rigibo.backend.RigidBody;
import rigibo.backend.geometry.Aabb;
import rigibo.fuzz.program.Witness;

import java.util.List;
import java.util.Optional;

/** Checks every step and every answer. */
final class Observer implements Witness {

    private static final double USUAL_STEP = 1.0 / 60;
    private static final int STEPS_OF_ALTERED = 3;

    private final Tally tally;
    private final Watch watch;
    private final StepLaws steps = new StepLaws();

    Observer(Tally tally, Watch watch) {
        this.tally = tally;
        this.watch = watch;
    }

    @Override
    public void beforeStep(Pool pool) {
        watch.begins("a step after " + pool.time() + " s");
        steps.before(pool);
    }

    @Override
    public void stepped(Pool pool, double dt) {
        tally.count(Tally.Of.STEPS);
        steps.after(pool, dt);
        for (int i = 0; i < pool.report().quarantined(); i++) {
            tally.count(Tally.Of.QUARANTINED);
        }
    }

    @Override
    public void restored(Pool pool) {
        steps.restored(pool);
    }

    @Override
    public void foundAt(Pool pool, double x, double y, Optional<RigidBody> found) {
        tally.count(Tally.Of.QUERIES);
        Answers.requireAt(pool, x, y, found);
    }

    @Override
    public void metByRay(
            Pool pool, double fromX, double fromY, double toX, double toY, Optional<RayHit> hit) {
        tally.count(Tally.Of.QUERIES);
        new Ray(fromX, fromY, toX, toY).requireHit(pool, hit);
    }

    @Override
    public void foundIn(Pool pool, Aabb box, List<RigidBody> found) {
        tally.count(Tally.Of.QUERIES);
        Answers.requireIn(pool, box, found);
    }

    /** Whatever the altered snapshot restored to must survive the next steps. */
    @Override
    public void restoredAltered(Pool pool, int bytes) {
        tally.count(Tally.Of.ALTERED_SNAPSHOTS_RESTORED);
        for (int i = 0; i < STEPS_OF_ALTERED; i++) {
            pool.step(USUAL_STEP);
            States.requireSound(pool);
        }
        pool.contactEvents();
        pool.snapshot();
    }
}
