package rigibo.backend.contact.row;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;

import rigibo.backend.Pool;
import rigibo.backend.PoolStorage;
import rigibo.backend.effect.Contacts;
import rigibo.backend.effect.Effects;
import rigibo.backend.effect.Gravity;
import rigibo.backend.geometry.Circle;
import rigibo.backend.geometry.Polygon;
import rigibo.backend.setup.Accuracy;
import rigibo.backend.setup.BodyDefinition;
import rigibo.backend.storage.DataStorage;
import rigibo.backend.storage.Islands;

import java.util.Arrays;
import java.util.HashSet;
import java.util.Set;

class ColoursTest {

    /** More contacts than the colours chosen by free capacity take. */
    private static final int MANY = 200;

    private final Pool pool =
            new Pool(Effects.of(new Contacts(), new Gravity(0, -9.81)), Accuracy.GAME);

    /**
     * A wall of bricks: each touches two below and two above, so that four colours would suffice.
     */
    @Test
    void noTwoOfOneColourShareABody() {
        pool.add(BodyDefinition.fixed(Polygon.box(100, 1)).at(0, -0.5));
        for (int storey = 0; storey < 20; storey++) {
            for (int i = 0; i < 20; i++) {
                double x = i * 1.1 + storey % 2 * 0.55;
                pool.add(BodyDefinition.dynamic(Polygon.box(1, 1)).at(x, storey + 0.5));
            }
        }
        Colours colours = colours();
        // A contact has at most 3 neighbours at each of its bodies, and the ground has 1 colour.
        assertThat(colours.count).isBetween(5, 8);
        assertThat(asked(colours) - colours.groundStart).isEqualTo(20);
        assertThat(colours.groundStart).isGreaterThan(700);
    }

    /** Discs on a plank that lies on the ground: the plank has a colour for each of them. */
    @Test
    void oneBodyMayTouchAnyNumber() {
        pool.add(BodyDefinition.fixed(Polygon.box(2 * MANY, 1)).at(0, -0.5));
        pool.add(BodyDefinition.dynamic(Polygon.box(2 * MANY, 1)).at(0, 0.5));
        for (int i = 0; i < MANY; i++) {
            pool.add(BodyDefinition.dynamic(new Circle(0.4)).at(i - MANY / 2.0, 1.4));
        }
        Colours colours = colours();
        assertThat(colours.count).isEqualTo(MANY + 1);
        assertThat(asked(colours)).isEqualTo(MANY + 1);
        assertThat(colours.groundStart).isEqualTo(MANY);
    }

    /** Bodies of other islands change nothing in an island. */
    @Test
    void strangersDoNotMatter() {
        Colours alone = stackBeside(0);
        Colours beside = stackBeside(5);
        assertThat(beside.count).isEqualTo(alone.count);
        assertThat(beside.end).startsWith(Arrays.copyOf(alone.end, alone.count));
    }

    private static Colours stackBeside(int strangers) {
        Pool pool = new Pool(Effects.of(new Contacts(), new Gravity(0, -9.81)), Accuracy.GAME);
        pool.add(BodyDefinition.fixed(Polygon.box(1000, 1)).at(0, -0.5));
        for (int i = 0; i < 10; i++) {
            pool.add(BodyDefinition.dynamic(Polygon.box(1, 1)).at(0, i + 0.5));
        }
        for (int i = 0; i < strangers; i++) {
            pool.add(BodyDefinition.dynamic(Polygon.box(1, 1)).at(100 + 2 * i, 0.5));
        }
        pool.step(1e-3);
        Colours colours = new Colours(PoolStorage.of(pool));
        colours.find(0);
        return colours;
    }

    private Colours colours() {
        pool.step(1e-3);
        Colours colours = new Colours(PoolStorage.of(pool));
        colours.find(0);
        return colours;
    }

    /** Visits every contact of the island; returns their number. */
    private int asked(Colours colours) {
        DataStorage data = PoolStorage.of(pool);
        Islands islands = data.islands;
        int start = 0;
        Set<Integer> seen = new HashSet<>();
        for (int colour = 0; colour < colours.count; colour++) {
            Set<Integer> touched = new HashSet<>();
            for (int i = start; i < colours.end[colour]; i++) {
                int pair = colours.order[i];
                int a = data.pairs.bodyA[pair];
                int b = data.pairs.bodyB[pair];
                boolean isOfGround = !data.bodies.isDynamic(a) || !data.bodies.isDynamic(b);
                assertThat(isOfGround).isEqualTo(i >= colours.groundStart);
                assertThat(!data.bodies.isDynamic(a) || touched.add(a)).isTrue();
                assertThat(!data.bodies.isDynamic(b) || touched.add(b)).isTrue();
                assertThat(seen.add(pair)).isTrue();
            }
            start = colours.end[colour];
        }
        assertThat(seen).hasSize(islands.pairStart[1] - islands.pairStart[0]);
        return seen.size();
    }
}
