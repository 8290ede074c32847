package rigibo.frontend.scene.joint;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;

import rigibo.backend.DistanceJoint;
import rigibo.backend.GearJoint;
import rigibo.backend.Joint;
import rigibo.backend.Pool;
import rigibo.backend.PulleyJoint;
import rigibo.backend.RevoluteJoint;
import rigibo.backend.RigidBody;
import rigibo.backend.effect.Effects;
import rigibo.backend.effect.Joints;
import rigibo.backend.geometry.Circle;
import rigibo.backend.geometry.Polygon;
import rigibo.backend.setup.Accuracy;
import rigibo.backend.setup.BodyDefinition;
import rigibo.frontend.scene.Camera;
import rigibo.frontend.scene.RecordingCanvas;

/** Joints look as what they are. */
class JointPictureTest {

    /** px for each m. */
    private static final double SCALE = 80;

    private final Camera camera = new Camera(0, 0, SCALE);
    private final RecordingCanvas canvas = new RecordingCanvas();
    private final Pool pool = new Pool(Effects.usual().with(new Joints()), Accuracy.GAME);
    private final RigidBody wall = pool.add(BodyDefinition.fixed(Polygon.box(6, 0.2)).at(0, 2));
    private final RigidBody ball =
            pool.add(BodyDefinition.dynamic(new Circle(0.3)).at(1, 1).mass(1));

    private void draw() {
        canvas.camera(camera);
        JointPicture.draw(canvas, camera, pool.joints());
    }

    private double lengthOf(RecordingCanvas.Curve curve) {
        double[] xy = curve.xy();
        double sum = 0;
        for (int i = 2; i < xy.length; i += 2) {
            sum += Math.hypot(xy[i] - xy[i - 2], xy[i + 1] - xy[i - 1]);
        }
        return sum / SCALE;
    }

    private static double lowestOf(RecordingCanvas.Curve curve) {
        double lowest = 0;
        for (int i = 1; i < curve.xy().length; i += 2) {
            lowest = Math.max(lowest, curve.xy()[i]);
        }
        return lowest;
    }

    /** As long as it is, however near its ends are, and below both of them. */
    @Test
    void aSlackRopeHangsThrough() {
        pool.join(DistanceJoint.rope(wall, -1, 2, ball, 1, 1, 4));
        draw();
        RecordingCanvas.Curve rope = canvas.curves().get(0);
        assertThat(lengthOf(rope)).isCloseTo(4, within(1e-6));
        assertThat(lowestOf(rope)).isGreaterThan(camera.screenY(0.5));
    }

    @Test
    void aTautRopeIsStraight() {
        double length = Math.sqrt(5);
        pool.join(DistanceJoint.rope(wall, -1, 2, ball, 1, 1, length));
        draw();
        assertThat(lengthOf(canvas.curves().get(0))).isCloseTo(length, within(1e-6));
        assertThat(lowestOf(canvas.curves().get(0))).isCloseTo(camera.screenY(1), within(1e-6));
    }

    /** The wire of a spring is longer than the way from end to end, and its coils are in front. */
    @Test
    void aSpringHasCoils() {
        pool.join(DistanceJoint.rod(wall, 1, 2, ball, 1, 1).spring(2, 0.1));
        draw();
        assertThat(lengthOf(canvas.curves().get(0))).isGreaterThan(1.5);
        assertThat(canvas.curves()).hasSizeGreaterThan(2 + 2 * 4);
    }

    @Test
    void aRodIsALineFromEndToEnd() {
        pool.join(DistanceJoint.rod(wall, 1, 2, ball, 1, 1));
        draw();
        assertThat(canvas.curves()).isEmpty();
        assertThat(canvas.lines().get(0).y1()).isCloseTo(camera.screenY(2), within(1e-9));
        assertThat(canvas.lines().get(0).y2()).isCloseTo(camera.screenY(1), within(1e-9));
    }

    /** Twelve teeth on the smaller wheel, and as many times that on the larger as it is larger. */
    @Test
    void gearedWheelsHaveTeethInTheirRatio() {
        RigidBody large = pool.add(BodyDefinition.dynamic(new Circle(0.5)).at(2, 1));
        Joint first = pool.join(RevoluteJoint.at(wall, ball, 1, 1));
        Joint second = pool.join(RevoluteJoint.at(wall, large, 2, 1));
        pool.join(GearJoint.of(first, second, 2));
        draw();
        assertThat(canvas.bodies()).hasSize(12 + 24);
    }

    /** From one body over both points down to the other. */
    @Test
    void aPulleysRopeRunsOverBothPoints() {
        RigidBody other = pool.add(BodyDefinition.dynamic(new Circle(0.3)).at(-1, 0.5));
        pool.join(PulleyJoint.over(ball, other, 1.8));
        draw();
        double rope = canvas.curves().stream().mapToDouble(this::lengthOf).sum() / 2;
        assertThat(rope).isCloseTo(0.8 + 2 + 1.3, within(1e-6));
    }

    /** Joints far outside the window cost nothing. */
    @Test
    void whatIsFarAwayIsNotDrawn() {
        pool.join(DistanceJoint.rope(wall, -1, 2, ball, 1, 1, 4));
        JointPicture.draw(canvas, new Camera(100, 0, SCALE), pool.joints());
        assertThat(canvas.curves()).isEmpty();
        assertThat(canvas.lines()).isEmpty();
    }
}
