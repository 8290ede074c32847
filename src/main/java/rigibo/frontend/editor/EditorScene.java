package rigibo.frontend.editor;

import rigibo.frontend.editor.desk.Finding;
import rigibo.frontend.editor.draft.Decimal;
import rigibo.frontend.editor.draft.Draft;
import rigibo.frontend.editor.draft.Grid;
import rigibo.frontend.editor.draft.Point;
import rigibo.frontend.editor.file.DraftFile;
import rigibo.frontend.editor.pane.Craft;
import rigibo.frontend.editor.pane.Pane;
import rigibo.frontend.editor.pane.Spots;
import rigibo.frontend.puzzle.level.World;
import rigibo.frontend.scene.Action;
import rigibo.frontend.scene.Camera;
import rigibo.frontend.scene.Canvas;
import rigibo.frontend.scene.Director;
import rigibo.frontend.scene.Key;
import rigibo.frontend.scene.Link;
import rigibo.frontend.scene.Modifier;
import rigibo.frontend.scene.Narrator;
import rigibo.frontend.scene.Pinch;
import rigibo.frontend.scene.PointerButton;
import rigibo.frontend.scene.Scene;
import rigibo.frontend.scene.Scenery;
import rigibo.frontend.scene.Tap;

import java.util.List;
import java.util.Optional;
import java.util.Set;

/** The editor: the draft with its panes, or the draft while it is played. */
final class EditorScene implements Scene {

    static final String NAME = "editor";

    private static final String GRID = "grid";
    private static final String OFF = "off";

    private static final double ZOOM = 1.15;

    private final Workshop shop;
    private final Commands commands;
    private final HandPanes hand;
    private final Spots spots = new Spots();
    private double pointerX;
    private double pointerY;
    private boolean isPanning;

    /** Whether the tool was pressed, and not released yet. */
    private boolean isUsed;

    private boolean isInHand;

    /** An editor with a draft on its desk. */
    EditorScene(Director director, DraftFile first) {
        shop = new Workshop(director, first);
        commands = new Commands(shop);
        hand = new HandPanes(shop, () -> leave(director));
        shop.turn();
    }

    private void leave(Director director) {
        if (!escaped()) {
            director.showMenu();
        }
    }

    /** The present draft. */
    Draft draft() {
        return shop.desk().draft();
    }

    /** The level that is being played, if there is one. */
    private Optional<Scene> played() {
        return shop.test().map(TestRun::scene);
    }

    @Override
    public String title() {
        return "RigiBo – " + shop.words().of("editor.window");
    }

    /** A draft is longer than an address may be, and goes as a code. */
    @Override
    public Link link() {
        Link link = Link.to(NAME);
        return shop.desk().grid() == Grid.ON ? link : link.with(GRID, OFF);
    }

    @Override
    public boolean follow(Link link) {
        boolean isOff = OFF.equals(link.choices().get(GRID));
        if (isOff) {
            shop.desk().switchGrid();
        }
        return link.choices().size() == (isOff ? 1 : 0);
    }

    /** The draft's scenery, which is also that of the level. */
    @Override
    public Scenery scenery() {
        double gravityX = Decimal.read(draft().at("/world/gravity/0"), 0);
        double gravityY = Decimal.read(draft().at("/world/gravity/1"), 0);
        return World.isOnTheMoon(gravityX, gravityY) ? Scenery.MOON : Scenery.WORKSHOP;
    }

    @Override
    public boolean isForHands() {
        return true;
    }

    /** The editor is one; a level that is played lies where levels lie. */
    @Override
    public boolean isSheet() {
        return played().isEmpty();
    }

    @Override
    public void step() {
        played().ifPresent(Scene::step);
        shop.turn();
    }

    @Override
    public void draw(Canvas canvas) {
        Optional<Scene> played = played();
        if (played.isPresent()) {
            played.get().draw(canvas);
            return;
        }
        List<Finding> findings = shop.inspection().findings();
        isInHand = canvas.layout().isInHand();
        Pane pane = new Pane(canvas, spots, shop.words(), pointerX, pointerY);
        shop.desk().finger(canvas.layout().touch().least());
        Panes panes = new Panes(shop, pane, findings);
        if (isInHand) {
            hand.makeRoom(pane, findings);
        } else {
            panes.makeRoom();
        }
        spots.clear();
        DeskView.draw(canvas, shop.desk(), findings);
        shop.tool().draw(canvas);
        if (isInHand) {
            hand.draw(pane, findings);
        } else {
            panes.draw();
        }
    }

    /** Tells of all buttons and fields, and of the things on the desk. */
    @Override
    public void describe(Narrator narrator) {
        Optional<Scene> played = played();
        if (played.isPresent()) {
            played.get().describe(narrator);
            return;
        }
        spots.describe(narrator);
        new DeskNames(shop.words(), shop.desk()).describe(narrator, spots);
        if (!shop.remark().isEmpty()) {
            narrator.says(shop.remark());
        }
    }

