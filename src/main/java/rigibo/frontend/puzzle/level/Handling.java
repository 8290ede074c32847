package rigibo.frontend.puzzle.level;

import rigibo.frontend.document.Document;
import rigibo.frontend.document.Fault;

import tools.jackson.databind.JsonNode;

import java.util.Optional;

/**
 * The action of a click on a body or joint.
 *
 * @param verb empty if nothing happens
 * @param isOn whether the switched device is on at the start
 * @param charge the blast of a bomb
 */
public record Handling(Optional<Verb> verb, boolean isOn, Optional<Charge> charge) {

    /**
     * The blast of a bomb; see the engine's {@code Explosion}.
     *
     * @param radius distance up to which it has its full strength, m
     * @param falloff further distance over which it weakens to nothing, m
     * @param impulse for each metre of width of a body that it meets, N·s/m
     */
    public record Charge(double radius, double falloff, double impulse) {}

    /** Reads the members of a body or joint that the schema accepts. */
    static Handling of(JsonNode node) {
        Optional<Verb> verb =
                node.path("deletable").asBoolean(false)
                        ? Optional.of(Verb.DELETE)
                        : Verb.titled(node.path("click").asString(""));
        JsonNode blast = node.path("blast");
        Optional<Charge> charge =
                blast.isObject()
                        ? Optional.of(
                                new Charge(
                                        blast.path("radius").asDouble(),
                                        blast.path("falloff").asDouble(0),
                                        blast.path("impulse").asDouble()))
                        : Optional.empty();
        return new Handling(verb, node.path("on").asBoolean(true), charge);
    }

    /** Whether a click switches it and it is off at the start. */
    public boolean beginsOff() {
        return does(Verb.SWITCH) && !isOn;
    }

    /** Whether a click acts by a verb. */
    boolean does(Verb what) {
        return verb.filter(what::equals).isPresent();
    }

    /**
     * E124: a click's action does not fit the body; E126: members that only a switch or a bomb has,
     * or a bomb without its blast; E127: a fan or magnet that moves.
     */
    static void check(Document json, Located<LevelBody> at) {
        LevelBody body = at.part();
        JsonNode node = json.node(at.pointer());
        String pointer = at.pointer();
        if (node.path("deletable").asBoolean(false) && node.has("click")) {
            tell(json, pointer, "E124.twice", "E124 is deletable and has another \"click\"");
        }
        boolean runs = body.material().surfaceSpeed() != 0 || body.source().isThere();
        if (body.does(Verb.SWITCH) && !runs) {
            tell(
                    json,
                    pointer,
                    "E124.switch",
                    "E124 a click switches a belt, a fan or a magnet only");
        }
        if (body.source().isThere() && body.mobility() != LevelBody.Mobility.STATIC) {
            tell(json, pointer, "E127", "E127 a fan or magnet stays where it is: not \"dynamic\"");
        }
        boolean needsMotion = body.does(Verb.FREEZE) || body.does(Verb.LIGHT);
        if (needsMotion && !body.isDynamic()) {
            String verb = body.verb().orElseThrow().title();
            tell(
                    json,
                    pointer,
                    "E124.still",
                    "E124 a click cannot %s what forces do not move",
                    verb);
        }
        if (body.does(Verb.LIGHT) != body.handling().charge().isPresent()) {
            tell(
                    json,
                    pointer,
                    "E126.blast",
                    "E126 a \"blast\" belongs to a body that a click lights");
        }
        switching(json, pointer, body.does(Verb.SWITCH));
    }

    /** E126: only a device that a click switches can be on or off at the start. */
    static void switching(Document json, String pointer, boolean isSwitch) {
        if (json.node(pointer).has("on") && !isSwitch) {
            tell(json, pointer + "/on", "E126.on", "E126 \"on\" belongs to what a click switches");
        }
    }

    private static void tell(
            Document json, String pointer, String kind, String words, Object... values) {
        json.error(pointer, () -> Fault.of(kind, words, values));
    }
}
