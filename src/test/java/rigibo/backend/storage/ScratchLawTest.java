package rigibo.backend.storage;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;

import rigibo.backend.Pool;
import rigibo.backend.PoolStorage;
import rigibo.backend.law.RandomProgram;
import rigibo.backend.storage.ShownColumns.Shown;

import java.lang.reflect.Array;
import java.util.Map;
import java.util.Random;
import java.util.Set;
import java.util.TreeSet;

/** Columns with the role SCRATCH are written in a step before they are read. */
class ScratchLawTest {

    private static final int PROGRAMS = 24;
    private static final int STEPS = 160;

    @Test
    void rubbishInScratchChangesNothing() {
        Set<String> filled = new TreeSet<>();
        for (long seed = 1; seed <= PROGRAMS; seed++) {
            Pool pool = RandomProgram.pool(seed);
            Pool littered = RandomProgram.pool(seed);
            DataStorage data = PoolStorage.of(littered);
            Random random = new Random(seed);
            for (int i = 0; i < STEPS; i++) {
                litter(ShownColumns.of(data.bodies), random, filled);
                litter(ShownColumns.of(data.pairs), random, filled);
                RandomProgram.step(pool, seed, i);
                RandomProgram.step(littered, seed, i);
                assertThat(littered.stateHash())
                        .as("seed %d, step %d", seed, i)
                        .isEqualTo(pool.stateHash());
            }
        }
        assertThat(filled).contains("pileTime", "startAngle", "former");
    }

    private static void litter(Map<String, Shown> columns, Random random, Set<String> filled) {
        columns.forEach(
                (name, column) -> {
                    if (column.role() == Role.SCRATCH && column.array() != null) {
                        litter(column.array(), random);
                        filled.add(name);
                    }
                });
    }

    private static void litter(Object array, Random random) {
        for (int i = 0; i < Array.getLength(array); i++) {
            if (array instanceof double[] numbers) {
                numbers[i] = random.nextBoolean() ? Double.NaN : 1e3 * random.nextGaussian();
            } else if (array instanceof int[] integers) {
                integers[i] = random.nextInt();
            } else {
                ((boolean[]) array)[i] = random.nextBoolean();
            }
        }
    }
}
