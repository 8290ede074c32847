package rigibo.frontend.editor.desk;

import rigibo.frontend.editor.draft.Decimal;
import rigibo.frontend.editor.draft.Disc;
import rigibo.frontend.editor.draft.Draft;
import rigibo.frontend.editor.draft.Item;
import rigibo.frontend.editor.draft.Joinery;
import rigibo.frontend.editor.draft.JointEntry;
import rigibo.frontend.editor.draft.Point;
import rigibo.frontend.puzzle.level.LevelJoint;
import rigibo.frontend.puzzle.level.Substance;

import tools.jackson.databind.node.JsonNodeFactory;
import tools.jackson.databind.node.ObjectNode;

import java.util.ArrayList;
import java.util.Collections;
import java.util.Comparator;
import java.util.List;
import java.util.Optional;

/** Joins items of a desk, and finds and moves their joints. */
public final class Joining {

    /** Radius of the hook that is added where a joint is on the backdrop, m. */
    public static final double HOOK = 0.1;

    private static final String HOOK_NAME = "hook";

    /** Distance within which the pointer takes hold of an anchor, and of a rope, px. */
    private static final double REACH = 11;

    private static final double ASIDE = 6;

    private final Desk desk;

    /** Joins the items of a desk. */
    public Joining(Desk desk) {
        this.desk = desk;
    }

    /**
     * A point of a joint.
     *
     * @param joint of which
     * @param anchor the member that states it
     */
    public record Anchor(JointEntry joint, String anchor) {

        /** Position of the anchor, m. */
        public Point place() {
            return joint.point(anchor);
        }
    }

    /**
     * One end of a joint in the making.
     *
     * @param item the item to hold; empty for the backdrop, which gets a hook
     * @param at the place, m
     */
    public record End(Optional<Item> item, Point at) {}

    /** The anchor nearest to a point, within reach; anchors of the selected joint come first. */
    public Optional<Anchor> anchorAt(Point point) {
        Comparator<Anchor> unchosenLast =
                Comparator.comparing(held -> !held.joint().pointer().equals(desk.chosen()));
        return topmost().stream()
                .flatMap(joint -> joint.anchors().stream().map(name -> new Anchor(joint, name)))
                .filter(held -> distance(held, point) <= desk.reach(REACH))
                .min(unchosenLast.thenComparingDouble(held -> distance(held, point)));
    }

    private static double distance(Anchor held, Point point) {
        return held.place().minus(point).length();
    }

    private List<JointEntry> topmost() {
        List<JointEntry> joints = new ArrayList<>(JointEntry.all(desk.draft()));
        Collections.reverse(joints);
        return joints;
    }

    /** The uppermost joint at a point, found by its anchors or by the line between them. */
    public Optional<JointEntry> at(Point point) {
        return anchorAt(point).map(Anchor::joint).or(() -> spanAt(point));
    }

    private Optional<JointEntry> spanAt(Point point) {
        return topmost().stream()
                .filter(joint -> joint.type().hasTwoPoints())
                .filter(
                        joint ->
                                point.isNear(
                                        joint.point("from"), joint.point("to"), desk.metres(ASIDE)))
                .findFirst();
    }

    /**
     * Position at which an anchor is placed that is dropped at a point: the middle of an item
     * nearby, or the grid.
     */
    public Point snap(Point point) {
        return desk.draft().items().stream()
                .map(Item::place)
                .filter(place -> place.minus(point).length() <= desk.metres(REACH))
                .min(Comparator.comparingDouble(place -> place.minus(point).length()))
                .orElseGet(() -> desk.grid().snap(point));
    }

    /** Drags an anchor; a hook under it follows, since it exists only for the anchor. */
    public void move(Anchor held, Point to) {
        Optional<Item> hook = Joinery.hook(desk.history().origin(), held.joint(), held.anchor());
        if (hook.isPresent()) {
            desk.put(hook.get().at(desk.grid().snap(to)));
        } else {
            JointEntry moved = held.joint().at(held.anchor(), snap(to));
            desk.change(desk.draft().with(moved.pointer(), moved.node()));
        }
    }

    /** The end that a press at a point chooses; {@code other} is the end chosen before. */
    public End end(Point point, Optional<Item> other) {
        Point at = snap(point);
        Optional<Item> under =
                desk.draft().items().stream()
                        .filter(item -> item.contains(point))
                        .filter(item -> other.filter(item::equals).isEmpty())
                        .reduce((below, above) -> above);
        return new End(under, under.isPresent() || other.isEmpty() ? at : desk.grid().snap(point));
    }

    /** Whether two ends can be joined: at least one of them must be an item. */
    public static boolean canJoin(End one, End other) {
        return one.item().isPresent() || other.item().isPresent();
    }

    /** Joins two ends and selects the joint; an end on the backdrop gets a hook. */
    public void join(LevelJoint.Type type, End one, End other) {
        // A motor drives its second end, which must not be the hook.
        End first = other.item().isPresent() ? one : other;
        End second = other.item().isPresent() ? other : one;
        Point at = other.at();
        Draft draft = desk.draft();
        String a;
        if (first.item().isPresent()) {
            a = Joinery.name(first.item().get());
        } else {
            draft = draft.plus(hook(type.hasTwoPoints() ? first.at() : at), HOOK_NAME);
            a = draft.lastBody().id();
        }
        String b = Joinery.name(second.item().orElseThrow());
        ObjectNode joint =
                type.hasTwoPoints()
                        ? Joinery.node(type, a, b, first.at(), second.at())
                        : Joinery.node(type, a, b, at, at);
        desk.change(Joinery.plus(draft, joint));
        List<JointEntry> all = JointEntry.all(desk.draft());
        desk.choose(all.get(all.size() - 1).pointer());
    }

    private static ObjectNode hook(Point at) {
        ObjectNode hook = JsonNodeFactory.instance.objectNode();
        hook.set("shape", new Disc(HOOK).node());
        hook.put("x", Decimal.rounded(at.x())).put("y", Decimal.rounded(at.y()));
        hook.put("material", Substance.IRON.title()).put("dynamic", false);
        return hook;
    }
}
