package rigibo.frontend.editor.desk;

import rigibo.frontend.editor.draft.Clicks;
import rigibo.frontend.editor.draft.Decimal;
import rigibo.frontend.editor.draft.Draft;
import rigibo.frontend.editor.draft.EffectUse;
import rigibo.frontend.editor.draft.Form;
import rigibo.frontend.editor.draft.Gluing;
import rigibo.frontend.editor.draft.Grid;
import rigibo.frontend.editor.draft.History;
import rigibo.frontend.editor.draft.Item;
import rigibo.frontend.editor.draft.Joinery;
import rigibo.frontend.editor.draft.JointEntry;
import rigibo.frontend.editor.draft.Point;
import rigibo.frontend.puzzle.level.Solution;
import rigibo.frontend.puzzle.level.Substance;
import rigibo.frontend.puzzle.level.Verb;
import rigibo.frontend.scene.Camera;
import rigibo.frontend.scene.Modifier;

import tools.jackson.databind.JsonNode;
import tools.jackson.databind.node.JsonNodeFactory;
import tools.jackson.databind.node.ObjectNode;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.Set;

/** The draft in progress, with the author's selection and state of work. */
public final class Desk {

    /** Distance between a copy and its original, m. */
    private static final Point ASIDE = new Point(0.25, 0.25);

    private final Camera camera;
    private History history;
    private String chosen = "";
    private Leaf bodyLeaf = Leaf.SHAPE;
    private Leaf levelLeaf = Leaf.LEVEL;
    private Grid grid = Grid.ON;
    private Substance substance = Substance.RIGIBO;
    private Set<Modifier> held = Set.of();
    private double finger;

    /** A desk with a draft, seen through a camera. */
    public Desk(Draft draft, Camera camera) {
        this.camera = camera;
        history = new History(draft);
    }

    /** Replaces the draft with another one, which has a history of its own. */
    public void lay(Draft draft) {
        history = new History(draft);
        chosen = "";
    }

    /** The present draft. */
    public Draft draft() {
        return history.present();
    }

    /** The history of the draft. */
    public History history() {
        return history;
    }

    /** The camera through which the draft is seen. */
    public Camera camera() {
        return camera;
    }

    /** The leaf to which the fields of a body are turned. */
    public Leaf bodyLeaf() {
        return bodyLeaf;
    }

    /** The leaf to which the fields of the level are turned. */
    public Leaf levelLeaf() {
        return levelLeaf;
    }

    /** Turns the fields to a leaf. */
    public void turnTo(Leaf leaf) {
        if (Leaf.OF_BODY.contains(leaf)) {
            bodyLeaf = leaf;
        } else {
            levelLeaf = leaf;
        }
    }

    /** The grid to which things snap. */
    public Grid grid() {
        return grid;
    }

    /** Switches snapping to the grid on or off. */
    public void switchGrid() {
        grid = grid.switched();
    }

    /** Sets which modifiers are held down. */
    public void held(Set<Modifier> modifiers) {
        held = modifiers;
    }

    /** Whether a modifier is held down. */
    public boolean isHeld(Modifier modifier) {
        return held.contains(modifier);
    }

    /** Pixels of the screen as a length in the world, m. */
    public double metres(double pixels) {
        return pixels / camera.scale();
    }

    /** Sets the least size of things to touch, px; 0 for a mouse, which points exactly. */
    public void finger(double least) {
        finger = least;
    }

    /** Whether the desk is used by fingers. */
    public boolean isInHand() {
        return finger > 0;
    }

    /** How near the pointer must come to a thing, m: the given number of px, or half a finger. */
    public double reach(double pixels) {
        return metres(Math.max(pixels, finger / 2));
    }

    /**
     * Makes an edit. Joints follow the bodies that they hold, and effects that the edit needs are
     * declared.
     */
    public void change(Draft next) {
        Draft joined = Joinery.followed(history.origin(), draft(), next);
        history.change(EffectUse.followed(draft(), joined));
    }

    /** The selected item. */
    public Optional<Item> item() {
        return chosen.isEmpty() ? Optional.empty() : draft().item(chosen);
    }

    /** The selected joint. */
    public Optional<JointEntry> joint() {
        return JointEntry.of(draft(), chosen);
    }

    /** JSON pointer of the selection; empty if nothing is selected. */
    public String chosen() {
        return item().isPresent() || joint().isPresent() ? chosen : "";
    }

    /** Selects the item at a JSON pointer; an empty pointer selects nothing. */
    public void choose(String pointer) {
        chosen = pointer;
    }

    /** The uppermost item at a point. */
    public Optional<Item> at(Point point) {
        return draft().items().stream()
                .filter(item -> item.contains(point))
                .reduce((below, above) -> above);
    }

    /** Selects the next item in the draft's order, or the previous one by −1. */
    public void chooseNext(int direction) {
        List<String> all = new ArrayList<>();
        draft().items().forEach(item -> all.add(item.pointer()));
        JointEntry.all(draft()).forEach(joint -> all.add(joint.pointer()));
        int at = all.indexOf(chosen());
        int from = at < 0 && direction < 0 ? 0 : at;
        choose(all.get(Math.floorMod(from + direction, all.size())));
    }

