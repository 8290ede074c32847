package rigibo.backend.storage;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;

import rigibo.backend.effect.Contacts;
import rigibo.backend.effect.Effects;
import rigibo.backend.effect.Friction;
import rigibo.backend.effect.Restitution;
import rigibo.backend.effect.RollingResistance;
import rigibo.backend.effect.Rotation;
import rigibo.backend.setup.BodyType;
import rigibo.backend.storage.ShownColumns.Shown;

import java.lang.reflect.Array;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Map;
import java.util.Random;
import java.util.Set;

/** Sorting the pairs gives them other slots, and nothing else. */
class PairOrderTest {

    private static final int BODIES = 80;
    private static final long SEED = 11;

    /** What says who a pair is and where its lists go on: checked by what is found through it. */
    private static final Set<String> LINKS =
            Set.of("bodyA", "bodyB", "next", "previous", "activeStep");

    private final DataStorage data = new DataStorage(everyColumn());
    private final Pairs pairs = data.pairs;

    private static Effects everyColumn() {
        return Effects.of(
                new Contacts(),
                new Rotation(),
                new Friction(),
                new Restitution(),
                new RollingResistance());
    }

    @Test
    void everyColumnGoesWithItsPair() {
        data.hold(Need.COMPOUNDS);
        data.hold(Need.ONE_SIDED);
        pairUpAtRandom();
        listActive();
        mark();
        List<List<Integer>> neighbours = neighbours();
        new PairOrder(data).restore();
        assertThat(pairs.slots.freeCount).isZero();
        assertThat(pairs.roomAhead()).as("sorted while it grows").isGreaterThan(pairs.room());
        for (int i = 0; i < pairs.activeCount; i++) {
            assertThat(pairs.active[i]).as("active pairs stand in their order").isEqualTo(i);
        }
        int active = pairs.activeCount;
        for (int pair = 0; pair < active; pair++) {
            pairs.activate(pair);
        }
        assertThat(pairs.activeCount).as("no pair is listed twice").isEqualTo(active);
        assertThat(neighbours()).isEqualTo(neighbours);
        for (int pair : pairs.slots.occupied()) {
            int a = pairs.bodyA[pair];
            int b = pairs.bodyB[pair];
            assertThat(pairs.index.find(a, b)).isEqualTo(pair);
            columns().forEach((name, column) -> requireMark(name, column, pair, a * BODIES + b));
        }
    }

    @Test
    void whatIsInOrderIsLeftAlone() {
        pairUpAtRandom();
        listActive();
        PairOrder order = new PairOrder(data);
        order.restore();
        double[] before = pairs.normalX;
        order.restore();
        assertThat(pairs.normalX).isSameAs(before);
    }

    /**
     * Every pair of bodies that is near by number, in any order, and a third of them gone again.
     */
    private void pairUpAtRandom() {
        List<int[]> all = new ArrayList<>();
        for (int a = 0; a < BODIES; a++) {
            int slot = data.bodies.take();
            data.bodies.type[slot] = BodyType.DYNAMIC;
            data.bodies.firstPair[slot] = Pairs.NONE;
            for (int b = a + 1; b < BODIES; b++) {
                all.add(new int[] {a, b});
            }
        }
        Collections.shuffle(all, new Random(SEED));
        for (int[] two : all) {
            pairs.add(data.bodies, two[0], two[1]);
        }
        for (int i = 0; i < all.size(); i += 3) {
            pairs.remove(data.bodies, pairs.index.find(all.get(i)[0], all.get(i)[1]));
        }
    }

    /** Most of them, body by body, as a step does. */
    private void listActive() {
        pairs.beginStep();
        for (int a = 0; a < BODIES - 2; a++) {
            for (int p = data.bodies.firstPair[a]; p != Pairs.NONE; p = pairs.nextOf(p, a)) {
                if (pairs.bodyA[p] == a) {
                    pairs.activate(p);
                }
            }
        }
    }

    private void mark() {
        for (int pair : pairs.slots.occupied()) {
            int mark = pairs.bodyA[pair] * BODIES + pairs.bodyB[pair];
            for (Shown column : columns().values()) {
                for (int i = 0; i < column.perSlot(); i++) {
                    set(column.array(), column.perSlot() * pair + i, mark + i);
                }
            }
        }
    }

    private static void requireMark(String name, Shown column, int pair, int mark) {
        for (int i = 0; i < column.perSlot(); i++) {
            Object found = Array.get(column.array(), column.perSlot() * pair + i);
            Object expected =
                    found instanceof Boolean
                            ? (Object) ((mark + i) % 2 == 0)
                            : found instanceof Double
                                    ? (Object) (double) (mark + i)
                                    : (Object) (mark + i);
            assertThat(found).as(name).isEqualTo(expected);
        }
    }

    private static void set(Object column, int at, int mark) {
        if (column instanceof boolean[] flags) {
            flags[at] = mark % 2 == 0;
        } else if (column instanceof double[] numbers) {
            numbers[at] = mark;
        } else {
            ((int[]) column)[at] = mark;
        }
    }

    /** All of the table but the links, so that a column that is added later is not forgotten. */
    private Map<String, Shown> columns() {
        Map<String, Shown> columns = ShownColumns.of(pairs);
        columns.keySet().removeAll(LINKS);
        return columns;
    }

    private List<List<Integer>> neighbours() {
        List<List<Integer>> of = new ArrayList<>();
        for (int body = 0; body < BODIES; body++) {
            List<Integer> others = new ArrayList<>();
            for (int p = data.bodies.firstPair[body]; p != Pairs.NONE; p = pairs.nextOf(p, body)) {
                others.add(pairs.other(p, body));
            }
            of.add(others);
        }
        return of;
    }
}