    @Override
    public void drawn(long nanos) {
        played().ifPresent(scene -> scene.drawn(nanos));
    }

    @Override
    public void paced(double share) {
        played().ifPresent(scene -> scene.paced(share));
    }

    @Override
    public void closed() {
        shop.close();
    }

    @Override
    public void pointerMoved(double x, double y) {
        Camera camera = shop.desk().camera();
        if (isPanning) {
            camera.pan(x - pointerX, y - pointerY);
        }
        pointerX = x;
        pointerY = y;
        Optional<Scene> played = played();
        if (played.isPresent()) {
            played.get().pointerMoved(x, y);
        } else if (!isPanning) {
            shop.tool().moved(world(x, y));
        }
    }

    private Point world(double x, double y) {
        Camera camera = shop.desk().camera();
        return new Point(camera.worldX(x), camera.worldY(y));
    }

    @Override
    public void pointerPressed(PointerButton button, double x, double y) {
        Optional<Scene> played = played();
        if (played.isPresent()) {
            played.get().pointerPressed(button, x, y);
            return;
        }
        pointerX = x;
        pointerY = y;
        if (shop.stopSettling()) {
            return;
        }
        Optional<Spots.Spot> spot = spots.at(x, y);
        if (spot.isPresent()) {
            shop.typing().end();
            spot.get().action().run();
        } else if (button == PointerButton.LEFT) {
            shop.typing().end();
            shop.tool().pressed(world(x, y));
            isUsed = true;
            isPanning = isInHand && shop.craft() == Craft.SELECT && shop.desk().chosen().isEmpty();
        } else {
            isPanning = true;
        }
    }

    @Override
    public Tap tap(double x, double y) {
        return played().map(scene -> scene.tap(x, y))
                .orElseGet(() -> spots.covers(x, y) ? Tap.LIFTED : Tap.AT_ONCE);
    }

    @Override
    public void choosing(boolean isChoosing) {
        played().ifPresent(scene -> scene.choosing(isChoosing));
    }

    @Override
    public void pointerReleased(PointerButton button, double x, double y) {
        Optional<Scene> played = played();
        if (played.isPresent()) {
            played.get().pointerReleased(button, x, y);
        } else if (button == PointerButton.LEFT && isUsed) {
            shop.tool().released(world(x, y));
        }
        isUsed = false;
        isPanning = false;
    }

    @Override
    public void interrupted() {
        if (isUsed) {
            shop.tool().interrupted();
        }
        isUsed = false;
        isPanning = false;
    }

    @Override
    public void pinched(Pinch pinch) {
        played().ifPresentOrElse(
                        scene -> scene.pinched(pinch), () -> shop.desk().camera().pinch(pinch));
    }

    @Override
    public void scrolled(double notches, double x, double y) {
        Optional<Scene> played = played();
        if (played.isPresent()) {
            played.get().scrolled(notches, x, y);
        } else {
            shop.desk().camera().zoom(Math.pow(ZOOM, notches), x, y);
        }
    }

    @Override
    public void held(Set<Modifier> modifiers) {
        shop.desk().held(modifiers);
        played().ifPresent(scene -> scene.held(modifiers));
    }

    @Override
    public void typed(int codePoint) {
        Optional<Scene> played = played();
        if (played.isPresent()) {
            played.get().typed(codePoint);
        } else {
            shop.typing().typed(codePoint);
        }
    }

    /** While a draft is played, a code leads elsewhere as it does from any level. */
    @Override
    public boolean pasted(String text) {
        boolean isMine = played().isEmpty();
        if (isMine) {
            shop.paste(text);
        }
        return isMine;
    }

    @Override
    public boolean isTyping() {
        return played().map(Scene::isTyping).orElseGet(shop.typing()::isOn);
    }

    @Override
    public Optional<Action.Place> place() {
        return played().flatMap(Scene::place);
    }

    @Override
    public void keyPressed(Key key) {
        Optional<Scene> played = played();
        if (played.isPresent() && key == Key.T) {
            shop.endTest();
        } else if (played.isPresent()) {
            played.get().keyPressed(key);
        } else {
            commands.keyPressed(key);
        }
    }

    /**
     * Leaves the innermost state: a text, a half-drawn shape, a list, the selection, and at last
     * the scene.
     */
    @Override
    public boolean escaped() {
        Optional<Scene> played = played();
        if (played.isPresent()) {
            if (!played.get().escaped()) {
                shop.endTest();
            }
            return true;
        }
        return isInHand && hand.shut() || commands.escaped();
    }
}
