package rigibo;

import picocli.CommandLine.Command;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.ParameterException;
import picocli.CommandLine.Spec;

import rigibo.backend.Pool;
import rigibo.lab.bench.BenchStudy;
import rigibo.lab.bench.Inquiry;
import rigibo.lab.bench.large.LargeBench;
import rigibo.lab.bench.moving.Contestant;
import rigibo.lab.bench.moving.MovingBench;
import rigibo.lab.bench.query.QueryBench;
import rigibo.lab.bench.scene.BenchScene;
import rigibo.lab.bench.scene.BenchScenes;
import rigibo.lab.bench.scene.MovingScenes;
import rigibo.lab.bench.workers.Crew;
import rigibo.lab.bench.workers.WorkersBench;
import rigibo.lab.engine.Engine;
import rigibo.lab.engine.Engines;
import rigibo.lab.precision.Environment;
import rigibo.lab.report.MeasuredPart;
import rigibo.lab.report.Report;

import java.io.IOException;
import java.io.PrintWriter;
import java.io.UncheckedIOException;
import java.nio.file.Path;
import java.time.LocalDate;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.Callable;
import java.util.stream.Collectors;
import java.util.stream.Stream;

/** Times steps of large scenes, beside other engines. */
@Command(
        name = "bench",
        description =
                "Times the steps of large scenes in every engine that is installed, and measures"
                    + " the state of each scene. Every run is a process of its own. An interrupted"
                    + " command continues where it stopped. All of it takes a quarter of an hour.")
final class BenchCommand implements Callable<Integer> {

    private static final String SWEEP = "sweep";
    private static final String ALL = "all";
    private static final String QUERIED = "GAME";
    private static final int MOST_ROUNDS = 100;
    private static final int MOST_STEPS = 100_000;

    @Option(
            names = "--scenes",
            paramLabel = "SCENE",
            split = ",",
            description =
                    "pyramid, large-pyramid, undermined-sleeper, undermined-awake, tumbler, flood,"
                            + " many-pyramids, free, level, sweep:"
                            + " floods of 100 to 50,000 discs (default: all).")
    private List<String> scenes = List.of();

    @Option(
            names = "--engines",
            paramLabel = "ENGINE",
            split = ",",
            description =
                    "rigibo, dyn4j, gdx-box2d, jbox2d; box2d and rapier after ./rigibo peers"
                            + " (default: all that are installed).")
    private List<String> engines = List.of();

    @Option(
            names = "--rounds",
            paramLabel = "N",
            defaultValue = "3",
            description =
                    "Rounds; in each, every engine runs every scene once (default:"
                            + " ${DEFAULT-VALUE}).")
    private int rounds;

    @Option(
            names = "--steps",
            paramLabel = "N",
            description =
                    "Steps timed of each scene, after at most as many untimed ones (default: a"
                            + " number for each scene).")
    private Integer steps;

    @Option(
            names = "--moving",
            paramLabel = "SCENE",
            split = ",",
            arity = "0..1",
            fallbackValue = ALL,
            description =
                    "Moving scenes in place of those above: the time of every step, and the deepest"
                            + " overlap. Without a name all of them; docs/performance.md lists"
                            + " them.")
    private List<String> moving = List.of();

    @Option(
            names = "--queries",
            description =
                    "In place of scenes: rays among 10,000 discs in ours and in gdx-box2d, and the"
                            + " cost of sensors.")
    private boolean areQueries;

    @Option(
            names = "--large",
            description =
                    "In place of scenes: the cost of a body in worlds of 10,000 and 100,000"
                            + " bodies, ours only.")
    private boolean areLarge;

    @Option(
            names = "--workers",
            paramLabel = "N",
            split = ",",
            description =
                    "Numbers of workers, such as 1,2: times each step of the moving scenes, or of"
                            + " --scenes, with each number in turn, by the wall clock; ours only,"
                            + " at GAME. Needs as many idle cores.")
    private List<Integer> workers = List.of();

