package rigibo.lab.hardcase;

import rigibo.backend.geometry.Circle;
import rigibo.backend.geometry.Polygon;
import rigibo.backend.geometry.Shape;
import rigibo.lab.bench.scene.Crowd;

import java.util.List;
import java.util.Locale;

/** Cases of moving piles, M1 to M16. */
final class MovingPiles {

    private static final Shape DISC = new Circle(0.35);
    private static final Shape BOX = Polygon.box(0.8, 0.6);

    private static final String RAIN =
            "Heaps lie still and yet are not calm enough to sleep. In larger ones a body that lands"
                    + " inside a pile sinks in, deepest where passes end, and its removal from"
                    + " overlap adds energy.";

    private static final String LINE =
            "Bodies that begin at one point part along one line: 200 of them need more than 10 s"
                    + " for that at three widths a second.";

    private static final String DRIVEN =
            "At DRAFT a body that lands on others under load sinks in where passes end; a rod is"
                    + " thin, so that the same depth is more of its width.";

    private static final String SPUN =
            "At EXACT a corner of a box is in the floor by 2 to 4 % after three bullets in a"
                    + " thousand: a strike turns it by 0.3 rad within a substep, or it evades"
                    + " overlap that nothing can part.";

    private MovingPiles() {}

    /** Cases that keep every limit at GAME and at EXACT. */
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

    /** Cases that do not yet keep every limit, or take long to. */
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
                        "a heavy bullet passes through no box and pushes none through a wall",
                        BulletIntoRow.ANY)
                .finding(SPUN);
        list.fromGame(
                        "M3/hardest",
                        "a bullet of over a thousand times the mass at over 400 m/s passes through"
                                + " no box of a long row",
                        BulletIntoRow.HARDEST)
                .finding(SPUN);
        list.fromGame(
                "M7",
                "a rocking block loses energy only at impacts, as much as Housner says",
                new RockingBlock());
        list.fromGame(
                        "M8",
                        "a pile on a moving floor behaves as on a floor at rest",
                        new MovingFloor())
                .finding(
                        "A pyramid can carry its load in more ways than one. While it moves,"
                                + " round-off decides which of them elimination finds.");
        List<Integer> many = List.of(23, 50, 100, 200);
        born(list, "many-discs", new BornAtOneSpot(DISC, List.of(23), many)).finding(LINE);
        born(list, "many-boxes", new BornAtOneSpot(BOX, List.of(23), many)).finding(LINE);
        list.fromGame(
                        "M10",
                        "an overfull room comes to rest and reports its overlap",
                        new OverfullRoom())
                .finding(
                        "One room in forty does not come to rest: a falling body makes its island"
                            + " count as moving, and that stirs it further. Tests do not run this"
                            + " row at EXACT, which takes too long.");
        list.fromGame(
                        "M12",
                        "a weak push moves a body that nothing holds, whatever lies beside it",
                        new WeakPush())
                .finding(
                        "A push below the round-off of the loads at its contacts cannot be told"
                                + " from rest.");
        driven(list, "belt", DrivenCrowd.BELT).finding(DRIVEN);
        list.fromGame(
                        "M14",
                        "far from the origin a pile takes the same work and comes to rest",
                        new FarPiles())
                .finding(
                        "Far from the origin coordinates are coarser, so that a pyramid settles"
                                + " differently and may take more work until it rests; why twice as"
                                + " much is not known.");
        list.add(
                "M15", "a scene 64 times as large or small keeps the same bits", new ScaledScene());
        return list.all();
    }

    /** Cases that take minutes. */
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
        String title = "a settling pyramid throws no box";
        list.fromGame("M2/" + storeys, title, scenes);
    }

    private static void bowl(CaseList list, FlatPlateBowl slider) {
        String name = name(slider);
        String loses = " in a bowl of plates loses energy at the kinks alone, and gains none";
        list.fromGame("M4/" + name, "a " + name + loses, slider);
    }

    private static CaseList born(CaseList list, String name, Scenes scenes) {
        String title = "bodies that begin at one point part slowly, however many there are";
        return list.fromGame("M9/" + name, title, scenes);
    }

    private static void elastic(CaseList list, String name, Scenes scenes) {
        list.fromGame("M11/" + name, "elastic polygons keep their energy at any speed", scenes);
    }

    private static CaseList driven(CaseList list, String name, Scenes scenes) {
        String title =
                "a driven crowd ("
                        + name
                        + ") loses no body and gains only the energy of its drive";
        return list.add("M13/" + name, title, scenes);
    }
}
