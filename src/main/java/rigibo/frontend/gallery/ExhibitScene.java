package rigibo.frontend.gallery;

import rigibo.backend.RigidBody;
import rigibo.backend.setup.Accuracy;
import rigibo.frontend.scene.Action;
import rigibo.frontend.scene.Camera;
import rigibo.frontend.scene.Canvas;
import rigibo.frontend.scene.Director;
import rigibo.frontend.scene.Grip;
import rigibo.frontend.scene.Impacts;
import rigibo.frontend.scene.Key;
import rigibo.frontend.scene.Link;
import rigibo.frontend.scene.Narrator;
import rigibo.frontend.scene.Pinch;
import rigibo.frontend.scene.PointerButton;
import rigibo.frontend.scene.Scene;
import rigibo.frontend.scene.Tap;
import rigibo.frontend.scene.Words;
import rigibo.frontend.scene.accuracy.AccuracyLink;
import rigibo.frontend.scene.accuracy.Preset;
import rigibo.frontend.scene.joint.JointPicture;
import rigibo.frontend.scene.widget.HandButtons;
import rigibo.frontend.scene.widget.WholePlate;

import java.util.List;
import java.util.Optional;

/** A running exhibit; its bodies can be dragged, and it can be paused and restarted. */
final class ExhibitScene implements Scene {

    private static final double ZOOM = 1.15;

    private final Director director;
    private final Found found;
    private final ExhibitPlates plates;
    private final Grip grip = new Grip();
    private final WholePlate whole;
    private Showing showing;
    private Camera camera;
    private Impacts impacts;

    /** The accuracy that its ghost was made for. */
    private Accuracy hauntedAt = Accuracy.GAME;

    private boolean isPaused;

    /** Whether its plates are hidden. */
    private boolean isBare;

    private boolean isPanning;
    private double lastX;
    private double lastY;

    ExhibitScene(Director director, Found found) {
        this.director = director;
        this.found = found;
        plates = new ExhibitPlates(found, director.words());
        whole = new WholePlate(director.words());
        restart();
    }

    private void restart() {
        grip.letGo();
        Accuracy accuracy = showing == null ? Accuracy.GAME : showing.pool().accuracy();
        showing = new Showing(found.make().get());
        showing.pool().accuracy(accuracy);
        if (plates.isOpen(Side.GHOST)) {
            showing.haunt(found.make().get());
            hauntedAt = accuracy;
        }
        View view = showing.exhibit().view();
        camera = new Camera(view.x(), view.y(), HEIGHT / view.height());
        impacts = new Impacts();
    }

    @Override
    public String title() {
        return "RigiBo – " + plates.title();
    }

    @Override
    public Link link() {
        Link link = AccuracyLink.in(Link.to(found.name()), showing.pool());
        return plates.isOpen(Side.GHOST) ? link.withGhost() : link;
    }

    @Override
    public boolean follow(Link link) {
        int taken = AccuracyLink.follow(link, showing.pool());
        if (link.hasGhost()) {
            plates.toggle(Side.GHOST);
            taken++;
        }
        return taken == link.choices().size();
    }

    @Override
    public boolean hasColumns() {
        return true;
    }

    @Override
    public boolean hasSource() {
        return true;
    }

    @Override
    public boolean isForHands() {
        return true;
    }

    /** The buttons of a hand. */
    private List<HandButtons.Item> buttons() {
        Words words = director.words();
        HandButtons.Item leave = new HandButtons.Item(words.of("scene.gallery"), this::leave);
        return HandButtons.ofSeveral(
                words, leave, isPaused, this::pause, this::show, this::restart);
    }

    private void pause() {
        isPaused = !isPaused;
    }

    private void leave() {
        director.show(new GalleryScene(director, Optional.of(found)));
    }

    @Override
    public Tap tap(double x, double y) {
        boolean isOnButton = whole.contains(x, y) || plates.contain(x, y);
        return isOnButton
                ? Tap.LIFTED
                : Grip.tap(showing.pool(), camera.worldX(x), camera.worldY(y));
    }

    /** With a ghost it begins anew: no copy of it could be made at work. */
    private void haunt() {
        boolean isHaunted = showing.ghost().isPresent();
        boolean isStale = isHaunted && !showing.pool().accuracy().equals(hauntedAt);
        if (isStale || isHaunted != plates.isOpen(Side.GHOST)) {
            restart();
        }
    }

    @Override
    public void step() {
        haunt();
        if (!isPaused) {
            advance();
        }
    }

