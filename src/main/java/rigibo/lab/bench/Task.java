package rigibo.lab.bench;

import rigibo.lab.bench.scene.BenchScene;

import java.util.List;

/**
 * One process to run.
 *
 * @param scene that is timed
 * @param fingerprint of its bodies and effects
 * @param engine name
 * @param round from 1 on
 */
record Task(BenchScene scene, int fingerprint, String engine, int round) {

    /** The arguments of the process. */
    List<String> arguments() {
        return List.of(scene.name(), engine, scene.pace().words());
    }

    /** The key under which the result is kept. */
    String name() {
        String bodies = Integer.toHexString(fingerprint);
        return String.join(" | ", arguments()) + " | " + bodies + " | " + round;
    }
}
