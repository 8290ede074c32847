package rigibo.lab.hardcase;

import rigibo.backend.geometry.Circle;
import rigibo.backend.geometry.Polygon;
import rigibo.backend.geometry.Shape;
import rigibo.lab.bench.scene.Commotions;
import rigibo.lab.bench.scene.Crowd;

import java.util.ArrayList;
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

    private MovingPiles() {}

    /** Those whose every figure is within its limit at GAME and at EXACT. */
    static List<HardCase> held() {
        List<Integer> several = List.of(2, 9);
        List<Integer> all = List.of(2, 3, 5, 9);
        return List.of(
                upTo100(Crowd.DISCS),
                elastic("slow", ElasticPolygons.SLOW),
                elastic("fast", ElasticPolygons.FAST),
                bowl(FlatPlateBowl.DISC),
                bowl(FlatPlateBowl.BOX),
                HardCase.of(
                                "M5",
                                "a rolling disc climbs a step if it is fast enough, and only then",
                                new StepClimb())
                        .limitedFrom(Preset.GAME),
                HardCase.of(
                                "M6",
                                "a disc leaves a round hill where its weight no longer holds it",
                                new RoundHill())
                        .limitedFrom(Preset.GAME),
                born("few-discs", new BornAtOneSpot(DISC, several, all)),
                born("few-boxes", new BornAtOneSpot(BOX, several, all)),
                driven(
                        "shaken",
                        new DrivenCrowd(
                                Commotions::shaken,
                                5,
                                DrivenCrowd::isInTheBox,
                                List.of(12),
                                List.of(12, 61, 100))),
                driven(
                                "rods",
                                new DrivenCrowd(
                                        Commotions::rods,
                                        8,
                                        DrivenCrowd::isAboveTheFloor,
                                        List.of(41),
                                        List.of(41, 140, 300)))
                        .finding(DRIVEN),
                driven(
                        "towers",
                        new DrivenCrowd(
                                storeys -> Commotions.towers(storeys / 4, storeys),
                                8,
                                DrivenCrowd::isAboveTheFloor,
                                List.of(9),
                                List.of(9, 17, 30))));
    }

    /** Those whose truth is not yet reached in every figure. */
    static List<HardCase> open() {
        List<HardCase> cases = new ArrayList<>();
        cases.add(upTo100(Crowd.BOXES).finding(RAIN));
        cases.add(upTo100(Crowd.MIXED).finding(RAIN));
        for (Crowd crowd : Crowd.values()) {
            List<Integer> sizes = List.of(101, 163, 240, 310, 400);
            cases.add(rain(crowd, 400, 0.05, List.of(110), sizes).finding(RAIN));
        }
        cases.add(settling("20", SettlingPyramid.LOW));
        cases.add(settling("100", SettlingPyramid.HIGH));
        cases.add(
                HardCase.of(
                                "M3",
                                "a heavy bullet drives nothing through a wall, nor itself through a"
                                        + " box",
                                new BulletIntoRow())
                        .limitedFrom(Preset.GAME)
                        .finding(
                                "Of a thousand bullets two or three, heavy and fast, are through a"
                                        + " box: elimination has spent what an island is worth, and"
                                        + " passes give way wherever they leave off."));
        cases.add(
                HardCase.of(
                                "M7",
                                "a rocking block loses at each impact what Housner says, and"
                                        + " nothing between",
                                new RockingBlock())
                        .limitedFrom(Preset.GAME));
        cases.add(
                HardCase.of(
                                "M8",
                                "a pile on a moving floor fares as on a floor at rest",
                                new MovingFloor())
                        .limitedFrom(Preset.GAME)
                        .finding(
                                "Storeys of a regular pyramid land at the same time, and from one"
                                    + " impact to the next round-off can choose which of two equal"
                                    + " ones is an impact at all."));
        List<Integer> many = List.of(23, 50, 100, 200);
        cases.add(born("many-discs", new BornAtOneSpot(DISC, List.of(23), many)).finding(LINE));
        cases.add(born("many-boxes", new BornAtOneSpot(BOX, List.of(23), many)).finding(LINE));
        cases.add(
                HardCase.of(
                                "M10",
                                "a room that is too full comes to rest and says so",
                                new OverfullRoom())
                        .limitedFrom(Preset.GAME)
                        .finding(
                                "One room in forty goes on: what falls in it makes it one that"
                                    + " moves, and then it is stirred. The row is kept, but takes"
                                    + " tests too long at EXACT."));
        cases.add(
                HardCase.of(
                                "M12",
                                "a weak push moves what nothing holds, whatever lies beside it",
                                new WeakPush())
                        .limitedFrom(Preset.GAME)
                        .finding(
                                "Below the round-off of what its own contacts carry nothing tells a"
                                        + " push from rest."));
        cases.add(
                driven(
                                "belt",
                                new DrivenCrowd(
                                        Commotions::belt,
                                        10,
                                        DrivenCrowd::isBeforeTheWall,
                                        List.of(24),
                                        List.of(24, 52, 80)))
                        .finding(DRIVEN));
        cases.add(
                HardCase.of(
                                "M14",
                                "far away a pile costs the same and finds its rest",
                                new FarPiles())
                        .limitedFrom(Preset.GAME)
                        .finding(
                                "Far away places are coarser, so that a pyramid settles in another"
                                        + " way and may take more work until it rests; why twice as"
                                        + " much is not known."));
        cases.add(
                HardCase.of(
                        "M15",
                        "a scene 64 times as large or small goes the same way to the last bit",
                        new ScaledScene()));
        return cases;
    }

    /** Those that take minutes. */
    static List<HardCase> longRuns() {
        List<HardCase> cases = new ArrayList<>();
        for (Crowd crowd : Crowd.values()) {
            List<Integer> sizes = List.of(500, 800, 1100, 1500);
            cases.add(rain(crowd, 1500, 0.10, List.of(900), sizes).finding(RAIN));
        }
        for (Avalanche avalanche : Avalanche.values()) {
            String name = name(avalanche);
            String title =
                    "a "
                            + name
                            + " of boxes flows as far, as high and as fast as in truth, on average";
            cases.add(
                    HardCase.of("M16/" + name, title, new CalmWithoutDamping(avalanche))
                            .limitedFrom(Preset.GAME));
        }
        return cases;
    }

    private static String name(Enum<?> one) {
        return one.name().toLowerCase(Locale.ROOT);
    }

    private static HardCase upTo100(Crowd crowd) {
        List<Integer> sizes = List.of(10, 17, 29, 50, 73, 100);
        return rain(crowd, 100, 0.02, List.of(11, 29), sizes);
    }

    private static HardCase rain(
            Crowd crowd, int most, double overlap, List<Integer> few, List<Integer> all) {
        String kind = name(crowd);
        return HardCase.of(
                "M1/" + kind + "/" + most,
                "up to " + most + " " + kind + " rain, pass through nothing and come to rest",
                new Rain(crowd, overlap, few, all));
    }

    private static HardCase settling(String storeys, Scenes scenes) {
        return HardCase.of("M2/" + storeys, "a pyramid that falls together throws nothing", scenes)
                .limitedFrom(Preset.GAME)
                .finding(
                        "When a pyramid that calms down goes from several substeps to one, its kick"
                            + " begins with longer impulses than the last one had, and passes leave"
                            + " part of them.");
    }

    private static HardCase bowl(FlatPlateBowl slider) {
        String name = name(slider);
        return HardCase.of(
                        "M4/" + name,
                        "a "
                                + name
                                + " in a bowl of plates loses what the kinks take, and gains"
                                + " nothing",
                        slider)
                .limitedFrom(Preset.GAME);
    }

    private static HardCase born(String name, Scenes scenes) {
        return HardCase.of(
                        "M9/" + name,
                        "bodies born at one spot part slowly, however many there are",
                        scenes)
                .limitedFrom(Preset.GAME);
    }

    private static HardCase elastic(String name, Scenes scenes) {
        return HardCase.of("M11/" + name, "elastic polygons keep their energy at any speed", scenes)
                .limitedFrom(Preset.GAME);
    }

    private static HardCase driven(String name, Scenes scenes) {
        return HardCase.of(
                "M13/" + name,
                "nobody leaves a crowd that is driven ("
                        + name
                        + "), and no energy comes in unseen",
                scenes);
    }
}
