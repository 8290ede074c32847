package rigibo.lab.hardcase;

import rigibo.lab.bench.scene.Crowd;

import java.util.ArrayList;
import java.util.List;

/** Cases of much that moves, M1 to M16. */
final class MovingPiles {

    private static final String RAIN =
            "Heaps lie still and yet are not calm enough to sleep; in larger ones what lands in the"
                    + " midst of a pile sinks in, deepest where passes leave off, and what is then"
                    + " pushed out of overlap has energy from nothing.";

    private MovingPiles() {}

    /** Those whose every figure is within its limit at GAME and at EXACT. */
    static List<HardCase> held() {
        List<HardCase> cases = new ArrayList<>();
        cases.add(upTo100(Crowd.DISCS, ""));
        cases.add(ElasticPolygons.slow());
        cases.add(ElasticPolygons.fast());
        cases.add(FlatPlateBowl.ofDisc());
        cases.add(FlatPlateBowl.ofBox());
        cases.add(new StepClimb());
        cases.add(new RoundHill());
        cases.addAll(BornAtOneSpot.several());
        cases.addAll(DrivenCrowd.held());
        return cases;
    }

    /** Those whose truth is not yet reached in every figure. */
    static List<HardCase> open() {
        List<HardCase> cases = new ArrayList<>();
        cases.add(upTo100(Crowd.BOXES, RAIN));
        cases.add(upTo100(Crowd.MIXED, RAIN));
        for (Crowd crowd : Crowd.values()) {
            List<Integer> all = List.of(101, 163, 240, 310, 400);
            cases.add(new Rain(crowd, 400, 0.05, List.of(110), all, RAIN));
        }
        cases.add(SettlingPyramid.low());
        cases.add(SettlingPyramid.high());
        cases.add(new BulletIntoRow());
        cases.add(new RockingBlock());
        cases.add(new MovingFloor());
        cases.addAll(BornAtOneSpot.many());
        cases.add(new OverfullRoom());
        cases.add(new WeakPush());
        cases.addAll(DrivenCrowd.open());
        cases.add(new FarPiles());
        cases.add(new ScaledScene());
        return cases;
    }

    /** Those that take minutes. */
    static List<HardCase> longRuns() {
        List<HardCase> cases = new ArrayList<>();
        for (Crowd crowd : Crowd.values()) {
            List<Integer> all = List.of(500, 800, 1100, 1500);
            cases.add(new Rain(crowd, 1500, 0.10, List.of(900), all, RAIN));
        }
        for (Avalanche avalanche : Avalanche.values()) {
            cases.add(new CalmWithoutDamping(avalanche));
        }
        return cases;
    }

    private static Rain upTo100(Crowd crowd, String finding) {
        List<Integer> all = List.of(10, 17, 29, 50, 73, 100);
        return new Rain(crowd, 100, 0.02, List.of(11, 29), all, finding);
    }
}
