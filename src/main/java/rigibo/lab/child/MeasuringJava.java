package rigibo.lab.child;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.stream.IntStream;

/** Starts Java processes that measure, one at a time, each pinned to a core if possible. */
public final class MeasuringJava {

    /**
     * Flags for even times: the collector has no threads of its own, and compilation blocks the
     * thread that asked for it. On one core the compiler would otherwise interrupt the measured
     * code, at a different moment in every run.
     */
    private static final List<String> FLAGS = List.of("-XX:+UseSerialGC", "-Xbatch");

    /** The size of the heap in MB, enough for one scene in most engines. */
    private static final int USUAL_HEAP_MEGABYTES = 256;

    private final List<String> pin;
    private final List<String> flags;

    private MeasuringJava(int core, int heapMegabytes) {
        pin = pin(core);
        flags = new ArrayList<>();
        flags.addAll(List.of("-Xms" + heapMegabytes + "m", "-Xmx" + heapMegabytes + "m"));
        flags.addAll(FLAGS);
    }

    /** Processes on the last core, which gets the fewest interrupts. */
    public static MeasuringJava onLastCore() {
        return onLastCore(USUAL_HEAP_MEGABYTES);
    }

    /** Processes on the last core with a heap of a size in MB, for large scenes. */
    public static MeasuringJava onLastCore(int heapMegabytes) {
        return new MeasuringJava(Runtime.getRuntime().availableProcessors() - 1, heapMegabytes);
    }

    /** One for each core, for processes that run in parallel. */
    public static List<MeasuringJava> onEveryCore() {
        return IntStream.range(0, Runtime.getRuntime().availableProcessors())
                .mapToObj(core -> new MeasuringJava(core, USUAL_HEAP_MEGABYTES))
                .toList();
    }

    /** The command that pins a process to a core; empty if there is none. */
    private static List<String> pin(int core) {
        List<String> words = List.of("taskset", "-c", "" + core);
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

    /** Describes how processes are run. */
    public String words() {
        String core = pin.isEmpty() ? "not pinned" : "pinned to one core";
        return String.join(" ", flags) + ", " + core;
    }

    /**
     * Runs a main class of this class path to its end; returns the first line that begins with the
     * mark, without the mark.
     */
    public String run(Class<?> main, List<String> arguments, String mark) {
        String classPath = System.getProperty("java.class.path");
        return run(classPath, main, arguments, mark).get(0);
    }

    /**
     * Runs a class to its end.
     *
     * @param mark beginning of the lines that are answers
     * @return the rest of each of these lines
     * @throws IllegalStateException when the class breaks off, with its output
     */
    public List<String> run(String classPath, Class<?> main, List<String> arguments, String mark) {
        List<String> command = new ArrayList<>(pin);
        command.add(Path.of(System.getProperty("java.home"), "bin", "java").toString());
        command.addAll(flags);
        command.addAll(List.of("-cp", classPath, main.getName()));
        command.addAll(arguments);
        try {
            Process process = new ProcessBuilder(command).redirectErrorStream(true).start();
            String said =
                    new String(process.getInputStream().readAllBytes(), StandardCharsets.UTF_8);
            List<String> answers =
                    said.lines()
                            .filter(line -> line.startsWith(mark))
                            .map(line -> line.substring(mark.length()))
                            .toList();
            if (process.waitFor() != 0 || answers.isEmpty()) {
                throw new IllegalStateException("broke off: " + said.strip());
            }
            return answers;
        } catch (IOException cause) {
            throw new IllegalStateException("Java cannot be started", cause);
        } catch (InterruptedException stop) {
            Thread.currentThread().interrupt();
            throw new IllegalStateException("interrupted", stop);
        }
    }
}