    /** The material of new bodies. */
    public Substance substance() {
        return item().filter(Item::hasMaterial).map(Item::substance).orElse(substance);
    }

    /** Gives the selected body or ball a material, and all new bodies from now on. */
    public void substance(Substance made) {
        substance = made;
        item().filter(Item::hasMaterial)
                .map(body -> body.with("material", text(made.title())))
                .ifPresent(this::put);
    }

    private static JsonNode text(String words) {
        return JsonNodeFactory.instance.stringNode(words);
    }

    /** Replaces an item with its changed form. */
    public void put(Item item) {
        change(draft().with(item));
    }

    /** Adds a body and selects it. A RigiBo can be deleted in play; other bodies stay. */
    public void place(Form form, Point at) {
        place(form, at, 0);
    }

    /** Adds a turned body and selects it, degrees. */
    public void place(Form form, Point at, double degrees) {
        ObjectNode body = JsonNodeFactory.instance.objectNode();
        body.set("shape", form.node());
        body.put("x", at.x()).put("y", at.y());
        if (degrees != 0) {
            body.set("angle", Decimal.of(degrees));
        }
        boolean moves = !form.isLandscape();
        // The game's creatures are to be clicked, which a landscape never is.
        boolean isGround = !moves && substance == Substance.RIGIBO;
        body.put("material", (isGround ? Substance.STONE : substance).title());
        body.put("dynamic", moves).put("deletable", moves && substance == Substance.RIGIBO);
        add(body);
    }

    private void add(ObjectNode body) {
        change(draft().plus(body).inFormatTwo());
        choose(draft().lastBody().pointer());
    }

    /** Makes a body part of another one, which is selected then. */
    public void glue(Item keeper, Item given) {
        change(Gluing.glued(draft(), keeper, given).inFormatTwo());
        draft().items().stream()
                .filter(item -> item.id().equals(keeper.id()))
                .forEach(item -> choose(item.pointer()));
    }

    /** Makes each part of a body a body of its own. */
    public void takeApart(Item body) {
        change(Gluing.apart(draft(), body));
    }

    /** Gives a body another outline, which the first format may lack. */
    public void form(Item body, Form form) {
        change(draft().with(body.formed(form)).inFormatTwo());
    }

    /** Adds a ball and selects it. */
    public void placeBall(Point at) {
        change(draft().plusBall(at));
        choose(draft().lastBall().pointer());
    }

    /** Changes the id of a body, also in the stored solutions. */
    public void rename(Item body, String id) {
        if (!id.isBlank() && !id.equals(body.id())) {
            change(Clicks.renamed(draft().with(body.with("id", text(id))), body.id(), id));
        }
    }

    /** Changes the id of a joint, also in the stored solutions. */
    public void rename(JointEntry joint, String id) {
        if (!id.isBlank() && !id.equals(joint.id())) {
            JointEntry named = joint.with("id", text(id));
            Draft draft = draft().with(named.pointer(), named.node());
            change(Clicks.jointRenamed(draft, joint.id(), id));
        }
    }

    /**
     * Makes a click in play do something to a body besides deleting; levels of format 2 have it.
     */
    public void click(Item body, Optional<Verb> verb, boolean isOn) {
        Draft next = draft().with(body.clicked(verb, isOn));
        change(verb.isPresent() ? next.inFormatTwo() : next);
    }

    /** Gives the draft a member that the first format lacks, or takes it away. */
    public void member(String pointer, JsonNode stated, boolean isThere) {
        change(isThere ? draft().with(pointer, stated).inFormatTwo() : draft().without(pointer));
    }

    /** Adds a copy beside the selected body and selects it. */
    public void duplicate() {
        item().filter(Desk::isBody)
                .ifPresent(
                        body -> {
                            ObjectNode copy = body.at(body.place().plus(ASIDE)).node().deepCopy();
                            copy.remove("id");
                            add(copy);
                        });
    }

    /** Removes the selection, unless every level needs it. */
    public void remove() {
        Optional<JointEntry> joint = joint();
        if (joint.isPresent()) {
            change(Joinery.without(draft(), joint.get()));
            choose("");
        }
        item().filter(Item::isDispensable)
                .ifPresent(
                        item -> {
                            change(draft().without(item));
                            choose("");
                        });
    }

    /** Turns the selection, degrees. */
    public void turn(double degrees) {
        item().filter(item -> item.kind() != Item.Kind.BALL)
                .ifPresent(item -> put(item.turnedTo(item.degrees() + degrees)));
    }

    /** Moves the selection. */
    public void move(Point way) {
        item().ifPresent(item -> put(item.at(item.place().plus(way))));
    }

    /** Stores clicks that won as a solution. */
    public void keep(Solution solution) {
        change(Clicks.keep(draft(), solution));
    }

    private static boolean isBody(Item item) {
        return item.kind() == Item.Kind.BODY;
    }
}
