package rigibo.frontend.editor.desk;

import rigibo.frontend.editor.draft.Clicks;
import rigibo.frontend.editor.draft.Draft;
import rigibo.frontend.editor.draft.EffectUse;
import rigibo.frontend.editor.draft.Form;
import rigibo.frontend.editor.draft.Grid;
import rigibo.frontend.editor.draft.History;
import rigibo.frontend.editor.draft.Item;
import rigibo.frontend.editor.draft.Joinery;
import rigibo.frontend.editor.draft.JointEntry;
import rigibo.frontend.editor.draft.Point;
import rigibo.frontend.puzzle.level.Solution;
import rigibo.frontend.puzzle.level.Substance;
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

    /** How far a copy lies beside what it was made of, m. */
    private static final Point ASIDE = new Point(0.25, 0.25);

    private final Camera camera;
    private History history;
    private String chosen = "";
    private Grid grid = Grid.ON;
    private Substance substance = Substance.RIGIBO;
    private Set<Modifier> held = Set.of();

    /** A desk with a draft, looked at through a camera. */
    public Desk(Draft draft, Camera camera) {
        this.camera = camera;
        history = new History(draft);
    }

    /** Puts another draft in this one's place, with a history of its own. */
    public void lay(Draft draft) {
        history = new History(draft);
        chosen = "";
    }

    /** The draft as it stands. */
    public Draft draft() {
        return history.present();
    }

    /** Its past and future. */
    public History history() {
        return history;
    }

    /** What the draft is looked at through. */
    public Camera camera() {
        return camera;
    }

    /** Where things snap to. */
    public Grid grid() {
        return grid;
    }

    /** Snaps to lines from now on, or no more. */
    public void switchGrid() {
        grid = grid.switched();
    }

    /** Tells what is held down. */
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

    /** Makes an edit; joints go along with what they hold, effects are declared with it. */
    public void change(Draft next) {
        Draft joined = Joinery.followed(history.origin(), draft(), next);
        history.change(EffectUse.followed(draft(), joined));
    }

    /** What is chosen. */
    public Optional<Item> item() {
        return chosen.isEmpty() ? Optional.empty() : draft().item(chosen);
    }

    /** The joint that is chosen. */
    public Optional<JointEntry> joint() {
        return JointEntry.of(draft(), chosen);
    }

    /** JSON pointer of what is chosen; empty where nothing is. */
    public String chosen() {
        return item().isPresent() || joint().isPresent() ? chosen : "";
    }

    /** Chooses what stands at a JSON pointer, or nothing by an empty one. */
    public void choose(String pointer) {
        chosen = pointer;
    }

    /** The uppermost item at a point. */
    public Optional<Item> at(Point point) {
        return draft().items().stream()
                .filter(item -> item.contains(point))
                .reduce((below, above) -> above);
    }

    /** Chooses what comes after the chosen one in the draft's order, or before by −1. */
    public void chooseNext(int direction) {
        List<String> all = new ArrayList<>();
        draft().items().forEach(item -> all.add(item.pointer()));
        JointEntry.all(draft()).forEach(joint -> all.add(joint.pointer()));
        int at = all.indexOf(chosen());
        int from = at < 0 && direction < 0 ? 0 : at;
        choose(all.get(Math.floorMod(from + direction, all.size())));
    }

    /** What new bodies are made of. */
    public Substance substance() {
        return item().filter(Desk::isBody).map(Item::substance).orElse(substance);
    }

    /** Makes the chosen body of a substance, and new ones from now on. */
    public void substance(Substance made) {
        substance = made;
        item().filter(Desk::isBody)
                .map(body -> body.with("material", text(made.title())))
                .ifPresent(this::put);
    }

    private static JsonNode text(String words) {
        return JsonNodeFactory.instance.stringNode(words);
    }

    /** Puts a changed item in its place. */
    public void put(Item item) {
        change(draft().with(item));
    }

    /** Adds a body and chooses it. A RigiBo is there to be deleted, other things stay. */
    public void place(Form form, Point at) {
        ObjectNode body = JsonNodeFactory.instance.objectNode();
        body.set("shape", form.node());
        body.put("x", at.x()).put("y", at.y());
        body.put("material", substance.title());
        body.put("dynamic", true).put("deletable", substance == Substance.RIGIBO);
        add(body);
    }

    private void add(ObjectNode body) {
        change(draft().plus(body));
        choose(draft().lastBody().pointer());
    }

    /** Adds a ball and chooses it. */
    public void placeBall(Point at) {
        change(draft().plusBall(at));
        choose(draft().lastBall().pointer());
    }

    /** Gives a body another id, in the solutions too. */
    public void rename(Item body, String id) {
        if (!id.isBlank() && !id.equals(body.id())) {
            change(Clicks.renamed(draft().with(body.with("id", text(id))), body.id(), id));
        }
    }

    /** Lays a copy of the chosen body beside it and chooses that. */
    public void duplicate() {
        item().filter(Desk::isBody)
                .ifPresent(
                        body -> {
                            ObjectNode copy = body.at(body.place().plus(ASIDE)).node().deepCopy();
                            copy.remove("id");
                            add(copy);
                        });
    }

    /** Takes away what is chosen, unless no level is without it. */
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

    /** Turns what is chosen, degrees. */
    public void turn(double degrees) {
        item().filter(item -> item.kind() != Item.Kind.BALL)
                .ifPresent(item -> put(item.turnedTo(item.degrees() + degrees)));
    }

    /** Moves what is chosen. */
    public void move(Point way) {
        item().ifPresent(item -> put(item.at(item.place().plus(way))));
    }

    /** Keeps clicks that were seen to win. */
    public void keep(Solution solution) {
        change(Clicks.keep(draft(), solution));
    }

    private static boolean isBody(Item item) {
        return item.kind() == Item.Kind.BODY;
    }
}
