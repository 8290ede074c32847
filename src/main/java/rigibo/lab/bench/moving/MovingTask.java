package rigibo.lab.bench.moving;

import rigibo.lab.bench.scene.BenchScene;

import java.util.List;

/**
 * One process to run.
 *
 * @param scene that goes
 * @param fingerprint of its bodies and effects
 * @param contestant that has it
 * @param steps at most
 * @param runs by which each step is timed
 */
record MovingTask(BenchScene scene, int fingerprint, Contestant contestant, int steps, int runs) {

    /** The arguments of the process. */
    List<String> arguments() {
        return List.of(
                scene.name(), contestant.engine(), contestant.setting(), "" + steps, "" + runs);
    }

    /** The key under which the result is kept. */
    String name() {
        return String.join(" | ", arguments()) + " | " + Integer.toHexString(fingerprint);
    }
}
