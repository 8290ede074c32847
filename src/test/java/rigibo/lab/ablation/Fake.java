package rigibo.lab.ablation;

import rigibo.lab.ablation.Findings.Ablation;
import rigibo.lab.ablation.Findings.Saving;
import rigibo.lab.ablation.Findings.UseCost;
import rigibo.lab.ablation.probe.Sample;
import rigibo.lab.ablation.probe.Share;
import rigibo.lab.child.Work;

import java.util.List;
import java.util.stream.DoubleStream;

/** Findings with numbers that can be followed by hand. */
final class Fake {

    private static final int RUNS = 20;

    private Fake() {}

    /** A run of so many ns per step in which 10 contacts had 25 rows. */
    static Sample sample(double nanos, int bits) {
        return new Sample(nanos, 0, 0xCAFE, new Work(12, 10, 3, 40, 25), bits);
    }

    /** Twenty pairs that all took the same. */
    static Pairs pairs(double first, double second) {
        return new Pairs(samples(first, 64), samples(second, 128));
    }

    private static List<Sample> samples(double nanos, int bits) {
        return DoubleStream.generate(() -> nanos)
                .limit(RUNS)
                .mapToObj(value -> sample(value, bits))
                .toList();
    }

    /**
     * A scene whose undeclared effects cost 0.2 %, an effect that costs 100 ns and 10 ns for each
     * of 100 users, and a saving of a quarter.
     */
    static Findings findings() {
        return new Findings(
                List.of(new Ablation("flyers", "discs in flight", 30, 41, pairs(5000, 5010))),
                List.of(
                        use(Share.NONE, 0, 1100),
                        use(Share.ONE, 1, 1110),
                        use(Share.HALF, 50, 1600),
                        use(Share.ALL, 100, 2100)),
                List.of(new Saving("flyers", "Gravity", List.of("Buoyancy"), pairs(3000, 4000))));
    }

    private static UseCost use(Share share, int users, double nanos) {
        Pairs pairs = pairs(1000, nanos);
        return new UseCost("Drag", "flyers", "discs", "its drag is not 0", share, users, pairs);
    }
}
