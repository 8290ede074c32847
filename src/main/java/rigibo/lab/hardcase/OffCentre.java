package rigibo.lab.hardcase;

import rigibo.backend.RigidBody;
import rigibo.backend.geometry.Circle;
import rigibo.backend.setup.BodyDefinition;

/**
 * Truth: equal smooth discs exchange the components along the normal. With r = ½ and the impact
 * parameter ½ the normal stands at sin α = ½, 30°: the struck one leaves along it with v·cos 30° =
 * 8.660, the other across it with v·sin 30° = 5, at 90° to each other.
 */
final class OffCentre implements HardCase {

    private static final double SPEED = 10;
    private static final double NORMAL = Math.PI / 6;
    private static final double DEGREE = Math.PI / 180;
    private static final int PHASES = 5;

    @Override
    public String row() {
        return "12";
    }

    @Override
    public String title() {
        return "discs that meet off centre part at a right angle";
    }

    /** DRAFT leaves impacts to the one solve of a pile that a step has. */
    @Override
    public Preset limitedFrom() {
        return Preset.GAME;
    }

    @Override
    public void run(Trial trial) {
        for (int phase = 0; phase < PHASES; phase++) {
            trial.variant("phase " + phase);
            WatchedPool pool = trial.pool(Surroundings.space());
            BodyDefinition disc =
                    BodyDefinition.dynamic(new Circle(0.5)).material(Surroundings.matter(0, 1));
            double start = -Math.cos(NORMAL) - SPEED * (6 + (phase + 0.5) / PHASES) * Trial.DT;
            RigidBody cue = pool.add(disc.at(start, 0).velocity(SPEED, 0));
            RigidBody struck = pool.add(disc.at(0, 0.5));
            pool.run(12 * Trial.DT);
            double along = StrictMath.atan2(struck.velocityY(), struck.velocityX());
            double across = StrictMath.atan2(cue.velocityY(), cue.velocityX());
            trial.measure("angle along", Math.abs(along - NORMAL), "rad", 1e-6, DEGREE);
            double right = Math.abs(along - across - Math.PI / 2);
            trial.measure("right angle", right, "rad", 1e-6, DEGREE);
            double speed = Math.hypot(struck.velocityX(), struck.velocityY());
            double off = Math.abs(speed - SPEED * Math.cos(NORMAL)) / SPEED;
            trial.measure("speed along", off, "of v", 1e-6, 1e-2);
        }
    }
}
