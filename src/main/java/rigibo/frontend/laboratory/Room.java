package rigibo.frontend.laboratory;

import rigibo.backend.Pool;
import rigibo.backend.effect.Effects;
import rigibo.backend.geometry.Polygon;
import rigibo.backend.setup.Accuracy;
import rigibo.backend.setup.BodyDefinition;
import rigibo.backend.setup.Material;
import rigibo.frontend.scene.Skin;

import java.util.ArrayList;
import java.util.List;

/**
 * The room of an experiment: the space between four walls, 7 m wide and 8.4 m high, with the origin
 * in the middle of the floor.
 */
final class Room {

    /** Half the inner width, m. */
    static final double REACH = 3.5;

    /** Inner height, m. */
    static final double HEIGHT = 8.4;

    /** Thickness of the walls, m. */
    static final double WALL = 0.2;

    private final Pool pool;
    private final Effects effects;
    private final List<Skin> skins = new ArrayList<>();

    private Room(Effects effects) {
        this.effects = effects;
        pool = new Pool(effects, Accuracy.GAME);
    }

    /** A room with the initial bodies of an experiment. */
    static Room of(Experiment experiment) {
        Room room = new Room(experiment.effects());
        experiment.build().accept(room);
        return room;
    }

    /** Adds the four walls, with the friction and elasticity of a material. */
    void walls(Material material) {
        wall(2 * (REACH + WALL), WALL, 0, -WALL / 2, material);
        wall(2 * (REACH + WALL), WALL, 0, HEIGHT + WALL / 2, material);
        wall(WALL, HEIGHT, -REACH - WALL / 2, HEIGHT / 2, material);
        wall(WALL, HEIGHT, REACH + WALL / 2, HEIGHT / 2, material);
    }

    private void wall(double width, double height, double x, double y, Material material) {
        add(
                BodyDefinition.fixed(Polygon.box(width, height)).at(x, y).material(material),
                Skin.STONE);
    }

    void add(BodyDefinition body, Skin skin) {
        pool.add(body);
        skins.add(skin);
    }

    /** Makes a pool in the room's initial state; two of them are equal to the last bit. */
    Pool copy() {
        return Pool.restore(pool.snapshot(), effects);
    }

    /** The skins of the bodies in their order. */
    List<Skin> skins() {
        return skins;
    }
}
