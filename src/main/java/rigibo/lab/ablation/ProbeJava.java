package rigibo.lab.ablation;

import rigibo.lab.ablation.probe.Probe;
import rigibo.lab.ablation.probe.Sample;
import rigibo.lab.child.Fields;
import rigibo.lab.child.MeasuringJava;

import java.io.File;
import java.util.List;

/** Makes runs, each in a process with its archives. */
final class ProbeJava {

    private final MeasuringJava java = MeasuringJava.onLastCore();
    private final Archives archives;
    private final long seed;

    ProbeJava(Archives archives, long seed) {
        this.archives = archives;
        this.seed = seed;
    }

    /** Describes how processes are run. */
    String words() {
        return java.words();
    }

    /**
     * Makes a run.
     *
     * @throws IllegalStateException when it breaks off, with what it said: a class that was taken
     *     out was needed, or the machine ended it
     */
    Sample run(Run run) {
        String classPath = archives.engine(run) + File.pathSeparator + archives.probe();
        List<String> arguments =
                List.of(
                        run.workload(),
                        "" + seed,
                        "" + run.budget().warmMillis,
                        "" + run.budget().timedMillis);
        try {
            String answer = java.run(classPath, Probe.class, arguments, Probe.MARK).get(0);
            return Fields.parse(Sample.class, answer);
        } catch (IllegalStateException broken) {
            boolean isStripped = run.engine() == Run.Engine.STRIPPED;
            String without = isStripped ? " without " + archives.takenOut(run.workload()) : "";
            throw new IllegalStateException(
                    "the run of '" + run.workload() + "'" + without + " " + broken.getMessage(),
                    broken);
        }
    }
}
