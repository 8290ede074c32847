package rigibo.frontend.demo;

import rigibo.backend.effect.Contacts;
import rigibo.backend.effect.Effects;
import rigibo.backend.effect.Friction;
import rigibo.backend.effect.Gravity;
import rigibo.backend.effect.Rotation;
import rigibo.backend.geometry.Angle;
import rigibo.frontend.scene.Camera;
import rigibo.frontend.scene.Canvas;
import rigibo.frontend.scene.Color;
import rigibo.frontend.scene.SceneEntry;
import rigibo.frontend.scene.Skin;
import rigibo.frontend.scene.Words;
import rigibo.frontend.scene.effects.EffectReason;
import rigibo.frontend.scene.widget.Button;
import rigibo.frontend.scene.widget.Readout;
import rigibo.frontend.scene.widget.Slider;
import rigibo.frontend.scene.widget.Widget;

import java.util.ArrayList;
import java.util.List;

/**
 * Three lanes of ice, wood and rubber: where a launched box stops, as predicted and as simulated.
 */
final class FrictionDemo implements Demo {

    private final Words words;

    private static final double GRAVITY = 9.81;

    /** The formula of the distance until a box stops. */
    private static final String FORMULA = "v²/2g(µ·cosα + sinα)";

    private static final double START = 2;
    private static final double FLAG = 48;

    /** Height of the plate with a lane's name, and of the floor above it, px. */
    private static final double SIGN = 24;

    private final List<Lane> lanes =
            List.of(
                    new Lane("ice", 0.03, START, 0, Skin.ICE),
                    new Lane("wood", 0.4, START, -3, Skin.WOOD),
                    new Lane("rubber", 0.9, START, -6, Skin.RUBBER));
    private Workbench bench;
    private double slope;
    private double speed = 5;
    private double mass = 10;

    FrictionDemo(Words words) {
        this.words = words;
    }

    /** How the menu lists it. */
    static SceneEntry entry() {
        return SceneEntry.of("friction", director -> new DemoScene(director, FrictionDemo::new));
    }

    @Override
    public String name() {
        return "friction";
    }

    @Override
    public Effects effects() {
        return Effects.of(new Gravity(0, -GRAVITY), new Contacts(), new Rotation(), new Friction());
    }

    @Override
    public List<EffectReason> reasons() {
        return List.of(
                new EffectReason(new Gravity(0, -GRAVITY), words.of("friction.gravity")),
                new EffectReason(new Contacts(), words.of("friction.contacts")),
                new EffectReason(new Rotation(), words.of("friction.rotation")),
                new EffectReason(new Friction(), words.of("friction.friction-why")));
    }

    @Override
    public Camera camera() {
        return new Camera(3.2, -2.1, 42);
    }

    /** The lanes begin at the left edge. */
    @Override
    public Camera cameraUpright() {
        return new Camera(8.2, -2.1, 42);
    }

    /** On ice a box slides far. */
    @Override
    public boolean goesOnToTheRight() {
        return true;
    }

    @Override
    public void build(Workbench on) {
        bench = on;
        launch();
    }

    @Override
    public void followed() {
        launch();
    }

    private void launch() {
        lanes.forEach(lane -> lane.launch(bench, Angle.ofDegrees(slope), speed, mass));
    }

    @Override
    public void afterStep(Workbench on) {
        lanes.forEach(Lane::afterStep);
    }

    @Override
    public List<Widget> widgets() {
        List<Widget> widgets = new ArrayList<>();
        widgets.add(new Slider(words, "friction.ramp", "%.0f°", 0, 60, 1, () -> slope, this::tilt));
        widgets.add(
                new Slider(
                        words,
                        "friction.speed",
                        "%.1f m/s",
                        1,
                        8,
                        0.5,
                        () -> speed,
                        v -> speed = v));
        widgets.add(
                new Slider(
                        words, "friction.mass", "%.0f kg", 1, 100, 1, () -> mass, v -> mass = v));
        widgets.add(new Button(words.of("friction.launch"), this::launch));
        for (Lane lane : lanes) {
            widgets.add(new Readout(name(lane), () -> limit(lane)));
            widgets.add(
                    new Readout(
                            "  " + words.of("friction.predicted"), () -> metres(lane.predicted())));
            widgets.add(
                    new Readout(
                            "  " + words.of("friction.reached"), () -> metres(lane.farthest())));
            widgets.add(new Readout("  " + words.of("friction.error"), () -> error(lane)));
        }
        widgets.add(new Readout("", () -> FORMULA));
        widgets.add(new Readout(words.of("friction.heat"), this::heat));
        return widgets;
    }

    private String name(Lane lane) {
        return words.of("friction." + lane.name);
    }

    private void tilt(double degrees) {
        slope = degrees;
        launch();
    }

    /** The steepest ramp on which the lane holds a box: arctan μ. */
    private String limit(Lane lane) {
        double degrees = Angle.inDegrees(Angle.atan2(lane.friction, 1));
        return words.of(
                "friction.limit",
                words.number("%.2f", lane.friction),
                words.number("%.1f", degrees));
    }

    private String metres(double length) {
        return words.number("%.3f m", length);
    }

    private String error(Lane lane) {
        double millis = 1000 * (lane.farthest() - lane.predicted());
        return lane.hasTurned() ? words.number("%+.3f mm", millis) : words.of("friction.going");
    }

    /** Energy that friction has taken out of the launches. */
    private String heat() {
        double joules = lanes.stream().mapToDouble(Lane::heat).sum();
        return words.number("%.1f J", joules);
    }

    /**
     * Draws a flag where each box should stop or turn, and below it a dot that lights up when the
     * box stands.
     */
    @Override
    public void draw(Workbench on, Canvas canvas) {
        for (Lane lane : lanes) {
            drawFlag(on.camera(), canvas, lane);
            double tickX = on.camera().screenX(lane.floorX(lane.gone()));
            double tickY = on.camera().screenY(lane.floorY(lane.gone()));
            canvas.disc(tickX, tickY + 10, 5, lane.isStill() ? Color.GOOD : Color.TEXT_DIM);
            drawSign(on.camera(), canvas, lane);
        }
    }

    private static void drawFlag(Camera camera, Canvas canvas, Lane lane) {
        double x = camera.screenX(lane.floorX(lane.predicted()));
        double y = camera.screenY(lane.floorY(lane.predicted()));
        canvas.line(x, y, x, y - FLAG, 3, Color.BRASS);
        canvas.panel(x, y - FLAG, 26, 16, 3, Color.BRASS);
    }

    /** Draws the lane's name below its start, and whether its ramp holds a box that has stopped. */
    private void drawSign(Camera camera, Canvas canvas, Lane lane) {
        String key = lane.holds() ? "friction.holds" : "friction.slides";
        String sign = words.of(key, name(lane));
        double width = canvas.textWidth(sign, 16, Canvas.Font.WORDS);
        double x = camera.screenX(lane.floorX(0));
        double half = canvas.layout().lettered(SIGN / 2);
        double y = camera.screenY(lane.floorY(0)) + SIGN + half;
        canvas.panel(x - 8, y - half, width + 16, 2 * half, 8, Color.PANEL);
        canvas.text(sign, x, y, 16, Canvas.Font.WORDS, Canvas.Align.LEFT, Color.TEXT);
    }

    List<Lane> lanes() {
        return lanes;
    }
}
