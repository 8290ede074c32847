package rigibo.frontend.editor.draft;

import rigibo.backend.setup.Material;

import tools.jackson.databind.JsonNode;
import tools.jackson.databind.node.ArrayNode;
import tools.jackson.databind.node.JsonNodeFactory;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.function.ToDoubleFunction;

/**
 * Declares effects that an edit starts to use, and removes those that it no longer uses. A choice
 * that the author made against the use is kept until the use itself changes.
 */
public final class EffectUse {

    private static final String POINTER = "/world/effects";

    /** Members of a body, and the effect that each of them needs. */
    private record Member(String effect, String name, ToDoubleFunction<Material> usual) {

        boolean isUsedBy(Item item) {
            return item.number(name, usual.applyAsDouble(item.substance().material())) != 0;
        }
    }

    private static final List<Member> MEMBERS =
            List.of(
                    new Member("friction", "friction", Material::friction),
                    new Member("restitution", "restitution", Material::elasticity),
                    new Member(
                            "rolling-resistance", "rollingResistance", Material::rollingResistance),
                    new Member("surface-speed", "surfaceSpeed", Material::surfaceSpeed),
                    new Member("drag", "drag", Material::drag));

    private EffectUse() {}

    /** Returns the draft that an edit made, with its effects adapted. */
    public static Draft followed(Draft before, Draft after) {
        Map<String, Boolean> was = used(before);
        List<String> declared = declared(after);
        used(after)
                .forEach(
                        (effect, isUsed) -> {
                            if (isUsed && !was.get(effect) && !declared.contains(effect)) {
                                declared.add(effect);
                            }
                            if (!isUsed && was.get(effect)) {
                                declared.remove(effect);
                            }
                        });
        return declared.equals(declared(after)) ? after : after.with(POINTER, node(declared));
    }

    /** The effects a draft declares, in its order. */
    public static List<String> declared(Draft draft) {
        List<String> titles = new ArrayList<>();
        draft.at(POINTER).forEach(title -> titles.add(title.asString("")));
        return titles;
    }

    /** Returns the draft with an effect declared if it was not, or undeclared if it was. */
    public static Draft switched(Draft draft, String effect) {
        List<String> declared = declared(draft);
        if (!declared.remove(effect)) {
            declared.add(effect);
        }
        return draft.with(POINTER, node(declared));
    }

    private static JsonNode node(List<String> effects) {
        ArrayNode node = JsonNodeFactory.instance.arrayNode();
        effects.forEach(node::add);
        return node;
    }

    private static Map<String, Boolean> used(Draft draft) {
        Map<String, Boolean> used = new LinkedHashMap<>();
        JsonNode gravity = draft.at("/world/gravity");
        used.put(
                "gravity",
                Decimal.read(gravity.path(0), 0) != 0 || Decimal.read(gravity.path(1), 0) != 0);
        used.put("joints", !draft.at(JointEntry.JOINTS).isEmpty());
        used.put("buoyancy", draft.at("/world/water").isObject());
        List<Item> items = draft.items();
        used.put("fan", items.stream().anyMatch(item -> item.node().has("fan")));
        used.put("magnet", items.stream().anyMatch(item -> item.node().has("magnet")));
        for (Member member : MEMBERS) {
            used.put(member.effect, items.stream().anyMatch(member::isUsedBy));
        }
        return used;
    }
}
