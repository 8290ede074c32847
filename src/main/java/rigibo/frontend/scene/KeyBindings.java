package rigibo.frontend.scene;

import java.util.Collections;
import java.util.EnumMap;
import java.util.EnumSet;
import java.util.Map;
import java.util.Optional;
import java.util.Set;

/**
 * The key of each action, as the player has chosen. The keys that steer menus (Enter, Tab, arrows),
 * those of the window and the digits belong to no action, so that no choice locks anybody out.
 *
 * @param keys the key of each action, one of {@link #FREE}; no two actions of one place share one
 */
public record KeyBindings(Map<Action, Key> keys) {

    /** The keys among which a player chooses. */
    public static final Set<Key> FREE = Collections.unmodifiableSet(free());

    /** The default keys. */
    public static final KeyBindings FIRST = completed(Map.of());

    public KeyBindings {
        keys = Collections.unmodifiableMap(new EnumMap<>(keys));
        if (!keys.keySet().equals(EnumSet.allOf(Action.class))
                || !FREE.containsAll(keys.values())
                || !isSound(keys)) {
            throw new IllegalArgumentException(
                    "KeyBindings.keys must give each action a free key of its own, was " + keys);
        }
    }

    private static Set<Key> free() {
        Set<Key> free = EnumSet.range(Key.A, Key.Z);
        // The window's: switches the sound off.
        free.remove(Key.M);
        free.addAll(EnumSet.range(Key.SPACE, Key.HOME));
        free.remove(Key.TAB);
        return free;
    }

    /** Whether no two of these actions, which are in one place, have one key. */
    public static boolean isSound(Map<Action, Key> keys) {
        return keys.entrySet().stream()
                .allMatch(
                        one ->
                                keys.keySet().stream()
                                        .filter(one.getKey()::meets)
                                        .noneMatch(it -> keys.get(it) == one.getValue()));
    }

    /**
     * The keys stated, which are sound, and for all other actions their first ones. An action that
     * is newer than a player's choice, and whose first key was chosen for another, gets any that is
     * free.
     */
    public static KeyBindings completed(Map<Action, Key> stated) {
        Map<Action, Key> all = new EnumMap<>(Action.class);
        all.putAll(stated);
        for (Action action : Action.values()) {
            if (isUnused(all, action, action.first())) {
                all.putIfAbsent(action, action.first());
            }
        }
        for (Action action : Action.values()) {
            all.computeIfAbsent(action, it -> anyFree(all, it));
        }
        return new KeyBindings(all);
    }

    private static Key anyFree(Map<Action, Key> keys, Action action) {
        return FREE.stream().filter(key -> isUnused(keys, action, key)).findFirst().orElseThrow();
    }

    private static boolean isUnused(Map<Action, Key> keys, Action action, Key key) {
        return keys.keySet().stream().filter(action::meets).noneMatch(it -> keys.get(it) == key);
    }

    /** The key of an action. */
    public Key of(Action action) {
        return keys.get(action);
    }

    /** The other actions that a key has where an action is. */
    public Set<Action> rivals(Action action, Key key) {
        Set<Action> rivals = EnumSet.noneOf(Action.class);
        keys.keySet().stream()
                .filter(action::meets)
                .filter(it -> keys.get(it) == key)
                .forEach(rivals::add);
        return rivals;
    }

    /**
     * Returns these keys with another one for an action; its rivals get the key that it had.
     * Nothing where that would not be sound.
     *
     * @param key one of {@link #FREE}
     */
    public Optional<KeyBindings> with(Action action, Key key) {
        Map<Action, Key> changed = new EnumMap<>(keys);
        rivals(action, key).forEach(rival -> changed.put(rival, of(action)));
        changed.put(action, key);
        return isSound(changed) ? Optional.of(new KeyBindings(changed)) : Optional.empty();
    }

    /**
     * The key that a scene is to be told when another is pressed: the first one of the action that
     * was meant; nothing for a key that lost its action.
     */
    public Optional<Key> meant(Action.Place place, Key pressed) {
        Optional<Key> meant =
                keys.keySet().stream()
                        .filter(action -> action.isIn(place) && of(action) == pressed)
                        .map(Action::first)
                        .findFirst();
        boolean hasLost =
                keys.keySet().stream()
                        .anyMatch(action -> action.isIn(place) && action.first() == pressed);
        return meant.isPresent() || hasLost ? meant : Optional.of(pressed);
    }
}