    private void advance() {
        grip.pull();
        showing.step();
        plates.stepped(showing.pool().report());
        if (director.sounds().isHeard()) {
            impacts.tell(showing.pool(), Looks::of, director.sounds());
        }
    }

    @Override
    public void draw(Canvas canvas) {
        canvas.camera(camera);
        canvas.gaze(grip.pointerX(), grip.pointerY());
        for (RigidBody body : showing.pool().bodies()) {
            if (isInView(canvas, body)) {
                canvas.body(
                        body.shape(),
                        body.x(),
                        body.y(),
                        body.angle(),
                        Looks.of(body),
                        Showing.mood(body));
            }
        }
        JointPicture.draw(canvas, camera, showing.pool().joints());
        showing.ghost().ifPresent(ghost -> ghost.draw(canvas));
        CanvasSketch sketch = new CanvasSketch(canvas, camera, 1);
        showing.exhibit().sketch(showing.pool(), sketch);
        whole.hide();
        if (camera.isPinched()) {
            whole.draw(canvas, HEIGHT);
        }
        plates.hide();
        if (!isBare || canvas.layout().isInHand()) {
            plates.draw(
                    canvas,
                    showing,
                    sketch.figure(),
                    isPaused,
                    buttons(),
                    HandButtons.ofAddress(director));
        }
    }

    @Override
    public void drawn(long nanos) {
        plates.drawn(nanos);
    }

    @Override
    public void describe(Narrator narrator) {
        plates.describe(narrator, isPaused);
        whole.describe(narrator);
    }

    private boolean isInView(Canvas canvas, RigidBody body) {
        double radius = body.shape().boundingRadius() * camera.scale();
        return canvas.layout().shows(camera.screenX(body.x()), camera.screenY(body.y()), radius);
    }

    @Override
    public void pointerMoved(double x, double y) {
        if (isPanning) {
            camera.pan(x - lastX, y - lastY);
        }
        lastX = x;
        lastY = y;
        grip.point(camera.worldX(x), camera.worldY(y));
    }

    @Override
    public void pointerPressed(PointerButton button, double x, double y) {
        pointerMoved(x, y);
        Optional<HandButtons.Item> pressed = plates.button(x, y);
        if (button == PointerButton.LEFT && pressed.isPresent()) {
            pressed.get().action().run();
        } else if (button == PointerButton.LEFT && whole.contains(x, y)) {
            camera.home();
        } else if (button == PointerButton.LEFT && plates.contain(x, y)) {
            plates.turn(1);
        } else if (button == PointerButton.LEFT) {
            grip.grab(showing, grip.pointerX(), grip.pointerY());
        } else if (button == PointerButton.RIGHT && !plates.contain(x, y)) {
            isPanning = true;
            showing.act(grip.pointerX(), grip.pointerY());
        }
    }

    @Override
    public void pinched(Pinch pinch) {
        camera.pinch(pinch);
    }

    @Override
    public void pointerReleased(PointerButton button, double x, double y) {
        grip.letGo();
        isPanning = false;
    }

    @Override
    public void scrolled(double notches, double x, double y) {
        if (plates.contain(x, y)) {
            plates.scroll(notches);
        } else {
            camera.zoom(Math.pow(ZOOM, notches), x, y);
        }
    }

    @Override
    public Optional<Action.Place> place() {
        return Optional.of(Action.Place.DEMO);
    }

    @Override
    public void keyPressed(Key key) {
        switch (key) {
            case SPACE -> pause();
            case PERIOD -> advance();
            case R -> restart();
            case HOME -> camera.home();
            case G -> plates.toggle(Side.GHOST);
            case F -> plates.toggle(Side.FRAME);
            case S -> plates.toggle(Side.SOURCE);
            case T -> isBare = !isBare;
            case LEFT_BRACKET -> show(-1);
            case RIGHT_BRACKET -> show(1);
            case DIGIT_1, DIGIT_2, DIGIT_3, DIGIT_4 ->
                    choose(key.ordinal() - Key.DIGIT_1.ordinal());
            default -> {}
        }
    }

    private void show(int direction) {
        director.show(new ExhibitScene(director, Exhibits.beside(found, direction)));
    }

    private void choose(int preset) {
        showing.pool().accuracy(Preset.values()[preset].accuracy());
    }

    /** Returns to the scene from which it was opened. */
    @Override
    public boolean escaped() {
        leave();
        return true;
    }
}
