package rigibo.lab.bench.scene;

import rigibo.backend.effect.Effects;
import rigibo.backend.setup.BodyDefinition;
import rigibo.backend.setup.BodyType;
import rigibo.lab.engine.Link;
import rigibo.lab.engine.World;

import java.util.List;
import java.util.Objects;

/**
 * A scene that every engine can simulate.
 *
 * @param effects what it calls for
 * @param bodies in the order they are added
 * @param links joints of them, joined before the first step
 * @param driver what is done to some of them before each step
 * @param loss of one of the bodies; {@link Loss#NONE} where all stay
 */
public record Scene(
        Effects effects, List<BodyDefinition> bodies, List<Link> links, Driver driver, Loss loss) {

    /** The time step of all scenes and engines, s. */
    public static final double STEP = 1.0 / 60;

    public Scene {
        bodies = List.copyOf(bodies);
        links = List.copyOf(links);
    }

    /** A scene in which nothing is driven. */
    public Scene(Effects effects, List<BodyDefinition> bodies) {
        this(effects, bodies, new Driver.None());
    }

    /** A scene from which no body is removed. */
    public Scene(Effects effects, List<BodyDefinition> bodies, Driver driver) {
        this(effects, bodies, driver, Loss.NONE);
    }

    /** A scene without joints. */
    public Scene(Effects effects, List<BodyDefinition> bodies, Driver driver, Loss loss) {
        this(effects, bodies, List.of(), driver, loss);
    }

    /** A scene of joined bodies that only motors drive. */
    public Scene(Effects effects, List<BodyDefinition> bodies, List<Link> links) {
        this(effects, bodies, links, new Driver.None(), Loss.NONE);
    }

    /** Adds all bodies to a world and joins them. */
    public void build(World world) {
        bodies.forEach(world::add);
        links.forEach(world::join);
    }

    /** Whether groups and joints let two of its bodies collide. */
    public boolean meet(int a, int b) {
        int group = bodies.get(a).group();
        return (group == 0 || group != bodies.get(b).group())
                && links.stream().noneMatch(link -> link.isOf(a, b));
    }

    /** A hash of the scene, which tells a changed level or flood. */
    public int fingerprint() {
        int mark = Objects.hash(effects.toString(), driver, loss);
        for (BodyDefinition body : bodies) {
            mark = 31 * mark + fingerprint(body);
        }
        for (Link link : links) {
            mark = 31 * mark + link.fingerprint();
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

    /** The number of dynamic bodies. */
    public int dynamic() {
        return (int) bodies.stream().filter(body -> body.type() == BodyType.DYNAMIC).count();
    }
}
