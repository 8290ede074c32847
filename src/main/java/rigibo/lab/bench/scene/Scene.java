package rigibo.lab.bench.scene;

import rigibo.backend.effect.Effects;
import rigibo.backend.setup.BodyDefinition;
import rigibo.backend.setup.BodyType;

import java.util.List;
import java.util.Objects;

/**
 * What every engine is given to step.
 *
 * @param effects what it calls for
 * @param bodies in the order they are added
 * @param driver what is done to some of them before each step
 * @param loss of one of the bodies; {@link Loss#NONE} where all stay
 */
public record Scene(Effects effects, List<BodyDefinition> bodies, Driver driver, Loss loss) {

    /** s, of every scene and engine. */
    public static final double STEP = 1.0 / 60;

    public Scene {
        bodies = List.copyOf(bodies);
    }

    /** A scene in which nothing is driven. */
    public Scene(Effects effects, List<BodyDefinition> bodies) {
        this(effects, bodies, Driver.NONE);
    }

    /** A scene that all bodies stay in. */
    public Scene(Effects effects, List<BodyDefinition> bodies, Driver driver) {
        this(effects, bodies, driver, Loss.NONE);
    }

    /** The same for equal scenes, hardly ever for others: a level's file may change, or a flood. */
    public int fingerprint() {
        int mark = Objects.hash(effects.toString(), driver, loss);
        for (BodyDefinition body : bodies) {
            mark = 31 * mark + fingerprint(body);
        }
        return mark;
    }

    private static int fingerprint(BodyDefinition body) {
        return Objects.hash(
                body.type().name(),
                body.shape(),
                body.material(),
                body.x(),
                body.y(),
                body.angle(),
                body.velocityX(),
                body.velocityY(),
                body.spin());
    }

    /** How many of its bodies are moved by forces and contacts: those that it is named for. */
    public int dynamic() {
        return (int) bodies.stream().filter(body -> body.type() == BodyType.DYNAMIC).count();
    }
}
