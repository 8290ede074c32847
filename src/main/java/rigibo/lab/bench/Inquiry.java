package rigibo.lab.bench;

import rigibo.lab.bench.scene.BenchScene;
import rigibo.lab.bench.scene.BenchScenes;
import rigibo.lab.engine.Engine;
import rigibo.lab.engine.RigiBoEngine;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;

/**
 * The order for a run of the bench.
 *
 * @param scenes in the order of the report
 * @param engines in the order of the report
 * @param rounds number of rounds; in each every engine runs every scene once
 * @param out directory where results are kept
 */
public record Inquiry(List<BenchScene> scenes, List<Engine> engines, int rounds, Path out) {

    /**
     * All runs, in order. The engines take turns, so that a disturbance of the machine affects all
     * of them. The sweep runs once, since its exponents are fitted to many sizes.
     */
    List<Task> tasks() {
        List<Task> tasks = new ArrayList<>();
        Map<BenchScene, Integer> fingerprints = new HashMap<>();
        scenes.forEach(scene -> fingerprints.put(scene, scene.scene().get().fingerprint()));
        for (int round = 1; round <= rounds; round++) {
            for (BenchScene scene : scenes) {
                for (Engine engine : engines) {
                    if (isAsked(scene, engine, round)) {
                        int bodies = fingerprints.get(scene);
                        tasks.add(new Task(scene, bodies, engine.name(), round));
                    }
                }
            }
        }
        return tasks;
    }

    private static boolean isAsked(BenchScene scene, Engine engine, int round) {
        boolean isOurs = engine.name().equals(RigiBoEngine.NAME);
        boolean isInRound = round == 1 || !BenchScenes.isSwept(scene.name());
        return isInRound && (isOurs || BenchScenes.isForAll(scene.name()));
    }

    /** The name of an engine on the command line, without its version. */
    public static String shortName(Engine engine) {
        return shortName(engine.name());
    }

    /** A name such as "JBox2D 2.2.1.1" in lower case and without its version. */
    public static String shortName(String engine) {
        return engine.split(" ")[0].toLowerCase(Locale.ROOT);
    }
}
