package rigibo.lab.bench.scene;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.NoSuchElementException;
import java.util.function.Supplier;

/** Scenes in which much moves, timed from the first step. */
public final class MovingScenes {

    /** The numbers of bodies of the rains. */
    static final List<Integer> SIZES = List.of(10, 20, 50, 100, 200, 400, 800, 1500);

    /** The most steps of a scene: 10 s. */
    public static final int STEPS = 600;

    private static final Pace PACE = new Pace(0, 0, STEPS);

    private static final long SEED = 20;

    private static final List<BenchScene> MORE =
            List.of(
                    scene(
                            "struck",
                            "a pyramid, 40 at the base, struck at its foot each second",
                            () -> Commotions.struck(40)),
                    scene(
                            "towers",
                            "20 towers of 30 boxes, the topmost of each pushed at 2 m/s",
                            () -> Commotions.towers(20, 30)),
                    scene(
                            "belt",
                            "80 boxes that a belt of 3 m/s jams against a wall",
                            () -> Commotions.belt(80)),
                    scene(
                            "shaken",
                            "100 boxes in a closed box shaken at 6 g and 3 Hz",
                            () -> Commotions.shaken(100)),
                    scene(
                            "rods",
                            "300 rods, a hundred times as long as thick, that fall crosswise",
                            () -> Commotions.rods(300)),
                    scene(
                            "compounds",
                            "1500 bodies of two to five parts that rain into a trough",
                            () -> ShapeCrowds.compounds(1500, SEED)),
                    scene(
                            "capsules",
                            "1500 capsules that rain into a trough",
                            () -> ShapeCrowds.capsules(1500, SEED)),
                    scene(
                            "cave",
                            "500 boxes and discs that fall in a cave of 2000 edges",
                            () -> ShapeCrowds.cave(500, 2000, SEED)),
                    scene(
                            "joint-grid",
                            "900 discs in a net of hinges that hangs by its corners",
                            () -> Assemblies.grid(30)),
                    scene(
                            "ragdolls",
                            "100 ragdolls of 11 bodies that fall on each other",
                            () -> Assemblies.ragdolls(100)),
                    scene(
                            "bridge",
                            "5 bridges of 40 planks, on each of which 10 discs fall",
                            () -> Assemblies.bridges(5, 40)),
                    scene(
                            "doors",
                            "50 doors, thrown open, that damped springs pull shut",
                            () -> Assemblies.doors(50)),
                    scene(
                            "cars",
                            "30 cars on springs that drive over bumps",
                            () -> Assemblies.cars(30)));

    private MovingScenes() {}

    /** All moving scenes. */
    public static List<BenchScene> all() {
        List<BenchScene> scenes = new ArrayList<>();
        for (Crowd crowd : Crowd.values()) {
            SIZES.forEach(size -> scenes.add(rain(crowd, size)));
        }
        for (int base : new int[] {20, 30, 50}) {
            scenes.add(
                    scene(
                            "settle-" + base,
                            "a pyramid, "
                                    + base
                                    + " at the base, that falls together from gaps of"
                                    + " 2 cm",
                            () -> Commotions.settling(base, 0.02)));
        }
        scenes.addAll(MORE);
        return scenes;
    }

    /**
     * The scene of a name.
     *
     * @throws NoSuchElementException naming it where there is none
     */
    public static BenchScene named(String name) {
        return all().stream()
                .filter(scene -> scene.name().equals(name))
                .findFirst()
                .orElseThrow(() -> new NoSuchElementException("no scene '" + name + "'"));
    }

    private static BenchScene rain(Crowd crowd, int size) {
        String kind = crowd.name().toLowerCase(Locale.ROOT);
        String what = crowd == Crowd.MIXED ? "boxes and discs" : kind;
        return scene(
                "rain-" + kind + "-" + size,
                size + " " + what + " that rain into a trough",
                () -> new Scene(Crowd.EFFECTS, crowd.rain(size, SEED)));
    }

    private static BenchScene scene(String name, String what, Supplier<Scene> scene) {
        return new BenchScene(name, what, PACE, scene);
    }
}
