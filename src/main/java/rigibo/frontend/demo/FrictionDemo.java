package rigibo.frontend.demo;

import rigibo.backend.RigidBody;
import rigibo.backend.effect.Contacts;
import rigibo.backend.effect.Effects;
import rigibo.backend.effect.Friction;
import rigibo.backend.effect.Gravity;
import rigibo.backend.effect.Rotation;
import rigibo.backend.geometry.Polygon;
import rigibo.backend.setup.BodyDefinition;
import rigibo.backend.setup.Material;
import rigibo.frontend.scene.Camera;
import rigibo.frontend.scene.Canvas;
import rigibo.frontend.scene.Color;
import rigibo.frontend.scene.SceneEntry;
import rigibo.frontend.scene.Skin;
import rigibo.frontend.scene.widget.Button;
import rigibo.frontend.scene.widget.Readout;
import rigibo.frontend.scene.widget.Slider;
import rigibo.frontend.scene.widget.Widget;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;

/** Three lanes of ice, wood and rubber: where a launched box stops, predicted and seen. */
final class FrictionDemo implements Demo {

    private static final double GRAVITY = 9.81;
    private static final double START = -5;
    private static final double LANE_LENGTH = 60;
    private static final double HALF_HEIGHT = 0.3;

    private Workbench bench;
    private final List<Lane> lanes = new ArrayList<>();
    private double speed = 5;
    private double mass = 10;

    /** A floor and the box on it. */
    private static final class Lane {
        final String name;
        final double friction;
        final double floor;
        final Skin skin;
        RigidBody box;
        double launched;

        Lane(String name, double friction, double floor, Skin skin) {
            this.name = name;
            this.friction = friction;
            this.floor = floor;
            this.skin = skin;
        }

        /** v²/(2μg), m. */
        double predicted() {
            return launched * launched / (2 * friction * GRAVITY);
        }

        double gone() {
            return box.x() - START;
        }
    }

    /** How the menu lists it. */
    static SceneEntry entry() {
        return new SceneEntry(
                "friction",
                "Friction",
                "Ice, wood, rubber: where it stops",
                SceneEntry.Kind.DEMO,
                director -> new DemoScene(director, FrictionDemo::new));
    }

    @Override
    public String title() {
        return "Friction";
    }

    @Override
    public Effects effects() {
        return Effects.of(new Gravity(0, -GRAVITY), new Contacts(), new Rotation(), new Friction());
    }

    @Override
    public Camera camera() {
        return new Camera(2.4, -0.4, 42);
    }

    @Override
    public void build(Workbench on) {
        bench = on;
        lanes.add(new Lane("ice", 0.03, 0, Skin.ICE));
        lanes.add(new Lane("wood", 0.4, -3, Skin.WOOD));
        lanes.add(new Lane("rubber", 0.9, -6, Skin.RUBBER));
        for (Lane lane : lanes) {
            bench.add(
                    BodyDefinition.fixed(Polygon.box(LANE_LENGTH, 0.4))
                            .at(START + LANE_LENGTH / 2 - 2, lane.floor - 0.2)
                            .material(new Material(1, lane.friction, 0)),
                    lane.skin);
        }
        launch();
    }

    private void launch() {
        for (Lane lane : lanes) {
            if (lane.box != null) {
                bench.remove(lane.box);
            }
            lane.launched = speed;
            // Lower than wide, or rubber would tumble it instead of stopping it.
            lane.box =
                    bench.add(
                            BodyDefinition.dynamic(Polygon.box(0.9, 2 * HALF_HEIGHT))
                                    .at(START, lane.floor + HALF_HEIGHT)
                                    .velocity(speed, 0)
                                    .mass(mass)
                                    .material(new Material(1, lane.friction, 0)),
                            Skin.RIGIBO);
        }
    }

    @Override
    public List<Widget> widgets() {
        List<Widget> widgets = new ArrayList<>();
        widgets.add(new Slider("speed", "%.1f m/s", 1, 8, 0.5, () -> speed, v -> speed = v));
        widgets.add(new Slider("mass", "%.0f kg", 1, 100, 1, () -> mass, v -> mass = v));
        widgets.add(new Button("launch", this::launch));
        for (Lane lane : lanes) {
            widgets.add(new Readout(lane.name + " slides to", () -> metres(lane.predicted())));
            widgets.add(new Readout("  is at", () -> metres(lane.gone())));
        }
        widgets.add(new Readout("heat", this::heat));
        return widgets;
    }

    private static String metres(double length) {
        return String.format(Locale.ROOT, "%.3f m", length);
    }

    /** What friction has taken out of the launch. */
    private String heat() {
        double left = bench.pool().kineticEnergy();
        double given = 0;
        for (Lane lane : lanes) {
            given += lane.box.mass() * lane.launched * lane.launched / 2;
        }
        return String.format(Locale.ROOT, "%.1f J", given - left);
    }

    /** The flag where each box should stop. */
    @Override
    public void draw(Workbench on, Canvas canvas) {
        Camera camera = on.camera();
        for (Lane lane : lanes) {
            double x = camera.screenX(START + lane.predicted());
            double y = camera.screenY(lane.floor);
            canvas.line(x, y, x, y - 60, 3, Color.BRASS);
            canvas.panel(x, y - 60, 26, 16, 3, Color.BRASS);
            boolean isStill = Math.abs(lane.box.velocityX()) < 1e-6;
            double tick = camera.screenX(lane.box.x());
            canvas.disc(tick, y + 10, 5, isStill ? Color.GOOD : Color.TEXT_DIM);
            drawName(canvas, lane, y);
        }
    }

    private static void drawName(Canvas canvas, Lane lane, double y) {
        String words =
                String.format(
                        Locale.ROOT,
                        "%s  u = %.2f, holds up to %.1f deg",
                        lane.name,
                        lane.friction,
                        Math.toDegrees(Math.atan(lane.friction)));
        canvas.text(
                words, WIDTH_MARGIN, y + 34, 16, Canvas.Font.WORDS, Canvas.Align.RIGHT, Color.TEXT);
    }

    private static final double WIDTH_MARGIN = 700;

    /** How far each box slid and how far it should have, m: ice, wood, rubber. */
    double[][] slides() {
        return lanes.stream()
                .map(lane -> new double[] {lane.gone(), lane.predicted()})
                .toArray(double[][]::new);
    }
}