    @Option(
            names = "--rehearse",
            paramLabel = "N",
            split = ",",
            description =
                    "With --workers: further numbers of workers, such as 2,4,8, whose times are"
                            + " computed from the longest path of their work, whatever cores there"
                            + " are.")
    private List<Integer> rehearsed = List.of();

    @Option(
            names = "--preset",
            paramLabel = "PRESET",
            split = ",",
            description =
                    "Presets of ours in moving scenes: DRAFT, GAME, FINE, EXACT (default: all)."
                            + " EXACT takes hours where hundreds of bodies rain.")
    private List<String> presets = List.of();

    @Option(
            names = "--runs",
            paramLabel = "N",
            defaultValue = "7",
            description =
                    "How often each step of a moving scene is timed (default: ${DEFAULT-VALUE}).")
    private int runs;

    @Option(
            names = "--csv",
            paramLabel = "FILE",
            description = "Writes a line of CSV for each scene, engine and round.")
    private Path csv;

    @Option(
            names = "--markdown",
            paramLabel = "FILE",
            description = "Writes the measured part of a page such as docs/performance.md.")
    private Path page;

    @Option(
            names = "--out",
            paramLabel = "DIR",
            defaultValue = "build/bench",
            description = "Where runs are kept (default: ${DEFAULT-VALUE}).")
    private Path out;

    @Spec private CommandSpec spec;

    @Override
    public Integer call() {
        Options.requireBetween(spec, "--rounds", rounds, 1, MOST_ROUNDS);
        if (steps != null) {
            Options.requireBetween(spec, "--steps", steps, 1, MOST_STEPS);
        }
        Options.requireBetween(spec, "--runs", runs, 1, MOST_ROUNDS);
        for (int count : workers) {
            Options.requireBetween(spec, "--workers", count, 1, Pool.MOST_WORKERS);
        }
        if (!rehearsed.isEmpty() && workers.isEmpty()) {
            throw new ParameterException(
                    spec.commandLine(), "--rehearse needs --workers to compare with, such as 1");
        }
        for (int count : rehearsed) {
            Options.requireBetween(spec, "--rehearse", count, 2, Pool.MOST_WORKERS);
        }
        Destination.requireFile(spec, "--csv", csv);
        Destination.requireFile(spec, "--markdown", page);
        Destination.requireDirectory(spec, "--out", out);
        PrintWriter written = spec.commandLine().getOut();
        Engines.missing().forEach(this::tell);
        try {
            found().forEach(written::println);
            return 0;
        } catch (IllegalStateException | IOException | UncheckedIOException cause) {
            tell("FAILED: " + cause.getMessage());
            return 1;
        }
    }

    private List<String> found() throws IOException {
        if (areQueries) {
            return ask();
        }
        if (areLarge) {
            return told(new LargeBench(LargeBench.SIZES).run(this::tell), environment());
        }
        if (!workers.isEmpty()) {
            return share();
        }
        return moving.isEmpty() ? study() : move();
    }

    /** Writes the page if one is wanted; returns what to print. */
    private List<String> told(Report found, Environment measured) throws IOException {
        if (page != null) {
            MeasuredPart.write(page, found.markdown(measured.provenance()));
        }
        return found.text();
    }

    private List<String> share() throws IOException {
        List<BenchScene> shared = new ArrayList<>();
        if (scenes.isEmpty() || !moving.isEmpty()) {
            shared.addAll(movingScenes());
        }
        if (!scenes.isEmpty()) {
            shared.addAll(chosenScenes());
        }
        WorkersBench bench = new WorkersBench(shared, crews(), movingSteps(), runs);
        return told(bench.run(this::tell), environment());
    }

    private List<String> ask() throws IOException {
        QueryBench bench =
                new QueryBench(
                        chosenEngines().stream()
                                .flatMap(engine -> Contestant.of(engine, List.of(QUERIED)))
                                .filter(one -> one.isOurs() || one.isFastestPeer())
                                .toList(),
                        runs);
        return told(bench.run(this::tell), environment().withFlags(bench.method()));
    }

