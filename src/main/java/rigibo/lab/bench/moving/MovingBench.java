package rigibo.lab.bench.moving;

import rigibo.backend.Pool;
import rigibo.lab.bench.scene.BenchScene;
import rigibo.lab.child.ClassFiles;
import rigibo.lab.child.Kept;
import rigibo.lab.child.MeasuringJava;
import rigibo.lab.child.Progress;
import rigibo.lab.engine.World;
import rigibo.lab.precision.Environment;
import rigibo.lab.truth.Outline;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.function.Consumer;
import java.util.stream.Collectors;
import java.util.stream.Stream;

/**
 * Lets every contestant have each moving scene, a process each, in turn.
 *
 * @param scenes in the order of the report
 * @param contestants likewise
 * @param steps of each scene at most
 * @param runs by which each step is timed
 * @param out directory in which what was found is kept
 */
public record MovingBench(
        List<BenchScene> scenes, List<Contestant> contestants, int steps, int runs, Path out) {

    private static final String LOG = "moving.log";
    private static final int HEAP_MEGABYTES = 512;

    /**
     * Makes the runs that are missing.
     *
     * @param tell is told how far it is
     * @return a section for each scene
     * @throws IllegalStateException when a process breaks off, with what it said
     */
    List<MovingSection> run(Consumer<String> tell) {
        MeasuringJava java = MeasuringJava.onLastCore(HEAP_MEGABYTES);
        Kept kept = new Kept(out.resolve(LOG), key());
        Progress progress = new Progress(scenes.size() * contestants.size(), tell);
        List<MovingSection> sections = new ArrayList<>();
        for (BenchScene scene : scenes) {
            Map<Contestant, Course> courses = new LinkedHashMap<>();
            int bodies = scene.scene().get().fingerprint();
            for (Contestant contestant : contestants) {
                List<String> arguments = arguments(scene, contestant);
                String name = String.join(" | ", arguments) + " | " + Integer.toHexString(bodies);
                if (kept.of(name).isEmpty()) {
                    String classPath = System.getProperty("java.class.path");
                    kept.add(
                            name,
                            java.run(classPath, MovingProbe.class, arguments, MovingProbe.MARK)
                                    .get(0));
                }
                courses.put(contestant, Course.parse(kept.of(name).orElseThrow()));
                progress.done();
            }
            sections.add(new MovingSection(scene.name() + ": " + scene.what(), courses, steps));
        }
        return sections;
    }

    private List<String> arguments(BenchScene scene, Contestant contestant) {
        return List.of(
                scene.name(), contestant.engine(), contestant.setting(), "" + steps, "" + runs);
    }

    /** The same for equal engines, ways to time them and Java. */
    private static String key() {
        return Stream.of(Pool.class, World.class, Outline.class, MovingProbe.class)
                        .map(member -> ClassFiles.of(member).hash())
                        .collect(Collectors.joining("-"))
                + "-"
                + Runtime.version();
    }

    /**
     * All of it for a terminal.
     *
     * @throws IllegalStateException as {@link #run}
     */
    public List<String> text(Consumer<String> tell) {
        List<String> lines = new ArrayList<>();
        for (MovingSection section : run(tell)) {
            lines.add(section.title());
            section.table().text().forEach(line -> lines.add("  " + line));
            section.sentences().forEach(line -> lines.add("  " + line));
            lines.add("");
        }
        return lines;
    }

    /**
     * All of it as Markdown.
     *
     * @throws IllegalStateException as {@link #run}
     */
    public String markdown(Environment environment, Consumer<String> tell) {
        Environment measured =
                environment.withFlags(MeasuringJava.onLastCore(HEAP_MEGABYTES).words());
        String provenance = measured.words() + " By `" + measured.command() + "`.\n\n";
        return provenance + sections(tell) + "\n";
    }

    private String sections(Consumer<String> tell) {
        return run(tell).stream()
                .map(
                        section ->
                                "### "
                                        + section.title()
                                        + "\n\n"
                                        + section.table().markdown()
                                        + "\n"
                                        + String.join("\n\n", section.sentences()))
                .collect(Collectors.joining("\n\n"));
    }
}
