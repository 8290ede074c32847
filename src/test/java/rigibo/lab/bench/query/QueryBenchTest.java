package rigibo.lab.bench.query;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;

import rigibo.backend.effect.Contacts;
import rigibo.backend.effect.Effects;
import rigibo.lab.bench.moving.Contestant;
import rigibo.lab.engine.Engine;
import rigibo.lab.engine.Engines;
import rigibo.lab.engine.World;

import java.util.LinkedHashMap;
import java.util.Map;

/** The queries of the bench, and the report of their cost. */
class QueryBenchTest {

    private static final Contestant OURS = new Contestant("RigiBo", "GAME");
    private static final Contestant PEER = new Contestant("gdx-box2d 1.14.0", "default");

    @Test
    void everyRayOfAKindGoesItsWay() {
        for (Rays kind : Rays.values()) {
            double[] rays = kind.draw(7, 100, 30);
            for (int at = 0; at < rays.length; at += Rays.STRIDE) {
                double dx = rays[at + 2] - rays[at];
                double dy = rays[at + 3] - rays[at + 1];
                // Beginnings are within 15 m, so that differences round at 1e-14.
                assertThat(Math.hypot(dx, dy)).isEqualTo(100, within(1e-12));
                assertThat(Math.abs(rays[at])).isLessThanOrEqualTo(15);
                if (kind == Rays.LEVEL) {
                    assertThat(dy).isZero();
                } else if (kind == Rays.DIAGONAL) {
                    assertThat(dx).isEqualTo(dy, within(1e-12));
                }
            }
        }
    }

    /**
     * The mean free way among discs of radius r, n on a square metre, is 1/(2·r·n): 9/0.45 = 20 m,
     * of which the square's rim lets some rays have more.
     */
    @Test
    void raysGoAsFarAsSoManyDiscsLetThem() {
        Engine ours = Engines.all().get(0);
        try (World world = ours.world(Effects.of(new Contacts()), Engines.setting(ours, "GAME"))) {
            Answers answers = QueryProbe.rays(world, 1);
            for (Rays kind : Rays.values()) {
                assertThat(answers.met()[kind.ordinal()]).isBetween(0.18, 0.25);
                assertThat(answers.nanos()[kind.ordinal()]).isPositive();
            }
        }
    }

    @Test
    void theReportTellsWhatIsMetAndWhatIsNot() {
        Map<Contestant, Answers> found = new LinkedHashMap<>();
        found.put(OURS, answers(2, 2e5));
        found.put(PEER, answers(3, 0));
        assertThat(new QueryReport(found).report().text())
                .contains(
                        "A level ray takes gdx-box2d 1.50 × as long as ours (≥ 2: not met), and"
                                + " goes as far.",
                        "1000 sensors among 2000 bodies add 200 µs to a step (≤ 300 µs: met).");
    }

    private static Answers answers(double nanos, double sensing) {
        return new Answers(
                new double[] {nanos, nanos, nanos}, new double[] {0.24, 0.24, 0.24}, sensing);
    }
}
