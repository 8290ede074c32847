package rigibo.lab.hardcase;

import rigibo.lab.bench.scene.Crowd;

import java.util.ArrayList;
import java.util.List;

/** Cases of much that moves, M1 to M16. */
final class MovingPiles {

    private MovingPiles() {}

    /** Those whose truth is not yet reached in every figure. */
    static List<HardCase> open() {
        List<HardCase> cases = new ArrayList<>();
        for (Crowd crowd : Crowd.values()) {
            cases.add(
                    new Rain(crowd, 100, 0.02, List.of(11, 29), List.of(10, 17, 29, 50, 73, 100)));
            cases.add(new Rain(crowd, 400, 0.05, List.of(110), List.of(101, 163, 240, 310, 400)));
        }
        cases.add(SettlingPyramid.low());
        cases.add(SettlingPyramid.high());
        cases.add(new BulletIntoRow());
        cases.add(FlatPlateBowl.ofDisc());
        cases.add(FlatPlateBowl.ofBox());
        cases.add(new StepClimb());
        cases.add(new RoundHill());
        cases.add(new RockingBlock());
        cases.add(new MovingFloor());
        cases.addAll(BornAtOneSpot.cases());
        cases.add(new OverfullRoom());
        cases.addAll(ElasticPolygons.cases());
        cases.add(new WeakPush());
        cases.addAll(DrivenCrowd.cases());
        cases.add(new FarPiles());
        cases.add(new ScaledScene());
        return cases;
    }

    /** Those that take minutes. */
    static List<HardCase> longRuns() {
        List<HardCase> cases = new ArrayList<>();
        for (Crowd crowd : Crowd.values()) {
            cases.add(new Rain(crowd, 1500, 0.10, List.of(900), List.of(500, 800, 1100, 1500)));
        }
        for (Avalanche avalanche : Avalanche.values()) {
            cases.add(new CalmWithoutDamping(avalanche));
        }
        return cases;
    }
}
