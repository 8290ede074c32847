package rigibo.lab.precision;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;

import rigibo.lab.engine.Line;
import rigibo.lab.engine.RigiBoEngine;
import rigibo.lab.engine.Setting;

import java.util.List;

class ComparisonTest {

    private static Point of(String engine, String setting, Line line, double cost) {
        return FakePoints.point("R1", engine, Setting.of(setting, line), 1e-3, cost);
    }

    /** What is native code, with or without a Java interface, is no engine in Java. */
    @Test
    void theFastestEngineInJavaIsNotANativeOne() {
        List<Point> points =
                List.of(
                        of(RigiBoEngine.NAME, "GAME", Line.PRESETS, 2),
                        of("gdx-box2d 1.14.0", "default", Line.PEERS, 0.1),
                        of("Box2D 3.2.0", "default", Line.PEERS, 0.1),
                        of("Rapier 0.36.1", "default", Line.PEERS, 0.1),
                        of("JBox2D 2.2.1.1", "default", Line.PEERS, 3),
                        of("dyn4j 6.0.0", "default", Line.PEERS, 4));
        Asked asked = Asked.of(FakePoints.PROBLEMS, points).get(0);
        Comparison comparison = Comparison.of(asked).orElseThrow();
        assertThat(comparison.fastestJava()).map(Point::engine).contains("JBox2D 2.2.1.1");
        assertThat(comparison.isNoSlower()).isTrue();
    }
}
