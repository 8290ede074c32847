package rigibo.lab.ablation;

import rigibo.lab.ablation.probe.Probe;
import rigibo.lab.ablation.probe.Sample;

import java.io.File;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;

/** Starts the Java processes that measure, one at a time, each on one core where that can be. */
final class ProbeJava {

    /**
     * A heap that never changes its size, collected without threads of its own. Compilation holds
     * up the thread that asked for it: on one core it would otherwise take turns with what is
     * measured, at another moment in every run.
     */
    private static final List<String> FLAGS =
            List.of("-Xms256m", "-Xmx256m", "-XX:+UseSerialGC", "-Xbatch");

    private final Archives archives;
    private final long seed;
    private final List<String> pin;

    ProbeJava(Archives archives, long seed) {
        this.archives = archives;
        this.seed = seed;
        pin = pin();
    }

    /** What pins a process to the last core, which fewest interrupts go to; empty if nothing. */
    private static List<String> pin() {
        int last = Runtime.getRuntime().availableProcessors() - 1;
        List<String> words = List.of("taskset", "-c", "" + last);
        List<String> trial = new ArrayList<>(words);
        trial.add("true");
        try {
            Process process = new ProcessBuilder(trial).redirectErrorStream(true).start();
            process.getInputStream().readAllBytes();
            return process.waitFor() == 0 ? words : List.of();
        } catch (IOException missing) {
            return List.of();
        } catch (InterruptedException stop) {
            Thread.currentThread().interrupt();
            return List.of();
        }
    }

    /** How processes are run, in words. */
    String words() {
        String core = pin.isEmpty() ? "not pinned" : "pinned to one core";
        return String.join(" ", FLAGS) + ", " + core;
    }

    /**
     * Runs one to its end.
     *
     * @throws IllegalStateException when it breaks off, with what it said: a class that was taken
     *     out was needed, or the machine ended it
     */
    Sample run(Run run) {
        try {
            Process process = new ProcessBuilder(command(run)).redirectErrorStream(true).start();
            String said =
                    new String(process.getInputStream().readAllBytes(), StandardCharsets.UTF_8);
            if (process.waitFor() != 0) {
                throw broken(run, said);
            }
            return said.lines()
                    .filter(line -> line.startsWith(Probe.MARK))
                    .findFirst()
                    .map(line -> Sample.parse(line.substring(Probe.MARK.length())))
                    .orElseThrow(() -> broken(run, said));
        } catch (IOException cause) {
            throw new IllegalStateException("cannot start Java for " + run.workload(), cause);
        } catch (InterruptedException stop) {
            Thread.currentThread().interrupt();
            throw new IllegalStateException("interrupted at " + run.workload(), stop);
        }
    }

    private List<String> command(Run run) {
        List<String> command = new ArrayList<>(pin);
        command.add(Path.of(System.getProperty("java.home"), "bin", "java").toString());
        command.addAll(FLAGS);
        String classPath = archives.engine(run) + File.pathSeparator + archives.probe();
        command.addAll(List.of("-cp", classPath, Probe.class.getName(), run.workload()));
        command.add("" + seed);
        command.add("" + run.budget().warmMillis);
        command.add("" + run.budget().timedMillis);
        return command;
    }

    private IllegalStateException broken(Run run, String said) {
        String without =
                run.engine() == Run.Engine.STRIPPED
                        ? " without " + archives.takenOut(run.workload())
                        : "";
        return new IllegalStateException(
                "the run of '" + run.workload() + "'" + without + " broke off: " + said.strip());
    }
}
