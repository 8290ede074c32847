package rigibo.backend;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

import rigibo.backend.effect.Contacts;
import rigibo.backend.effect.Effects;
import rigibo.backend.effect.Gravity;
import rigibo.backend.effect.Joints;
import rigibo.backend.geometry.Circle;
import rigibo.backend.setup.Accuracy;
import rigibo.backend.setup.BodyDefinition;
import rigibo.backend.setup.JointFrame;
import rigibo.backend.setup.JointSettings;
import rigibo.backend.setup.JointSpring;

/**
 * A body on a damped spring that nothing else moves: q = q₀·e^(−ζωt)·(cos ω′t + (ζω/ω′)·sin ω′t),
 * ω′ = ω·√(1 − ζ²), at any accuracy.
 */
class DampedSpringTest {

    private static final double DT = 1.0 / 60;

    /** The spring as it is at rest, m, and how far it is drawn out. */
    private static final double LENGTH = 1;

    private static final double DRAWN = 0.2;

    /** Some thousand times the round-off of places of 1 m. */
    private static final double ROUND_OFF = 1e-12;

    private static Accuracy accuracy(String name) {
        return switch (name) {
            case "DRAFT" -> Accuracy.DRAFT;
            case "FINE" -> Accuracy.FINE;
            case "EXACT" -> Accuracy.EXACT;
            default -> Accuracy.GAME;
        };
    }

    private static RigidBody hang(Pool pool, double x, double y, JointSpring spring) {
        RigidBody hook = pool.add(BodyDefinition.fixed(new Circle(0.01)));
        double far = Math.hypot(x, y);
        RigidBody body =
                pool.add(BodyDefinition.dynamic(new Circle(0.2)).at(x / far, y / far).mass(3));
        JointSettings soft = JointSettings.NONE.spring(spring);
        JointFrame centre = JointFrame.CENTRE;
        pool.join(new DistanceJoint(hook, body, centre, centre, LENGTH, soft));
        body.moveTo(x, y, 0);
        return body;
    }

    @ParameterizedTest
    @CsvSource({
        "DRAFT, 5, 0.3",
        "DRAFT, 2, 0.9",
        "GAME, 5, 0.3",
        "GAME, 14, 0.45",
        "GAME, 1, 0.05",
        "FINE, 9, 0.7",
        "EXACT, 14, 0.45",
        "EXACT, 3, 0.2",
    })
    void swingsAsTheFormulaSays(String preset, double hertz, double ratio) {
        Pool pool = new Pool(Effects.of(new Contacts(), new Joints()), accuracy(preset));
        RigidBody body = hang(pool, LENGTH + DRAWN, 0, new JointSpring(hertz, ratio));
        double omega = 2 * Math.PI * hertz;
        double damped = omega * Math.sqrt(1 - ratio * ratio);
        double deepest = 0;
        for (int step = 1; step <= 120; step++) {
            pool.step(DT);
            double t = step * DT;
            double wave = Math.cos(damped * t) + ratio * omega / damped * Math.sin(damped * t);
            double truth = LENGTH + DRAWN * Math.exp(-ratio * omega * t) * wave;
            assertThat(Math.abs(body.x() - truth)).as("step " + step).isLessThan(ROUND_OFF);
            deepest = Math.max(deepest, LENGTH - body.x());
        }
        // It came to the other side, by what a half swing leaves of it where steps meet that.
        assertThat(deepest).isPositive();
    }

    /**
     * At rest a spring sags by g/ω², however its oscillation is integrated. Rest is found at speeds
     * that leave some 1e-11 m to go.
     */
    @Test
    void whatRestsSagsByItsWeight() {
        double g = 9.81;
        for (String preset : new String[] {"DRAFT", "GAME", "EXACT"}) {
            Pool pool =
                    new Pool(
                            Effects.of(new Contacts(), new Joints(), new Gravity(0, -g)),
                            accuracy(preset));
            RigidBody body = hang(pool, 0, -LENGTH, new JointSpring(4, 0.6));
            for (int step = 0; step < 600; step++) {
                pool.step(DT);
            }
            double omega = 2 * Math.PI * 4;
            double off = Math.abs(body.y() + LENGTH + g / (omega * omega));
            assertThat(off).as(preset).isLessThan(1e-10);
        }
    }
}
