package rigibo.lab.hardcase;

import rigibo.backend.RigidBody;
import rigibo.backend.geometry.Circle;
import rigibo.backend.setup.BodyDefinition;
import rigibo.lab.truth.Solid;

import java.util.SplittableRandom;

/**
 * A disc leaves a round hill, from rest 1° beside its top. Truth: v² = 2g(R + r)(cos θ₀ − cos θ)
 * without friction, with 4/3 in place of 2 where it rolls. It leaves where its weight cannot bend
 * its path any more, v² = g(R + r)·cos θ: at cos θ = (2/3)·cos θ₀, and (4/7)·cos θ₀ where it rolls.
 * After that its horizontal speed is v·cos θ, so vₓ² = g(R + r)·cos³θ gives θ.
 */
final class RoundHill implements Scenes {

    private static final double START = Math.toRadians(1);

    /** With less friction a disc slips while its load on the hill falls to 0. */
    private static final double FRICTION = 100;

    private static final double PATIENCE = 30;
    private static final Limits DEGREES = Limits.of(0.4, 0.05);

    @Override
    public void run(Trial trial) {
        for (SplittableRandom random : trial.sampling().draws(5, 40)) {
            double reach = 2 + 8 * random.nextDouble();
            double radius = reach * (0.03 + 0.4 * random.nextDouble());
            String words = ", R + r " + reach + " m, r " + radius + " m";
            trial.variant("smooth" + words);
            trial.measure("smooth", off(trial, reach, radius, 0, 2.0 / 3), "°", DEGREES);
            trial.variant("rolling" + words);
            trial.measure("rolling", off(trial, reach, radius, FRICTION, 4.0 / 7), "°", DEGREES);
        }
    }

    private static double off(
            Trial trial, double reach, double radius, double friction, double share) {
        WatchedPool pool = trial.earth().withOverlapOfItsOwn();
        pool.add(
                BodyDefinition.fixed(new Circle(reach - radius))
                        .material(Solid.matter(friction, 0)));
        RigidBody disc =
                pool.add(
                        Solid.disc(radius, friction, 0)
                                .at(reach * Math.sin(START), reach * Math.cos(START)));
        while (disc.y() > 0 && pool.time() < PATIENCE) {
            pool.step();
        }
        double vx = disc.velocityX();
        double cos = Math.cbrt(vx * vx / (Trial.GRAVITY * reach));
        return Math.toDegrees(Math.abs(Math.acos(cos) - Math.acos(share * Math.cos(START))));
    }
}
