package rigibo.lab.hardcase;

import rigibo.backend.geometry.Circle;
import rigibo.backend.geometry.Polygon;
import rigibo.backend.geometry.Shape;
import rigibo.lab.bench.scene.Crowd;

import java.util.List;
import java.util.Locale;

/** Cases of much that moves, M1 to M16. */
final class MovingPiles {

    private static final Shape DISC = new Circle(0.35);
    private static final Shape BOX = Polygon.box(0.8, 0.6);

    private static final String RAIN =
            "Heaps lie still and yet are not calm enough to sleep; in larger ones what lands in the"
                    + " midst of a pile sinks in, deepest where passes leave off, and what is then"
                    + " pushed out of overlap has energy from nothing.";

    private static final String LINE =
            "What begins at the very same place parts along one line: 200 bodies need more than"
                    + " 10 s for that at three widths a second.";

    private static final String DRIVEN =
            "What lands on what others press sinks in where passes leave off at DRAFT; a rod"
                    + " is thin, so that the same depth is more of its width.";

    private static final String SETTLING =
            "When a pyramid that calms down goes from several substeps to one, its kick"
                    + " begins with longer impulses than the last one had, and passes leave"
                    + " part of them.";

    private MovingPiles() {}

    /** Those whose every figure is within its limit at GAME and at EXACT. */
    static List<HardCase> held() {
        CaseList list = new CaseList();
        upTo100(list, Crowd.DISCS);
        elastic(list, "slow", ElasticPolygons.SLOW);
        elastic(list, "fast", ElasticPolygons.FAST);
        bowl(list, FlatPlateBowl.DISC);
        bowl(list, FlatPlateBowl.BOX);
        list.fromGame(
                "M5",
                "a rolling disc climbs a step if it is fast enough, and only then",
                new StepClimb());
        list.fromGame(
                "M6",
                "a disc leaves a round hill where its weight no longer holds it",
                new RoundHill());
        List<Integer> all = List.of(2, 3, 5, 9);
        born(list, "few-discs", new BornAtOneSpot(DISC, List.of(2, 9), all));
        born(list, "few-boxes", new BornAtOneSpot(BOX, List.of(2, 9), all));
        driven(list, "shaken", DrivenCrowd.SHAKEN);
        driven(list, "rods", DrivenCrowd.RODS).finding(DRIVEN);
        driven(list, "towers", DrivenCrowd.TOWERS);
        return list.all();
    }

    /** Those whose truth is not yet reached in every figure. */
    static List<HardCase> open() {
        CaseList list = new CaseList();
        upTo100(list, Crowd.BOXES).finding(RAIN);
        upTo100(list, Crowd.MIXED).finding(RAIN);
        for (Crowd crowd : Crowd.values()) {
            List<Integer> sizes = List.of(101, 163, 240, 310, 400);
            rain(list, 400, new Rain(crowd, 0.05, List.of(110), sizes)).finding(RAIN);
        }
        settling(list, "20", SettlingPyramid.LOW);
        settling(list, "100", SettlingPyramid.HIGH);
        list.fromGame(
                        "M3",
                        "a heavy bullet drives nothing through a wall, nor itself through a box",
                        new BulletIntoRow())
                .finding(
                        "Of a thousand bullets two or three, heavy and fast, are through a box:"
                            + " elimination has spent what an island is worth, and passes give way"
                            + " wherever they leave off.");
        list.fromGame(
                "M7",
                "a rocking block loses at each impact what Housner says, and nothing between",
                new RockingBlock());
        list.fromGame(
                        "M8",
                        "a pile on a moving floor fares as on a floor at rest",
                        new MovingFloor())
                .finding(
                        "A pyramid can carry its load in more ways than one. While it moves,"
                                + " round-off chooses which of them elimination takes.");
        List<Integer> many = List.of(23, 50, 100, 200);
        born(list, "many-discs", new BornAtOneSpot(DISC, List.of(23), many)).finding(LINE);
        born(list, "many-boxes", new BornAtOneSpot(BOX, List.of(23), many)).finding(LINE);
        list.fromGame(
                        "M10",
                        "a room that is too full comes to rest and says so",
                        new OverfullRoom())
                .finding(
                        "One room in forty goes on: what falls in it makes it one that moves, and"
                            + " then it is stirred. The row is kept, but takes tests too long at"
                            + " EXACT.");
        list.fromGame(
                        "M12",
                        "a weak push moves what nothing holds, whatever lies beside it",
                        new WeakPush())
                .finding(
                        "Below the round-off of what its own contacts carry nothing tells a push"
                                + " from rest.");
        driven(list, "belt", DrivenCrowd.BELT).finding(DRIVEN);
        list.fromGame("M14", "far away a pile costs the same and finds its rest", new FarPiles())
                .finding(
                        "Far away places are coarser, so that a pyramid settles in another way and"
                                + " may take more work until it rests; why twice as much is not"
                                + " known.");
        list.add(
                "M15",
                "a scene 64 times as large or small goes the same way to the last bit",
                new ScaledScene());
        return list.all();
    }

    /** Those that take minutes. */
    static List<HardCase> longRuns() {
        CaseList list = new CaseList();
        for (Crowd crowd : Crowd.values()) {
            List<Integer> sizes = List.of(500, 800, 1100, 1500);
            rain(list, 1500, new Rain(crowd, 0.10, List.of(900), sizes)).finding(RAIN);
        }
        for (Avalanche avalanche : Avalanche.values()) {
            String name = name(avalanche);
            String flows = " of boxes flows as far, as high and as fast as in truth, on average";
            list.fromGame("M16/" + name, "a " + name + flows, new CalmWithoutDamping(avalanche));
        }
        return list.all();
    }

    private static String name(Enum<?> one) {
        return one.name().toLowerCase(Locale.ROOT);
    }

    private static CaseList upTo100(CaseList list, Crowd crowd) {
        List<Integer> sizes = List.of(10, 17, 29, 50, 73, 100);
        return rain(list, 100, new Rain(crowd, 0.02, List.of(11, 29), sizes));
    }

    private static CaseList rain(CaseList list, int most, Rain rain) {
        String kind = name(rain.crowd());
        String title =
                "up to " + most + " " + kind + " rain, pass through nothing and come to rest";
        return list.add("M1/" + kind + "/" + most, title, rain);
    }

    private static void settling(CaseList list, String storeys, Scenes scenes) {
        String title = "a pyramid that falls together throws nothing";
        list.fromGame("M2/" + storeys, title, scenes).finding(SETTLING);
    }

    private static void bowl(CaseList list, FlatPlateBowl slider) {
        String name = name(slider);
        String loses = " in a bowl of plates loses what the kinks take, and gains nothing";
        list.fromGame("M4/" + name, "a " + name + loses, slider);
    }

    private static CaseList born(CaseList list, String name, Scenes scenes) {
        String title = "bodies born at one spot part slowly, however many there are";
        return list.fromGame("M9/" + name, title, scenes);
    }

    private static void elastic(CaseList list, String name, Scenes scenes) {
        list.fromGame("M11/" + name, "elastic polygons keep their energy at any speed", scenes);
    }

    private static CaseList driven(CaseList list, String name, Scenes scenes) {
        String title =
                "nobody leaves a crowd that is driven ("
                        + name
                        + "), and no energy comes in unseen";
        return list.add("M13/" + name, title, scenes);
    }
}
