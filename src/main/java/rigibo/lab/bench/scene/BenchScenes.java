package rigibo.lab.bench.scene;

import java.util.List;
import java.util.Locale;
import java.util.NoSuchElementException;
import java.util.stream.Stream;

/**
 * All scenes of the bench but the level, which only the game can read. The numbers of steps are
 * chosen so that each scene shows what it is for and the slowest engine takes at most a minute.
 */
public final class BenchScenes {

    /** The beginning of the names of the sweep's scenes; the number of discs follows. */
    private static final String SWEPT = "flood-of-";

    /** The sizes that every engine runs, in discs. */
    private static final List<Integer> SIZES = List.of(100, 300, 1000, 3000, 10_000);

    /** The sizes that only our engine runs, since the slowest others would take minutes. */
    private static final List<Integer> LARGE_SIZES = List.of(20_000, 50_000);

    /** The pace of the sweep, whose discs are at rest within 3 s. */
    private static final Pace SWEEP = new Pace(2, 0, 180);

    /**
     * The pace of the undermined pyramid. There are so few timed steps that the first, in which the
     * box is removed, is the 99th percentile.
     */
    private static final Pace UNDERMINED = new Pace(2, 120, 60);

    private BenchScenes() {}

    /** The scenes outside the sweep. */
    public static List<BenchScene> all() {
        return List.of(
                new BenchScene(
                        "pyramid",
                        "820 boxes, 40 at the base, at rest",
                        new Pace(1, 60, 240),
                        () -> Pyramids.one(40)),
                new BenchScene(
                        "large-pyramid",
                        "5,050 boxes, 100 at the base, at rest",
                        new Pace(1, 60, 120),
                        () -> Pyramids.one(100)),
                new BenchScene(
                        "undermined-sleeper",
                        "465 boxes in a sleeping pyramid whose base loses a box at the first timed"
                                + " step, the p99",
                        UNDERMINED,
                        () -> Pyramids.undermined(30, UNDERMINED.settling(), Pyramids.withSleep())),
                new BenchScene(
                        "undermined-awake",
                        "the same pyramid awake: what its loss may be compared with",
                        UNDERMINED,
                        () ->
                                Pyramids.undermined(
                                        30, UNDERMINED.settling(), Pyramids.withoutSleep())),
                new BenchScene(
                        "tumbler",
                        "2,025 boxes of 0.25 m in a drum that turns by 25°/s",
                        new Pace(0, 150, 150),
                        () -> Tumbler.of(45)),
                new BenchScene(
                        "flood",
                        "5,000 discs of radius 0.25 m and elasticity 0.5, poured into a trough of"
                                + " 40 m, from the first step until they lie",
                        new Pace(2, 0, 300),
                        () -> Floods.of(5000)),
                new BenchScene(
                        "many-pyramids",
                        "22,000 boxes in 400 pyramids of 10 at the base, at rest",
                        new Pace(0, 15, 40),
                        () -> Pyramids.field(20, 20, 10)),
                new BenchScene(
                        "free",
                        "20,000 boxes in flight that touch nothing",
                        new Pace(1, 60, 240),
                        () -> Flyers.of(20_000)));
    }

    /**
     * The scene with a name, in the sweep or not.
     *
     * @throws NoSuchElementException naming it where there is none
     */
    public static BenchScene named(String name) {
        return Stream.concat(all().stream(), sweep().stream())
                .filter(scene -> scene.name().equals(name))
                .findFirst()
                .orElseThrow(() -> new NoSuchElementException("no scene '" + name + "'"));
    }

    /** The sweep: floods of equal depth and growing width. */
    public static List<BenchScene> sweep() {
        return Stream.concat(SIZES.stream(), LARGE_SIZES.stream()).map(BenchScenes::swept).toList();
    }

    private static BenchScene swept(int discs) {
        return new BenchScene(
                SWEPT + discs,
                String.format(Locale.ROOT, "%,d discs", discs),
                SWEEP,
                () -> Floods.asDeepAsAny(discs));
    }

    /** Whether a scene belongs to the sweep. */
    public static boolean isSwept(String name) {
        return name.startsWith(SWEPT);
    }

    /** How many discs a scene of the sweep has. */
    public static int discs(String name) {
        return Integer.parseInt(name.substring(SWEPT.length()));
    }

    /** Whether engines other than ours run a scene. */
    public static boolean isForAll(String name) {
        return !isSwept(name) || SIZES.contains(discs(name));
    }
}
