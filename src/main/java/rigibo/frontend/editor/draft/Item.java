package rigibo.frontend.editor.draft;

import rigibo.frontend.puzzle.level.Substance;
import rigibo.frontend.puzzle.level.Verb;

import tools.jackson.databind.JsonNode;
import tools.jackson.databind.node.JsonNodeFactory;
import tools.jackson.databind.node.ObjectNode;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;

/**
 * An item of a draft: a ball, the platform, a body. Edits return a new item; its node never changes
 * once it is part of one.
 *
 * @param pointer JSON pointer to the item in the draft
 * @param node the item as the level file states it
 */
public record Item(String pointer, ObjectNode node) {

    /** Height of a platform that does not state it, m. */
    private static final double USUAL_PLATFORM = 0.3;

    /** The kind of item. */
    public enum Kind {
        BALL,
        PLATFORM,
        BODY
    }

    /** Its kind. */
    public Kind kind() {
        if (pointer.equals("/ball") || isFurtherBall()) {
            return Kind.BALL;
        }
        return pointer.equals("/platform") ? Kind.PLATFORM : Kind.BODY;
    }

    /** Whether it is a ball besides the one that every level has. */
    public boolean isFurtherBall() {
        return pointer.startsWith(Draft.MORE_BALLS);
    }

    /** Whether a level may lack it: it is a body or a further ball. */
    public boolean isDispensable() {
        return kind() == Kind.BODY || isFurtherBall();
    }

    /** The id of a body; empty for others. */
    public String id() {
        return node.path("id").asString("");
    }

    /** Its position, m. */
    public Point place() {
        return new Point(number("x", 0), number("y", 0));
    }

    /** Its angle, degrees, counter-clockwise. */
    public double degrees() {
        return number("angle", 0);
    }

    /** A number that it states, or the default. */
    public double number(String name, double otherwise) {
        return Decimal.read(node.path(name), otherwise);
    }

    /** Its outline relative to its position, not turned. */
    public Form form() {
        return switch (kind()) {
            case BALL -> new Disc(number("radius", 0));
            case PLATFORM -> new Box(number("w", 0), number("h", USUAL_PLATFORM));
            case BODY -> Form.of(node.path("shape"));
        };
    }

    /** Its material; stone if the file states an unknown one. */
    public Substance substance() {
        Substance usual =
                switch (kind()) {
                    case BALL -> Substance.BALL;
                    case PLATFORM -> Substance.PLANK;
                    case BODY -> Substance.STONE;
                };
        String title = node.path("material").asString("");
        return Arrays.stream(Substance.values())
                .filter(substance -> substance.title().equals(title))
                .findFirst()
                .orElse(usual);
    }

    /** Whether its material can be chosen; the platform's is its mark. */
    public boolean hasMaterial() {
        return kind() != Kind.PLATFORM;
    }

    /** Whether a click deletes it in play. */
    public boolean isDeletable() {
        return node.path("deletable").asBoolean(false);
    }

    /** Whether it is a fan or a magnet. */
    public boolean isSource() {
        return node.has("fan") || node.has("magnet");
    }

    /** The effect of a click on it in play, other than deletion. */
    public Optional<Verb> verb() {
        return Verb.titled(node.path("click").asString(""));
    }

    /**
     * The verbs of clicks that fit it, besides deleting: belts, fans and magnets are switched, what
     * moves freezes.
     */
    public List<Verb> fitting() {
        List<Verb> fitting = new ArrayList<>();
        if (number("surfaceSpeed", 0) != 0 || isSource()) {
            fitting.add(Verb.SWITCH);
        }
        if (!isFixed()) {
            fitting.add(Verb.FREEZE);
            fitting.add(Verb.LIGHT);
        }
        return fitting;
    }

    /** Returns this body with a click that does something to it besides deleting, or nothing. */
    public Item clicked(Optional<Verb> verb, boolean isOn) {
        ObjectNode changed = JsonNodeFactory.instance.objectNode();
        changed.setAll(node);
        changed.remove(List.of("click", "on", "blast"));
        if (verb.isPresent()) {
            changed.remove("deletable");
            changed.put("click", verb.get().title());
            if (!isOn) {
                changed.put("on", false);
            }
        }
        if (verb.filter(Verb.LIGHT::equals).isPresent()) {
            changed.putObject("blast").put("radius", 1).put("falloff", 1).put("impulse", 1500);
        }
        return new Item(pointer, changed);
    }

    /** Whether it is fixed. */
    public boolean isFixed() {
        return kind() == Kind.PLATFORM || node.has("path") || !node.path("dynamic").asBoolean(true);
    }

    /** Converts a point of the world to its own frame, m. */
    public Point toOwn(Point world) {
        return world.minus(place()).turned(-degrees());
    }

    /** Converts a point of its own frame to the world, m. */
    public Point toWorld(Point own) {
        return place().plus(own.turned(degrees()));
    }

    /** Whether a point of the world lies in it. */
    public boolean contains(Point world) {
        return form().contains(toOwn(world));
    }

    /** The corners in the world, m; none of a disc. */
    public List<Point> corners() {
        return form().corners().stream().map(this::toWorld).toList();
    }

    /** The lines by which its outline is drawn, in the world, m; none of a disc. */
    public List<List<Point>> lines() {
        return form().lines().stream()
                .map(line -> line.stream().map(this::toWorld).toList())
                .toList();
    }

    /** Returns this item at another place, m. */
    public Item at(Point place) {
        return with("x", Decimal.of(place.x())).with("y", Decimal.of(place.y()));
    }

    /** Returns this item at an angle, degrees, reduced to half a turn either way. */
    public Item turnedTo(double degrees) {
        return with("angle", Decimal.of(Math.IEEEremainder(degrees, 360)));
    }

    /** Returns this item with another outline: a ball takes only a disc, a platform only a box. */
    public Item formed(Form form) {
        if (kind() == Kind.BALL) {
            return with("radius", Decimal.of(form.reach()));
        }
        if (form instanceof Box box && kind() == Kind.PLATFORM) {
            return with("w", Decimal.of(box.width())).with("h", Decimal.of(box.height()));
        }
        return with("shape", form.node());
    }

    /** Returns this item with one member changed. */
    public Item with(String name, JsonNode value) {
        ObjectNode changed = JsonNodeFactory.instance.objectNode();
        changed.setAll(node);
        changed.set(name, value);
        return new Item(pointer, changed);
    }
}
