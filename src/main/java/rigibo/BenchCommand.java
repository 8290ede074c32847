package rigibo;

import picocli.CommandLine.Command;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
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
                "Times the steps of large scenes by every engine at hand, each in a process of its"
                        + " own, and tells what became of the scenes. Interrupted, it goes on where"
                        + " it was when it is started again. All of it takes about 12 minutes.")
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
                    "pyramid, large-pyramid, tumbler, flood, many-pyramids, free, level, sweep; all"
                            + " of them unless said otherwise.")
    private List<String> scenes = List.of();

    @Option(
            names = "--sweep",
            description =
                    "Floods of 100 to 50,000 discs, and how their time grows: the same as"
                            + " --scenes sweep.")
    private boolean isSweep;

    @Option(
            names = "--engines",
            paramLabel = "ENGINE",
            split = ",",
            description =
                    "rigibo, dyn4j, gdx-box2d, jbox2d, and box2d and rapier once ./rigibo peers has"
                            + " built them; all that are at hand unless said otherwise.")
    private List<String> engines = List.of();

    @Option(
            names = "--rounds",
            paramLabel = "N",
            defaultValue = "3",
            description =
                    "How often every engine is given each scene in turn, 3 unless said otherwise.")
    private int rounds;

    @Option(
            names = "--steps",
            paramLabel = "N",
            description =
                    "Steps timed of each scene, after no more than as many; a number of its own for"
                            + " each unless said otherwise.")
    private Integer steps;

    @Option(
            names = "--moving",
            paramLabel = "SCENE",
            split = ",",
            arity = "0..1",
            fallbackValue = ALL,
            description =
                    "Scenes in which much moves, in place of those above: from each step's time to"
                        + " the deepest overlap on the way, ours at every preset. All of them where"
                        + " none is named: rain-boxes-10 to rain-mixed-1500, settle-20, settle-30,"
                        + " settle-50, struck, towers, belt, shaken, rods, compounds, capsules,"
                        + " cave.")
    private List<String> moving = List.of();

    @Option(
            names = "--queries",
            description =
                    "Rays among 10,000 discs by ours and by gdx-box2d, and what sensors cost, in"
                            + " place of scenes.")
    private boolean areQueries;

    @Option(
            names = "--large",
            description =
                    "What a body costs in worlds of 10,000 and of 100,000 bodies, ours alone, in"
                            + " place of scenes.")
    private boolean areLarge;

    @Option(
            names = "--workers",
            paramLabel = "N",
            split = ",",
            description =
                    "Numbers of workers, such as 1,2: the moving scenes, or those of --scenes, by"
                            + " ours alone at GAME, each step by every number in turn, by the wall"
                            + " clock. It needs as many cores that do nothing else.")
    private List<Integer> workers = List.of();

    @Option(
            names = "--preset",
            paramLabel = "PRESET",
            split = ",",
            description =
                    "DRAFT, GAME, FINE, EXACT: ours in those scenes; all of them unless said"
                            + " otherwise. EXACT takes hours where hundreds of bodies rain.")
    private List<String> presets = List.of();

    @Option(
            names = "--runs",
            paramLabel = "N",
            defaultValue = "7",
            description =
                    "How often each step of a moving scene is timed, 7 unless said otherwise.")
    private int runs;

    @Option(
            names = "--csv",
            paramLabel = "FILE",
            description = "Writes every run as CSV, a line for each scene, engine and round.")
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
            description = "Where runs are kept, build/bench unless said otherwise.")
    private Path out;

    @Spec private CommandSpec spec;

    @Override
    public Integer call() {
        requireWithin("--rounds", rounds, MOST_ROUNDS);
        if (steps != null) {
            requireWithin("--steps", steps, MOST_STEPS);
        }
        requireWithin("--runs", runs, MOST_ROUNDS);
        workers.forEach(count -> requireWithin("--workers", count, Pool.MOST_WORKERS));
        Destination.requireFile(spec, "--csv", csv);
        Destination.requireFile(spec, "--markdown", page);
        Destination.requireDirectory(spec, "--out", out);
        PrintWriter written = spec.commandLine().getOut();
        Engines.missing().forEach(this::tell);
        try {
            found().forEach(written::println);
            written.flush();
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
        WorkersBench bench = new WorkersBench(shared, workers, movingSteps(), runs);
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
        return new BenchStudy(inquiry, BenchProcess.class, environment())
                .make(Optional.ofNullable(csv), Optional.ofNullable(page), this::tell);
    }

    /** Those that were named; all if none was. */
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
        boolean isAll = scenes.isEmpty() && !isSweep;
        List<BenchScene> chosen =
                new ArrayList<>(
                        known.stream()
                                .filter(scene -> isAll || scenes.contains(scene.name()))
                                .toList());
        if (isAll || isSweep || scenes.contains(SWEEP)) {
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

    private void requireWithin(String option, int value, int most) {
        if (value < 1 || value > most) {
            throw Options.refused(spec, option, "must be 1 to " + most + ", was " + value);
        }
    }

    private Environment environment() {
        String today = LocalDate.now().toString();
        return new Environment(
                Machine.words(), Machine.jvm(), "", Machine.commit(), today, command());
    }

    /** What was asked, as it was typed, where to write it left out. */
    private String command() {
        return "./rigibo bench"
                + (scenes.isEmpty() ? "" : " --scenes " + String.join(",", scenes))
                + (isSweep ? " --sweep" : "")
                + (engines.isEmpty() ? "" : " --engines " + String.join(",", engines))
                + (areQueries ? " --queries --runs " + runs : "")
                + (areLarge ? " --large" : "")
                + (areQueries || areLarge ? "" : timed())
                + (steps == null ? "" : " --steps " + steps);
    }

    /** How often scenes are timed, and which of them move. */
    private String timed() {
        if (moving.isEmpty() && workers.isEmpty()) {
            return " --rounds " + rounds;
        }
        String counts = workers.stream().map(String::valueOf).collect(Collectors.joining(","));
        return (moving.isEmpty() ? "" : " --moving " + String.join(",", moving))
                + (counts.isEmpty() ? "" : " --workers " + counts)
                + (presets.isEmpty() ? "" : " --preset " + String.join(",", presets))
                + " --runs "
                + runs;
    }

    private void tell(String words) {
        PrintWriter err = spec.commandLine().getErr();
        err.println(words);
        err.flush();
    }
}