    private List<String> study() throws IOException {
        Inquiry inquiry = new Inquiry(chosenScenes(), chosenEngines(), rounds, out);
        return BenchStudy.make(
                inquiry,
                BenchProcess.class,
                environment(),
                Optional.ofNullable(csv),
                Optional.ofNullable(page),
                this::tell);
    }

    /** The scenes that were named, or all. */
    private List<BenchScene> movingScenes() {
        List<BenchScene> known = MovingScenes.all();
        if (moving.isEmpty() || moving.equals(List.of(ALL))) {
            return known;
        }
        Options.requireKnown(
                spec, "--moving", moving, known.stream().map(BenchScene::name).toList());
        return known.stream().filter(scene -> moving.contains(scene.name())).toList();
    }

    private int movingSteps() {
        return steps == null ? MovingScenes.STEPS : steps;
    }

    private List<String> move() throws IOException {
        MovingBench bench =
                new MovingBench(
                        movingScenes(),
                        chosenEngines().stream().flatMap(this::contestants).toList(),
                        movingSteps(),
                        runs,
                        out);
        return told(bench.run(this::tell), environment().withFlags(bench.method()));
    }

    private List<Crew> crews() {
        return Stream.concat(
                        workers.stream().map(count -> new Crew(count, false)),
                        rehearsed.stream().map(count -> new Crew(count, true)))
                .toList();
    }

    private Stream<Contestant> contestants(Engine engine) {
        Options.requireKnown(spec, "--preset", presets, Contestant.PRESETS);
        return Contestant.of(engine, presets.isEmpty() ? Contestant.PRESETS : presets);
    }

    private List<BenchScene> chosenScenes() {
        List<BenchScene> known = new ArrayList<>(BenchScenes.all());
        known.add(BenchProcess.level());
        List<String> names = new ArrayList<>(known.stream().map(BenchScene::name).toList());
        names.add(SWEEP);
        Options.requireKnown(spec, "--scenes", scenes, names);
        boolean isAll = scenes.isEmpty();
        List<BenchScene> chosen =
                new ArrayList<>(
                        known.stream()
                                .filter(scene -> isAll || scenes.contains(scene.name()))
                                .toList());
        if (isAll || scenes.contains(SWEEP)) {
            chosen.addAll(BenchScenes.sweep());
        }
        return steps == null ? chosen : chosen.stream().map(scene -> scene.timing(steps)).toList();
    }

    private List<Engine> chosenEngines() {
        List<Engine> known = Engines.all();
        Options.requireKnown(
                spec, "--engines", engines, known.stream().map(Inquiry::shortName).toList());
        return known.stream()
                .filter(engine -> engines.isEmpty() || engines.contains(Inquiry.shortName(engine)))
                .toList();
    }

    private Environment environment() {
        String today = LocalDate.now().toString();
        return new Environment(
                Machine.words(), Machine.jvm(), "", Machine.commit(), today, command());
    }

    /** The command as it was typed, without the files to write. */
    private String command() {
        return "./rigibo bench"
                + (scenes.isEmpty() ? "" : " --scenes " + String.join(",", scenes))
                + (engines.isEmpty() ? "" : " --engines " + String.join(",", engines))
                + (areQueries ? " --queries --runs " + runs : "")
                + (areLarge ? " --large" : "")
                + (areQueries || areLarge ? "" : timed())
                + (steps == null ? "" : " --steps " + steps);
    }

    /** The options that say how often scenes are timed, and which moving ones. */
    private String timed() {
        if (moving.isEmpty() && workers.isEmpty()) {
            return " --rounds " + rounds;
        }
        String rehearsing = rehearsed.isEmpty() ? "" : " --rehearse " + joined(rehearsed);
        return (moving.isEmpty() ? "" : " --moving " + String.join(",", moving))
                + (workers.isEmpty() ? "" : " --workers " + joined(workers) + rehearsing)
                + (presets.isEmpty() ? "" : " --preset " + String.join(",", presets))
                + " --runs "
                + runs;
    }

    private static String joined(List<Integer> numbers) {
        return numbers.stream().map(String::valueOf).collect(Collectors.joining(","));
    }

    private void tell(String words) {
        spec.commandLine().getErr().println(words);
    }
}
