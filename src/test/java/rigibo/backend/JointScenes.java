package rigibo.backend;

import rigibo.backend.effect.Contacts;
import rigibo.backend.effect.ContinuousImpacts;
import rigibo.backend.effect.Effects;
import rigibo.backend.effect.Gravity;
import rigibo.backend.effect.Joints;
import rigibo.backend.effect.Restitution;
import rigibo.backend.effect.Rotation;
import rigibo.backend.geometry.Polygon;
import rigibo.backend.setup.Accuracy;
import rigibo.backend.setup.BodyDefinition;

/** What scenes with joined bodies have in common. */
final class JointScenes {

    static final double G = 9.81;

    /** Joined bodies that meet, without weight. */
    static final Effects SPACE =
            Effects.of(
                    new Contacts(),
                    new ContinuousImpacts(),
                    new Rotation(),
                    new Restitution(),
                    new Joints());

    static final Effects EARTH = SPACE.with(new Gravity(0, -G));

    private JointScenes() {}

    static Accuracy accuracy(String preset) {
        return preset.equals("EXACT") ? Accuracy.EXACT : Accuracy.GAME;
    }

    /** What joints hang from. */
    static RigidBody hook(Pool pool, double x, double y) {
        return pool.add(BodyDefinition.fixed(Polygon.box(0.1, 0.1)).at(x, y).group(1));
    }
}
